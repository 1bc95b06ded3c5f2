(* Statements of trigonometric, Part Helicoid. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition X (h : R) (r : R) (t : R) : list R :=
  [r * cos t; r * sin t; h * t].
Definition N_ (t : R) : list R :=
  [cos t; sin t; 0].
End Definitions.
Import Definitions.

Module helicoid_skew.
(* trigonometric/helicoid.skew, Helicoid
   printed: For the helicoid, with rulings along N, det(X', N, N') = h.
   stated: det([X'(t), N(t), N'(t)]) == h *)
Definition statement : Prop :=
forall (h : R) (r : R) (t : R),
  0 < h ->
  0 < r ->
  det [vDerive 3 (fun t => X h r t) 1 t; N_ t; vDerive 3 (fun t => N_ t) 1 t] = h.
Definition instance : Prop :=
exists (h : R) (r : R) (t : R),
  0 < h /\
  0 < r.
End helicoid_skew.

Module helicoid_skew_slip.
(* trigonometric/helicoid.skew.slip, Helicoid
   printed: A common slip: the helicoid is developable, det(X', N, N') = 0
   stated: det([X'(t), N(t), N'(t)]) == 0 *)
Definition statement : Prop :=
forall (h : R) (r : R) (t : R),
  0 < h ->
  0 < r ->
  det [vDerive 3 (fun t => X h r t) 1 t; N_ t; vDerive 3 (fun t => N_ t) 1 t] = 0.
End helicoid_skew_slip.
