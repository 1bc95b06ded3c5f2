(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms.
From HermiteDevelopable Require Section_2.
Open Scope R_scope.

Module sec_2_cubic_equations.
Import HermiteDevelopable.Section_2.sec_2_cubic_equations.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cubic cubic_]; identity. Qed.
End sec_2_cubic_equations.

Module sec_2_cubic_a1.
Import HermiteDevelopable.Section_2.sec_2_cubic_a1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cubic cubic_conditions cubic_conditions_ cubic_conditions__ cubic_conditions___ cubic_ cubic_conditions____ cubic_conditions_____ cubic_conditions______ cubic_conditions_______]; prepared; unknown A; unknown B; unknown C_; unknown E_; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cubic cubic_conditions cubic_conditions_ cubic_conditions__ cubic_conditions___ cubic_ cubic_conditions____ cubic_conditions_____ cubic_conditions______ cubic_conditions_______]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7; met) | (exists 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_2_cubic_a1.

Module sec_2_cubic_b1.
Import HermiteDevelopable.Section_2.sec_2_cubic_b1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cubic cubic_conditions cubic_conditions_ cubic_conditions__ cubic_conditions___ cubic_ cubic_conditions____ cubic_conditions_____ cubic_conditions______ cubic_conditions_______]; prepared; unknown A; unknown B; unknown C_; unknown E_; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cubic cubic_conditions cubic_conditions_ cubic_conditions__ cubic_conditions___ cubic_ cubic_conditions____ cubic_conditions_____ cubic_conditions______ cubic_conditions_______]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7; met) | (exists 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_2_cubic_b1.

Module sec_2_cubic_c1.
Import HermiteDevelopable.Section_2.sec_2_cubic_c1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cubic cubic_conditions cubic_conditions_ cubic_conditions__ cubic_conditions___ cubic_ cubic_conditions____ cubic_conditions_____ cubic_conditions______ cubic_conditions_______]; prepared; unknown A; unknown B; unknown C_; unknown E_; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cubic cubic_conditions cubic_conditions_ cubic_conditions__ cubic_conditions___ cubic_ cubic_conditions____ cubic_conditions_____ cubic_conditions______ cubic_conditions_______]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7; met) | (exists 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_2_cubic_c1.

Module sec_2_cubic_d1.
Import HermiteDevelopable.Section_2.sec_2_cubic_d1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cubic cubic_conditions cubic_conditions_ cubic_conditions__ cubic_conditions___ cubic_ cubic_conditions____ cubic_conditions_____ cubic_conditions______ cubic_conditions_______]; prepared; unknown A; unknown B; unknown C_; unknown E_; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cubic cubic_conditions cubic_conditions_ cubic_conditions__ cubic_conditions___ cubic_ cubic_conditions____ cubic_conditions_____ cubic_conditions______ cubic_conditions_______]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7; met) | (exists 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_2_cubic_d1.

Module eq_2_1a.
Import HermiteDevelopable.Section_2.eq_2_1a.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cubic cubic_conditions cubic_conditions_ cubic_conditions__ cubic_conditions___ cubic_ cubic_conditions____ cubic_conditions_____ cubic_conditions______ cubic_conditions_______]; prepared; unknown A; unknown B; unknown C_; unknown E_; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cubic cubic_conditions cubic_conditions_ cubic_conditions__ cubic_conditions___ cubic_ cubic_conditions____ cubic_conditions_____ cubic_conditions______ cubic_conditions_______]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, (1 / 3); met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, (1 / 3); met)]. Qed.
End eq_2_1a.

Module eq_2_1b.
Import HermiteDevelopable.Section_2.eq_2_1b.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement cubic cubic_conditions cubic_conditions_ cubic_conditions__ cubic_conditions___ cubic_ cubic_conditions____ cubic_conditions_____ cubic_conditions______ cubic_conditions_______ H1 H2 H3 H4]; prepared; unknown A; unknown B; unknown C_; unknown E_; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance cubic cubic_conditions cubic_conditions_ cubic_conditions__ cubic_conditions___ cubic_ cubic_conditions____ cubic_conditions_____ cubic_conditions______ cubic_conditions_______ H1 H2 H3 H4]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, (1 / 3); met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, (1 / 3); met)]. Qed.
End eq_2_1b.

Module sec_2_quartic_solvable.
Import HermiteDevelopable.Section_2.sec_2_quartic_solvable.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement quartic quartic_ quartic_data]; ordered. Qed.
End sec_2_quartic_solvable.

Module sec_2_quartic_a1.
Import HermiteDevelopable.Section_2.sec_2_quartic_a1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement quartic quartic_conditions quartic_conditions_ quartic_ quartic_conditions__ quartic_conditions___ quartic_conditions____ quartic_conditions_____ quartic_conditions______ quartic_conditions_______ quartic_conditions________ quartic_conditions_________]; prepared; unknown A; unknown B; unknown C_; unknown E_; unknown F; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance quartic quartic_conditions quartic_conditions_ quartic_ quartic_conditions__ quartic_conditions___ quartic_conditions____ quartic_conditions_____ quartic_conditions______ quartic_conditions_______ quartic_conditions________ quartic_conditions_________]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2; met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_2_quartic_a1.

Module sec_2_quartic_b1.
Import HermiteDevelopable.Section_2.sec_2_quartic_b1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement quartic quartic_conditions quartic_conditions_ quartic_ quartic_conditions__ quartic_conditions___ quartic_conditions____ quartic_conditions_____ quartic_conditions______ quartic_conditions_______ quartic_conditions________ quartic_conditions_________]; prepared; unknown A; unknown B; unknown C_; unknown E_; unknown F; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance quartic quartic_conditions quartic_conditions_ quartic_ quartic_conditions__ quartic_conditions___ quartic_conditions____ quartic_conditions_____ quartic_conditions______ quartic_conditions_______ quartic_conditions________ quartic_conditions_________]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2; met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_2_quartic_b1.

Module sec_2_quartic_third.
Import HermiteDevelopable.Section_2.sec_2_quartic_third.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement quartic quartic_conditions quartic_conditions_ quartic_ quartic_conditions__ quartic_conditions___ quartic_conditions____ quartic_conditions_____ quartic_conditions______ quartic_conditions_______ quartic_conditions________ quartic_conditions_________] in no; refuting (no (16) (-32) (16) (0) (0) (0) (0) (0) (0) (1)). Qed.
End sec_2_quartic_third.

Module sec_2_quartic_third_corrected.
Import HermiteDevelopable.Section_2.sec_2_quartic_third_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement quartic quartic_conditions quartic_conditions_ quartic_ quartic_conditions__ quartic_conditions___ quartic_conditions____ quartic_conditions_____ quartic_conditions______ quartic_conditions_______ quartic_conditions________ quartic_conditions_________]; prepared; unknown A; unknown B; unknown C_; unknown E_; unknown F; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance quartic quartic_conditions quartic_conditions_ quartic_ quartic_conditions__ quartic_conditions___ quartic_conditions____ quartic_conditions_____ quartic_conditions______ quartic_conditions_______ quartic_conditions________ quartic_conditions_________]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2; met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_2_quartic_third_corrected.

