(* Statements of splines, Part B. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module uniform_bezier.
(* splines/uniform.bezier, Bézier points
   printed: The inner Bézier points of F: F'(0) = 3(b_1 - F(0)) with b_1 = (2P_1 + P_2)/3
   stated: F'(0) == 3*((2*P[1] + P[2])/3 - F(0)) *)
Definition U (s : R) (i : Z) (k : Z) : R :=
  counted (fun i k => (IZR i + 1 - s) / IZR k) (fun i k => (s + IZR k - IZR i) / IZR k) [1] i k.
Definition F (P : Z -> R) (s : R) : R :=
  sum 0%Z 3%Z (fun i => U s i 3%Z * P i).
Definition statement : Prop :=
forall (P : Z -> R),
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= 4)%Z) ->
  Derive_n (fun s => F P s) 1 0 = 3 * ((2 * P 1%Z + P 2%Z) / 3 - F P 0).
Definition instance : Prop :=
exists (P : Z -> R),
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i <= 4)%Z).
End uniform_bezier.
