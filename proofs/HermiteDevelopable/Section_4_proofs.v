(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From HermiteDevelopable Require Section_4.
Import HermiteDevelopable.Section_4.Definitions.
From HermiteDevelopable Require Import Section_4_closed.
Open Scope R_scope.

Module sec_4_cone.
Import HermiteDevelopable.Section_4.sec_4_cone.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ quintic_criterion_ a d normal image r]; similar_quintic_numbers quintic_basis; images; ring. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; quintic_number_parts quintic_basis ltac:(cbv beta zeta delta [blend6 hermite5 q5 p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ quintic_criterion_ a d normal image r]); met_joins; first [lra | numeric]. Qed.
End sec_4_cone.

Module eq_4_1.
Import HermiteDevelopable.Section_4.eq_4_1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement oblique oblique_ normal]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance oblique oblique_ normal]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, (1 / 3), (12); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2), (0); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, (1 / 3), (11); met) | (exists 7, 9, 7, 7, 2, 11, 7, 2, 11, (1 / 3), (1); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, (1 / 3), (1); met)]. Qed.
End eq_4_1.

Module sec_4_goal_designed.
Import HermiteDevelopable.Section_4.sec_4_goal_designed.
Theorem refuted : ~ statement.
Proof. unfold not; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; assert (PP : forall u, p5 0 0 0 0 0 0 2 1 0 0 0 0 0 1 0 0 0 u = [poly [1 / 2] u; poly [0; 0; 8; - 16; 8] u; poly [0; 0; 7 / 2; - 17; 26; - 12] u]) by (intro u; cbv beta delta [p5 q5 hermite5 blend6 q0 qm q1 q0u qu q1u o]; staged; compute_goal; cbv beta iota delta [poly]; parts; field); assert (RR : forall u, r5 0 0 0 0 0 0 1 0 0 0 0 0 1 0 0 0 u = [poly [1; 0; - 8; 16; - 8] u; poly [0; 0; 8; - 16; 8] u; poly [0; 0; 7; - 34; 52; - 24] u]) by (intro u; cbv beta delta [r5 hermite5 blend6 r0 r r1 r0u ru r1u image normal q0 qm q1 q0u qu q1u o]; cbv beta delta [image normal]; cbv beta delta [q0 qm q1 q0u qu q1u o]; staged; compute_goal; cbv beta iota delta [poly]; parts; field); cbv beta zeta delta [statement]; intro no; generalize (no 0 0 0 0 0 0 2 (1 / 4) 1 0 0 0 0 0 1 0 0 0); clear no; repeat curve_at ltac:(fun u => first [apply PP | apply RR]); rewrite ?PP, ?RR; cbv beta iota zeta delta [slope_n slope slopes tl poly qm q1 q0 q0u qu q1u o normal]; fails. Qed.
End sec_4_goal_designed.

Module sec_4_goal_image.
Import HermiteDevelopable.Section_4.sec_4_goal_image.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement dp dr p image chord]; intros a'1 a'2 a'3 c'1 c'2 c'3 d'1 d'2 d'3 dc'1 dc'2 dc'3 k o'1 o'2 o'3 q0'1 q0'2 q0'3 W K L; clear L; assert (N : exists n1 n2 n3, normal [a'1; a'2; a'3] [d'1; d'2; d'3] = [n1; n2; n3]) by (do 3 eexists; reflexivity); destruct N as (n1 & n2 & n3 & N); rewrite N in *; clear N; assert (V : ((c'1 - o'1) * n1 + (c'2 - o'2) * n2 + (c'3 - o'3) * n3) <> 0) by (let E := fresh in intro E; apply W; compute_goal; lra); clear W; assert (D : forall o c d s, Derive_n (fun x => o + s / ((c'1 + x * dc'1 - o'1) * n1 + ((c'2 + x * dc'2 - o'2) * n2 + ((c'3 + x * dc'3 - o'3) * n3 + 0))) * (c + x * d - o)) 1 0 = s * (d / ((c'1 - o'1) * n1 + (c'2 - o'2) * n2 + (c'3 - o'3) * n3) - (dc'1 * n1 + dc'2 * n2 + dc'3 * n3) * (c - o) / ((c'1 - o'1) * n1 + (c'2 - o'2) * n2 + (c'3 - o'3) * n3) ^ 2)) by (intros; apply is_derive_unique; auto_derive; [let E := fresh in intro E; apply V; lra | field; repeat split; first [exact V | let E := fresh in intro E; apply V; lra]]); compute_goal; rewrite !D; clear D; conjuncts; parts; field; repeat split; try assumption; let E := fresh in intro E; apply V; lra. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal chord]; exists 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0; met. Qed.
End sec_4_goal_image.

Module sec_4_goal_leaves.
Import HermiteDevelopable.Section_4.sec_4_goal_leaves.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement]; intros; intro no; pose proof (no 0 0 0 0 0 0 (1 / 4) 0 0 0 0 1 0 1 0 0 0) as C; clear no; with_quintics quintic_basis ltac:(fun curve => granted C ltac:(cbv beta zeta delta [q0 qm q1 q0u qu q1u o normal]) curve; revert C; vectors ltac:(cbv beta delta [q0 qm q1 q0u qu q1u o normal image r r0 r1 r0u ru r1u r5 q5 hermite5 blend6]) curve); compute_goal; intro C; contradiction_in C. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; lra. Qed.
End sec_4_goal_leaves.

Module sec_4_goal_nodes.
Import HermiteDevelopable.Section_4.sec_4_goal_nodes.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement r0u r0 image r ru r1 r1u]; intros; repeat match goal with |- context [dot ?a ?b / dot ?c ?d] => generalize (dot a b / dot c d) end; compute_goal; intros; conjuncts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal r0u r0 image r ru r1 r1u]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13; met) | (exists 7, 9, 7, 7, 2, 11, 9, 7, 7, 7, 2, 11, 7, 2, 11, 7, 2, 11, 7, 2, 11, 13, 8, 8, 7, 2, 11; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1; met)]. Qed.
End sec_4_goal_nodes.

