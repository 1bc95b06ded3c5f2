(* The kernel's word: each theorem has the type of its statement. *)
From HermiteDevelopable Require Part_Abstract_printed Part_Abstract_printed_proofs.
From HermiteDevelopable Require Part_Abstract Part_Abstract_proofs.
From HermiteDevelopable Require Section_1_printed Section_1_printed_proofs.
From HermiteDevelopable Require Section_1 Section_1_proofs.
From HermiteDevelopable Require Section_2_printed Section_2_printed_proofs.
From HermiteDevelopable Require Section_2 Section_2_proofs.
From HermiteDevelopable Require Section_3_1_printed Section_3_1_printed_proofs.
From HermiteDevelopable Require Section_3_1 Section_3_1_proofs.
From HermiteDevelopable Require Section_3_2_printed Section_3_2_printed_proofs.
From HermiteDevelopable Require Section_3_2 Section_3_2_proofs.
From HermiteDevelopable Require Section_3_3_printed Section_3_3_printed_proofs.
From HermiteDevelopable Require Section_3_3 Section_3_3_proofs.
From HermiteDevelopable Require Section_3_printed Section_3_printed_proofs.
From HermiteDevelopable Require Section_3 Section_3_proofs.
From HermiteDevelopable Require Section_4_printed Section_4_printed_proofs.
From HermiteDevelopable Require Section_4 Section_4_proofs.
From HermiteDevelopable Require Section_5_printed Section_5_printed_proofs.
From HermiteDevelopable Require Section_5 Section_5_proofs.
Check (Part_Abstract_printed_proofs.abs_construct_a.proved : Part_Abstract_printed.abs_construct_a.statement).
Check (Part_Abstract_printed_proofs.abs_construct_a.met : Part_Abstract_printed.abs_construct_a.instance).
Check (Part_Abstract_printed_proofs.abs_construct_b.proved : Part_Abstract_printed.abs_construct_b.statement).
Check (Part_Abstract_printed_proofs.abs_construct_b.met : Part_Abstract_printed.abs_construct_b.instance).
Check (Part_Abstract_printed_proofs.abs_construct_c.proved : Part_Abstract_printed.abs_construct_c.statement).
Check (Part_Abstract_printed_proofs.abs_construct_c.met : Part_Abstract_printed.abs_construct_c.instance).
Check (Part_Abstract_printed_proofs.abs_construct_d.refuted : ~ Part_Abstract_printed.abs_construct_d.statement).
Check (Part_Abstract_proofs.abs_construct_a.proved : Part_Abstract.abs_construct_a.statement).
Check (Part_Abstract_proofs.abs_construct_a.met : Part_Abstract.abs_construct_a.instance).
Check (Part_Abstract_proofs.abs_construct_b.proved : Part_Abstract.abs_construct_b.statement).
Check (Part_Abstract_proofs.abs_construct_b.met : Part_Abstract.abs_construct_b.instance).
Check (Part_Abstract_proofs.abs_construct_c.proved : Part_Abstract.abs_construct_c.statement).
Check (Part_Abstract_proofs.abs_construct_c.met : Part_Abstract.abs_construct_c.instance).
Check (Part_Abstract_proofs.abs_construct_d.refuted : ~ Part_Abstract.abs_construct_d.statement).
Check (Section_1_printed_proofs.sec_1_parallel_tangents.proved : Section_1_printed.sec_1_parallel_tangents.statement).
Check (Section_1_printed_proofs.sec_1_parallel_tangents.met : Section_1_printed.sec_1_parallel_tangents.instance).
Check (Section_1_proofs.sec_1_parallel_tangents.proved : Section_1.sec_1_parallel_tangents.statement).
Check (Section_1_proofs.sec_1_parallel_tangents.met : Section_1.sec_1_parallel_tangents.instance).
Check (Section_2_printed_proofs.sec_2_cubic_conditions.proved : Section_2_printed.sec_2_cubic_conditions.statement).
Check (Section_2_printed_proofs.sec_2_cubic_conditions.met : Section_2_printed.sec_2_cubic_conditions.instance).
Check (Section_2_printed_proofs.sec_2_cubic_equations.proved : Section_2_printed.sec_2_cubic_equations.statement).
Check (Section_2_printed_proofs.sec_2_cubic_a1.proved : Section_2_printed.sec_2_cubic_a1.statement).
Check (Section_2_printed_proofs.sec_2_cubic_a1.met : Section_2_printed.sec_2_cubic_a1.instance).
Check (Section_2_printed_proofs.sec_2_cubic_b1.proved : Section_2_printed.sec_2_cubic_b1.statement).
Check (Section_2_printed_proofs.sec_2_cubic_b1.met : Section_2_printed.sec_2_cubic_b1.instance).
Check (Section_2_printed_proofs.sec_2_cubic_c1.proved : Section_2_printed.sec_2_cubic_c1.statement).
Check (Section_2_printed_proofs.sec_2_cubic_c1.met : Section_2_printed.sec_2_cubic_c1.instance).
Check (Section_2_printed_proofs.sec_2_cubic_d1.proved : Section_2_printed.sec_2_cubic_d1.statement).
Check (Section_2_printed_proofs.sec_2_cubic_d1.met : Section_2_printed.sec_2_cubic_d1.instance).
Check (Section_2_printed_proofs.eq_2_1a.proved : Section_2_printed.eq_2_1a.statement).
Check (Section_2_printed_proofs.eq_2_1a.met : Section_2_printed.eq_2_1a.instance).
Check (Section_2_printed_proofs.eq_2_1b.proved : Section_2_printed.eq_2_1b.statement).
Check (Section_2_printed_proofs.eq_2_1b.met : Section_2_printed.eq_2_1b.instance).
Check (Section_2_printed_proofs.eq_2_1b_H1.proved : Section_2_printed.eq_2_1b_H1.statement).
Check (Section_2_printed_proofs.eq_2_1b_H1.met : Section_2_printed.eq_2_1b_H1.instance).
Check (Section_2_printed_proofs.eq_2_1b_H2.proved : Section_2_printed.eq_2_1b_H2.statement).
Check (Section_2_printed_proofs.eq_2_1b_H2.met : Section_2_printed.eq_2_1b_H2.instance).
Check (Section_2_printed_proofs.eq_2_1b_H3.proved : Section_2_printed.eq_2_1b_H3.statement).
Check (Section_2_printed_proofs.eq_2_1b_H3.met : Section_2_printed.eq_2_1b_H3.instance).
Check (Section_2_printed_proofs.eq_2_1b_H4.proved : Section_2_printed.eq_2_1b_H4.statement).
Check (Section_2_printed_proofs.eq_2_1b_H4.met : Section_2_printed.eq_2_1b_H4.instance).
Check (Section_2_printed_proofs.sec_2_quartic_conditions.proved : Section_2_printed.sec_2_quartic_conditions.statement).
Check (Section_2_printed_proofs.sec_2_quartic_conditions.met : Section_2_printed.sec_2_quartic_conditions.instance).
Check (Section_2_printed_proofs.sec_2_quartic_solvable.proved : Section_2_printed.sec_2_quartic_solvable.statement).
Check (Section_2_printed_proofs.sec_2_quartic_a1.proved : Section_2_printed.sec_2_quartic_a1.statement).
Check (Section_2_printed_proofs.sec_2_quartic_a1.met : Section_2_printed.sec_2_quartic_a1.instance).
Check (Section_2_printed_proofs.sec_2_quartic_b1.proved : Section_2_printed.sec_2_quartic_b1.statement).
Check (Section_2_printed_proofs.sec_2_quartic_b1.met : Section_2_printed.sec_2_quartic_b1.instance).
Check (Section_2_printed_proofs.sec_2_quartic_third.refuted : ~ Section_2_printed.sec_2_quartic_third.statement).
Check (Section_2_printed_proofs.sec_2_quartic_third_corrected.proved : Section_2_printed.sec_2_quartic_third_corrected.statement).
Check (Section_2_printed_proofs.sec_2_quartic_third_corrected.met : Section_2_printed.sec_2_quartic_third_corrected.instance).
Check (Section_2_printed_proofs.sec_2_quartic_d1.proved : Section_2_printed.sec_2_quartic_d1.statement).
Check (Section_2_printed_proofs.sec_2_quartic_d1.met : Section_2_printed.sec_2_quartic_d1.instance).
Check (Section_2_printed_proofs.sec_2_quartic_e1.proved : Section_2_printed.sec_2_quartic_e1.statement).
Check (Section_2_printed_proofs.sec_2_quartic_e1.met : Section_2_printed.sec_2_quartic_e1.instance).
Check (Section_2_printed_proofs.eq_2_2.proved : Section_2_printed.eq_2_2.statement).
Check (Section_2_printed_proofs.eq_2_2.met : Section_2_printed.eq_2_2.instance).
Check (Section_2_printed_proofs.eq_2_3.refuted : ~ Section_2_printed.eq_2_3.statement).
Check (Section_2_printed_proofs.eq_2_3_corrected.proved : Section_2_printed.eq_2_3_corrected.statement).
Check (Section_2_printed_proofs.eq_2_3_corrected.met : Section_2_printed.eq_2_3_corrected.instance).
Check (Section_2_printed_proofs.eq_2_3_H1.proved : Section_2_printed.eq_2_3_H1.statement).
Check (Section_2_printed_proofs.eq_2_3_H1.met : Section_2_printed.eq_2_3_H1.instance).
Check (Section_2_printed_proofs.eq_2_3_H2.proved : Section_2_printed.eq_2_3_H2.statement).
Check (Section_2_printed_proofs.eq_2_3_H2.met : Section_2_printed.eq_2_3_H2.instance).
Check (Section_2_printed_proofs.eq_2_3_H3.proved : Section_2_printed.eq_2_3_H3.statement).
Check (Section_2_printed_proofs.eq_2_3_H3.met : Section_2_printed.eq_2_3_H3.instance).
Check (Section_2_printed_proofs.eq_2_3_H4.proved : Section_2_printed.eq_2_3_H4.statement).
Check (Section_2_printed_proofs.eq_2_3_H4.met : Section_2_printed.eq_2_3_H4.instance).
Check (Section_2_printed_proofs.eq_2_3_H5.proved : Section_2_printed.eq_2_3_H5.statement).
Check (Section_2_printed_proofs.eq_2_3_H5.met : Section_2_printed.eq_2_3_H5.instance).
Check (Section_2_printed_proofs.sec_2_quintic_conditions.proved : Section_2_printed.sec_2_quintic_conditions.statement).
Check (Section_2_printed_proofs.sec_2_quintic_conditions.met : Section_2_printed.sec_2_quintic_conditions.instance).
Check (Section_2_printed_proofs.sec_2_quintic_a1.proved : Section_2_printed.sec_2_quintic_a1.statement).
Check (Section_2_printed_proofs.sec_2_quintic_a1.met : Section_2_printed.sec_2_quintic_a1.instance).
Check (Section_2_printed_proofs.sec_2_quintic_b1.proved : Section_2_printed.sec_2_quintic_b1.statement).
Check (Section_2_printed_proofs.sec_2_quintic_b1.met : Section_2_printed.sec_2_quintic_b1.instance).
Check (Section_2_printed_proofs.sec_2_quintic_c1.proved : Section_2_printed.sec_2_quintic_c1.statement).
Check (Section_2_printed_proofs.sec_2_quintic_c1.met : Section_2_printed.sec_2_quintic_c1.instance).
Check (Section_2_printed_proofs.sec_2_quintic_d1.proved : Section_2_printed.sec_2_quintic_d1.statement).
Check (Section_2_printed_proofs.sec_2_quintic_d1.met : Section_2_printed.sec_2_quintic_d1.instance).
Check (Section_2_printed_proofs.sec_2_quintic_e1.proved : Section_2_printed.sec_2_quintic_e1.statement).
Check (Section_2_printed_proofs.sec_2_quintic_e1.met : Section_2_printed.sec_2_quintic_e1.instance).
Check (Section_2_printed_proofs.sec_2_quintic_f1.proved : Section_2_printed.sec_2_quintic_f1.statement).
Check (Section_2_printed_proofs.sec_2_quintic_f1.met : Section_2_printed.sec_2_quintic_f1.instance).
Check (Section_2_printed_proofs.eq_2_4.proved : Section_2_printed.eq_2_4.statement).
Check (Section_2_printed_proofs.eq_2_4.met : Section_2_printed.eq_2_4.instance).
Check (Section_2_printed_proofs.sec_2_control.proved : Section_2_printed.sec_2_control.statement).
Check (Section_2_printed_proofs.sec_2_control.met : Section_2_printed.sec_2_control.instance).
Check (Section_2_printed_proofs.fig_1b_middle.proved : Section_2_printed.fig_1b_middle.statement).
Check (Section_2_printed_proofs.fig_1b_middle.met : Section_2_printed.fig_1b_middle.instance).
Check (Section_2_proofs.sec_2_cubic_conditions.proved : Section_2.sec_2_cubic_conditions.statement).
Check (Section_2_proofs.sec_2_cubic_conditions.met : Section_2.sec_2_cubic_conditions.instance).
Check (Section_2_proofs.sec_2_cubic_equations.proved : Section_2.sec_2_cubic_equations.statement).
Check (Section_2_proofs.sec_2_cubic_a1.proved : Section_2.sec_2_cubic_a1.statement).
Check (Section_2_proofs.sec_2_cubic_a1.met : Section_2.sec_2_cubic_a1.instance).
Check (Section_2_proofs.sec_2_cubic_b1.proved : Section_2.sec_2_cubic_b1.statement).
Check (Section_2_proofs.sec_2_cubic_b1.met : Section_2.sec_2_cubic_b1.instance).
Check (Section_2_proofs.sec_2_cubic_c1.proved : Section_2.sec_2_cubic_c1.statement).
Check (Section_2_proofs.sec_2_cubic_c1.met : Section_2.sec_2_cubic_c1.instance).
Check (Section_2_proofs.sec_2_cubic_d1.proved : Section_2.sec_2_cubic_d1.statement).
Check (Section_2_proofs.sec_2_cubic_d1.met : Section_2.sec_2_cubic_d1.instance).
Check (Section_2_proofs.eq_2_1a.proved : Section_2.eq_2_1a.statement).
Check (Section_2_proofs.eq_2_1a.met : Section_2.eq_2_1a.instance).
Check (Section_2_proofs.eq_2_1b.proved : Section_2.eq_2_1b.statement).
Check (Section_2_proofs.eq_2_1b.met : Section_2.eq_2_1b.instance).
Check (Section_2_proofs.eq_2_1b_H1.proved : Section_2.eq_2_1b_H1.statement).
Check (Section_2_proofs.eq_2_1b_H1.met : Section_2.eq_2_1b_H1.instance).
Check (Section_2_proofs.eq_2_1b_H2.proved : Section_2.eq_2_1b_H2.statement).
Check (Section_2_proofs.eq_2_1b_H2.met : Section_2.eq_2_1b_H2.instance).
Check (Section_2_proofs.eq_2_1b_H3.proved : Section_2.eq_2_1b_H3.statement).
Check (Section_2_proofs.eq_2_1b_H3.met : Section_2.eq_2_1b_H3.instance).
Check (Section_2_proofs.eq_2_1b_H4.proved : Section_2.eq_2_1b_H4.statement).
Check (Section_2_proofs.eq_2_1b_H4.met : Section_2.eq_2_1b_H4.instance).
Check (Section_2_proofs.sec_2_quartic_conditions.proved : Section_2.sec_2_quartic_conditions.statement).
Check (Section_2_proofs.sec_2_quartic_conditions.met : Section_2.sec_2_quartic_conditions.instance).
Check (Section_2_proofs.sec_2_quartic_solvable.proved : Section_2.sec_2_quartic_solvable.statement).
Check (Section_2_proofs.sec_2_quartic_a1.proved : Section_2.sec_2_quartic_a1.statement).
Check (Section_2_proofs.sec_2_quartic_a1.met : Section_2.sec_2_quartic_a1.instance).
Check (Section_2_proofs.sec_2_quartic_b1.proved : Section_2.sec_2_quartic_b1.statement).
Check (Section_2_proofs.sec_2_quartic_b1.met : Section_2.sec_2_quartic_b1.instance).
Check (Section_2_proofs.sec_2_quartic_third.refuted : ~ Section_2.sec_2_quartic_third.statement).
Check (Section_2_proofs.sec_2_quartic_third_corrected.proved : Section_2.sec_2_quartic_third_corrected.statement).
Check (Section_2_proofs.sec_2_quartic_third_corrected.met : Section_2.sec_2_quartic_third_corrected.instance).
Check (Section_2_proofs.sec_2_quartic_d1.proved : Section_2.sec_2_quartic_d1.statement).
Check (Section_2_proofs.sec_2_quartic_d1.met : Section_2.sec_2_quartic_d1.instance).
Check (Section_2_proofs.sec_2_quartic_e1.proved : Section_2.sec_2_quartic_e1.statement).
Check (Section_2_proofs.sec_2_quartic_e1.met : Section_2.sec_2_quartic_e1.instance).
Check (Section_2_proofs.eq_2_2.proved : Section_2.eq_2_2.statement).
Check (Section_2_proofs.eq_2_2.met : Section_2.eq_2_2.instance).
Check (Section_2_proofs.eq_2_3.refuted : ~ Section_2.eq_2_3.statement).
Check (Section_2_proofs.eq_2_3_corrected.proved : Section_2.eq_2_3_corrected.statement).
Check (Section_2_proofs.eq_2_3_corrected.met : Section_2.eq_2_3_corrected.instance).
Check (Section_2_proofs.eq_2_3_H1.proved : Section_2.eq_2_3_H1.statement).
Check (Section_2_proofs.eq_2_3_H1.met : Section_2.eq_2_3_H1.instance).
Check (Section_2_proofs.eq_2_3_H2.proved : Section_2.eq_2_3_H2.statement).
Check (Section_2_proofs.eq_2_3_H2.met : Section_2.eq_2_3_H2.instance).
Check (Section_2_proofs.eq_2_3_H3.proved : Section_2.eq_2_3_H3.statement).
Check (Section_2_proofs.eq_2_3_H3.met : Section_2.eq_2_3_H3.instance).
Check (Section_2_proofs.eq_2_3_H4.proved : Section_2.eq_2_3_H4.statement).
Check (Section_2_proofs.eq_2_3_H4.met : Section_2.eq_2_3_H4.instance).
Check (Section_2_proofs.eq_2_3_H5.proved : Section_2.eq_2_3_H5.statement).
Check (Section_2_proofs.eq_2_3_H5.met : Section_2.eq_2_3_H5.instance).
Check (Section_2_proofs.sec_2_quintic_conditions.proved : Section_2.sec_2_quintic_conditions.statement).
Check (Section_2_proofs.sec_2_quintic_conditions.met : Section_2.sec_2_quintic_conditions.instance).
Check (Section_2_proofs.sec_2_quintic_a1.proved : Section_2.sec_2_quintic_a1.statement).
Check (Section_2_proofs.sec_2_quintic_a1.met : Section_2.sec_2_quintic_a1.instance).
Check (Section_2_proofs.sec_2_quintic_b1.proved : Section_2.sec_2_quintic_b1.statement).
Check (Section_2_proofs.sec_2_quintic_b1.met : Section_2.sec_2_quintic_b1.instance).
Check (Section_2_proofs.sec_2_quintic_c1.proved : Section_2.sec_2_quintic_c1.statement).
Check (Section_2_proofs.sec_2_quintic_c1.met : Section_2.sec_2_quintic_c1.instance).
Check (Section_2_proofs.sec_2_quintic_d1.proved : Section_2.sec_2_quintic_d1.statement).
Check (Section_2_proofs.sec_2_quintic_d1.met : Section_2.sec_2_quintic_d1.instance).
Check (Section_2_proofs.sec_2_quintic_e1.proved : Section_2.sec_2_quintic_e1.statement).
Check (Section_2_proofs.sec_2_quintic_e1.met : Section_2.sec_2_quintic_e1.instance).
Check (Section_2_proofs.sec_2_quintic_f1.proved : Section_2.sec_2_quintic_f1.statement).
Check (Section_2_proofs.sec_2_quintic_f1.met : Section_2.sec_2_quintic_f1.instance).
Check (Section_2_proofs.eq_2_4.proved : Section_2.eq_2_4.statement).
Check (Section_2_proofs.eq_2_4.met : Section_2.eq_2_4.instance).
Check (Section_2_proofs.sec_2_control.proved : Section_2.sec_2_control.statement).
Check (Section_2_proofs.sec_2_control.met : Section_2.sec_2_control.instance).
Check (Section_2_proofs.fig_1b_middle.proved : Section_2.fig_1b_middle.statement).
Check (Section_2_proofs.fig_1b_middle.met : Section_2.fig_1b_middle.instance).
Check (Section_3_1_printed_proofs.sec_3_1_polynomials.proved : Section_3_1_printed.sec_3_1_polynomials.statement).
Check (Section_3_1_printed_proofs.sec_3_1_polynomials.met : Section_3_1_printed.sec_3_1_polynomials.instance).
Check (Section_3_1_printed_proofs.sec_3_1_substituted.proved : Section_3_1_printed.sec_3_1_substituted.statement).
Check (Section_3_1_printed_proofs.sec_3_1_substituted.met : Section_3_1_printed.sec_3_1_substituted.instance).
Check (Section_3_1_printed_proofs.sec_3_1_coefficients.proved : Section_3_1_printed.sec_3_1_coefficients.statement).
Check (Section_3_1_printed_proofs.sec_3_1_coefficients.met : Section_3_1_printed.sec_3_1_coefficients.instance).
Check (Section_3_1_printed_proofs.sec_3_1_hermite_1.proved : Section_3_1_printed.sec_3_1_hermite_1.statement).
Check (Section_3_1_printed_proofs.sec_3_1_hermite_1.met : Section_3_1_printed.sec_3_1_hermite_1.instance).
Check (Section_3_1_printed_proofs.sec_3_1_hermite_2.proved : Section_3_1_printed.sec_3_1_hermite_2.statement).
Check (Section_3_1_printed_proofs.sec_3_1_hermite_2.met : Section_3_1_printed.sec_3_1_hermite_2.instance).
Check (Section_3_1_printed_proofs.sec_3_1_hermite_3.proved : Section_3_1_printed.sec_3_1_hermite_3.statement).
Check (Section_3_1_printed_proofs.sec_3_1_hermite_3.met : Section_3_1_printed.sec_3_1_hermite_3.instance).
Check (Section_3_1_printed_proofs.sec_3_1_hermite_4.proved : Section_3_1_printed.sec_3_1_hermite_4.statement).
Check (Section_3_1_printed_proofs.sec_3_1_hermite_4.met : Section_3_1_printed.sec_3_1_hermite_4.instance).
Check (Section_3_1_printed_proofs.eq_3_5_A_r1.proved : Section_3_1_printed.eq_3_5_A_r1.statement).
Check (Section_3_1_printed_proofs.eq_3_5_A_r1.met : Section_3_1_printed.eq_3_5_A_r1.instance).
Check (Section_3_1_printed_proofs.eq_3_5_A_r2.proved : Section_3_1_printed.eq_3_5_A_r2.statement).
Check (Section_3_1_printed_proofs.eq_3_5_A_r2.met : Section_3_1_printed.eq_3_5_A_r2.instance).
Check (Section_3_1_printed_proofs.eq_3_5_A_r3.proved : Section_3_1_printed.eq_3_5_A_r3.statement).
Check (Section_3_1_printed_proofs.eq_3_5_A_r3.met : Section_3_1_printed.eq_3_5_A_r3.instance).
Check (Section_3_1_printed_proofs.eq_3_5_A_r4.proved : Section_3_1_printed.eq_3_5_A_r4.statement).
Check (Section_3_1_printed_proofs.eq_3_5_A_r4.met : Section_3_1_printed.eq_3_5_A_r4.instance).
Check (Section_3_1_printed_proofs.eq_3_5_B.refuted : ~ Section_3_1_printed.eq_3_5_B.statement).
Check (Section_3_1_printed_proofs.eq_3_5_B_corrected.proved : Section_3_1_printed.eq_3_5_B_corrected.statement).
Check (Section_3_1_printed_proofs.eq_3_5_B_corrected.met : Section_3_1_printed.eq_3_5_B_corrected.instance).
Check (Section_3_1_printed_proofs.eq_3_5_C_r1.proved : Section_3_1_printed.eq_3_5_C_r1.statement).
Check (Section_3_1_printed_proofs.eq_3_5_C_r1.met : Section_3_1_printed.eq_3_5_C_r1.instance).
Check (Section_3_1_printed_proofs.eq_3_5_C_r2.proved : Section_3_1_printed.eq_3_5_C_r2.statement).
Check (Section_3_1_printed_proofs.eq_3_5_C_r2.met : Section_3_1_printed.eq_3_5_C_r2.instance).
Check (Section_3_1_printed_proofs.eq_3_5_C_r3.proved : Section_3_1_printed.eq_3_5_C_r3.statement).
Check (Section_3_1_printed_proofs.eq_3_5_C_r3.met : Section_3_1_printed.eq_3_5_C_r3.instance).
Check (Section_3_1_printed_proofs.eq_3_5_C_r4.proved : Section_3_1_printed.eq_3_5_C_r4.statement).
Check (Section_3_1_printed_proofs.eq_3_5_C_r4.met : Section_3_1_printed.eq_3_5_C_r4.instance).
Check (Section_3_1_printed_proofs.eq_3_5_sizes.proved : Section_3_1_printed.eq_3_5_sizes.statement).
Check (Section_3_1_printed_proofs.eq_3_5_unique.proved : Section_3_1_printed.eq_3_5_unique.statement).
Check (Section_3_1_printed_proofs.eq_3_5_unique.met : Section_3_1_printed.eq_3_5_unique.instance).
Check (Section_3_1_printed_proofs.eq_3_5_det.proved : Section_3_1_printed.eq_3_5_det.statement).
Check (Section_3_1_printed_proofs.eq_3_5_k.proved : Section_3_1_printed.eq_3_5_k.statement).
Check (Section_3_1_printed_proofs.eq_3_5_k.met : Section_3_1_printed.eq_3_5_k.instance).
Check (Section_3_1_printed_proofs.eq_3_5_sol_p1.proved : Section_3_1_printed.eq_3_5_sol_p1.statement).
Check (Section_3_1_printed_proofs.eq_3_5_sol_p1.met : Section_3_1_printed.eq_3_5_sol_p1.instance).
Check (Section_3_1_printed_proofs.eq_3_5_sol_p0u.proved : Section_3_1_printed.eq_3_5_sol_p0u.statement).
Check (Section_3_1_printed_proofs.eq_3_5_sol_p0u.met : Section_3_1_printed.eq_3_5_sol_p0u.instance).
Check (Section_3_1_printed_proofs.eq_3_5_sol_p1u.proved : Section_3_1_printed.eq_3_5_sol_p1u.statement).
Check (Section_3_1_printed_proofs.eq_3_5_sol_p1u.met : Section_3_1_printed.eq_3_5_sol_p1u.instance).
Check (Section_3_1_printed_proofs.eq_3_5_sol_p0.proved : Section_3_1_printed.eq_3_5_sol_p0.statement).
Check (Section_3_1_printed_proofs.eq_3_5_sol_p0.met : Section_3_1_printed.eq_3_5_sol_p0.instance).
Check (Section_3_1_printed_proofs.sec_3_1_conclusion.proved : Section_3_1_printed.sec_3_1_conclusion.statement).
Check (Section_3_1_printed_proofs.sec_3_1_conclusion.met : Section_3_1_printed.sec_3_1_conclusion.instance).
Check (Section_3_1_printed_proofs.alg_3_1_step1.proved : Section_3_1_printed.alg_3_1_step1.statement).
Check (Section_3_1_printed_proofs.alg_3_1_step1.met : Section_3_1_printed.alg_3_1_step1.instance).
Check (Section_3_1_printed_proofs.alg_3_1_step2.proved : Section_3_1_printed.alg_3_1_step2.statement).
Check (Section_3_1_printed_proofs.alg_3_1_step2.met : Section_3_1_printed.alg_3_1_step2.instance).
Check (Section_3_1_printed_proofs.alg_3_1_step3.proved : Section_3_1_printed.alg_3_1_step3.statement).
Check (Section_3_1_printed_proofs.alg_3_1_step3.met : Section_3_1_printed.alg_3_1_step3.instance).
Check (Section_3_1_printed_proofs.sec_3_1_tension.proved : Section_3_1_printed.sec_3_1_tension.statement).
Check (Section_3_1_printed_proofs.sec_3_1_tension.met : Section_3_1_printed.sec_3_1_tension.instance).
Check (Section_3_1_printed_proofs.ex_3_1_arrange.proved : Section_3_1_printed.ex_3_1_arrange.statement).
Check (Section_3_1_printed_proofs.ex_3_1_arrange.met : Section_3_1_printed.ex_3_1_arrange.instance).
Check (Section_3_1_printed_proofs.ex_3_1_tension_effect.proved : Section_3_1_printed.ex_3_1_tension_effect.statement).
Check (Section_3_1_printed_proofs.ex_3_1_tension_effect.met : Section_3_1_printed.ex_3_1_tension_effect.instance).
Check (Section_3_1_printed_proofs.ex_3_1_p1.proved : Section_3_1_printed.ex_3_1_p1.statement).
Check (Section_3_1_printed_proofs.ex_3_1_p1.met : Section_3_1_printed.ex_3_1_p1.instance).
Check (Section_3_1_printed_proofs.ex_3_1_p0u.proved : Section_3_1_printed.ex_3_1_p0u.statement).
Check (Section_3_1_printed_proofs.ex_3_1_p0u.met : Section_3_1_printed.ex_3_1_p0u.instance).
Check (Section_3_1_printed_proofs.ex_3_1_p1u.proved : Section_3_1_printed.ex_3_1_p1u.statement).
Check (Section_3_1_printed_proofs.ex_3_1_p1u.met : Section_3_1_printed.ex_3_1_p1u.instance).
Check (Section_3_1_printed_proofs.ex_3_1_p0.proved : Section_3_1_printed.ex_3_1_p0.statement).
Check (Section_3_1_printed_proofs.ex_3_1_p0.met : Section_3_1_printed.ex_3_1_p0.instance).
Check (Section_3_1_printed_proofs.ex_3_1_parallel.proved : Section_3_1_printed.ex_3_1_parallel.statement).
Check (Section_3_1_printed_proofs.ex_3_1_parallel.met : Section_3_1_printed.ex_3_1_parallel.instance).
Check (Section_3_1_printed_proofs.ex_3_1_width.proved : Section_3_1_printed.ex_3_1_width.statement).
Check (Section_3_1_printed_proofs.ex_3_1_width.met : Section_3_1_printed.ex_3_1_width.instance).
Check (Section_3_1_printed_proofs.ex_3_1_shapes.proved : Section_3_1_printed.ex_3_1_shapes.statement).
Check (Section_3_1_printed_proofs.ex_3_1_shapes.met : Section_3_1_printed.ex_3_1_shapes.instance).
Check (Section_3_1_proofs.sec_3_1_polynomials.proved : Section_3_1.sec_3_1_polynomials.statement).
Check (Section_3_1_proofs.sec_3_1_polynomials.met : Section_3_1.sec_3_1_polynomials.instance).
Check (Section_3_1_proofs.sec_3_1_substituted.proved : Section_3_1.sec_3_1_substituted.statement).
Check (Section_3_1_proofs.sec_3_1_substituted.met : Section_3_1.sec_3_1_substituted.instance).
Check (Section_3_1_proofs.sec_3_1_coefficients.proved : Section_3_1.sec_3_1_coefficients.statement).
Check (Section_3_1_proofs.sec_3_1_coefficients.met : Section_3_1.sec_3_1_coefficients.instance).
Check (Section_3_1_proofs.sec_3_1_hermite_1.proved : Section_3_1.sec_3_1_hermite_1.statement).
Check (Section_3_1_proofs.sec_3_1_hermite_1.met : Section_3_1.sec_3_1_hermite_1.instance).
Check (Section_3_1_proofs.sec_3_1_hermite_2.proved : Section_3_1.sec_3_1_hermite_2.statement).
Check (Section_3_1_proofs.sec_3_1_hermite_2.met : Section_3_1.sec_3_1_hermite_2.instance).
Check (Section_3_1_proofs.sec_3_1_hermite_3.proved : Section_3_1.sec_3_1_hermite_3.statement).
Check (Section_3_1_proofs.sec_3_1_hermite_3.met : Section_3_1.sec_3_1_hermite_3.instance).
Check (Section_3_1_proofs.sec_3_1_hermite_4.proved : Section_3_1.sec_3_1_hermite_4.statement).
Check (Section_3_1_proofs.sec_3_1_hermite_4.met : Section_3_1.sec_3_1_hermite_4.instance).
Check (Section_3_1_proofs.eq_3_5_A_r1.proved : Section_3_1.eq_3_5_A_r1.statement).
Check (Section_3_1_proofs.eq_3_5_A_r1.met : Section_3_1.eq_3_5_A_r1.instance).
Check (Section_3_1_proofs.eq_3_5_A_r2.proved : Section_3_1.eq_3_5_A_r2.statement).
Check (Section_3_1_proofs.eq_3_5_A_r2.met : Section_3_1.eq_3_5_A_r2.instance).
Check (Section_3_1_proofs.eq_3_5_A_r3.proved : Section_3_1.eq_3_5_A_r3.statement).
Check (Section_3_1_proofs.eq_3_5_A_r3.met : Section_3_1.eq_3_5_A_r3.instance).
Check (Section_3_1_proofs.eq_3_5_A_r4.proved : Section_3_1.eq_3_5_A_r4.statement).
Check (Section_3_1_proofs.eq_3_5_A_r4.met : Section_3_1.eq_3_5_A_r4.instance).
Check (Section_3_1_proofs.eq_3_5_B.refuted : ~ Section_3_1.eq_3_5_B.statement).
Check (Section_3_1_proofs.eq_3_5_B_corrected.proved : Section_3_1.eq_3_5_B_corrected.statement).
Check (Section_3_1_proofs.eq_3_5_B_corrected.met : Section_3_1.eq_3_5_B_corrected.instance).
Check (Section_3_1_proofs.eq_3_5_C_r1.proved : Section_3_1.eq_3_5_C_r1.statement).
Check (Section_3_1_proofs.eq_3_5_C_r1.met : Section_3_1.eq_3_5_C_r1.instance).
Check (Section_3_1_proofs.eq_3_5_C_r2.proved : Section_3_1.eq_3_5_C_r2.statement).
Check (Section_3_1_proofs.eq_3_5_C_r2.met : Section_3_1.eq_3_5_C_r2.instance).
Check (Section_3_1_proofs.eq_3_5_C_r3.proved : Section_3_1.eq_3_5_C_r3.statement).
Check (Section_3_1_proofs.eq_3_5_C_r3.met : Section_3_1.eq_3_5_C_r3.instance).
Check (Section_3_1_proofs.eq_3_5_C_r4.proved : Section_3_1.eq_3_5_C_r4.statement).
Check (Section_3_1_proofs.eq_3_5_C_r4.met : Section_3_1.eq_3_5_C_r4.instance).
Check (Section_3_1_proofs.eq_3_5_sizes.proved : Section_3_1.eq_3_5_sizes.statement).
Check (Section_3_1_proofs.eq_3_5_unique.proved : Section_3_1.eq_3_5_unique.statement).
Check (Section_3_1_proofs.eq_3_5_unique.met : Section_3_1.eq_3_5_unique.instance).
Check (Section_3_1_proofs.eq_3_5_det.proved : Section_3_1.eq_3_5_det.statement).
Check (Section_3_1_proofs.eq_3_5_k.proved : Section_3_1.eq_3_5_k.statement).
Check (Section_3_1_proofs.eq_3_5_k.met : Section_3_1.eq_3_5_k.instance).
Check (Section_3_1_proofs.eq_3_5_sol_p1.proved : Section_3_1.eq_3_5_sol_p1.statement).
Check (Section_3_1_proofs.eq_3_5_sol_p1.met : Section_3_1.eq_3_5_sol_p1.instance).
Check (Section_3_1_proofs.eq_3_5_sol_p0u.proved : Section_3_1.eq_3_5_sol_p0u.statement).
Check (Section_3_1_proofs.eq_3_5_sol_p0u.met : Section_3_1.eq_3_5_sol_p0u.instance).
Check (Section_3_1_proofs.eq_3_5_sol_p1u.proved : Section_3_1.eq_3_5_sol_p1u.statement).
Check (Section_3_1_proofs.eq_3_5_sol_p1u.met : Section_3_1.eq_3_5_sol_p1u.instance).
Check (Section_3_1_proofs.eq_3_5_sol_p0.proved : Section_3_1.eq_3_5_sol_p0.statement).
Check (Section_3_1_proofs.eq_3_5_sol_p0.met : Section_3_1.eq_3_5_sol_p0.instance).
Check (Section_3_1_proofs.sec_3_1_conclusion.proved : Section_3_1.sec_3_1_conclusion.statement).
Check (Section_3_1_proofs.sec_3_1_conclusion.met : Section_3_1.sec_3_1_conclusion.instance).
Check (Section_3_1_proofs.alg_3_1_step1.proved : Section_3_1.alg_3_1_step1.statement).
Check (Section_3_1_proofs.alg_3_1_step1.met : Section_3_1.alg_3_1_step1.instance).
Check (Section_3_1_proofs.alg_3_1_step2.proved : Section_3_1.alg_3_1_step2.statement).
Check (Section_3_1_proofs.alg_3_1_step2.met : Section_3_1.alg_3_1_step2.instance).
Check (Section_3_1_proofs.alg_3_1_step3.proved : Section_3_1.alg_3_1_step3.statement).
Check (Section_3_1_proofs.alg_3_1_step3.met : Section_3_1.alg_3_1_step3.instance).
Check (Section_3_1_proofs.sec_3_1_tension.proved : Section_3_1.sec_3_1_tension.statement).
Check (Section_3_1_proofs.sec_3_1_tension.met : Section_3_1.sec_3_1_tension.instance).
Check (Section_3_1_proofs.ex_3_1_arrange.proved : Section_3_1.ex_3_1_arrange.statement).
Check (Section_3_1_proofs.ex_3_1_arrange.met : Section_3_1.ex_3_1_arrange.instance).
Check (Section_3_1_proofs.ex_3_1_tension_effect.proved : Section_3_1.ex_3_1_tension_effect.statement).
Check (Section_3_1_proofs.ex_3_1_tension_effect.met : Section_3_1.ex_3_1_tension_effect.instance).
Check (Section_3_1_proofs.ex_3_1_p1.proved : Section_3_1.ex_3_1_p1.statement).
Check (Section_3_1_proofs.ex_3_1_p1.met : Section_3_1.ex_3_1_p1.instance).
Check (Section_3_1_proofs.ex_3_1_p0u.proved : Section_3_1.ex_3_1_p0u.statement).
Check (Section_3_1_proofs.ex_3_1_p0u.met : Section_3_1.ex_3_1_p0u.instance).
Check (Section_3_1_proofs.ex_3_1_p1u.proved : Section_3_1.ex_3_1_p1u.statement).
Check (Section_3_1_proofs.ex_3_1_p1u.met : Section_3_1.ex_3_1_p1u.instance).
Check (Section_3_1_proofs.ex_3_1_p0.proved : Section_3_1.ex_3_1_p0.statement).
Check (Section_3_1_proofs.ex_3_1_p0.met : Section_3_1.ex_3_1_p0.instance).
Check (Section_3_1_proofs.ex_3_1_parallel.proved : Section_3_1.ex_3_1_parallel.statement).
Check (Section_3_1_proofs.ex_3_1_parallel.met : Section_3_1.ex_3_1_parallel.instance).
Check (Section_3_1_proofs.ex_3_1_width.proved : Section_3_1.ex_3_1_width.statement).
Check (Section_3_1_proofs.ex_3_1_width.met : Section_3_1.ex_3_1_width.instance).
Check (Section_3_1_proofs.ex_3_1_shapes.proved : Section_3_1.ex_3_1_shapes.statement).
Check (Section_3_1_proofs.ex_3_1_shapes.met : Section_3_1.ex_3_1_shapes.instance).
Check (Section_3_2_printed_proofs.sec_3_2_curves.proved : Section_3_2_printed.sec_3_2_curves.statement).
Check (Section_3_2_printed_proofs.sec_3_2_curves.met : Section_3_2_printed.sec_3_2_curves.instance).
Check (Section_3_2_printed_proofs.eq_3_6_A_r1.proved : Section_3_2_printed.eq_3_6_A_r1.statement).
Check (Section_3_2_printed_proofs.eq_3_6_A_r1.met : Section_3_2_printed.eq_3_6_A_r1.instance).
Check (Section_3_2_printed_proofs.eq_3_6_A_r2.proved : Section_3_2_printed.eq_3_6_A_r2.statement).
Check (Section_3_2_printed_proofs.eq_3_6_A_r2.met : Section_3_2_printed.eq_3_6_A_r2.instance).
Check (Section_3_2_printed_proofs.eq_3_6_A_r3.proved : Section_3_2_printed.eq_3_6_A_r3.statement).
Check (Section_3_2_printed_proofs.eq_3_6_A_r3.met : Section_3_2_printed.eq_3_6_A_r3.instance).
Check (Section_3_2_printed_proofs.eq_3_6_A_r4.proved : Section_3_2_printed.eq_3_6_A_r4.statement).
Check (Section_3_2_printed_proofs.eq_3_6_A_r4.met : Section_3_2_printed.eq_3_6_A_r4.instance).
Check (Section_3_2_printed_proofs.eq_3_6_A_r5.proved : Section_3_2_printed.eq_3_6_A_r5.statement).
Check (Section_3_2_printed_proofs.eq_3_6_A_r5.met : Section_3_2_printed.eq_3_6_A_r5.instance).
Check (Section_3_2_printed_proofs.eq_3_6_B.refuted : ~ Section_3_2_printed.eq_3_6_B.statement).
Check (Section_3_2_printed_proofs.eq_3_6_B_corrected.proved : Section_3_2_printed.eq_3_6_B_corrected.statement).
Check (Section_3_2_printed_proofs.eq_3_6_B_corrected.met : Section_3_2_printed.eq_3_6_B_corrected.instance).
Check (Section_3_2_printed_proofs.eq_3_6_C_r1.proved : Section_3_2_printed.eq_3_6_C_r1.statement).
Check (Section_3_2_printed_proofs.eq_3_6_C_r1.met : Section_3_2_printed.eq_3_6_C_r1.instance).
Check (Section_3_2_printed_proofs.eq_3_6_C_r2.refuted : ~ Section_3_2_printed.eq_3_6_C_r2.statement).
Check (Section_3_2_printed_proofs.eq_3_6_C_r2_corrected.proved : Section_3_2_printed.eq_3_6_C_r2_corrected.statement).
Check (Section_3_2_printed_proofs.eq_3_6_C_r2_corrected.met : Section_3_2_printed.eq_3_6_C_r2_corrected.instance).
Check (Section_3_2_printed_proofs.eq_3_6_C_r3.proved : Section_3_2_printed.eq_3_6_C_r3.statement).
Check (Section_3_2_printed_proofs.eq_3_6_C_r3.met : Section_3_2_printed.eq_3_6_C_r3.instance).
Check (Section_3_2_printed_proofs.eq_3_6_C_r4.proved : Section_3_2_printed.eq_3_6_C_r4.statement).
Check (Section_3_2_printed_proofs.eq_3_6_C_r4.met : Section_3_2_printed.eq_3_6_C_r4.instance).
Check (Section_3_2_printed_proofs.eq_3_6_C_r5.refuted : ~ Section_3_2_printed.eq_3_6_C_r5.statement).
Check (Section_3_2_printed_proofs.eq_3_6_C_r5_corrected.proved : Section_3_2_printed.eq_3_6_C_r5_corrected.statement).
Check (Section_3_2_printed_proofs.eq_3_6_C_r5_corrected.met : Section_3_2_printed.eq_3_6_C_r5_corrected.instance).
Check (Section_3_2_printed_proofs.eq_3_6_det.refuted : ~ Section_3_2_printed.eq_3_6_det.statement).
Check (Section_3_2_printed_proofs.eq_3_6_det_corrected.proved : Section_3_2_printed.eq_3_6_det_corrected.statement).
Check (Section_3_2_printed_proofs.eq_3_6_det_true.proved : Section_3_2_printed.eq_3_6_det_true.statement).
Check (Section_3_2_printed_proofs.eq_3_6_det_true.met : Section_3_2_printed.eq_3_6_det_true.instance).
Check (Section_3_2_printed_proofs.eq_3_6_det_slip.proved : Section_3_2_printed.eq_3_6_det_slip.statement).
Check (Section_3_2_printed_proofs.eq_3_6_det_factored.proved : Section_3_2_printed.eq_3_6_det_factored.statement).
Check (Section_3_2_printed_proofs.eq_3_6_k.proved : Section_3_2_printed.eq_3_6_k.statement).
Check (Section_3_2_printed_proofs.eq_3_6_k.met : Section_3_2_printed.eq_3_6_k.instance).
Check (Section_3_2_printed_proofs.eq_3_6_k_every.proved : Section_3_2_printed.eq_3_6_k_every.statement).
Check (Section_3_2_printed_proofs.eq_3_6_k_every.met : Section_3_2_printed.eq_3_6_k_every.instance).
Check (Section_3_2_printed_proofs.eq_3_6_k_135_136.proved : Section_3_2_printed.eq_3_6_k_135_136.statement).
Check (Section_3_2_printed_proofs.eq_3_6_k_135_136.met : Section_3_2_printed.eq_3_6_k_135_136.instance).
Check (Section_3_2_printed_proofs.eq_3_6_sol_q.proved : Section_3_2_printed.eq_3_6_sol_q.statement).
Check (Section_3_2_printed_proofs.eq_3_6_sol_q.met : Section_3_2_printed.eq_3_6_sol_q.instance).
Check (Section_3_2_printed_proofs.eq_3_6_sol_p1.proved : Section_3_2_printed.eq_3_6_sol_p1.statement).
Check (Section_3_2_printed_proofs.eq_3_6_sol_p1.met : Section_3_2_printed.eq_3_6_sol_p1.instance).
Check (Section_3_2_printed_proofs.eq_3_6_sol_p0u.proved : Section_3_2_printed.eq_3_6_sol_p0u.statement).
Check (Section_3_2_printed_proofs.eq_3_6_sol_p0u.met : Section_3_2_printed.eq_3_6_sol_p0u.instance).
Check (Section_3_2_printed_proofs.eq_3_6_sol_p1u.proved : Section_3_2_printed.eq_3_6_sol_p1u.statement).
Check (Section_3_2_printed_proofs.eq_3_6_sol_p1u.met : Section_3_2_printed.eq_3_6_sol_p1u.instance).
Check (Section_3_2_printed_proofs.eq_3_6_sol_o.proved : Section_3_2_printed.eq_3_6_sol_o.statement).
Check (Section_3_2_printed_proofs.eq_3_6_sol_o.met : Section_3_2_printed.eq_3_6_sol_o.instance).
Check (Section_3_2_printed_proofs.eq_3_6_system.proved : Section_3_2_printed.eq_3_6_system.statement).
Check (Section_3_2_printed_proofs.eq_3_6_system.met : Section_3_2_printed.eq_3_6_system.instance).
Check (Section_3_2_printed_proofs.sec_3_2_advantage.proved : Section_3_2_printed.sec_3_2_advantage.statement).
Check (Section_3_2_printed_proofs.sec_3_2_advantage.met : Section_3_2_printed.sec_3_2_advantage.instance).
Check (Section_3_2_printed_proofs.ex_3_2_q.proved : Section_3_2_printed.ex_3_2_q.statement).
Check (Section_3_2_printed_proofs.ex_3_2_q.met : Section_3_2_printed.ex_3_2_q.instance).
Check (Section_3_2_printed_proofs.ex_3_2_p1.proved : Section_3_2_printed.ex_3_2_p1.statement).
Check (Section_3_2_printed_proofs.ex_3_2_p1.met : Section_3_2_printed.ex_3_2_p1.instance).
Check (Section_3_2_printed_proofs.ex_3_2_p0u.proved : Section_3_2_printed.ex_3_2_p0u.statement).
Check (Section_3_2_printed_proofs.ex_3_2_p0u.met : Section_3_2_printed.ex_3_2_p0u.instance).
Check (Section_3_2_printed_proofs.ex_3_2_p1u.proved : Section_3_2_printed.ex_3_2_p1u.statement).
Check (Section_3_2_printed_proofs.ex_3_2_p1u.met : Section_3_2_printed.ex_3_2_p1u.instance).
Check (Section_3_2_printed_proofs.ex_3_2_o.proved : Section_3_2_printed.ex_3_2_o.statement).
Check (Section_3_2_printed_proofs.ex_3_2_o.met : Section_3_2_printed.ex_3_2_o.instance).
Check (Section_3_2_printed_proofs.ex_3_2_parallel.proved : Section_3_2_printed.ex_3_2_parallel.statement).
Check (Section_3_2_printed_proofs.ex_3_2_parallel.met : Section_3_2_printed.ex_3_2_parallel.instance).
Check (Section_3_2_proofs.sec_3_2_curves.proved : Section_3_2.sec_3_2_curves.statement).
Check (Section_3_2_proofs.sec_3_2_curves.met : Section_3_2.sec_3_2_curves.instance).
Check (Section_3_2_proofs.eq_3_6_A_r1.proved : Section_3_2.eq_3_6_A_r1.statement).
Check (Section_3_2_proofs.eq_3_6_A_r1.met : Section_3_2.eq_3_6_A_r1.instance).
Check (Section_3_2_proofs.eq_3_6_A_r2.proved : Section_3_2.eq_3_6_A_r2.statement).
Check (Section_3_2_proofs.eq_3_6_A_r2.met : Section_3_2.eq_3_6_A_r2.instance).
Check (Section_3_2_proofs.eq_3_6_A_r3.proved : Section_3_2.eq_3_6_A_r3.statement).
Check (Section_3_2_proofs.eq_3_6_A_r3.met : Section_3_2.eq_3_6_A_r3.instance).
Check (Section_3_2_proofs.eq_3_6_A_r4.proved : Section_3_2.eq_3_6_A_r4.statement).
Check (Section_3_2_proofs.eq_3_6_A_r4.met : Section_3_2.eq_3_6_A_r4.instance).
Check (Section_3_2_proofs.eq_3_6_A_r5.proved : Section_3_2.eq_3_6_A_r5.statement).
Check (Section_3_2_proofs.eq_3_6_A_r5.met : Section_3_2.eq_3_6_A_r5.instance).
Check (Section_3_2_proofs.eq_3_6_B.refuted : ~ Section_3_2.eq_3_6_B.statement).
Check (Section_3_2_proofs.eq_3_6_B_corrected.proved : Section_3_2.eq_3_6_B_corrected.statement).
Check (Section_3_2_proofs.eq_3_6_B_corrected.met : Section_3_2.eq_3_6_B_corrected.instance).
Check (Section_3_2_proofs.eq_3_6_C_r1.proved : Section_3_2.eq_3_6_C_r1.statement).
Check (Section_3_2_proofs.eq_3_6_C_r1.met : Section_3_2.eq_3_6_C_r1.instance).
Check (Section_3_2_proofs.eq_3_6_C_r2.refuted : ~ Section_3_2.eq_3_6_C_r2.statement).
Check (Section_3_2_proofs.eq_3_6_C_r2_corrected.proved : Section_3_2.eq_3_6_C_r2_corrected.statement).
Check (Section_3_2_proofs.eq_3_6_C_r2_corrected.met : Section_3_2.eq_3_6_C_r2_corrected.instance).
Check (Section_3_2_proofs.eq_3_6_C_r3.proved : Section_3_2.eq_3_6_C_r3.statement).
Check (Section_3_2_proofs.eq_3_6_C_r3.met : Section_3_2.eq_3_6_C_r3.instance).
Check (Section_3_2_proofs.eq_3_6_C_r4.proved : Section_3_2.eq_3_6_C_r4.statement).
Check (Section_3_2_proofs.eq_3_6_C_r4.met : Section_3_2.eq_3_6_C_r4.instance).
Check (Section_3_2_proofs.eq_3_6_C_r5.refuted : ~ Section_3_2.eq_3_6_C_r5.statement).
Check (Section_3_2_proofs.eq_3_6_C_r5_corrected.proved : Section_3_2.eq_3_6_C_r5_corrected.statement).
Check (Section_3_2_proofs.eq_3_6_C_r5_corrected.met : Section_3_2.eq_3_6_C_r5_corrected.instance).
Check (Section_3_2_proofs.eq_3_6_det.refuted : ~ Section_3_2.eq_3_6_det.statement).
Check (Section_3_2_proofs.eq_3_6_det_corrected.proved : Section_3_2.eq_3_6_det_corrected.statement).
Check (Section_3_2_proofs.eq_3_6_det_true.proved : Section_3_2.eq_3_6_det_true.statement).
Check (Section_3_2_proofs.eq_3_6_det_true.met : Section_3_2.eq_3_6_det_true.instance).
Check (Section_3_2_proofs.eq_3_6_det_slip.proved : Section_3_2.eq_3_6_det_slip.statement).
Check (Section_3_2_proofs.eq_3_6_det_factored.proved : Section_3_2.eq_3_6_det_factored.statement).
Check (Section_3_2_proofs.eq_3_6_k.proved : Section_3_2.eq_3_6_k.statement).
Check (Section_3_2_proofs.eq_3_6_k.met : Section_3_2.eq_3_6_k.instance).
Check (Section_3_2_proofs.eq_3_6_k_every.proved : Section_3_2.eq_3_6_k_every.statement).
Check (Section_3_2_proofs.eq_3_6_k_every.met : Section_3_2.eq_3_6_k_every.instance).
Check (Section_3_2_proofs.eq_3_6_k_135_136.proved : Section_3_2.eq_3_6_k_135_136.statement).
Check (Section_3_2_proofs.eq_3_6_k_135_136.met : Section_3_2.eq_3_6_k_135_136.instance).
Check (Section_3_2_proofs.eq_3_6_sol_q.proved : Section_3_2.eq_3_6_sol_q.statement).
Check (Section_3_2_proofs.eq_3_6_sol_q.met : Section_3_2.eq_3_6_sol_q.instance).
Check (Section_3_2_proofs.eq_3_6_sol_p1.proved : Section_3_2.eq_3_6_sol_p1.statement).
Check (Section_3_2_proofs.eq_3_6_sol_p1.met : Section_3_2.eq_3_6_sol_p1.instance).
Check (Section_3_2_proofs.eq_3_6_sol_p0u.proved : Section_3_2.eq_3_6_sol_p0u.statement).
Check (Section_3_2_proofs.eq_3_6_sol_p0u.met : Section_3_2.eq_3_6_sol_p0u.instance).
Check (Section_3_2_proofs.eq_3_6_sol_p1u.proved : Section_3_2.eq_3_6_sol_p1u.statement).
Check (Section_3_2_proofs.eq_3_6_sol_p1u.met : Section_3_2.eq_3_6_sol_p1u.instance).
Check (Section_3_2_proofs.eq_3_6_sol_o.proved : Section_3_2.eq_3_6_sol_o.statement).
Check (Section_3_2_proofs.eq_3_6_sol_o.met : Section_3_2.eq_3_6_sol_o.instance).
Check (Section_3_2_proofs.eq_3_6_system.proved : Section_3_2.eq_3_6_system.statement).
Check (Section_3_2_proofs.eq_3_6_system.met : Section_3_2.eq_3_6_system.instance).
Check (Section_3_2_proofs.sec_3_2_advantage.proved : Section_3_2.sec_3_2_advantage.statement).
Check (Section_3_2_proofs.sec_3_2_advantage.met : Section_3_2.sec_3_2_advantage.instance).
Check (Section_3_2_proofs.ex_3_2_q.proved : Section_3_2.ex_3_2_q.statement).
Check (Section_3_2_proofs.ex_3_2_q.met : Section_3_2.ex_3_2_q.instance).
Check (Section_3_2_proofs.ex_3_2_p1.proved : Section_3_2.ex_3_2_p1.statement).
Check (Section_3_2_proofs.ex_3_2_p1.met : Section_3_2.ex_3_2_p1.instance).
Check (Section_3_2_proofs.ex_3_2_p0u.proved : Section_3_2.ex_3_2_p0u.statement).
Check (Section_3_2_proofs.ex_3_2_p0u.met : Section_3_2.ex_3_2_p0u.instance).
Check (Section_3_2_proofs.ex_3_2_p1u.proved : Section_3_2.ex_3_2_p1u.statement).
Check (Section_3_2_proofs.ex_3_2_p1u.met : Section_3_2.ex_3_2_p1u.instance).
Check (Section_3_2_proofs.ex_3_2_o.proved : Section_3_2.ex_3_2_o.statement).
Check (Section_3_2_proofs.ex_3_2_o.met : Section_3_2.ex_3_2_o.instance).
Check (Section_3_2_proofs.ex_3_2_parallel.proved : Section_3_2.ex_3_2_parallel.statement).
Check (Section_3_2_proofs.ex_3_2_parallel.met : Section_3_2.ex_3_2_parallel.instance).
Check (Section_3_3_printed_proofs.sec_3_3_curves.proved : Section_3_3_printed.sec_3_3_curves.statement).
Check (Section_3_3_printed_proofs.sec_3_3_curves.met : Section_3_3_printed.sec_3_3_curves.instance).
Check (Section_3_3_printed_proofs.eq_3_7_A_r1.proved : Section_3_3_printed.eq_3_7_A_r1.statement).
Check (Section_3_3_printed_proofs.eq_3_7_A_r1.met : Section_3_3_printed.eq_3_7_A_r1.instance).
Check (Section_3_3_printed_proofs.eq_3_7_A_r2.proved : Section_3_3_printed.eq_3_7_A_r2.statement).
Check (Section_3_3_printed_proofs.eq_3_7_A_r2.met : Section_3_3_printed.eq_3_7_A_r2.instance).
Check (Section_3_3_printed_proofs.eq_3_7_A_r3.proved : Section_3_3_printed.eq_3_7_A_r3.statement).
Check (Section_3_3_printed_proofs.eq_3_7_A_r3.met : Section_3_3_printed.eq_3_7_A_r3.instance).
Check (Section_3_3_printed_proofs.eq_3_7_A_r4.proved : Section_3_3_printed.eq_3_7_A_r4.statement).
Check (Section_3_3_printed_proofs.eq_3_7_A_r4.met : Section_3_3_printed.eq_3_7_A_r4.instance).
Check (Section_3_3_printed_proofs.eq_3_7_A_r5.proved : Section_3_3_printed.eq_3_7_A_r5.statement).
Check (Section_3_3_printed_proofs.eq_3_7_A_r5.met : Section_3_3_printed.eq_3_7_A_r5.instance).
Check (Section_3_3_printed_proofs.eq_3_7_A_r6.proved : Section_3_3_printed.eq_3_7_A_r6.statement).
Check (Section_3_3_printed_proofs.eq_3_7_A_r6.met : Section_3_3_printed.eq_3_7_A_r6.instance).
Check (Section_3_3_printed_proofs.eq_3_7_B.refuted : ~ Section_3_3_printed.eq_3_7_B.statement).
Check (Section_3_3_printed_proofs.eq_3_7_B_corrected.proved : Section_3_3_printed.eq_3_7_B_corrected.statement).
Check (Section_3_3_printed_proofs.eq_3_7_B_corrected.met : Section_3_3_printed.eq_3_7_B_corrected.instance).
Check (Section_3_3_printed_proofs.eq_3_7_C_r1.proved : Section_3_3_printed.eq_3_7_C_r1.statement).
Check (Section_3_3_printed_proofs.eq_3_7_C_r1.met : Section_3_3_printed.eq_3_7_C_r1.instance).
Check (Section_3_3_printed_proofs.eq_3_7_C_r2.proved : Section_3_3_printed.eq_3_7_C_r2.statement).
Check (Section_3_3_printed_proofs.eq_3_7_C_r2.met : Section_3_3_printed.eq_3_7_C_r2.instance).
Check (Section_3_3_printed_proofs.eq_3_7_C_r3.proved : Section_3_3_printed.eq_3_7_C_r3.statement).
Check (Section_3_3_printed_proofs.eq_3_7_C_r3.met : Section_3_3_printed.eq_3_7_C_r3.instance).
Check (Section_3_3_printed_proofs.eq_3_7_C_r4.proved : Section_3_3_printed.eq_3_7_C_r4.statement).
Check (Section_3_3_printed_proofs.eq_3_7_C_r4.met : Section_3_3_printed.eq_3_7_C_r4.instance).
Check (Section_3_3_printed_proofs.eq_3_7_C_r5.proved : Section_3_3_printed.eq_3_7_C_r5.statement).
Check (Section_3_3_printed_proofs.eq_3_7_C_r5.met : Section_3_3_printed.eq_3_7_C_r5.instance).
Check (Section_3_3_printed_proofs.eq_3_7_C_r6.proved : Section_3_3_printed.eq_3_7_C_r6.statement).
Check (Section_3_3_printed_proofs.eq_3_7_C_r6.met : Section_3_3_printed.eq_3_7_C_r6.instance).
Check (Section_3_3_printed_proofs.eq_3_7_det.proved : Section_3_3_printed.eq_3_7_det.statement).
Check (Section_3_3_printed_proofs.eq_3_7_k.proved : Section_3_3_printed.eq_3_7_k.statement).
Check (Section_3_3_printed_proofs.eq_3_7_k.met : Section_3_3_printed.eq_3_7_k.instance).
Check (Section_3_3_printed_proofs.eq_3_7_k_needed.proved : Section_3_3_printed.eq_3_7_k_needed.statement).
Check (Section_3_3_printed_proofs.eq_3_7_k_needed.met : Section_3_3_printed.eq_3_7_k_needed.instance).
Check (Section_3_3_printed_proofs.eq_3_7_sol_p0u.proved : Section_3_3_printed.eq_3_7_sol_p0u.statement).
Check (Section_3_3_printed_proofs.eq_3_7_sol_p0u.met : Section_3_3_printed.eq_3_7_sol_p0u.instance).
Check (Section_3_3_printed_proofs.eq_3_7_sol_qu.proved : Section_3_3_printed.eq_3_7_sol_qu.statement).
Check (Section_3_3_printed_proofs.eq_3_7_sol_qu.met : Section_3_3_printed.eq_3_7_sol_qu.instance).
Check (Section_3_3_printed_proofs.eq_3_7_sol_p1u.proved : Section_3_3_printed.eq_3_7_sol_p1u.statement).
Check (Section_3_3_printed_proofs.eq_3_7_sol_p1u.met : Section_3_3_printed.eq_3_7_sol_p1u.instance).
Check (Section_3_3_printed_proofs.eq_3_7_sol_q.proved : Section_3_3_printed.eq_3_7_sol_q.statement).
Check (Section_3_3_printed_proofs.eq_3_7_sol_q.met : Section_3_3_printed.eq_3_7_sol_q.instance).
Check (Section_3_3_printed_proofs.eq_3_7_sol_p1.proved : Section_3_3_printed.eq_3_7_sol_p1.statement).
Check (Section_3_3_printed_proofs.eq_3_7_sol_p1.met : Section_3_3_printed.eq_3_7_sol_p1.instance).
Check (Section_3_3_printed_proofs.eq_3_7_sol_o.proved : Section_3_3_printed.eq_3_7_sol_o.statement).
Check (Section_3_3_printed_proofs.eq_3_7_sol_o.met : Section_3_3_printed.eq_3_7_sol_o.instance).
Check (Section_3_3_printed_proofs.eq_3_7_system.proved : Section_3_3_printed.eq_3_7_system.statement).
Check (Section_3_3_printed_proofs.eq_3_7_system.met : Section_3_3_printed.eq_3_7_system.instance).
Check (Section_3_3_printed_proofs.sec_3_3_advantage.proved : Section_3_3_printed.sec_3_3_advantage.statement).
Check (Section_3_3_printed_proofs.sec_3_3_advantage.met : Section_3_3_printed.sec_3_3_advantage.instance).
Check (Section_3_3_printed_proofs.ex_3_3_equation.refuted : ~ Section_3_3_printed.ex_3_3_equation.statement).
Check (Section_3_3_printed_proofs.ex_3_3_equation_true.proved : Section_3_3_printed.ex_3_3_equation_true.statement).
Check (Section_3_3_printed_proofs.ex_3_3_equation_true.met : Section_3_3_printed.ex_3_3_equation_true.instance).
Check (Section_3_3_printed_proofs.ex_3_3_p0u.proved : Section_3_3_printed.ex_3_3_p0u.statement).
Check (Section_3_3_printed_proofs.ex_3_3_p0u.met : Section_3_3_printed.ex_3_3_p0u.instance).
Check (Section_3_3_printed_proofs.ex_3_3_qu.proved : Section_3_3_printed.ex_3_3_qu.statement).
Check (Section_3_3_printed_proofs.ex_3_3_qu.met : Section_3_3_printed.ex_3_3_qu.instance).
Check (Section_3_3_printed_proofs.ex_3_3_p1u.proved : Section_3_3_printed.ex_3_3_p1u.statement).
Check (Section_3_3_printed_proofs.ex_3_3_p1u.met : Section_3_3_printed.ex_3_3_p1u.instance).
Check (Section_3_3_printed_proofs.ex_3_3_q.proved : Section_3_3_printed.ex_3_3_q.statement).
Check (Section_3_3_printed_proofs.ex_3_3_q.met : Section_3_3_printed.ex_3_3_q.instance).
Check (Section_3_3_printed_proofs.ex_3_3_p1.proved : Section_3_3_printed.ex_3_3_p1.statement).
Check (Section_3_3_printed_proofs.ex_3_3_p1.met : Section_3_3_printed.ex_3_3_p1.instance).
Check (Section_3_3_printed_proofs.ex_3_3_o.proved : Section_3_3_printed.ex_3_3_o.statement).
Check (Section_3_3_printed_proofs.ex_3_3_o.met : Section_3_3_printed.ex_3_3_o.instance).
Check (Section_3_3_printed_proofs.ex_3_3_parallel.proved : Section_3_3_printed.ex_3_3_parallel.statement).
Check (Section_3_3_printed_proofs.ex_3_3_parallel.met : Section_3_3_printed.ex_3_3_parallel.instance).
Check (Section_3_3_printed_proofs.fig_4d_constant.proved : Section_3_3_printed.fig_4d_constant.statement).
Check (Section_3_3_printed_proofs.fig_4d_constant.met : Section_3_3_printed.fig_4d_constant.instance).
Check (Section_3_3_proofs.sec_3_3_curves.proved : Section_3_3.sec_3_3_curves.statement).
Check (Section_3_3_proofs.sec_3_3_curves.met : Section_3_3.sec_3_3_curves.instance).
Check (Section_3_3_proofs.eq_3_7_A_r1.proved : Section_3_3.eq_3_7_A_r1.statement).
Check (Section_3_3_proofs.eq_3_7_A_r1.met : Section_3_3.eq_3_7_A_r1.instance).
Check (Section_3_3_proofs.eq_3_7_A_r2.proved : Section_3_3.eq_3_7_A_r2.statement).
Check (Section_3_3_proofs.eq_3_7_A_r2.met : Section_3_3.eq_3_7_A_r2.instance).
Check (Section_3_3_proofs.eq_3_7_A_r3.proved : Section_3_3.eq_3_7_A_r3.statement).
Check (Section_3_3_proofs.eq_3_7_A_r3.met : Section_3_3.eq_3_7_A_r3.instance).
Check (Section_3_3_proofs.eq_3_7_A_r4.proved : Section_3_3.eq_3_7_A_r4.statement).
Check (Section_3_3_proofs.eq_3_7_A_r4.met : Section_3_3.eq_3_7_A_r4.instance).
Check (Section_3_3_proofs.eq_3_7_A_r5.proved : Section_3_3.eq_3_7_A_r5.statement).
Check (Section_3_3_proofs.eq_3_7_A_r5.met : Section_3_3.eq_3_7_A_r5.instance).
Check (Section_3_3_proofs.eq_3_7_A_r6.proved : Section_3_3.eq_3_7_A_r6.statement).
Check (Section_3_3_proofs.eq_3_7_A_r6.met : Section_3_3.eq_3_7_A_r6.instance).
Check (Section_3_3_proofs.eq_3_7_B.refuted : ~ Section_3_3.eq_3_7_B.statement).
Check (Section_3_3_proofs.eq_3_7_B_corrected.proved : Section_3_3.eq_3_7_B_corrected.statement).
Check (Section_3_3_proofs.eq_3_7_B_corrected.met : Section_3_3.eq_3_7_B_corrected.instance).
Check (Section_3_3_proofs.eq_3_7_C_r1.proved : Section_3_3.eq_3_7_C_r1.statement).
Check (Section_3_3_proofs.eq_3_7_C_r1.met : Section_3_3.eq_3_7_C_r1.instance).
Check (Section_3_3_proofs.eq_3_7_C_r2.proved : Section_3_3.eq_3_7_C_r2.statement).
Check (Section_3_3_proofs.eq_3_7_C_r2.met : Section_3_3.eq_3_7_C_r2.instance).
Check (Section_3_3_proofs.eq_3_7_C_r3.proved : Section_3_3.eq_3_7_C_r3.statement).
Check (Section_3_3_proofs.eq_3_7_C_r3.met : Section_3_3.eq_3_7_C_r3.instance).
Check (Section_3_3_proofs.eq_3_7_C_r4.proved : Section_3_3.eq_3_7_C_r4.statement).
Check (Section_3_3_proofs.eq_3_7_C_r4.met : Section_3_3.eq_3_7_C_r4.instance).
Check (Section_3_3_proofs.eq_3_7_C_r5.proved : Section_3_3.eq_3_7_C_r5.statement).
Check (Section_3_3_proofs.eq_3_7_C_r5.met : Section_3_3.eq_3_7_C_r5.instance).
Check (Section_3_3_proofs.eq_3_7_C_r6.proved : Section_3_3.eq_3_7_C_r6.statement).
Check (Section_3_3_proofs.eq_3_7_C_r6.met : Section_3_3.eq_3_7_C_r6.instance).
Check (Section_3_3_proofs.eq_3_7_det.proved : Section_3_3.eq_3_7_det.statement).
Check (Section_3_3_proofs.eq_3_7_k.proved : Section_3_3.eq_3_7_k.statement).
Check (Section_3_3_proofs.eq_3_7_k.met : Section_3_3.eq_3_7_k.instance).
Check (Section_3_3_proofs.eq_3_7_k_needed.proved : Section_3_3.eq_3_7_k_needed.statement).
Check (Section_3_3_proofs.eq_3_7_k_needed.met : Section_3_3.eq_3_7_k_needed.instance).
Check (Section_3_3_proofs.eq_3_7_sol_p0u.proved : Section_3_3.eq_3_7_sol_p0u.statement).
Check (Section_3_3_proofs.eq_3_7_sol_p0u.met : Section_3_3.eq_3_7_sol_p0u.instance).
Check (Section_3_3_proofs.eq_3_7_sol_qu.proved : Section_3_3.eq_3_7_sol_qu.statement).
Check (Section_3_3_proofs.eq_3_7_sol_qu.met : Section_3_3.eq_3_7_sol_qu.instance).
Check (Section_3_3_proofs.eq_3_7_sol_p1u.proved : Section_3_3.eq_3_7_sol_p1u.statement).
Check (Section_3_3_proofs.eq_3_7_sol_p1u.met : Section_3_3.eq_3_7_sol_p1u.instance).
Check (Section_3_3_proofs.eq_3_7_sol_q.proved : Section_3_3.eq_3_7_sol_q.statement).
Check (Section_3_3_proofs.eq_3_7_sol_q.met : Section_3_3.eq_3_7_sol_q.instance).
Check (Section_3_3_proofs.eq_3_7_sol_p1.proved : Section_3_3.eq_3_7_sol_p1.statement).
Check (Section_3_3_proofs.eq_3_7_sol_p1.met : Section_3_3.eq_3_7_sol_p1.instance).
Check (Section_3_3_proofs.eq_3_7_sol_o.proved : Section_3_3.eq_3_7_sol_o.statement).
Check (Section_3_3_proofs.eq_3_7_sol_o.met : Section_3_3.eq_3_7_sol_o.instance).
Check (Section_3_3_proofs.eq_3_7_system.proved : Section_3_3.eq_3_7_system.statement).
Check (Section_3_3_proofs.eq_3_7_system.met : Section_3_3.eq_3_7_system.instance).
Check (Section_3_3_proofs.sec_3_3_advantage.proved : Section_3_3.sec_3_3_advantage.statement).
Check (Section_3_3_proofs.sec_3_3_advantage.met : Section_3_3.sec_3_3_advantage.instance).
Check (Section_3_3_proofs.ex_3_3_equation.refuted : ~ Section_3_3.ex_3_3_equation.statement).
Check (Section_3_3_proofs.ex_3_3_equation_true.proved : Section_3_3.ex_3_3_equation_true.statement).
Check (Section_3_3_proofs.ex_3_3_equation_true.met : Section_3_3.ex_3_3_equation_true.instance).
Check (Section_3_3_proofs.ex_3_3_p0u.proved : Section_3_3.ex_3_3_p0u.statement).
Check (Section_3_3_proofs.ex_3_3_p0u.met : Section_3_3.ex_3_3_p0u.instance).
Check (Section_3_3_proofs.ex_3_3_qu.proved : Section_3_3.ex_3_3_qu.statement).
Check (Section_3_3_proofs.ex_3_3_qu.met : Section_3_3.ex_3_3_qu.instance).
Check (Section_3_3_proofs.ex_3_3_p1u.proved : Section_3_3.ex_3_3_p1u.statement).
Check (Section_3_3_proofs.ex_3_3_p1u.met : Section_3_3.ex_3_3_p1u.instance).
Check (Section_3_3_proofs.ex_3_3_q.proved : Section_3_3.ex_3_3_q.statement).
Check (Section_3_3_proofs.ex_3_3_q.met : Section_3_3.ex_3_3_q.instance).
Check (Section_3_3_proofs.ex_3_3_p1.proved : Section_3_3.ex_3_3_p1.statement).
Check (Section_3_3_proofs.ex_3_3_p1.met : Section_3_3.ex_3_3_p1.instance).
Check (Section_3_3_proofs.ex_3_3_o.proved : Section_3_3.ex_3_3_o.statement).
Check (Section_3_3_proofs.ex_3_3_o.met : Section_3_3.ex_3_3_o.instance).
Check (Section_3_3_proofs.ex_3_3_parallel.proved : Section_3_3.ex_3_3_parallel.statement).
Check (Section_3_3_proofs.ex_3_3_parallel.met : Section_3_3.ex_3_3_parallel.instance).
Check (Section_3_3_proofs.fig_4d_constant.proved : Section_3_3.fig_4d_constant.statement).
Check (Section_3_3_proofs.fig_4d_constant.met : Section_3_3.fig_4d_constant.instance).
Check (Section_3_printed_proofs.def_3_1.proved : Section_3_printed.def_3_1.statement).
Check (Section_3_printed_proofs.def_3_1.met : Section_3_printed.def_3_1.instance).
Check (Section_3_printed_proofs.def_3_1_normal.proved : Section_3_printed.def_3_1_normal.statement).
Check (Section_3_printed_proofs.def_3_1_normal.met : Section_3_printed.def_3_1_normal.instance).
Check (Section_3_printed_proofs.def_3_2.proved : Section_3_printed.def_3_2.statement).
Check (Section_3_printed_proofs.def_3_2_lincomb.proved : Section_3_printed.def_3_2_lincomb.statement).
Check (Section_3_printed_proofs.sec_3_g_boundary.proved : Section_3_printed.sec_3_g_boundary.statement).
Check (Section_3_printed_proofs.sec_3_g_boundary.met : Section_3_printed.sec_3_g_boundary.instance).
Check (Section_3_printed_proofs.sec_3_g_prime.refuted : ~ Section_3_printed.sec_3_g_prime.statement).
Check (Section_3_printed_proofs.sec_3_g_prime_corrected.proved : Section_3_printed.sec_3_g_prime_corrected.statement).
Check (Section_3_printed_proofs.sec_3_g_prime_corrected.met : Section_3_printed.sec_3_g_prime_corrected.instance).
Check (Section_3_printed_proofs.eq_3_1.proved : Section_3_printed.eq_3_1.statement).
Check (Section_3_printed_proofs.eq_3_1.met : Section_3_printed.eq_3_1.instance).
Check (Section_3_printed_proofs.eq_3_1_must.proved : Section_3_printed.eq_3_1_must.statement).
Check (Section_3_printed_proofs.eq_3_1_must.met : Section_3_printed.eq_3_1_must.instance).
Check (Section_3_printed_proofs.eq_3_1_types_a.proved : Section_3_printed.eq_3_1_types_a.statement).
Check (Section_3_printed_proofs.eq_3_1_types_a.met : Section_3_printed.eq_3_1_types_a.instance).
Check (Section_3_printed_proofs.eq_3_1_types_b.proved : Section_3_printed.eq_3_1_types_b.statement).
Check (Section_3_printed_proofs.eq_3_1_parallel_planes.proved : Section_3_printed.eq_3_1_parallel_planes.statement).
Check (Section_3_printed_proofs.eq_3_1_parallel_planes.met : Section_3_printed.eq_3_1_parallel_planes.instance).
Check (Section_3_printed_proofs.eq_3_1_rho_constant.proved : Section_3_printed.eq_3_1_rho_constant.statement).
Check (Section_3_printed_proofs.eq_3_1_rho_constant.met : Section_3_printed.eq_3_1_rho_constant.instance).
Check (Section_3_printed_proofs.eq_3_1_rho_quadratic.proved : Section_3_printed.eq_3_1_rho_quadratic.statement).
Check (Section_3_printed_proofs.eq_3_1_rho_quadratic.met : Section_3_printed.eq_3_1_rho_quadratic.instance).
Check (Section_3_printed_proofs.eq_3_1_difficulties_same.proved : Section_3_printed.eq_3_1_difficulties_same.statement).
Check (Section_3_printed_proofs.eq_3_1_difficulties_same.met : Section_3_printed.eq_3_1_difficulties_same.instance).
Check (Section_3_printed_proofs.eq_3_2.proved : Section_3_printed.eq_3_2.statement).
Check (Section_3_printed_proofs.eq_3_2.met : Section_3_printed.eq_3_2.instance).
Check (Section_3_printed_proofs.eq_3_2_edge.proved : Section_3_printed.eq_3_2_edge.statement).
Check (Section_3_printed_proofs.eq_3_2_edge.met : Section_3_printed.eq_3_2_edge.instance).
Check (Section_3_printed_proofs.eq_3_2_planes_a_generatrix.refuted : ~ Section_3_printed.eq_3_2_planes_a_generatrix.statement).
Check (Section_3_printed_proofs.eq_3_2_planes_a_direction.proved : Section_3_printed.eq_3_2_planes_a_direction.statement).
Check (Section_3_printed_proofs.eq_3_2_planes_a_direction.met : Section_3_printed.eq_3_2_planes_a_direction.instance).
Check (Section_3_printed_proofs.eq_3_2_planes_b_generatrix.refuted : ~ Section_3_printed.eq_3_2_planes_b_generatrix.statement).
Check (Section_3_printed_proofs.eq_3_2_planes_b_direction.refuted : ~ Section_3_printed.eq_3_2_planes_b_direction.statement).
Check (Section_3_printed_proofs.eq_3_2_planes_parallel.proved : Section_3_printed.eq_3_2_planes_parallel.statement).
Check (Section_3_printed_proofs.eq_3_2_planes_parallel.met : Section_3_printed.eq_3_2_planes_parallel.instance).
Check (Section_3_printed_proofs.eq_3_2_with_h.proved : Section_3_printed.eq_3_2_with_h.statement).
Check (Section_3_printed_proofs.eq_3_2_with_h.met : Section_3_printed.eq_3_2_with_h.instance).
Check (Section_3_printed_proofs.eq_3_2_across.proved : Section_3_printed.eq_3_2_across.statement).
Check (Section_3_printed_proofs.eq_3_2_across.met : Section_3_printed.eq_3_2_across.instance).
Check (Section_3_printed_proofs.eq_3_2_across_summit.proved : Section_3_printed.eq_3_2_across_summit.statement).
Check (Section_3_printed_proofs.eq_3_2_across_summit.met : Section_3_printed.eq_3_2_across_summit.instance).
Check (Section_3_printed_proofs.eq_3_2_every_degree.proved : Section_3_printed.eq_3_2_every_degree.statement).
Check (Section_3_printed_proofs.eq_3_2_every_degree.met : Section_3_printed.eq_3_2_every_degree.instance).
Check (Section_3_printed_proofs.eq_3_3_g_generatrix.refuted : ~ Section_3_printed.eq_3_3_g_generatrix.statement).
Check (Section_3_printed_proofs.eq_3_3_g_direction.proved : Section_3_printed.eq_3_3_g_direction.statement).
Check (Section_3_printed_proofs.eq_3_3_g_true.proved : Section_3_printed.eq_3_3_g_true.statement).
Check (Section_3_printed_proofs.eq_3_3a.proved : Section_3_printed.eq_3_3a.statement).
Check (Section_3_printed_proofs.eq_3_3a.met : Section_3_printed.eq_3_3a.instance).
Check (Section_3_printed_proofs.eq_3_3b.proved : Section_3_printed.eq_3_3b.statement).
Check (Section_3_printed_proofs.eq_3_3b.met : Section_3_printed.eq_3_3b.instance).
Check (Section_3_printed_proofs.eq_3_3_same_as_3_2_generatrix.refuted : ~ Section_3_printed.eq_3_3_same_as_3_2_generatrix.statement).
Check (Section_3_printed_proofs.eq_3_3_same_as_3_2_direction.proved : Section_3_printed.eq_3_3_same_as_3_2_direction.statement).
Check (Section_3_printed_proofs.eq_3_3_same_as_3_2_direction.met : Section_3_printed.eq_3_3_same_as_3_2_direction.instance).
Check (Section_3_printed_proofs.eq_3_3_same_as_3_2_true.proved : Section_3_printed.eq_3_3_same_as_3_2_true.statement).
Check (Section_3_printed_proofs.eq_3_3_same_as_3_2_true.met : Section_3_printed.eq_3_3_same_as_3_2_true.instance).
Check (Section_3_printed_proofs.eq_3_3_developable_Hermite.proved : Section_3_printed.eq_3_3_developable_Hermite.statement).
Check (Section_3_printed_proofs.eq_3_3_developable_Hermite.met : Section_3_printed.eq_3_3_developable_Hermite.instance).
Check (Section_3_printed_proofs.eq_3_3_developable_any.refuted : ~ Section_3_printed.eq_3_3_developable_any.statement).
Check (Section_3_printed_proofs.eq_3_3_exact.proved : Section_3_printed.eq_3_3_exact.statement).
Check (Section_3_printed_proofs.eq_3_3_exact.met : Section_3_printed.eq_3_3_exact.instance).
Check (Section_3_printed_proofs.eq_3_3_multiples_cone.proved : Section_3_printed.eq_3_3_multiples_cone.statement).
Check (Section_3_printed_proofs.eq_3_3_multiples_cone.met : Section_3_printed.eq_3_3_multiples_cone.instance).
Check (Section_3_printed_proofs.eq_3_3_multiples_Hermite.proved : Section_3_printed.eq_3_3_multiples_Hermite.statement).
Check (Section_3_printed_proofs.eq_3_3_multiples_Hermite.met : Section_3_printed.eq_3_3_multiples_Hermite.instance).
Check (Section_3_printed_proofs.eq_3_3_multiples_any.refuted : ~ Section_3_printed.eq_3_3_multiples_any.statement).
Check (Section_3_printed_proofs.eq_3_3_k_below_1.proved : Section_3_printed.eq_3_3_k_below_1.statement).
Check (Section_3_printed_proofs.eq_3_3_k_below_1.met : Section_3_printed.eq_3_3_k_below_1.instance).
Check (Section_3_printed_proofs.eq_3_3_k_equal_1.proved : Section_3_printed.eq_3_3_k_equal_1.statement).
Check (Section_3_printed_proofs.eq_3_3_k_equal_1.met : Section_3_printed.eq_3_3_k_equal_1.instance).
Check (Section_3_printed_proofs.eq_3_3_k_above_1.proved : Section_3_printed.eq_3_3_k_above_1.statement).
Check (Section_3_printed_proofs.eq_3_3_k_above_1.met : Section_3_printed.eq_3_3_k_above_1.instance).
Check (Section_3_printed_proofs.sec_3_summit_outside.proved : Section_3_printed.sec_3_summit_outside.statement).
Check (Section_3_printed_proofs.sec_3_summit_outside.met : Section_3_printed.sec_3_summit_outside.instance).
Check (Section_3_printed_proofs.eq_3_4.proved : Section_3_printed.eq_3_4.statement).
Check (Section_3_printed_proofs.eq_3_4.met : Section_3_printed.eq_3_4.instance).
Check (Section_3_proofs.def_3_1.proved : Section_3.def_3_1.statement).
Check (Section_3_proofs.def_3_1.met : Section_3.def_3_1.instance).
Check (Section_3_proofs.def_3_1_normal.proved : Section_3.def_3_1_normal.statement).
Check (Section_3_proofs.def_3_1_normal.met : Section_3.def_3_1_normal.instance).
Check (Section_3_proofs.def_3_2.proved : Section_3.def_3_2.statement).
Check (Section_3_proofs.def_3_2_lincomb.proved : Section_3.def_3_2_lincomb.statement).
Check (Section_3_proofs.sec_3_g_boundary.proved : Section_3.sec_3_g_boundary.statement).
Check (Section_3_proofs.sec_3_g_boundary.met : Section_3.sec_3_g_boundary.instance).
Check (Section_3_proofs.sec_3_g_prime.refuted : ~ Section_3.sec_3_g_prime.statement).
Check (Section_3_proofs.sec_3_g_prime_corrected.proved : Section_3.sec_3_g_prime_corrected.statement).
Check (Section_3_proofs.sec_3_g_prime_corrected.met : Section_3.sec_3_g_prime_corrected.instance).
Check (Section_3_proofs.eq_3_1.proved : Section_3.eq_3_1.statement).
Check (Section_3_proofs.eq_3_1.met : Section_3.eq_3_1.instance).
Check (Section_3_proofs.eq_3_1_must.proved : Section_3.eq_3_1_must.statement).
Check (Section_3_proofs.eq_3_1_must.met : Section_3.eq_3_1_must.instance).
Check (Section_3_proofs.eq_3_1_types_a.proved : Section_3.eq_3_1_types_a.statement).
Check (Section_3_proofs.eq_3_1_types_a.met : Section_3.eq_3_1_types_a.instance).
Check (Section_3_proofs.eq_3_1_types_b.proved : Section_3.eq_3_1_types_b.statement).
Check (Section_3_proofs.eq_3_1_parallel_planes.proved : Section_3.eq_3_1_parallel_planes.statement).
Check (Section_3_proofs.eq_3_1_parallel_planes.met : Section_3.eq_3_1_parallel_planes.instance).
Check (Section_3_proofs.eq_3_1_rho_constant.proved : Section_3.eq_3_1_rho_constant.statement).
Check (Section_3_proofs.eq_3_1_rho_constant.met : Section_3.eq_3_1_rho_constant.instance).
Check (Section_3_proofs.eq_3_1_rho_quadratic.proved : Section_3.eq_3_1_rho_quadratic.statement).
Check (Section_3_proofs.eq_3_1_rho_quadratic.met : Section_3.eq_3_1_rho_quadratic.instance).
Check (Section_3_proofs.eq_3_1_difficulties_same.proved : Section_3.eq_3_1_difficulties_same.statement).
Check (Section_3_proofs.eq_3_1_difficulties_same.met : Section_3.eq_3_1_difficulties_same.instance).
Check (Section_3_proofs.eq_3_2.proved : Section_3.eq_3_2.statement).
Check (Section_3_proofs.eq_3_2.met : Section_3.eq_3_2.instance).
Check (Section_3_proofs.eq_3_2_edge.proved : Section_3.eq_3_2_edge.statement).
Check (Section_3_proofs.eq_3_2_edge.met : Section_3.eq_3_2_edge.instance).
Check (Section_3_proofs.eq_3_2_planes_a_generatrix.refuted : ~ Section_3.eq_3_2_planes_a_generatrix.statement).
Check (Section_3_proofs.eq_3_2_planes_a_direction.proved : Section_3.eq_3_2_planes_a_direction.statement).
Check (Section_3_proofs.eq_3_2_planes_a_direction.met : Section_3.eq_3_2_planes_a_direction.instance).
Check (Section_3_proofs.eq_3_2_planes_b_generatrix.refuted : ~ Section_3.eq_3_2_planes_b_generatrix.statement).
Check (Section_3_proofs.eq_3_2_planes_b_direction.refuted : ~ Section_3.eq_3_2_planes_b_direction.statement).
Check (Section_3_proofs.eq_3_2_planes_parallel.proved : Section_3.eq_3_2_planes_parallel.statement).
Check (Section_3_proofs.eq_3_2_planes_parallel.met : Section_3.eq_3_2_planes_parallel.instance).
Check (Section_3_proofs.eq_3_2_with_h.proved : Section_3.eq_3_2_with_h.statement).
Check (Section_3_proofs.eq_3_2_with_h.met : Section_3.eq_3_2_with_h.instance).
Check (Section_3_proofs.eq_3_2_across.proved : Section_3.eq_3_2_across.statement).
Check (Section_3_proofs.eq_3_2_across.met : Section_3.eq_3_2_across.instance).
Check (Section_3_proofs.eq_3_2_across_summit.proved : Section_3.eq_3_2_across_summit.statement).
Check (Section_3_proofs.eq_3_2_across_summit.met : Section_3.eq_3_2_across_summit.instance).
Check (Section_3_proofs.eq_3_2_every_degree.proved : Section_3.eq_3_2_every_degree.statement).
Check (Section_3_proofs.eq_3_2_every_degree.met : Section_3.eq_3_2_every_degree.instance).
Check (Section_3_proofs.eq_3_3_g_generatrix.refuted : ~ Section_3.eq_3_3_g_generatrix.statement).
Check (Section_3_proofs.eq_3_3_g_direction.proved : Section_3.eq_3_3_g_direction.statement).
Check (Section_3_proofs.eq_3_3_g_true.proved : Section_3.eq_3_3_g_true.statement).
Check (Section_3_proofs.eq_3_3a.proved : Section_3.eq_3_3a.statement).
Check (Section_3_proofs.eq_3_3a.met : Section_3.eq_3_3a.instance).
Check (Section_3_proofs.eq_3_3b.proved : Section_3.eq_3_3b.statement).
Check (Section_3_proofs.eq_3_3b.met : Section_3.eq_3_3b.instance).
Check (Section_3_proofs.eq_3_3_same_as_3_2_generatrix.refuted : ~ Section_3.eq_3_3_same_as_3_2_generatrix.statement).
Check (Section_3_proofs.eq_3_3_same_as_3_2_direction.proved : Section_3.eq_3_3_same_as_3_2_direction.statement).
Check (Section_3_proofs.eq_3_3_same_as_3_2_direction.met : Section_3.eq_3_3_same_as_3_2_direction.instance).
Check (Section_3_proofs.eq_3_3_same_as_3_2_true.proved : Section_3.eq_3_3_same_as_3_2_true.statement).
Check (Section_3_proofs.eq_3_3_same_as_3_2_true.met : Section_3.eq_3_3_same_as_3_2_true.instance).
Check (Section_3_proofs.eq_3_3_developable_Hermite.proved : Section_3.eq_3_3_developable_Hermite.statement).
Check (Section_3_proofs.eq_3_3_developable_Hermite.met : Section_3.eq_3_3_developable_Hermite.instance).
Check (Section_3_proofs.eq_3_3_developable_any.refuted : ~ Section_3.eq_3_3_developable_any.statement).
Check (Section_3_proofs.eq_3_3_exact.proved : Section_3.eq_3_3_exact.statement).
Check (Section_3_proofs.eq_3_3_exact.met : Section_3.eq_3_3_exact.instance).
Check (Section_3_proofs.eq_3_3_multiples_cone.proved : Section_3.eq_3_3_multiples_cone.statement).
Check (Section_3_proofs.eq_3_3_multiples_cone.met : Section_3.eq_3_3_multiples_cone.instance).
Check (Section_3_proofs.eq_3_3_multiples_Hermite.proved : Section_3.eq_3_3_multiples_Hermite.statement).
Check (Section_3_proofs.eq_3_3_multiples_Hermite.met : Section_3.eq_3_3_multiples_Hermite.instance).
Check (Section_3_proofs.eq_3_3_multiples_any.refuted : ~ Section_3.eq_3_3_multiples_any.statement).
Check (Section_3_proofs.eq_3_3_k_below_1.proved : Section_3.eq_3_3_k_below_1.statement).
Check (Section_3_proofs.eq_3_3_k_below_1.met : Section_3.eq_3_3_k_below_1.instance).
Check (Section_3_proofs.eq_3_3_k_equal_1.proved : Section_3.eq_3_3_k_equal_1.statement).
Check (Section_3_proofs.eq_3_3_k_equal_1.met : Section_3.eq_3_3_k_equal_1.instance).
Check (Section_3_proofs.eq_3_3_k_above_1.proved : Section_3.eq_3_3_k_above_1.statement).
Check (Section_3_proofs.eq_3_3_k_above_1.met : Section_3.eq_3_3_k_above_1.instance).
Check (Section_3_proofs.sec_3_summit_outside.proved : Section_3.sec_3_summit_outside.statement).
Check (Section_3_proofs.sec_3_summit_outside.met : Section_3.sec_3_summit_outside.instance).
Check (Section_3_proofs.eq_3_4.proved : Section_3.eq_3_4.statement).
Check (Section_3_proofs.eq_3_4.met : Section_3.eq_3_4.instance).
Check (Section_4_printed_proofs.sec_4_cone.proved : Section_4_printed.sec_4_cone.statement).
Check (Section_4_printed_proofs.sec_4_cone.met : Section_4_printed.sec_4_cone.instance).
Check (Section_4_printed_proofs.eq_4_1.proved : Section_4_printed.eq_4_1.statement).
Check (Section_4_printed_proofs.eq_4_1.met : Section_4_printed.eq_4_1.instance).
Check (Section_4_printed_proofs.sec_4_goal_designed.refuted : ~ Section_4_printed.sec_4_goal_designed.statement).
Check (Section_4_printed_proofs.sec_4_goal_image.proved : Section_4_printed.sec_4_goal_image.statement).
Check (Section_4_printed_proofs.sec_4_goal_image.met : Section_4_printed.sec_4_goal_image.instance).
Check (Section_4_printed_proofs.sec_4_goal_leaves.proved : Section_4_printed.sec_4_goal_leaves.statement).
Check (Section_4_printed_proofs.sec_4_goal_leaves.met : Section_4_printed.sec_4_goal_leaves.instance).
Check (Section_4_printed_proofs.sec_4_goal_nodes.proved : Section_4_printed.sec_4_goal_nodes.statement).
Check (Section_4_printed_proofs.sec_4_goal_nodes.met : Section_4_printed.sec_4_goal_nodes.instance).
Check (Section_4_printed_proofs.sec_4_goal_only.proved : Section_4_printed.sec_4_goal_only.statement).
Check (Section_4_printed_proofs.sec_4_goal_only.met : Section_4_printed.sec_4_goal_only.instance).
Check (Section_4_printed_proofs.sec_4_goal_parallel.proved : Section_4_printed.sec_4_goal_parallel.statement).
Check (Section_4_printed_proofs.sec_4_goal_parallel.met : Section_4_printed.sec_4_goal_parallel.instance).
Check (Section_4_printed_proofs.sec_4_in_plane.proved : Section_4_printed.sec_4_in_plane.statement).
Check (Section_4_printed_proofs.sec_4_in_plane.met : Section_4_printed.sec_4_in_plane.instance).
Check (Section_4_printed_proofs.sec_4_r0.proved : Section_4_printed.sec_4_r0.statement).
Check (Section_4_printed_proofs.sec_4_r0.met : Section_4_printed.sec_4_r0.instance).
Check (Section_4_printed_proofs.sec_4_I1.proved : Section_4_printed.sec_4_I1.statement).
Check (Section_4_printed_proofs.sec_4_I1.met : Section_4_printed.sec_4_I1.instance).
Check (Section_4_printed_proofs.sec_4_w.proved : Section_4_printed.sec_4_w.statement).
Check (Section_4_printed_proofs.sec_4_w.met : Section_4_printed.sec_4_w.instance).
Check (Section_4_printed_proofs.eq_4_2.proved : Section_4_printed.eq_4_2.statement).
Check (Section_4_printed_proofs.eq_4_2.met : Section_4_printed.eq_4_2.instance).
Check (Section_4_printed_proofs.eq_4_2_tangent_derivative.refuted : ~ Section_4_printed.eq_4_2_tangent_derivative.statement).
Check (Section_4_printed_proofs.eq_4_2_tangent_end_point.proved : Section_4_printed.eq_4_2_tangent_end_point.statement).
Check (Section_4_printed_proofs.eq_4_2_tangent_end_point.met : Section_4_printed.eq_4_2_tangent_end_point.instance).
Check (Section_4_printed_proofs.eq_4_2_tangent_parallel.proved : Section_4_printed.eq_4_2_tangent_parallel.statement).
Check (Section_4_printed_proofs.eq_4_2_tangent_parallel.met : Section_4_printed.eq_4_2_tangent_parallel.instance).
Check (Section_4_printed_proofs.eq_4_2_tangent_true.proved : Section_4_printed.eq_4_2_tangent_true.statement).
Check (Section_4_printed_proofs.eq_4_2_tangent_true.met : Section_4_printed.eq_4_2_tangent_true.instance).
Check (Section_4_printed_proofs.sec_4_s.proved : Section_4_printed.sec_4_s.statement).
Check (Section_4_printed_proofs.sec_4_s.met : Section_4_printed.sec_4_s.instance).
Check (Section_4_printed_proofs.eq_4_3.proved : Section_4_printed.eq_4_3.statement).
Check (Section_4_printed_proofs.eq_4_3.met : Section_4_printed.eq_4_3.instance).
Check (Section_4_printed_proofs.eq_4_4_ru.proved : Section_4_printed.eq_4_4_ru.statement).
Check (Section_4_printed_proofs.eq_4_4_ru.met : Section_4_printed.eq_4_4_ru.instance).
Check (Section_4_printed_proofs.eq_4_4_r1.proved : Section_4_printed.eq_4_4_r1.statement).
Check (Section_4_printed_proofs.eq_4_4_r1.met : Section_4_printed.eq_4_4_r1.instance).
Check (Section_4_printed_proofs.eq_4_4_r1u.proved : Section_4_printed.eq_4_4_r1u.statement).
Check (Section_4_printed_proofs.eq_4_4_r1u.met : Section_4_printed.eq_4_4_r1u.instance).
Check (Section_4_printed_proofs.eq_4_4_tangent_derivative.refuted : ~ Section_4_printed.eq_4_4_tangent_derivative.statement).
Check (Section_4_printed_proofs.eq_4_4_tangent_end_point.proved : Section_4_printed.eq_4_4_tangent_end_point.statement).
Check (Section_4_printed_proofs.eq_4_4_tangent_end_point.met : Section_4_printed.eq_4_4_tangent_end_point.instance).
Check (Section_4_printed_proofs.eq_4_4_tangent_parallel.proved : Section_4_printed.eq_4_4_tangent_parallel.statement).
Check (Section_4_printed_proofs.eq_4_4_tangent_parallel.met : Section_4_printed.eq_4_4_tangent_parallel.instance).
Check (Section_4_printed_proofs.sec_4_oblique.proved : Section_4_printed.sec_4_oblique.statement).
Check (Section_4_printed_proofs.ex_4_data.proved : Section_4_printed.ex_4_data.statement).
Check (Section_4_printed_proofs.ex_4_data.met : Section_4_printed.ex_4_data.instance).
Check (Section_4_printed_proofs.ex_4_r0.proved : Section_4_printed.ex_4_r0.statement).
Check (Section_4_printed_proofs.ex_4_r0.met : Section_4_printed.ex_4_r0.instance).
Check (Section_4_printed_proofs.ex_4_r0u.refuted : ~ Section_4_printed.ex_4_r0u.statement).
Check (Section_4_printed_proofs.ex_4_r.proved : Section_4_printed.ex_4_r.statement).
Check (Section_4_printed_proofs.ex_4_r.met : Section_4_printed.ex_4_r.instance).
Check (Section_4_printed_proofs.ex_4_ru.refuted : ~ Section_4_printed.ex_4_ru.statement).
Check (Section_4_printed_proofs.ex_4_r1.proved : Section_4_printed.ex_4_r1.statement).
Check (Section_4_printed_proofs.ex_4_r1.met : Section_4_printed.ex_4_r1.instance).
Check (Section_4_printed_proofs.ex_4_r1_rounding.proved : Section_4_printed.ex_4_r1_rounding.statement).
Check (Section_4_printed_proofs.ex_4_r1_rounding.met : Section_4_printed.ex_4_r1_rounding.instance).
Check (Section_4_printed_proofs.ex_4_r1u.refuted : ~ Section_4_printed.ex_4_r1u.statement).
Check (Section_4_printed_proofs.ex_4_other_data.proved : Section_4_printed.ex_4_other_data.statement).
Check (Section_4_printed_proofs.ex_4_other_data.met : Section_4_printed.ex_4_other_data.instance).
Check (Section_4_printed_proofs.ex_4_other_data_twist.proved : Section_4_printed.ex_4_other_data_twist.statement).
Check (Section_4_printed_proofs.ex_4_other_data_twist.met : Section_4_printed.ex_4_other_data_twist.instance).
Check (Section_4_printed_proofs.ex_4_stated_data.proved : Section_4_printed.ex_4_stated_data.statement).
Check (Section_4_printed_proofs.ex_4_stated_data.met : Section_4_printed.ex_4_stated_data.instance).
Check (Section_4_printed_proofs.ex_4_true_tangents.proved : Section_4_printed.ex_4_true_tangents.statement).
Check (Section_4_printed_proofs.ex_4_true_tangents.met : Section_4_printed.ex_4_true_tangents.instance).
Check (Section_4_printed_proofs.ex_4_a_developable_computed.refuted : ~ Section_4_printed.ex_4_a_developable_computed.statement).
Check (Section_4_printed_proofs.ex_4_a_developable_printed.refuted : ~ Section_4_printed.ex_4_a_developable_printed.statement).
Check (Section_4_printed_proofs.ex_4_a_twist.proved : Section_4_printed.ex_4_a_twist.statement).
Check (Section_4_printed_proofs.ex_4_a_twist.met : Section_4_printed.ex_4_a_twist.instance).
Check (Section_4_printed_proofs.ex_4_a_twist_most.proved : Section_4_printed.ex_4_a_twist_most.statement).
Check (Section_4_printed_proofs.ex_4_a_twist_most.met : Section_4_printed.ex_4_a_twist_most.instance).
Check (Section_4_printed_proofs.ex_4_a_twist_printed.proved : Section_4_printed.ex_4_a_twist_printed.statement).
Check (Section_4_printed_proofs.ex_4_a_twist_printed.met : Section_4_printed.ex_4_a_twist_printed.instance).
Check (Section_4_printed_proofs.ex_4_b_developable.refuted : ~ Section_4_printed.ex_4_b_developable.statement).
Check (Section_4_printed_proofs.ex_4_b_twist.proved : Section_4_printed.ex_4_b_twist.statement).
Check (Section_4_printed_proofs.ex_4_b_twist.met : Section_4_printed.ex_4_b_twist.instance).
Check (Section_4_proofs.sec_4_cone.proved : Section_4.sec_4_cone.statement).
Check (Section_4_proofs.sec_4_cone.met : Section_4.sec_4_cone.instance).
Check (Section_4_proofs.eq_4_1.proved : Section_4.eq_4_1.statement).
Check (Section_4_proofs.eq_4_1.met : Section_4.eq_4_1.instance).
Check (Section_4_proofs.sec_4_goal_designed.refuted : ~ Section_4.sec_4_goal_designed.statement).
Check (Section_4_proofs.sec_4_goal_image.proved : Section_4.sec_4_goal_image.statement).
Check (Section_4_proofs.sec_4_goal_image.met : Section_4.sec_4_goal_image.instance).
Check (Section_4_proofs.sec_4_goal_leaves.proved : Section_4.sec_4_goal_leaves.statement).
Check (Section_4_proofs.sec_4_goal_leaves.met : Section_4.sec_4_goal_leaves.instance).
Check (Section_4_proofs.sec_4_goal_nodes.proved : Section_4.sec_4_goal_nodes.statement).
Check (Section_4_proofs.sec_4_goal_nodes.met : Section_4.sec_4_goal_nodes.instance).
Check (Section_4_proofs.sec_4_goal_only.proved : Section_4.sec_4_goal_only.statement).
Check (Section_4_proofs.sec_4_goal_only.met : Section_4.sec_4_goal_only.instance).
Check (Section_4_proofs.sec_4_goal_parallel.proved : Section_4.sec_4_goal_parallel.statement).
Check (Section_4_proofs.sec_4_goal_parallel.met : Section_4.sec_4_goal_parallel.instance).
Check (Section_4_proofs.sec_4_in_plane.proved : Section_4.sec_4_in_plane.statement).
Check (Section_4_proofs.sec_4_in_plane.met : Section_4.sec_4_in_plane.instance).
Check (Section_4_proofs.sec_4_r0.proved : Section_4.sec_4_r0.statement).
Check (Section_4_proofs.sec_4_r0.met : Section_4.sec_4_r0.instance).
Check (Section_4_proofs.sec_4_I1.proved : Section_4.sec_4_I1.statement).
Check (Section_4_proofs.sec_4_I1.met : Section_4.sec_4_I1.instance).
Check (Section_4_proofs.sec_4_w.proved : Section_4.sec_4_w.statement).
Check (Section_4_proofs.sec_4_w.met : Section_4.sec_4_w.instance).
Check (Section_4_proofs.eq_4_2.proved : Section_4.eq_4_2.statement).
Check (Section_4_proofs.eq_4_2.met : Section_4.eq_4_2.instance).
Check (Section_4_proofs.eq_4_2_tangent_derivative.refuted : ~ Section_4.eq_4_2_tangent_derivative.statement).
Check (Section_4_proofs.eq_4_2_tangent_end_point.proved : Section_4.eq_4_2_tangent_end_point.statement).
Check (Section_4_proofs.eq_4_2_tangent_end_point.met : Section_4.eq_4_2_tangent_end_point.instance).
Check (Section_4_proofs.eq_4_2_tangent_parallel.proved : Section_4.eq_4_2_tangent_parallel.statement).
Check (Section_4_proofs.eq_4_2_tangent_parallel.met : Section_4.eq_4_2_tangent_parallel.instance).
Check (Section_4_proofs.eq_4_2_tangent_true.proved : Section_4.eq_4_2_tangent_true.statement).
Check (Section_4_proofs.eq_4_2_tangent_true.met : Section_4.eq_4_2_tangent_true.instance).
Check (Section_4_proofs.sec_4_s.proved : Section_4.sec_4_s.statement).
Check (Section_4_proofs.sec_4_s.met : Section_4.sec_4_s.instance).
Check (Section_4_proofs.eq_4_3.proved : Section_4.eq_4_3.statement).
Check (Section_4_proofs.eq_4_3.met : Section_4.eq_4_3.instance).
Check (Section_4_proofs.eq_4_4_ru.proved : Section_4.eq_4_4_ru.statement).
Check (Section_4_proofs.eq_4_4_ru.met : Section_4.eq_4_4_ru.instance).
Check (Section_4_proofs.eq_4_4_r1.proved : Section_4.eq_4_4_r1.statement).
Check (Section_4_proofs.eq_4_4_r1.met : Section_4.eq_4_4_r1.instance).
Check (Section_4_proofs.eq_4_4_r1u.proved : Section_4.eq_4_4_r1u.statement).
Check (Section_4_proofs.eq_4_4_r1u.met : Section_4.eq_4_4_r1u.instance).
Check (Section_4_proofs.eq_4_4_tangent_derivative.refuted : ~ Section_4.eq_4_4_tangent_derivative.statement).
Check (Section_4_proofs.eq_4_4_tangent_end_point.proved : Section_4.eq_4_4_tangent_end_point.statement).
Check (Section_4_proofs.eq_4_4_tangent_end_point.met : Section_4.eq_4_4_tangent_end_point.instance).
Check (Section_4_proofs.eq_4_4_tangent_parallel.proved : Section_4.eq_4_4_tangent_parallel.statement).
Check (Section_4_proofs.eq_4_4_tangent_parallel.met : Section_4.eq_4_4_tangent_parallel.instance).
Check (Section_4_proofs.sec_4_oblique.proved : Section_4.sec_4_oblique.statement).
Check (Section_4_proofs.ex_4_data.proved : Section_4.ex_4_data.statement).
Check (Section_4_proofs.ex_4_data.met : Section_4.ex_4_data.instance).
Check (Section_4_proofs.ex_4_r0.proved : Section_4.ex_4_r0.statement).
Check (Section_4_proofs.ex_4_r0.met : Section_4.ex_4_r0.instance).
Check (Section_4_proofs.ex_4_r0u.refuted : ~ Section_4.ex_4_r0u.statement).
Check (Section_4_proofs.ex_4_r.proved : Section_4.ex_4_r.statement).
Check (Section_4_proofs.ex_4_r.met : Section_4.ex_4_r.instance).
Check (Section_4_proofs.ex_4_ru.refuted : ~ Section_4.ex_4_ru.statement).
Check (Section_4_proofs.ex_4_r1.proved : Section_4.ex_4_r1.statement).
Check (Section_4_proofs.ex_4_r1.met : Section_4.ex_4_r1.instance).
Check (Section_4_proofs.ex_4_r1_rounding.proved : Section_4.ex_4_r1_rounding.statement).
Check (Section_4_proofs.ex_4_r1_rounding.met : Section_4.ex_4_r1_rounding.instance).
Check (Section_4_proofs.ex_4_r1u.refuted : ~ Section_4.ex_4_r1u.statement).
Check (Section_4_proofs.ex_4_other_data.proved : Section_4.ex_4_other_data.statement).
Check (Section_4_proofs.ex_4_other_data.met : Section_4.ex_4_other_data.instance).
Check (Section_4_proofs.ex_4_other_data_twist.proved : Section_4.ex_4_other_data_twist.statement).
Check (Section_4_proofs.ex_4_other_data_twist.met : Section_4.ex_4_other_data_twist.instance).
Check (Section_4_proofs.ex_4_stated_data.proved : Section_4.ex_4_stated_data.statement).
Check (Section_4_proofs.ex_4_stated_data.met : Section_4.ex_4_stated_data.instance).
Check (Section_4_proofs.ex_4_true_tangents.proved : Section_4.ex_4_true_tangents.statement).
Check (Section_4_proofs.ex_4_true_tangents.met : Section_4.ex_4_true_tangents.instance).
Check (Section_4_proofs.ex_4_a_developable_computed.refuted : ~ Section_4.ex_4_a_developable_computed.statement).
Check (Section_4_proofs.ex_4_a_developable_printed.refuted : ~ Section_4.ex_4_a_developable_printed.statement).
Check (Section_4_proofs.ex_4_a_twist.proved : Section_4.ex_4_a_twist.statement).
Check (Section_4_proofs.ex_4_a_twist.met : Section_4.ex_4_a_twist.instance).
Check (Section_4_proofs.ex_4_a_twist_most.proved : Section_4.ex_4_a_twist_most.statement).
Check (Section_4_proofs.ex_4_a_twist_most.met : Section_4.ex_4_a_twist_most.instance).
Check (Section_4_proofs.ex_4_a_twist_printed.proved : Section_4.ex_4_a_twist_printed.statement).
Check (Section_4_proofs.ex_4_a_twist_printed.met : Section_4.ex_4_a_twist_printed.instance).
Check (Section_4_proofs.ex_4_b_developable.refuted : ~ Section_4.ex_4_b_developable.statement).
Check (Section_4_proofs.ex_4_b_twist.proved : Section_4.ex_4_b_twist.statement).
Check (Section_4_proofs.ex_4_b_twist.met : Section_4.ex_4_b_twist.instance).
Check (Section_5_printed_proofs.sec_5_criteria_a.proved : Section_5_printed.sec_5_criteria_a.statement).
Check (Section_5_printed_proofs.sec_5_criteria_a.met : Section_5_printed.sec_5_criteria_a.instance).
Check (Section_5_printed_proofs.sec_5_criteria_reach.proved : Section_5_printed.sec_5_criteria_reach.statement).
Check (Section_5_printed_proofs.sec_5_criteria_reach.met : Section_5_printed.sec_5_criteria_reach.instance).
Check (Section_5_printed_proofs.sec_5_planes_a.proved : Section_5_printed.sec_5_planes_a.statement).
Check (Section_5_printed_proofs.sec_5_planes_a.met : Section_5_printed.sec_5_planes_a.instance).
Check (Section_5_printed_proofs.sec_5_planes_parallel.proved : Section_5_printed.sec_5_planes_parallel.statement).
Check (Section_5_printed_proofs.sec_5_planes_parallel.met : Section_5_printed.sec_5_planes_parallel.instance).
Check (Section_5_printed_proofs.sec_5_planes_b.refuted : ~ Section_5_printed.sec_5_planes_b.statement).
Check (Section_5_proofs.sec_5_criteria_a.proved : Section_5.sec_5_criteria_a.statement).
Check (Section_5_proofs.sec_5_criteria_a.met : Section_5.sec_5_criteria_a.instance).
Check (Section_5_proofs.sec_5_criteria_reach.proved : Section_5.sec_5_criteria_reach.statement).
Check (Section_5_proofs.sec_5_criteria_reach.met : Section_5.sec_5_criteria_reach.instance).
Check (Section_5_proofs.sec_5_planes_a.proved : Section_5.sec_5_planes_a.statement).
Check (Section_5_proofs.sec_5_planes_a.met : Section_5.sec_5_planes_a.instance).
Check (Section_5_proofs.sec_5_planes_parallel.proved : Section_5.sec_5_planes_parallel.statement).
Check (Section_5_proofs.sec_5_planes_parallel.met : Section_5.sec_5_planes_parallel.instance).
Check (Section_5_proofs.sec_5_planes_b.refuted : ~ Section_5.sec_5_planes_b.statement).
Definition all_theorems : True :=
let _ := Part_Abstract_printed_proofs.abs_construct_a.proved in
let _ := Part_Abstract_printed_proofs.abs_construct_a.met in
let _ := Part_Abstract_printed_proofs.abs_construct_b.proved in
let _ := Part_Abstract_printed_proofs.abs_construct_b.met in
let _ := Part_Abstract_printed_proofs.abs_construct_c.proved in
let _ := Part_Abstract_printed_proofs.abs_construct_c.met in
let _ := Part_Abstract_printed_proofs.abs_construct_d.refuted in
let _ := Part_Abstract_proofs.abs_construct_a.proved in
let _ := Part_Abstract_proofs.abs_construct_a.met in
let _ := Part_Abstract_proofs.abs_construct_b.proved in
let _ := Part_Abstract_proofs.abs_construct_b.met in
let _ := Part_Abstract_proofs.abs_construct_c.proved in
let _ := Part_Abstract_proofs.abs_construct_c.met in
let _ := Part_Abstract_proofs.abs_construct_d.refuted in
let _ := Section_1_printed_proofs.sec_1_parallel_tangents.proved in
let _ := Section_1_printed_proofs.sec_1_parallel_tangents.met in
let _ := Section_1_proofs.sec_1_parallel_tangents.proved in
let _ := Section_1_proofs.sec_1_parallel_tangents.met in
let _ := Section_2_printed_proofs.sec_2_cubic_conditions.proved in
let _ := Section_2_printed_proofs.sec_2_cubic_conditions.met in
let _ := Section_2_printed_proofs.sec_2_cubic_equations.proved in
let _ := Section_2_printed_proofs.sec_2_cubic_a1.proved in
let _ := Section_2_printed_proofs.sec_2_cubic_a1.met in
let _ := Section_2_printed_proofs.sec_2_cubic_b1.proved in
let _ := Section_2_printed_proofs.sec_2_cubic_b1.met in
let _ := Section_2_printed_proofs.sec_2_cubic_c1.proved in
let _ := Section_2_printed_proofs.sec_2_cubic_c1.met in
let _ := Section_2_printed_proofs.sec_2_cubic_d1.proved in
let _ := Section_2_printed_proofs.sec_2_cubic_d1.met in
let _ := Section_2_printed_proofs.eq_2_1a.proved in
let _ := Section_2_printed_proofs.eq_2_1a.met in
let _ := Section_2_printed_proofs.eq_2_1b.proved in
let _ := Section_2_printed_proofs.eq_2_1b.met in
let _ := Section_2_printed_proofs.eq_2_1b_H1.proved in
let _ := Section_2_printed_proofs.eq_2_1b_H1.met in
let _ := Section_2_printed_proofs.eq_2_1b_H2.proved in
let _ := Section_2_printed_proofs.eq_2_1b_H2.met in
let _ := Section_2_printed_proofs.eq_2_1b_H3.proved in
let _ := Section_2_printed_proofs.eq_2_1b_H3.met in
let _ := Section_2_printed_proofs.eq_2_1b_H4.proved in
let _ := Section_2_printed_proofs.eq_2_1b_H4.met in
let _ := Section_2_printed_proofs.sec_2_quartic_conditions.proved in
let _ := Section_2_printed_proofs.sec_2_quartic_conditions.met in
let _ := Section_2_printed_proofs.sec_2_quartic_solvable.proved in
let _ := Section_2_printed_proofs.sec_2_quartic_a1.proved in
let _ := Section_2_printed_proofs.sec_2_quartic_a1.met in
let _ := Section_2_printed_proofs.sec_2_quartic_b1.proved in
let _ := Section_2_printed_proofs.sec_2_quartic_b1.met in
let _ := Section_2_printed_proofs.sec_2_quartic_third.refuted in
let _ := Section_2_printed_proofs.sec_2_quartic_third_corrected.proved in
let _ := Section_2_printed_proofs.sec_2_quartic_third_corrected.met in
let _ := Section_2_printed_proofs.sec_2_quartic_d1.proved in
let _ := Section_2_printed_proofs.sec_2_quartic_d1.met in
let _ := Section_2_printed_proofs.sec_2_quartic_e1.proved in
let _ := Section_2_printed_proofs.sec_2_quartic_e1.met in
let _ := Section_2_printed_proofs.eq_2_2.proved in
let _ := Section_2_printed_proofs.eq_2_2.met in
let _ := Section_2_printed_proofs.eq_2_3.refuted in
let _ := Section_2_printed_proofs.eq_2_3_corrected.proved in
let _ := Section_2_printed_proofs.eq_2_3_corrected.met in
let _ := Section_2_printed_proofs.eq_2_3_H1.proved in
let _ := Section_2_printed_proofs.eq_2_3_H1.met in
let _ := Section_2_printed_proofs.eq_2_3_H2.proved in
let _ := Section_2_printed_proofs.eq_2_3_H2.met in
let _ := Section_2_printed_proofs.eq_2_3_H3.proved in
let _ := Section_2_printed_proofs.eq_2_3_H3.met in
let _ := Section_2_printed_proofs.eq_2_3_H4.proved in
let _ := Section_2_printed_proofs.eq_2_3_H4.met in
let _ := Section_2_printed_proofs.eq_2_3_H5.proved in
let _ := Section_2_printed_proofs.eq_2_3_H5.met in
let _ := Section_2_printed_proofs.sec_2_quintic_conditions.proved in
let _ := Section_2_printed_proofs.sec_2_quintic_conditions.met in
let _ := Section_2_printed_proofs.sec_2_quintic_a1.proved in
let _ := Section_2_printed_proofs.sec_2_quintic_a1.met in
let _ := Section_2_printed_proofs.sec_2_quintic_b1.proved in
let _ := Section_2_printed_proofs.sec_2_quintic_b1.met in
let _ := Section_2_printed_proofs.sec_2_quintic_c1.proved in
let _ := Section_2_printed_proofs.sec_2_quintic_c1.met in
let _ := Section_2_printed_proofs.sec_2_quintic_d1.proved in
let _ := Section_2_printed_proofs.sec_2_quintic_d1.met in
let _ := Section_2_printed_proofs.sec_2_quintic_e1.proved in
let _ := Section_2_printed_proofs.sec_2_quintic_e1.met in
let _ := Section_2_printed_proofs.sec_2_quintic_f1.proved in
let _ := Section_2_printed_proofs.sec_2_quintic_f1.met in
let _ := Section_2_printed_proofs.eq_2_4.proved in
let _ := Section_2_printed_proofs.eq_2_4.met in
let _ := Section_2_printed_proofs.sec_2_control.proved in
let _ := Section_2_printed_proofs.sec_2_control.met in
let _ := Section_2_printed_proofs.fig_1b_middle.proved in
let _ := Section_2_printed_proofs.fig_1b_middle.met in
let _ := Section_2_proofs.sec_2_cubic_conditions.proved in
let _ := Section_2_proofs.sec_2_cubic_conditions.met in
let _ := Section_2_proofs.sec_2_cubic_equations.proved in
let _ := Section_2_proofs.sec_2_cubic_a1.proved in
let _ := Section_2_proofs.sec_2_cubic_a1.met in
let _ := Section_2_proofs.sec_2_cubic_b1.proved in
let _ := Section_2_proofs.sec_2_cubic_b1.met in
let _ := Section_2_proofs.sec_2_cubic_c1.proved in
let _ := Section_2_proofs.sec_2_cubic_c1.met in
let _ := Section_2_proofs.sec_2_cubic_d1.proved in
let _ := Section_2_proofs.sec_2_cubic_d1.met in
let _ := Section_2_proofs.eq_2_1a.proved in
let _ := Section_2_proofs.eq_2_1a.met in
let _ := Section_2_proofs.eq_2_1b.proved in
let _ := Section_2_proofs.eq_2_1b.met in
let _ := Section_2_proofs.eq_2_1b_H1.proved in
let _ := Section_2_proofs.eq_2_1b_H1.met in
let _ := Section_2_proofs.eq_2_1b_H2.proved in
let _ := Section_2_proofs.eq_2_1b_H2.met in
let _ := Section_2_proofs.eq_2_1b_H3.proved in
let _ := Section_2_proofs.eq_2_1b_H3.met in
let _ := Section_2_proofs.eq_2_1b_H4.proved in
let _ := Section_2_proofs.eq_2_1b_H4.met in
let _ := Section_2_proofs.sec_2_quartic_conditions.proved in
let _ := Section_2_proofs.sec_2_quartic_conditions.met in
let _ := Section_2_proofs.sec_2_quartic_solvable.proved in
let _ := Section_2_proofs.sec_2_quartic_a1.proved in
let _ := Section_2_proofs.sec_2_quartic_a1.met in
let _ := Section_2_proofs.sec_2_quartic_b1.proved in
let _ := Section_2_proofs.sec_2_quartic_b1.met in
let _ := Section_2_proofs.sec_2_quartic_third.refuted in
let _ := Section_2_proofs.sec_2_quartic_third_corrected.proved in
let _ := Section_2_proofs.sec_2_quartic_third_corrected.met in
let _ := Section_2_proofs.sec_2_quartic_d1.proved in
let _ := Section_2_proofs.sec_2_quartic_d1.met in
let _ := Section_2_proofs.sec_2_quartic_e1.proved in
let _ := Section_2_proofs.sec_2_quartic_e1.met in
let _ := Section_2_proofs.eq_2_2.proved in
let _ := Section_2_proofs.eq_2_2.met in
let _ := Section_2_proofs.eq_2_3.refuted in
let _ := Section_2_proofs.eq_2_3_corrected.proved in
let _ := Section_2_proofs.eq_2_3_corrected.met in
let _ := Section_2_proofs.eq_2_3_H1.proved in
let _ := Section_2_proofs.eq_2_3_H1.met in
let _ := Section_2_proofs.eq_2_3_H2.proved in
let _ := Section_2_proofs.eq_2_3_H2.met in
let _ := Section_2_proofs.eq_2_3_H3.proved in
let _ := Section_2_proofs.eq_2_3_H3.met in
let _ := Section_2_proofs.eq_2_3_H4.proved in
let _ := Section_2_proofs.eq_2_3_H4.met in
let _ := Section_2_proofs.eq_2_3_H5.proved in
let _ := Section_2_proofs.eq_2_3_H5.met in
let _ := Section_2_proofs.sec_2_quintic_conditions.proved in
let _ := Section_2_proofs.sec_2_quintic_conditions.met in
let _ := Section_2_proofs.sec_2_quintic_a1.proved in
let _ := Section_2_proofs.sec_2_quintic_a1.met in
let _ := Section_2_proofs.sec_2_quintic_b1.proved in
let _ := Section_2_proofs.sec_2_quintic_b1.met in
let _ := Section_2_proofs.sec_2_quintic_c1.proved in
let _ := Section_2_proofs.sec_2_quintic_c1.met in
let _ := Section_2_proofs.sec_2_quintic_d1.proved in
let _ := Section_2_proofs.sec_2_quintic_d1.met in
let _ := Section_2_proofs.sec_2_quintic_e1.proved in
let _ := Section_2_proofs.sec_2_quintic_e1.met in
let _ := Section_2_proofs.sec_2_quintic_f1.proved in
let _ := Section_2_proofs.sec_2_quintic_f1.met in
let _ := Section_2_proofs.eq_2_4.proved in
let _ := Section_2_proofs.eq_2_4.met in
let _ := Section_2_proofs.sec_2_control.proved in
let _ := Section_2_proofs.sec_2_control.met in
let _ := Section_2_proofs.fig_1b_middle.proved in
let _ := Section_2_proofs.fig_1b_middle.met in
let _ := Section_3_1_printed_proofs.sec_3_1_polynomials.proved in
let _ := Section_3_1_printed_proofs.sec_3_1_polynomials.met in
let _ := Section_3_1_printed_proofs.sec_3_1_substituted.proved in
let _ := Section_3_1_printed_proofs.sec_3_1_substituted.met in
let _ := Section_3_1_printed_proofs.sec_3_1_coefficients.proved in
let _ := Section_3_1_printed_proofs.sec_3_1_coefficients.met in
let _ := Section_3_1_printed_proofs.sec_3_1_hermite_1.proved in
let _ := Section_3_1_printed_proofs.sec_3_1_hermite_1.met in
let _ := Section_3_1_printed_proofs.sec_3_1_hermite_2.proved in
let _ := Section_3_1_printed_proofs.sec_3_1_hermite_2.met in
let _ := Section_3_1_printed_proofs.sec_3_1_hermite_3.proved in
let _ := Section_3_1_printed_proofs.sec_3_1_hermite_3.met in
let _ := Section_3_1_printed_proofs.sec_3_1_hermite_4.proved in
let _ := Section_3_1_printed_proofs.sec_3_1_hermite_4.met in
let _ := Section_3_1_printed_proofs.eq_3_5_A_r1.proved in
let _ := Section_3_1_printed_proofs.eq_3_5_A_r1.met in
let _ := Section_3_1_printed_proofs.eq_3_5_A_r2.proved in
let _ := Section_3_1_printed_proofs.eq_3_5_A_r2.met in
let _ := Section_3_1_printed_proofs.eq_3_5_A_r3.proved in
let _ := Section_3_1_printed_proofs.eq_3_5_A_r3.met in
let _ := Section_3_1_printed_proofs.eq_3_5_A_r4.proved in
let _ := Section_3_1_printed_proofs.eq_3_5_A_r4.met in
let _ := Section_3_1_printed_proofs.eq_3_5_B.refuted in
let _ := Section_3_1_printed_proofs.eq_3_5_B_corrected.proved in
let _ := Section_3_1_printed_proofs.eq_3_5_B_corrected.met in
let _ := Section_3_1_printed_proofs.eq_3_5_C_r1.proved in
let _ := Section_3_1_printed_proofs.eq_3_5_C_r1.met in
let _ := Section_3_1_printed_proofs.eq_3_5_C_r2.proved in
let _ := Section_3_1_printed_proofs.eq_3_5_C_r2.met in
let _ := Section_3_1_printed_proofs.eq_3_5_C_r3.proved in
let _ := Section_3_1_printed_proofs.eq_3_5_C_r3.met in
let _ := Section_3_1_printed_proofs.eq_3_5_C_r4.proved in
let _ := Section_3_1_printed_proofs.eq_3_5_C_r4.met in
let _ := Section_3_1_printed_proofs.eq_3_5_sizes.proved in
let _ := Section_3_1_printed_proofs.eq_3_5_unique.proved in
let _ := Section_3_1_printed_proofs.eq_3_5_unique.met in
let _ := Section_3_1_printed_proofs.eq_3_5_det.proved in
let _ := Section_3_1_printed_proofs.eq_3_5_k.proved in
let _ := Section_3_1_printed_proofs.eq_3_5_k.met in
let _ := Section_3_1_printed_proofs.eq_3_5_sol_p1.proved in
let _ := Section_3_1_printed_proofs.eq_3_5_sol_p1.met in
let _ := Section_3_1_printed_proofs.eq_3_5_sol_p0u.proved in
let _ := Section_3_1_printed_proofs.eq_3_5_sol_p0u.met in
let _ := Section_3_1_printed_proofs.eq_3_5_sol_p1u.proved in
let _ := Section_3_1_printed_proofs.eq_3_5_sol_p1u.met in
let _ := Section_3_1_printed_proofs.eq_3_5_sol_p0.proved in
let _ := Section_3_1_printed_proofs.eq_3_5_sol_p0.met in
let _ := Section_3_1_printed_proofs.sec_3_1_conclusion.proved in
let _ := Section_3_1_printed_proofs.sec_3_1_conclusion.met in
let _ := Section_3_1_printed_proofs.alg_3_1_step1.proved in
let _ := Section_3_1_printed_proofs.alg_3_1_step1.met in
let _ := Section_3_1_printed_proofs.alg_3_1_step2.proved in
let _ := Section_3_1_printed_proofs.alg_3_1_step2.met in
let _ := Section_3_1_printed_proofs.alg_3_1_step3.proved in
let _ := Section_3_1_printed_proofs.alg_3_1_step3.met in
let _ := Section_3_1_printed_proofs.sec_3_1_tension.proved in
let _ := Section_3_1_printed_proofs.sec_3_1_tension.met in
let _ := Section_3_1_printed_proofs.ex_3_1_arrange.proved in
let _ := Section_3_1_printed_proofs.ex_3_1_arrange.met in
let _ := Section_3_1_printed_proofs.ex_3_1_tension_effect.proved in
let _ := Section_3_1_printed_proofs.ex_3_1_tension_effect.met in
let _ := Section_3_1_printed_proofs.ex_3_1_p1.proved in
let _ := Section_3_1_printed_proofs.ex_3_1_p1.met in
let _ := Section_3_1_printed_proofs.ex_3_1_p0u.proved in
let _ := Section_3_1_printed_proofs.ex_3_1_p0u.met in
let _ := Section_3_1_printed_proofs.ex_3_1_p1u.proved in
let _ := Section_3_1_printed_proofs.ex_3_1_p1u.met in
let _ := Section_3_1_printed_proofs.ex_3_1_p0.proved in
let _ := Section_3_1_printed_proofs.ex_3_1_p0.met in
let _ := Section_3_1_printed_proofs.ex_3_1_parallel.proved in
let _ := Section_3_1_printed_proofs.ex_3_1_parallel.met in
let _ := Section_3_1_printed_proofs.ex_3_1_width.proved in
let _ := Section_3_1_printed_proofs.ex_3_1_width.met in
let _ := Section_3_1_printed_proofs.ex_3_1_shapes.proved in
let _ := Section_3_1_printed_proofs.ex_3_1_shapes.met in
let _ := Section_3_1_proofs.sec_3_1_polynomials.proved in
let _ := Section_3_1_proofs.sec_3_1_polynomials.met in
let _ := Section_3_1_proofs.sec_3_1_substituted.proved in
let _ := Section_3_1_proofs.sec_3_1_substituted.met in
let _ := Section_3_1_proofs.sec_3_1_coefficients.proved in
let _ := Section_3_1_proofs.sec_3_1_coefficients.met in
let _ := Section_3_1_proofs.sec_3_1_hermite_1.proved in
let _ := Section_3_1_proofs.sec_3_1_hermite_1.met in
let _ := Section_3_1_proofs.sec_3_1_hermite_2.proved in
let _ := Section_3_1_proofs.sec_3_1_hermite_2.met in
let _ := Section_3_1_proofs.sec_3_1_hermite_3.proved in
let _ := Section_3_1_proofs.sec_3_1_hermite_3.met in
let _ := Section_3_1_proofs.sec_3_1_hermite_4.proved in
let _ := Section_3_1_proofs.sec_3_1_hermite_4.met in
let _ := Section_3_1_proofs.eq_3_5_A_r1.proved in
let _ := Section_3_1_proofs.eq_3_5_A_r1.met in
let _ := Section_3_1_proofs.eq_3_5_A_r2.proved in
let _ := Section_3_1_proofs.eq_3_5_A_r2.met in
let _ := Section_3_1_proofs.eq_3_5_A_r3.proved in
let _ := Section_3_1_proofs.eq_3_5_A_r3.met in
let _ := Section_3_1_proofs.eq_3_5_A_r4.proved in
let _ := Section_3_1_proofs.eq_3_5_A_r4.met in
let _ := Section_3_1_proofs.eq_3_5_B.refuted in
let _ := Section_3_1_proofs.eq_3_5_B_corrected.proved in
let _ := Section_3_1_proofs.eq_3_5_B_corrected.met in
let _ := Section_3_1_proofs.eq_3_5_C_r1.proved in
let _ := Section_3_1_proofs.eq_3_5_C_r1.met in
let _ := Section_3_1_proofs.eq_3_5_C_r2.proved in
let _ := Section_3_1_proofs.eq_3_5_C_r2.met in
let _ := Section_3_1_proofs.eq_3_5_C_r3.proved in
let _ := Section_3_1_proofs.eq_3_5_C_r3.met in
let _ := Section_3_1_proofs.eq_3_5_C_r4.proved in
let _ := Section_3_1_proofs.eq_3_5_C_r4.met in
let _ := Section_3_1_proofs.eq_3_5_sizes.proved in
let _ := Section_3_1_proofs.eq_3_5_unique.proved in
let _ := Section_3_1_proofs.eq_3_5_unique.met in
let _ := Section_3_1_proofs.eq_3_5_det.proved in
let _ := Section_3_1_proofs.eq_3_5_k.proved in
let _ := Section_3_1_proofs.eq_3_5_k.met in
let _ := Section_3_1_proofs.eq_3_5_sol_p1.proved in
let _ := Section_3_1_proofs.eq_3_5_sol_p1.met in
let _ := Section_3_1_proofs.eq_3_5_sol_p0u.proved in
let _ := Section_3_1_proofs.eq_3_5_sol_p0u.met in
let _ := Section_3_1_proofs.eq_3_5_sol_p1u.proved in
let _ := Section_3_1_proofs.eq_3_5_sol_p1u.met in
let _ := Section_3_1_proofs.eq_3_5_sol_p0.proved in
let _ := Section_3_1_proofs.eq_3_5_sol_p0.met in
let _ := Section_3_1_proofs.sec_3_1_conclusion.proved in
let _ := Section_3_1_proofs.sec_3_1_conclusion.met in
let _ := Section_3_1_proofs.alg_3_1_step1.proved in
let _ := Section_3_1_proofs.alg_3_1_step1.met in
let _ := Section_3_1_proofs.alg_3_1_step2.proved in
let _ := Section_3_1_proofs.alg_3_1_step2.met in
let _ := Section_3_1_proofs.alg_3_1_step3.proved in
let _ := Section_3_1_proofs.alg_3_1_step3.met in
let _ := Section_3_1_proofs.sec_3_1_tension.proved in
let _ := Section_3_1_proofs.sec_3_1_tension.met in
let _ := Section_3_1_proofs.ex_3_1_arrange.proved in
let _ := Section_3_1_proofs.ex_3_1_arrange.met in
let _ := Section_3_1_proofs.ex_3_1_tension_effect.proved in
let _ := Section_3_1_proofs.ex_3_1_tension_effect.met in
let _ := Section_3_1_proofs.ex_3_1_p1.proved in
let _ := Section_3_1_proofs.ex_3_1_p1.met in
let _ := Section_3_1_proofs.ex_3_1_p0u.proved in
let _ := Section_3_1_proofs.ex_3_1_p0u.met in
let _ := Section_3_1_proofs.ex_3_1_p1u.proved in
let _ := Section_3_1_proofs.ex_3_1_p1u.met in
let _ := Section_3_1_proofs.ex_3_1_p0.proved in
let _ := Section_3_1_proofs.ex_3_1_p0.met in
let _ := Section_3_1_proofs.ex_3_1_parallel.proved in
let _ := Section_3_1_proofs.ex_3_1_parallel.met in
let _ := Section_3_1_proofs.ex_3_1_width.proved in
let _ := Section_3_1_proofs.ex_3_1_width.met in
let _ := Section_3_1_proofs.ex_3_1_shapes.proved in
let _ := Section_3_1_proofs.ex_3_1_shapes.met in
let _ := Section_3_2_printed_proofs.sec_3_2_curves.proved in
let _ := Section_3_2_printed_proofs.sec_3_2_curves.met in
let _ := Section_3_2_printed_proofs.eq_3_6_A_r1.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_A_r1.met in
let _ := Section_3_2_printed_proofs.eq_3_6_A_r2.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_A_r2.met in
let _ := Section_3_2_printed_proofs.eq_3_6_A_r3.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_A_r3.met in
let _ := Section_3_2_printed_proofs.eq_3_6_A_r4.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_A_r4.met in
let _ := Section_3_2_printed_proofs.eq_3_6_A_r5.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_A_r5.met in
let _ := Section_3_2_printed_proofs.eq_3_6_B.refuted in
let _ := Section_3_2_printed_proofs.eq_3_6_B_corrected.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_B_corrected.met in
let _ := Section_3_2_printed_proofs.eq_3_6_C_r1.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_C_r1.met in
let _ := Section_3_2_printed_proofs.eq_3_6_C_r2.refuted in
let _ := Section_3_2_printed_proofs.eq_3_6_C_r2_corrected.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_C_r2_corrected.met in
let _ := Section_3_2_printed_proofs.eq_3_6_C_r3.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_C_r3.met in
let _ := Section_3_2_printed_proofs.eq_3_6_C_r4.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_C_r4.met in
let _ := Section_3_2_printed_proofs.eq_3_6_C_r5.refuted in
let _ := Section_3_2_printed_proofs.eq_3_6_C_r5_corrected.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_C_r5_corrected.met in
let _ := Section_3_2_printed_proofs.eq_3_6_det.refuted in
let _ := Section_3_2_printed_proofs.eq_3_6_det_corrected.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_det_true.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_det_true.met in
let _ := Section_3_2_printed_proofs.eq_3_6_det_slip.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_det_factored.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_k.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_k.met in
let _ := Section_3_2_printed_proofs.eq_3_6_k_every.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_k_every.met in
let _ := Section_3_2_printed_proofs.eq_3_6_k_135_136.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_k_135_136.met in
let _ := Section_3_2_printed_proofs.eq_3_6_sol_q.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_sol_q.met in
let _ := Section_3_2_printed_proofs.eq_3_6_sol_p1.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_sol_p1.met in
let _ := Section_3_2_printed_proofs.eq_3_6_sol_p0u.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_sol_p0u.met in
let _ := Section_3_2_printed_proofs.eq_3_6_sol_p1u.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_sol_p1u.met in
let _ := Section_3_2_printed_proofs.eq_3_6_sol_o.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_sol_o.met in
let _ := Section_3_2_printed_proofs.eq_3_6_system.proved in
let _ := Section_3_2_printed_proofs.eq_3_6_system.met in
let _ := Section_3_2_printed_proofs.sec_3_2_advantage.proved in
let _ := Section_3_2_printed_proofs.sec_3_2_advantage.met in
let _ := Section_3_2_printed_proofs.ex_3_2_q.proved in
let _ := Section_3_2_printed_proofs.ex_3_2_q.met in
let _ := Section_3_2_printed_proofs.ex_3_2_p1.proved in
let _ := Section_3_2_printed_proofs.ex_3_2_p1.met in
let _ := Section_3_2_printed_proofs.ex_3_2_p0u.proved in
let _ := Section_3_2_printed_proofs.ex_3_2_p0u.met in
let _ := Section_3_2_printed_proofs.ex_3_2_p1u.proved in
let _ := Section_3_2_printed_proofs.ex_3_2_p1u.met in
let _ := Section_3_2_printed_proofs.ex_3_2_o.proved in
let _ := Section_3_2_printed_proofs.ex_3_2_o.met in
let _ := Section_3_2_printed_proofs.ex_3_2_parallel.proved in
let _ := Section_3_2_printed_proofs.ex_3_2_parallel.met in
let _ := Section_3_2_proofs.sec_3_2_curves.proved in
let _ := Section_3_2_proofs.sec_3_2_curves.met in
let _ := Section_3_2_proofs.eq_3_6_A_r1.proved in
let _ := Section_3_2_proofs.eq_3_6_A_r1.met in
let _ := Section_3_2_proofs.eq_3_6_A_r2.proved in
let _ := Section_3_2_proofs.eq_3_6_A_r2.met in
let _ := Section_3_2_proofs.eq_3_6_A_r3.proved in
let _ := Section_3_2_proofs.eq_3_6_A_r3.met in
let _ := Section_3_2_proofs.eq_3_6_A_r4.proved in
let _ := Section_3_2_proofs.eq_3_6_A_r4.met in
let _ := Section_3_2_proofs.eq_3_6_A_r5.proved in
let _ := Section_3_2_proofs.eq_3_6_A_r5.met in
let _ := Section_3_2_proofs.eq_3_6_B.refuted in
let _ := Section_3_2_proofs.eq_3_6_B_corrected.proved in
let _ := Section_3_2_proofs.eq_3_6_B_corrected.met in
let _ := Section_3_2_proofs.eq_3_6_C_r1.proved in
let _ := Section_3_2_proofs.eq_3_6_C_r1.met in
let _ := Section_3_2_proofs.eq_3_6_C_r2.refuted in
let _ := Section_3_2_proofs.eq_3_6_C_r2_corrected.proved in
let _ := Section_3_2_proofs.eq_3_6_C_r2_corrected.met in
let _ := Section_3_2_proofs.eq_3_6_C_r3.proved in
let _ := Section_3_2_proofs.eq_3_6_C_r3.met in
let _ := Section_3_2_proofs.eq_3_6_C_r4.proved in
let _ := Section_3_2_proofs.eq_3_6_C_r4.met in
let _ := Section_3_2_proofs.eq_3_6_C_r5.refuted in
let _ := Section_3_2_proofs.eq_3_6_C_r5_corrected.proved in
let _ := Section_3_2_proofs.eq_3_6_C_r5_corrected.met in
let _ := Section_3_2_proofs.eq_3_6_det.refuted in
let _ := Section_3_2_proofs.eq_3_6_det_corrected.proved in
let _ := Section_3_2_proofs.eq_3_6_det_true.proved in
let _ := Section_3_2_proofs.eq_3_6_det_true.met in
let _ := Section_3_2_proofs.eq_3_6_det_slip.proved in
let _ := Section_3_2_proofs.eq_3_6_det_factored.proved in
let _ := Section_3_2_proofs.eq_3_6_k.proved in
let _ := Section_3_2_proofs.eq_3_6_k.met in
let _ := Section_3_2_proofs.eq_3_6_k_every.proved in
let _ := Section_3_2_proofs.eq_3_6_k_every.met in
let _ := Section_3_2_proofs.eq_3_6_k_135_136.proved in
let _ := Section_3_2_proofs.eq_3_6_k_135_136.met in
let _ := Section_3_2_proofs.eq_3_6_sol_q.proved in
let _ := Section_3_2_proofs.eq_3_6_sol_q.met in
let _ := Section_3_2_proofs.eq_3_6_sol_p1.proved in
let _ := Section_3_2_proofs.eq_3_6_sol_p1.met in
let _ := Section_3_2_proofs.eq_3_6_sol_p0u.proved in
let _ := Section_3_2_proofs.eq_3_6_sol_p0u.met in
let _ := Section_3_2_proofs.eq_3_6_sol_p1u.proved in
let _ := Section_3_2_proofs.eq_3_6_sol_p1u.met in
let _ := Section_3_2_proofs.eq_3_6_sol_o.proved in
let _ := Section_3_2_proofs.eq_3_6_sol_o.met in
let _ := Section_3_2_proofs.eq_3_6_system.proved in
let _ := Section_3_2_proofs.eq_3_6_system.met in
let _ := Section_3_2_proofs.sec_3_2_advantage.proved in
let _ := Section_3_2_proofs.sec_3_2_advantage.met in
let _ := Section_3_2_proofs.ex_3_2_q.proved in
let _ := Section_3_2_proofs.ex_3_2_q.met in
let _ := Section_3_2_proofs.ex_3_2_p1.proved in
let _ := Section_3_2_proofs.ex_3_2_p1.met in
let _ := Section_3_2_proofs.ex_3_2_p0u.proved in
let _ := Section_3_2_proofs.ex_3_2_p0u.met in
let _ := Section_3_2_proofs.ex_3_2_p1u.proved in
let _ := Section_3_2_proofs.ex_3_2_p1u.met in
let _ := Section_3_2_proofs.ex_3_2_o.proved in
let _ := Section_3_2_proofs.ex_3_2_o.met in
let _ := Section_3_2_proofs.ex_3_2_parallel.proved in
let _ := Section_3_2_proofs.ex_3_2_parallel.met in
let _ := Section_3_3_printed_proofs.sec_3_3_curves.proved in
let _ := Section_3_3_printed_proofs.sec_3_3_curves.met in
let _ := Section_3_3_printed_proofs.eq_3_7_A_r1.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_A_r1.met in
let _ := Section_3_3_printed_proofs.eq_3_7_A_r2.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_A_r2.met in
let _ := Section_3_3_printed_proofs.eq_3_7_A_r3.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_A_r3.met in
let _ := Section_3_3_printed_proofs.eq_3_7_A_r4.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_A_r4.met in
let _ := Section_3_3_printed_proofs.eq_3_7_A_r5.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_A_r5.met in
let _ := Section_3_3_printed_proofs.eq_3_7_A_r6.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_A_r6.met in
let _ := Section_3_3_printed_proofs.eq_3_7_B.refuted in
let _ := Section_3_3_printed_proofs.eq_3_7_B_corrected.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_B_corrected.met in
let _ := Section_3_3_printed_proofs.eq_3_7_C_r1.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_C_r1.met in
let _ := Section_3_3_printed_proofs.eq_3_7_C_r2.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_C_r2.met in
let _ := Section_3_3_printed_proofs.eq_3_7_C_r3.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_C_r3.met in
let _ := Section_3_3_printed_proofs.eq_3_7_C_r4.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_C_r4.met in
let _ := Section_3_3_printed_proofs.eq_3_7_C_r5.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_C_r5.met in
let _ := Section_3_3_printed_proofs.eq_3_7_C_r6.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_C_r6.met in
let _ := Section_3_3_printed_proofs.eq_3_7_det.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_k.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_k.met in
let _ := Section_3_3_printed_proofs.eq_3_7_k_needed.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_k_needed.met in
let _ := Section_3_3_printed_proofs.eq_3_7_sol_p0u.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_sol_p0u.met in
let _ := Section_3_3_printed_proofs.eq_3_7_sol_qu.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_sol_qu.met in
let _ := Section_3_3_printed_proofs.eq_3_7_sol_p1u.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_sol_p1u.met in
let _ := Section_3_3_printed_proofs.eq_3_7_sol_q.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_sol_q.met in
let _ := Section_3_3_printed_proofs.eq_3_7_sol_p1.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_sol_p1.met in
let _ := Section_3_3_printed_proofs.eq_3_7_sol_o.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_sol_o.met in
let _ := Section_3_3_printed_proofs.eq_3_7_system.proved in
let _ := Section_3_3_printed_proofs.eq_3_7_system.met in
let _ := Section_3_3_printed_proofs.sec_3_3_advantage.proved in
let _ := Section_3_3_printed_proofs.sec_3_3_advantage.met in
let _ := Section_3_3_printed_proofs.ex_3_3_equation.refuted in
let _ := Section_3_3_printed_proofs.ex_3_3_equation_true.proved in
let _ := Section_3_3_printed_proofs.ex_3_3_equation_true.met in
let _ := Section_3_3_printed_proofs.ex_3_3_p0u.proved in
let _ := Section_3_3_printed_proofs.ex_3_3_p0u.met in
let _ := Section_3_3_printed_proofs.ex_3_3_qu.proved in
let _ := Section_3_3_printed_proofs.ex_3_3_qu.met in
let _ := Section_3_3_printed_proofs.ex_3_3_p1u.proved in
let _ := Section_3_3_printed_proofs.ex_3_3_p1u.met in
let _ := Section_3_3_printed_proofs.ex_3_3_q.proved in
let _ := Section_3_3_printed_proofs.ex_3_3_q.met in
let _ := Section_3_3_printed_proofs.ex_3_3_p1.proved in
let _ := Section_3_3_printed_proofs.ex_3_3_p1.met in
let _ := Section_3_3_printed_proofs.ex_3_3_o.proved in
let _ := Section_3_3_printed_proofs.ex_3_3_o.met in
let _ := Section_3_3_printed_proofs.ex_3_3_parallel.proved in
let _ := Section_3_3_printed_proofs.ex_3_3_parallel.met in
let _ := Section_3_3_printed_proofs.fig_4d_constant.proved in
let _ := Section_3_3_printed_proofs.fig_4d_constant.met in
let _ := Section_3_3_proofs.sec_3_3_curves.proved in
let _ := Section_3_3_proofs.sec_3_3_curves.met in
let _ := Section_3_3_proofs.eq_3_7_A_r1.proved in
let _ := Section_3_3_proofs.eq_3_7_A_r1.met in
let _ := Section_3_3_proofs.eq_3_7_A_r2.proved in
let _ := Section_3_3_proofs.eq_3_7_A_r2.met in
let _ := Section_3_3_proofs.eq_3_7_A_r3.proved in
let _ := Section_3_3_proofs.eq_3_7_A_r3.met in
let _ := Section_3_3_proofs.eq_3_7_A_r4.proved in
let _ := Section_3_3_proofs.eq_3_7_A_r4.met in
let _ := Section_3_3_proofs.eq_3_7_A_r5.proved in
let _ := Section_3_3_proofs.eq_3_7_A_r5.met in
let _ := Section_3_3_proofs.eq_3_7_A_r6.proved in
let _ := Section_3_3_proofs.eq_3_7_A_r6.met in
let _ := Section_3_3_proofs.eq_3_7_B.refuted in
let _ := Section_3_3_proofs.eq_3_7_B_corrected.proved in
let _ := Section_3_3_proofs.eq_3_7_B_corrected.met in
let _ := Section_3_3_proofs.eq_3_7_C_r1.proved in
let _ := Section_3_3_proofs.eq_3_7_C_r1.met in
let _ := Section_3_3_proofs.eq_3_7_C_r2.proved in
let _ := Section_3_3_proofs.eq_3_7_C_r2.met in
let _ := Section_3_3_proofs.eq_3_7_C_r3.proved in
let _ := Section_3_3_proofs.eq_3_7_C_r3.met in
let _ := Section_3_3_proofs.eq_3_7_C_r4.proved in
let _ := Section_3_3_proofs.eq_3_7_C_r4.met in
let _ := Section_3_3_proofs.eq_3_7_C_r5.proved in
let _ := Section_3_3_proofs.eq_3_7_C_r5.met in
let _ := Section_3_3_proofs.eq_3_7_C_r6.proved in
let _ := Section_3_3_proofs.eq_3_7_C_r6.met in
let _ := Section_3_3_proofs.eq_3_7_det.proved in
let _ := Section_3_3_proofs.eq_3_7_k.proved in
let _ := Section_3_3_proofs.eq_3_7_k.met in
let _ := Section_3_3_proofs.eq_3_7_k_needed.proved in
let _ := Section_3_3_proofs.eq_3_7_k_needed.met in
let _ := Section_3_3_proofs.eq_3_7_sol_p0u.proved in
let _ := Section_3_3_proofs.eq_3_7_sol_p0u.met in
let _ := Section_3_3_proofs.eq_3_7_sol_qu.proved in
let _ := Section_3_3_proofs.eq_3_7_sol_qu.met in
let _ := Section_3_3_proofs.eq_3_7_sol_p1u.proved in
let _ := Section_3_3_proofs.eq_3_7_sol_p1u.met in
let _ := Section_3_3_proofs.eq_3_7_sol_q.proved in
let _ := Section_3_3_proofs.eq_3_7_sol_q.met in
let _ := Section_3_3_proofs.eq_3_7_sol_p1.proved in
let _ := Section_3_3_proofs.eq_3_7_sol_p1.met in
let _ := Section_3_3_proofs.eq_3_7_sol_o.proved in
let _ := Section_3_3_proofs.eq_3_7_sol_o.met in
let _ := Section_3_3_proofs.eq_3_7_system.proved in
let _ := Section_3_3_proofs.eq_3_7_system.met in
let _ := Section_3_3_proofs.sec_3_3_advantage.proved in
let _ := Section_3_3_proofs.sec_3_3_advantage.met in
let _ := Section_3_3_proofs.ex_3_3_equation.refuted in
let _ := Section_3_3_proofs.ex_3_3_equation_true.proved in
let _ := Section_3_3_proofs.ex_3_3_equation_true.met in
let _ := Section_3_3_proofs.ex_3_3_p0u.proved in
let _ := Section_3_3_proofs.ex_3_3_p0u.met in
let _ := Section_3_3_proofs.ex_3_3_qu.proved in
let _ := Section_3_3_proofs.ex_3_3_qu.met in
let _ := Section_3_3_proofs.ex_3_3_p1u.proved in
let _ := Section_3_3_proofs.ex_3_3_p1u.met in
let _ := Section_3_3_proofs.ex_3_3_q.proved in
let _ := Section_3_3_proofs.ex_3_3_q.met in
let _ := Section_3_3_proofs.ex_3_3_p1.proved in
let _ := Section_3_3_proofs.ex_3_3_p1.met in
let _ := Section_3_3_proofs.ex_3_3_o.proved in
let _ := Section_3_3_proofs.ex_3_3_o.met in
let _ := Section_3_3_proofs.ex_3_3_parallel.proved in
let _ := Section_3_3_proofs.ex_3_3_parallel.met in
let _ := Section_3_3_proofs.fig_4d_constant.proved in
let _ := Section_3_3_proofs.fig_4d_constant.met in
let _ := Section_3_printed_proofs.def_3_1.proved in
let _ := Section_3_printed_proofs.def_3_1.met in
let _ := Section_3_printed_proofs.def_3_1_normal.proved in
let _ := Section_3_printed_proofs.def_3_1_normal.met in
let _ := Section_3_printed_proofs.def_3_2.proved in
let _ := Section_3_printed_proofs.def_3_2_lincomb.proved in
let _ := Section_3_printed_proofs.sec_3_g_boundary.proved in
let _ := Section_3_printed_proofs.sec_3_g_boundary.met in
let _ := Section_3_printed_proofs.sec_3_g_prime.refuted in
let _ := Section_3_printed_proofs.sec_3_g_prime_corrected.proved in
let _ := Section_3_printed_proofs.sec_3_g_prime_corrected.met in
let _ := Section_3_printed_proofs.eq_3_1.proved in
let _ := Section_3_printed_proofs.eq_3_1.met in
let _ := Section_3_printed_proofs.eq_3_1_must.proved in
let _ := Section_3_printed_proofs.eq_3_1_must.met in
let _ := Section_3_printed_proofs.eq_3_1_types_a.proved in
let _ := Section_3_printed_proofs.eq_3_1_types_a.met in
let _ := Section_3_printed_proofs.eq_3_1_types_b.proved in
let _ := Section_3_printed_proofs.eq_3_1_parallel_planes.proved in
let _ := Section_3_printed_proofs.eq_3_1_parallel_planes.met in
let _ := Section_3_printed_proofs.eq_3_1_rho_constant.proved in
let _ := Section_3_printed_proofs.eq_3_1_rho_constant.met in
let _ := Section_3_printed_proofs.eq_3_1_rho_quadratic.proved in
let _ := Section_3_printed_proofs.eq_3_1_rho_quadratic.met in
let _ := Section_3_printed_proofs.eq_3_1_difficulties_same.proved in
let _ := Section_3_printed_proofs.eq_3_1_difficulties_same.met in
let _ := Section_3_printed_proofs.eq_3_2.proved in
let _ := Section_3_printed_proofs.eq_3_2.met in
let _ := Section_3_printed_proofs.eq_3_2_edge.proved in
let _ := Section_3_printed_proofs.eq_3_2_edge.met in
let _ := Section_3_printed_proofs.eq_3_2_planes_a_generatrix.refuted in
let _ := Section_3_printed_proofs.eq_3_2_planes_a_direction.proved in
let _ := Section_3_printed_proofs.eq_3_2_planes_a_direction.met in
let _ := Section_3_printed_proofs.eq_3_2_planes_b_generatrix.refuted in
let _ := Section_3_printed_proofs.eq_3_2_planes_b_direction.refuted in
let _ := Section_3_printed_proofs.eq_3_2_planes_parallel.proved in
let _ := Section_3_printed_proofs.eq_3_2_planes_parallel.met in
let _ := Section_3_printed_proofs.eq_3_2_with_h.proved in
let _ := Section_3_printed_proofs.eq_3_2_with_h.met in
let _ := Section_3_printed_proofs.eq_3_2_across.proved in
let _ := Section_3_printed_proofs.eq_3_2_across.met in
let _ := Section_3_printed_proofs.eq_3_2_across_summit.proved in
let _ := Section_3_printed_proofs.eq_3_2_across_summit.met in
let _ := Section_3_printed_proofs.eq_3_2_every_degree.proved in
let _ := Section_3_printed_proofs.eq_3_2_every_degree.met in
let _ := Section_3_printed_proofs.eq_3_3_g_generatrix.refuted in
let _ := Section_3_printed_proofs.eq_3_3_g_direction.proved in
let _ := Section_3_printed_proofs.eq_3_3_g_true.proved in
let _ := Section_3_printed_proofs.eq_3_3a.proved in
let _ := Section_3_printed_proofs.eq_3_3a.met in
let _ := Section_3_printed_proofs.eq_3_3b.proved in
let _ := Section_3_printed_proofs.eq_3_3b.met in
let _ := Section_3_printed_proofs.eq_3_3_same_as_3_2_generatrix.refuted in
let _ := Section_3_printed_proofs.eq_3_3_same_as_3_2_direction.proved in
let _ := Section_3_printed_proofs.eq_3_3_same_as_3_2_direction.met in
let _ := Section_3_printed_proofs.eq_3_3_same_as_3_2_true.proved in
let _ := Section_3_printed_proofs.eq_3_3_same_as_3_2_true.met in
let _ := Section_3_printed_proofs.eq_3_3_developable_Hermite.proved in
let _ := Section_3_printed_proofs.eq_3_3_developable_Hermite.met in
let _ := Section_3_printed_proofs.eq_3_3_developable_any.refuted in
let _ := Section_3_printed_proofs.eq_3_3_exact.proved in
let _ := Section_3_printed_proofs.eq_3_3_exact.met in
let _ := Section_3_printed_proofs.eq_3_3_multiples_cone.proved in
let _ := Section_3_printed_proofs.eq_3_3_multiples_cone.met in
let _ := Section_3_printed_proofs.eq_3_3_multiples_Hermite.proved in
let _ := Section_3_printed_proofs.eq_3_3_multiples_Hermite.met in
let _ := Section_3_printed_proofs.eq_3_3_multiples_any.refuted in
let _ := Section_3_printed_proofs.eq_3_3_k_below_1.proved in
let _ := Section_3_printed_proofs.eq_3_3_k_below_1.met in
let _ := Section_3_printed_proofs.eq_3_3_k_equal_1.proved in
let _ := Section_3_printed_proofs.eq_3_3_k_equal_1.met in
let _ := Section_3_printed_proofs.eq_3_3_k_above_1.proved in
let _ := Section_3_printed_proofs.eq_3_3_k_above_1.met in
let _ := Section_3_printed_proofs.sec_3_summit_outside.proved in
let _ := Section_3_printed_proofs.sec_3_summit_outside.met in
let _ := Section_3_printed_proofs.eq_3_4.proved in
let _ := Section_3_printed_proofs.eq_3_4.met in
let _ := Section_3_proofs.def_3_1.proved in
let _ := Section_3_proofs.def_3_1.met in
let _ := Section_3_proofs.def_3_1_normal.proved in
let _ := Section_3_proofs.def_3_1_normal.met in
let _ := Section_3_proofs.def_3_2.proved in
let _ := Section_3_proofs.def_3_2_lincomb.proved in
let _ := Section_3_proofs.sec_3_g_boundary.proved in
let _ := Section_3_proofs.sec_3_g_boundary.met in
let _ := Section_3_proofs.sec_3_g_prime.refuted in
let _ := Section_3_proofs.sec_3_g_prime_corrected.proved in
let _ := Section_3_proofs.sec_3_g_prime_corrected.met in
let _ := Section_3_proofs.eq_3_1.proved in
let _ := Section_3_proofs.eq_3_1.met in
let _ := Section_3_proofs.eq_3_1_must.proved in
let _ := Section_3_proofs.eq_3_1_must.met in
let _ := Section_3_proofs.eq_3_1_types_a.proved in
let _ := Section_3_proofs.eq_3_1_types_a.met in
let _ := Section_3_proofs.eq_3_1_types_b.proved in
let _ := Section_3_proofs.eq_3_1_parallel_planes.proved in
let _ := Section_3_proofs.eq_3_1_parallel_planes.met in
let _ := Section_3_proofs.eq_3_1_rho_constant.proved in
let _ := Section_3_proofs.eq_3_1_rho_constant.met in
let _ := Section_3_proofs.eq_3_1_rho_quadratic.proved in
let _ := Section_3_proofs.eq_3_1_rho_quadratic.met in
let _ := Section_3_proofs.eq_3_1_difficulties_same.proved in
let _ := Section_3_proofs.eq_3_1_difficulties_same.met in
let _ := Section_3_proofs.eq_3_2.proved in
let _ := Section_3_proofs.eq_3_2.met in
let _ := Section_3_proofs.eq_3_2_edge.proved in
let _ := Section_3_proofs.eq_3_2_edge.met in
let _ := Section_3_proofs.eq_3_2_planes_a_generatrix.refuted in
let _ := Section_3_proofs.eq_3_2_planes_a_direction.proved in
let _ := Section_3_proofs.eq_3_2_planes_a_direction.met in
let _ := Section_3_proofs.eq_3_2_planes_b_generatrix.refuted in
let _ := Section_3_proofs.eq_3_2_planes_b_direction.refuted in
let _ := Section_3_proofs.eq_3_2_planes_parallel.proved in
let _ := Section_3_proofs.eq_3_2_planes_parallel.met in
let _ := Section_3_proofs.eq_3_2_with_h.proved in
let _ := Section_3_proofs.eq_3_2_with_h.met in
let _ := Section_3_proofs.eq_3_2_across.proved in
let _ := Section_3_proofs.eq_3_2_across.met in
let _ := Section_3_proofs.eq_3_2_across_summit.proved in
let _ := Section_3_proofs.eq_3_2_across_summit.met in
let _ := Section_3_proofs.eq_3_2_every_degree.proved in
let _ := Section_3_proofs.eq_3_2_every_degree.met in
let _ := Section_3_proofs.eq_3_3_g_generatrix.refuted in
let _ := Section_3_proofs.eq_3_3_g_direction.proved in
let _ := Section_3_proofs.eq_3_3_g_true.proved in
let _ := Section_3_proofs.eq_3_3a.proved in
let _ := Section_3_proofs.eq_3_3a.met in
let _ := Section_3_proofs.eq_3_3b.proved in
let _ := Section_3_proofs.eq_3_3b.met in
let _ := Section_3_proofs.eq_3_3_same_as_3_2_generatrix.refuted in
let _ := Section_3_proofs.eq_3_3_same_as_3_2_direction.proved in
let _ := Section_3_proofs.eq_3_3_same_as_3_2_direction.met in
let _ := Section_3_proofs.eq_3_3_same_as_3_2_true.proved in
let _ := Section_3_proofs.eq_3_3_same_as_3_2_true.met in
let _ := Section_3_proofs.eq_3_3_developable_Hermite.proved in
let _ := Section_3_proofs.eq_3_3_developable_Hermite.met in
let _ := Section_3_proofs.eq_3_3_developable_any.refuted in
let _ := Section_3_proofs.eq_3_3_exact.proved in
let _ := Section_3_proofs.eq_3_3_exact.met in
let _ := Section_3_proofs.eq_3_3_multiples_cone.proved in
let _ := Section_3_proofs.eq_3_3_multiples_cone.met in
let _ := Section_3_proofs.eq_3_3_multiples_Hermite.proved in
let _ := Section_3_proofs.eq_3_3_multiples_Hermite.met in
let _ := Section_3_proofs.eq_3_3_multiples_any.refuted in
let _ := Section_3_proofs.eq_3_3_k_below_1.proved in
let _ := Section_3_proofs.eq_3_3_k_below_1.met in
let _ := Section_3_proofs.eq_3_3_k_equal_1.proved in
let _ := Section_3_proofs.eq_3_3_k_equal_1.met in
let _ := Section_3_proofs.eq_3_3_k_above_1.proved in
let _ := Section_3_proofs.eq_3_3_k_above_1.met in
let _ := Section_3_proofs.sec_3_summit_outside.proved in
let _ := Section_3_proofs.sec_3_summit_outside.met in
let _ := Section_3_proofs.eq_3_4.proved in
let _ := Section_3_proofs.eq_3_4.met in
let _ := Section_4_printed_proofs.sec_4_cone.proved in
let _ := Section_4_printed_proofs.sec_4_cone.met in
let _ := Section_4_printed_proofs.eq_4_1.proved in
let _ := Section_4_printed_proofs.eq_4_1.met in
let _ := Section_4_printed_proofs.sec_4_goal_designed.refuted in
let _ := Section_4_printed_proofs.sec_4_goal_image.proved in
let _ := Section_4_printed_proofs.sec_4_goal_image.met in
let _ := Section_4_printed_proofs.sec_4_goal_leaves.proved in
let _ := Section_4_printed_proofs.sec_4_goal_leaves.met in
let _ := Section_4_printed_proofs.sec_4_goal_nodes.proved in
let _ := Section_4_printed_proofs.sec_4_goal_nodes.met in
let _ := Section_4_printed_proofs.sec_4_goal_only.proved in
let _ := Section_4_printed_proofs.sec_4_goal_only.met in
let _ := Section_4_printed_proofs.sec_4_goal_parallel.proved in
let _ := Section_4_printed_proofs.sec_4_goal_parallel.met in
let _ := Section_4_printed_proofs.sec_4_in_plane.proved in
let _ := Section_4_printed_proofs.sec_4_in_plane.met in
let _ := Section_4_printed_proofs.sec_4_r0.proved in
let _ := Section_4_printed_proofs.sec_4_r0.met in
let _ := Section_4_printed_proofs.sec_4_I1.proved in
let _ := Section_4_printed_proofs.sec_4_I1.met in
let _ := Section_4_printed_proofs.sec_4_w.proved in
let _ := Section_4_printed_proofs.sec_4_w.met in
let _ := Section_4_printed_proofs.eq_4_2.proved in
let _ := Section_4_printed_proofs.eq_4_2.met in
let _ := Section_4_printed_proofs.eq_4_2_tangent_derivative.refuted in
let _ := Section_4_printed_proofs.eq_4_2_tangent_end_point.proved in
let _ := Section_4_printed_proofs.eq_4_2_tangent_end_point.met in
let _ := Section_4_printed_proofs.eq_4_2_tangent_parallel.proved in
let _ := Section_4_printed_proofs.eq_4_2_tangent_parallel.met in
let _ := Section_4_printed_proofs.eq_4_2_tangent_true.proved in
let _ := Section_4_printed_proofs.eq_4_2_tangent_true.met in
let _ := Section_4_printed_proofs.sec_4_s.proved in
let _ := Section_4_printed_proofs.sec_4_s.met in
let _ := Section_4_printed_proofs.eq_4_3.proved in
let _ := Section_4_printed_proofs.eq_4_3.met in
let _ := Section_4_printed_proofs.eq_4_4_ru.proved in
let _ := Section_4_printed_proofs.eq_4_4_ru.met in
let _ := Section_4_printed_proofs.eq_4_4_r1.proved in
let _ := Section_4_printed_proofs.eq_4_4_r1.met in
let _ := Section_4_printed_proofs.eq_4_4_r1u.proved in
let _ := Section_4_printed_proofs.eq_4_4_r1u.met in
let _ := Section_4_printed_proofs.eq_4_4_tangent_derivative.refuted in
let _ := Section_4_printed_proofs.eq_4_4_tangent_end_point.proved in
let _ := Section_4_printed_proofs.eq_4_4_tangent_end_point.met in
let _ := Section_4_printed_proofs.eq_4_4_tangent_parallel.proved in
let _ := Section_4_printed_proofs.eq_4_4_tangent_parallel.met in
let _ := Section_4_printed_proofs.sec_4_oblique.proved in
let _ := Section_4_printed_proofs.ex_4_data.proved in
let _ := Section_4_printed_proofs.ex_4_data.met in
let _ := Section_4_printed_proofs.ex_4_r0.proved in
let _ := Section_4_printed_proofs.ex_4_r0.met in
let _ := Section_4_printed_proofs.ex_4_r0u.refuted in
let _ := Section_4_printed_proofs.ex_4_r.proved in
let _ := Section_4_printed_proofs.ex_4_r.met in
let _ := Section_4_printed_proofs.ex_4_ru.refuted in
let _ := Section_4_printed_proofs.ex_4_r1.proved in
let _ := Section_4_printed_proofs.ex_4_r1.met in
let _ := Section_4_printed_proofs.ex_4_r1_rounding.proved in
let _ := Section_4_printed_proofs.ex_4_r1_rounding.met in
let _ := Section_4_printed_proofs.ex_4_r1u.refuted in
let _ := Section_4_printed_proofs.ex_4_other_data.proved in
let _ := Section_4_printed_proofs.ex_4_other_data.met in
let _ := Section_4_printed_proofs.ex_4_other_data_twist.proved in
let _ := Section_4_printed_proofs.ex_4_other_data_twist.met in
let _ := Section_4_printed_proofs.ex_4_stated_data.proved in
let _ := Section_4_printed_proofs.ex_4_stated_data.met in
let _ := Section_4_printed_proofs.ex_4_true_tangents.proved in
let _ := Section_4_printed_proofs.ex_4_true_tangents.met in
let _ := Section_4_printed_proofs.ex_4_a_developable_computed.refuted in
let _ := Section_4_printed_proofs.ex_4_a_developable_printed.refuted in
let _ := Section_4_printed_proofs.ex_4_a_twist.proved in
let _ := Section_4_printed_proofs.ex_4_a_twist.met in
let _ := Section_4_printed_proofs.ex_4_a_twist_most.proved in
let _ := Section_4_printed_proofs.ex_4_a_twist_most.met in
let _ := Section_4_printed_proofs.ex_4_a_twist_printed.proved in
let _ := Section_4_printed_proofs.ex_4_a_twist_printed.met in
let _ := Section_4_printed_proofs.ex_4_b_developable.refuted in
let _ := Section_4_printed_proofs.ex_4_b_twist.proved in
let _ := Section_4_printed_proofs.ex_4_b_twist.met in
let _ := Section_4_proofs.sec_4_cone.proved in
let _ := Section_4_proofs.sec_4_cone.met in
let _ := Section_4_proofs.eq_4_1.proved in
let _ := Section_4_proofs.eq_4_1.met in
let _ := Section_4_proofs.sec_4_goal_designed.refuted in
let _ := Section_4_proofs.sec_4_goal_image.proved in
let _ := Section_4_proofs.sec_4_goal_image.met in
let _ := Section_4_proofs.sec_4_goal_leaves.proved in
let _ := Section_4_proofs.sec_4_goal_leaves.met in
let _ := Section_4_proofs.sec_4_goal_nodes.proved in
let _ := Section_4_proofs.sec_4_goal_nodes.met in
let _ := Section_4_proofs.sec_4_goal_only.proved in
let _ := Section_4_proofs.sec_4_goal_only.met in
let _ := Section_4_proofs.sec_4_goal_parallel.proved in
let _ := Section_4_proofs.sec_4_goal_parallel.met in
let _ := Section_4_proofs.sec_4_in_plane.proved in
let _ := Section_4_proofs.sec_4_in_plane.met in
let _ := Section_4_proofs.sec_4_r0.proved in
let _ := Section_4_proofs.sec_4_r0.met in
let _ := Section_4_proofs.sec_4_I1.proved in
let _ := Section_4_proofs.sec_4_I1.met in
let _ := Section_4_proofs.sec_4_w.proved in
let _ := Section_4_proofs.sec_4_w.met in
let _ := Section_4_proofs.eq_4_2.proved in
let _ := Section_4_proofs.eq_4_2.met in
let _ := Section_4_proofs.eq_4_2_tangent_derivative.refuted in
let _ := Section_4_proofs.eq_4_2_tangent_end_point.proved in
let _ := Section_4_proofs.eq_4_2_tangent_end_point.met in
let _ := Section_4_proofs.eq_4_2_tangent_parallel.proved in
let _ := Section_4_proofs.eq_4_2_tangent_parallel.met in
let _ := Section_4_proofs.eq_4_2_tangent_true.proved in
let _ := Section_4_proofs.eq_4_2_tangent_true.met in
let _ := Section_4_proofs.sec_4_s.proved in
let _ := Section_4_proofs.sec_4_s.met in
let _ := Section_4_proofs.eq_4_3.proved in
let _ := Section_4_proofs.eq_4_3.met in
let _ := Section_4_proofs.eq_4_4_ru.proved in
let _ := Section_4_proofs.eq_4_4_ru.met in
let _ := Section_4_proofs.eq_4_4_r1.proved in
let _ := Section_4_proofs.eq_4_4_r1.met in
let _ := Section_4_proofs.eq_4_4_r1u.proved in
let _ := Section_4_proofs.eq_4_4_r1u.met in
let _ := Section_4_proofs.eq_4_4_tangent_derivative.refuted in
let _ := Section_4_proofs.eq_4_4_tangent_end_point.proved in
let _ := Section_4_proofs.eq_4_4_tangent_end_point.met in
let _ := Section_4_proofs.eq_4_4_tangent_parallel.proved in
let _ := Section_4_proofs.eq_4_4_tangent_parallel.met in
let _ := Section_4_proofs.sec_4_oblique.proved in
let _ := Section_4_proofs.ex_4_data.proved in
let _ := Section_4_proofs.ex_4_data.met in
let _ := Section_4_proofs.ex_4_r0.proved in
let _ := Section_4_proofs.ex_4_r0.met in
let _ := Section_4_proofs.ex_4_r0u.refuted in
let _ := Section_4_proofs.ex_4_r.proved in
let _ := Section_4_proofs.ex_4_r.met in
let _ := Section_4_proofs.ex_4_ru.refuted in
let _ := Section_4_proofs.ex_4_r1.proved in
let _ := Section_4_proofs.ex_4_r1.met in
let _ := Section_4_proofs.ex_4_r1_rounding.proved in
let _ := Section_4_proofs.ex_4_r1_rounding.met in
let _ := Section_4_proofs.ex_4_r1u.refuted in
let _ := Section_4_proofs.ex_4_other_data.proved in
let _ := Section_4_proofs.ex_4_other_data.met in
let _ := Section_4_proofs.ex_4_other_data_twist.proved in
let _ := Section_4_proofs.ex_4_other_data_twist.met in
let _ := Section_4_proofs.ex_4_stated_data.proved in
let _ := Section_4_proofs.ex_4_stated_data.met in
let _ := Section_4_proofs.ex_4_true_tangents.proved in
let _ := Section_4_proofs.ex_4_true_tangents.met in
let _ := Section_4_proofs.ex_4_a_developable_computed.refuted in
let _ := Section_4_proofs.ex_4_a_developable_printed.refuted in
let _ := Section_4_proofs.ex_4_a_twist.proved in
let _ := Section_4_proofs.ex_4_a_twist.met in
let _ := Section_4_proofs.ex_4_a_twist_most.proved in
let _ := Section_4_proofs.ex_4_a_twist_most.met in
let _ := Section_4_proofs.ex_4_a_twist_printed.proved in
let _ := Section_4_proofs.ex_4_a_twist_printed.met in
let _ := Section_4_proofs.ex_4_b_developable.refuted in
let _ := Section_4_proofs.ex_4_b_twist.proved in
let _ := Section_4_proofs.ex_4_b_twist.met in
let _ := Section_5_printed_proofs.sec_5_criteria_a.proved in
let _ := Section_5_printed_proofs.sec_5_criteria_a.met in
let _ := Section_5_printed_proofs.sec_5_criteria_reach.proved in
let _ := Section_5_printed_proofs.sec_5_criteria_reach.met in
let _ := Section_5_printed_proofs.sec_5_planes_a.proved in
let _ := Section_5_printed_proofs.sec_5_planes_a.met in
let _ := Section_5_printed_proofs.sec_5_planes_parallel.proved in
let _ := Section_5_printed_proofs.sec_5_planes_parallel.met in
let _ := Section_5_printed_proofs.sec_5_planes_b.refuted in
let _ := Section_5_proofs.sec_5_criteria_a.proved in
let _ := Section_5_proofs.sec_5_criteria_a.met in
let _ := Section_5_proofs.sec_5_criteria_reach.proved in
let _ := Section_5_proofs.sec_5_criteria_reach.met in
let _ := Section_5_proofs.sec_5_planes_a.proved in
let _ := Section_5_proofs.sec_5_planes_a.met in
let _ := Section_5_proofs.sec_5_planes_parallel.proved in
let _ := Section_5_proofs.sec_5_planes_parallel.met in
let _ := Section_5_proofs.sec_5_planes_b.refuted in
I.