Module sec_2_quartic_d1.
Import HermiteDevelopable.Section_2.sec_2_quartic_d1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement quartic quartic_conditions quartic_conditions_ quartic_ quartic_conditions__ quartic_conditions___ quartic_conditions____ quartic_conditions_____ quartic_conditions______ quartic_conditions_______ quartic_conditions________ quartic_conditions_________]; prepared; unknown A; unknown B; unknown C_; unknown E_; unknown F; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance quartic quartic_conditions quartic_conditions_ quartic_ quartic_conditions__ quartic_conditions___ quartic_conditions____ quartic_conditions_____ quartic_conditions______ quartic_conditions_______ quartic_conditions________ quartic_conditions_________]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2; met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_2_quartic_d1.

Module sec_2_quartic_e1.
Import HermiteDevelopable.Section_2.sec_2_quartic_e1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement quartic quartic_conditions quartic_conditions_ quartic_ quartic_conditions__ quartic_conditions___ quartic_conditions____ quartic_conditions_____ quartic_conditions______ quartic_conditions_______ quartic_conditions________ quartic_conditions_________]; prepared; unknown A; unknown B; unknown C_; unknown E_; unknown F; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance quartic quartic_conditions quartic_conditions_ quartic_ quartic_conditions__ quartic_conditions___ quartic_conditions____ quartic_conditions_____ quartic_conditions______ quartic_conditions_______ quartic_conditions________ quartic_conditions_________]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2; met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_2_quartic_e1.

Module eq_2_2.
Import HermiteDevelopable.Section_2.eq_2_2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement quartic quartic_conditions quartic_conditions_ quartic_ quartic_conditions__ quartic_conditions___ quartic_conditions____ quartic_conditions_____ quartic_conditions______ quartic_conditions_______ quartic_conditions________ quartic_conditions_________]; prepared; unknown A; unknown B; unknown C_; unknown E_; unknown F; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance quartic quartic_conditions quartic_conditions_ quartic_ quartic_conditions__ quartic_conditions___ quartic_conditions____ quartic_conditions_____ quartic_conditions______ quartic_conditions_______ quartic_conditions________ quartic_conditions_________]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, (1 / 3); met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, (1 / 3); met)]. Qed.
End eq_2_2.

Module eq_2_3.
Import HermiteDevelopable.Section_2.eq_2_3.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement quartic quartic_conditions quartic_conditions_ quartic_ quartic_conditions__ quartic_conditions___ quartic_conditions____ quartic_conditions_____ quartic_conditions______ quartic_conditions_______ quartic_conditions________ quartic_conditions_________ H1 H2 H3 H4 H5] in no; refuting (no (16) (-32) (16) (0) (0) (0) (0) (0) (0) (1) (1/2)). Qed.
End eq_2_3.

Module eq_2_3_corrected.
Import HermiteDevelopable.Section_2.eq_2_3_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement quartic quartic_conditions quartic_conditions_ quartic_ quartic_conditions__ quartic_conditions___ quartic_conditions____ quartic_conditions_____ quartic_conditions______ quartic_conditions_______ quartic_conditions________ quartic_conditions_________ H1 H2 H3 H4 H5]; prepared; unknown A; unknown B; unknown C_; unknown E_; unknown F; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance quartic quartic_conditions quartic_conditions_ quartic_ quartic_conditions__ quartic_conditions___ quartic_conditions____ quartic_conditions_____ quartic_conditions______ quartic_conditions_______ quartic_conditions________ quartic_conditions_________ H1 H2 H3 H4 H5]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, (1 / 3); met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, (1 / 3); met)]. Qed.
End eq_2_3_corrected.

Module sec_2_quintic_a1.
Import HermiteDevelopable.Section_2.sec_2_quintic_a1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement quintic quintic_conditions quintic_conditions_ quintic_ quintic_conditions__ quintic_conditions___ quintic_conditions____ quintic_conditions_____ quintic_conditions______ quintic_conditions_______ quintic_conditions________ quintic_conditions_________ quintic_conditions__________ quintic_conditions___________]; prepared; unknown A; unknown B; unknown C_; unknown E_; unknown F; unknown G; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance quintic quintic_conditions quintic_conditions_ quintic_ quintic_conditions__ quintic_conditions___ quintic_conditions____ quintic_conditions_____ quintic_conditions______ quintic_conditions_______ quintic_conditions________ quintic_conditions_________ quintic_conditions__________ quintic_conditions___________]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1; met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_2_quintic_a1.

Module sec_2_quintic_b1.
Import HermiteDevelopable.Section_2.sec_2_quintic_b1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement quintic quintic_conditions quintic_conditions_ quintic_ quintic_conditions__ quintic_conditions___ quintic_conditions____ quintic_conditions_____ quintic_conditions______ quintic_conditions_______ quintic_conditions________ quintic_conditions_________ quintic_conditions__________ quintic_conditions___________]; prepared; unknown A; unknown B; unknown C_; unknown E_; unknown F; unknown G; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance quintic quintic_conditions quintic_conditions_ quintic_ quintic_conditions__ quintic_conditions___ quintic_conditions____ quintic_conditions_____ quintic_conditions______ quintic_conditions_______ quintic_conditions________ quintic_conditions_________ quintic_conditions__________ quintic_conditions___________]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1; met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_2_quintic_b1.

Module sec_2_quintic_c1.
Import HermiteDevelopable.Section_2.sec_2_quintic_c1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement quintic quintic_conditions quintic_conditions_ quintic_ quintic_conditions__ quintic_conditions___ quintic_conditions____ quintic_conditions_____ quintic_conditions______ quintic_conditions_______ quintic_conditions________ quintic_conditions_________ quintic_conditions__________ quintic_conditions___________]; prepared; unknown A; unknown B; unknown C_; unknown E_; unknown F; unknown G; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance quintic quintic_conditions quintic_conditions_ quintic_ quintic_conditions__ quintic_conditions___ quintic_conditions____ quintic_conditions_____ quintic_conditions______ quintic_conditions_______ quintic_conditions________ quintic_conditions_________ quintic_conditions__________ quintic_conditions___________]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1; met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_2_quintic_c1.

Module sec_2_quintic_d1.
Import HermiteDevelopable.Section_2.sec_2_quintic_d1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement quintic quintic_conditions quintic_conditions_ quintic_ quintic_conditions__ quintic_conditions___ quintic_conditions____ quintic_conditions_____ quintic_conditions______ quintic_conditions_______ quintic_conditions________ quintic_conditions_________ quintic_conditions__________ quintic_conditions___________]; prepared; unknown A; unknown B; unknown C_; unknown E_; unknown F; unknown G; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance quintic quintic_conditions quintic_conditions_ quintic_ quintic_conditions__ quintic_conditions___ quintic_conditions____ quintic_conditions_____ quintic_conditions______ quintic_conditions_______ quintic_conditions________ quintic_conditions_________ quintic_conditions__________ quintic_conditions___________]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1; met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_2_quintic_d1.