Module sec_4_goal_only.
Import HermiteDevelopable.Section_4.sec_4_goal_only.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal image]; unstaged; prepared; known (w) (a'1*d'2*o'3 - a'1*d'2*q0'3 - a'1*d'3*o'2 + a'1*d'3*q0'2 - a'2*d'1*o'3 + a'2*d'1*q0'3 + a'2*d'3*o'1 - a'2*d'3*q0'1 + a'3*d'1*o'2 - a'3*d'1*q0'2 - a'3*d'2*o'1 + a'3*d'2*q0'1) (a'1*c'2*d'3 - a'1*c'3*d'2 + a'1*d'2*o'3 - a'1*d'3*o'2 - a'2*c'1*d'3 + a'2*c'3*d'1 - a'2*d'1*o'3 + a'2*d'3*o'1 + a'3*c'1*d'2 - a'3*c'2*d'1 + a'3*d'1*o'2 - a'3*d'2*o'1); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal image]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, (((2)*(9)*(13) - (2)*(9)*(16) - (2)*(10)*(12) + (2)*(10)*(15) - (3)*(8)*(13) + (3)*(8)*(16) + (3)*(10)*(11) - (3)*(10)*(14) + (4)*(8)*(12) - (4)*(8)*(15) - (4)*(9)*(11) + (4)*(9)*(14)) / ((2)*(6)*(10) - (2)*(7)*(9) + (2)*(9)*(13) - (2)*(10)*(12) - (3)*(5)*(10) + (3)*(7)*(8) - (3)*(8)*(13) + (3)*(10)*(11) + (4)*(5)*(9) - (4)*(6)*(8) + (4)*(8)*(12) - (4)*(9)*(11))); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (((0)*(0)*(0) - (0)*(0)*(0) - (0)*(0)*(0) + (0)*(0)*(0) - (0)*(0)*(0) + (0)*(0)*(0) + (0)*(0)*(0) - (0)*(0)*(0) + (0)*(0)*(0) - (0)*(0)*(0) - (0)*(0)*(0) + (0)*(0)*(0)) / ((0)*(0)*(0) - (0)*(0)*(0) + (0)*(0)*(0) - (0)*(0)*(0) - (0)*(0)*(0) + (0)*(0)*(0) - (0)*(0)*(0) + (0)*(0)*(0) + (0)*(0)*(0) - (0)*(0)*(0) + (0)*(0)*(0) - (0)*(0)*(0))); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, (((13)*(7)*(1) - (13)*(7)*(8) - (13)*(7)*(11) + (13)*(7)*(13) - (8)*(9)*(1) + (8)*(9)*(8) + (8)*(7)*(2) - (8)*(7)*(4) + (8)*(9)*(11) - (8)*(9)*(13) - (8)*(7)*(2) + (8)*(7)*(4)) / ((13)*(8)*(7) - (13)*(7)*(7) + (13)*(7)*(1) - (13)*(7)*(11) - (8)*(6)*(7) + (8)*(7)*(9) - (8)*(9)*(1) + (8)*(7)*(2) + (8)*(6)*(7) - (8)*(8)*(9) + (8)*(9)*(11) - (8)*(7)*(2))); met) | (exists 7, 9, 7, 7, 7, 2, 7, 2, 11, 9, 7, 7, 7, 2, 11, (((7)*(2)*(7) - (7)*(2)*(11) - (7)*(11)*(7) + (7)*(11)*(2) - (9)*(7)*(7) + (9)*(7)*(11) + (9)*(11)*(9) - (9)*(11)*(7) + (7)*(7)*(7) - (7)*(7)*(2) - (7)*(2)*(9) + (7)*(2)*(7)) / ((7)*(7)*(11) - (7)*(2)*(2) + (7)*(2)*(7) - (7)*(11)*(7) - (9)*(7)*(11) + (9)*(2)*(7) - (9)*(7)*(7) + (9)*(11)*(9) + (7)*(7)*(2) - (7)*(7)*(7) + (7)*(7)*(7) - (7)*(2)*(9))); met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, (((1)*(0)*(0) - (1)*(0)*(0) - (1)*(1)*(0) + (1)*(1)*(1) - (0)*(0)*(0) + (0)*(0)*(0) + (0)*(1)*(1) - (0)*(1)*(0) + (0)*(0)*(0) - (0)*(0)*(1) - (0)*(0)*(1) + (0)*(0)*(0)) / ((1)*(1)*(1) - (1)*(0)*(0) + (1)*(0)*(0) - (1)*(1)*(0) - (0)*(0)*(1) + (0)*(0)*(0) - (0)*(0)*(0) + (0)*(1)*(1) + (0)*(0)*(0) - (0)*(1)*(0) + (0)*(0)*(0) - (0)*(0)*(1))); met)]. Qed.
End sec_4_goal_only.

Module sec_4_goal_parallel.
Import HermiteDevelopable.Section_4.sec_4_goal_parallel.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement]; intros; with_quintics quintic_basis ltac:(fun curve => match goal with |- context [p5 ?a ?b ?c ?d ?e ?f ?g ?h ?i ?j ?k ?l ?u] => eassert (P : p5 a b c d e f g h i j k l u = _) by (cbv beta delta [p5 hermite5 blend6]; curve u); rewrite P; clear P end; match goal with |- ?r = ?s /\ _ => assert (E : r = s) by (cbv beta delta [r_ shadow turned normal cross]; cbv beta iota zeta delta [vsub vscale map zip dot fold_right entry nth Nat.pred]; cbv beta delta [hermite5 blend6]; curves curve; generalize (a'2 * d'3 - a'3 * d'2), (a'3 * d'1 - a'1 * d'3), (a'1 * d'2 - a'2 * d'1); intros; rewrite !quintic_along; match goal with |- _ - ?t * _ :: _ = _ - ?v * _ :: _ => replace t with v by (cbv beta iota zeta delta [poly quintic_of Rdiv]; match goal with |- context [/ ?n] => generalize (/ n) end; intros; ring) end; reflexivity) end); rewrite E; clear E; match goal with N : dot _ _ <> 0 |- _ => revert N end; cbv beta delta [shadow turned normal]; any_points; match goal with N : dot _ _ <> 0 |- _ => revert N end; compute_goal; generalize (a'2 * d'3 - a'3 * d'2), (a'3 * d'1 - a'1 * d'3), (a'1 * d'2 - a'2 * d'1); intros; conjuncts; parts; (first [reflexivity | field; nonzero]). Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal]; stage quintic; stage quintic_; stage quintic_data; exists 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met_joins; first [lra | compute_goal; lra]. Qed.
End sec_4_goal_parallel.

