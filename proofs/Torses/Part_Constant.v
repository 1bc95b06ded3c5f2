(* Statements of torses, Part Constant. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module slope_torse.
(* torses/slope.torse, Constant slope
   printed: The lines of slope h on the normals of a plane curve form a torse: R = [-y' w, x' w, h] with w² (x'² + y'²) = 1, (w² (x'² + y'²))' = 0.
   stated: det([[x'(u), y'(u), 0], R(u), R'(u)])*w(u) == 0 *)
Definition R_ (h : R) (w_u_ : R) (x'_u_ : R) (y'_u_ : R) : list R :=
  [- y'_u_ * w_u_; x'_u_ * w_u_; h].
Definition R__ (h : R) (w'_u_ : R) (w_u_ : R) (x''_u_ : R) (x'_u_ : R) (y''_u_ : R) (y'_u_ : R) (u : R) : list R :=
  [- (y'_u_ + 1 * u * y''_u_) * (w_u_ + 1 * u * w'_u_); (x'_u_ + 1 * u * x''_u_) * (w_u_ + 1 * u * w'_u_); h].
Definition statement : Prop :=
forall (h : R) (u : R) (w'_u_ : R) (w_u_ : R) (x''_u_ : R) (x'_u_ : R) (y''_u_ : R) (y'_u_ : R),
  Derive_n (fun u_ => let u__ := u + u_ in (w_u_ + 1 * u_ * w'_u_) ^ 2 * ((x'_u_ + 1 * u_ * x''_u_) ^ 2 + (y'_u_ + 1 * u_ * y''_u_) ^ 2)) 1 0 = 0 ->
  det [[x'_u_; y'_u_; 0]; R_ h w_u_ x'_u_ y'_u_; vDerive 3 (fun u_ => R__ h w'_u_ w_u_ x''_u_ x'_u_ y''_u_ y'_u_ u_) 1 0] * w_u_ = 0.
Definition instance : Prop :=
exists (h : R) (u : R) (w'_u_ : R) (w_u_ : R) (x''_u_ : R) (x'_u_ : R) (y''_u_ : R) (y'_u_ : R),
  Derive_n (fun u_ => let u__ := u + u_ in (w_u_ + 1 * u_ * w'_u_) ^ 2 * ((x'_u_ + 1 * u_ * x''_u_) ^ 2 + (y'_u_ + 1 * u_ * y''_u_) ^ 2)) 1 0 = 0.
End slope_torse.