Module sec_2_quintic_e1.
Import HermiteDevelopable.Section_2.sec_2_quintic_e1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement quintic quintic_conditions quintic_conditions_ quintic_ quintic_conditions__ quintic_conditions___ quintic_conditions____ quintic_conditions_____ quintic_conditions______ quintic_conditions_______ quintic_conditions________ quintic_conditions_________ quintic_conditions__________ quintic_conditions___________]; prepared; unknown A; unknown B; unknown C_; unknown E_; unknown F; unknown G; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance quintic quintic_conditions quintic_conditions_ quintic_ quintic_conditions__ quintic_conditions___ quintic_conditions____ quintic_conditions_____ quintic_conditions______ quintic_conditions_______ quintic_conditions________ quintic_conditions_________ quintic_conditions__________ quintic_conditions___________]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1; met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_2_quintic_e1.

Module sec_2_quintic_f1.
Import HermiteDevelopable.Section_2.sec_2_quintic_f1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement quintic quintic_conditions quintic_conditions_ quintic_ quintic_conditions__ quintic_conditions___ quintic_conditions____ quintic_conditions_____ quintic_conditions______ quintic_conditions_______ quintic_conditions________ quintic_conditions_________ quintic_conditions__________ quintic_conditions___________]; prepared; unknown A; unknown B; unknown C_; unknown E_; unknown F; unknown G; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance quintic quintic_conditions quintic_conditions_ quintic_ quintic_conditions__ quintic_conditions___ quintic_conditions____ quintic_conditions_____ quintic_conditions______ quintic_conditions_______ quintic_conditions________ quintic_conditions_________ quintic_conditions__________ quintic_conditions___________]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13; met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0; met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1; met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1; met)]. Qed.
End sec_2_quintic_f1.

Module eq_2_4.
Import HermiteDevelopable.Section_2.eq_2_4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement quintic quintic_conditions quintic_conditions_ quintic_ quintic_conditions__ quintic_conditions___ quintic_conditions____ quintic_conditions_____ quintic_conditions______ quintic_conditions_______ quintic_conditions________ quintic_conditions_________ quintic_conditions__________ quintic_conditions___________]; prepared; unknown A; unknown B; unknown C_; unknown E_; unknown F; unknown G; finished. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance quintic quintic_conditions quintic_conditions_ quintic_ quintic_conditions__ quintic_conditions___ quintic_conditions____ quintic_conditions_____ quintic_conditions______ quintic_conditions_______ quintic_conditions________ quintic_conditions_________ quintic_conditions__________ quintic_conditions___________]; first [(exists 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, (1 / 3); met) | (exists 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, (1 / 2); met) | (exists 13, 8, 8, 6, 8, 7, 9, 7, 7, 2, 11, 1, (1 / 3); met) | (exists 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, (1 / 3); met)]. Qed.
End eq_2_4.

Module eq_2_1b_H1.
Import HermiteDevelopable.Section_2.eq_2_1b_H1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_conditions; stage cubic_conditions_; stage cubic_conditions__; stage cubic_conditions___; stage cubic_; stage cubic_conditions____; stage cubic_conditions_____; stage cubic_conditions______; staged_goal cubic_conditions_______; unstaged; computed; intros; along (forall p0 : R, A_of_p0 p0 = ((2*p0 + p0u - 2*p1 + p1u) / (1)) /\ B_of_p0 p0 = ((-3*p0 - 2*p0u + 3*p1 - p1u) / (1)) /\ C__of_p0 p0 = ((p0u) / (1)) /\ E__of_p0 p0 = ((p0) / (1))); function A_of_p0; function B_of_p0; function C__of_p0; function E__of_p0; conclusion; prepared; known (A) (2*p0 + p0u - 2*p1 + p1u) (1); known (B) (-3*p0 - 2*p0u + 3*p1 - p1u) (1); known (C_) (p0u) (1); known (E_) (p0) (1); put_known; concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_conditions; stage cubic_conditions_; stage cubic_conditions__; stage cubic_conditions___; stage cubic_; stage cubic_conditions____; stage cubic_conditions_____; stage cubic_conditions______; staged_goal cubic_conditions_______; unstaged; first [(exists ((2*(6) + (7) - 2*(8) + (9)) / (1)), ((-3*(6) - 2*(7) + 3*(8) - (9)) / (1)), (((7)) / (1)), (((6)) / (1)), 6, 7, 8, 9, (1 / 3), (fun p0 => ((2*p0 + (7) - 2*(8) + (9)) / (1))), (fun p0 => ((-3*p0 - 2*(7) + 3*(8) - (9)) / (1))), (fun p0 => (((7)) / (1))), (fun p0 => ((p0) / (1))); met) | (exists ((2*(0) + (0) - 2*(0) + (0)) / (1)), ((-3*(0) - 2*(0) + 3*(0) - (0)) / (1)), (((0)) / (1)), (((0)) / (1)), 0, 0, 0, 0, (1 / 2), (fun p0 => ((2*p0 + (0) - 2*(0) + (0)) / (1))), (fun p0 => ((-3*p0 - 2*(0) + 3*(0) - (0)) / (1))), (fun p0 => (((0)) / (1))), (fun p0 => ((p0) / (1))); met) | (exists ((2*(8) + (7) - 2*(9) + (7)) / (1)), ((-3*(8) - 2*(7) + 3*(9) - (7)) / (1)), (((7)) / (1)), (((8)) / (1)), 8, 7, 9, 7, (1 / 3), (fun p0 => ((2*p0 + (7) - 2*(9) + (7)) / (1))), (fun p0 => ((-3*p0 - 2*(7) + 3*(9) - (7)) / (1))), (fun p0 => (((7)) / (1))), (fun p0 => ((p0) / (1))); met) | (exists ((2*(1) + (1) - 2*(1) + (1)) / (1)), ((-3*(1) - 2*(1) + 3*(1) - (1)) / (1)), (((1)) / (1)), (((1)) / (1)), 1, 1, 1, 1, (1 / 3), (fun p0 => ((2*p0 + (1) - 2*(1) + (1)) / (1))), (fun p0 => ((-3*p0 - 2*(1) + 3*(1) - (1)) / (1))), (fun p0 => (((1)) / (1))), (fun p0 => ((p0) / (1))); met)]. Qed.
End eq_2_1b_H1.