Module sec_4_in_plane.
Import HermiteDevelopable.Section_4.sec_4_in_plane.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement r0 a d normal image r r1 r0u r1u ru]; intros; repeat match goal with H : det _ <> 0 |- _ => clear H end; match goal with E : quintic_basis = _ |- _ => rewrite E; clear E end; unstaged; conjuncts; lazymatch goal with |- dot _ _ = 0 => back; identity | |- _ => cbv beta iota delta [entry nth Nat.pred]; ring end. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage normal; stage quintic; stage quintic_; stage quintic_data; stage r0; stage image; stage r; stage r1; stage r0u; stage ru; stage r1u; staged_goal quintic_basis; unstaged; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8, 8, 6, 8, 7, 9, (1 / 3); met) | (exists 1, 1, 1, 1, 1, 1, 7, 9, 7, 7, 2, 11, 9, 7, 7, 7, 2, 11, 7, 2, 11, 7, 2, 11, 7, 2, 11, 13, 8, 8, 7, 2, 11, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, (1 / 3); met)]. Qed.
End sec_4_in_plane.

Module sec_4_r0.
Import HermiteDevelopable.Section_4.sec_4_r0.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal image r0]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal image r0]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1; met) | (exists 7, 9, 7, 7, 2, 11, 9, 7, 7, 7, 2, 11; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0; met)]. Qed.
End sec_4_r0.

Module sec_4_I1.
Import HermiteDevelopable.Section_4.sec_4_I1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal]; compute_goal; intros; match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1; pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1); pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2); pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; split; [apply value_of; [ assumption | lra ] | lra ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal ]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ]. Qed.
End sec_4_I1.

Module sec_4_w.
Import HermiteDevelopable.Section_4.sec_4_w.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal]; compute_goal; intros; match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1; pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1); pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2); pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; apply value_of; [ assumption | lra ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal ]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ]. Qed.
End sec_4_w.

Module eq_4_2.
Import HermiteDevelopable.Section_4.eq_4_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal]; compute_goal; intros; match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1; pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1); pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2); pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; match goal with |- context [?n / ?d] => assert (W : w = n / d) by (apply value_of; [ assumption | lra ]); rewrite <- W; clear W end; parts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal ]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ]. Qed.
End eq_4_2.

Module eq_4_2_tangent_derivative.
Import HermiteDevelopable.Section_4.eq_4_2_tangent_derivative.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement normal chord image r0u] in no; refuting (no (0) (0) (1) (1) (0) (0) (0) (0) (0) (0) (1) (0) (1) (1) (0)). Qed.
End eq_4_2_tangent_derivative.

Module eq_4_2_tangent_end_point.
Import HermiteDevelopable.Section_4.eq_4_2_tangent_end_point.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal image r0 r0u]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal image r0 r0u]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8; met) | (exists 7, 9, 7, 7, 2, 11, 9, 7, 7, 7, 2, 11, 7, 2, 11; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0; met)]. Qed.
End eq_4_2_tangent_end_point.

Module eq_4_2_tangent_parallel.
Import HermiteDevelopable.Section_4.eq_4_2_tangent_parallel.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal chord r0u image]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal chord r0u image]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, 4, 13, 8; met) | (exists 7, 9, 7, 7, 2, 11, 9, 7, 7, 7, 2, 11, 7, 2, 11; met) | (exists 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0; met)]. Qed.
End eq_4_2_tangent_parallel.

Module eq_4_2_tangent_true.
Import HermiteDevelopable.Section_4.eq_4_2_tangent_true.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal chord first image]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal chord first image]; exists 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0; met. Qed.
End eq_4_2_tangent_true.

Module sec_4_s.
Import HermiteDevelopable.Section_4.sec_4_s.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal]; compute_goal; intros; match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1; pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1); pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2); pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; apply value_of; [ assumption | lra ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal ]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ]. Qed.
End sec_4_s.

Module eq_4_3.
Import HermiteDevelopable.Section_4.eq_4_3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal]; compute_goal; intros; match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1; pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1); pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2); pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; match goal with |- context [?n / ?d] => assert (W : s = n / d) by (apply value_of; [ assumption | lra ]); rewrite <- W; clear W end; parts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal ]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ]. Qed.
End eq_4_3.

Module eq_4_4_ru.
Import HermiteDevelopable.Section_4.eq_4_4_ru.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal r image]; compute_goal; intros; match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1; pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1); pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2); pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; match goal with |- _ = (?m / ?d * _ - _) :: _ => assert (W : t = m / d) by (apply value_of; [ assumption | lra ]); rewrite <- W; clear W end; parts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal r]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ]. Qed.
End eq_4_4_ru.

Module eq_4_4_r1.
Import HermiteDevelopable.Section_4.eq_4_4_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal]; compute_goal; intros; match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1; pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1); pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2); pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; match goal with |- context [?zz / ?d] => assert (W : n = zz / d) by (apply value_of; [ assumption | lra ]); rewrite <- W; clear W end; parts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal ]; exists 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ]. Qed.
End eq_4_4_r1.

