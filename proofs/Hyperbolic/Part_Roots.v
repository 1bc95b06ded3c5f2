(* Statements of hyperbolic, Part Roots. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition K (t : R) : list R :=
  [t; (exp t + exp (- t)) / 2].
End Definitions.
Import Definitions.

Module catenary_norm.
(* hyperbolic/catenary.norm, Roots
   printed: |K'| = cosh t
   stated: norm(K'(t)) == cosh(t) *)
Definition statement : Prop :=
forall (t : R),
  norm (vDerive 2 (fun t_ => K t_) 1 t) = (exp t + exp (- t)) / 2.
End catenary_norm.

Module catenary_bend.
(* hyperbolic/catenary.bend, Roots
   printed: The curvature: det(K', K'')/|K'|³ = 1/cosh² t
   stated: det([K'(t), K''(t)])/norm(K'(t))^3 == 1/cosh(t)^2 *)
Definition statement : Prop :=
forall (t : R),
  norm (vDerive 2 (fun t_ => K t_) 1 t) ^ 3 <> 0 ->
  ((exp t + exp (- t)) / 2) ^ 2 <> 0 ->
  det [vDerive 2 (fun t_ => K t_) 1 t; vDerive 2 (fun t_ => K t_) 2 t] / norm (vDerive 2 (fun t_ => K t_) 1 t) ^ 3 = 1 / ((exp t + exp (- t)) / 2) ^ 2.
Definition instance : Prop :=
exists (t : R),
  norm (vDerive 2 (fun t_ => K t_) 1 t) ^ 3 <> 0 /\
  ((exp t + exp (- t)) / 2) ^ 2 <> 0.
End catenary_bend.

Module catenary_bend_slip.
(* hyperbolic/catenary.bend.slip, Roots
   printed: A common slip: det(K', K'')/|K'|³ = 1/cosh t
   stated: det([K'(t), K''(t)])/norm(K'(t))^3 == 1/cosh(t) *)
Definition statement : Prop :=
forall (t : R),
  norm (vDerive 2 (fun t_ => K t_) 1 t) ^ 3 <> 0 ->
  (exp t + exp (- t)) / 2 <> 0 ->
  det [vDerive 2 (fun t_ => K t_) 1 t; vDerive 2 (fun t_ => K t_) 2 t] / norm (vDerive 2 (fun t_ => K t_) 1 t) ^ 3 = 1 / ((exp t + exp (- t)) / 2).
End catenary_bend_slip.

Module catenary_bend_slip_corrected.
(* hyperbolic/catenary.bend.slip (corrected), Roots
   printed: A common slip: det(K', K'')/|K'|³ = 1/cosh t
   stated: det([K'(t), K''(t)])/norm(K'(t))^3 == 1/cosh(t)^2 *)
Definition statement : Prop :=
forall (t : R),
  norm (vDerive 2 (fun t_ => K t_) 1 t) ^ 3 <> 0 ->
  ((exp t + exp (- t)) / 2) ^ 2 <> 0 ->
  det [vDerive 2 (fun t_ => K t_) 1 t; vDerive 2 (fun t_ => K t_) 2 t] / norm (vDerive 2 (fun t_ => K t_) 1 t) ^ 3 = 1 / ((exp t + exp (- t)) / 2) ^ 2.
Definition instance : Prop :=
exists (t : R),
  norm (vDerive 2 (fun t_ => K t_) 1 t) ^ 3 <> 0 /\
  ((exp t + exp (- t)) / 2) ^ 2 <> 0.
End catenary_bend_slip_corrected.

Module tractrix_norm.
(* hyperbolic/tractrix.norm, Roots
   printed: |T'| = |tanh t|
   stated: norm(T'(t)) == abs(tanh(t)) *)
Definition T (t : R) : list R :=
  [t - (exp t - exp (- t)) / (exp t + exp (- t)); 1 / ((exp t + exp (- t)) / 2)].
Definition statement : Prop :=
forall (t : R),
  locally t (fun t_ => exp t_ + exp (- t_) <> 0) ->
  locally t (fun t_ => (exp t_ + exp (- t_)) / 2 <> 0) ->
  exp t + exp (- t) <> 0 ->
  0 <= (exp t - exp (- t)) / (exp t + exp (- t)) * ((exp t - exp (- t)) / (exp t + exp (- t))) ->
  norm (vDerive 2 (fun t_ => T t_) 1 t) = sqrt ((exp t - exp (- t)) / (exp t + exp (- t)) * ((exp t - exp (- t)) / (exp t + exp (- t)))).
Definition instance : Prop :=
exists (t : R),
  locally t (fun t_ => exp t_ + exp (- t_) <> 0) /\
  locally t (fun t_ => (exp t_ + exp (- t_)) / 2 <> 0) /\
  exp t + exp (- t) <> 0 /\
  0 <= (exp t - exp (- t)) / (exp t + exp (- t)) * ((exp t - exp (- t)) / (exp t + exp (- t))).
End tractrix_norm.