Module eq_2_1b_H2.
Import HermiteDevelopable.Section_2.eq_2_1b_H2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_conditions; stage cubic_conditions_; stage cubic_conditions__; stage cubic_conditions___; stage cubic_; stage cubic_conditions____; stage cubic_conditions_____; stage cubic_conditions______; staged_goal cubic_conditions_______; unstaged; computed; intros; along (forall p1 : R, A_of_p1 p1 = ((2*p0 + p0u - 2*p1 + p1u) / (1)) /\ B_of_p1 p1 = ((-3*p0 - 2*p0u + 3*p1 - p1u) / (1)) /\ C__of_p1 p1 = ((p0u) / (1)) /\ E__of_p1 p1 = ((p0) / (1))); function A_of_p1; function B_of_p1; function C__of_p1; function E__of_p1; conclusion; prepared; known (A) (2*p0 + p0u - 2*p1 + p1u) (1); known (B) (-3*p0 - 2*p0u + 3*p1 - p1u) (1); known (C_) (p0u) (1); known (E_) (p0) (1); put_known; concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_conditions; stage cubic_conditions_; stage cubic_conditions__; stage cubic_conditions___; stage cubic_; stage cubic_conditions____; stage cubic_conditions_____; stage cubic_conditions______; staged_goal cubic_conditions_______; unstaged; first [(exists ((2*(6) + (7) - 2*(8) + (9)) / (1)), ((-3*(6) - 2*(7) + 3*(8) - (9)) / (1)), (((7)) / (1)), (((6)) / (1)), 6, 7, 8, 9, (1 / 3), (fun p1 => ((2*(6) + (7) - 2*p1 + (9)) / (1))), (fun p1 => ((-3*(6) - 2*(7) + 3*p1 - (9)) / (1))), (fun p1 => (((7)) / (1))), (fun p1 => (((6)) / (1))); met) | (exists ((2*(0) + (0) - 2*(0) + (0)) / (1)), ((-3*(0) - 2*(0) + 3*(0) - (0)) / (1)), (((0)) / (1)), (((0)) / (1)), 0, 0, 0, 0, (1 / 2), (fun p1 => ((2*(0) + (0) - 2*p1 + (0)) / (1))), (fun p1 => ((-3*(0) - 2*(0) + 3*p1 - (0)) / (1))), (fun p1 => (((0)) / (1))), (fun p1 => (((0)) / (1))); met) | (exists ((2*(8) + (7) - 2*(9) + (7)) / (1)), ((-3*(8) - 2*(7) + 3*(9) - (7)) / (1)), (((7)) / (1)), (((8)) / (1)), 8, 7, 9, 7, (1 / 3), (fun p1 => ((2*(8) + (7) - 2*p1 + (7)) / (1))), (fun p1 => ((-3*(8) - 2*(7) + 3*p1 - (7)) / (1))), (fun p1 => (((7)) / (1))), (fun p1 => (((8)) / (1))); met) | (exists ((2*(1) + (1) - 2*(1) + (1)) / (1)), ((-3*(1) - 2*(1) + 3*(1) - (1)) / (1)), (((1)) / (1)), (((1)) / (1)), 1, 1, 1, 1, (1 / 3), (fun p1 => ((2*(1) + (1) - 2*p1 + (1)) / (1))), (fun p1 => ((-3*(1) - 2*(1) + 3*p1 - (1)) / (1))), (fun p1 => (((1)) / (1))), (fun p1 => (((1)) / (1))); met)]. Qed.
End eq_2_1b_H2.

Module eq_2_1b_H3.
Import HermiteDevelopable.Section_2.eq_2_1b_H3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_conditions; stage cubic_conditions_; stage cubic_conditions__; stage cubic_conditions___; stage cubic_; stage cubic_conditions____; stage cubic_conditions_____; stage cubic_conditions______; staged_goal cubic_conditions_______; unstaged; computed; intros; along (forall p0u : R, A_of_p0u p0u = ((2*p0 + p0u - 2*p1 + p1u) / (1)) /\ B_of_p0u p0u = ((-3*p0 - 2*p0u + 3*p1 - p1u) / (1)) /\ C__of_p0u p0u = ((p0u) / (1)) /\ E__of_p0u p0u = ((p0) / (1))); function A_of_p0u; function B_of_p0u; function C__of_p0u; function E__of_p0u; conclusion; prepared; known (A) (2*p0 + p0u - 2*p1 + p1u) (1); known (B) (-3*p0 - 2*p0u + 3*p1 - p1u) (1); known (C_) (p0u) (1); known (E_) (p0) (1); put_known; concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_conditions; stage cubic_conditions_; stage cubic_conditions__; stage cubic_conditions___; stage cubic_; stage cubic_conditions____; stage cubic_conditions_____; stage cubic_conditions______; staged_goal cubic_conditions_______; unstaged; first [(exists ((2*(6) + (7) - 2*(8) + (9)) / (1)), ((-3*(6) - 2*(7) + 3*(8) - (9)) / (1)), (((7)) / (1)), (((6)) / (1)), 6, 7, 8, 9, (1 / 3), (fun p0u => ((2*(6) + p0u - 2*(8) + (9)) / (1))), (fun p0u => ((-3*(6) - 2*p0u + 3*(8) - (9)) / (1))), (fun p0u => ((p0u) / (1))), (fun p0u => (((6)) / (1))); met) | (exists ((2*(0) + (0) - 2*(0) + (0)) / (1)), ((-3*(0) - 2*(0) + 3*(0) - (0)) / (1)), (((0)) / (1)), (((0)) / (1)), 0, 0, 0, 0, (1 / 2), (fun p0u => ((2*(0) + p0u - 2*(0) + (0)) / (1))), (fun p0u => ((-3*(0) - 2*p0u + 3*(0) - (0)) / (1))), (fun p0u => ((p0u) / (1))), (fun p0u => (((0)) / (1))); met) | (exists ((2*(8) + (7) - 2*(9) + (7)) / (1)), ((-3*(8) - 2*(7) + 3*(9) - (7)) / (1)), (((7)) / (1)), (((8)) / (1)), 8, 7, 9, 7, (1 / 3), (fun p0u => ((2*(8) + p0u - 2*(9) + (7)) / (1))), (fun p0u => ((-3*(8) - 2*p0u + 3*(9) - (7)) / (1))), (fun p0u => ((p0u) / (1))), (fun p0u => (((8)) / (1))); met) | (exists ((2*(1) + (1) - 2*(1) + (1)) / (1)), ((-3*(1) - 2*(1) + 3*(1) - (1)) / (1)), (((1)) / (1)), (((1)) / (1)), 1, 1, 1, 1, (1 / 3), (fun p0u => ((2*(1) + p0u - 2*(1) + (1)) / (1))), (fun p0u => ((-3*(1) - 2*p0u + 3*(1) - (1)) / (1))), (fun p0u => ((p0u) / (1))), (fun p0u => (((1)) / (1))); met)]. Qed.
End eq_2_1b_H3.