Module eq_4_4_r1u.
Import HermiteDevelopable.Section_4.eq_4_4_r1u.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal r1 image]; compute_goal; intros; match goal with E : _ :: _ = _ :: _ |- _ => injection E; clear E; intros F3 F2 F1; pose proof (f_equal (Rmult (a'2 * d'3 - a'3 * d'2)) F1); pose proof (f_equal (Rmult (a'3 * d'1 - a'1 * d'3)) F2); pose proof (f_equal (Rmult (a'1 * d'2 - a'2 * d'1)) F3); clear F1 F2 F3 end; match goal with |- _ = (?z / ?d * _ - _) :: _ => assert (W : m = z / d) by (apply value_of; [ assumption | lra ]); rewrite <- W; clear W end; parts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal r1]; exists 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0; compute_goal; repeat match goal with |- _ /\ _ => split end; first [ numeric | parts; ring ]. Qed.
End eq_4_4_r1u.

Module eq_4_4_tangent_derivative.
Import HermiteDevelopable.Section_4.eq_4_4_tangent_derivative.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement normal chord last image r ru r1 r1u] in no; refuting (no (0) (0) (1) (1) (0) (0) (0) (0) (0) (0) (1) (0) (0) (1) (1) (1) (0) (1) (0) (2) (0) (1) (1) (0)). Qed.
End eq_4_4_tangent_derivative.

Module eq_4_4_tangent_end_point.
Import HermiteDevelopable.Section_4.eq_4_4_tangent_end_point.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement image ru r1u r r1]; intros a'1 a'2 a'3 d'1 d'2 d'3 o'1 o'2 o'3 q0'1 q0'2 q0'3 q1'1 q1'2 q1'3 q1u'1 q1u'2 q1u'3 qm'1 qm'2 qm'3 qu'1 qu'2 qu'3 _ _ _ _ _ _; assert (M : forall x y z x' y' z', vsub (vadd [x; y; z] [x'; y'; z']) [o'1; o'2; o'3] = vadd (vsub [x; y; z] [o'1; o'2; o'3]) [x'; y'; z']) by (intros; compute_goal; parts; ring); rewrite !M; clear M; repeat match goal with |- context [dot ?a ?b / dot ?c ?d] => generalize (dot a b / dot c d) end; intros; compute_goal; conjuncts; parts; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0; met. Qed.
End eq_4_4_tangent_end_point.

Module eq_4_4_tangent_parallel.
Import HermiteDevelopable.Section_4.eq_4_4_tangent_parallel.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal chord last image r ru r1 r1u]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance normal chord last image r ru r1 r1u]; exists 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0; met. Qed.
End eq_4_4_tangent_parallel.

Module sec_4_oblique.
Import HermiteDevelopable.Section_4.sec_4_oblique.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement normal normal2 a d not]; compute_goal; split; intro E; injection E; intros; lra. Qed.
End sec_4_oblique.

Module ex_4_data.
Import HermiteDevelopable.Section_4.ex_4_data.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 q1 q0u q1u p0 pm pu q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ q5_ blend6 hermite5 a hermite5_]; whole_points quintic_basis_ quintic_basis; intros; with_quintics quintic_basis joins; data_of_joins; worth o'1 (100); worth o'2 (20); worth o'3 (45); worth qm'1 (-20); worth qm'2 (5); worth qm'3 (35); worth qu'1 (0); worth qu'2 (-50); worth qu'3 (70); quintic_curves quintic_basis; parts; lra. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 100, 20, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), (-20), 5, 35, 0, (-50), 70; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 q1 q0u q1u p0 pm pu q5 k p5 quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ q5_ blend6 hermite5 a quintic_basis_ hermite5_]); met_joins. Qed.
End ex_4_data.

Module ex_4_r0.
Import HermiteDevelopable.Section_4.ex_4_r0.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q0 o a d normal image]; identity. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q0 o a d normal image]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_r0.

Module ex_4_r0u.
Import HermiteDevelopable.Section_4.ex_4_r0u.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement q0 o q0u a d normal r0u] in no; refuting (no ). Qed.
End ex_4_r0u.

Module ex_4_r.
Import HermiteDevelopable.Section_4.ex_4_r.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement qm o a d normal q0 image r]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance qm o a d normal q0 image r]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_r.

Module ex_4_ru.
Import HermiteDevelopable.Section_4.ex_4_ru.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement qm o qu a d normal q0 image r ru] in no; refuting (no ). Qed.
End ex_4_ru.

Module ex_4_r1.
Import HermiteDevelopable.Section_4.ex_4_r1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q1 o a d normal q0 image r1]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q1 o a d normal q0 image r1]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_r1.

Module ex_4_r1_rounding.
Import HermiteDevelopable.Section_4.ex_4_r1_rounding.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q1 o a d normal q0 image r1]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q1 o a d normal q0 image r1]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_r1_rounding.

Module ex_4_r1u.
Import HermiteDevelopable.Section_4.ex_4_r1u.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement q1 o q1u a d normal q0 image r1 r1u] in no; refuting (no ). Qed.
End ex_4_r1u.

Module ex_4_other_data.
Import HermiteDevelopable.Section_4.ex_4_other_data.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q0 o q0u a d normal qm qu q1 q1u r0u image r ru r1 r1u]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q0 o q0u a d normal qm qu q1 q1u r0u image r ru r1 r1u]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_other_data.

Module ex_4_other_data_twist.
Import HermiteDevelopable.Section_4.ex_4_other_data_twist.
Theorem proved : statement.
Proof. let one D := (let E := fresh in eassert (E : D = _) by (cbv delta [D r_ r1 image normal q0 qm q1 q0u qu q1u o a_ d_]; on_left; entries)) in stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ blend6 hermite5 p5]; intros; one r_; one r1; one r0u; one ru; one r1u; with_quintics quintic_basis joins; data_of_joins; cbv beta delta [turn size near far]; with_quintics quintic_basis ltac:(fun curve => match goal with E : quintic_basis = _ |- _ => clear E end; conjuncts; vectors ltac:(cbv beta delta [p5 r5 hermite5 blend6 r0 q0]; whole_points quintic_basis_ quintic_basis; staged) curve); closed_numbers. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 40, 40, 45, 0, (-25), 30, 40, (-15), 45, 0, (-25), (-30), 40, (25/2), 40, 0, (-30), 40; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ normal blend6 hermite5 p5 a_ d_]); met_joins; compute_goal; numeric. Qed.
End ex_4_other_data_twist.

