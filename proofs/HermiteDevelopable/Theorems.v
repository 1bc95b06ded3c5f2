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
Check (HermiteDevelopable.Part_Abstract_printed_proofs.abs_construct_a.proved : HermiteDevelopable.Part_Abstract_printed.abs_construct_a.statement).
Check (HermiteDevelopable.Part_Abstract_printed_proofs.abs_construct_a.met : HermiteDevelopable.Part_Abstract_printed.abs_construct_a.instance).
Check (HermiteDevelopable.Part_Abstract_printed_proofs.abs_construct_b.proved : HermiteDevelopable.Part_Abstract_printed.abs_construct_b.statement).
Check (HermiteDevelopable.Part_Abstract_printed_proofs.abs_construct_b.met : HermiteDevelopable.Part_Abstract_printed.abs_construct_b.instance).
Check (HermiteDevelopable.Part_Abstract_printed_proofs.abs_construct_c.proved : HermiteDevelopable.Part_Abstract_printed.abs_construct_c.statement).
Check (HermiteDevelopable.Part_Abstract_printed_proofs.abs_construct_c.met : HermiteDevelopable.Part_Abstract_printed.abs_construct_c.instance).
Check (HermiteDevelopable.Part_Abstract_printed_proofs.abs_construct_d.refuted : ~ HermiteDevelopable.Part_Abstract_printed.abs_construct_d.statement).
Check (HermiteDevelopable.Part_Abstract_proofs.abs_construct_a.proved : HermiteDevelopable.Part_Abstract.abs_construct_a.statement).
Check (HermiteDevelopable.Part_Abstract_proofs.abs_construct_a.met : HermiteDevelopable.Part_Abstract.abs_construct_a.instance).
Check (HermiteDevelopable.Part_Abstract_proofs.abs_construct_b.proved : HermiteDevelopable.Part_Abstract.abs_construct_b.statement).
Check (HermiteDevelopable.Part_Abstract_proofs.abs_construct_b.met : HermiteDevelopable.Part_Abstract.abs_construct_b.instance).
Check (HermiteDevelopable.Part_Abstract_proofs.abs_construct_c.proved : HermiteDevelopable.Part_Abstract.abs_construct_c.statement).
Check (HermiteDevelopable.Part_Abstract_proofs.abs_construct_c.met : HermiteDevelopable.Part_Abstract.abs_construct_c.instance).
Check (HermiteDevelopable.Part_Abstract_proofs.abs_construct_d.refuted : ~ HermiteDevelopable.Part_Abstract.abs_construct_d.statement).
Check (HermiteDevelopable.Section_1_printed_proofs.sec_1_parallel_tangents.proved : HermiteDevelopable.Section_1_printed.sec_1_parallel_tangents.statement).
Check (HermiteDevelopable.Section_1_printed_proofs.sec_1_parallel_tangents.met : HermiteDevelopable.Section_1_printed.sec_1_parallel_tangents.instance).
Check (HermiteDevelopable.Section_1_proofs.sec_1_parallel_tangents.proved : HermiteDevelopable.Section_1.sec_1_parallel_tangents.statement).
Check (HermiteDevelopable.Section_1_proofs.sec_1_parallel_tangents.met : HermiteDevelopable.Section_1.sec_1_parallel_tangents.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_conditions.proved : HermiteDevelopable.Section_2_printed.sec_2_cubic_conditions.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_conditions.met : HermiteDevelopable.Section_2_printed.sec_2_cubic_conditions.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_equations.proved : HermiteDevelopable.Section_2_printed.sec_2_cubic_equations.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_a1.proved : HermiteDevelopable.Section_2_printed.sec_2_cubic_a1.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_a1.met : HermiteDevelopable.Section_2_printed.sec_2_cubic_a1.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_b1.proved : HermiteDevelopable.Section_2_printed.sec_2_cubic_b1.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_b1.met : HermiteDevelopable.Section_2_printed.sec_2_cubic_b1.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_c1.proved : HermiteDevelopable.Section_2_printed.sec_2_cubic_c1.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_c1.met : HermiteDevelopable.Section_2_printed.sec_2_cubic_c1.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_d1.proved : HermiteDevelopable.Section_2_printed.sec_2_cubic_d1.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_d1.met : HermiteDevelopable.Section_2_printed.sec_2_cubic_d1.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_1a.proved : HermiteDevelopable.Section_2_printed.eq_2_1a.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_1a.met : HermiteDevelopable.Section_2_printed.eq_2_1a.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_1b.proved : HermiteDevelopable.Section_2_printed.eq_2_1b.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_1b.met : HermiteDevelopable.Section_2_printed.eq_2_1b.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_1b_H1.proved : HermiteDevelopable.Section_2_printed.eq_2_1b_H1.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_1b_H1.met : HermiteDevelopable.Section_2_printed.eq_2_1b_H1.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_1b_H2.proved : HermiteDevelopable.Section_2_printed.eq_2_1b_H2.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_1b_H2.met : HermiteDevelopable.Section_2_printed.eq_2_1b_H2.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_1b_H3.proved : HermiteDevelopable.Section_2_printed.eq_2_1b_H3.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_1b_H3.met : HermiteDevelopable.Section_2_printed.eq_2_1b_H3.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_1b_H4.proved : HermiteDevelopable.Section_2_printed.eq_2_1b_H4.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_1b_H4.met : HermiteDevelopable.Section_2_printed.eq_2_1b_H4.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_conditions.proved : HermiteDevelopable.Section_2_printed.sec_2_quartic_conditions.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_conditions.met : HermiteDevelopable.Section_2_printed.sec_2_quartic_conditions.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_solvable.proved : HermiteDevelopable.Section_2_printed.sec_2_quartic_solvable.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_a1.proved : HermiteDevelopable.Section_2_printed.sec_2_quartic_a1.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_a1.met : HermiteDevelopable.Section_2_printed.sec_2_quartic_a1.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_b1.proved : HermiteDevelopable.Section_2_printed.sec_2_quartic_b1.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_b1.met : HermiteDevelopable.Section_2_printed.sec_2_quartic_b1.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_third.refuted : ~ HermiteDevelopable.Section_2_printed.sec_2_quartic_third.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_third_corrected.proved : HermiteDevelopable.Section_2_printed.sec_2_quartic_third_corrected.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_third_corrected.met : HermiteDevelopable.Section_2_printed.sec_2_quartic_third_corrected.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_d1.proved : HermiteDevelopable.Section_2_printed.sec_2_quartic_d1.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_d1.met : HermiteDevelopable.Section_2_printed.sec_2_quartic_d1.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_e1.proved : HermiteDevelopable.Section_2_printed.sec_2_quartic_e1.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_e1.met : HermiteDevelopable.Section_2_printed.sec_2_quartic_e1.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_2.proved : HermiteDevelopable.Section_2_printed.eq_2_2.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_2.met : HermiteDevelopable.Section_2_printed.eq_2_2.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_3.refuted : ~ HermiteDevelopable.Section_2_printed.eq_2_3.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_3_corrected.proved : HermiteDevelopable.Section_2_printed.eq_2_3_corrected.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_3_corrected.met : HermiteDevelopable.Section_2_printed.eq_2_3_corrected.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H1.proved : HermiteDevelopable.Section_2_printed.eq_2_3_H1.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H1.met : HermiteDevelopable.Section_2_printed.eq_2_3_H1.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H2.proved : HermiteDevelopable.Section_2_printed.eq_2_3_H2.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H2.met : HermiteDevelopable.Section_2_printed.eq_2_3_H2.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H3.proved : HermiteDevelopable.Section_2_printed.eq_2_3_H3.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H3.met : HermiteDevelopable.Section_2_printed.eq_2_3_H3.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H4.proved : HermiteDevelopable.Section_2_printed.eq_2_3_H4.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H4.met : HermiteDevelopable.Section_2_printed.eq_2_3_H4.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H5.proved : HermiteDevelopable.Section_2_printed.eq_2_3_H5.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H5.met : HermiteDevelopable.Section_2_printed.eq_2_3_H5.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_conditions.proved : HermiteDevelopable.Section_2_printed.sec_2_quintic_conditions.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_conditions.met : HermiteDevelopable.Section_2_printed.sec_2_quintic_conditions.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_a1.proved : HermiteDevelopable.Section_2_printed.sec_2_quintic_a1.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_a1.met : HermiteDevelopable.Section_2_printed.sec_2_quintic_a1.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_b1.proved : HermiteDevelopable.Section_2_printed.sec_2_quintic_b1.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_b1.met : HermiteDevelopable.Section_2_printed.sec_2_quintic_b1.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_c1.proved : HermiteDevelopable.Section_2_printed.sec_2_quintic_c1.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_c1.met : HermiteDevelopable.Section_2_printed.sec_2_quintic_c1.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_d1.proved : HermiteDevelopable.Section_2_printed.sec_2_quintic_d1.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_d1.met : HermiteDevelopable.Section_2_printed.sec_2_quintic_d1.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_e1.proved : HermiteDevelopable.Section_2_printed.sec_2_quintic_e1.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_e1.met : HermiteDevelopable.Section_2_printed.sec_2_quintic_e1.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_f1.proved : HermiteDevelopable.Section_2_printed.sec_2_quintic_f1.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_f1.met : HermiteDevelopable.Section_2_printed.sec_2_quintic_f1.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_4.proved : HermiteDevelopable.Section_2_printed.eq_2_4.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.eq_2_4.met : HermiteDevelopable.Section_2_printed.eq_2_4.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_control.proved : HermiteDevelopable.Section_2_printed.sec_2_control.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.sec_2_control.met : HermiteDevelopable.Section_2_printed.sec_2_control.instance).
Check (HermiteDevelopable.Section_2_printed_proofs.fig_1b_middle.proved : HermiteDevelopable.Section_2_printed.fig_1b_middle.statement).
Check (HermiteDevelopable.Section_2_printed_proofs.fig_1b_middle.met : HermiteDevelopable.Section_2_printed.fig_1b_middle.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_conditions.proved : HermiteDevelopable.Section_2.sec_2_cubic_conditions.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_conditions.met : HermiteDevelopable.Section_2.sec_2_cubic_conditions.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_equations.proved : HermiteDevelopable.Section_2.sec_2_cubic_equations.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_a1.proved : HermiteDevelopable.Section_2.sec_2_cubic_a1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_a1.met : HermiteDevelopable.Section_2.sec_2_cubic_a1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_b1.proved : HermiteDevelopable.Section_2.sec_2_cubic_b1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_b1.met : HermiteDevelopable.Section_2.sec_2_cubic_b1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_c1.proved : HermiteDevelopable.Section_2.sec_2_cubic_c1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_c1.met : HermiteDevelopable.Section_2.sec_2_cubic_c1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_d1.proved : HermiteDevelopable.Section_2.sec_2_cubic_d1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_cubic_d1.met : HermiteDevelopable.Section_2.sec_2_cubic_d1.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1a.proved : HermiteDevelopable.Section_2.eq_2_1a.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1a.met : HermiteDevelopable.Section_2.eq_2_1a.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b.proved : HermiteDevelopable.Section_2.eq_2_1b.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b.met : HermiteDevelopable.Section_2.eq_2_1b.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b_H1.proved : HermiteDevelopable.Section_2.eq_2_1b_H1.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b_H1.met : HermiteDevelopable.Section_2.eq_2_1b_H1.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b_H2.proved : HermiteDevelopable.Section_2.eq_2_1b_H2.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b_H2.met : HermiteDevelopable.Section_2.eq_2_1b_H2.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b_H3.proved : HermiteDevelopable.Section_2.eq_2_1b_H3.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b_H3.met : HermiteDevelopable.Section_2.eq_2_1b_H3.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b_H4.proved : HermiteDevelopable.Section_2.eq_2_1b_H4.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_1b_H4.met : HermiteDevelopable.Section_2.eq_2_1b_H4.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_conditions.proved : HermiteDevelopable.Section_2.sec_2_quartic_conditions.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_conditions.met : HermiteDevelopable.Section_2.sec_2_quartic_conditions.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_solvable.proved : HermiteDevelopable.Section_2.sec_2_quartic_solvable.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_a1.proved : HermiteDevelopable.Section_2.sec_2_quartic_a1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_a1.met : HermiteDevelopable.Section_2.sec_2_quartic_a1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_b1.proved : HermiteDevelopable.Section_2.sec_2_quartic_b1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_b1.met : HermiteDevelopable.Section_2.sec_2_quartic_b1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_third.refuted : ~ HermiteDevelopable.Section_2.sec_2_quartic_third.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_third_corrected.proved : HermiteDevelopable.Section_2.sec_2_quartic_third_corrected.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_third_corrected.met : HermiteDevelopable.Section_2.sec_2_quartic_third_corrected.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_d1.proved : HermiteDevelopable.Section_2.sec_2_quartic_d1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_d1.met : HermiteDevelopable.Section_2.sec_2_quartic_d1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_e1.proved : HermiteDevelopable.Section_2.sec_2_quartic_e1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quartic_e1.met : HermiteDevelopable.Section_2.sec_2_quartic_e1.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_2.proved : HermiteDevelopable.Section_2.eq_2_2.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_2.met : HermiteDevelopable.Section_2.eq_2_2.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3.refuted : ~ HermiteDevelopable.Section_2.eq_2_3.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_corrected.proved : HermiteDevelopable.Section_2.eq_2_3_corrected.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_corrected.met : HermiteDevelopable.Section_2.eq_2_3_corrected.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H1.proved : HermiteDevelopable.Section_2.eq_2_3_H1.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H1.met : HermiteDevelopable.Section_2.eq_2_3_H1.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H2.proved : HermiteDevelopable.Section_2.eq_2_3_H2.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H2.met : HermiteDevelopable.Section_2.eq_2_3_H2.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H3.proved : HermiteDevelopable.Section_2.eq_2_3_H3.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H3.met : HermiteDevelopable.Section_2.eq_2_3_H3.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H4.proved : HermiteDevelopable.Section_2.eq_2_3_H4.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H4.met : HermiteDevelopable.Section_2.eq_2_3_H4.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H5.proved : HermiteDevelopable.Section_2.eq_2_3_H5.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_3_H5.met : HermiteDevelopable.Section_2.eq_2_3_H5.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_conditions.proved : HermiteDevelopable.Section_2.sec_2_quintic_conditions.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_conditions.met : HermiteDevelopable.Section_2.sec_2_quintic_conditions.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_a1.proved : HermiteDevelopable.Section_2.sec_2_quintic_a1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_a1.met : HermiteDevelopable.Section_2.sec_2_quintic_a1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_b1.proved : HermiteDevelopable.Section_2.sec_2_quintic_b1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_b1.met : HermiteDevelopable.Section_2.sec_2_quintic_b1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_c1.proved : HermiteDevelopable.Section_2.sec_2_quintic_c1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_c1.met : HermiteDevelopable.Section_2.sec_2_quintic_c1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_d1.proved : HermiteDevelopable.Section_2.sec_2_quintic_d1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_d1.met : HermiteDevelopable.Section_2.sec_2_quintic_d1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_e1.proved : HermiteDevelopable.Section_2.sec_2_quintic_e1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_e1.met : HermiteDevelopable.Section_2.sec_2_quintic_e1.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_f1.proved : HermiteDevelopable.Section_2.sec_2_quintic_f1.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_quintic_f1.met : HermiteDevelopable.Section_2.sec_2_quintic_f1.instance).
Check (HermiteDevelopable.Section_2_proofs.eq_2_4.proved : HermiteDevelopable.Section_2.eq_2_4.statement).
Check (HermiteDevelopable.Section_2_proofs.eq_2_4.met : HermiteDevelopable.Section_2.eq_2_4.instance).
Check (HermiteDevelopable.Section_2_proofs.sec_2_control.proved : HermiteDevelopable.Section_2.sec_2_control.statement).
Check (HermiteDevelopable.Section_2_proofs.sec_2_control.met : HermiteDevelopable.Section_2.sec_2_control.instance).
Check (HermiteDevelopable.Section_2_proofs.fig_1b_middle.proved : HermiteDevelopable.Section_2.fig_1b_middle.statement).
Check (HermiteDevelopable.Section_2_proofs.fig_1b_middle.met : HermiteDevelopable.Section_2.fig_1b_middle.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_polynomials.proved : HermiteDevelopable.Section_3_1_printed.sec_3_1_polynomials.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_polynomials.met : HermiteDevelopable.Section_3_1_printed.sec_3_1_polynomials.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_substituted.proved : HermiteDevelopable.Section_3_1_printed.sec_3_1_substituted.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_substituted.met : HermiteDevelopable.Section_3_1_printed.sec_3_1_substituted.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_coefficients.proved : HermiteDevelopable.Section_3_1_printed.sec_3_1_coefficients.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_coefficients.met : HermiteDevelopable.Section_3_1_printed.sec_3_1_coefficients.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_hermite_1.proved : HermiteDevelopable.Section_3_1_printed.sec_3_1_hermite_1.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_hermite_1.met : HermiteDevelopable.Section_3_1_printed.sec_3_1_hermite_1.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_hermite_2.proved : HermiteDevelopable.Section_3_1_printed.sec_3_1_hermite_2.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_hermite_2.met : HermiteDevelopable.Section_3_1_printed.sec_3_1_hermite_2.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_hermite_3.proved : HermiteDevelopable.Section_3_1_printed.sec_3_1_hermite_3.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_hermite_3.met : HermiteDevelopable.Section_3_1_printed.sec_3_1_hermite_3.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_hermite_4.proved : HermiteDevelopable.Section_3_1_printed.sec_3_1_hermite_4.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_hermite_4.met : HermiteDevelopable.Section_3_1_printed.sec_3_1_hermite_4.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_A_r1.proved : HermiteDevelopable.Section_3_1_printed.eq_3_5_A_r1.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_A_r1.met : HermiteDevelopable.Section_3_1_printed.eq_3_5_A_r1.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_A_r2.proved : HermiteDevelopable.Section_3_1_printed.eq_3_5_A_r2.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_A_r2.met : HermiteDevelopable.Section_3_1_printed.eq_3_5_A_r2.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_A_r3.proved : HermiteDevelopable.Section_3_1_printed.eq_3_5_A_r3.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_A_r3.met : HermiteDevelopable.Section_3_1_printed.eq_3_5_A_r3.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_A_r4.proved : HermiteDevelopable.Section_3_1_printed.eq_3_5_A_r4.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_A_r4.met : HermiteDevelopable.Section_3_1_printed.eq_3_5_A_r4.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_B.refuted : ~ HermiteDevelopable.Section_3_1_printed.eq_3_5_B.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_B_corrected.proved : HermiteDevelopable.Section_3_1_printed.eq_3_5_B_corrected.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_B_corrected.met : HermiteDevelopable.Section_3_1_printed.eq_3_5_B_corrected.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_C_r1.proved : HermiteDevelopable.Section_3_1_printed.eq_3_5_C_r1.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_C_r1.met : HermiteDevelopable.Section_3_1_printed.eq_3_5_C_r1.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_C_r2.proved : HermiteDevelopable.Section_3_1_printed.eq_3_5_C_r2.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_C_r2.met : HermiteDevelopable.Section_3_1_printed.eq_3_5_C_r2.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_C_r3.proved : HermiteDevelopable.Section_3_1_printed.eq_3_5_C_r3.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_C_r3.met : HermiteDevelopable.Section_3_1_printed.eq_3_5_C_r3.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_C_r4.proved : HermiteDevelopable.Section_3_1_printed.eq_3_5_C_r4.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_C_r4.met : HermiteDevelopable.Section_3_1_printed.eq_3_5_C_r4.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_sizes.proved : HermiteDevelopable.Section_3_1_printed.eq_3_5_sizes.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_unique.proved : HermiteDevelopable.Section_3_1_printed.eq_3_5_unique.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_unique.met : HermiteDevelopable.Section_3_1_printed.eq_3_5_unique.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_det.proved : HermiteDevelopable.Section_3_1_printed.eq_3_5_det.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_k.proved : HermiteDevelopable.Section_3_1_printed.eq_3_5_k.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_k.met : HermiteDevelopable.Section_3_1_printed.eq_3_5_k.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_sol_p1.proved : HermiteDevelopable.Section_3_1_printed.eq_3_5_sol_p1.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_sol_p1.met : HermiteDevelopable.Section_3_1_printed.eq_3_5_sol_p1.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_sol_p0u.proved : HermiteDevelopable.Section_3_1_printed.eq_3_5_sol_p0u.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_sol_p0u.met : HermiteDevelopable.Section_3_1_printed.eq_3_5_sol_p0u.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_sol_p1u.proved : HermiteDevelopable.Section_3_1_printed.eq_3_5_sol_p1u.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_sol_p1u.met : HermiteDevelopable.Section_3_1_printed.eq_3_5_sol_p1u.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_sol_p0.proved : HermiteDevelopable.Section_3_1_printed.eq_3_5_sol_p0.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_sol_p0.met : HermiteDevelopable.Section_3_1_printed.eq_3_5_sol_p0.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_conclusion.proved : HermiteDevelopable.Section_3_1_printed.sec_3_1_conclusion.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_conclusion.met : HermiteDevelopable.Section_3_1_printed.sec_3_1_conclusion.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.alg_3_1_step1.proved : HermiteDevelopable.Section_3_1_printed.alg_3_1_step1.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.alg_3_1_step1.met : HermiteDevelopable.Section_3_1_printed.alg_3_1_step1.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.alg_3_1_step2.proved : HermiteDevelopable.Section_3_1_printed.alg_3_1_step2.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.alg_3_1_step2.met : HermiteDevelopable.Section_3_1_printed.alg_3_1_step2.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.alg_3_1_step3.proved : HermiteDevelopable.Section_3_1_printed.alg_3_1_step3.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.alg_3_1_step3.met : HermiteDevelopable.Section_3_1_printed.alg_3_1_step3.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_tension.proved : HermiteDevelopable.Section_3_1_printed.sec_3_1_tension.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_tension.met : HermiteDevelopable.Section_3_1_printed.sec_3_1_tension.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_arrange.proved : HermiteDevelopable.Section_3_1_printed.ex_3_1_arrange.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_arrange.met : HermiteDevelopable.Section_3_1_printed.ex_3_1_arrange.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_tension_effect.proved : HermiteDevelopable.Section_3_1_printed.ex_3_1_tension_effect.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_tension_effect.met : HermiteDevelopable.Section_3_1_printed.ex_3_1_tension_effect.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_p1.proved : HermiteDevelopable.Section_3_1_printed.ex_3_1_p1.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_p1.met : HermiteDevelopable.Section_3_1_printed.ex_3_1_p1.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_p0u.proved : HermiteDevelopable.Section_3_1_printed.ex_3_1_p0u.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_p0u.met : HermiteDevelopable.Section_3_1_printed.ex_3_1_p0u.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_p1u.proved : HermiteDevelopable.Section_3_1_printed.ex_3_1_p1u.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_p1u.met : HermiteDevelopable.Section_3_1_printed.ex_3_1_p1u.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_p0.proved : HermiteDevelopable.Section_3_1_printed.ex_3_1_p0.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_p0.met : HermiteDevelopable.Section_3_1_printed.ex_3_1_p0.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_parallel.proved : HermiteDevelopable.Section_3_1_printed.ex_3_1_parallel.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_parallel.met : HermiteDevelopable.Section_3_1_printed.ex_3_1_parallel.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_width.proved : HermiteDevelopable.Section_3_1_printed.ex_3_1_width.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_width.met : HermiteDevelopable.Section_3_1_printed.ex_3_1_width.instance).
Check (HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_shapes.proved : HermiteDevelopable.Section_3_1_printed.ex_3_1_shapes.statement).
Check (HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_shapes.met : HermiteDevelopable.Section_3_1_printed.ex_3_1_shapes.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_polynomials.proved : HermiteDevelopable.Section_3_1.sec_3_1_polynomials.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_polynomials.met : HermiteDevelopable.Section_3_1.sec_3_1_polynomials.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_substituted.proved : HermiteDevelopable.Section_3_1.sec_3_1_substituted.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_substituted.met : HermiteDevelopable.Section_3_1.sec_3_1_substituted.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_coefficients.proved : HermiteDevelopable.Section_3_1.sec_3_1_coefficients.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_coefficients.met : HermiteDevelopable.Section_3_1.sec_3_1_coefficients.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_1.proved : HermiteDevelopable.Section_3_1.sec_3_1_hermite_1.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_1.met : HermiteDevelopable.Section_3_1.sec_3_1_hermite_1.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_2.proved : HermiteDevelopable.Section_3_1.sec_3_1_hermite_2.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_2.met : HermiteDevelopable.Section_3_1.sec_3_1_hermite_2.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_3.proved : HermiteDevelopable.Section_3_1.sec_3_1_hermite_3.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_3.met : HermiteDevelopable.Section_3_1.sec_3_1_hermite_3.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_4.proved : HermiteDevelopable.Section_3_1.sec_3_1_hermite_4.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_4.met : HermiteDevelopable.Section_3_1.sec_3_1_hermite_4.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r1.proved : HermiteDevelopable.Section_3_1.eq_3_5_A_r1.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r1.met : HermiteDevelopable.Section_3_1.eq_3_5_A_r1.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r2.proved : HermiteDevelopable.Section_3_1.eq_3_5_A_r2.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r2.met : HermiteDevelopable.Section_3_1.eq_3_5_A_r2.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r3.proved : HermiteDevelopable.Section_3_1.eq_3_5_A_r3.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r3.met : HermiteDevelopable.Section_3_1.eq_3_5_A_r3.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r4.proved : HermiteDevelopable.Section_3_1.eq_3_5_A_r4.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r4.met : HermiteDevelopable.Section_3_1.eq_3_5_A_r4.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_B.refuted : ~ HermiteDevelopable.Section_3_1.eq_3_5_B.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_B_corrected.proved : HermiteDevelopable.Section_3_1.eq_3_5_B_corrected.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_B_corrected.met : HermiteDevelopable.Section_3_1.eq_3_5_B_corrected.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r1.proved : HermiteDevelopable.Section_3_1.eq_3_5_C_r1.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r1.met : HermiteDevelopable.Section_3_1.eq_3_5_C_r1.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r2.proved : HermiteDevelopable.Section_3_1.eq_3_5_C_r2.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r2.met : HermiteDevelopable.Section_3_1.eq_3_5_C_r2.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r3.proved : HermiteDevelopable.Section_3_1.eq_3_5_C_r3.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r3.met : HermiteDevelopable.Section_3_1.eq_3_5_C_r3.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r4.proved : HermiteDevelopable.Section_3_1.eq_3_5_C_r4.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r4.met : HermiteDevelopable.Section_3_1.eq_3_5_C_r4.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_sizes.proved : HermiteDevelopable.Section_3_1.eq_3_5_sizes.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_unique.proved : HermiteDevelopable.Section_3_1.eq_3_5_unique.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_unique.met : HermiteDevelopable.Section_3_1.eq_3_5_unique.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_det.proved : HermiteDevelopable.Section_3_1.eq_3_5_det.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_k.proved : HermiteDevelopable.Section_3_1.eq_3_5_k.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_k.met : HermiteDevelopable.Section_3_1.eq_3_5_k.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1.proved : HermiteDevelopable.Section_3_1.eq_3_5_sol_p1.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1.met : HermiteDevelopable.Section_3_1.eq_3_5_sol_p1.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0u.proved : HermiteDevelopable.Section_3_1.eq_3_5_sol_p0u.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0u.met : HermiteDevelopable.Section_3_1.eq_3_5_sol_p0u.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1u.proved : HermiteDevelopable.Section_3_1.eq_3_5_sol_p1u.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1u.met : HermiteDevelopable.Section_3_1.eq_3_5_sol_p1u.instance).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0.proved : HermiteDevelopable.Section_3_1.eq_3_5_sol_p0.statement).
Check (HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0.met : HermiteDevelopable.Section_3_1.eq_3_5_sol_p0.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_conclusion.proved : HermiteDevelopable.Section_3_1.sec_3_1_conclusion.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_conclusion.met : HermiteDevelopable.Section_3_1.sec_3_1_conclusion.instance).
Check (HermiteDevelopable.Section_3_1_proofs.alg_3_1_step1.proved : HermiteDevelopable.Section_3_1.alg_3_1_step1.statement).
Check (HermiteDevelopable.Section_3_1_proofs.alg_3_1_step1.met : HermiteDevelopable.Section_3_1.alg_3_1_step1.instance).
Check (HermiteDevelopable.Section_3_1_proofs.alg_3_1_step2.proved : HermiteDevelopable.Section_3_1.alg_3_1_step2.statement).
Check (HermiteDevelopable.Section_3_1_proofs.alg_3_1_step2.met : HermiteDevelopable.Section_3_1.alg_3_1_step2.instance).
Check (HermiteDevelopable.Section_3_1_proofs.alg_3_1_step3.proved : HermiteDevelopable.Section_3_1.alg_3_1_step3.statement).
Check (HermiteDevelopable.Section_3_1_proofs.alg_3_1_step3.met : HermiteDevelopable.Section_3_1.alg_3_1_step3.instance).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_tension.proved : HermiteDevelopable.Section_3_1.sec_3_1_tension.statement).
Check (HermiteDevelopable.Section_3_1_proofs.sec_3_1_tension.met : HermiteDevelopable.Section_3_1.sec_3_1_tension.instance).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_arrange.proved : HermiteDevelopable.Section_3_1.ex_3_1_arrange.statement).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_arrange.met : HermiteDevelopable.Section_3_1.ex_3_1_arrange.instance).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_tension_effect.proved : HermiteDevelopable.Section_3_1.ex_3_1_tension_effect.statement).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_tension_effect.met : HermiteDevelopable.Section_3_1.ex_3_1_tension_effect.instance).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1.proved : HermiteDevelopable.Section_3_1.ex_3_1_p1.statement).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1.met : HermiteDevelopable.Section_3_1.ex_3_1_p1.instance).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0u.proved : HermiteDevelopable.Section_3_1.ex_3_1_p0u.statement).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0u.met : HermiteDevelopable.Section_3_1.ex_3_1_p0u.instance).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1u.proved : HermiteDevelopable.Section_3_1.ex_3_1_p1u.statement).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1u.met : HermiteDevelopable.Section_3_1.ex_3_1_p1u.instance).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0.proved : HermiteDevelopable.Section_3_1.ex_3_1_p0.statement).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0.met : HermiteDevelopable.Section_3_1.ex_3_1_p0.instance).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_parallel.proved : HermiteDevelopable.Section_3_1.ex_3_1_parallel.statement).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_parallel.met : HermiteDevelopable.Section_3_1.ex_3_1_parallel.instance).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_width.proved : HermiteDevelopable.Section_3_1.ex_3_1_width.statement).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_width.met : HermiteDevelopable.Section_3_1.ex_3_1_width.instance).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_shapes.proved : HermiteDevelopable.Section_3_1.ex_3_1_shapes.statement).
Check (HermiteDevelopable.Section_3_1_proofs.ex_3_1_shapes.met : HermiteDevelopable.Section_3_1.ex_3_1_shapes.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.sec_3_2_curves.proved : HermiteDevelopable.Section_3_2_printed.sec_3_2_curves.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.sec_3_2_curves.met : HermiteDevelopable.Section_3_2_printed.sec_3_2_curves.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r1.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_A_r1.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r1.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_A_r1.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r2.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_A_r2.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r2.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_A_r2.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r3.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_A_r3.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r3.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_A_r3.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r4.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_A_r4.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r4.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_A_r4.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r5.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_A_r5.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r5.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_A_r5.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_B.refuted : ~ HermiteDevelopable.Section_3_2_printed.eq_3_6_B.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_B_corrected.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_B_corrected.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_B_corrected.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_B_corrected.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r1.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r1.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r1.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r1.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r2.refuted : ~ HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r2.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r2_corrected.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r2_corrected.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r2_corrected.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r2_corrected.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r3.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r3.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r3.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r3.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r4.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r4.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r4.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r4.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r5.refuted : ~ HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r5.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r5_corrected.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r5_corrected.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r5_corrected.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_C_r5_corrected.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_det.refuted : ~ HermiteDevelopable.Section_3_2_printed.eq_3_6_det.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_det_corrected.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_det_corrected.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_det_true.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_det_true.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_det_true.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_det_true.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_det_slip.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_det_slip.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_det_factored.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_det_factored.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_k.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_k.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_k.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_k.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_k_every.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_k_every.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_k_every.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_k_every.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_k_135_136.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_k_135_136.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_k_135_136.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_k_135_136.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_q.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_sol_q.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_q.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_sol_q.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_p1.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_sol_p1.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_p1.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_sol_p1.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_p0u.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_sol_p0u.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_p0u.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_sol_p0u.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_p1u.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_sol_p1u.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_p1u.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_sol_p1u.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_o.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_sol_o.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_o.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_sol_o.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_system.proved : HermiteDevelopable.Section_3_2_printed.eq_3_6_system.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_system.met : HermiteDevelopable.Section_3_2_printed.eq_3_6_system.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.sec_3_2_advantage.proved : HermiteDevelopable.Section_3_2_printed.sec_3_2_advantage.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.sec_3_2_advantage.met : HermiteDevelopable.Section_3_2_printed.sec_3_2_advantage.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_q.proved : HermiteDevelopable.Section_3_2_printed.ex_3_2_q.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_q.met : HermiteDevelopable.Section_3_2_printed.ex_3_2_q.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_p1.proved : HermiteDevelopable.Section_3_2_printed.ex_3_2_p1.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_p1.met : HermiteDevelopable.Section_3_2_printed.ex_3_2_p1.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_p0u.proved : HermiteDevelopable.Section_3_2_printed.ex_3_2_p0u.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_p0u.met : HermiteDevelopable.Section_3_2_printed.ex_3_2_p0u.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_p1u.proved : HermiteDevelopable.Section_3_2_printed.ex_3_2_p1u.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_p1u.met : HermiteDevelopable.Section_3_2_printed.ex_3_2_p1u.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_o.proved : HermiteDevelopable.Section_3_2_printed.ex_3_2_o.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_o.met : HermiteDevelopable.Section_3_2_printed.ex_3_2_o.instance).
Check (HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_parallel.proved : HermiteDevelopable.Section_3_2_printed.ex_3_2_parallel.statement).
Check (HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_parallel.met : HermiteDevelopable.Section_3_2_printed.ex_3_2_parallel.instance).
Check (HermiteDevelopable.Section_3_2_proofs.sec_3_2_curves.proved : HermiteDevelopable.Section_3_2.sec_3_2_curves.statement).
Check (HermiteDevelopable.Section_3_2_proofs.sec_3_2_curves.met : HermiteDevelopable.Section_3_2.sec_3_2_curves.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r1.proved : HermiteDevelopable.Section_3_2.eq_3_6_A_r1.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r1.met : HermiteDevelopable.Section_3_2.eq_3_6_A_r1.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r2.proved : HermiteDevelopable.Section_3_2.eq_3_6_A_r2.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r2.met : HermiteDevelopable.Section_3_2.eq_3_6_A_r2.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r3.proved : HermiteDevelopable.Section_3_2.eq_3_6_A_r3.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r3.met : HermiteDevelopable.Section_3_2.eq_3_6_A_r3.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r4.proved : HermiteDevelopable.Section_3_2.eq_3_6_A_r4.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r4.met : HermiteDevelopable.Section_3_2.eq_3_6_A_r4.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r5.proved : HermiteDevelopable.Section_3_2.eq_3_6_A_r5.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r5.met : HermiteDevelopable.Section_3_2.eq_3_6_A_r5.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_B.refuted : ~ HermiteDevelopable.Section_3_2.eq_3_6_B.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_B_corrected.proved : HermiteDevelopable.Section_3_2.eq_3_6_B_corrected.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_B_corrected.met : HermiteDevelopable.Section_3_2.eq_3_6_B_corrected.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r1.proved : HermiteDevelopable.Section_3_2.eq_3_6_C_r1.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r1.met : HermiteDevelopable.Section_3_2.eq_3_6_C_r1.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r2.refuted : ~ HermiteDevelopable.Section_3_2.eq_3_6_C_r2.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r2_corrected.proved : HermiteDevelopable.Section_3_2.eq_3_6_C_r2_corrected.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r2_corrected.met : HermiteDevelopable.Section_3_2.eq_3_6_C_r2_corrected.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r3.proved : HermiteDevelopable.Section_3_2.eq_3_6_C_r3.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r3.met : HermiteDevelopable.Section_3_2.eq_3_6_C_r3.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r4.proved : HermiteDevelopable.Section_3_2.eq_3_6_C_r4.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r4.met : HermiteDevelopable.Section_3_2.eq_3_6_C_r4.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r5.refuted : ~ HermiteDevelopable.Section_3_2.eq_3_6_C_r5.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r5_corrected.proved : HermiteDevelopable.Section_3_2.eq_3_6_C_r5_corrected.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r5_corrected.met : HermiteDevelopable.Section_3_2.eq_3_6_C_r5_corrected.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_det.refuted : ~ HermiteDevelopable.Section_3_2.eq_3_6_det.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_corrected.proved : HermiteDevelopable.Section_3_2.eq_3_6_det_corrected.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_true.proved : HermiteDevelopable.Section_3_2.eq_3_6_det_true.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_true.met : HermiteDevelopable.Section_3_2.eq_3_6_det_true.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_slip.proved : HermiteDevelopable.Section_3_2.eq_3_6_det_slip.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_factored.proved : HermiteDevelopable.Section_3_2.eq_3_6_det_factored.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_k.proved : HermiteDevelopable.Section_3_2.eq_3_6_k.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_k.met : HermiteDevelopable.Section_3_2.eq_3_6_k.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_every.proved : HermiteDevelopable.Section_3_2.eq_3_6_k_every.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_every.met : HermiteDevelopable.Section_3_2.eq_3_6_k_every.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_135_136.proved : HermiteDevelopable.Section_3_2.eq_3_6_k_135_136.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_135_136.met : HermiteDevelopable.Section_3_2.eq_3_6_k_135_136.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_q.proved : HermiteDevelopable.Section_3_2.eq_3_6_sol_q.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_q.met : HermiteDevelopable.Section_3_2.eq_3_6_sol_q.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1.proved : HermiteDevelopable.Section_3_2.eq_3_6_sol_p1.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1.met : HermiteDevelopable.Section_3_2.eq_3_6_sol_p1.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p0u.proved : HermiteDevelopable.Section_3_2.eq_3_6_sol_p0u.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p0u.met : HermiteDevelopable.Section_3_2.eq_3_6_sol_p0u.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1u.proved : HermiteDevelopable.Section_3_2.eq_3_6_sol_p1u.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1u.met : HermiteDevelopable.Section_3_2.eq_3_6_sol_p1u.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_o.proved : HermiteDevelopable.Section_3_2.eq_3_6_sol_o.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_o.met : HermiteDevelopable.Section_3_2.eq_3_6_sol_o.instance).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_system.proved : HermiteDevelopable.Section_3_2.eq_3_6_system.statement).
Check (HermiteDevelopable.Section_3_2_proofs.eq_3_6_system.met : HermiteDevelopable.Section_3_2.eq_3_6_system.instance).
Check (HermiteDevelopable.Section_3_2_proofs.sec_3_2_advantage.proved : HermiteDevelopable.Section_3_2.sec_3_2_advantage.statement).
Check (HermiteDevelopable.Section_3_2_proofs.sec_3_2_advantage.met : HermiteDevelopable.Section_3_2.sec_3_2_advantage.instance).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_q.proved : HermiteDevelopable.Section_3_2.ex_3_2_q.statement).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_q.met : HermiteDevelopable.Section_3_2.ex_3_2_q.instance).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1.proved : HermiteDevelopable.Section_3_2.ex_3_2_p1.statement).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1.met : HermiteDevelopable.Section_3_2.ex_3_2_p1.instance).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_p0u.proved : HermiteDevelopable.Section_3_2.ex_3_2_p0u.statement).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_p0u.met : HermiteDevelopable.Section_3_2.ex_3_2_p0u.instance).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1u.proved : HermiteDevelopable.Section_3_2.ex_3_2_p1u.statement).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1u.met : HermiteDevelopable.Section_3_2.ex_3_2_p1u.instance).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_o.proved : HermiteDevelopable.Section_3_2.ex_3_2_o.statement).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_o.met : HermiteDevelopable.Section_3_2.ex_3_2_o.instance).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_parallel.proved : HermiteDevelopable.Section_3_2.ex_3_2_parallel.statement).
Check (HermiteDevelopable.Section_3_2_proofs.ex_3_2_parallel.met : HermiteDevelopable.Section_3_2.ex_3_2_parallel.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.sec_3_3_curves.proved : HermiteDevelopable.Section_3_3_printed.sec_3_3_curves.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.sec_3_3_curves.met : HermiteDevelopable.Section_3_3_printed.sec_3_3_curves.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r1.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_A_r1.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r1.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_A_r1.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r2.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_A_r2.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r2.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_A_r2.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r3.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_A_r3.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r3.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_A_r3.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r4.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_A_r4.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r4.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_A_r4.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r5.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_A_r5.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r5.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_A_r5.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r6.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_A_r6.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r6.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_A_r6.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_B.refuted : ~ HermiteDevelopable.Section_3_3_printed.eq_3_7_B.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_B_corrected.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_B_corrected.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_B_corrected.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_B_corrected.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r1.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_C_r1.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r1.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_C_r1.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r2.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_C_r2.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r2.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_C_r2.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r3.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_C_r3.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r3.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_C_r3.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r4.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_C_r4.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r4.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_C_r4.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r5.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_C_r5.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r5.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_C_r5.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r6.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_C_r6.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r6.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_C_r6.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_det.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_det.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_k.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_k.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_k.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_k.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_k_needed.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_k_needed.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_k_needed.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_k_needed.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_p0u.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_sol_p0u.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_p0u.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_sol_p0u.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_qu.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_sol_qu.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_qu.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_sol_qu.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_p1u.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_sol_p1u.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_p1u.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_sol_p1u.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_q.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_sol_q.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_q.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_sol_q.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_p1.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_sol_p1.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_p1.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_sol_p1.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_o.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_sol_o.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_o.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_sol_o.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_system.proved : HermiteDevelopable.Section_3_3_printed.eq_3_7_system.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_system.met : HermiteDevelopable.Section_3_3_printed.eq_3_7_system.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.sec_3_3_advantage.proved : HermiteDevelopable.Section_3_3_printed.sec_3_3_advantage.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.sec_3_3_advantage.met : HermiteDevelopable.Section_3_3_printed.sec_3_3_advantage.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_equation.refuted : ~ HermiteDevelopable.Section_3_3_printed.ex_3_3_equation.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_equation_true.proved : HermiteDevelopable.Section_3_3_printed.ex_3_3_equation_true.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_equation_true.met : HermiteDevelopable.Section_3_3_printed.ex_3_3_equation_true.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_p0u.proved : HermiteDevelopable.Section_3_3_printed.ex_3_3_p0u.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_p0u.met : HermiteDevelopable.Section_3_3_printed.ex_3_3_p0u.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_qu.proved : HermiteDevelopable.Section_3_3_printed.ex_3_3_qu.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_qu.met : HermiteDevelopable.Section_3_3_printed.ex_3_3_qu.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_p1u.proved : HermiteDevelopable.Section_3_3_printed.ex_3_3_p1u.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_p1u.met : HermiteDevelopable.Section_3_3_printed.ex_3_3_p1u.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_q.proved : HermiteDevelopable.Section_3_3_printed.ex_3_3_q.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_q.met : HermiteDevelopable.Section_3_3_printed.ex_3_3_q.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_p1.proved : HermiteDevelopable.Section_3_3_printed.ex_3_3_p1.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_p1.met : HermiteDevelopable.Section_3_3_printed.ex_3_3_p1.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_o.proved : HermiteDevelopable.Section_3_3_printed.ex_3_3_o.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_o.met : HermiteDevelopable.Section_3_3_printed.ex_3_3_o.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_parallel.proved : HermiteDevelopable.Section_3_3_printed.ex_3_3_parallel.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_parallel.met : HermiteDevelopable.Section_3_3_printed.ex_3_3_parallel.instance).
Check (HermiteDevelopable.Section_3_3_printed_proofs.fig_4d_constant.proved : HermiteDevelopable.Section_3_3_printed.fig_4d_constant.statement).
Check (HermiteDevelopable.Section_3_3_printed_proofs.fig_4d_constant.met : HermiteDevelopable.Section_3_3_printed.fig_4d_constant.instance).
Check (HermiteDevelopable.Section_3_3_proofs.sec_3_3_curves.proved : HermiteDevelopable.Section_3_3.sec_3_3_curves.statement).
Check (HermiteDevelopable.Section_3_3_proofs.sec_3_3_curves.met : HermiteDevelopable.Section_3_3.sec_3_3_curves.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r1.proved : HermiteDevelopable.Section_3_3.eq_3_7_A_r1.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r1.met : HermiteDevelopable.Section_3_3.eq_3_7_A_r1.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r2.proved : HermiteDevelopable.Section_3_3.eq_3_7_A_r2.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r2.met : HermiteDevelopable.Section_3_3.eq_3_7_A_r2.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r3.proved : HermiteDevelopable.Section_3_3.eq_3_7_A_r3.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r3.met : HermiteDevelopable.Section_3_3.eq_3_7_A_r3.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r4.proved : HermiteDevelopable.Section_3_3.eq_3_7_A_r4.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r4.met : HermiteDevelopable.Section_3_3.eq_3_7_A_r4.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r5.proved : HermiteDevelopable.Section_3_3.eq_3_7_A_r5.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r5.met : HermiteDevelopable.Section_3_3.eq_3_7_A_r5.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r6.proved : HermiteDevelopable.Section_3_3.eq_3_7_A_r6.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r6.met : HermiteDevelopable.Section_3_3.eq_3_7_A_r6.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_B.refuted : ~ HermiteDevelopable.Section_3_3.eq_3_7_B.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_B_corrected.proved : HermiteDevelopable.Section_3_3.eq_3_7_B_corrected.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_B_corrected.met : HermiteDevelopable.Section_3_3.eq_3_7_B_corrected.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r1.proved : HermiteDevelopable.Section_3_3.eq_3_7_C_r1.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r1.met : HermiteDevelopable.Section_3_3.eq_3_7_C_r1.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r2.proved : HermiteDevelopable.Section_3_3.eq_3_7_C_r2.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r2.met : HermiteDevelopable.Section_3_3.eq_3_7_C_r2.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r3.proved : HermiteDevelopable.Section_3_3.eq_3_7_C_r3.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r3.met : HermiteDevelopable.Section_3_3.eq_3_7_C_r3.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r4.proved : HermiteDevelopable.Section_3_3.eq_3_7_C_r4.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r4.met : HermiteDevelopable.Section_3_3.eq_3_7_C_r4.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r5.proved : HermiteDevelopable.Section_3_3.eq_3_7_C_r5.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r5.met : HermiteDevelopable.Section_3_3.eq_3_7_C_r5.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r6.proved : HermiteDevelopable.Section_3_3.eq_3_7_C_r6.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r6.met : HermiteDevelopable.Section_3_3.eq_3_7_C_r6.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_det.proved : HermiteDevelopable.Section_3_3.eq_3_7_det.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_k.proved : HermiteDevelopable.Section_3_3.eq_3_7_k.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_k.met : HermiteDevelopable.Section_3_3.eq_3_7_k.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_k_needed.proved : HermiteDevelopable.Section_3_3.eq_3_7_k_needed.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_k_needed.met : HermiteDevelopable.Section_3_3.eq_3_7_k_needed.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p0u.proved : HermiteDevelopable.Section_3_3.eq_3_7_sol_p0u.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p0u.met : HermiteDevelopable.Section_3_3.eq_3_7_sol_p0u.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_qu.proved : HermiteDevelopable.Section_3_3.eq_3_7_sol_qu.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_qu.met : HermiteDevelopable.Section_3_3.eq_3_7_sol_qu.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1u.proved : HermiteDevelopable.Section_3_3.eq_3_7_sol_p1u.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1u.met : HermiteDevelopable.Section_3_3.eq_3_7_sol_p1u.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_q.proved : HermiteDevelopable.Section_3_3.eq_3_7_sol_q.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_q.met : HermiteDevelopable.Section_3_3.eq_3_7_sol_q.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1.proved : HermiteDevelopable.Section_3_3.eq_3_7_sol_p1.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1.met : HermiteDevelopable.Section_3_3.eq_3_7_sol_p1.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_o.proved : HermiteDevelopable.Section_3_3.eq_3_7_sol_o.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_o.met : HermiteDevelopable.Section_3_3.eq_3_7_sol_o.instance).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_system.proved : HermiteDevelopable.Section_3_3.eq_3_7_system.statement).
Check (HermiteDevelopable.Section_3_3_proofs.eq_3_7_system.met : HermiteDevelopable.Section_3_3.eq_3_7_system.instance).
Check (HermiteDevelopable.Section_3_3_proofs.sec_3_3_advantage.proved : HermiteDevelopable.Section_3_3.sec_3_3_advantage.statement).
Check (HermiteDevelopable.Section_3_3_proofs.sec_3_3_advantage.met : HermiteDevelopable.Section_3_3.sec_3_3_advantage.instance).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_equation.refuted : ~ HermiteDevelopable.Section_3_3.ex_3_3_equation.statement).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_equation_true.proved : HermiteDevelopable.Section_3_3.ex_3_3_equation_true.statement).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_equation_true.met : HermiteDevelopable.Section_3_3.ex_3_3_equation_true.instance).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_p0u.proved : HermiteDevelopable.Section_3_3.ex_3_3_p0u.statement).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_p0u.met : HermiteDevelopable.Section_3_3.ex_3_3_p0u.instance).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_qu.proved : HermiteDevelopable.Section_3_3.ex_3_3_qu.statement).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_qu.met : HermiteDevelopable.Section_3_3.ex_3_3_qu.instance).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1u.proved : HermiteDevelopable.Section_3_3.ex_3_3_p1u.statement).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1u.met : HermiteDevelopable.Section_3_3.ex_3_3_p1u.instance).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_q.proved : HermiteDevelopable.Section_3_3.ex_3_3_q.statement).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_q.met : HermiteDevelopable.Section_3_3.ex_3_3_q.instance).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1.proved : HermiteDevelopable.Section_3_3.ex_3_3_p1.statement).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1.met : HermiteDevelopable.Section_3_3.ex_3_3_p1.instance).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_o.proved : HermiteDevelopable.Section_3_3.ex_3_3_o.statement).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_o.met : HermiteDevelopable.Section_3_3.ex_3_3_o.instance).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_parallel.proved : HermiteDevelopable.Section_3_3.ex_3_3_parallel.statement).
Check (HermiteDevelopable.Section_3_3_proofs.ex_3_3_parallel.met : HermiteDevelopable.Section_3_3.ex_3_3_parallel.instance).
Check (HermiteDevelopable.Section_3_3_proofs.fig_4d_constant.proved : HermiteDevelopable.Section_3_3.fig_4d_constant.statement).
Check (HermiteDevelopable.Section_3_3_proofs.fig_4d_constant.met : HermiteDevelopable.Section_3_3.fig_4d_constant.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.def_3_1.proved : HermiteDevelopable.Section_3_printed.def_3_1.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.def_3_1.met : HermiteDevelopable.Section_3_printed.def_3_1.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.def_3_1_normal.proved : HermiteDevelopable.Section_3_printed.def_3_1_normal.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.def_3_1_normal.met : HermiteDevelopable.Section_3_printed.def_3_1_normal.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.def_3_2.proved : HermiteDevelopable.Section_3_printed.def_3_2.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.def_3_2_lincomb.proved : HermiteDevelopable.Section_3_printed.def_3_2_lincomb.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.sec_3_g_boundary.proved : HermiteDevelopable.Section_3_printed.sec_3_g_boundary.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.sec_3_g_boundary.met : HermiteDevelopable.Section_3_printed.sec_3_g_boundary.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.sec_3_g_prime.refuted : ~ HermiteDevelopable.Section_3_printed.sec_3_g_prime.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.sec_3_g_prime_corrected.proved : HermiteDevelopable.Section_3_printed.sec_3_g_prime_corrected.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.sec_3_g_prime_corrected.met : HermiteDevelopable.Section_3_printed.sec_3_g_prime_corrected.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_1.proved : HermiteDevelopable.Section_3_printed.eq_3_1.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_1.met : HermiteDevelopable.Section_3_printed.eq_3_1.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_1_must.proved : HermiteDevelopable.Section_3_printed.eq_3_1_must.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_1_must.met : HermiteDevelopable.Section_3_printed.eq_3_1_must.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_1_types_a.proved : HermiteDevelopable.Section_3_printed.eq_3_1_types_a.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_1_types_a.met : HermiteDevelopable.Section_3_printed.eq_3_1_types_a.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_1_types_b.proved : HermiteDevelopable.Section_3_printed.eq_3_1_types_b.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_1_parallel_planes.proved : HermiteDevelopable.Section_3_printed.eq_3_1_parallel_planes.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_1_parallel_planes.met : HermiteDevelopable.Section_3_printed.eq_3_1_parallel_planes.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_1_rho_constant.proved : HermiteDevelopable.Section_3_printed.eq_3_1_rho_constant.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_1_rho_constant.met : HermiteDevelopable.Section_3_printed.eq_3_1_rho_constant.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_1_rho_quadratic.proved : HermiteDevelopable.Section_3_printed.eq_3_1_rho_quadratic.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_1_rho_quadratic.met : HermiteDevelopable.Section_3_printed.eq_3_1_rho_quadratic.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_1_difficulties_same.proved : HermiteDevelopable.Section_3_printed.eq_3_1_difficulties_same.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_1_difficulties_same.met : HermiteDevelopable.Section_3_printed.eq_3_1_difficulties_same.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2.proved : HermiteDevelopable.Section_3_printed.eq_3_2.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2.met : HermiteDevelopable.Section_3_printed.eq_3_2.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2_edge.proved : HermiteDevelopable.Section_3_printed.eq_3_2_edge.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2_edge.met : HermiteDevelopable.Section_3_printed.eq_3_2_edge.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2_planes_a_generatrix.refuted : ~ HermiteDevelopable.Section_3_printed.eq_3_2_planes_a_generatrix.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2_planes_a_direction.proved : HermiteDevelopable.Section_3_printed.eq_3_2_planes_a_direction.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2_planes_a_direction.met : HermiteDevelopable.Section_3_printed.eq_3_2_planes_a_direction.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2_planes_b_generatrix.refuted : ~ HermiteDevelopable.Section_3_printed.eq_3_2_planes_b_generatrix.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2_planes_b_direction.refuted : ~ HermiteDevelopable.Section_3_printed.eq_3_2_planes_b_direction.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2_planes_parallel.proved : HermiteDevelopable.Section_3_printed.eq_3_2_planes_parallel.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2_planes_parallel.met : HermiteDevelopable.Section_3_printed.eq_3_2_planes_parallel.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2_with_h.proved : HermiteDevelopable.Section_3_printed.eq_3_2_with_h.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2_with_h.met : HermiteDevelopable.Section_3_printed.eq_3_2_with_h.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2_across.proved : HermiteDevelopable.Section_3_printed.eq_3_2_across.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2_across.met : HermiteDevelopable.Section_3_printed.eq_3_2_across.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2_across_summit.proved : HermiteDevelopable.Section_3_printed.eq_3_2_across_summit.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2_across_summit.met : HermiteDevelopable.Section_3_printed.eq_3_2_across_summit.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2_every_degree.proved : HermiteDevelopable.Section_3_printed.eq_3_2_every_degree.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_2_every_degree.met : HermiteDevelopable.Section_3_printed.eq_3_2_every_degree.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_g_generatrix.refuted : ~ HermiteDevelopable.Section_3_printed.eq_3_3_g_generatrix.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_g_direction.proved : HermiteDevelopable.Section_3_printed.eq_3_3_g_direction.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_g_true.proved : HermiteDevelopable.Section_3_printed.eq_3_3_g_true.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3a.proved : HermiteDevelopable.Section_3_printed.eq_3_3a.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3a.met : HermiteDevelopable.Section_3_printed.eq_3_3a.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3b.proved : HermiteDevelopable.Section_3_printed.eq_3_3b.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3b.met : HermiteDevelopable.Section_3_printed.eq_3_3b.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_same_as_3_2_generatrix.refuted : ~ HermiteDevelopable.Section_3_printed.eq_3_3_same_as_3_2_generatrix.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_same_as_3_2_direction.proved : HermiteDevelopable.Section_3_printed.eq_3_3_same_as_3_2_direction.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_same_as_3_2_direction.met : HermiteDevelopable.Section_3_printed.eq_3_3_same_as_3_2_direction.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_same_as_3_2_true.proved : HermiteDevelopable.Section_3_printed.eq_3_3_same_as_3_2_true.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_same_as_3_2_true.met : HermiteDevelopable.Section_3_printed.eq_3_3_same_as_3_2_true.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_developable_Hermite.proved : HermiteDevelopable.Section_3_printed.eq_3_3_developable_Hermite.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_developable_Hermite.met : HermiteDevelopable.Section_3_printed.eq_3_3_developable_Hermite.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_developable_any.refuted : ~ HermiteDevelopable.Section_3_printed.eq_3_3_developable_any.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_exact.proved : HermiteDevelopable.Section_3_printed.eq_3_3_exact.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_exact.met : HermiteDevelopable.Section_3_printed.eq_3_3_exact.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_multiples_cone.proved : HermiteDevelopable.Section_3_printed.eq_3_3_multiples_cone.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_multiples_cone.met : HermiteDevelopable.Section_3_printed.eq_3_3_multiples_cone.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_multiples_Hermite.proved : HermiteDevelopable.Section_3_printed.eq_3_3_multiples_Hermite.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_multiples_Hermite.met : HermiteDevelopable.Section_3_printed.eq_3_3_multiples_Hermite.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_multiples_any.refuted : ~ HermiteDevelopable.Section_3_printed.eq_3_3_multiples_any.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_k_below_1.proved : HermiteDevelopable.Section_3_printed.eq_3_3_k_below_1.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_k_below_1.met : HermiteDevelopable.Section_3_printed.eq_3_3_k_below_1.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_k_equal_1.proved : HermiteDevelopable.Section_3_printed.eq_3_3_k_equal_1.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_k_equal_1.met : HermiteDevelopable.Section_3_printed.eq_3_3_k_equal_1.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_k_above_1.proved : HermiteDevelopable.Section_3_printed.eq_3_3_k_above_1.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_3_k_above_1.met : HermiteDevelopable.Section_3_printed.eq_3_3_k_above_1.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.sec_3_summit_outside.proved : HermiteDevelopable.Section_3_printed.sec_3_summit_outside.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.sec_3_summit_outside.met : HermiteDevelopable.Section_3_printed.sec_3_summit_outside.instance).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_4.proved : HermiteDevelopable.Section_3_printed.eq_3_4.statement).
Check (HermiteDevelopable.Section_3_printed_proofs.eq_3_4.met : HermiteDevelopable.Section_3_printed.eq_3_4.instance).
Check (HermiteDevelopable.Section_3_proofs.def_3_1.proved : HermiteDevelopable.Section_3.def_3_1.statement).
Check (HermiteDevelopable.Section_3_proofs.def_3_1.met : HermiteDevelopable.Section_3.def_3_1.instance).
Check (HermiteDevelopable.Section_3_proofs.def_3_1_normal.proved : HermiteDevelopable.Section_3.def_3_1_normal.statement).
Check (HermiteDevelopable.Section_3_proofs.def_3_1_normal.met : HermiteDevelopable.Section_3.def_3_1_normal.instance).
Check (HermiteDevelopable.Section_3_proofs.def_3_2.proved : HermiteDevelopable.Section_3.def_3_2.statement).
Check (HermiteDevelopable.Section_3_proofs.def_3_2_lincomb.proved : HermiteDevelopable.Section_3.def_3_2_lincomb.statement).
Check (HermiteDevelopable.Section_3_proofs.sec_3_g_boundary.proved : HermiteDevelopable.Section_3.sec_3_g_boundary.statement).
Check (HermiteDevelopable.Section_3_proofs.sec_3_g_boundary.met : HermiteDevelopable.Section_3.sec_3_g_boundary.instance).
Check (HermiteDevelopable.Section_3_proofs.sec_3_g_prime.refuted : ~ HermiteDevelopable.Section_3.sec_3_g_prime.statement).
Check (HermiteDevelopable.Section_3_proofs.sec_3_g_prime_corrected.proved : HermiteDevelopable.Section_3.sec_3_g_prime_corrected.statement).
Check (HermiteDevelopable.Section_3_proofs.sec_3_g_prime_corrected.met : HermiteDevelopable.Section_3.sec_3_g_prime_corrected.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1.proved : HermiteDevelopable.Section_3.eq_3_1.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1.met : HermiteDevelopable.Section_3.eq_3_1.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_must.proved : HermiteDevelopable.Section_3.eq_3_1_must.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_must.met : HermiteDevelopable.Section_3.eq_3_1_must.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_types_a.proved : HermiteDevelopable.Section_3.eq_3_1_types_a.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_types_a.met : HermiteDevelopable.Section_3.eq_3_1_types_a.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_types_b.proved : HermiteDevelopable.Section_3.eq_3_1_types_b.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_parallel_planes.proved : HermiteDevelopable.Section_3.eq_3_1_parallel_planes.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_parallel_planes.met : HermiteDevelopable.Section_3.eq_3_1_parallel_planes.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_rho_constant.proved : HermiteDevelopable.Section_3.eq_3_1_rho_constant.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_rho_constant.met : HermiteDevelopable.Section_3.eq_3_1_rho_constant.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_rho_quadratic.proved : HermiteDevelopable.Section_3.eq_3_1_rho_quadratic.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_rho_quadratic.met : HermiteDevelopable.Section_3.eq_3_1_rho_quadratic.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_difficulties_same.proved : HermiteDevelopable.Section_3.eq_3_1_difficulties_same.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_1_difficulties_same.met : HermiteDevelopable.Section_3.eq_3_1_difficulties_same.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2.proved : HermiteDevelopable.Section_3.eq_3_2.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2.met : HermiteDevelopable.Section_3.eq_3_2.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_edge.proved : HermiteDevelopable.Section_3.eq_3_2_edge.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_edge.met : HermiteDevelopable.Section_3.eq_3_2_edge.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_planes_a_generatrix.refuted : ~ HermiteDevelopable.Section_3.eq_3_2_planes_a_generatrix.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_planes_a_direction.proved : HermiteDevelopable.Section_3.eq_3_2_planes_a_direction.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_planes_a_direction.met : HermiteDevelopable.Section_3.eq_3_2_planes_a_direction.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_planes_b_generatrix.refuted : ~ HermiteDevelopable.Section_3.eq_3_2_planes_b_generatrix.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_planes_b_direction.refuted : ~ HermiteDevelopable.Section_3.eq_3_2_planes_b_direction.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_planes_parallel.proved : HermiteDevelopable.Section_3.eq_3_2_planes_parallel.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_planes_parallel.met : HermiteDevelopable.Section_3.eq_3_2_planes_parallel.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_with_h.proved : HermiteDevelopable.Section_3.eq_3_2_with_h.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_with_h.met : HermiteDevelopable.Section_3.eq_3_2_with_h.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_across.proved : HermiteDevelopable.Section_3.eq_3_2_across.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_across.met : HermiteDevelopable.Section_3.eq_3_2_across.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_across_summit.proved : HermiteDevelopable.Section_3.eq_3_2_across_summit.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_across_summit.met : HermiteDevelopable.Section_3.eq_3_2_across_summit.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_every_degree.proved : HermiteDevelopable.Section_3.eq_3_2_every_degree.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_2_every_degree.met : HermiteDevelopable.Section_3.eq_3_2_every_degree.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_g_generatrix.refuted : ~ HermiteDevelopable.Section_3.eq_3_3_g_generatrix.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_g_direction.proved : HermiteDevelopable.Section_3.eq_3_3_g_direction.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_g_true.proved : HermiteDevelopable.Section_3.eq_3_3_g_true.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3a.proved : HermiteDevelopable.Section_3.eq_3_3a.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3a.met : HermiteDevelopable.Section_3.eq_3_3a.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3b.proved : HermiteDevelopable.Section_3.eq_3_3b.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3b.met : HermiteDevelopable.Section_3.eq_3_3b.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_generatrix.refuted : ~ HermiteDevelopable.Section_3.eq_3_3_same_as_3_2_generatrix.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_direction.proved : HermiteDevelopable.Section_3.eq_3_3_same_as_3_2_direction.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_direction.met : HermiteDevelopable.Section_3.eq_3_3_same_as_3_2_direction.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_true.proved : HermiteDevelopable.Section_3.eq_3_3_same_as_3_2_true.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_true.met : HermiteDevelopable.Section_3.eq_3_3_same_as_3_2_true.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_developable_Hermite.proved : HermiteDevelopable.Section_3.eq_3_3_developable_Hermite.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_developable_Hermite.met : HermiteDevelopable.Section_3.eq_3_3_developable_Hermite.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_developable_any.refuted : ~ HermiteDevelopable.Section_3.eq_3_3_developable_any.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_exact.proved : HermiteDevelopable.Section_3.eq_3_3_exact.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_exact.met : HermiteDevelopable.Section_3.eq_3_3_exact.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_cone.proved : HermiteDevelopable.Section_3.eq_3_3_multiples_cone.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_cone.met : HermiteDevelopable.Section_3.eq_3_3_multiples_cone.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_Hermite.proved : HermiteDevelopable.Section_3.eq_3_3_multiples_Hermite.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_Hermite.met : HermiteDevelopable.Section_3.eq_3_3_multiples_Hermite.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_any.refuted : ~ HermiteDevelopable.Section_3.eq_3_3_multiples_any.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_k_below_1.proved : HermiteDevelopable.Section_3.eq_3_3_k_below_1.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_k_below_1.met : HermiteDevelopable.Section_3.eq_3_3_k_below_1.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_k_equal_1.proved : HermiteDevelopable.Section_3.eq_3_3_k_equal_1.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_k_equal_1.met : HermiteDevelopable.Section_3.eq_3_3_k_equal_1.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_k_above_1.proved : HermiteDevelopable.Section_3.eq_3_3_k_above_1.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_3_k_above_1.met : HermiteDevelopable.Section_3.eq_3_3_k_above_1.instance).
Check (HermiteDevelopable.Section_3_proofs.sec_3_summit_outside.proved : HermiteDevelopable.Section_3.sec_3_summit_outside.statement).
Check (HermiteDevelopable.Section_3_proofs.sec_3_summit_outside.met : HermiteDevelopable.Section_3.sec_3_summit_outside.instance).
Check (HermiteDevelopable.Section_3_proofs.eq_3_4.proved : HermiteDevelopable.Section_3.eq_3_4.statement).
Check (HermiteDevelopable.Section_3_proofs.eq_3_4.met : HermiteDevelopable.Section_3.eq_3_4.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_cone.proved : HermiteDevelopable.Section_4_printed.sec_4_cone.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_cone.met : HermiteDevelopable.Section_4_printed.sec_4_cone.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_1.proved : HermiteDevelopable.Section_4_printed.eq_4_1.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_1.met : HermiteDevelopable.Section_4_printed.eq_4_1.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_designed.refuted : ~ HermiteDevelopable.Section_4_printed.sec_4_goal_designed.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_image.proved : HermiteDevelopable.Section_4_printed.sec_4_goal_image.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_image.met : HermiteDevelopable.Section_4_printed.sec_4_goal_image.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_leaves.proved : HermiteDevelopable.Section_4_printed.sec_4_goal_leaves.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_leaves.met : HermiteDevelopable.Section_4_printed.sec_4_goal_leaves.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_nodes.proved : HermiteDevelopable.Section_4_printed.sec_4_goal_nodes.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_nodes.met : HermiteDevelopable.Section_4_printed.sec_4_goal_nodes.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_only.proved : HermiteDevelopable.Section_4_printed.sec_4_goal_only.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_only.met : HermiteDevelopable.Section_4_printed.sec_4_goal_only.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_parallel.proved : HermiteDevelopable.Section_4_printed.sec_4_goal_parallel.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_parallel.met : HermiteDevelopable.Section_4_printed.sec_4_goal_parallel.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_in_plane.proved : HermiteDevelopable.Section_4_printed.sec_4_in_plane.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_in_plane.met : HermiteDevelopable.Section_4_printed.sec_4_in_plane.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_r0.proved : HermiteDevelopable.Section_4_printed.sec_4_r0.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_r0.met : HermiteDevelopable.Section_4_printed.sec_4_r0.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_I1.proved : HermiteDevelopable.Section_4_printed.sec_4_I1.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_I1.met : HermiteDevelopable.Section_4_printed.sec_4_I1.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_w.proved : HermiteDevelopable.Section_4_printed.sec_4_w.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_w.met : HermiteDevelopable.Section_4_printed.sec_4_w.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_2.proved : HermiteDevelopable.Section_4_printed.eq_4_2.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_2.met : HermiteDevelopable.Section_4_printed.eq_4_2.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_2_tangent_derivative.refuted : ~ HermiteDevelopable.Section_4_printed.eq_4_2_tangent_derivative.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_2_tangent_end_point.proved : HermiteDevelopable.Section_4_printed.eq_4_2_tangent_end_point.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_2_tangent_end_point.met : HermiteDevelopable.Section_4_printed.eq_4_2_tangent_end_point.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_2_tangent_parallel.proved : HermiteDevelopable.Section_4_printed.eq_4_2_tangent_parallel.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_2_tangent_parallel.met : HermiteDevelopable.Section_4_printed.eq_4_2_tangent_parallel.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_2_tangent_true.proved : HermiteDevelopable.Section_4_printed.eq_4_2_tangent_true.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_2_tangent_true.met : HermiteDevelopable.Section_4_printed.eq_4_2_tangent_true.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_s.proved : HermiteDevelopable.Section_4_printed.sec_4_s.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_s.met : HermiteDevelopable.Section_4_printed.sec_4_s.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_3.proved : HermiteDevelopable.Section_4_printed.eq_4_3.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_3.met : HermiteDevelopable.Section_4_printed.eq_4_3.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_4_ru.proved : HermiteDevelopable.Section_4_printed.eq_4_4_ru.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_4_ru.met : HermiteDevelopable.Section_4_printed.eq_4_4_ru.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_4_r1.proved : HermiteDevelopable.Section_4_printed.eq_4_4_r1.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_4_r1.met : HermiteDevelopable.Section_4_printed.eq_4_4_r1.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_4_r1u.proved : HermiteDevelopable.Section_4_printed.eq_4_4_r1u.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_4_r1u.met : HermiteDevelopable.Section_4_printed.eq_4_4_r1u.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_4_tangent_derivative.refuted : ~ HermiteDevelopable.Section_4_printed.eq_4_4_tangent_derivative.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_4_tangent_end_point.proved : HermiteDevelopable.Section_4_printed.eq_4_4_tangent_end_point.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_4_tangent_end_point.met : HermiteDevelopable.Section_4_printed.eq_4_4_tangent_end_point.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_4_tangent_parallel.proved : HermiteDevelopable.Section_4_printed.eq_4_4_tangent_parallel.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.eq_4_4_tangent_parallel.met : HermiteDevelopable.Section_4_printed.eq_4_4_tangent_parallel.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.sec_4_oblique.proved : HermiteDevelopable.Section_4_printed.sec_4_oblique.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_data.proved : HermiteDevelopable.Section_4_printed.ex_4_data.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_data.met : HermiteDevelopable.Section_4_printed.ex_4_data.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_r0.proved : HermiteDevelopable.Section_4_printed.ex_4_r0.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_r0.met : HermiteDevelopable.Section_4_printed.ex_4_r0.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_r0u.refuted : ~ HermiteDevelopable.Section_4_printed.ex_4_r0u.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_r.proved : HermiteDevelopable.Section_4_printed.ex_4_r.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_r.met : HermiteDevelopable.Section_4_printed.ex_4_r.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_ru.refuted : ~ HermiteDevelopable.Section_4_printed.ex_4_ru.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_r1.proved : HermiteDevelopable.Section_4_printed.ex_4_r1.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_r1.met : HermiteDevelopable.Section_4_printed.ex_4_r1.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_r1_rounding.proved : HermiteDevelopable.Section_4_printed.ex_4_r1_rounding.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_r1_rounding.met : HermiteDevelopable.Section_4_printed.ex_4_r1_rounding.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_r1u.refuted : ~ HermiteDevelopable.Section_4_printed.ex_4_r1u.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_other_data.proved : HermiteDevelopable.Section_4_printed.ex_4_other_data.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_other_data.met : HermiteDevelopable.Section_4_printed.ex_4_other_data.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_other_data_twist.proved : HermiteDevelopable.Section_4_printed.ex_4_other_data_twist.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_other_data_twist.met : HermiteDevelopable.Section_4_printed.ex_4_other_data_twist.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_stated_data.proved : HermiteDevelopable.Section_4_printed.ex_4_stated_data.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_stated_data.met : HermiteDevelopable.Section_4_printed.ex_4_stated_data.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_true_tangents.proved : HermiteDevelopable.Section_4_printed.ex_4_true_tangents.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_true_tangents.met : HermiteDevelopable.Section_4_printed.ex_4_true_tangents.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_a_developable_computed.refuted : ~ HermiteDevelopable.Section_4_printed.ex_4_a_developable_computed.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_a_developable_printed.refuted : ~ HermiteDevelopable.Section_4_printed.ex_4_a_developable_printed.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_a_twist.proved : HermiteDevelopable.Section_4_printed.ex_4_a_twist.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_a_twist.met : HermiteDevelopable.Section_4_printed.ex_4_a_twist.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_a_twist_most.proved : HermiteDevelopable.Section_4_printed.ex_4_a_twist_most.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_a_twist_most.met : HermiteDevelopable.Section_4_printed.ex_4_a_twist_most.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_a_twist_printed.proved : HermiteDevelopable.Section_4_printed.ex_4_a_twist_printed.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_a_twist_printed.met : HermiteDevelopable.Section_4_printed.ex_4_a_twist_printed.instance).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_b_developable.refuted : ~ HermiteDevelopable.Section_4_printed.ex_4_b_developable.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_b_twist.proved : HermiteDevelopable.Section_4_printed.ex_4_b_twist.statement).
Check (HermiteDevelopable.Section_4_printed_proofs.ex_4_b_twist.met : HermiteDevelopable.Section_4_printed.ex_4_b_twist.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_cone.proved : HermiteDevelopable.Section_4.sec_4_cone.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_cone.met : HermiteDevelopable.Section_4.sec_4_cone.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_1.proved : HermiteDevelopable.Section_4.eq_4_1.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_1.met : HermiteDevelopable.Section_4.eq_4_1.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_designed.refuted : ~ HermiteDevelopable.Section_4.sec_4_goal_designed.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_image.proved : HermiteDevelopable.Section_4.sec_4_goal_image.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_image.met : HermiteDevelopable.Section_4.sec_4_goal_image.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_leaves.proved : HermiteDevelopable.Section_4.sec_4_goal_leaves.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_leaves.met : HermiteDevelopable.Section_4.sec_4_goal_leaves.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_nodes.proved : HermiteDevelopable.Section_4.sec_4_goal_nodes.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_nodes.met : HermiteDevelopable.Section_4.sec_4_goal_nodes.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_only.proved : HermiteDevelopable.Section_4.sec_4_goal_only.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_only.met : HermiteDevelopable.Section_4.sec_4_goal_only.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_parallel.proved : HermiteDevelopable.Section_4.sec_4_goal_parallel.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_goal_parallel.met : HermiteDevelopable.Section_4.sec_4_goal_parallel.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_in_plane.proved : HermiteDevelopable.Section_4.sec_4_in_plane.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_in_plane.met : HermiteDevelopable.Section_4.sec_4_in_plane.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_r0.proved : HermiteDevelopable.Section_4.sec_4_r0.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_r0.met : HermiteDevelopable.Section_4.sec_4_r0.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_I1.proved : HermiteDevelopable.Section_4.sec_4_I1.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_I1.met : HermiteDevelopable.Section_4.sec_4_I1.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_w.proved : HermiteDevelopable.Section_4.sec_4_w.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_w.met : HermiteDevelopable.Section_4.sec_4_w.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_2.proved : HermiteDevelopable.Section_4.eq_4_2.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_2.met : HermiteDevelopable.Section_4.eq_4_2.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_derivative.refuted : ~ HermiteDevelopable.Section_4.eq_4_2_tangent_derivative.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_end_point.proved : HermiteDevelopable.Section_4.eq_4_2_tangent_end_point.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_end_point.met : HermiteDevelopable.Section_4.eq_4_2_tangent_end_point.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_parallel.proved : HermiteDevelopable.Section_4.eq_4_2_tangent_parallel.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_parallel.met : HermiteDevelopable.Section_4.eq_4_2_tangent_parallel.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_true.proved : HermiteDevelopable.Section_4.eq_4_2_tangent_true.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_true.met : HermiteDevelopable.Section_4.eq_4_2_tangent_true.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_s.proved : HermiteDevelopable.Section_4.sec_4_s.statement).
Check (HermiteDevelopable.Section_4_proofs.sec_4_s.met : HermiteDevelopable.Section_4.sec_4_s.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_3.proved : HermiteDevelopable.Section_4.eq_4_3.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_3.met : HermiteDevelopable.Section_4.eq_4_3.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_ru.proved : HermiteDevelopable.Section_4.eq_4_4_ru.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_ru.met : HermiteDevelopable.Section_4.eq_4_4_ru.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_r1.proved : HermiteDevelopable.Section_4.eq_4_4_r1.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_r1.met : HermiteDevelopable.Section_4.eq_4_4_r1.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_r1u.proved : HermiteDevelopable.Section_4.eq_4_4_r1u.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_r1u.met : HermiteDevelopable.Section_4.eq_4_4_r1u.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_derivative.refuted : ~ HermiteDevelopable.Section_4.eq_4_4_tangent_derivative.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_end_point.proved : HermiteDevelopable.Section_4.eq_4_4_tangent_end_point.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_end_point.met : HermiteDevelopable.Section_4.eq_4_4_tangent_end_point.instance).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_parallel.proved : HermiteDevelopable.Section_4.eq_4_4_tangent_parallel.statement).
Check (HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_parallel.met : HermiteDevelopable.Section_4.eq_4_4_tangent_parallel.instance).
Check (HermiteDevelopable.Section_4_proofs.sec_4_oblique.proved : HermiteDevelopable.Section_4.sec_4_oblique.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_data.proved : HermiteDevelopable.Section_4.ex_4_data.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_data.met : HermiteDevelopable.Section_4.ex_4_data.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r0.proved : HermiteDevelopable.Section_4.ex_4_r0.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r0.met : HermiteDevelopable.Section_4.ex_4_r0.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r0u.refuted : ~ HermiteDevelopable.Section_4.ex_4_r0u.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r.proved : HermiteDevelopable.Section_4.ex_4_r.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r.met : HermiteDevelopable.Section_4.ex_4_r.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_ru.refuted : ~ HermiteDevelopable.Section_4.ex_4_ru.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r1.proved : HermiteDevelopable.Section_4.ex_4_r1.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r1.met : HermiteDevelopable.Section_4.ex_4_r1.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r1_rounding.proved : HermiteDevelopable.Section_4.ex_4_r1_rounding.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r1_rounding.met : HermiteDevelopable.Section_4.ex_4_r1_rounding.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_r1u.refuted : ~ HermiteDevelopable.Section_4.ex_4_r1u.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_other_data.proved : HermiteDevelopable.Section_4.ex_4_other_data.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_other_data.met : HermiteDevelopable.Section_4.ex_4_other_data.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_other_data_twist.proved : HermiteDevelopable.Section_4.ex_4_other_data_twist.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_other_data_twist.met : HermiteDevelopable.Section_4.ex_4_other_data_twist.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_stated_data.proved : HermiteDevelopable.Section_4.ex_4_stated_data.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_stated_data.met : HermiteDevelopable.Section_4.ex_4_stated_data.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_true_tangents.proved : HermiteDevelopable.Section_4.ex_4_true_tangents.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_true_tangents.met : HermiteDevelopable.Section_4.ex_4_true_tangents.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_a_developable_computed.refuted : ~ HermiteDevelopable.Section_4.ex_4_a_developable_computed.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_a_developable_printed.refuted : ~ HermiteDevelopable.Section_4.ex_4_a_developable_printed.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_a_twist.proved : HermiteDevelopable.Section_4.ex_4_a_twist.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_a_twist.met : HermiteDevelopable.Section_4.ex_4_a_twist.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_a_twist_most.proved : HermiteDevelopable.Section_4.ex_4_a_twist_most.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_a_twist_most.met : HermiteDevelopable.Section_4.ex_4_a_twist_most.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_a_twist_printed.proved : HermiteDevelopable.Section_4.ex_4_a_twist_printed.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_a_twist_printed.met : HermiteDevelopable.Section_4.ex_4_a_twist_printed.instance).
Check (HermiteDevelopable.Section_4_proofs.ex_4_b_developable.refuted : ~ HermiteDevelopable.Section_4.ex_4_b_developable.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_b_twist.proved : HermiteDevelopable.Section_4.ex_4_b_twist.statement).
Check (HermiteDevelopable.Section_4_proofs.ex_4_b_twist.met : HermiteDevelopable.Section_4.ex_4_b_twist.instance).
Check (HermiteDevelopable.Section_5_printed_proofs.sec_5_criteria_a.proved : HermiteDevelopable.Section_5_printed.sec_5_criteria_a.statement).
Check (HermiteDevelopable.Section_5_printed_proofs.sec_5_criteria_a.met : HermiteDevelopable.Section_5_printed.sec_5_criteria_a.instance).
Check (HermiteDevelopable.Section_5_printed_proofs.sec_5_criteria_reach.proved : HermiteDevelopable.Section_5_printed.sec_5_criteria_reach.statement).
Check (HermiteDevelopable.Section_5_printed_proofs.sec_5_criteria_reach.met : HermiteDevelopable.Section_5_printed.sec_5_criteria_reach.instance).
Check (HermiteDevelopable.Section_5_printed_proofs.sec_5_planes_a.proved : HermiteDevelopable.Section_5_printed.sec_5_planes_a.statement).
Check (HermiteDevelopable.Section_5_printed_proofs.sec_5_planes_a.met : HermiteDevelopable.Section_5_printed.sec_5_planes_a.instance).
Check (HermiteDevelopable.Section_5_printed_proofs.sec_5_planes_parallel.proved : HermiteDevelopable.Section_5_printed.sec_5_planes_parallel.statement).
Check (HermiteDevelopable.Section_5_printed_proofs.sec_5_planes_parallel.met : HermiteDevelopable.Section_5_printed.sec_5_planes_parallel.instance).
Check (HermiteDevelopable.Section_5_printed_proofs.sec_5_planes_b.refuted : ~ HermiteDevelopable.Section_5_printed.sec_5_planes_b.statement).
Check (HermiteDevelopable.Section_5_proofs.sec_5_criteria_a.proved : HermiteDevelopable.Section_5.sec_5_criteria_a.statement).
Check (HermiteDevelopable.Section_5_proofs.sec_5_criteria_a.met : HermiteDevelopable.Section_5.sec_5_criteria_a.instance).
Check (HermiteDevelopable.Section_5_proofs.sec_5_criteria_reach.proved : HermiteDevelopable.Section_5.sec_5_criteria_reach.statement).
Check (HermiteDevelopable.Section_5_proofs.sec_5_criteria_reach.met : HermiteDevelopable.Section_5.sec_5_criteria_reach.instance).
Check (HermiteDevelopable.Section_5_proofs.sec_5_planes_a.proved : HermiteDevelopable.Section_5.sec_5_planes_a.statement).
Check (HermiteDevelopable.Section_5_proofs.sec_5_planes_a.met : HermiteDevelopable.Section_5.sec_5_planes_a.instance).
Check (HermiteDevelopable.Section_5_proofs.sec_5_planes_parallel.proved : HermiteDevelopable.Section_5.sec_5_planes_parallel.statement).
Check (HermiteDevelopable.Section_5_proofs.sec_5_planes_parallel.met : HermiteDevelopable.Section_5.sec_5_planes_parallel.instance).
Check (HermiteDevelopable.Section_5_proofs.sec_5_planes_b.refuted : ~ HermiteDevelopable.Section_5.sec_5_planes_b.statement).
Definition all_theorems : True :=
let _ := HermiteDevelopable.Part_Abstract_printed_proofs.abs_construct_a.proved in
let _ := HermiteDevelopable.Part_Abstract_printed_proofs.abs_construct_a.met in
let _ := HermiteDevelopable.Part_Abstract_printed_proofs.abs_construct_b.proved in
let _ := HermiteDevelopable.Part_Abstract_printed_proofs.abs_construct_b.met in
let _ := HermiteDevelopable.Part_Abstract_printed_proofs.abs_construct_c.proved in
let _ := HermiteDevelopable.Part_Abstract_printed_proofs.abs_construct_c.met in
let _ := HermiteDevelopable.Part_Abstract_printed_proofs.abs_construct_d.refuted in
let _ := HermiteDevelopable.Part_Abstract_proofs.abs_construct_a.proved in
let _ := HermiteDevelopable.Part_Abstract_proofs.abs_construct_a.met in
let _ := HermiteDevelopable.Part_Abstract_proofs.abs_construct_b.proved in
let _ := HermiteDevelopable.Part_Abstract_proofs.abs_construct_b.met in
let _ := HermiteDevelopable.Part_Abstract_proofs.abs_construct_c.proved in
let _ := HermiteDevelopable.Part_Abstract_proofs.abs_construct_c.met in
let _ := HermiteDevelopable.Part_Abstract_proofs.abs_construct_d.refuted in
let _ := HermiteDevelopable.Section_1_printed_proofs.sec_1_parallel_tangents.proved in
let _ := HermiteDevelopable.Section_1_printed_proofs.sec_1_parallel_tangents.met in
let _ := HermiteDevelopable.Section_1_proofs.sec_1_parallel_tangents.proved in
let _ := HermiteDevelopable.Section_1_proofs.sec_1_parallel_tangents.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_conditions.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_conditions.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_equations.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_a1.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_a1.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_b1.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_b1.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_c1.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_c1.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_d1.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_cubic_d1.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_1a.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_1a.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_1b.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_1b.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_1b_H1.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_1b_H1.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_1b_H2.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_1b_H2.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_1b_H3.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_1b_H3.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_1b_H4.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_1b_H4.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_conditions.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_conditions.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_solvable.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_a1.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_a1.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_b1.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_b1.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_third.refuted in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_third_corrected.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_third_corrected.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_d1.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_d1.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_e1.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quartic_e1.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_2.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_2.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_3.refuted in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_3_corrected.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_3_corrected.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H1.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H1.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H2.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H2.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H3.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H3.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H4.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H4.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H5.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_3_H5.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_conditions.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_conditions.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_a1.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_a1.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_b1.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_b1.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_c1.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_c1.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_d1.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_d1.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_e1.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_e1.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_f1.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_quintic_f1.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_4.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.eq_2_4.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_control.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.sec_2_control.met in
let _ := HermiteDevelopable.Section_2_printed_proofs.fig_1b_middle.proved in
let _ := HermiteDevelopable.Section_2_printed_proofs.fig_1b_middle.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_conditions.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_conditions.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_equations.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_a1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_a1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_b1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_b1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_c1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_c1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_d1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_cubic_d1.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1a.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1a.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b_H1.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b_H1.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b_H2.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b_H2.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b_H3.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b_H3.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b_H4.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_1b_H4.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_conditions.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_conditions.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_solvable.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_a1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_a1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_b1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_b1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_third.refuted in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_third_corrected.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_third_corrected.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_d1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_d1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_e1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quartic_e1.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_2.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_2.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3.refuted in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_corrected.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_corrected.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H1.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H1.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H2.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H2.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H3.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H3.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H4.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H4.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H5.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_3_H5.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_conditions.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_conditions.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_a1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_a1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_b1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_b1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_c1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_c1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_d1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_d1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_e1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_e1.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_f1.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_quintic_f1.met in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_4.proved in
let _ := HermiteDevelopable.Section_2_proofs.eq_2_4.met in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_control.proved in
let _ := HermiteDevelopable.Section_2_proofs.sec_2_control.met in
let _ := HermiteDevelopable.Section_2_proofs.fig_1b_middle.proved in
let _ := HermiteDevelopable.Section_2_proofs.fig_1b_middle.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_polynomials.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_polynomials.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_substituted.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_substituted.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_coefficients.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_coefficients.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_hermite_1.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_hermite_1.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_hermite_2.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_hermite_2.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_hermite_3.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_hermite_3.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_hermite_4.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_hermite_4.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_A_r1.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_A_r1.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_A_r2.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_A_r2.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_A_r3.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_A_r3.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_A_r4.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_A_r4.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_B.refuted in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_B_corrected.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_B_corrected.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_C_r1.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_C_r1.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_C_r2.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_C_r2.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_C_r3.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_C_r3.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_C_r4.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_C_r4.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_sizes.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_unique.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_unique.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_det.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_k.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_k.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_sol_p1.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_sol_p1.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_sol_p0u.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_sol_p0u.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_sol_p1u.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_sol_p1u.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_sol_p0.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.eq_3_5_sol_p0.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_conclusion.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_conclusion.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.alg_3_1_step1.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.alg_3_1_step1.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.alg_3_1_step2.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.alg_3_1_step2.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.alg_3_1_step3.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.alg_3_1_step3.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_tension.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.sec_3_1_tension.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_arrange.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_arrange.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_tension_effect.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_tension_effect.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_p1.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_p1.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_p0u.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_p0u.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_p1u.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_p1u.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_p0.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_p0.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_parallel.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_parallel.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_width.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_width.met in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_shapes.proved in
let _ := HermiteDevelopable.Section_3_1_printed_proofs.ex_3_1_shapes.met in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_polynomials.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_polynomials.met in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_substituted.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_substituted.met in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_coefficients.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_coefficients.met in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_1.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_1.met in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_2.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_2.met in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_3.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_3.met in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_4.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_hermite_4.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r1.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r1.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r2.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r2.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r3.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r3.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r4.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_A_r4.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_B.refuted in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_B_corrected.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_B_corrected.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r1.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r1.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r2.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r2.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r3.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r3.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r4.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_C_r4.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_sizes.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_unique.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_unique.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_det.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_k.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_k.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0u.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0u.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1u.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p1u.met in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.eq_3_5_sol_p0.met in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_conclusion.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_conclusion.met in
let _ := HermiteDevelopable.Section_3_1_proofs.alg_3_1_step1.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.alg_3_1_step1.met in
let _ := HermiteDevelopable.Section_3_1_proofs.alg_3_1_step2.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.alg_3_1_step2.met in
let _ := HermiteDevelopable.Section_3_1_proofs.alg_3_1_step3.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.alg_3_1_step3.met in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_tension.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.sec_3_1_tension.met in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_arrange.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_arrange.met in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_tension_effect.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_tension_effect.met in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1.met in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0u.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0u.met in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1u.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_p1u.met in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_p0.met in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_parallel.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_parallel.met in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_width.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_width.met in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_shapes.proved in
let _ := HermiteDevelopable.Section_3_1_proofs.ex_3_1_shapes.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.sec_3_2_curves.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.sec_3_2_curves.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r1.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r1.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r2.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r2.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r3.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r3.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r4.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r4.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r5.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_A_r5.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_B.refuted in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_B_corrected.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_B_corrected.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r1.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r1.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r2.refuted in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r2_corrected.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r2_corrected.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r3.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r3.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r4.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r4.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r5.refuted in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r5_corrected.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_C_r5_corrected.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_det.refuted in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_det_corrected.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_det_true.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_det_true.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_det_slip.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_det_factored.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_k.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_k.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_k_every.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_k_every.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_k_135_136.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_k_135_136.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_q.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_q.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_p1.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_p1.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_p0u.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_p0u.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_p1u.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_p1u.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_o.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_sol_o.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_system.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.eq_3_6_system.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.sec_3_2_advantage.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.sec_3_2_advantage.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_q.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_q.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_p1.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_p1.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_p0u.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_p0u.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_p1u.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_p1u.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_o.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_o.met in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_parallel.proved in
let _ := HermiteDevelopable.Section_3_2_printed_proofs.ex_3_2_parallel.met in
let _ := HermiteDevelopable.Section_3_2_proofs.sec_3_2_curves.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.sec_3_2_curves.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r1.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r1.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r2.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r2.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r3.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r3.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r4.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r4.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r5.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_A_r5.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_B.refuted in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_B_corrected.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_B_corrected.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r1.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r1.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r2.refuted in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r2_corrected.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r2_corrected.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r3.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r3.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r4.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r4.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r5.refuted in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r5_corrected.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_C_r5_corrected.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_det.refuted in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_corrected.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_true.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_true.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_slip.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_det_factored.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_k.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_k.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_every.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_every.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_135_136.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_k_135_136.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_q.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_q.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p0u.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p0u.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1u.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_p1u.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_o.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_sol_o.met in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_system.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.eq_3_6_system.met in
let _ := HermiteDevelopable.Section_3_2_proofs.sec_3_2_advantage.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.sec_3_2_advantage.met in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_q.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_q.met in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1.met in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_p0u.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_p0u.met in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1u.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_p1u.met in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_o.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_o.met in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_parallel.proved in
let _ := HermiteDevelopable.Section_3_2_proofs.ex_3_2_parallel.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.sec_3_3_curves.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.sec_3_3_curves.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r1.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r1.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r2.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r2.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r3.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r3.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r4.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r4.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r5.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r5.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r6.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_A_r6.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_B.refuted in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_B_corrected.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_B_corrected.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r1.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r1.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r2.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r2.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r3.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r3.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r4.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r4.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r5.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r5.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r6.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_C_r6.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_det.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_k.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_k.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_k_needed.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_k_needed.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_p0u.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_p0u.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_qu.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_qu.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_p1u.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_p1u.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_q.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_q.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_p1.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_p1.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_o.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_sol_o.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_system.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.eq_3_7_system.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.sec_3_3_advantage.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.sec_3_3_advantage.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_equation.refuted in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_equation_true.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_equation_true.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_p0u.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_p0u.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_qu.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_qu.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_p1u.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_p1u.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_q.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_q.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_p1.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_p1.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_o.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_o.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_parallel.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.ex_3_3_parallel.met in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.fig_4d_constant.proved in
let _ := HermiteDevelopable.Section_3_3_printed_proofs.fig_4d_constant.met in
let _ := HermiteDevelopable.Section_3_3_proofs.sec_3_3_curves.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.sec_3_3_curves.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r1.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r1.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r2.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r2.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r3.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r3.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r4.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r4.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r5.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r5.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r6.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_A_r6.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_B.refuted in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_B_corrected.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_B_corrected.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r1.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r1.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r2.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r2.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r3.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r3.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r4.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r4.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r5.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r5.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r6.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_C_r6.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_det.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_k.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_k.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_k_needed.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_k_needed.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p0u.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p0u.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_qu.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_qu.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1u.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1u.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_q.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_q.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_p1.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_o.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_sol_o.met in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_system.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.eq_3_7_system.met in
let _ := HermiteDevelopable.Section_3_3_proofs.sec_3_3_advantage.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.sec_3_3_advantage.met in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_equation.refuted in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_equation_true.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_equation_true.met in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_p0u.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_p0u.met in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_qu.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_qu.met in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1u.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1u.met in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_q.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_q.met in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_p1.met in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_o.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_o.met in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_parallel.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.ex_3_3_parallel.met in
let _ := HermiteDevelopable.Section_3_3_proofs.fig_4d_constant.proved in
let _ := HermiteDevelopable.Section_3_3_proofs.fig_4d_constant.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.def_3_1.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.def_3_1.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.def_3_1_normal.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.def_3_1_normal.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.def_3_2.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.def_3_2_lincomb.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.sec_3_g_boundary.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.sec_3_g_boundary.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.sec_3_g_prime.refuted in
let _ := HermiteDevelopable.Section_3_printed_proofs.sec_3_g_prime_corrected.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.sec_3_g_prime_corrected.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_1.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_1.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_1_must.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_1_must.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_1_types_a.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_1_types_a.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_1_types_b.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_1_parallel_planes.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_1_parallel_planes.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_1_rho_constant.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_1_rho_constant.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_1_rho_quadratic.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_1_rho_quadratic.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_1_difficulties_same.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_1_difficulties_same.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2_edge.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2_edge.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2_planes_a_generatrix.refuted in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2_planes_a_direction.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2_planes_a_direction.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2_planes_b_generatrix.refuted in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2_planes_b_direction.refuted in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2_planes_parallel.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2_planes_parallel.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2_with_h.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2_with_h.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2_across.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2_across.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2_across_summit.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2_across_summit.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2_every_degree.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_2_every_degree.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_g_generatrix.refuted in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_g_direction.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_g_true.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3a.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3a.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3b.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3b.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_same_as_3_2_generatrix.refuted in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_same_as_3_2_direction.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_same_as_3_2_direction.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_same_as_3_2_true.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_same_as_3_2_true.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_developable_Hermite.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_developable_Hermite.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_developable_any.refuted in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_exact.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_exact.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_multiples_cone.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_multiples_cone.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_multiples_Hermite.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_multiples_Hermite.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_multiples_any.refuted in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_k_below_1.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_k_below_1.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_k_equal_1.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_k_equal_1.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_k_above_1.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_3_k_above_1.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.sec_3_summit_outside.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.sec_3_summit_outside.met in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_4.proved in
let _ := HermiteDevelopable.Section_3_printed_proofs.eq_3_4.met in
let _ := HermiteDevelopable.Section_3_proofs.def_3_1.proved in
let _ := HermiteDevelopable.Section_3_proofs.def_3_1.met in
let _ := HermiteDevelopable.Section_3_proofs.def_3_1_normal.proved in
let _ := HermiteDevelopable.Section_3_proofs.def_3_1_normal.met in
let _ := HermiteDevelopable.Section_3_proofs.def_3_2.proved in
let _ := HermiteDevelopable.Section_3_proofs.def_3_2_lincomb.proved in
let _ := HermiteDevelopable.Section_3_proofs.sec_3_g_boundary.proved in
let _ := HermiteDevelopable.Section_3_proofs.sec_3_g_boundary.met in
let _ := HermiteDevelopable.Section_3_proofs.sec_3_g_prime.refuted in
let _ := HermiteDevelopable.Section_3_proofs.sec_3_g_prime_corrected.proved in
let _ := HermiteDevelopable.Section_3_proofs.sec_3_g_prime_corrected.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_must.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_must.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_types_a.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_types_a.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_types_b.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_parallel_planes.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_parallel_planes.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_rho_constant.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_rho_constant.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_rho_quadratic.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_rho_quadratic.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_difficulties_same.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_1_difficulties_same.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_edge.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_edge.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_planes_a_generatrix.refuted in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_planes_a_direction.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_planes_a_direction.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_planes_b_generatrix.refuted in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_planes_b_direction.refuted in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_planes_parallel.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_planes_parallel.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_with_h.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_with_h.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_across.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_across.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_across_summit.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_across_summit.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_every_degree.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_2_every_degree.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_g_generatrix.refuted in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_g_direction.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_g_true.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3a.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3a.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3b.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3b.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_generatrix.refuted in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_direction.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_direction.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_true.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_same_as_3_2_true.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_developable_Hermite.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_developable_Hermite.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_developable_any.refuted in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_exact.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_exact.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_cone.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_cone.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_Hermite.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_Hermite.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_multiples_any.refuted in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_k_below_1.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_k_below_1.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_k_equal_1.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_k_equal_1.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_k_above_1.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_3_k_above_1.met in
let _ := HermiteDevelopable.Section_3_proofs.sec_3_summit_outside.proved in
let _ := HermiteDevelopable.Section_3_proofs.sec_3_summit_outside.met in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_4.proved in
let _ := HermiteDevelopable.Section_3_proofs.eq_3_4.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_cone.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_cone.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_1.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_1.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_designed.refuted in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_image.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_image.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_leaves.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_leaves.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_nodes.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_nodes.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_only.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_only.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_parallel.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_goal_parallel.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_in_plane.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_in_plane.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_r0.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_r0.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_I1.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_I1.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_w.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_w.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_2.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_2.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_2_tangent_derivative.refuted in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_2_tangent_end_point.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_2_tangent_end_point.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_2_tangent_parallel.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_2_tangent_parallel.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_2_tangent_true.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_2_tangent_true.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_s.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_s.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_3.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_3.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_4_ru.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_4_ru.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_4_r1.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_4_r1.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_4_r1u.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_4_r1u.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_4_tangent_derivative.refuted in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_4_tangent_end_point.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_4_tangent_end_point.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_4_tangent_parallel.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.eq_4_4_tangent_parallel.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.sec_4_oblique.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_data.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_data.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_r0.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_r0.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_r0u.refuted in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_r.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_r.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_ru.refuted in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_r1.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_r1.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_r1_rounding.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_r1_rounding.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_r1u.refuted in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_other_data.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_other_data.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_other_data_twist.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_other_data_twist.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_stated_data.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_stated_data.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_true_tangents.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_true_tangents.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_a_developable_computed.refuted in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_a_developable_printed.refuted in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_a_twist.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_a_twist.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_a_twist_most.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_a_twist_most.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_a_twist_printed.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_a_twist_printed.met in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_b_developable.refuted in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_b_twist.proved in
let _ := HermiteDevelopable.Section_4_printed_proofs.ex_4_b_twist.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_cone.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_cone.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_1.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_1.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_designed.refuted in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_image.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_image.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_leaves.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_leaves.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_nodes.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_nodes.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_only.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_only.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_parallel.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_goal_parallel.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_in_plane.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_in_plane.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_r0.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_r0.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_I1.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_I1.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_w.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_w.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_2.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_2.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_derivative.refuted in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_end_point.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_end_point.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_parallel.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_parallel.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_true.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_2_tangent_true.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_s.proved in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_s.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_3.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_3.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_ru.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_ru.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_r1.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_r1.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_r1u.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_r1u.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_derivative.refuted in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_end_point.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_end_point.met in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_parallel.proved in
let _ := HermiteDevelopable.Section_4_proofs.eq_4_4_tangent_parallel.met in
let _ := HermiteDevelopable.Section_4_proofs.sec_4_oblique.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_data.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_data.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r0.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r0.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r0u.refuted in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_ru.refuted in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r1.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r1.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r1_rounding.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r1_rounding.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_r1u.refuted in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_other_data.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_other_data.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_other_data_twist.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_other_data_twist.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_stated_data.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_stated_data.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_true_tangents.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_true_tangents.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_a_developable_computed.refuted in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_a_developable_printed.refuted in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_a_twist.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_a_twist.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_a_twist_most.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_a_twist_most.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_a_twist_printed.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_a_twist_printed.met in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_b_developable.refuted in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_b_twist.proved in
let _ := HermiteDevelopable.Section_4_proofs.ex_4_b_twist.met in
let _ := HermiteDevelopable.Section_5_printed_proofs.sec_5_criteria_a.proved in
let _ := HermiteDevelopable.Section_5_printed_proofs.sec_5_criteria_a.met in
let _ := HermiteDevelopable.Section_5_printed_proofs.sec_5_criteria_reach.proved in
let _ := HermiteDevelopable.Section_5_printed_proofs.sec_5_criteria_reach.met in
let _ := HermiteDevelopable.Section_5_printed_proofs.sec_5_planes_a.proved in
let _ := HermiteDevelopable.Section_5_printed_proofs.sec_5_planes_a.met in
let _ := HermiteDevelopable.Section_5_printed_proofs.sec_5_planes_parallel.proved in
let _ := HermiteDevelopable.Section_5_printed_proofs.sec_5_planes_parallel.met in
let _ := HermiteDevelopable.Section_5_printed_proofs.sec_5_planes_b.refuted in
let _ := HermiteDevelopable.Section_5_proofs.sec_5_criteria_a.proved in
let _ := HermiteDevelopable.Section_5_proofs.sec_5_criteria_a.met in
let _ := HermiteDevelopable.Section_5_proofs.sec_5_criteria_reach.proved in
let _ := HermiteDevelopable.Section_5_proofs.sec_5_criteria_reach.met in
let _ := HermiteDevelopable.Section_5_proofs.sec_5_planes_a.proved in
let _ := HermiteDevelopable.Section_5_proofs.sec_5_planes_a.met in
let _ := HermiteDevelopable.Section_5_proofs.sec_5_planes_parallel.proved in
let _ := HermiteDevelopable.Section_5_proofs.sec_5_planes_parallel.met in
let _ := HermiteDevelopable.Section_5_proofs.sec_5_planes_b.refuted in
I.