Module eq_2_1b_H4.
Import HermiteDevelopable.Section_2.eq_2_1b_H4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage cubic; stage cubic_conditions; stage cubic_conditions_; stage cubic_conditions__; stage cubic_conditions___; stage cubic_; stage cubic_conditions____; stage cubic_conditions_____; stage cubic_conditions______; staged_goal cubic_conditions_______; unstaged; computed; intros; along (forall p1u : R, A_of_p1u p1u = ((2*p0 + p0u - 2*p1 + p1u) / (1)) /\ B_of_p1u p1u = ((-3*p0 - 2*p0u + 3*p1 - p1u) / (1)) /\ C__of_p1u p1u = ((p0u) / (1)) /\ E__of_p1u p1u = ((p0) / (1))); function A_of_p1u; function B_of_p1u; function C__of_p1u; function E__of_p1u; conclusion; prepared; known (A) (2*p0 + p0u - 2*p1 + p1u) (1); known (B) (-3*p0 - 2*p0u + 3*p1 - p1u) (1); known (C_) (p0u) (1); known (E_) (p0) (1); put_known; concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage cubic; stage cubic_conditions; stage cubic_conditions_; stage cubic_conditions__; stage cubic_conditions___; stage cubic_; stage cubic_conditions____; stage cubic_conditions_____; stage cubic_conditions______; staged_goal cubic_conditions_______; unstaged; first [(exists ((2*(6) + (7) - 2*(8) + (9)) / (1)), ((-3*(6) - 2*(7) + 3*(8) - (9)) / (1)), (((7)) / (1)), (((6)) / (1)), 6, 7, 8, 9, (1 / 3), (fun p1u => ((2*(6) + (7) - 2*(8) + p1u) / (1))), (fun p1u => ((-3*(6) - 2*(7) + 3*(8) - p1u) / (1))), (fun p1u => (((7)) / (1))), (fun p1u => (((6)) / (1))); met) | (exists ((2*(0) + (0) - 2*(0) + (0)) / (1)), ((-3*(0) - 2*(0) + 3*(0) - (0)) / (1)), (((0)) / (1)), (((0)) / (1)), 0, 0, 0, 0, (1 / 2), (fun p1u => ((2*(0) + (0) - 2*(0) + p1u) / (1))), (fun p1u => ((-3*(0) - 2*(0) + 3*(0) - p1u) / (1))), (fun p1u => (((0)) / (1))), (fun p1u => (((0)) / (1))); met) | (exists ((2*(8) + (7) - 2*(9) + (7)) / (1)), ((-3*(8) - 2*(7) + 3*(9) - (7)) / (1)), (((7)) / (1)), (((8)) / (1)), 8, 7, 9, 7, (1 / 3), (fun p1u => ((2*(8) + (7) - 2*(9) + p1u) / (1))), (fun p1u => ((-3*(8) - 2*(7) + 3*(9) - p1u) / (1))), (fun p1u => (((7)) / (1))), (fun p1u => (((8)) / (1))); met) | (exists ((2*(1) + (1) - 2*(1) + (1)) / (1)), ((-3*(1) - 2*(1) + 3*(1) - (1)) / (1)), (((1)) / (1)), (((1)) / (1)), 1, 1, 1, 1, (1 / 3), (fun p1u => ((2*(1) + (1) - 2*(1) + p1u) / (1))), (fun p1u => ((-3*(1) - 2*(1) + 3*(1) - p1u) / (1))), (fun p1u => (((1)) / (1))), (fun p1u => (((1)) / (1))); met)]. Qed.
End eq_2_1b_H4.

Module eq_2_3_H1.
Import HermiteDevelopable.Section_2.eq_2_3_H1.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quartic; stage quartic_conditions; stage quartic_conditions_; stage quartic_; stage quartic_conditions__; stage quartic_conditions___; stage quartic_conditions____; stage quartic_conditions_____; stage quartic_conditions______; stage quartic_conditions_______; stage quartic_conditions________; staged_goal quartic_conditions_________; unstaged; computed; intros; along (forall p0 : R, A_of_p0 p0 = ((-8*p0 - 2*p0u - 8*p1 + 2*p1u + 16*pm) / (1)) /\ B_of_p0 p0 = ((18*p0 + 5*p0u + 14*p1 - 3*p1u - 32*pm) / (1)) /\ C__of_p0 p0 = ((-11*p0 - 4*p0u - 5*p1 + p1u + 16*pm) / (1)) /\ E__of_p0 p0 = ((p0u) / (1)) /\ F_of_p0 p0 = ((p0) / (1))); function A_of_p0; function B_of_p0; function C__of_p0; function E__of_p0; function F_of_p0; conclusion; prepared; known (A) (-8*p0 - 2*p0u - 8*p1 + 2*p1u + 16*pm) (1); known (B) (18*p0 + 5*p0u + 14*p1 - 3*p1u - 32*pm) (1); known (C_) (-11*p0 - 4*p0u - 5*p1 + p1u + 16*pm) (1); known (E_) (p0u) (1); known (F) (p0) (1); put_known; concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quartic; stage quartic_conditions; stage quartic_conditions_; stage quartic_; stage quartic_conditions__; stage quartic_conditions___; stage quartic_conditions____; stage quartic_conditions_____; stage quartic_conditions______; stage quartic_conditions_______; stage quartic_conditions________; staged_goal quartic_conditions_________; unstaged; first [(exists ((-8*(7) - 2*(8) - 8*(9) + 2*(10) + 16*(11)) / (1)), ((18*(7) + 5*(8) + 14*(9) - 3*(10) - 32*(11)) / (1)), ((-11*(7) - 4*(8) - 5*(9) + (10) + 16*(11)) / (1)), (((8)) / (1)), (((7)) / (1)), 7, 8, 9, 10, 11, (1 / 3), (fun p0 => ((-8*p0 - 2*(8) - 8*(9) + 2*(10) + 16*(11)) / (1))), (fun p0 => ((18*p0 + 5*(8) + 14*(9) - 3*(10) - 32*(11)) / (1))), (fun p0 => ((-11*p0 - 4*(8) - 5*(9) + (10) + 16*(11)) / (1))), (fun p0 => (((8)) / (1))), (fun p0 => ((p0) / (1))); met) | (exists ((-8*(0) - 2*(0) - 8*(0) + 2*(0) + 16*(0)) / (1)), ((18*(0) + 5*(0) + 14*(0) - 3*(0) - 32*(0)) / (1)), ((-11*(0) - 4*(0) - 5*(0) + (0) + 16*(0)) / (1)), (((0)) / (1)), (((0)) / (1)), 0, 0, 0, 0, 0, (1 / 2), (fun p0 => ((-8*p0 - 2*(0) - 8*(0) + 2*(0) + 16*(0)) / (1))), (fun p0 => ((18*p0 + 5*(0) + 14*(0) - 3*(0) - 32*(0)) / (1))), (fun p0 => ((-11*p0 - 4*(0) - 5*(0) + (0) + 16*(0)) / (1))), (fun p0 => (((0)) / (1))), (fun p0 => ((p0) / (1))); met) | (exists ((-8*(7) - 2*(9) - 8*(7) + 2*(7) + 16*(2)) / (1)), ((18*(7) + 5*(9) + 14*(7) - 3*(7) - 32*(2)) / (1)), ((-11*(7) - 4*(9) - 5*(7) + (7) + 16*(2)) / (1)), (((9)) / (1)), (((7)) / (1)), 7, 9, 7, 7, 2, (1 / 3), (fun p0 => ((-8*p0 - 2*(9) - 8*(7) + 2*(7) + 16*(2)) / (1))), (fun p0 => ((18*p0 + 5*(9) + 14*(7) - 3*(7) - 32*(2)) / (1))), (fun p0 => ((-11*p0 - 4*(9) - 5*(7) + (7) + 16*(2)) / (1))), (fun p0 => (((9)) / (1))), (fun p0 => ((p0) / (1))); met) | (exists ((-8*(1) - 2*(1) - 8*(1) + 2*(1) + 16*(1)) / (1)), ((18*(1) + 5*(1) + 14*(1) - 3*(1) - 32*(1)) / (1)), ((-11*(1) - 4*(1) - 5*(1) + (1) + 16*(1)) / (1)), (((1)) / (1)), (((1)) / (1)), 1, 1, 1, 1, 1, (1 / 3), (fun p0 => ((-8*p0 - 2*(1) - 8*(1) + 2*(1) + 16*(1)) / (1))), (fun p0 => ((18*p0 + 5*(1) + 14*(1) - 3*(1) - 32*(1)) / (1))), (fun p0 => ((-11*p0 - 4*(1) - 5*(1) + (1) + 16*(1)) / (1))), (fun p0 => (((1)) / (1))), (fun p0 => ((p0) / (1))); met)]. Qed.
End eq_2_3_H1.

