(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Ends Hermite.
From GbtDevelopable Require Section_4_1.
Import GbtDevelopable.Section_4_1.Definitions.
Open Scope R_scope.

Module ex_4_1_Q0.
Import GbtDevelopable.Section_4_1.ex_4_1_Q0.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g E1_0 E1_1 E1_2 E1_3 E1]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g E1_0 E1_1 E1_2 E1_3 E1]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_1_Q0.

Module ex_4_1_Q1.
Import GbtDevelopable.Section_4_1.ex_4_1_Q1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal g E1_0 E1_1 E1_2 E1_3 E1 distance2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal g E1_0 E1_1 E1_2 E1_3 E1 distance2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_1_Q1.

Module ex_4_1_Q2.
Import GbtDevelopable.Section_4_1.ex_4_1_Q2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal g E1_0 E1_1 E1_2 E1_3 E1 distance2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal g E1_0 E1_1 E1_2 E1_3 E1 distance2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_1_Q2.

Module ex_4_1_Q3.
Import GbtDevelopable.Section_4_1.ex_4_1_Q3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal g E1_0 E1_1 E1_2 E1_3 E1 distance2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal g E1_0 E1_1 E1_2 E1_3 E1 distance2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_1_Q3.

Module ex_4_1_distance.
Import GbtDevelopable.Section_4_1.ex_4_1_distance.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement E1_0 normal E1_1 E1_2 E1_3 distance2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance E1_0 normal E1_1 E1_2 E1_3 distance2]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_1_distance.

Module ex_4_1_coplanar.
Import GbtDevelopable.Section_4_1.ex_4_1_coplanar.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement E1_0 E1_1 E1_2 E1_3 normal midpoint volume]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance E1_0 E1_1 E1_2 E1_3 normal midpoint volume]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_1_coplanar.

Module ex_4_1_c1_a.
Import GbtDevelopable.Section_4_1.ex_4_1_c1_a.
Theorem proved : statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in let lines := fun _ => (compute_goal; intros; repeat match goal with L : locally _ _ |- _ => apply locally_singleton in L; cbv beta in L end; conjuncts; parts; derivatives; roots; equal) in cbv beta zeta delta [statement]; line_at E1 E1_ 0%Z ltac:(cbv beta delta [direction moment normal E1 E1_ g E1_0 E1_1 E1_2 E1_3]); lines (). Qed.
Theorem met : instance.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [instance]; line_at E1 E1_ 0%Z ltac:(cbv beta delta [direction moment normal E1 E1_ g E1_0 E1_1 E1_2 E1_3]); exists 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ lra | near ]. Qed.
End ex_4_1_c1_a.

Module ex_4_1_lengths.
Import GbtDevelopable.Section_4_1.ex_4_1_lengths.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g E1_0 E1_1 E1_2 E1_3 E1 E1_ normal direction length2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g E1_0 E1_1 E1_2 E1_3 E1 E1_ normal direction length2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_1_lengths.

Module ex_4_1_lengths_exchanged.
Import GbtDevelopable.Section_4_1.ex_4_1_lengths_exchanged.
Theorem proved : statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [statement]; line_at E1 E1_ 0%Z ltac:(cbv beta delta [direction moment normal E1 E1_ g E1_0 E1_1 E1_2 E1_3]); line_at E1 E1_ 1%Z ltac:(cbv beta delta [direction moment normal E1 E1_ g E1_0 E1_1 E1_2 E1_3]); line_at E1__ E1___ 0%Z ltac:(cbv beta delta [direction moment normal E1__ E1___ g E1_0 E1_1 E1_2 E1_3]); line_at E1__ E1___ 1%Z ltac:(cbv beta delta [direction moment normal E1__ E1___ g E1_0 E1_1 E1_2 E1_3]); compute_goal; intros; conjuncts; derivatives; pose proof PI_RGT_0; first [ solve [field] | nra ]. Qed.
Theorem met : instance.
Proof. cbv delta [instance]; exists 0, 0; lra. Qed.
End ex_4_1_lengths_exchanged.

