(* Statements of hyperbolic, Part Tractrix. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition T (t : R) : list R :=
  [t - (exp t - exp (- t)) / (exp t + exp (- t)); 1 / ((exp t + exp (- t)) / 2)].
End Definitions.
Import Definitions.

Module tractrix_pull.
(* hyperbolic/tractrix.pull, Tractrix
   printed: On each tangent the axis is at distance 1: T_2²/T_2'² T'·T' = 1 for t > 0
   stated: T(t)[2]^2/T'(t)[2]^2*dot(T'(t), T'(t)) == 1 *)
Definition statement : Prop :=
forall (t : R),
  0 < t ->
  exp t + exp (- t) <> 0 ->
  (exp t + exp (- t)) / 2 <> 0 ->
  locally t (fun t_ => exp t_ + exp (- t_) <> 0) ->
  locally t (fun t_ => (exp t_ + exp (- t_)) / 2 <> 0) ->
  entry (vDerive 2 (fun t => T t) 1 t) 2 ^ 2 <> 0 ->
  entry (T t) 2 ^ 2 / entry (vDerive 2 (fun t => T t) 1 t) 2 ^ 2 * dot (vDerive 2 (fun t => T t) 1 t) (vDerive 2 (fun t => T t) 1 t) = 1.
Definition instance : Prop :=
exists (t : R),
  0 < t /\
  exp t + exp (- t) <> 0 /\
  (exp t + exp (- t)) / 2 <> 0 /\
  locally t (fun t_ => exp t_ + exp (- t_) <> 0) /\
  locally t (fun t_ => (exp t_ + exp (- t_)) / 2 <> 0) /\
  entry (vDerive 2 (fun t => T t) 1 t) 2 ^ 2 <> 0.
End tractrix_pull.

Module tractrix_speed.
(* hyperbolic/tractrix.speed, Tractrix
   printed: T'·T' = tanh² t
   stated: dot(T'(t), T'(t)) == tanh(t)^2 *)
Definition statement : Prop :=
forall (t : R),
  locally t (fun t_ => exp t_ + exp (- t_) <> 0) ->
  locally t (fun t_ => (exp t_ + exp (- t_)) / 2 <> 0) ->
  exp t + exp (- t) <> 0 ->
  dot (vDerive 2 (fun t => T t) 1 t) (vDerive 2 (fun t => T t) 1 t) = ((exp t - exp (- t)) / (exp t + exp (- t))) ^ 2.
Definition instance : Prop :=
exists (t : R),
  locally t (fun t_ => exp t_ + exp (- t_) <> 0) /\
  locally t (fun t_ => (exp t_ + exp (- t_)) / 2 <> 0) /\
  exp t + exp (- t) <> 0.
End tractrix_speed.