Module ex_4_stated_data.
Import HermiteDevelopable.Section_4.ex_4_stated_data.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q0 o q0u a d normal qm qu q1 q1u r0u image r ru r1 r1u]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q0 o q0u a d normal qm qu q1 q1u r0u image r ru r1 r1u]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_stated_data.

Module ex_4_true_tangents.
Import HermiteDevelopable.Section_4.ex_4_true_tangents.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement q0 q0u first o a d normal qm qu middle q1 q1u last image]; ordered. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance q0 q0u first o a d normal qm qu middle q1 q1u last image]; first [(met) | (met) | (met) | (met) | (met)]. Qed.
End ex_4_true_tangents.

Module ex_4_a_developable_computed.
Import HermiteDevelopable.Section_4.ex_4_a_developable_computed.
Theorem refuted : ~ statement.
Proof. unfold not; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ blend6 hermite5 p5 r0 a_ normal image r_ r1 r0u ru r1u r5 d_]; intro no; generalize (no 0 0 0 0 0 0 40 40 45 0 (-30) 45 40 (-15) 45 0 (-25) (-15) 40 (25/2) 40 0 (-25) 35 (1/4)); clear no; with_quintics quintic_basis joins; with_quintics quintic_basis curves_at; fails. Qed.
End ex_4_a_developable_computed.

Module ex_4_a_developable_printed.
Import HermiteDevelopable.Section_4.ex_4_a_developable_printed.
Theorem refuted : ~ statement.
Proof. unfold not; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ blend6 hermite5 p5 rp]; intro no; generalize (no 0 0 0 0 0 0 40 40 45 0 (-30) 45 40 (-15) 45 0 (-25) (-15) 40 (25/2) 40 0 (-25) 35 (1/4)); clear no; with_quintics quintic_basis joins; with_quintics quintic_basis curves_at; fails. Qed.
End ex_4_a_developable_printed.

Module ex_4_a_twist.
Import HermiteDevelopable.Section_4.ex_4_a_twist.
Theorem proved : statement.
Proof. let one D := (let E := fresh in eassert (E : D = _) by (cbv delta [D r_ r1 image normal q0 qm q1 q0u qu q1u o a_ d_]; on_left; entries)) in stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ blend6 hermite5 p5]; intros; one r_; one r1; one r0u; one ru; one r1u; with_quintics quintic_basis joins; data_of_joins; cbv beta delta [turn turn_ size near near_ far far_]; with_quintics quintic_basis ltac:(fun curve => match goal with E : quintic_basis = _ |- _ => clear E end; conjuncts; vectors ltac:(cbv beta delta [p5 p5_ r5 r5_ hermite5 hermite5_ blend6 r0 q0]; whole_points quintic_basis_ quintic_basis; staged) curve); closed_numbers. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 40, 40, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), 40, (25/2), 40, 0, (-25), 35; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ normal blend6 hermite5 p5 a_ d_]); met_joins; compute_goal; numeric. Qed.
End ex_4_a_twist.