Module ex_4_1_c1_b.
Import GbtDevelopable.Section_4_1.ex_4_1_c1_b.
Theorem proved : statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in let lines := fun _ => (compute_goal; intros; repeat match goal with L : locally _ _ |- _ => apply locally_singleton in L; cbv beta in L end; conjuncts; parts; derivatives; roots; equal) in cbv beta zeta delta [statement]; line_at E1 E1_ 1%Z ltac:(cbv beta delta [direction moment normal E1 E1_ g E1_0 E1_1 E1_2 E1_3]); lines (). Qed.
Theorem met : instance.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [instance]; line_at E1 E1_ 1%Z ltac:(cbv beta delta [direction moment normal E1 E1_ g E1_0 E1_1 E1_2 E1_3]); exists 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ lra | near ]. Qed.
End ex_4_1_c1_b.

Module ex_4_1_c1_c.
Import GbtDevelopable.Section_4_1.ex_4_1_c1_c.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g E1_0 E1_1 E1_2 E1_3 E1 E1_ normal direction length2] in no; refuting (no (0) (1)). Qed.
End ex_4_1_c1_c.

Module ex_4_1_c1_d.
Import GbtDevelopable.Section_4_1.ex_4_1_c1_d.
Theorem refuted : ~ statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [statement not]; intro no; apply (no 0 0 ltac:(lra) ltac:(lra)); clear no; line_at E1 E1_ 0%Z ltac:(cbv beta delta [direction moment normal E1 E1_ g E1_0 E1_1 E1_2 E1_3]); compute_goal; intros; derivatives; ring. Qed.
End ex_4_1_c1_d.

Module ex_4_1_c1_e.
Import GbtDevelopable.Section_4_1.ex_4_1_c1_e.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g E1_0 E1_1 E1_2 E1_3 E1 E1_ normal direction length2] in no; refuting (no (0) (0)). Qed.
End ex_4_1_c1_e.

Module ex_4_1_c1_f_there_and_nowhere_else.
Import GbtDevelopable.Section_4_1.ex_4_1_c1_f_there_and_nowhere_else.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g E1_0 E1_1 E1_2 E1_3 E1 E1_ E1__ E1___ normal direction length2 len len_] in no; refuting (no (1) (0)). Qed.
End ex_4_1_c1_f_there_and_nowhere_else.

Module ex_4_1_c2_a.
Import GbtDevelopable.Section_4_1.ex_4_1_c2_a.
Theorem proved : statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in let lines := fun _ => (compute_goal; intros; repeat match goal with L : locally _ _ |- _ => apply locally_singleton in L; cbv beta in L end; conjuncts; parts; derivatives; roots; equal) in cbv beta zeta delta [statement]; line_at E1 E1_ 0%Z ltac:(cbv beta delta [direction moment normal E1 E1_ g E1_0 E1_1 E1_2 E1_3]); line_at E1__ E1___ 0%Z ltac:(cbv beta delta [direction moment normal E1__ E1___ g E1_0 E1_1 E1_2 E1_3]); lines (). Qed.
Theorem met : instance.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [instance]; line_at E1 E1_ 0%Z ltac:(cbv beta delta [direction moment normal E1 E1_ g E1_0 E1_1 E1_2 E1_3]); exists 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ lra | near ]. Qed.
End ex_4_1_c2_a.

Module ex_4_1_c2_b.
Import GbtDevelopable.Section_4_1.ex_4_1_c2_b.
Theorem proved : statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in let lines := fun _ => (compute_goal; intros; repeat match goal with L : locally _ _ |- _ => apply locally_singleton in L; cbv beta in L end; conjuncts; parts; derivatives; roots; equal) in cbv beta zeta delta [statement]; line_at E1 E1_ 1%Z ltac:(cbv beta delta [direction moment normal E1 E1_ g E1_0 E1_1 E1_2 E1_3]); line_at E1__ E1___ 1%Z ltac:(cbv beta delta [direction moment normal E1__ E1___ g E1_0 E1_1 E1_2 E1_3]); lines (). Qed.
Theorem met : instance.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [instance]; line_at E1 E1_ 1%Z ltac:(cbv beta delta [direction moment normal E1 E1_ g E1_0 E1_1 E1_2 E1_3]); exists 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ lra | near ]. Qed.
End ex_4_1_c2_b.