Module eq_2_3_H2.
Import HermiteDevelopable.Section_2.eq_2_3_H2.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quartic; stage quartic_conditions; stage quartic_conditions_; stage quartic_; stage quartic_conditions__; stage quartic_conditions___; stage quartic_conditions____; stage quartic_conditions_____; stage quartic_conditions______; stage quartic_conditions_______; stage quartic_conditions________; staged_goal quartic_conditions_________; unstaged; computed; intros; along (forall pm : R, A_of_pm pm = ((-8*p0 - 2*p0u - 8*p1 + 2*p1u + 16*pm) / (1)) /\ B_of_pm pm = ((18*p0 + 5*p0u + 14*p1 - 3*p1u - 32*pm) / (1)) /\ C__of_pm pm = ((-11*p0 - 4*p0u - 5*p1 + p1u + 16*pm) / (1)) /\ E__of_pm pm = ((p0u) / (1)) /\ F_of_pm pm = ((p0) / (1))); function A_of_pm; function B_of_pm; function C__of_pm; function E__of_pm; function F_of_pm; conclusion; prepared; known (A) (-8*p0 - 2*p0u - 8*p1 + 2*p1u + 16*pm) (1); known (B) (18*p0 + 5*p0u + 14*p1 - 3*p1u - 32*pm) (1); known (C_) (-11*p0 - 4*p0u - 5*p1 + p1u + 16*pm) (1); known (E_) (p0u) (1); known (F) (p0) (1); put_known; concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quartic; stage quartic_conditions; stage quartic_conditions_; stage quartic_; stage quartic_conditions__; stage quartic_conditions___; stage quartic_conditions____; stage quartic_conditions_____; stage quartic_conditions______; stage quartic_conditions_______; stage quartic_conditions________; staged_goal quartic_conditions_________; unstaged; first [(exists ((-8*(7) - 2*(8) - 8*(9) + 2*(10) + 16*(11)) / (1)), ((18*(7) + 5*(8) + 14*(9) - 3*(10) - 32*(11)) / (1)), ((-11*(7) - 4*(8) - 5*(9) + (10) + 16*(11)) / (1)), (((8)) / (1)), (((7)) / (1)), 7, 8, 9, 10, 11, (1 / 3), (fun pm => ((-8*(7) - 2*(8) - 8*(9) + 2*(10) + 16*pm) / (1))), (fun pm => ((18*(7) + 5*(8) + 14*(9) - 3*(10) - 32*pm) / (1))), (fun pm => ((-11*(7) - 4*(8) - 5*(9) + (10) + 16*pm) / (1))), (fun pm => (((8)) / (1))), (fun pm => (((7)) / (1))); met) | (exists ((-8*(0) - 2*(0) - 8*(0) + 2*(0) + 16*(0)) / (1)), ((18*(0) + 5*(0) + 14*(0) - 3*(0) - 32*(0)) / (1)), ((-11*(0) - 4*(0) - 5*(0) + (0) + 16*(0)) / (1)), (((0)) / (1)), (((0)) / (1)), 0, 0, 0, 0, 0, (1 / 2), (fun pm => ((-8*(0) - 2*(0) - 8*(0) + 2*(0) + 16*pm) / (1))), (fun pm => ((18*(0) + 5*(0) + 14*(0) - 3*(0) - 32*pm) / (1))), (fun pm => ((-11*(0) - 4*(0) - 5*(0) + (0) + 16*pm) / (1))), (fun pm => (((0)) / (1))), (fun pm => (((0)) / (1))); met) | (exists ((-8*(7) - 2*(9) - 8*(7) + 2*(7) + 16*(2)) / (1)), ((18*(7) + 5*(9) + 14*(7) - 3*(7) - 32*(2)) / (1)), ((-11*(7) - 4*(9) - 5*(7) + (7) + 16*(2)) / (1)), (((9)) / (1)), (((7)) / (1)), 7, 9, 7, 7, 2, (1 / 3), (fun pm => ((-8*(7) - 2*(9) - 8*(7) + 2*(7) + 16*pm) / (1))), (fun pm => ((18*(7) + 5*(9) + 14*(7) - 3*(7) - 32*pm) / (1))), (fun pm => ((-11*(7) - 4*(9) - 5*(7) + (7) + 16*pm) / (1))), (fun pm => (((9)) / (1))), (fun pm => (((7)) / (1))); met) | (exists ((-8*(1) - 2*(1) - 8*(1) + 2*(1) + 16*(1)) / (1)), ((18*(1) + 5*(1) + 14*(1) - 3*(1) - 32*(1)) / (1)), ((-11*(1) - 4*(1) - 5*(1) + (1) + 16*(1)) / (1)), (((1)) / (1)), (((1)) / (1)), 1, 1, 1, 1, 1, (1 / 3), (fun pm => ((-8*(1) - 2*(1) - 8*(1) + 2*(1) + 16*pm) / (1))), (fun pm => ((18*(1) + 5*(1) + 14*(1) - 3*(1) - 32*pm) / (1))), (fun pm => ((-11*(1) - 4*(1) - 5*(1) + (1) + 16*pm) / (1))), (fun pm => (((1)) / (1))), (fun pm => (((1)) / (1))); met)]. Qed.
End eq_2_3_H2.

