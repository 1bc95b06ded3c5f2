(* Statements of bezier, Part Lists. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition T (x : R) (v : R) (i : Z) (k : Z) : R :=
  basis 0 0 [(1 - x) ^ 2 * (1 + v * x); 2 * x * (1 - x) - v * x * (1 - x); x ^ 2 * (1 + v * (1 - x))] i k.
End Definitions.
Import Definitions.

Module list_unity.
(* bezier/list.unity, Lists
   printed: The functions T_0, T_1, T_2 add up to one.
   stated: T[0,2](x) + T[1,2](x) + T[2,2](x) == 1 *)
Definition statement : Prop :=
forall (v : R) (x : R),
  0 <= x <= 1 ->
  T x v 0%Z 2%Z + T x v 1%Z 2%Z + T x v 2%Z 2%Z = 1.
Definition instance : Prop :=
exists (v : R) (x : R),
  0 <= x <= 1.
End list_unity.

Module list_nonnegative.
(* bezier/list.nonnegative, Lists
   printed: They are nonnegative for -1 <= v <= 2.
   stated: nonnegative(T) *)
Definition statement : Prop :=
forall (v : R),
  (-1) <= v <= 2 ->
  forall x : R, 0 <= x <= 1 -> T x v 0%Z 2%Z >= 0 /\ T x v 1%Z 2%Z >= 0 /\ T x v 2%Z 2%Z >= 0.
Definition instance : Prop :=
exists (v : R),
  (-1) <= v <= 2.
End list_nonnegative.

Module list_nonnegative_slip.
(* bezier/list.nonnegative.slip, Lists
   printed: A common slip: they are nonnegative for -1 <= v <= 3.
   stated: nonnegative(T) *)
Definition statement : Prop :=
forall (v : R),
  (-1) <= v <= 3 ->
  forall x : R, 0 <= x <= 1 -> T x v 0%Z 2%Z >= 0 /\ T x v 1%Z 2%Z >= 0 /\ T x v 2%Z 2%Z >= 0.
End list_nonnegative_slip.