Module ex_4_a_twist_most.
Import HermiteDevelopable.Section_4.ex_4_a_twist_most.
Theorem proved : statement.
Proof. let one D := (let E := fresh in eassert (E : D = _) by (cbv delta [D r_ r1 image normal q0 qm q1 q0u qu q1u o a_ d_]; on_left; entries)) in stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ blend6 hermite5 p5]; intros; one r_; one r1; one r0u; one ru; one r1u; with_quintics quintic_basis joins; data_of_joins; cbv beta delta [turn size near far]; with_quintics quintic_basis ltac:(fun curve => match goal with E : quintic_basis = _ |- _ => clear E end; assert (PP : forall u, vDerive 3 (fun u_ => p5 A B C_ E_ F G [p0'1; p0'2; p0'3] [p0u'1; p0u'2; p0u'3] [p1'1; p1'2; p1'3] [p1u'1; p1u'2; p1u'3] [pm'1; pm'2; pm'3] [pu'1; pu'2; pu'3] u_) 1 u = vscale 5 (at_number [[0; 0; 0; 0; 0]; [(-6); (-168); 861; (-1392); 700]; [9; (-246); 1074; (-1520); 680]]%Z u)) by (intro; cbv beta delta [p5 r5 hermite5 blend6 r0 q0]; staged; curves curve; preimages; cbv beta iota zeta delta [slope slopes tl poly quintic_of entry nth Nat.pred at_number whole_poly map vscale vsub zip]; parts; field); assert (RR : forall u, vDerive 3 (fun u_ => r5 A B C_ E_ F G u_) 1 u = vscale (10 / 17730167) (at_number [[(-16366308); (-445659120); 2306056896; (-3782863488); 1920830400]; [(-109108720); (-2971060800); 15373712640; (-25219089920); 12805536000]; [171846234; (-4786671174); 21030632415; (-29848375488); 13366862100]]%Z u)) by (intro; cbv beta delta [p5 r5 hermite5 blend6 r0 q0]; staged; curves curve; preimages; cbv beta iota zeta delta [slope slopes tl poly quintic_of entry nth Nat.pred at_number whole_poly map vscale vsub zip]; parts; field); assert (WW : forall u, vsub (r5 A B C_ E_ F G u) (p5 A B C_ E_ F G [p0'1; p0'2; p0'3] [p0u'1; p0u'2; p0u'3] [p1'1; p1'2; p1'3] [p1u'1; p1u'2; p1u'3] [pm'1; pm'2; pm'3] [pu'1; pu'2; pu'3] u) = vscale (5 / 17730167) (at_number [[(-212762004); (-32732616); (-445659120); 1537371264; (-1891431744); 768332160]; [70920668; (-111836438); (-1481726772); 5160583831; (-6439446844); 2639991020]; [0; 184120965; (-2605860633); 7673021824; (-8186724284); 2935442128]]%Z u)) by (intro; cbv beta delta [p5 r5 hermite5 blend6 r0 q0]; staged; curves curve; preimages; cbv beta iota zeta delta [slope slopes tl poly quintic_of entry nth Nat.pred at_number whole_poly map vscale vsub zip]; parts; field)); rewrite !PP, !RR, !WW; (assert (LEM : forall al be ga p1 p2 p3 w1 w2 w3 r1 r2 r3 y z v e c : R, al <> 0 -> be <> 0 -> ga <> 0 -> let p := [p1; p2; p3] in let w := [w1; w2; w3] in let r := [r1; r2; r3] in dot (cross p w) r = y -> dot (cross p w) (cross r w) = z -> dot w w < v * v -> 0 < e * z - y * v -> 0 < e * z + y * v -> c * c < 1 -> e * e * (1 - c * c) <= c * c -> dot (cross (cross (vscale al p) (vscale be w)) (cross (vscale ga r) (vscale be w))) (cross (cross (vscale al p) (vscale be w)) (cross (vscale ga r) (vscale be w))) < c ^ 2 * (dot (cross (vscale al p) (vscale be w)) (cross (vscale al p) (vscale be w)) * dot (cross (vscale ga r) (vscale be w)) (cross (vscale ga r) (vscale be w)))) by (clear; intros al be ga p1 p2 p3 w1 w2 w3 r1 r2 r3 y z v e c A B C p w r Y Z W V1 V2 I J; destruct (angle_scaled al be ga p1 p2 p3 w1 w2 w3 r1 r2 r3) as [E F]; cbv zeta in E, F; subst p w r; rewrite E, F; clear E F; assert (K : 0 < (al * be * ga * be) ^ 2) by (rewrite <- Rsqr_pow2; apply Rsqr_pos_lt; repeat apply Rmult_integral_contrapositive_currified; assumption); assert (L : forall x1 x2 x3 y1 y2 y3, dot (cross [x1; x2; x3] [y1; y2; y3]) (cross [x1; x2; x3] [y1; y2; y3]) = dot [x1; x2; x3] [x1; x2; x3] * dot [y1; y2; y3] [y1; y2; y3] - dot [x1; x2; x3] [y1; y2; y3] * dot [x1; x2; x3] [y1; y2; y3]) by (intros; cbv [dot cross entry zip fold_right nth Nat.pred]; ring); pose proof (cross_of_crosses p1 p2 p3 w1 w2 w3 r1 r2 r3) as M; cbv zeta in M; pose proof M as N; change (cross [p1; p2; p3] [w1; w2; w3]) with [p2 * w3 - p3 * w2; p3 * w1 - p1 * w3; p1 * w2 - p2 * w1] in N at 1 3; change (cross [r1; r2; r3] [w1; w2; w3]) with [r2 * w3 - r3 * w2; r3 * w1 - r1 * w3; r1 * w2 - r2 * w1] in N; rewrite L in N; change [p2 * w3 - p3 * w2; p3 * w1 - p1 * w3; p1 * w2 - p2 * w1] with (cross [p1; p2; p3] [w1; w2; w3]) in N; change [r2 * w3 - r3 * w2; r3 * w1 - r1 * w3; r1 * w2 - r2 * w1] with (cross [r1; r2; r3] [w1; w2; w3]) in N; rewrite Z, Y in N; rewrite M, Y; assert (P : 0 <= dot [w1; w2; w3] [w1; w2; w3]) by (cbv [dot zip fold_right]; pose proof (Rle_0_sqr w1); pose proof (Rle_0_sqr w2); pose proof (Rle_0_sqr w3); unfold Rsqr in *; lra); clear M L A B C; revert N W P; generalize (dot [w1; w2; w3] [w1; w2; w3]); generalize (dot (cross [p1; p2; p3] [w1; w2; w3]) (cross [p1; p2; p3] [w1; w2; w3]) * dot (cross [r1; r2; r3] [w1; w2; w3]) (cross [r1; r2; r3] [w1; w2; w3])); revert K; generalize ((al * be * ga * be) ^ 2); clear - V1 V2 I J; intros k K t w N W P; replace (c ^ 2 * (k * t)) with (k * (c ^ 2 * t)) by ring; apply Rmult_lt_compat_l; [exact K|]; replace t with (z * z + y * y * w) by lra; pose proof (Rmult_lt_0_compat _ _ V1 V2) as V; assert (G : y * y * w <= y * y * (v * v)) by (apply Rmult_le_compat_l; [exact (Rle_0_sqr y) | lra]); replace ((e * z - y * v) * (e * z + y * v)) with (e * e * (z * z) - y * y * (v * v)) in V by ring; assert (G1 : 0 < (1 - c * c) * (e * e * (z * z) - y * y * w)) by (apply Rmult_lt_0_compat; lra); assert (G2 : 0 <= (c * c - e * e * (1 - c * c)) * (z * z)) by (apply Rmult_le_pos; [lra | exact (Rle_0_sqr z)]); clear - G1 G2; lra); lazymatch goal with |- dot (cross (cross (vscale ?al (at_number ?p ?u)) (vscale ?be (at_number ?w ?u))) (cross (vscale ?ga (at_number ?r ?u)) _)) _ < _ => assert (U : 0 <= u <= 1) by lra; clear - U LEM; cbv beta; assert (ED : dot_poly (cross_poly p w) r = times_number 425524008 [0; (-128199042); 19301622417; (-138501502482); 227802137613; 746342905608; (-4041104027306); 8947880584296; (-12865041458800); 13195319915840; (-9160976708640); 3712605575296; (-643500844800); 0]%Z) by exact_no_check (@eq_refl (list Z) (times_number 425524008 [0; (-128199042); 19301622417; (-138501502482); 227802137613; 746342905608; (-4041104027306); 8947880584296; (-12865041458800); 13195319915840; (-9160976708640); 3712605575296; (-643500844800); 0]%Z)); assert (EQ : dot_poly (cross_poly p w) (cross_poly r w) = times_number 17730167 [6142474653116413248; (-143822632747739938272); 5258452908812429853072; (-44187706537521358933080); 183727524408385479748392; (-551527859818614245985720); 1599559893565992359467660; (-4400422036484174960702698); 10004734101898411980688032; (-18790061886422939349943851); 31703349484718535088065502; (-49536315726344384123644272); 66944115368653331011626192; (-71713233154205728617047456); 57381747924382613809190400; (-32792315101815651761353984); 12640035189084323977429760; (-2949140604289295354438400); 314817326355802086720000]%Z) by exact_no_check (@eq_refl (list Z) (times_number 17730167 [6142474653116413248; (-143822632747739938272); 5258452908812429853072; (-44187706537521358933080); 183727524408385479748392; (-551527859818614245985720); 1599559893565992359467660; (-4400422036484174960702698); 10004734101898411980688032; (-18790061886422939349943851); 31703349484718535088065502; (-49536315726344384123644272); 66944115368653331011626192; (-71713233154205728617047456); 57381747924382613809190400; (-32792315101815651761353984); 12640035189084323977429760; (-2949140604289295354438400); 314817326355802086720000]%Z)); assert (C1 : 0 < whole_poly (plus_poly (times_number 11 [6142474653116413248; (-143822632747739938272); 5258452908812429853072; (-44187706537521358933080); 183727524408385479748392; (-551527859818614245985720); 1599559893565992359467660; (-4400422036484174960702698); 10004734101898411980688032; (-18790061886422939349943851); 31703349484718535088065502; (-49536315726344384123644272); 66944115368653331011626192; (-71713233154205728617047456); 57381747924382613809190400; (-32792315101815651761353984); 12640035189084323977429760; (-2949140604289295354438400); 314817326355802086720000]%Z) (times_number (-432000000) (times_poly [0; (-128199042); 19301622417; (-138501502482); 227802137613; 746342905608; (-4041104027306); 8947880584296; (-12865041458800); 13195319915840; (-9160976708640); 3712605575296; (-643500844800); 0]%Z [2535; (-960); 1700]%Z))) u) by (apply (positive_poly 1); [ exact_no_check (@eq_refl bool true) | exact U ]); assert (C2 : 0 < whole_poly (plus_poly (times_number 11 [6142474653116413248; (-143822632747739938272); 5258452908812429853072; (-44187706537521358933080); 183727524408385479748392; (-551527859818614245985720); 1599559893565992359467660; (-4400422036484174960702698); 10004734101898411980688032; (-18790061886422939349943851); 31703349484718535088065502; (-49536315726344384123644272); 66944115368653331011626192; (-71713233154205728617047456); 57381747924382613809190400; (-32792315101815651761353984); 12640035189084323977429760; (-2949140604289295354438400); 314817326355802086720000]%Z) (times_number 432000000 (times_poly [0; (-128199042); 19301622417; (-138501502482); 227802137613; 746342905608; (-4041104027306); 8947880584296; (-12865041458800); 13195319915840; (-9160976708640); 3712605575296; (-643500844800); 0]%Z [2535; (-960); 1700]%Z))) u) by (apply (positive_poly 3); [ exact_no_check (@eq_refl bool true) | exact U ]); assert (C3 : 0 < whole_poly (minus_poly (times_number 10000000000 (times_poly [2535; (-960); 1700]%Z [2535; (-960); 1700]%Z)) (dot_poly w w)) u) by (apply (positive_poly 3); [ exact_no_check (@eq_refl bool true) | exact U ]); apply (f_equal (fun c => whole_poly c u)) in ED; apply (f_equal (fun c => whole_poly c u)) in EQ; cbv beta in ED, EQ; rewrite whole_number, dot_at, cross_at in ED by reflexivity; rewrite whole_number, dot_at, !cross_at in EQ by reflexivity; rewrite whole_plus, !whole_number, !whole_times in C1, C2; rewrite whole_minus, !whole_number, whole_times, dot_at in C3 by reflexivity; cbv beta iota delta [at_number map] in C3 |- *; refine (LEM _ _ _ _ _ _ _ _ _ _ _ _ _ _ (100000 * whole_poly [2535; (-960); 1700]%Z u) (11 / 180) _ _ _ _ _ _ _ _ _ _ _); [lra | lra | lra | exact ED | exact EQ | revert C3; generalize (whole_poly [2535; (-960); 1700]%Z u); match goal with |- context [dot ?a ?b] => generalize (dot a b) end; clear; intros; lra | revert C1; generalize (whole_poly [2535; (-960); 1700]%Z u) (whole_poly [0; (-128199042); 19301622417; (-138501502482); 227802137613; 746342905608; (-4041104027306); 8947880584296; (-12865041458800); 13195319915840; (-9160976708640); 3712605575296; (-643500844800); 0]%Z u) (whole_poly [6142474653116413248; (-143822632747739938272); 5258452908812429853072; (-44187706537521358933080); 183727524408385479748392; (-551527859818614245985720); 1599559893565992359467660; (-4400422036484174960702698); 10004734101898411980688032; (-18790061886422939349943851); 31703349484718535088065502; (-49536315726344384123644272); 66944115368653331011626192; (-71713233154205728617047456); 57381747924382613809190400; (-32792315101815651761353984); 12640035189084323977429760; (-2949140604289295354438400); 314817326355802086720000]%Z u); clear; intros; lra | revert C2; generalize (whole_poly [2535; (-960); 1700]%Z u) (whole_poly [0; (-128199042); 19301622417; (-138501502482); 227802137613; 746342905608; (-4041104027306); 8947880584296; (-12865041458800); 13195319915840; (-9160976708640); 3712605575296; (-643500844800); 0]%Z u) (whole_poly [6142474653116413248; (-143822632747739938272); 5258452908812429853072; (-44187706537521358933080); 183727524408385479748392; (-551527859818614245985720); 1599559893565992359467660; (-4400422036484174960702698); 10004734101898411980688032; (-18790061886422939349943851); 31703349484718535088065502; (-49536315726344384123644272); 66944115368653331011626192; (-71713233154205728617047456); 57381747924382613809190400; (-32792315101815651761353984); 12640035189084323977429760; (-2949140604289295354438400); 314817326355802086720000]%Z u); clear; intros; lra | lra | lra ] end). Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 40, 40, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), 40, (25/2), 40, 0, (-25), 35, 0; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ normal blend6 hermite5 p5 a_ d_]); met_joins; compute_goal; numeric. Qed.
End ex_4_a_twist_most.