Module ex_4_1_c2_c.
Import GbtDevelopable.Section_4_1.ex_4_1_c2_c.
Theorem refuted : ~ statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [statement not]; intro no; apply (no 0 0 ltac:(lra) ltac:(lra)); clear no; line_at E1 E1_ 1%Z ltac:(cbv beta delta [direction moment normal E1 E1_ g E1_0 E1_1 E1_2 E1_3]); compute_goal; intros; derivatives; ring. Qed.
End ex_4_1_c2_c.

Module ex_4_1_c2_d.
Import GbtDevelopable.Section_4_1.ex_4_1_c2_d.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g E1_0 E1_1 E1_2 E1_3 E1 E1_ normal direction length2] in no; refuting (no (0) (0)). Qed.
End ex_4_1_c2_d.

Module ex_4_1_c2_e_there_and_nowhere_else.
Import GbtDevelopable.Section_4_1.ex_4_1_c2_e_there_and_nowhere_else.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g E1_0 E1_1 E1_2 E1_3 E1 E1_ E1__ E1___ normal direction length2 len len_] in no; refuting (no (0) (1)). Qed.
End ex_4_1_c2_e_there_and_nowhere_else.

Module ex_4_1_c3_a.
Import GbtDevelopable.Section_4_1.ex_4_1_c3_a.
Theorem refuted : ~ statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in let lines := fun _ => (compute_goal; intros; repeat match goal with L : locally _ _ |- _ => apply locally_singleton in L; cbv beta in L end; conjuncts; parts; derivatives; roots; equal) in cbv beta zeta delta [statement not]; intro no; apply (no 0 0 ltac:(lra) ltac:(lra)); clear no; line_at E1 E1_ 0%Z ltac:(cbv beta delta [direction moment normal E1 E1_ g E1_0 E1_1 E1_2 E1_3]); line_at E1 E1_ 1%Z ltac:(cbv beta delta [direction moment normal E1 E1_ g E1_0 E1_1 E1_2 E1_3]); line_at E1__ E1___ 0%Z ltac:(cbv beta delta [direction moment normal E1__ E1___ g E1_0 E1_1 E1_2 E1_3]); line_at E1__ E1___ 1%Z ltac:(cbv beta delta [direction moment normal E1__ E1___ g E1_0 E1_1 E1_2 E1_3]); lines (). Qed.
End ex_4_1_c3_a.

Module ex_4_1_c3_b.
Import GbtDevelopable.Section_4_1.ex_4_1_c3_b.
Theorem proved : statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [statement not]; line_at E1 E1_ 0%Z ltac:(cbv beta delta [direction moment normal E1 E1_ g E1_0 E1_1 E1_2 E1_3]); line_at E1 E1_ 1%Z ltac:(cbv beta delta [direction moment normal E1 E1_ g E1_0 E1_1 E1_2 E1_3]); compute_goal; intros nu N; split; intro no; specialize (no 0 ltac:(lra)); revert no; derivatives; pose proof PI_RGT_0; nra. Qed.
Theorem met : instance.
Proof. cbv delta [instance]; exists 0; lra. Qed.
End ex_4_1_c3_b.

Module ex_4_1_c3_c.
Import GbtDevelopable.Section_4_1.ex_4_1_c3_c.
Theorem proved : statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [statement]; line_at E1 E1_ 0%Z ltac:(cbv beta delta [direction moment normal E1 E1_ g E1_0 E1_1 E1_2 E1_3]); line_at E1 E1_ 1%Z ltac:(cbv beta delta [direction moment normal E1 E1_ g E1_0 E1_1 E1_2 E1_3]); compute_goal; intros; split; derivatives; pose proof PI_RGT_0; nra. Qed.
Theorem met : instance.
Proof. cbv delta [instance]; exists 0; lra. Qed.
End ex_4_1_c3_c.

