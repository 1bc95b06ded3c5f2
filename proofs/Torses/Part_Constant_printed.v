(* Statements of torses, Part Constant. Nothing is proved here. *)
From Torse Require Import Defs Functions.
Open Scope R_scope.

Module slope_torse.
(* torses/slope.torse, Constant slope
   printed: The lines of slope h on the normals of a plane curve form a torse: R = [-y' w, x' w, h] with w² (x'² + y'²) = 1, (w² (x'² + y'²))' = 0.
   stated: det([[x'(u), y'(u), 0], R(u), R'(u)])*w(u) == 0 *)
Definition R_ (h : R) (w : R -> R) (x : R -> R) (y : R -> R) (u : R) : list R :=
  [- Derive_n (fun x => y x) 1 u * w u; Derive_n (fun x_ => x x_) 1 u * w u; h].
Definition statement : Prop :=
forall (w : R -> R) (x : R -> R) (y : R -> R) (h : R) (u : R),
  smooth w ->
  smooth x ->
  smooth y ->
  Derive_n (fun u => w u ^ 2 * (Derive_n (fun x_ => x x_) 1 u ^ 2 + Derive_n (fun x => y x) 1 u ^ 2)) 1 u = 0 ->
  det [[Derive_n (fun x_ => x x_) 1 u; Derive_n (fun x => y x) 1 u; 0]; R_ h w x y u; vDerive 3 (fun u => R_ h w x y u) 1 u] * w u = 0.
Definition instance : Prop :=
exists (w : R -> R) (x : R -> R) (y : R -> R) (h : R) (u : R),
  smooth w /\
  smooth x /\
  smooth y /\
  Derive_n (fun u => w u ^ 2 * (Derive_n (fun x_ => x x_) 1 u ^ 2 + Derive_n (fun x => y x) 1 u ^ 2)) 1 u = 0.
End slope_torse.