Module eq_2_3_H3.
Import HermiteDevelopable.Section_2.eq_2_3_H3.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quartic; stage quartic_conditions; stage quartic_conditions_; stage quartic_; stage quartic_conditions__; stage quartic_conditions___; stage quartic_conditions____; stage quartic_conditions_____; stage quartic_conditions______; stage quartic_conditions_______; stage quartic_conditions________; staged_goal quartic_conditions_________; unstaged; computed; intros; along (forall p1 : R, A_of_p1 p1 = ((-8*p0 - 2*p0u - 8*p1 + 2*p1u + 16*pm) / (1)) /\ B_of_p1 p1 = ((18*p0 + 5*p0u + 14*p1 - 3*p1u - 32*pm) / (1)) /\ C__of_p1 p1 = ((-11*p0 - 4*p0u - 5*p1 + p1u + 16*pm) / (1)) /\ E__of_p1 p1 = ((p0u) / (1)) /\ F_of_p1 p1 = ((p0) / (1))); function A_of_p1; function B_of_p1; function C__of_p1; function E__of_p1; function F_of_p1; conclusion; prepared; known (A) (-8*p0 - 2*p0u - 8*p1 + 2*p1u + 16*pm) (1); known (B) (18*p0 + 5*p0u + 14*p1 - 3*p1u - 32*pm) (1); known (C_) (-11*p0 - 4*p0u - 5*p1 + p1u + 16*pm) (1); known (E_) (p0u) (1); known (F) (p0) (1); put_known; concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quartic; stage quartic_conditions; stage quartic_conditions_; stage quartic_; stage quartic_conditions__; stage quartic_conditions___; stage quartic_conditions____; stage quartic_conditions_____; stage quartic_conditions______; stage quartic_conditions_______; stage quartic_conditions________; staged_goal quartic_conditions_________; unstaged; first [(exists ((-8*(7) - 2*(8) - 8*(9) + 2*(10) + 16*(11)) / (1)), ((18*(7) + 5*(8) + 14*(9) - 3*(10) - 32*(11)) / (1)), ((-11*(7) - 4*(8) - 5*(9) + (10) + 16*(11)) / (1)), (((8)) / (1)), (((7)) / (1)), 7, 8, 9, 10, 11, (1 / 3), (fun p1 => ((-8*(7) - 2*(8) - 8*p1 + 2*(10) + 16*(11)) / (1))), (fun p1 => ((18*(7) + 5*(8) + 14*p1 - 3*(10) - 32*(11)) / (1))), (fun p1 => ((-11*(7) - 4*(8) - 5*p1 + (10) + 16*(11)) / (1))), (fun p1 => (((8)) / (1))), (fun p1 => (((7)) / (1))); met) | (exists ((-8*(0) - 2*(0) - 8*(0) + 2*(0) + 16*(0)) / (1)), ((18*(0) + 5*(0) + 14*(0) - 3*(0) - 32*(0)) / (1)), ((-11*(0) - 4*(0) - 5*(0) + (0) + 16*(0)) / (1)), (((0)) / (1)), (((0)) / (1)), 0, 0, 0, 0, 0, (1 / 2), (fun p1 => ((-8*(0) - 2*(0) - 8*p1 + 2*(0) + 16*(0)) / (1))), (fun p1 => ((18*(0) + 5*(0) + 14*p1 - 3*(0) - 32*(0)) / (1))), (fun p1 => ((-11*(0) - 4*(0) - 5*p1 + (0) + 16*(0)) / (1))), (fun p1 => (((0)) / (1))), (fun p1 => (((0)) / (1))); met) | (exists ((-8*(7) - 2*(9) - 8*(7) + 2*(7) + 16*(2)) / (1)), ((18*(7) + 5*(9) + 14*(7) - 3*(7) - 32*(2)) / (1)), ((-11*(7) - 4*(9) - 5*(7) + (7) + 16*(2)) / (1)), (((9)) / (1)), (((7)) / (1)), 7, 9, 7, 7, 2, (1 / 3), (fun p1 => ((-8*(7) - 2*(9) - 8*p1 + 2*(7) + 16*(2)) / (1))), (fun p1 => ((18*(7) + 5*(9) + 14*p1 - 3*(7) - 32*(2)) / (1))), (fun p1 => ((-11*(7) - 4*(9) - 5*p1 + (7) + 16*(2)) / (1))), (fun p1 => (((9)) / (1))), (fun p1 => (((7)) / (1))); met) | (exists ((-8*(1) - 2*(1) - 8*(1) + 2*(1) + 16*(1)) / (1)), ((18*(1) + 5*(1) + 14*(1) - 3*(1) - 32*(1)) / (1)), ((-11*(1) - 4*(1) - 5*(1) + (1) + 16*(1)) / (1)), (((1)) / (1)), (((1)) / (1)), 1, 1, 1, 1, 1, (1 / 3), (fun p1 => ((-8*(1) - 2*(1) - 8*p1 + 2*(1) + 16*(1)) / (1))), (fun p1 => ((18*(1) + 5*(1) + 14*p1 - 3*(1) - 32*(1)) / (1))), (fun p1 => ((-11*(1) - 4*(1) - 5*p1 + (1) + 16*(1)) / (1))), (fun p1 => (((1)) / (1))), (fun p1 => (((1)) / (1))); met)]. Qed.
End eq_2_3_H3.

Module eq_2_3_H4.
Import HermiteDevelopable.Section_2.eq_2_3_H4.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quartic; stage quartic_conditions; stage quartic_conditions_; stage quartic_; stage quartic_conditions__; stage quartic_conditions___; stage quartic_conditions____; stage quartic_conditions_____; stage quartic_conditions______; stage quartic_conditions_______; stage quartic_conditions________; staged_goal quartic_conditions_________; unstaged; computed; intros; along (forall p0u : R, A_of_p0u p0u = ((-8*p0 - 2*p0u - 8*p1 + 2*p1u + 16*pm) / (1)) /\ B_of_p0u p0u = ((18*p0 + 5*p0u + 14*p1 - 3*p1u - 32*pm) / (1)) /\ C__of_p0u p0u = ((-11*p0 - 4*p0u - 5*p1 + p1u + 16*pm) / (1)) /\ E__of_p0u p0u = ((p0u) / (1)) /\ F_of_p0u p0u = ((p0) / (1))); function A_of_p0u; function B_of_p0u; function C__of_p0u; function E__of_p0u; function F_of_p0u; conclusion; prepared; known (A) (-8*p0 - 2*p0u - 8*p1 + 2*p1u + 16*pm) (1); known (B) (18*p0 + 5*p0u + 14*p1 - 3*p1u - 32*pm) (1); known (C_) (-11*p0 - 4*p0u - 5*p1 + p1u + 16*pm) (1); known (E_) (p0u) (1); known (F) (p0) (1); put_known; concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quartic; stage quartic_conditions; stage quartic_conditions_; stage quartic_; stage quartic_conditions__; stage quartic_conditions___; stage quartic_conditions____; stage quartic_conditions_____; stage quartic_conditions______; stage quartic_conditions_______; stage quartic_conditions________; staged_goal quartic_conditions_________; unstaged; first [(exists ((-8*(7) - 2*(8) - 8*(9) + 2*(10) + 16*(11)) / (1)), ((18*(7) + 5*(8) + 14*(9) - 3*(10) - 32*(11)) / (1)), ((-11*(7) - 4*(8) - 5*(9) + (10) + 16*(11)) / (1)), (((8)) / (1)), (((7)) / (1)), 7, 8, 9, 10, 11, (1 / 3), (fun p0u => ((-8*(7) - 2*p0u - 8*(9) + 2*(10) + 16*(11)) / (1))), (fun p0u => ((18*(7) + 5*p0u + 14*(9) - 3*(10) - 32*(11)) / (1))), (fun p0u => ((-11*(7) - 4*p0u - 5*(9) + (10) + 16*(11)) / (1))), (fun p0u => ((p0u) / (1))), (fun p0u => (((7)) / (1))); met) | (exists ((-8*(0) - 2*(0) - 8*(0) + 2*(0) + 16*(0)) / (1)), ((18*(0) + 5*(0) + 14*(0) - 3*(0) - 32*(0)) / (1)), ((-11*(0) - 4*(0) - 5*(0) + (0) + 16*(0)) / (1)), (((0)) / (1)), (((0)) / (1)), 0, 0, 0, 0, 0, (1 / 2), (fun p0u => ((-8*(0) - 2*p0u - 8*(0) + 2*(0) + 16*(0)) / (1))), (fun p0u => ((18*(0) + 5*p0u + 14*(0) - 3*(0) - 32*(0)) / (1))), (fun p0u => ((-11*(0) - 4*p0u - 5*(0) + (0) + 16*(0)) / (1))), (fun p0u => ((p0u) / (1))), (fun p0u => (((0)) / (1))); met) | (exists ((-8*(7) - 2*(9) - 8*(7) + 2*(7) + 16*(2)) / (1)), ((18*(7) + 5*(9) + 14*(7) - 3*(7) - 32*(2)) / (1)), ((-11*(7) - 4*(9) - 5*(7) + (7) + 16*(2)) / (1)), (((9)) / (1)), (((7)) / (1)), 7, 9, 7, 7, 2, (1 / 3), (fun p0u => ((-8*(7) - 2*p0u - 8*(7) + 2*(7) + 16*(2)) / (1))), (fun p0u => ((18*(7) + 5*p0u + 14*(7) - 3*(7) - 32*(2)) / (1))), (fun p0u => ((-11*(7) - 4*p0u - 5*(7) + (7) + 16*(2)) / (1))), (fun p0u => ((p0u) / (1))), (fun p0u => (((7)) / (1))); met) | (exists ((-8*(1) - 2*(1) - 8*(1) + 2*(1) + 16*(1)) / (1)), ((18*(1) + 5*(1) + 14*(1) - 3*(1) - 32*(1)) / (1)), ((-11*(1) - 4*(1) - 5*(1) + (1) + 16*(1)) / (1)), (((1)) / (1)), (((1)) / (1)), 1, 1, 1, 1, 1, (1 / 3), (fun p0u => ((-8*(1) - 2*p0u - 8*(1) + 2*(1) + 16*(1)) / (1))), (fun p0u => ((18*(1) + 5*p0u + 14*(1) - 3*(1) - 32*(1)) / (1))), (fun p0u => ((-11*(1) - 4*p0u - 5*(1) + (1) + 16*(1)) / (1))), (fun p0u => ((p0u) / (1))), (fun p0u => (((1)) / (1))); met)]. Qed.
End eq_2_3_H4.

