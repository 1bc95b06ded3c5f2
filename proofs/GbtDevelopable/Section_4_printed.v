(* Statements of gbt-developable, Section 4. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition E2_0 : list R :=
  [5 * sqrt 2; - 5 * sqrt 2; 5; 125].
Definition E2_1 : list R :=
  [- 5 * sqrt 2; - 5 * sqrt 2; 5; 125].
Definition E2_2 : list R :=
  [- 5 * sqrt 2; - 5 * sqrt 2; 5; 125].
Definition E2_3 : list R :=
  [5 * sqrt 2; - 5 * sqrt 2; 5; 125].
Definition distance2 (P : list R) : R :=
  entry P 4 ^ 2 / dot (normal P) (normal P).
Definition midpoint (P : list R) : list R :=
  vscale (entry P 4 / dot (normal P) (normal P)) (normal P).
Definition volume (A : list R) (B : list R) (C_ : list R) (D_ : list R) : R :=
  det [vsub (midpoint B) (midpoint A); vsub (midpoint C_) (midpoint A); vsub (midpoint D_) (midpoint A)].
End Definitions.
Import Definitions.

Module sec_4_midpoints.
(* gbt-developable/sec-4.midpoints, Sect. 4, first paragraph, last sentence
   printed: In all designing examples of enveloping developable GBT-Bézier surfaces, we assume that the midpoints of all planes of the enveloping developable GBT-Bézier surfaces lie in the same plane and have the same distance from the origin.
   read as: 'midpoint' of a plane read as its nearest point to the origin, s t/|t|²; 'all planes' as the control planes, as Example 4.1 says of the same assumption ('the midpoints of the four control planes'); 'all designing examples of enveloping developable GBT-Bézier surfaces' is the heading of Sect. 4.1, with Examples 4.1 and 4.2.
   stated: distance2(E1_0) == distance2(E1_1) == distance2(E1_2) == distance2(E1_3) and volume(E1_0, E1_1, E1_2, E1_3) == 0 and distance2(E2_0) == distance2(E2_1) == distance2(E2_2) == distance2(E2_3) and volume(E2_0, E2_1, E2_2, E2_3) == 0 *)
Definition E1_0 : list R :=
  [0; - 20; 10; 400].
Definition E1_1 : list R :=
  [0; - 10; 20; 400].
Definition E1_2 : list R :=
  [0; 10; 20; 400].
Definition E1_3 : list R :=
  [0; 20; 10; 400].
Definition statement : Prop :=
  dot (normal E1_0) (normal E1_0) <> 0 ->
  dot (normal E1_1) (normal E1_1) <> 0 ->
  dot (normal E1_2) (normal E1_2) <> 0 ->
  dot (normal E1_3) (normal E1_3) <> 0 ->
  dot (normal E2_0) (normal E2_0) <> 0 ->
  dot (normal E2_1) (normal E2_1) <> 0 ->
  dot (normal E2_2) (normal E2_2) <> 0 ->
  dot (normal E2_3) (normal E2_3) <> 0 ->
  distance2 E1_0 = distance2 E1_1 /\ distance2 E1_1 = distance2 E1_2 /\ distance2 E1_2 = distance2 E1_3 /\ volume E1_0 E1_1 E1_2 E1_3 = 0 /\ distance2 E2_0 = distance2 E2_1 /\ distance2 E2_1 = distance2 E2_2 /\ distance2 E2_2 = distance2 E2_3 /\ volume E2_0 E2_1 E2_2 E2_3 = 0.
Definition instance : Prop :=
  dot (normal E1_0) (normal E1_0) <> 0 /\
  dot (normal E1_1) (normal E1_1) <> 0 /\
  dot (normal E1_2) (normal E1_2) <> 0 /\
  dot (normal E1_3) (normal E1_3) <> 0 /\
  dot (normal E2_0) (normal E2_0) <> 0 /\
  dot (normal E2_1) (normal E2_1) <> 0 /\
  dot (normal E2_2) (normal E2_2) <> 0 /\
  dot (normal E2_3) (normal E2_3) <> 0.
End sec_4_midpoints.

Module ex_4_2_distance.
(* gbt-developable/ex-4.2.distance, Sect. 4 (rule for all enveloping examples) applied to Example 4.2
   printed: midpoints of all planes ... have the same distance from the origin
   stated: distance2(E2_0) == distance2(E2_1) == distance2(E2_2) == distance2(E2_3) *)
Definition statement : Prop :=
  dot (normal E2_0) (normal E2_0) <> 0 ->
  dot (normal E2_1) (normal E2_1) <> 0 ->
  dot (normal E2_2) (normal E2_2) <> 0 ->
  dot (normal E2_3) (normal E2_3) <> 0 ->
  distance2 E2_0 = distance2 E2_1 /\ distance2 E2_1 = distance2 E2_2 /\ distance2 E2_2 = distance2 E2_3.
Definition instance : Prop :=
  dot (normal E2_0) (normal E2_0) <> 0 /\
  dot (normal E2_1) (normal E2_1) <> 0 /\
  dot (normal E2_2) (normal E2_2) <> 0 /\
  dot (normal E2_3) (normal E2_3) <> 0.
End ex_4_2_distance.

Module ex_4_2_coplanar.
(* gbt-developable/ex-4.2.coplanar, Sect. 4 (rule for all enveloping examples) applied to Example 4.2
   printed: midpoints of all planes ... lie in the same plane
   stated: volume(E2_0, E2_1, E2_2, E2_3) == 0 *)
Definition statement : Prop :=
  dot (normal E2_1) (normal E2_1) <> 0 ->
  dot (normal E2_0) (normal E2_0) <> 0 ->
  dot (normal E2_2) (normal E2_2) <> 0 ->
  dot (normal E2_3) (normal E2_3) <> 0 ->
  volume E2_0 E2_1 E2_2 E2_3 = 0.
Definition instance : Prop :=
  dot (normal E2_1) (normal E2_1) <> 0 /\
  dot (normal E2_0) (normal E2_0) <> 0 /\
  dot (normal E2_2) (normal E2_2) <> 0 /\
  dot (normal E2_3) (normal E2_3) <> 0.
End ex_4_2_coplanar.