Module ex_4_a_twist_printed.
Import HermiteDevelopable.Section_4.ex_4_a_twist_printed.
Theorem proved : statement.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ blend6 hermite5 p5]; intros; with_quintics quintic_basis joins; data_of_joins; cbv beta delta [turn turn_ size near near_ far far_]; with_quintics quintic_basis ltac:(fun curve => match goal with E : quintic_basis = _ |- _ => clear E end; conjuncts; vectors ltac:(cbv beta delta [p5 p5_ r5 r5_ rp rp_ hermite5 hermite5_ blend6]; whole_points quintic_basis_ quintic_basis; staged) curve); closed_numbers. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 40, 40, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), 40, (25/2), 40, 0, (-25), 35; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ blend6 hermite5 p5]); met_joins. Qed.
End ex_4_a_twist_printed.

Module ex_4_b_developable.
Import HermiteDevelopable.Section_4.ex_4_b_developable.
Theorem refuted : ~ statement.
Proof. unfold not; stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement]; intro no; pose proof (no 0 0 0 0 0 0 40 40 45 0 (-30) 45 40 (-15) 45 0 (-25) (-15) 40 (25/2) 40 0 (-25) 35 (1/4)) as C; cbv zeta in C; clear no; with_quintics quintic_basis ltac:(fun curve => granted C ltac:(cbv beta zeta delta [q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ normal blend6 hermite5 p5 a_ d_]) curve; revert C; vectors ltac:(cbv beta delta [q0 qm q1 q0u qu q1u o r0 a_ d_ normal image r_ r1 r0u ru r1u r5 p5 blend6 hermite5]) curve); compute_goal; intro C; contradiction_in C. Qed.
End ex_4_b_developable.

