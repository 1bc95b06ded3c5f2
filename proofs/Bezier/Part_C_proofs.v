(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_C.
Import Bezier.Part_C.Definitions.
Open Scope R_scope.

Module join_C0.
Import Bezier.Part_C.join_C0.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B S_ C_]; prepared; unknown (R_ 0%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B S_ C_]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0); met)]. Qed.
End join_C0.

Module join_C1.
Import Bezier.Part_C.join_C1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B S_ C_ S__ C__]; prepared; unknown (R_ 0%Z); unknown (R_ 1%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B S_ C_ S__ C__]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0); met)]. Qed.
End join_C1.

Module join_C1_slip.
Import Bezier.Part_C.join_C1_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement B S_ C_ S__ C__] in no; refuting (no ((3))%Z ((4))%Z (fun i0 => if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else if (Z.eqb i0 (1))%bool then (7/4) else 0)). Qed.
End join_C1_slip.

Module join_C1_slip_corrected.
Import Bezier.Part_C.join_C1_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B S_ C_ S__ C__]; prepared; unknown (R_ 0%Z); unknown (R_ 1%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B S_ C_ S__ C__]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0); met)]. Qed.
End join_C1_slip_corrected.

Module join_C2.
Import Bezier.Part_C.join_C2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B S_ C_ S__ C__ d1 d2]; prepared; unknown (R_ 0%Z); unknown (R_ 1%Z); unknown (R_ 2%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B S_ C_ S__ C__ d1 d2]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0); met)]. Qed.
End join_C2.

Module join_C2_slip.
Import Bezier.Part_C.join_C2_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement B S_ C_ S__ C__ d1 d2] in no; refuting (no ((3))%Z ((3))%Z (fun i0 => if (Z.eqb i0 (1))%bool then (0) else if (Z.eqb i0 (2))%bool then (0) else if (Z.eqb i0 (3))%bool then (1) else 0) (fun i0 => if (Z.eqb i0 (0))%bool then (1) else if (Z.eqb i0 (1))%bool then (2) else if (Z.eqb i0 (2))%bool then (4) else 0)). Qed.
End join_C2_slip.

Module join_C2_slip_corrected.
Import Bezier.Part_C.join_C2_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B S_ C_ S__ C__ d1 d2]; prepared; unknown (R_ 0%Z); unknown (R_ 1%Z); unknown (R_ 2%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B S_ C_ S__ C__ d1 d2]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0); met)]. Qed.
End join_C2_slip_corrected.

Module join_C3.
Import Bezier.Part_C.join_C3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B S_ C_ S__ C__ d1 d2 d3]; intros m n P Q M N _ _ E F G H _ _ A _ B _ C _; revert E F G H; lists; derivatives; operators; ends; tidied; maxes; members; numbers; intros E F G H; apply (Rmult_eq_reg_l (IZR n * (IZR n - 1) * (IZR n - 2))); [ match type of F with ?f = _ => match type of G with ?g = _ => match type of H with ?h = _ => transitivity (h + 3 * (IZR n - 2) * g + 3 * (IZR n - 1) * (IZR n - 2) * f + IZR n * (IZR n - 1) * (IZR n - 2) * Q 0%Z) end end end; [ ring | rewrite F, G, H, E; field; nonzero ] | exact C ]. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B S_ C_ S__ C__ d1 d2 d3]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0); met)]. Qed.
End join_C3.

Module join_C2_sufficient.
Import Bezier.Part_C.join_C2_sufficient.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement d1 d2 B S_ C_ S__ C__]; prepared; unknown (R_ 0%Z); unknown (R_ 1%Z); unknown (R_ 2%Z); put_in; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance d1 d2 B S_ C_ S__ C__]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0); met)]. Qed.
End join_C2_sufficient.