Module ex_4_2_Q0.
Import GbtDevelopable.Section_4_1.ex_4_2_Q0.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g E2_0 E2_1 E2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g E2_0 E2_1 E2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_2_Q0.

Module ex_4_2_Q1.
Import GbtDevelopable.Section_4_1.ex_4_2_Q1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal g E2_0 E2_1 E2 distance2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal g E2_0 E2_1 E2 distance2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_2_Q1.

Module ex_4_2_Q2.
Import GbtDevelopable.Section_4_1.ex_4_2_Q2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal g E2_0 E2_1 E2 distance2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal g E2_0 E2_1 E2 distance2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_2_Q2.

Module ex_4_2_Q3.
Import GbtDevelopable.Section_4_1.ex_4_2_Q3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal g E2_0 E2_1 E2 distance2]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal g E2_0 E2_1 E2 distance2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_2_Q3.

Module ex_4_2_pencil.
Import GbtDevelopable.Section_4_1.ex_4_2_pencil.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g E2_0 E2_1 E2 normal]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g E2_0 E2_1 E2 normal]; first [(exists ((-1) / 3), ((-1) / 3), (1 / 3), (5); met) | (exists (0), (0), (1 / 2), (0); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3), (6); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3), (1); met) | (exists ((-1) / 3), ((-1) / 3), (1 / 3), (1); met)]. Qed.
End ex_4_2_pencil.

Module ex_4_2_lengths.
Import GbtDevelopable.Section_4_1.ex_4_2_lengths.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement g E2_0 E2_1 E2 E2_ normal direction length2]; at_points. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance g E2_0 E2_1 E2 E2_ normal direction length2]; first [(exists ((-1) / 3), ((-1) / 3); met) | (exists (0), (0); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met) | (exists ((-1) / 3), ((-1) / 3); met)]. Qed.
End ex_4_2_lengths.

Module ex_4_2_c1_a.
Import GbtDevelopable.Section_4_1.ex_4_2_c1_a.
Theorem refuted : ~ statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [statement not]; intro no; apply (no 0 0 ltac:(lra) ltac:(lra)); clear no; line_at E2 E2_ 1%Z ltac:(cbv beta delta [direction moment normal E2 E2_ g E2_0 E2_1]); compute_goal; intros; derivatives; atoms; equal. Qed.
End ex_4_2_c1_a.

Module ex_4_2_c1_b.
Import GbtDevelopable.Section_4_1.ex_4_2_c1_b.
Theorem proved : statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in let lines := fun _ => (compute_goal; intros; repeat match goal with L : locally _ _ |- _ => apply locally_singleton in L; cbv beta in L end; conjuncts; parts; derivatives; roots; equal) in cbv beta zeta delta [statement]; line_at E2 E2_ 1%Z ltac:(cbv beta delta [direction moment normal E2 E2_ g E2_0 E2_1]); line_at E2__ E2___ 1%Z ltac:(cbv beta delta [direction moment normal E2__ E2___ g E2_0 E2_1]); lines (). Qed.
Theorem met : instance.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [instance]; line_at E2 E2_ 1%Z ltac:(cbv beta delta [direction moment normal E2 E2_ g E2_0 E2_1]); exists 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ lra | near ]. Qed.
End ex_4_2_c1_b.

Module ex_4_2_c1_c.
Import GbtDevelopable.Section_4_1.ex_4_2_c1_c.
Theorem proved : statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in let lines := fun _ => (compute_goal; intros; repeat match goal with L : locally _ _ |- _ => apply locally_singleton in L; cbv beta in L end; conjuncts; parts; derivatives; roots; equal) in cbv beta zeta delta [statement]; line_at E2 E2_ 0%Z ltac:(cbv beta delta [direction moment normal E2 E2_ g E2_0 E2_1]); line_at E2__ E2___ 0%Z ltac:(cbv beta delta [direction moment normal E2__ E2___ g E2_0 E2_1]); lines (). Qed.
Theorem met : instance.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [instance]; line_at E2 E2_ 0%Z ltac:(cbv beta delta [direction moment normal E2 E2_ g E2_0 E2_1]); exists 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ lra | near ]. Qed.
End ex_4_2_c1_c.