Module ex_4_b_twist.
Import HermiteDevelopable.Section_4.ex_4_b_twist.
Theorem proved : statement.
Proof. let one D := (let E := fresh in eassert (E : D = _) by (cbv delta [D r_ r1 image normal q0 qm q1 q0u qu q1u o a_ d_]; on_left; entries)) in stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [statement q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ blend6 hermite5 p5]; intros; one r_; one r1; one r0u; one ru; one r1u; with_quintics quintic_basis joins; data_of_joins; cbv beta delta [turn size near far]; with_quintics quintic_basis ltac:(fun curve => match goal with E : quintic_basis = _ |- _ => clear E end; assert (PP : forall u, vDerive 3 (fun u_ => p5 A B C_ E_ F G [p0'1; p0'2; p0'3] [p0u'1; p0u'2; p0u'3] [p1'1; p1'2; p1'3] [p1u'1; p1u'2; p1u'3] [pm'1; pm'2; pm'3] [pu'1; pu'2; pu'3] u_) 1 u = vscale 5 (at_number [[0; 0; 0; 0; 0]; [(-6); (-168); 861; (-1392); 700]; [9; (-246); 1074; (-1520); 680]]%Z u)) by (intro; cbv beta delta [p5 r5 hermite5 blend6 r0 q0]; staged; curves curve; preimages; cbv beta iota zeta delta [slope slopes tl poly quintic_of entry nth Nat.pred at_number whole_poly map vscale vsub zip]; parts; field); assert (RR : forall u, vDerive 3 (fun u_ => r5 A B C_ E_ F G u_) 1 u = vscale (10 / 26733) (at_number [[(-50652); (-1327440); 6932304; (-11544192); 5913600]; [(-168840); (-4424800); 23107680; (-38480640); 19712000]; [278586; (-7928226); 35064945; (-49890432); 22349100]]%Z u)) by (intro; cbv beta delta [p5 r5 hermite5 blend6 r0 q0]; staged; curves curve; preimages; cbv beta iota zeta delta [slope slopes tl poly quintic_of entry nth Nat.pred at_number whole_poly map vscale vsub zip]; parts; field); assert (WW : forall u, vsub (r5 A B C_ E_ F G u) (p5 A B C_ E_ F G [p0'1; p0'2; p0'3] [p0u'1; p0u'2; p0u'3] [p1'1; p1'2; p1'3] [p1u'1; p1u'2; p1u'3] [pm'1; pm'2; pm'3] [pu'1; pu'2; pu'3] u) = vscale (5 / 26733) (at_number [[(-320796); (-101304); (-1327440); 4621536; (-5772096); 2365440]; [106932; (-177282); (-2179228); 7732749; (-9937236); 4142180]; [0; 316575; (-4640067); 13806216; (-14786676); 5303952]]%Z u)) by (intro; cbv beta delta [p5 r5 hermite5 blend6 r0 q0]; staged; curves curve; preimages; cbv beta iota zeta delta [slope slopes tl poly quintic_of entry nth Nat.pred at_number whole_poly map vscale vsub zip]; parts; field)); rewrite !PP, !RR, !WW; split; [ cbv beta iota zeta delta [at_number whole_poly map vscale cross dot entry zip fold_right nth Nat.pred]; numeric | apply (angle_below 6 125 1000); [ exact_no_check (@eq_refl bool true) | first [ reflexivity | lia | lra ] .. ] ]. Qed.
Theorem met : instance.
Proof. stage quintic; stage quintic_; stage quintic_data; stage quintic_basis; cbv beta zeta delta [instance]; exists 0, 0, 0, 0, 0, 0, 40, 40, 45, 0, (-30), 45, 40, (-15), 45, 0, (-25), (-15), 40, (25/2), 40, 0, (-25), 35, 0; quintic_parts quintic_basis ltac:(cbv beta zeta delta [q0 qm q1 q0u qu q1u q5 k o quintic_gap quintic_part quintic_criterion quintic_criterion__ quintic_criterion___ quintic_criterion____ quintic_criterion_____ quintic_criterion______ normal blend6 hermite5 p5 a_ d_]); met_joins; compute_goal; numeric. Qed.
End ex_4_b_twist.