Module join_knot.
Import Bezier.Part_C.join_knot.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement B S_ C_ S__ C__]; combined. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance B S_ C_ S__ C__]; first [(exists (3)%Z, (3)%Z, (fun _ => 4), (fun _ => 5), (6), (7); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0); met) | (exists (3)%Z, (3)%Z, (fun i0 => IZR (1 * i0 * i0 * i0 + 6 * i0 + 8)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 6)%Z), (8), (7); met) | (exists (3)%Z, (3)%Z, (fun _ => 1), (fun _ => 1), (1), (1); met) | (exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (1), (0); met)]. Qed.
End join_knot.

Module trigonometric_C1.
Import Bezier.Part_C.trigonometric_C1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T G F G_ F_]; unstaged; prepared; known ((R_ (0)%Z)) ((P (3)%Z)) (1); known ((R_ (1)%Z)) (-(P (2)%Z)*mu - 2*(P (2)%Z) + (P (3)%Z)*lambda2 + (P (3)%Z)*mu + 4*(P (3)%Z)) (lambda2 + 2); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance T G F G_ F_]; first [(exists (fun _ => 2), (fun _ => 3), ((-1)), ((-1)), ((-1)), ((-1)); met) | (exists (fun _ => 0), (fun _ => 0), ((-1) / 2), ((-1) / 2), ((-1) / 2), ((-1) / 2); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1)), ((-1)), ((-1)), ((-1)); met) | (exists (fun _ => 1), (fun _ => 1), ((-1)), ((-1)), ((-1)), ((-1)); met) | (exists (fun _ => 0), (fun _ => 0), ((-1)), ((-1)), ((-1)), ((-1)); met)]. Qed.
End trigonometric_C1.

Module trigonometric_C1_inside.
Import Bezier.Part_C.trigonometric_C1_inside.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement T G F G_ F_]; unstaged; prepared; known ((R_ (0)%Z)) ((P (3)%Z)) (1); known ((R_ (1)%Z)) (-(P (2)%Z)*mu - 2*(P (2)%Z) + (P (3)%Z)*lambda2 + (P (3)%Z)*mu + 4*(P (3)%Z)) (lambda2 + 2); put_known; Solved.concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance T G F G_ F_]; first [(exists (fun _ => 2), (fun _ => 3), ((-1)), ((-1)), ((-1)), ((-1)); met) | (exists (fun _ => 0), (fun _ => 0), ((-1) / 2), ((-1) / 2), ((-1) / 2), ((-1) / 2); met) | (exists (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 13)%Z), (fun i0 => IZR (1 * i0 * i0 * i0 + 8 * i0 + 8)%Z), ((-1)), ((-1)), ((-1)), ((-1)); met) | (exists (fun _ => 1), (fun _ => 1), ((-1)), ((-1)), ((-1)), ((-1)); met) | (exists (fun _ => 0), (fun _ => 0), ((-1)), ((-1)), ((-1)), ((-1)); met)]. Qed.
End trigonometric_C1_inside.

Module trigonometric_bezier.
Import Bezier.Part_C.trigonometric_bezier.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement S_ S__ F F_ B T]; intros n P R_ l m L M N _ A D _ Z; revert A D; closed_parts; derivatives; operators; ends; special; compute_goal; derivatives; special; rewrite (Z.max_l n 0) by lia; intros A D; assert (A' : R_ 0%Z = P 3%Z) by lra; rewrite A' in D; apply (Rmult_eq_reg_l (2 * IZR n)); [ | exact Z ]; match goal with |- _ = ?r => replace r with (2 * IZR n * P 3%Z + PI * (2 + m) * (P 3%Z - P 2%Z)) by (field; intro E; apply Z; rewrite E; ring) end; lra. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance S_ S__ F F_ B T]; exists 3%Z, (fun _ => 0), (fun _ => 0), 0, 0; repeat match goal with |- _ /\ _ => split end; intros; try lra; try lia; compute_goal; derivatives; special; ring. Qed.
End trigonometric_bezier.
