(* Statements of trigonometric, Part Tangents. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module angle_tangent.
(* trigonometric/angle.tangent, Tangents
   printed: tan(w/2) = sin w/(1 + cos w) for w in (-π, π)
   stated: tan(w/2) == sin(w)/(1 + cos(w)) *)
Definition statement : Prop :=
forall (w : R),
  (-1) * PI < w < 1 * PI ->
  cos (w / 2) <> 0 ->
  1 + cos w <> 0 ->
  sin (w / 2) / cos (w / 2) = sin w / (1 + cos w).
Definition instance : Prop :=
exists (w : R),
  (-1) * PI < w < 1 * PI /\
  cos (w / 2) <> 0 /\
  1 + cos w <> 0.
End angle_tangent.

Module angle_tangent_closed.
(* trigonometric/angle.tangent.closed, Tangents
   printed: tan(v/2) = sin v/(1 + cos v) for v in [-π, π]
   stated: tan(v/2) == sin(v)/(1 + cos(v)) *)
Definition statement : Prop :=
forall (v : R),
  (-1) * PI <= v <= 1 * PI ->
  cos (v / 2) <> 0 ->
  1 + cos v <> 0 ->
  sin (v / 2) / cos (v / 2) = sin v / (1 + cos v).
Definition instance : Prop :=
exists (v : R),
  (-1) * PI <= v <= 1 * PI /\
  cos (v / 2) <> 0 /\
  1 + cos v <> 0.
End angle_tangent_closed.