Module ex_4_2_c1_d.
Import GbtDevelopable.Section_4_1.ex_4_2_c1_d.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g E2_0 E2_1 E2 E2_ normal direction length2] in no; refuting (no (1) (0)). Qed.
End ex_4_2_c1_d.

Module ex_4_2_c1_e.
Import GbtDevelopable.Section_4_1.ex_4_2_c1_e.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement g E2_0 E2_1 E2 E2_ normal direction length2] in no; refuting (no (0) (0)). Qed.
End ex_4_2_c1_e.

Module ex_4_2_c2_a.
Import GbtDevelopable.Section_4_1.ex_4_2_c2_a.
Theorem refuted : ~ statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [statement not]; line_at E2 E2_ 0%Z ltac:(cbv beta delta [direction moment normal E2 E2_ g E2_0 E2_1]); line_at E2__ E2___ 0%Z ltac:(cbv beta delta [direction moment normal E2__ E2___ g E2_0 E2_1]); compute_goal; intro no; destruct (no (1 / 2) (1 / 2) ltac:(lra) ltac:(lra)) as [A B]; revert A B; derivatives; roots; pose proof PI_RGT_0; intros; nra. Qed.
End ex_4_2_c2_a.

Module ex_4_2_c2_b.
Import GbtDevelopable.Section_4_1.ex_4_2_c2_b.
Theorem proved : statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in let lines := fun _ => (compute_goal; intros; repeat match goal with L : locally _ _ |- _ => apply locally_singleton in L; cbv beta in L end; conjuncts; parts; derivatives; roots; equal) in cbv beta zeta delta [statement]; line_at E2 E2_ 0%Z ltac:(cbv beta delta [direction moment normal E2 E2_ g E2_0 E2_1]); line_at E2__ E2___ 0%Z ltac:(cbv beta delta [direction moment normal E2__ E2___ g E2_0 E2_1]); lines (). Qed.
Theorem met : instance.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [instance]; line_at E2 E2_ 0%Z ltac:(cbv beta delta [direction moment normal E2 E2_ g E2_0 E2_1]); line_at E2__ E2___ 0%Z ltac:(cbv beta delta [direction moment normal E2__ E2___ g E2_0 E2_1]); exists 1, 1; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ lra | near ]. Qed.
End ex_4_2_c2_b.

Module ex_4_2_c2_c.
Import GbtDevelopable.Section_4_1.ex_4_2_c2_c.
Theorem proved : statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in let lines := fun _ => (compute_goal; intros; repeat match goal with L : locally _ _ |- _ => apply locally_singleton in L; cbv beta in L end; conjuncts; parts; derivatives; roots; equal) in cbv beta zeta delta [statement]; line_at E2 E2_ 1%Z ltac:(cbv beta delta [direction moment normal E2 E2_ g E2_0 E2_1]); line_at E2__ E2___ 1%Z ltac:(cbv beta delta [direction moment normal E2__ E2___ g E2_0 E2_1]); lines (). Qed.
Theorem met : instance.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [instance]; line_at E2 E2_ 1%Z ltac:(cbv beta delta [direction moment normal E2 E2_ g E2_0 E2_1]); line_at E2__ E2___ 1%Z ltac:(cbv beta delta [direction moment normal E2__ E2___ g E2_0 E2_1]); exists 1, 1; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ lra | near ]. Qed.
End ex_4_2_c2_c.