Module eq_2_3_H5.
Import HermiteDevelopable.Section_2.eq_2_3_H5.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage quartic; stage quartic_conditions; stage quartic_conditions_; stage quartic_; stage quartic_conditions__; stage quartic_conditions___; stage quartic_conditions____; stage quartic_conditions_____; stage quartic_conditions______; stage quartic_conditions_______; stage quartic_conditions________; staged_goal quartic_conditions_________; unstaged; computed; intros; along (forall p1u : R, A_of_p1u p1u = ((-8*p0 - 2*p0u - 8*p1 + 2*p1u + 16*pm) / (1)) /\ B_of_p1u p1u = ((18*p0 + 5*p0u + 14*p1 - 3*p1u - 32*pm) / (1)) /\ C__of_p1u p1u = ((-11*p0 - 4*p0u - 5*p1 + p1u + 16*pm) / (1)) /\ E__of_p1u p1u = ((p0u) / (1)) /\ F_of_p1u p1u = ((p0) / (1))); function A_of_p1u; function B_of_p1u; function C__of_p1u; function E__of_p1u; function F_of_p1u; conclusion; prepared; known (A) (-8*p0 - 2*p0u - 8*p1 + 2*p1u + 16*pm) (1); known (B) (18*p0 + 5*p0u + 14*p1 - 3*p1u - 32*pm) (1); known (C_) (-11*p0 - 4*p0u - 5*p1 + p1u + 16*pm) (1); known (E_) (p0u) (1); known (F) (p0) (1); put_known; concluded. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; stage quartic; stage quartic_conditions; stage quartic_conditions_; stage quartic_; stage quartic_conditions__; stage quartic_conditions___; stage quartic_conditions____; stage quartic_conditions_____; stage quartic_conditions______; stage quartic_conditions_______; stage quartic_conditions________; staged_goal quartic_conditions_________; unstaged; first [(exists ((-8*(7) - 2*(8) - 8*(9) + 2*(10) + 16*(11)) / (1)), ((18*(7) + 5*(8) + 14*(9) - 3*(10) - 32*(11)) / (1)), ((-11*(7) - 4*(8) - 5*(9) + (10) + 16*(11)) / (1)), (((8)) / (1)), (((7)) / (1)), 7, 8, 9, 10, 11, (1 / 3), (fun p1u => ((-8*(7) - 2*(8) - 8*(9) + 2*p1u + 16*(11)) / (1))), (fun p1u => ((18*(7) + 5*(8) + 14*(9) - 3*p1u - 32*(11)) / (1))), (fun p1u => ((-11*(7) - 4*(8) - 5*(9) + p1u + 16*(11)) / (1))), (fun p1u => (((8)) / (1))), (fun p1u => (((7)) / (1))); met) | (exists ((-8*(0) - 2*(0) - 8*(0) + 2*(0) + 16*(0)) / (1)), ((18*(0) + 5*(0) + 14*(0) - 3*(0) - 32*(0)) / (1)), ((-11*(0) - 4*(0) - 5*(0) + (0) + 16*(0)) / (1)), (((0)) / (1)), (((0)) / (1)), 0, 0, 0, 0, 0, (1 / 2), (fun p1u => ((-8*(0) - 2*(0) - 8*(0) + 2*p1u + 16*(0)) / (1))), (fun p1u => ((18*(0) + 5*(0) + 14*(0) - 3*p1u - 32*(0)) / (1))), (fun p1u => ((-11*(0) - 4*(0) - 5*(0) + p1u + 16*(0)) / (1))), (fun p1u => (((0)) / (1))), (fun p1u => (((0)) / (1))); met) | (exists ((-8*(7) - 2*(9) - 8*(7) + 2*(7) + 16*(2)) / (1)), ((18*(7) + 5*(9) + 14*(7) - 3*(7) - 32*(2)) / (1)), ((-11*(7) - 4*(9) - 5*(7) + (7) + 16*(2)) / (1)), (((9)) / (1)), (((7)) / (1)), 7, 9, 7, 7, 2, (1 / 3), (fun p1u => ((-8*(7) - 2*(9) - 8*(7) + 2*p1u + 16*(2)) / (1))), (fun p1u => ((18*(7) + 5*(9) + 14*(7) - 3*p1u - 32*(2)) / (1))), (fun p1u => ((-11*(7) - 4*(9) - 5*(7) + p1u + 16*(2)) / (1))), (fun p1u => (((9)) / (1))), (fun p1u => (((7)) / (1))); met) | (exists ((-8*(1) - 2*(1) - 8*(1) + 2*(1) + 16*(1)) / (1)), ((18*(1) + 5*(1) + 14*(1) - 3*(1) - 32*(1)) / (1)), ((-11*(1) - 4*(1) - 5*(1) + (1) + 16*(1)) / (1)), (((1)) / (1)), (((1)) / (1)), 1, 1, 1, 1, 1, (1 / 3), (fun p1u => ((-8*(1) - 2*(1) - 8*(1) + 2*p1u + 16*(1)) / (1))), (fun p1u => ((18*(1) + 5*(1) + 14*(1) - 3*p1u - 32*(1)) / (1))), (fun p1u => ((-11*(1) - 4*(1) - 5*(1) + p1u + 16*(1)) / (1))), (fun p1u => (((1)) / (1))), (fun p1u => (((1)) / (1))); met)]. Qed.
End eq_2_3_H5.
