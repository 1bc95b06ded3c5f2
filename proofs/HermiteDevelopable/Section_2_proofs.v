(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages.
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