Module ex_4_2_c2_d.
Import GbtDevelopable.Section_4_1.ex_4_2_c2_d.
Theorem proved : statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [statement not]; line_at E2 E2_ 1%Z ltac:(cbv beta delta [direction moment normal E2 E2_ g E2_0 E2_1]); line_at E2__ E2___ 1%Z ltac:(cbv beta delta [direction moment normal E2__ E2___ g E2_0 E2_1]); compute_goal; intros mu nu M N no; destruct (no (1 / 2) (1 / 2) ltac:(lra) ltac:(lra)) as [A B]; revert A B; derivatives; roots; pose proof PI_RGT_0; intros; nra. Qed.
Theorem met : instance.
Proof. cbv delta [instance]; exists 1, 1; lra. Qed.
End ex_4_2_c2_d.

Module ex_4_2_c3_a.
Import GbtDevelopable.Section_4_1.ex_4_2_c3_a.
Theorem proved : statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in let lines := fun _ => (compute_goal; intros; repeat match goal with L : locally _ _ |- _ => apply locally_singleton in L; cbv beta in L end; conjuncts; parts; derivatives; roots; equal) in cbv beta zeta delta [statement]; line_at E2 E2_ 0%Z ltac:(cbv beta delta [direction moment normal E2 E2_ g E2_0 E2_1]); line_at E2__ E2___ 0%Z ltac:(cbv beta delta [direction moment normal E2__ E2___ g E2_0 E2_1]); lines (). Qed.
Theorem met : instance.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [instance]; line_at E2 E2_ 0%Z ltac:(cbv beta delta [direction moment normal E2 E2_ g E2_0 E2_1]); line_at E2__ E2___ 0%Z ltac:(cbv beta delta [direction moment normal E2__ E2___ g E2_0 E2_1]); exists (-1), (-1); compute_goal; repeat match goal with |- _ /\ _ => split end; first [ lra | near ]. Qed.
End ex_4_2_c3_a.

Module ex_4_2_c3_b.
Import GbtDevelopable.Section_4_1.ex_4_2_c3_b.
Theorem proved : statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in let lines := fun _ => (compute_goal; intros; repeat match goal with L : locally _ _ |- _ => apply locally_singleton in L; cbv beta in L end; conjuncts; parts; derivatives; roots; equal) in cbv beta zeta delta [statement]; line_at E2 E2_ 1%Z ltac:(cbv beta delta [direction moment normal E2 E2_ g E2_0 E2_1]); line_at E2__ E2___ 1%Z ltac:(cbv beta delta [direction moment normal E2__ E2___ g E2_0 E2_1]); lines (). Qed.
Theorem met : instance.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [instance]; line_at E2 E2_ 1%Z ltac:(cbv beta delta [direction moment normal E2 E2_ g E2_0 E2_1]); line_at E2__ E2___ 1%Z ltac:(cbv beta delta [direction moment normal E2__ E2___ g E2_0 E2_1]); exists (-1), (-1); compute_goal; repeat match goal with |- _ /\ _ => split end; first [ lra | near ]. Qed.
End ex_4_2_c3_b.

Module ex_4_2_c3_c.
Import GbtDevelopable.Section_4_1.ex_4_2_c3_c.
Theorem proved : statement.
Proof. let line_at := fun E E_ z unfolding => (cbv beta delta [foot length2]; let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let simplified := (unfolding; etransitivity; [ lists; at_ends; repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z))); change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y); change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y); eassert (A : a = _) by (subst a; arguments; simplified); eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta) in cbv beta zeta delta [statement not]; line_at E2 E2_ 0%Z ltac:(cbv beta delta [direction moment normal E2 E2_ g E2_0 E2_1]); line_at E2 E2_ 1%Z ltac:(cbv beta delta [direction moment normal E2 E2_ g E2_0 E2_1]); compute_goal; intros nu N; split; intro no; specialize (no (- (1 / 2)) ltac:(lra)); revert no; derivatives; roots; pose proof PI_RGT_0; nra. Qed.
Theorem met : instance.
Proof. cbv delta [instance]; exists (-1); lra. Qed.
End ex_4_2_c3_c.
