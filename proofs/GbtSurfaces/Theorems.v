(* The kernel's word: each theorem has the type of its statement. *)
From GbtSurfaces Require Part_Abstract_printed Part_Abstract_printed_proofs.
From GbtSurfaces Require Part_Abstract Part_Abstract_proofs.
From GbtSurfaces Require Part_Table_printed Part_Table_printed_proofs.
From GbtSurfaces Require Part_Table Part_Table_proofs.
From GbtSurfaces Require Section_1_printed Section_1_printed_proofs.
From GbtSurfaces Require Section_1 Section_1_proofs.
From GbtSurfaces Require Section_2_1_printed Section_2_1_printed_proofs.
From GbtSurfaces Require Section_2_1 Section_2_1_proofs.
From GbtSurfaces Require Section_2_2_printed Section_2_2_printed_proofs.
From GbtSurfaces Require Section_2_2 Section_2_2_proofs.
From GbtSurfaces Require Section_2_3_printed Section_2_3_printed_proofs.
From GbtSurfaces Require Section_2_3 Section_2_3_proofs.
From GbtSurfaces Require Section_3_1_printed Section_3_1_printed_proofs.
From GbtSurfaces Require Section_3_1 Section_3_1_proofs.
From GbtSurfaces Require Section_3_2_printed Section_3_2_printed_proofs.
From GbtSurfaces Require Section_3_2 Section_3_2_proofs.
From GbtSurfaces Require Section_3_3_printed Section_3_3_printed_proofs.
From GbtSurfaces Require Section_3_3 Section_3_3_proofs.
From GbtSurfaces Require Section_3_4_printed Section_3_4_printed_proofs.
From GbtSurfaces Require Section_3_4 Section_3_4_proofs.
From GbtSurfaces Require Section_3_5_printed Section_3_5_printed_proofs.
From GbtSurfaces Require Section_3_5 Section_3_5_proofs.
From GbtSurfaces Require Section_3_6_printed Section_3_6_printed_proofs.
From GbtSurfaces Require Section_3_6 Section_3_6_proofs.
From GbtSurfaces Require Section_4_printed Section_4_printed_proofs.
From GbtSurfaces Require Section_4 Section_4_proofs.
Check (GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_a.proved : GbtSurfaces.Part_Abstract_printed.abs_basis_a.statement).
Check (GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_a.met : GbtSurfaces.Part_Abstract_printed.abs_basis_a.instance).
Check (GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_b_name.proved : GbtSurfaces.Part_Abstract_printed.abs_basis_b_name.statement).
Check (GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_b_name.met : GbtSurfaces.Part_Abstract_printed.abs_basis_b_name.instance).
Check (GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_b_basis.refuted : ~ GbtSurfaces.Part_Abstract_printed.abs_basis_b_basis.statement).
Check (GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_order_2.proved : GbtSurfaces.Part_Abstract_printed.abs_basis_order_2.statement).
Check (GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_order_2.met : GbtSurfaces.Part_Abstract_printed.abs_basis_order_2.instance).
Check (GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_cubic.proved : GbtSurfaces.Part_Abstract_printed.abs_basis_cubic.statement).
Check (GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_cubic.met : GbtSurfaces.Part_Abstract_printed.abs_basis_cubic.instance).
Check (GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_all.proved : GbtSurfaces.Part_Abstract_printed.abs_basis_all.statement).
Check (GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_all.met : GbtSurfaces.Part_Abstract_printed.abs_basis_all.instance).
Check (GbtSurfaces.Part_Abstract_printed_proofs.abs_continuity_a.proved : GbtSurfaces.Part_Abstract_printed.abs_continuity_a.statement).
Check (GbtSurfaces.Part_Abstract_printed_proofs.abs_continuity_a.met : GbtSurfaces.Part_Abstract_printed.abs_continuity_a.instance).
Check (GbtSurfaces.Part_Abstract_printed_proofs.abs_continuity_rows.proved : GbtSurfaces.Part_Abstract_printed.abs_continuity_rows.statement).
Check (GbtSurfaces.Part_Abstract_printed_proofs.abs_continuity_rows.met : GbtSurfaces.Part_Abstract_printed.abs_continuity_rows.instance).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_a.proved : GbtSurfaces.Part_Abstract.abs_basis_a.statement).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_a.met : GbtSurfaces.Part_Abstract.abs_basis_a.instance).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_b_name.proved : GbtSurfaces.Part_Abstract.abs_basis_b_name.statement).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_b_name.met : GbtSurfaces.Part_Abstract.abs_basis_b_name.instance).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_b_basis.refuted : ~ GbtSurfaces.Part_Abstract.abs_basis_b_basis.statement).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_order_2.proved : GbtSurfaces.Part_Abstract.abs_basis_order_2.statement).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_order_2.met : GbtSurfaces.Part_Abstract.abs_basis_order_2.instance).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_cubic.proved : GbtSurfaces.Part_Abstract.abs_basis_cubic.statement).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_cubic.met : GbtSurfaces.Part_Abstract.abs_basis_cubic.instance).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_all.proved : GbtSurfaces.Part_Abstract.abs_basis_all.statement).
Check (GbtSurfaces.Part_Abstract_proofs.abs_basis_all.met : GbtSurfaces.Part_Abstract.abs_basis_all.instance).
Check (GbtSurfaces.Part_Abstract_proofs.abs_continuity_a.proved : GbtSurfaces.Part_Abstract.abs_continuity_a.statement).
Check (GbtSurfaces.Part_Abstract_proofs.abs_continuity_a.met : GbtSurfaces.Part_Abstract.abs_continuity_a.instance).
Check (GbtSurfaces.Part_Abstract_proofs.abs_continuity_rows.proved : GbtSurfaces.Part_Abstract.abs_continuity_rows.statement).
Check (GbtSurfaces.Part_Abstract_proofs.abs_continuity_rows.met : GbtSurfaces.Part_Abstract.abs_continuity_rows.instance).
Check (GbtSurfaces.Part_Table_printed_proofs.tab_1_1_proposed.proved : GbtSurfaces.Part_Table_printed.tab_1_1_proposed.statement).
Check (GbtSurfaces.Part_Table_printed_proofs.tab_1_1_proposed.met : GbtSurfaces.Part_Table_printed.tab_1_1_proposed.instance).
Check (GbtSurfaces.Part_Table_printed_proofs.tab_1_2_proposed.proved : GbtSurfaces.Part_Table_printed.tab_1_2_proposed.statement).
Check (GbtSurfaces.Part_Table_printed_proofs.tab_1_2_proposed.met : GbtSurfaces.Part_Table_printed.tab_1_2_proposed.instance).
Check (GbtSurfaces.Part_Table_printed_proofs.tab_1_3_proposed.proved : GbtSurfaces.Part_Table_printed.tab_1_3_proposed.statement).
Check (GbtSurfaces.Part_Table_printed_proofs.tab_1_3_proposed.met : GbtSurfaces.Part_Table_printed.tab_1_3_proposed.instance).
Check (GbtSurfaces.Part_Table_printed_proofs.tab_1_4_proposed.proved : GbtSurfaces.Part_Table_printed.tab_1_4_proposed.statement).
Check (GbtSurfaces.Part_Table_printed_proofs.tab_1_4_proposed.met : GbtSurfaces.Part_Table_printed.tab_1_4_proposed.instance).
Check (GbtSurfaces.Part_Table_printed_proofs.tab_1_5_proposed.proved : GbtSurfaces.Part_Table_printed.tab_1_5_proposed.statement).
Check (GbtSurfaces.Part_Table_printed_proofs.tab_1_5_proposed.met : GbtSurfaces.Part_Table_printed.tab_1_5_proposed.instance).
Check (GbtSurfaces.Part_Table_proofs.tab_1_1_proposed.proved : GbtSurfaces.Part_Table.tab_1_1_proposed.statement).
Check (GbtSurfaces.Part_Table_proofs.tab_1_1_proposed.met : GbtSurfaces.Part_Table.tab_1_1_proposed.instance).
Check (GbtSurfaces.Part_Table_proofs.tab_1_2_proposed.proved : GbtSurfaces.Part_Table.tab_1_2_proposed.statement).
Check (GbtSurfaces.Part_Table_proofs.tab_1_2_proposed.met : GbtSurfaces.Part_Table.tab_1_2_proposed.instance).
Check (GbtSurfaces.Part_Table_proofs.tab_1_3_proposed.proved : GbtSurfaces.Part_Table.tab_1_3_proposed.statement).
Check (GbtSurfaces.Part_Table_proofs.tab_1_3_proposed.met : GbtSurfaces.Part_Table.tab_1_3_proposed.instance).
Check (GbtSurfaces.Part_Table_proofs.tab_1_4_proposed.proved : GbtSurfaces.Part_Table.tab_1_4_proposed.statement).
Check (GbtSurfaces.Part_Table_proofs.tab_1_4_proposed.met : GbtSurfaces.Part_Table.tab_1_4_proposed.instance).
Check (GbtSurfaces.Part_Table_proofs.tab_1_5_proposed.proved : GbtSurfaces.Part_Table.tab_1_5_proposed.statement).
Check (GbtSurfaces.Part_Table_proofs.tab_1_5_proposed.met : GbtSurfaces.Part_Table.tab_1_5_proposed.instance).
Check (GbtSurfaces.Section_1_printed_proofs.sec_1_contrib_1.proved : GbtSurfaces.Section_1_printed.sec_1_contrib_1.statement).
Check (GbtSurfaces.Section_1_printed_proofs.sec_1_contrib_1.met : GbtSurfaces.Section_1_printed.sec_1_contrib_1.instance).
Check (GbtSurfaces.Section_1_printed_proofs.sec_1_contrib_2.proved : GbtSurfaces.Section_1_printed.sec_1_contrib_2.statement).
Check (GbtSurfaces.Section_1_printed_proofs.sec_1_contrib_2.met : GbtSurfaces.Section_1_printed.sec_1_contrib_2.instance).
Check (GbtSurfaces.Section_1_printed_proofs.sec_1_contrib_3_by_the_printed_conditions.refuted : ~ GbtSurfaces.Section_1_printed.sec_1_contrib_3_by_the_printed_conditions.statement).
Check (GbtSurfaces.Section_1_printed_proofs.sec_1_contrib_3_there_are_such_compositions.proved : GbtSurfaces.Section_1_printed.sec_1_contrib_3_there_are_such_compositions.statement).
Check (GbtSurfaces.Section_1_printed_proofs.sec_1_contrib_3_there_are_such_compositions.met : GbtSurfaces.Section_1_printed.sec_1_contrib_3_there_are_such_compositions.instance).
Check (GbtSurfaces.Section_1_proofs.sec_1_contrib_1.proved : GbtSurfaces.Section_1.sec_1_contrib_1.statement).
Check (GbtSurfaces.Section_1_proofs.sec_1_contrib_1.met : GbtSurfaces.Section_1.sec_1_contrib_1.instance).
Check (GbtSurfaces.Section_1_proofs.sec_1_contrib_2.proved : GbtSurfaces.Section_1.sec_1_contrib_2.statement).
Check (GbtSurfaces.Section_1_proofs.sec_1_contrib_2.met : GbtSurfaces.Section_1.sec_1_contrib_2.instance).
Check (GbtSurfaces.Section_1_proofs.sec_1_contrib_3_by_the_printed_conditions.refuted : ~ GbtSurfaces.Section_1.sec_1_contrib_3_by_the_printed_conditions.statement).
Check (GbtSurfaces.Section_1_proofs.sec_1_contrib_3_there_are_such_compositions.proved : GbtSurfaces.Section_1.sec_1_contrib_3_there_are_such_compositions.statement).
Check (GbtSurfaces.Section_1_proofs.sec_1_contrib_3_there_are_such_compositions.met : GbtSurfaces.Section_1.sec_1_contrib_3_there_are_such_compositions.instance).
Check (GbtSurfaces.Section_2_1_printed_proofs.eq_1_f0.proved : GbtSurfaces.Section_2_1_printed.eq_1_f0.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.eq_1_f0.met : GbtSurfaces.Section_2_1_printed.eq_1_f0.instance).
Check (GbtSurfaces.Section_2_1_printed_proofs.eq_1_f1.proved : GbtSurfaces.Section_2_1_printed.eq_1_f1.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.eq_1_f1.met : GbtSurfaces.Section_2_1_printed.eq_1_f1.instance).
Check (GbtSurfaces.Section_2_1_printed_proofs.eq_1_f2.proved : GbtSurfaces.Section_2_1_printed.eq_1_f2.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.eq_1_f2.met : GbtSurfaces.Section_2_1_printed.eq_1_f2.instance).
Check (GbtSurfaces.Section_2_1_printed_proofs.eq_2.proved : GbtSurfaces.Section_2_1_printed.eq_2.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.eq_2.met : GbtSurfaces.Section_2_1_printed.eq_2.instance).
Check (GbtSurfaces.Section_2_1_printed_proofs.eq_2_zero.refuted : ~ GbtSurfaces.Section_2_1_printed.eq_2_zero.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.eq_2_zero_true.proved : GbtSurfaces.Section_2_1_printed.eq_2_zero_true.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.eq_2_zero_true.met : GbtSurfaces.Section_2_1_printed.eq_2_zero_true.instance).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_1_formal.proved : GbtSurfaces.Section_2_1_printed.thm_1_1_formal.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_1_formal.met : GbtSurfaces.Section_2_1_printed.thm_1_1_formal.instance).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_1_as_functions.refuted : ~ GbtSurfaces.Section_2_1_printed.thm_1_1_as_functions.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_1_true.proved : GbtSurfaces.Section_2_1_printed.thm_1_1_true.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_1_true.met : GbtSurfaces.Section_2_1_printed.thm_1_1_true.instance).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_1_blend.proved : GbtSurfaces.Section_2_1_printed.thm_1_1_blend.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_1_blend.met : GbtSurfaces.Section_2_1_printed.thm_1_1_blend.instance).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_2_Definition_1.refuted : ~ GbtSurfaces.Section_2_1_printed.thm_1_2_Definition_1.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_2_where_curves_are_defined.proved : GbtSurfaces.Section_2_1_printed.thm_1_2_where_curves_are_defined.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_2_where_curves_are_defined.met : GbtSurfaces.Section_2_1_printed.thm_1_2_where_curves_are_defined.instance).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_3.proved : GbtSurfaces.Section_2_1_printed.thm_1_3.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_3.met : GbtSurfaces.Section_2_1_printed.thm_1_3.instance).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_4.proved : GbtSurfaces.Section_2_1_printed.thm_1_4.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_4.met : GbtSurfaces.Section_2_1_printed.thm_1_4.instance).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d1_0_values.proved : GbtSurfaces.Section_2_1_printed.thm_1_5_d1_0_values.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d1_0_values.met : GbtSurfaces.Section_2_1_printed.thm_1_5_d1_0_values.instance).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d1_1_values.proved : GbtSurfaces.Section_2_1_printed.thm_1_5_d1_1_values.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d1_1_values.met : GbtSurfaces.Section_2_1_printed.thm_1_5_d1_1_values.instance).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d2_0_values.proved : GbtSurfaces.Section_2_1_printed.thm_1_5_d2_0_values.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d2_0_values.met : GbtSurfaces.Section_2_1_printed.thm_1_5_d2_0_values.instance).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d2_1_values.proved : GbtSurfaces.Section_2_1_printed.thm_1_5_d2_1_values.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d2_1_values.met : GbtSurfaces.Section_2_1_printed.thm_1_5_d2_1_values.instance).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d3_0_values.proved : GbtSurfaces.Section_2_1_printed.thm_1_5_d3_0_values.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d3_0_values.met : GbtSurfaces.Section_2_1_printed.thm_1_5_d3_0_values.instance).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d3_1_values.proved : GbtSurfaces.Section_2_1_printed.thm_1_5_d3_1_values.statement).
Check (GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d3_1_values.met : GbtSurfaces.Section_2_1_printed.thm_1_5_d3_1_values.instance).
Check (GbtSurfaces.Section_2_1_proofs.eq_1_f0.proved : GbtSurfaces.Section_2_1.eq_1_f0.statement).
Check (GbtSurfaces.Section_2_1_proofs.eq_1_f0.met : GbtSurfaces.Section_2_1.eq_1_f0.instance).
Check (GbtSurfaces.Section_2_1_proofs.eq_1_f1.proved : GbtSurfaces.Section_2_1.eq_1_f1.statement).
Check (GbtSurfaces.Section_2_1_proofs.eq_1_f1.met : GbtSurfaces.Section_2_1.eq_1_f1.instance).
Check (GbtSurfaces.Section_2_1_proofs.eq_1_f2.proved : GbtSurfaces.Section_2_1.eq_1_f2.statement).
Check (GbtSurfaces.Section_2_1_proofs.eq_1_f2.met : GbtSurfaces.Section_2_1.eq_1_f2.instance).
Check (GbtSurfaces.Section_2_1_proofs.eq_2.proved : GbtSurfaces.Section_2_1.eq_2.statement).
Check (GbtSurfaces.Section_2_1_proofs.eq_2.met : GbtSurfaces.Section_2_1.eq_2.instance).
Check (GbtSurfaces.Section_2_1_proofs.eq_2_zero.refuted : ~ GbtSurfaces.Section_2_1.eq_2_zero.statement).
Check (GbtSurfaces.Section_2_1_proofs.eq_2_zero_true.proved : GbtSurfaces.Section_2_1.eq_2_zero_true.statement).
Check (GbtSurfaces.Section_2_1_proofs.eq_2_zero_true.met : GbtSurfaces.Section_2_1.eq_2_zero_true.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_1_formal.proved : GbtSurfaces.Section_2_1.thm_1_1_formal.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_1_formal.met : GbtSurfaces.Section_2_1.thm_1_1_formal.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_1_as_functions.refuted : ~ GbtSurfaces.Section_2_1.thm_1_1_as_functions.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_1_true.proved : GbtSurfaces.Section_2_1.thm_1_1_true.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_1_true.met : GbtSurfaces.Section_2_1.thm_1_1_true.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_1_blend.proved : GbtSurfaces.Section_2_1.thm_1_1_blend.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_1_blend.met : GbtSurfaces.Section_2_1.thm_1_1_blend.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_2_Definition_1.refuted : ~ GbtSurfaces.Section_2_1.thm_1_2_Definition_1.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_2_where_curves_are_defined.proved : GbtSurfaces.Section_2_1.thm_1_2_where_curves_are_defined.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_2_where_curves_are_defined.met : GbtSurfaces.Section_2_1.thm_1_2_where_curves_are_defined.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_3.proved : GbtSurfaces.Section_2_1.thm_1_3.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_3.met : GbtSurfaces.Section_2_1.thm_1_3.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_4.proved : GbtSurfaces.Section_2_1.thm_1_4.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_4.met : GbtSurfaces.Section_2_1.thm_1_4.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_0_values.proved : GbtSurfaces.Section_2_1.thm_1_5_d1_0_values.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_0_values.met : GbtSurfaces.Section_2_1.thm_1_5_d1_0_values.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_1_values.proved : GbtSurfaces.Section_2_1.thm_1_5_d1_1_values.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_1_values.met : GbtSurfaces.Section_2_1.thm_1_5_d1_1_values.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_0_values.proved : GbtSurfaces.Section_2_1.thm_1_5_d2_0_values.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_0_values.met : GbtSurfaces.Section_2_1.thm_1_5_d2_0_values.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_1_values.proved : GbtSurfaces.Section_2_1.thm_1_5_d2_1_values.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_1_values.met : GbtSurfaces.Section_2_1.thm_1_5_d2_1_values.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_0_values.proved : GbtSurfaces.Section_2_1.thm_1_5_d3_0_values.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_0_values.met : GbtSurfaces.Section_2_1.thm_1_5_d3_0_values.instance).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_1_values.proved : GbtSurfaces.Section_2_1.thm_1_5_d3_1_values.statement).
Check (GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_1_values.met : GbtSurfaces.Section_2_1.thm_1_5_d3_1_values.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.def_2_points.refuted : ~ GbtSurfaces.Section_2_2_printed.def_2_points.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.eq_3.proved : GbtSurfaces.Section_2_2_printed.eq_3.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.eq_3.met : GbtSurfaces.Section_2_2_printed.eq_3.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_symmetry_as_in_Theorem_1.proved : GbtSurfaces.Section_2_2_printed.sec_2_2_symmetry_as_in_Theorem_1.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_symmetry_as_in_Theorem_1.met : GbtSurfaces.Section_2_2_printed.sec_2_2_symmetry_as_in_Theorem_1.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_symmetry_parameters_exchanged.proved : GbtSurfaces.Section_2_2_printed.sec_2_2_symmetry_parameters_exchanged.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_symmetry_parameters_exchanged.met : GbtSurfaces.Section_2_2_printed.sec_2_2_symmetry_parameters_exchanged.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_symmetry_as_for_B_zier_curves.refuted : ~ GbtSurfaces.Section_2_2_printed.sec_2_2_symmetry_as_for_B_zier_curves.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_convex_hull.proved : GbtSurfaces.Section_2_2_printed.sec_2_2_convex_hull.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_convex_hull.met : GbtSurfaces.Section_2_2_printed.sec_2_2_convex_hull.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_variation_diminishing_order_2.proved : GbtSurfaces.Section_2_2_printed.sec_2_2_variation_diminishing_order_2.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_variation_diminishing_order_2.met : GbtSurfaces.Section_2_2_printed.sec_2_2_variation_diminishing_order_2.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_invariance.proved : GbtSurfaces.Section_2_2_printed.sec_2_2_invariance.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_invariance.met : GbtSurfaces.Section_2_2_printed.sec_2_2_invariance.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_shape_adjustable.proved : GbtSurfaces.Section_2_2_printed.sec_2_2_shape_adjustable.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_shape_adjustable.met : GbtSurfaces.Section_2_2_printed.sec_2_2_shape_adjustable.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_terminal_0_values.proved : GbtSurfaces.Section_2_2_printed.sec_2_2_terminal_0_values.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_terminal_0_values.met : GbtSurfaces.Section_2_2_printed.sec_2_2_terminal_0_values.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_terminal_1_values.proved : GbtSurfaces.Section_2_2_printed.sec_2_2_terminal_1_values.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_terminal_1_values.met : GbtSurfaces.Section_2_2_printed.sec_2_2_terminal_1_values.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_interpolation.proved : GbtSurfaces.Section_2_2_printed.sec_2_2_interpolation.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_interpolation.met : GbtSurfaces.Section_2_2_printed.sec_2_2_interpolation.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_end_derivatives.proved : GbtSurfaces.Section_2_2_printed.sec_2_2_end_derivatives.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_end_derivatives.met : GbtSurfaces.Section_2_2_printed.sec_2_2_end_derivatives.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_setting.proved : GbtSurfaces.Section_2_2_printed.thm_2_setting.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_setting.met : GbtSurfaces.Section_2_2_printed.thm_2_setting.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_1.proved : GbtSurfaces.Section_2_2_printed.thm_2_1.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_1.met : GbtSurfaces.Section_2_2_printed.thm_2_1.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.eq_4_Q11.proved : GbtSurfaces.Section_2_2_printed.eq_4_Q11.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.eq_4_Q11.met : GbtSurfaces.Section_2_2_printed.eq_4_Q11.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_2.proved : GbtSurfaces.Section_2_2_printed.thm_2_2.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_2.met : GbtSurfaces.Section_2_2_printed.thm_2_2.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.eq_5_Q12.refuted : ~ GbtSurfaces.Section_2_2_printed.eq_5_Q12.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.eq_5_Q12_corrected.proved : GbtSurfaces.Section_2_2_printed.eq_5_Q12_corrected.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.eq_5_Q12_corrected.met : GbtSurfaces.Section_2_2_printed.eq_5_Q12_corrected.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.eq_5_Q12_true.proved : GbtSurfaces.Section_2_2_printed.eq_5_Q12_true.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.eq_5_Q12_true.met : GbtSurfaces.Section_2_2_printed.eq_5_Q12_true.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_a.refuted : ~ GbtSurfaces.Section_2_2_printed.thm_2_3_a.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_b.refuted : ~ GbtSurfaces.Section_2_2_printed.thm_2_3_b.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_true.proved : GbtSurfaces.Section_2_2_printed.thm_2_3_true.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_true.met : GbtSurfaces.Section_2_2_printed.thm_2_3_true.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_iff.proved : GbtSurfaces.Section_2_2_printed.thm_2_3_iff.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_iff.met : GbtSurfaces.Section_2_2_printed.thm_2_3_iff.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_necessary.proved : GbtSurfaces.Section_2_2_printed.thm_2_3_necessary.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_necessary.met : GbtSurfaces.Section_2_2_printed.thm_2_3_necessary.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_sufficient.proved : GbtSurfaces.Section_2_2_printed.thm_2_3_sufficient.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_sufficient.met : GbtSurfaces.Section_2_2_printed.thm_2_3_sufficient.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_jump.proved : GbtSurfaces.Section_2_2_printed.thm_2_3_jump.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_jump.met : GbtSurfaces.Section_2_2_printed.thm_2_3_jump.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_when.proved : GbtSurfaces.Section_2_2_printed.thm_2_3_when.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_when.met : GbtSurfaces.Section_2_2_printed.thm_2_3_when.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.eq_6_Q11.proved : GbtSurfaces.Section_2_2_printed.eq_6_Q11.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.eq_6_Q11.met : GbtSurfaces.Section_2_2_printed.eq_6_Q11.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.eq_6_Q12.refuted : ~ GbtSurfaces.Section_2_2_printed.eq_6_Q12.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.eq_6_Q12_corrected.proved : GbtSurfaces.Section_2_2_printed.eq_6_Q12_corrected.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.eq_6_Q12_corrected.met : GbtSurfaces.Section_2_2_printed.eq_6_Q12_corrected.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.eq_6_Q13.refuted : ~ GbtSurfaces.Section_2_2_printed.eq_6_Q13.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.eq_6_Q13_true.proved : GbtSurfaces.Section_2_2_printed.eq_6_Q13_true.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.eq_6_Q13_true.met : GbtSurfaces.Section_2_2_printed.eq_6_Q13_true.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_a.refuted : ~ GbtSurfaces.Section_2_2_printed.thm_2_4_a.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_c.refuted : ~ GbtSurfaces.Section_2_2_printed.thm_2_4_c.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_b.refuted : ~ GbtSurfaces.Section_2_2_printed.thm_2_4_b.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_true.proved : GbtSurfaces.Section_2_2_printed.thm_2_4_true.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_true.met : GbtSurfaces.Section_2_2_printed.thm_2_4_true.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_iff.proved : GbtSurfaces.Section_2_2_printed.thm_2_4_iff.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_iff.met : GbtSurfaces.Section_2_2_printed.thm_2_4_iff.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_necessary.proved : GbtSurfaces.Section_2_2_printed.thm_2_4_necessary.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_necessary.met : GbtSurfaces.Section_2_2_printed.thm_2_4_necessary.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_sufficient.proved : GbtSurfaces.Section_2_2_printed.thm_2_4_sufficient.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_sufficient.met : GbtSurfaces.Section_2_2_printed.thm_2_4_sufficient.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_sufficient_quintic.proved : GbtSurfaces.Section_2_2_printed.thm_2_4_sufficient_quintic.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_sufficient_quintic.met : GbtSurfaces.Section_2_2_printed.thm_2_4_sufficient_quintic.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_cubic.proved : GbtSurfaces.Section_2_2_printed.thm_2_4_cubic.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_cubic.met : GbtSurfaces.Section_2_2_printed.thm_2_4_cubic.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_a.proved : GbtSurfaces.Section_2_2_printed.thm_2_a.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_a.met : GbtSurfaces.Section_2_2_printed.thm_2_a.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_a1.proved : GbtSurfaces.Section_2_2_printed.thm_2_a1.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_a1.met : GbtSurfaces.Section_2_2_printed.thm_2_a1.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_a1_sign.proved : GbtSurfaces.Section_2_2_printed.thm_2_a1_sign.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_a1_sign.met : GbtSurfaces.Section_2_2_printed.thm_2_a1_sign.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_a2.proved : GbtSurfaces.Section_2_2_printed.thm_2_a2.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_a2.met : GbtSurfaces.Section_2_2_printed.thm_2_a2.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_a3.refuted : ~ GbtSurfaces.Section_2_2_printed.thm_2_a3.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_a3_corrected.proved : GbtSurfaces.Section_2_2_printed.thm_2_a3_corrected.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_a3_corrected.met : GbtSurfaces.Section_2_2_printed.thm_2_a3_corrected.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_a3_true.proved : GbtSurfaces.Section_2_2_printed.thm_2_a3_true.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_a3_true.met : GbtSurfaces.Section_2_2_printed.thm_2_a3_true.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_b1.proved : GbtSurfaces.Section_2_2_printed.thm_2_b1.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_b1.met : GbtSurfaces.Section_2_2_printed.thm_2_b1.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_b1_sign.proved : GbtSurfaces.Section_2_2_printed.thm_2_b1_sign.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_b1_sign.met : GbtSurfaces.Section_2_2_printed.thm_2_b1_sign.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_b2.refuted : ~ GbtSurfaces.Section_2_2_printed.thm_2_b2.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_b2_true.proved : GbtSurfaces.Section_2_2_printed.thm_2_b2_true.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_b2_true.met : GbtSurfaces.Section_2_2_printed.thm_2_b2_true.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_b3.refuted : ~ GbtSurfaces.Section_2_2_printed.thm_2_b3.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_b3_corrected.proved : GbtSurfaces.Section_2_2_printed.thm_2_b3_corrected.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_b3_corrected.met : GbtSurfaces.Section_2_2_printed.thm_2_b3_corrected.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_b3_true.proved : GbtSurfaces.Section_2_2_printed.thm_2_b3_true.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_b3_true.met : GbtSurfaces.Section_2_2_printed.thm_2_b3_true.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_b4.refuted : ~ GbtSurfaces.Section_2_2_printed.thm_2_b4.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_b4_corrected.proved : GbtSurfaces.Section_2_2_printed.thm_2_b4_corrected.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_b4_corrected.met : GbtSurfaces.Section_2_2_printed.thm_2_b4_corrected.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_b4_true.proved : GbtSurfaces.Section_2_2_printed.thm_2_b4_true.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_b4_true.met : GbtSurfaces.Section_2_2_printed.thm_2_b4_true.instance).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_c1.proved : GbtSurfaces.Section_2_2_printed.thm_2_c1.statement).
Check (GbtSurfaces.Section_2_2_printed_proofs.thm_2_c1.met : GbtSurfaces.Section_2_2_printed.thm_2_c1.instance).
Check (GbtSurfaces.Section_2_2_proofs.def_2_points.refuted : ~ GbtSurfaces.Section_2_2.def_2_points.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_3.proved : GbtSurfaces.Section_2_2.eq_3.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_3.met : GbtSurfaces.Section_2_2.eq_3.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_as_in_Theorem_1.proved : GbtSurfaces.Section_2_2.sec_2_2_symmetry_as_in_Theorem_1.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_as_in_Theorem_1.met : GbtSurfaces.Section_2_2.sec_2_2_symmetry_as_in_Theorem_1.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_parameters_exchanged.proved : GbtSurfaces.Section_2_2.sec_2_2_symmetry_parameters_exchanged.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_parameters_exchanged.met : GbtSurfaces.Section_2_2.sec_2_2_symmetry_parameters_exchanged.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_as_for_B_zier_curves.refuted : ~ GbtSurfaces.Section_2_2.sec_2_2_symmetry_as_for_B_zier_curves.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_convex_hull.proved : GbtSurfaces.Section_2_2.sec_2_2_convex_hull.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_convex_hull.met : GbtSurfaces.Section_2_2.sec_2_2_convex_hull.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_variation_diminishing_order_2.proved : GbtSurfaces.Section_2_2.sec_2_2_variation_diminishing_order_2.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_variation_diminishing_order_2.met : GbtSurfaces.Section_2_2.sec_2_2_variation_diminishing_order_2.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_invariance.proved : GbtSurfaces.Section_2_2.sec_2_2_invariance.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_invariance.met : GbtSurfaces.Section_2_2.sec_2_2_invariance.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_shape_adjustable.proved : GbtSurfaces.Section_2_2.sec_2_2_shape_adjustable.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_shape_adjustable.met : GbtSurfaces.Section_2_2.sec_2_2_shape_adjustable.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_0_values.proved : GbtSurfaces.Section_2_2.sec_2_2_terminal_0_values.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_0_values.met : GbtSurfaces.Section_2_2.sec_2_2_terminal_0_values.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_1_values.proved : GbtSurfaces.Section_2_2.sec_2_2_terminal_1_values.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_1_values.met : GbtSurfaces.Section_2_2.sec_2_2_terminal_1_values.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_interpolation.proved : GbtSurfaces.Section_2_2.sec_2_2_interpolation.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_interpolation.met : GbtSurfaces.Section_2_2.sec_2_2_interpolation.instance).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_end_derivatives.proved : GbtSurfaces.Section_2_2.sec_2_2_end_derivatives.statement).
Check (GbtSurfaces.Section_2_2_proofs.sec_2_2_end_derivatives.met : GbtSurfaces.Section_2_2.sec_2_2_end_derivatives.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_setting.proved : GbtSurfaces.Section_2_2.thm_2_setting.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_setting.met : GbtSurfaces.Section_2_2.thm_2_setting.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_1.proved : GbtSurfaces.Section_2_2.thm_2_1.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_1.met : GbtSurfaces.Section_2_2.thm_2_1.instance).
Check (GbtSurfaces.Section_2_2_proofs.eq_4_Q11.proved : GbtSurfaces.Section_2_2.eq_4_Q11.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_4_Q11.met : GbtSurfaces.Section_2_2.eq_4_Q11.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_2.proved : GbtSurfaces.Section_2_2.thm_2_2.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_2.met : GbtSurfaces.Section_2_2.thm_2_2.instance).
Check (GbtSurfaces.Section_2_2_proofs.eq_5_Q12.refuted : ~ GbtSurfaces.Section_2_2.eq_5_Q12.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_5_Q12_corrected.proved : GbtSurfaces.Section_2_2.eq_5_Q12_corrected.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_5_Q12_corrected.met : GbtSurfaces.Section_2_2.eq_5_Q12_corrected.instance).
Check (GbtSurfaces.Section_2_2_proofs.eq_5_Q12_true.proved : GbtSurfaces.Section_2_2.eq_5_Q12_true.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_5_Q12_true.met : GbtSurfaces.Section_2_2.eq_5_Q12_true.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_a.refuted : ~ GbtSurfaces.Section_2_2.thm_2_3_a.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_b.refuted : ~ GbtSurfaces.Section_2_2.thm_2_3_b.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_true.proved : GbtSurfaces.Section_2_2.thm_2_3_true.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_true.met : GbtSurfaces.Section_2_2.thm_2_3_true.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_iff.proved : GbtSurfaces.Section_2_2.thm_2_3_iff.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_iff.met : GbtSurfaces.Section_2_2.thm_2_3_iff.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_necessary.proved : GbtSurfaces.Section_2_2.thm_2_3_necessary.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_necessary.met : GbtSurfaces.Section_2_2.thm_2_3_necessary.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_sufficient.proved : GbtSurfaces.Section_2_2.thm_2_3_sufficient.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_sufficient.met : GbtSurfaces.Section_2_2.thm_2_3_sufficient.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_jump.proved : GbtSurfaces.Section_2_2.thm_2_3_jump.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_jump.met : GbtSurfaces.Section_2_2.thm_2_3_jump.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_when.proved : GbtSurfaces.Section_2_2.thm_2_3_when.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_3_when.met : GbtSurfaces.Section_2_2.thm_2_3_when.instance).
Check (GbtSurfaces.Section_2_2_proofs.eq_6_Q11.proved : GbtSurfaces.Section_2_2.eq_6_Q11.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_6_Q11.met : GbtSurfaces.Section_2_2.eq_6_Q11.instance).
Check (GbtSurfaces.Section_2_2_proofs.eq_6_Q12.refuted : ~ GbtSurfaces.Section_2_2.eq_6_Q12.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_6_Q12_corrected.proved : GbtSurfaces.Section_2_2.eq_6_Q12_corrected.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_6_Q12_corrected.met : GbtSurfaces.Section_2_2.eq_6_Q12_corrected.instance).
Check (GbtSurfaces.Section_2_2_proofs.eq_6_Q13.refuted : ~ GbtSurfaces.Section_2_2.eq_6_Q13.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_6_Q13_true.proved : GbtSurfaces.Section_2_2.eq_6_Q13_true.statement).
Check (GbtSurfaces.Section_2_2_proofs.eq_6_Q13_true.met : GbtSurfaces.Section_2_2.eq_6_Q13_true.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_a.refuted : ~ GbtSurfaces.Section_2_2.thm_2_4_a.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_c.refuted : ~ GbtSurfaces.Section_2_2.thm_2_4_c.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_b.refuted : ~ GbtSurfaces.Section_2_2.thm_2_4_b.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_true.proved : GbtSurfaces.Section_2_2.thm_2_4_true.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_true.met : GbtSurfaces.Section_2_2.thm_2_4_true.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_iff.proved : GbtSurfaces.Section_2_2.thm_2_4_iff.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_iff.met : GbtSurfaces.Section_2_2.thm_2_4_iff.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_necessary.proved : GbtSurfaces.Section_2_2.thm_2_4_necessary.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_necessary.met : GbtSurfaces.Section_2_2.thm_2_4_necessary.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient.proved : GbtSurfaces.Section_2_2.thm_2_4_sufficient.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient.met : GbtSurfaces.Section_2_2.thm_2_4_sufficient.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient_quintic.proved : GbtSurfaces.Section_2_2.thm_2_4_sufficient_quintic.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient_quintic.met : GbtSurfaces.Section_2_2.thm_2_4_sufficient_quintic.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_cubic.proved : GbtSurfaces.Section_2_2.thm_2_4_cubic.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_4_cubic.met : GbtSurfaces.Section_2_2.thm_2_4_cubic.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a.proved : GbtSurfaces.Section_2_2.thm_2_a.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a.met : GbtSurfaces.Section_2_2.thm_2_a.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a1.proved : GbtSurfaces.Section_2_2.thm_2_a1.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a1.met : GbtSurfaces.Section_2_2.thm_2_a1.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a1_sign.proved : GbtSurfaces.Section_2_2.thm_2_a1_sign.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a1_sign.met : GbtSurfaces.Section_2_2.thm_2_a1_sign.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a2.proved : GbtSurfaces.Section_2_2.thm_2_a2.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a2.met : GbtSurfaces.Section_2_2.thm_2_a2.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a3.refuted : ~ GbtSurfaces.Section_2_2.thm_2_a3.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a3_corrected.proved : GbtSurfaces.Section_2_2.thm_2_a3_corrected.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a3_corrected.met : GbtSurfaces.Section_2_2.thm_2_a3_corrected.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a3_true.proved : GbtSurfaces.Section_2_2.thm_2_a3_true.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_a3_true.met : GbtSurfaces.Section_2_2.thm_2_a3_true.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b1.proved : GbtSurfaces.Section_2_2.thm_2_b1.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b1.met : GbtSurfaces.Section_2_2.thm_2_b1.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b1_sign.proved : GbtSurfaces.Section_2_2.thm_2_b1_sign.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b1_sign.met : GbtSurfaces.Section_2_2.thm_2_b1_sign.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b2.refuted : ~ GbtSurfaces.Section_2_2.thm_2_b2.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b2_true.proved : GbtSurfaces.Section_2_2.thm_2_b2_true.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b2_true.met : GbtSurfaces.Section_2_2.thm_2_b2_true.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b3.refuted : ~ GbtSurfaces.Section_2_2.thm_2_b3.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b3_corrected.proved : GbtSurfaces.Section_2_2.thm_2_b3_corrected.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b3_corrected.met : GbtSurfaces.Section_2_2.thm_2_b3_corrected.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b3_true.proved : GbtSurfaces.Section_2_2.thm_2_b3_true.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b3_true.met : GbtSurfaces.Section_2_2.thm_2_b3_true.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b4.refuted : ~ GbtSurfaces.Section_2_2.thm_2_b4.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b4_corrected.proved : GbtSurfaces.Section_2_2.thm_2_b4_corrected.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b4_corrected.met : GbtSurfaces.Section_2_2.thm_2_b4_corrected.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b4_true.proved : GbtSurfaces.Section_2_2.thm_2_b4_true.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_b4_true.met : GbtSurfaces.Section_2_2.thm_2_b4_true.instance).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_c1.proved : GbtSurfaces.Section_2_2.thm_2_c1.statement).
Check (GbtSurfaces.Section_2_2_proofs.thm_2_c1.met : GbtSurfaces.Section_2_2.thm_2_c1.instance).
Check (GbtSurfaces.Section_2_3_printed_proofs.eq_7.proved : GbtSurfaces.Section_2_3_printed.eq_7.statement).
Check (GbtSurfaces.Section_2_3_printed_proofs.eq_7.met : GbtSurfaces.Section_2_3_printed.eq_7.instance).
Check (GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_features_a.proved : GbtSurfaces.Section_2_3_printed.sec_2_3_features_a.statement).
Check (GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_features_a.met : GbtSurfaces.Section_2_3_printed.sec_2_3_features_a.instance).
Check (GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_features_b.proved : GbtSurfaces.Section_2_3_printed.sec_2_3_features_b.statement).
Check (GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_features_b.met : GbtSurfaces.Section_2_3_printed.sec_2_3_features_b.instance).
Check (GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_features_c.proved : GbtSurfaces.Section_2_3_printed.sec_2_3_features_c.statement).
Check (GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_features_c.met : GbtSurfaces.Section_2_3_printed.sec_2_3_features_c.instance).
Check (GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_features_d.proved : GbtSurfaces.Section_2_3_printed.sec_2_3_features_d.statement).
Check (GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_features_d.met : GbtSurfaces.Section_2_3_printed.sec_2_3_features_d.instance).
Check (GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_classical_the_features_of_Sect__2_2.proved : GbtSurfaces.Section_2_3_printed.sec_2_3_classical_the_features_of_Sect__2_2.statement).
Check (GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_classical_the_features_of_Sect__2_2.met : GbtSurfaces.Section_2_3_printed.sec_2_3_classical_the_features_of_Sect__2_2.instance).
Check (GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_classical_every_property.refuted : ~ GbtSurfaces.Section_2_3_printed.sec_2_3_classical_every_property.statement).
Check (GbtSurfaces.Section_2_3_proofs.eq_7.proved : GbtSurfaces.Section_2_3.eq_7.statement).
Check (GbtSurfaces.Section_2_3_proofs.eq_7.met : GbtSurfaces.Section_2_3.eq_7.instance).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_features_a.proved : GbtSurfaces.Section_2_3.sec_2_3_features_a.statement).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_features_a.met : GbtSurfaces.Section_2_3.sec_2_3_features_a.instance).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_features_b.proved : GbtSurfaces.Section_2_3.sec_2_3_features_b.statement).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_features_b.met : GbtSurfaces.Section_2_3.sec_2_3_features_b.instance).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_features_c.proved : GbtSurfaces.Section_2_3.sec_2_3_features_c.statement).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_features_c.met : GbtSurfaces.Section_2_3.sec_2_3_features_c.instance).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_features_d.proved : GbtSurfaces.Section_2_3.sec_2_3_features_d.statement).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_features_d.met : GbtSurfaces.Section_2_3.sec_2_3_features_d.instance).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_classical_the_features_of_Sect__2_2.proved : GbtSurfaces.Section_2_3.sec_2_3_classical_the_features_of_Sect__2_2.statement).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_classical_the_features_of_Sect__2_2.met : GbtSurfaces.Section_2_3.sec_2_3_classical_the_features_of_Sect__2_2.instance).
Check (GbtSurfaces.Section_2_3_proofs.sec_2_3_classical_every_property.refuted : ~ GbtSurfaces.Section_2_3.sec_2_3_classical_every_property.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_i.proved : GbtSurfaces.Section_3_1_printed.sec_3_1_i.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_i.met : GbtSurfaces.Section_3_1_printed.sec_3_1_i.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_8_1.proved : GbtSurfaces.Section_3_1_printed.eq_8_1.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_8_1.met : GbtSurfaces.Section_3_1_printed.eq_8_1.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_8_2.proved : GbtSurfaces.Section_3_1_printed.eq_8_2.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_8_2.met : GbtSurfaces.Section_3_1_printed.eq_8_2.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.prop_3_1.proved : GbtSurfaces.Section_3_1_printed.prop_3_1.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.prop_3_1.met : GbtSurfaces.Section_3_1_printed.prop_3_1.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_translating.proved : GbtSurfaces.Section_3_1_printed.sec_3_1_translating.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_translating.met : GbtSurfaces.Section_3_1_printed.sec_3_1_translating.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_not_tensor_literal.refuted : ~ GbtSurfaces.Section_3_1_printed.sec_3_1_not_tensor_literal.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_not_tensor_as_it_stands.proved : GbtSurfaces.Section_3_1_printed.sec_3_1_not_tensor_as_it_stands.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_not_tensor_as_it_stands.met : GbtSurfaces.Section_3_1_printed.sec_3_1_not_tensor_as_it_stands.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_order_one_missing_none.proved : GbtSurfaces.Section_3_1_printed.sec_3_1_order_one_missing_none.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_order_one_missing_none.met : GbtSurfaces.Section_3_1_printed.sec_3_1_order_one_missing_none.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_10.proved : GbtSurfaces.Section_3_1_printed.eq_10.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_10.met : GbtSurfaces.Section_3_1_printed.eq_10.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_10_bernstein.proved : GbtSurfaces.Section_3_1_printed.eq_10_bernstein.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_10_bernstein.met : GbtSurfaces.Section_3_1_printed.eq_10_bernstein.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_10_extending.proved : GbtSurfaces.Section_3_1_printed.eq_10_extending.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_10_extending.met : GbtSurfaces.Section_3_1_printed.eq_10_extending.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_11.refuted : ~ GbtSurfaces.Section_3_1_printed.eq_11.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_11_corrected.proved : GbtSurfaces.Section_3_1_printed.eq_11_corrected.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_11_corrected.met : GbtSurfaces.Section_3_1_printed.eq_11_corrected.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_11_points.refuted : ~ GbtSurfaces.Section_3_1_printed.eq_11_points.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_11_points_corrected.proved : GbtSurfaces.Section_3_1_printed.eq_11_points_corrected.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_11_points_corrected.met : GbtSurfaces.Section_3_1_printed.eq_11_points_corrected.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_11_parameters.proved : GbtSurfaces.Section_3_1_printed.eq_11_parameters.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_11_parameters.met : GbtSurfaces.Section_3_1_printed.eq_11_parameters.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_12_1.refuted : ~ GbtSurfaces.Section_3_1_printed.eq_12_1.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_12_1_corrected.proved : GbtSurfaces.Section_3_1_printed.eq_12_1_corrected.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_12_1_corrected.met : GbtSurfaces.Section_3_1_printed.eq_12_1_corrected.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_12_2.proved : GbtSurfaces.Section_3_1_printed.eq_12_2.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_12_2.met : GbtSurfaces.Section_3_1_printed.eq_12_2.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_12_3.proved : GbtSurfaces.Section_3_1_printed.eq_12_3.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_12_3.met : GbtSurfaces.Section_3_1_printed.eq_12_3.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_12_4.proved : GbtSurfaces.Section_3_1_printed.eq_12_4.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_12_4.met : GbtSurfaces.Section_3_1_printed.eq_12_4.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.thm_3.proved : GbtSurfaces.Section_3_1_printed.thm_3.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.thm_3.met : GbtSurfaces.Section_3_1_printed.thm_3.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_benefits.proved : GbtSurfaces.Section_3_1_printed.sec_3_1_benefits.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_benefits.met : GbtSurfaces.Section_3_1_printed.sec_3_1_benefits.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_any_shape_literal.refuted : ~ GbtSurfaces.Section_3_1_printed.sec_3_1_any_shape_literal.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_any_shape_the_shape_changes.proved : GbtSurfaces.Section_3_1_printed.sec_3_1_any_shape_the_shape_changes.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_any_shape_the_shape_changes.met : GbtSurfaces.Section_3_1_printed.sec_3_1_any_shape_the_shape_changes.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.alg_1.proved : GbtSurfaces.Section_3_1_printed.alg_1.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.alg_1.met : GbtSurfaces.Section_3_1_printed.alg_1.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.ex_3_1_points.proved : GbtSurfaces.Section_3_1_printed.ex_3_1_points.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.ex_3_1_normal.proved : GbtSurfaces.Section_3_1_printed.ex_3_1_normal.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_13.proved : GbtSurfaces.Section_3_1_printed.eq_13.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.eq_13.met : GbtSurfaces.Section_3_1_printed.eq_13.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.ex_3_1_net.proved : GbtSurfaces.Section_3_1_printed.ex_3_1_net.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.ex_3_1_mesh_count.proved : GbtSurfaces.Section_3_1_printed.ex_3_1_mesh_count.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.ex_3_1_hull.proved : GbtSurfaces.Section_3_1_printed.ex_3_1_hull.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.ex_3_1_hull.met : GbtSurfaces.Section_3_1_printed.ex_3_1_hull.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_effect.proved : GbtSurfaces.Section_3_1_printed.sec_3_1_effect.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_effect.met : GbtSurfaces.Section_3_1_printed.sec_3_1_effect.instance).
Check (GbtSurfaces.Section_3_1_printed_proofs.prop_3_1_translation.proved : GbtSurfaces.Section_3_1_printed.prop_3_1_translation.statement).
Check (GbtSurfaces.Section_3_1_printed_proofs.prop_3_1_translation.met : GbtSurfaces.Section_3_1_printed.prop_3_1_translation.instance).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_i.proved : GbtSurfaces.Section_3_1.sec_3_1_i.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_i.met : GbtSurfaces.Section_3_1.sec_3_1_i.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_8_1.proved : GbtSurfaces.Section_3_1.eq_8_1.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_8_1.met : GbtSurfaces.Section_3_1.eq_8_1.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_8_2.proved : GbtSurfaces.Section_3_1.eq_8_2.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_8_2.met : GbtSurfaces.Section_3_1.eq_8_2.instance).
Check (GbtSurfaces.Section_3_1_proofs.prop_3_1.proved : GbtSurfaces.Section_3_1.prop_3_1.statement).
Check (GbtSurfaces.Section_3_1_proofs.prop_3_1.met : GbtSurfaces.Section_3_1.prop_3_1.instance).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_translating.proved : GbtSurfaces.Section_3_1.sec_3_1_translating.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_translating.met : GbtSurfaces.Section_3_1.sec_3_1_translating.instance).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_not_tensor_literal.refuted : ~ GbtSurfaces.Section_3_1.sec_3_1_not_tensor_literal.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_not_tensor_as_it_stands.proved : GbtSurfaces.Section_3_1.sec_3_1_not_tensor_as_it_stands.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_not_tensor_as_it_stands.met : GbtSurfaces.Section_3_1.sec_3_1_not_tensor_as_it_stands.instance).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_order_one_missing_none.proved : GbtSurfaces.Section_3_1.sec_3_1_order_one_missing_none.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_order_one_missing_none.met : GbtSurfaces.Section_3_1.sec_3_1_order_one_missing_none.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_10.proved : GbtSurfaces.Section_3_1.eq_10.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_10.met : GbtSurfaces.Section_3_1.eq_10.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_10_bernstein.proved : GbtSurfaces.Section_3_1.eq_10_bernstein.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_10_bernstein.met : GbtSurfaces.Section_3_1.eq_10_bernstein.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_10_extending.proved : GbtSurfaces.Section_3_1.eq_10_extending.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_10_extending.met : GbtSurfaces.Section_3_1.eq_10_extending.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_11.refuted : ~ GbtSurfaces.Section_3_1.eq_11.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_11_corrected.proved : GbtSurfaces.Section_3_1.eq_11_corrected.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_11_corrected.met : GbtSurfaces.Section_3_1.eq_11_corrected.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_11_points.refuted : ~ GbtSurfaces.Section_3_1.eq_11_points.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_11_points_corrected.proved : GbtSurfaces.Section_3_1.eq_11_points_corrected.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_11_points_corrected.met : GbtSurfaces.Section_3_1.eq_11_points_corrected.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_11_parameters.proved : GbtSurfaces.Section_3_1.eq_11_parameters.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_11_parameters.met : GbtSurfaces.Section_3_1.eq_11_parameters.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_1.refuted : ~ GbtSurfaces.Section_3_1.eq_12_1.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_1_corrected.proved : GbtSurfaces.Section_3_1.eq_12_1_corrected.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_1_corrected.met : GbtSurfaces.Section_3_1.eq_12_1_corrected.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_2.proved : GbtSurfaces.Section_3_1.eq_12_2.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_2.met : GbtSurfaces.Section_3_1.eq_12_2.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_3.proved : GbtSurfaces.Section_3_1.eq_12_3.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_3.met : GbtSurfaces.Section_3_1.eq_12_3.instance).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_4.proved : GbtSurfaces.Section_3_1.eq_12_4.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_12_4.met : GbtSurfaces.Section_3_1.eq_12_4.instance).
Check (GbtSurfaces.Section_3_1_proofs.thm_3.proved : GbtSurfaces.Section_3_1.thm_3.statement).
Check (GbtSurfaces.Section_3_1_proofs.thm_3.met : GbtSurfaces.Section_3_1.thm_3.instance).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_benefits.proved : GbtSurfaces.Section_3_1.sec_3_1_benefits.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_benefits.met : GbtSurfaces.Section_3_1.sec_3_1_benefits.instance).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_any_shape_literal.refuted : ~ GbtSurfaces.Section_3_1.sec_3_1_any_shape_literal.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_any_shape_the_shape_changes.proved : GbtSurfaces.Section_3_1.sec_3_1_any_shape_the_shape_changes.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_any_shape_the_shape_changes.met : GbtSurfaces.Section_3_1.sec_3_1_any_shape_the_shape_changes.instance).
Check (GbtSurfaces.Section_3_1_proofs.alg_1.proved : GbtSurfaces.Section_3_1.alg_1.statement).
Check (GbtSurfaces.Section_3_1_proofs.alg_1.met : GbtSurfaces.Section_3_1.alg_1.instance).
Check (GbtSurfaces.Section_3_1_proofs.ex_3_1_points.proved : GbtSurfaces.Section_3_1.ex_3_1_points.statement).
Check (GbtSurfaces.Section_3_1_proofs.ex_3_1_normal.proved : GbtSurfaces.Section_3_1.ex_3_1_normal.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_13.proved : GbtSurfaces.Section_3_1.eq_13.statement).
Check (GbtSurfaces.Section_3_1_proofs.eq_13.met : GbtSurfaces.Section_3_1.eq_13.instance).
Check (GbtSurfaces.Section_3_1_proofs.ex_3_1_net.proved : GbtSurfaces.Section_3_1.ex_3_1_net.statement).
Check (GbtSurfaces.Section_3_1_proofs.ex_3_1_mesh_count.proved : GbtSurfaces.Section_3_1.ex_3_1_mesh_count.statement).
Check (GbtSurfaces.Section_3_1_proofs.ex_3_1_hull.proved : GbtSurfaces.Section_3_1.ex_3_1_hull.statement).
Check (GbtSurfaces.Section_3_1_proofs.ex_3_1_hull.met : GbtSurfaces.Section_3_1.ex_3_1_hull.instance).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_effect.proved : GbtSurfaces.Section_3_1.sec_3_1_effect.statement).
Check (GbtSurfaces.Section_3_1_proofs.sec_3_1_effect.met : GbtSurfaces.Section_3_1.sec_3_1_effect.instance).
Check (GbtSurfaces.Section_3_1_proofs.prop_3_1_translation.proved : GbtSurfaces.Section_3_1.prop_3_1_translation.statement).
Check (GbtSurfaces.Section_3_1_proofs.prop_3_1_translation.met : GbtSurfaces.Section_3_1.prop_3_1_translation.instance).
Check (GbtSurfaces.Section_3_2_printed_proofs.eq_14.proved : GbtSurfaces.Section_3_2_printed.eq_14.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.eq_14.met : GbtSurfaces.Section_3_2_printed.eq_14.instance).
Check (GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_segments.proved : GbtSurfaces.Section_3_2_printed.sec_3_2_segments.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_segments.met : GbtSurfaces.Section_3_2_printed.sec_3_2_segments.instance).
Check (GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_linear.proved : GbtSurfaces.Section_3_2_printed.sec_3_2_linear.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_linear.met : GbtSurfaces.Section_3_2_printed.sec_3_2_linear.instance).
Check (GbtSurfaces.Section_3_2_printed_proofs.prop_3_2_a.proved : GbtSurfaces.Section_3_2_printed.prop_3_2_a.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.prop_3_2_a.met : GbtSurfaces.Section_3_2_printed.prop_3_2_a.instance).
Check (GbtSurfaces.Section_3_2_printed_proofs.prop_3_2_b.proved : GbtSurfaces.Section_3_2_printed.prop_3_2_b.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.prop_3_2_b.met : GbtSurfaces.Section_3_2_printed.prop_3_2_b.instance).
Check (GbtSurfaces.Section_3_2_printed_proofs.prop_3_2_c.proved : GbtSurfaces.Section_3_2_printed.prop_3_2_c.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.prop_3_2_c.met : GbtSurfaces.Section_3_2_printed.prop_3_2_c.instance).
Check (GbtSurfaces.Section_3_2_printed_proofs.eq_15.proved : GbtSurfaces.Section_3_2_printed.eq_15.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.eq_15.met : GbtSurfaces.Section_3_2_printed.eq_15.instance).
Check (GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_fixed.proved : GbtSurfaces.Section_3_2_printed.sec_3_2_fixed.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_fixed.met : GbtSurfaces.Section_3_2_printed.sec_3_2_fixed.instance).
Check (GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_list_1.proved : GbtSurfaces.Section_3_2_printed.sec_3_2_list_1.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_list_1.met : GbtSurfaces.Section_3_2_printed.sec_3_2_list_1.instance).
Check (GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_list_2.proved : GbtSurfaces.Section_3_2_printed.sec_3_2_list_2.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_list_2.met : GbtSurfaces.Section_3_2_printed.sec_3_2_list_2.instance).
Check (GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_list_3.proved : GbtSurfaces.Section_3_2_printed.sec_3_2_list_3.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_list_3.met : GbtSurfaces.Section_3_2_printed.sec_3_2_list_3.instance).
Check (GbtSurfaces.Section_3_2_printed_proofs.alg_2_1.proved : GbtSurfaces.Section_3_2_printed.alg_2_1.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.alg_2_1.met : GbtSurfaces.Section_3_2_printed.alg_2_1.instance).
Check (GbtSurfaces.Section_3_2_printed_proofs.alg_2_2.proved : GbtSurfaces.Section_3_2_printed.alg_2_2.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.alg_2_2.met : GbtSurfaces.Section_3_2_printed.alg_2_2.instance).
Check (GbtSurfaces.Section_3_2_printed_proofs.alg_2_2_irregular.proved : GbtSurfaces.Section_3_2_printed.alg_2_2_irregular.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.alg_2_2_irregular.met : GbtSurfaces.Section_3_2_printed.alg_2_2_irregular.instance).
Check (GbtSurfaces.Section_3_2_printed_proofs.eq_16.proved : GbtSurfaces.Section_3_2_printed.eq_16.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.eq_16.met : GbtSurfaces.Section_3_2_printed.eq_16.instance).
Check (GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_corners.proved : GbtSurfaces.Section_3_2_printed.ex_3_2_corners.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_corners.met : GbtSurfaces.Section_3_2_printed.ex_3_2_corners.instance).
Check (GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_division_z_lines.proved : GbtSurfaces.Section_3_2_printed.ex_3_2_division_z_lines.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_division_Q0l.proved : GbtSurfaces.Section_3_2_printed.ex_3_2_division_Q0l.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_division_Q3l.refuted : ~ GbtSurfaces.Section_3_2_printed.ex_3_2_division_Q3l.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_division_Q3l_corrected.proved : GbtSurfaces.Section_3_2_printed.ex_3_2_division_Q3l_corrected.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_equal_parts_a.proved : GbtSurfaces.Section_3_2_printed.ex_3_2_equal_parts_a.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_equal_parts_b.proved : GbtSurfaces.Section_3_2_printed.ex_3_2_equal_parts_b.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_equal_parts_c.proved : GbtSurfaces.Section_3_2_printed.ex_3_2_equal_parts_c.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_equal_parts_d.refuted : ~ GbtSurfaces.Section_3_2_printed.ex_3_2_equal_parts_d.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_equal_parts_d_corrected.proved : GbtSurfaces.Section_3_2_printed.ex_3_2_equal_parts_d_corrected.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_interior.proved : GbtSurfaces.Section_3_2_printed.ex_3_2_interior.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_equation.refuted : ~ GbtSurfaces.Section_3_2_printed.ex_3_2_equation.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_sixteen.proved : GbtSurfaces.Section_3_2_printed.ex_3_2_sixteen.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_coplanar.proved : GbtSurfaces.Section_3_2_printed.ex_3_2_coplanar.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_noncoplanar_possible.proved : GbtSurfaces.Section_3_2_printed.ex_3_2_noncoplanar_possible.statement).
Check (GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_noncoplanar_possible.met : GbtSurfaces.Section_3_2_printed.ex_3_2_noncoplanar_possible.instance).
Check (GbtSurfaces.Section_3_2_proofs.eq_14.proved : GbtSurfaces.Section_3_2.eq_14.statement).
Check (GbtSurfaces.Section_3_2_proofs.eq_14.met : GbtSurfaces.Section_3_2.eq_14.instance).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_segments.proved : GbtSurfaces.Section_3_2.sec_3_2_segments.statement).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_segments.met : GbtSurfaces.Section_3_2.sec_3_2_segments.instance).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_linear.proved : GbtSurfaces.Section_3_2.sec_3_2_linear.statement).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_linear.met : GbtSurfaces.Section_3_2.sec_3_2_linear.instance).
Check (GbtSurfaces.Section_3_2_proofs.prop_3_2_a.proved : GbtSurfaces.Section_3_2.prop_3_2_a.statement).
Check (GbtSurfaces.Section_3_2_proofs.prop_3_2_a.met : GbtSurfaces.Section_3_2.prop_3_2_a.instance).
Check (GbtSurfaces.Section_3_2_proofs.prop_3_2_b.proved : GbtSurfaces.Section_3_2.prop_3_2_b.statement).
Check (GbtSurfaces.Section_3_2_proofs.prop_3_2_b.met : GbtSurfaces.Section_3_2.prop_3_2_b.instance).
Check (GbtSurfaces.Section_3_2_proofs.prop_3_2_c.proved : GbtSurfaces.Section_3_2.prop_3_2_c.statement).
Check (GbtSurfaces.Section_3_2_proofs.prop_3_2_c.met : GbtSurfaces.Section_3_2.prop_3_2_c.instance).
Check (GbtSurfaces.Section_3_2_proofs.eq_15.proved : GbtSurfaces.Section_3_2.eq_15.statement).
Check (GbtSurfaces.Section_3_2_proofs.eq_15.met : GbtSurfaces.Section_3_2.eq_15.instance).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_fixed.proved : GbtSurfaces.Section_3_2.sec_3_2_fixed.statement).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_fixed.met : GbtSurfaces.Section_3_2.sec_3_2_fixed.instance).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_list_1.proved : GbtSurfaces.Section_3_2.sec_3_2_list_1.statement).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_list_1.met : GbtSurfaces.Section_3_2.sec_3_2_list_1.instance).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_list_2.proved : GbtSurfaces.Section_3_2.sec_3_2_list_2.statement).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_list_2.met : GbtSurfaces.Section_3_2.sec_3_2_list_2.instance).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_list_3.proved : GbtSurfaces.Section_3_2.sec_3_2_list_3.statement).
Check (GbtSurfaces.Section_3_2_proofs.sec_3_2_list_3.met : GbtSurfaces.Section_3_2.sec_3_2_list_3.instance).
Check (GbtSurfaces.Section_3_2_proofs.alg_2_1.proved : GbtSurfaces.Section_3_2.alg_2_1.statement).
Check (GbtSurfaces.Section_3_2_proofs.alg_2_1.met : GbtSurfaces.Section_3_2.alg_2_1.instance).
Check (GbtSurfaces.Section_3_2_proofs.alg_2_2.proved : GbtSurfaces.Section_3_2.alg_2_2.statement).
Check (GbtSurfaces.Section_3_2_proofs.alg_2_2.met : GbtSurfaces.Section_3_2.alg_2_2.instance).
Check (GbtSurfaces.Section_3_2_proofs.alg_2_2_irregular.proved : GbtSurfaces.Section_3_2.alg_2_2_irregular.statement).
Check (GbtSurfaces.Section_3_2_proofs.alg_2_2_irregular.met : GbtSurfaces.Section_3_2.alg_2_2_irregular.instance).
Check (GbtSurfaces.Section_3_2_proofs.eq_16.proved : GbtSurfaces.Section_3_2.eq_16.statement).
Check (GbtSurfaces.Section_3_2_proofs.eq_16.met : GbtSurfaces.Section_3_2.eq_16.instance).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_corners.proved : GbtSurfaces.Section_3_2.ex_3_2_corners.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_corners.met : GbtSurfaces.Section_3_2.ex_3_2_corners.instance).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_division_z_lines.proved : GbtSurfaces.Section_3_2.ex_3_2_division_z_lines.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_division_Q0l.proved : GbtSurfaces.Section_3_2.ex_3_2_division_Q0l.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_division_Q3l.refuted : ~ GbtSurfaces.Section_3_2.ex_3_2_division_Q3l.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_division_Q3l_corrected.proved : GbtSurfaces.Section_3_2.ex_3_2_division_Q3l_corrected.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_a.proved : GbtSurfaces.Section_3_2.ex_3_2_equal_parts_a.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_b.proved : GbtSurfaces.Section_3_2.ex_3_2_equal_parts_b.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_c.proved : GbtSurfaces.Section_3_2.ex_3_2_equal_parts_c.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_d.refuted : ~ GbtSurfaces.Section_3_2.ex_3_2_equal_parts_d.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_d_corrected.proved : GbtSurfaces.Section_3_2.ex_3_2_equal_parts_d_corrected.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_interior.proved : GbtSurfaces.Section_3_2.ex_3_2_interior.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_equation.refuted : ~ GbtSurfaces.Section_3_2.ex_3_2_equation.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_sixteen.proved : GbtSurfaces.Section_3_2.ex_3_2_sixteen.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_coplanar.proved : GbtSurfaces.Section_3_2.ex_3_2_coplanar.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_noncoplanar_possible.proved : GbtSurfaces.Section_3_2.ex_3_2_noncoplanar_possible.statement).
Check (GbtSurfaces.Section_3_2_proofs.ex_3_2_noncoplanar_possible.met : GbtSurfaces.Section_3_2.ex_3_2_noncoplanar_possible.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_generatrix.proved : GbtSurfaces.Section_3_3_printed.sec_3_3_generatrix.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_generatrix.met : GbtSurfaces.Section_3_3_printed.sec_3_3_generatrix.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_same_degree_literal.refuted : ~ GbtSurfaces.Section_3_3_printed.sec_3_3_same_degree_literal.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_same_degree_in_general.proved : GbtSurfaces.Section_3_3_printed.sec_3_3_same_degree_in_general.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_same_degree_in_general.met : GbtSurfaces.Section_3_3_printed.sec_3_3_same_degree_in_general.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_17_0.proved : GbtSurfaces.Section_3_3_printed.eq_17_0.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_17_0.met : GbtSurfaces.Section_3_3_printed.eq_17_0.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_17_1.proved : GbtSurfaces.Section_3_3_printed.eq_17_1.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_17_1.met : GbtSurfaces.Section_3_3_printed.eq_17_1.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_condition_1.proved : GbtSurfaces.Section_3_3_printed.sec_3_3_condition_1.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_condition_1.met : GbtSurfaces.Section_3_3_printed.sec_3_3_condition_1.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_condition_2.refuted : ~ GbtSurfaces.Section_3_3_printed.sec_3_3_condition_2.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_18.refuted : ~ GbtSurfaces.Section_3_3_printed.eq_18.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_18_corrected.proved : GbtSurfaces.Section_3_3_printed.eq_18_corrected.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_18_corrected.met : GbtSurfaces.Section_3_3_printed.eq_18_corrected.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_18_true.proved : GbtSurfaces.Section_3_3_printed.eq_18_true.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_18_true.met : GbtSurfaces.Section_3_3_printed.eq_18_true.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_18_sufficient.proved : GbtSurfaces.Section_3_3_printed.eq_18_sufficient.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_18_sufficient.met : GbtSurfaces.Section_3_3_printed.eq_18_sufficient.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_18_necessary.proved : GbtSurfaces.Section_3_3_printed.eq_18_necessary.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_18_necessary.met : GbtSurfaces.Section_3_3_printed.eq_18_necessary.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_18_defect.proved : GbtSurfaces.Section_3_3_printed.eq_18_defect.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_18_defect.met : GbtSurfaces.Section_3_3_printed.eq_18_defect.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_18_tensor.proved : GbtSurfaces.Section_3_3_printed.eq_18_tensor.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_18_tensor.met : GbtSurfaces.Section_3_3_printed.eq_18_tensor.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_benefits_a.proved : GbtSurfaces.Section_3_3_printed.sec_3_3_benefits_a.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_benefits_a.met : GbtSurfaces.Section_3_3_printed.sec_3_3_benefits_a.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.prop_3_3_a.proved : GbtSurfaces.Section_3_3_printed.prop_3_3_a.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.prop_3_3_a.met : GbtSurfaces.Section_3_3_printed.prop_3_3_a.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.prop_3_3_b.proved : GbtSurfaces.Section_3_3_printed.prop_3_3_b.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.prop_3_3_b.met : GbtSurfaces.Section_3_3_printed.prop_3_3_b.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.prop_3_4_a.proved : GbtSurfaces.Section_3_3_printed.prop_3_4_a.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.prop_3_4_a.met : GbtSurfaces.Section_3_3_printed.prop_3_4_a.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.prop_3_4_a_net.proved : GbtSurfaces.Section_3_3_printed.prop_3_4_a_net.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.prop_3_4_a_net.met : GbtSurfaces.Section_3_3_printed.prop_3_4_a_net.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.prop_3_4_b.proved : GbtSurfaces.Section_3_3_printed.prop_3_4_b.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.prop_3_4_b.met : GbtSurfaces.Section_3_3_printed.prop_3_4_b.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.alg_3_a.refuted : ~ GbtSurfaces.Section_3_3_printed.alg_3_a.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.alg_3_a_corrected.proved : GbtSurfaces.Section_3_3_printed.alg_3_a_corrected.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.alg_3_a_corrected.met : GbtSurfaces.Section_3_3_printed.alg_3_a_corrected.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.alg_3_b.refuted : ~ GbtSurfaces.Section_3_3_printed.alg_3_b.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_curves.refuted : ~ GbtSurfaces.Section_3_3_printed.ex_3_3_curves.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_curves_corrected.proved : GbtSurfaces.Section_3_3_printed.ex_3_3_curves_corrected.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_curves_corrected.met : GbtSurfaces.Section_3_3_printed.ex_3_3_curves_corrected.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_19.refuted : ~ GbtSurfaces.Section_3_3_printed.eq_19.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.eq_19_tensor.refuted : ~ GbtSurfaces.Section_3_3_printed.eq_19_tensor.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_gl_0.refuted : ~ GbtSurfaces.Section_3_3_printed.ex_3_3_gl_0.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_gl_0_corrected.proved : GbtSurfaces.Section_3_3_printed.ex_3_3_gl_0_corrected.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_gl_0_corrected.met : GbtSurfaces.Section_3_3_printed.ex_3_3_gl_0_corrected.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_gl_1.refuted : ~ GbtSurfaces.Section_3_3_printed.ex_3_3_gl_1.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_gl_1_corrected.proved : GbtSurfaces.Section_3_3_printed.ex_3_3_gl_1_corrected.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_gl_1_corrected.met : GbtSurfaces.Section_3_3_printed.ex_3_3_gl_1_corrected.instance).
Check (GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_composite.proved : GbtSurfaces.Section_3_3_printed.ex_3_3_composite.statement).
Check (GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_composite.met : GbtSurfaces.Section_3_3_printed.ex_3_3_composite.instance).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_generatrix.proved : GbtSurfaces.Section_3_3.sec_3_3_generatrix.statement).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_generatrix.met : GbtSurfaces.Section_3_3.sec_3_3_generatrix.instance).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_same_degree_literal.refuted : ~ GbtSurfaces.Section_3_3.sec_3_3_same_degree_literal.statement).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_same_degree_in_general.proved : GbtSurfaces.Section_3_3.sec_3_3_same_degree_in_general.statement).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_same_degree_in_general.met : GbtSurfaces.Section_3_3.sec_3_3_same_degree_in_general.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_17_0.proved : GbtSurfaces.Section_3_3.eq_17_0.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_17_0.met : GbtSurfaces.Section_3_3.eq_17_0.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_17_1.proved : GbtSurfaces.Section_3_3.eq_17_1.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_17_1.met : GbtSurfaces.Section_3_3.eq_17_1.instance).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_1.proved : GbtSurfaces.Section_3_3.sec_3_3_condition_1.statement).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_1.met : GbtSurfaces.Section_3_3.sec_3_3_condition_1.instance).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_2.refuted : ~ GbtSurfaces.Section_3_3.sec_3_3_condition_2.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_18.refuted : ~ GbtSurfaces.Section_3_3.eq_18.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_corrected.proved : GbtSurfaces.Section_3_3.eq_18_corrected.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_corrected.met : GbtSurfaces.Section_3_3.eq_18_corrected.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_true.proved : GbtSurfaces.Section_3_3.eq_18_true.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_true.met : GbtSurfaces.Section_3_3.eq_18_true.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_sufficient.proved : GbtSurfaces.Section_3_3.eq_18_sufficient.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_sufficient.met : GbtSurfaces.Section_3_3.eq_18_sufficient.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_necessary.proved : GbtSurfaces.Section_3_3.eq_18_necessary.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_necessary.met : GbtSurfaces.Section_3_3.eq_18_necessary.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_defect.proved : GbtSurfaces.Section_3_3.eq_18_defect.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_defect.met : GbtSurfaces.Section_3_3.eq_18_defect.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_tensor.proved : GbtSurfaces.Section_3_3.eq_18_tensor.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_18_tensor.met : GbtSurfaces.Section_3_3.eq_18_tensor.instance).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_benefits_a.proved : GbtSurfaces.Section_3_3.sec_3_3_benefits_a.statement).
Check (GbtSurfaces.Section_3_3_proofs.sec_3_3_benefits_a.met : GbtSurfaces.Section_3_3.sec_3_3_benefits_a.instance).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_3_a.proved : GbtSurfaces.Section_3_3.prop_3_3_a.statement).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_3_a.met : GbtSurfaces.Section_3_3.prop_3_3_a.instance).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_3_b.proved : GbtSurfaces.Section_3_3.prop_3_3_b.statement).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_3_b.met : GbtSurfaces.Section_3_3.prop_3_3_b.instance).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_4_a.proved : GbtSurfaces.Section_3_3.prop_3_4_a.statement).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_4_a.met : GbtSurfaces.Section_3_3.prop_3_4_a.instance).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_4_a_net.proved : GbtSurfaces.Section_3_3.prop_3_4_a_net.statement).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_4_a_net.met : GbtSurfaces.Section_3_3.prop_3_4_a_net.instance).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_4_b.proved : GbtSurfaces.Section_3_3.prop_3_4_b.statement).
Check (GbtSurfaces.Section_3_3_proofs.prop_3_4_b.met : GbtSurfaces.Section_3_3.prop_3_4_b.instance).
Check (GbtSurfaces.Section_3_3_proofs.alg_3_a.refuted : ~ GbtSurfaces.Section_3_3.alg_3_a.statement).
Check (GbtSurfaces.Section_3_3_proofs.alg_3_a_corrected.proved : GbtSurfaces.Section_3_3.alg_3_a_corrected.statement).
Check (GbtSurfaces.Section_3_3_proofs.alg_3_a_corrected.met : GbtSurfaces.Section_3_3.alg_3_a_corrected.instance).
Check (GbtSurfaces.Section_3_3_proofs.alg_3_b.refuted : ~ GbtSurfaces.Section_3_3.alg_3_b.statement).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_curves.refuted : ~ GbtSurfaces.Section_3_3.ex_3_3_curves.statement).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_curves_corrected.proved : GbtSurfaces.Section_3_3.ex_3_3_curves_corrected.statement).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_curves_corrected.met : GbtSurfaces.Section_3_3.ex_3_3_curves_corrected.instance).
Check (GbtSurfaces.Section_3_3_proofs.eq_19.refuted : ~ GbtSurfaces.Section_3_3.eq_19.statement).
Check (GbtSurfaces.Section_3_3_proofs.eq_19_tensor.refuted : ~ GbtSurfaces.Section_3_3.eq_19_tensor.statement).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_0.refuted : ~ GbtSurfaces.Section_3_3.ex_3_3_gl_0.statement).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_0_corrected.proved : GbtSurfaces.Section_3_3.ex_3_3_gl_0_corrected.statement).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_0_corrected.met : GbtSurfaces.Section_3_3.ex_3_3_gl_0_corrected.instance).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_1.refuted : ~ GbtSurfaces.Section_3_3.ex_3_3_gl_1.statement).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_1_corrected.proved : GbtSurfaces.Section_3_3.ex_3_3_gl_1_corrected.statement).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_1_corrected.met : GbtSurfaces.Section_3_3.ex_3_3_gl_1_corrected.instance).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_composite.proved : GbtSurfaces.Section_3_3.ex_3_3_composite.statement).
Check (GbtSurfaces.Section_3_3_proofs.ex_3_3_composite.met : GbtSurfaces.Section_3_3.ex_3_3_composite.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_20_profile.proved : GbtSurfaces.Section_3_4_printed.eq_20_profile.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_20_profile.met : GbtSurfaces.Section_3_4_printed.eq_20_profile.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_20_trajectory.refuted : ~ GbtSurfaces.Section_3_4_printed.eq_20_trajectory.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_20_trajectory_corrected.proved : GbtSurfaces.Section_3_4_printed.eq_20_trajectory_corrected.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_20_trajectory_corrected.met : GbtSurfaces.Section_3_4_printed.eq_20_trajectory_corrected.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_21.proved : GbtSurfaces.Section_3_4_printed.eq_21.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_21.met : GbtSurfaces.Section_3_4_printed.eq_21.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_22.proved : GbtSurfaces.Section_3_4_printed.eq_22.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_22.met : GbtSurfaces.Section_3_4_printed.eq_22.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.prop_3_5.proved : GbtSurfaces.Section_3_4_printed.prop_3_5.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.prop_3_5.met : GbtSurfaces.Section_3_4_printed.prop_3_5.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.prop_3_6_1.proved : GbtSurfaces.Section_3_4_printed.prop_3_6_1.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.prop_3_6_1.met : GbtSurfaces.Section_3_4_printed.prop_3_6_1.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.prop_3_6_2.proved : GbtSurfaces.Section_3_4_printed.prop_3_6_2.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.prop_3_6_2.met : GbtSurfaces.Section_3_4_printed.prop_3_6_2.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_23.proved : GbtSurfaces.Section_3_4_printed.eq_23.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_23.met : GbtSurfaces.Section_3_4_printed.eq_23.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.thm_4_elements.refuted : ~ GbtSurfaces.Section_3_4_printed.thm_4_elements.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.thm_4_elements_corrected.proved : GbtSurfaces.Section_3_4_printed.thm_4_elements_corrected.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.thm_4_elements_corrected.met : GbtSurfaces.Section_3_4_printed.thm_4_elements_corrected.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.thm_4_parameters.proved : GbtSurfaces.Section_3_4_printed.thm_4_parameters.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.thm_4_parameters.met : GbtSurfaces.Section_3_4_printed.thm_4_parameters.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_24.proved : GbtSurfaces.Section_3_4_printed.eq_24.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_24.met : GbtSurfaces.Section_3_4_printed.eq_24.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.thm_4_unity.proved : GbtSurfaces.Section_3_4_printed.thm_4_unity.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.thm_4_unity.met : GbtSurfaces.Section_3_4_printed.thm_4_unity.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_1.proved : GbtSurfaces.Section_3_4_printed.eq_25_1.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_1.met : GbtSurfaces.Section_3_4_printed.eq_25_1.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_2_a.refuted : ~ GbtSurfaces.Section_3_4_printed.eq_25_2_a.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_2_a_corrected.proved : GbtSurfaces.Section_3_4_printed.eq_25_2_a_corrected.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_2_a_corrected.met : GbtSurfaces.Section_3_4_printed.eq_25_2_a_corrected.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_2_b.refuted : ~ GbtSurfaces.Section_3_4_printed.eq_25_2_b.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_2_b_corrected.proved : GbtSurfaces.Section_3_4_printed.eq_25_2_b_corrected.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_2_b_corrected.met : GbtSurfaces.Section_3_4_printed.eq_25_2_b_corrected.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_2_c.proved : GbtSurfaces.Section_3_4_printed.eq_25_2_c.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_2_c.met : GbtSurfaces.Section_3_4_printed.eq_25_2_c.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_3.proved : GbtSurfaces.Section_3_4_printed.eq_25_3.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_3.met : GbtSurfaces.Section_3_4_printed.eq_25_3.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_4_a.refuted : ~ GbtSurfaces.Section_3_4_printed.eq_25_4_a.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_4_a_corrected.proved : GbtSurfaces.Section_3_4_printed.eq_25_4_a_corrected.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_4_a_corrected.met : GbtSurfaces.Section_3_4_printed.eq_25_4_a_corrected.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_4_b.refuted : ~ GbtSurfaces.Section_3_4_printed.eq_25_4_b.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_4_b_corrected.proved : GbtSurfaces.Section_3_4_printed.eq_25_4_b_corrected.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_4_b_corrected.met : GbtSurfaces.Section_3_4_printed.eq_25_4_b_corrected.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_4_c.proved : GbtSurfaces.Section_3_4_printed.eq_25_4_c.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_25_4_c.met : GbtSurfaces.Section_3_4_printed.eq_25_4_c.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.thm_4_degree.refuted : ~ GbtSurfaces.Section_3_4_printed.thm_4_degree.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_features_a.proved : GbtSurfaces.Section_3_4_printed.sec_3_4_features_a.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_features_a.met : GbtSurfaces.Section_3_4_printed.sec_3_4_features_a.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_continuity_pc.proved : GbtSurfaces.Section_3_4_printed.sec_3_4_continuity_pc.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_continuity_pc.met : GbtSurfaces.Section_3_4_printed.sec_3_4_continuity_pc.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_continuity_tc.proved : GbtSurfaces.Section_3_4_printed.sec_3_4_continuity_tc.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_continuity_tc.met : GbtSurfaces.Section_3_4_printed.sec_3_4_continuity_tc.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_closed.proved : GbtSurfaces.Section_3_4_printed.sec_3_4_closed.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_closed.met : GbtSurfaces.Section_3_4_printed.sec_3_4_closed.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_revolution.proved : GbtSurfaces.Section_3_4_printed.sec_3_4_revolution.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_revolution.met : GbtSurfaces.Section_3_4_printed.sec_3_4_revolution.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_revolution_not_tensor_quarter.proved : GbtSurfaces.Section_3_4_printed.sec_3_4_revolution_not_tensor_quarter.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_revolution_not_tensor_quarter.met : GbtSurfaces.Section_3_4_printed.sec_3_4_revolution_not_tensor_quarter.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_revolution_not_tensor_cubic.proved : GbtSurfaces.Section_3_4_printed.sec_3_4_revolution_not_tensor_cubic.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_revolution_not_tensor_cubic.met : GbtSurfaces.Section_3_4_printed.sec_3_4_revolution_not_tensor_cubic.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.alg_4_a.proved : GbtSurfaces.Section_3_4_printed.alg_4_a.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.alg_4_a.met : GbtSurfaces.Section_3_4_printed.alg_4_a.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.alg_4_b.refuted : ~ GbtSurfaces.Section_3_4_printed.alg_4_b.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.eq_26.proved : GbtSurfaces.Section_3_4_printed.eq_26.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.ex_3_4_scaling.proved : GbtSurfaces.Section_3_4_printed.ex_3_4_scaling.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.ex_3_4_scaling.met : GbtSurfaces.Section_3_4_printed.ex_3_4_scaling.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.fig_16_lambda_between_the_panels.proved : GbtSurfaces.Section_3_4_printed.fig_16_lambda_between_the_panels.statement).
Check (GbtSurfaces.Section_3_4_printed_proofs.fig_16_lambda_between_the_panels.met : GbtSurfaces.Section_3_4_printed.fig_16_lambda_between_the_panels.instance).
Check (GbtSurfaces.Section_3_4_printed_proofs.fig_16_lambda_between_the_surfaces.refuted : ~ GbtSurfaces.Section_3_4_printed.fig_16_lambda_between_the_surfaces.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_20_profile.proved : GbtSurfaces.Section_3_4.eq_20_profile.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_20_profile.met : GbtSurfaces.Section_3_4.eq_20_profile.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_20_trajectory.refuted : ~ GbtSurfaces.Section_3_4.eq_20_trajectory.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_20_trajectory_corrected.proved : GbtSurfaces.Section_3_4.eq_20_trajectory_corrected.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_20_trajectory_corrected.met : GbtSurfaces.Section_3_4.eq_20_trajectory_corrected.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_21.proved : GbtSurfaces.Section_3_4.eq_21.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_21.met : GbtSurfaces.Section_3_4.eq_21.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_22.proved : GbtSurfaces.Section_3_4.eq_22.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_22.met : GbtSurfaces.Section_3_4.eq_22.instance).
Check (GbtSurfaces.Section_3_4_proofs.prop_3_5.proved : GbtSurfaces.Section_3_4.prop_3_5.statement).
Check (GbtSurfaces.Section_3_4_proofs.prop_3_5.met : GbtSurfaces.Section_3_4.prop_3_5.instance).
Check (GbtSurfaces.Section_3_4_proofs.prop_3_6_1.proved : GbtSurfaces.Section_3_4.prop_3_6_1.statement).
Check (GbtSurfaces.Section_3_4_proofs.prop_3_6_1.met : GbtSurfaces.Section_3_4.prop_3_6_1.instance).
Check (GbtSurfaces.Section_3_4_proofs.prop_3_6_2.proved : GbtSurfaces.Section_3_4.prop_3_6_2.statement).
Check (GbtSurfaces.Section_3_4_proofs.prop_3_6_2.met : GbtSurfaces.Section_3_4.prop_3_6_2.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_23.proved : GbtSurfaces.Section_3_4.eq_23.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_23.met : GbtSurfaces.Section_3_4.eq_23.instance).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_elements.refuted : ~ GbtSurfaces.Section_3_4.thm_4_elements.statement).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_elements_corrected.proved : GbtSurfaces.Section_3_4.thm_4_elements_corrected.statement).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_elements_corrected.met : GbtSurfaces.Section_3_4.thm_4_elements_corrected.instance).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_parameters.proved : GbtSurfaces.Section_3_4.thm_4_parameters.statement).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_parameters.met : GbtSurfaces.Section_3_4.thm_4_parameters.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_24.proved : GbtSurfaces.Section_3_4.eq_24.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_24.met : GbtSurfaces.Section_3_4.eq_24.instance).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_unity.proved : GbtSurfaces.Section_3_4.thm_4_unity.statement).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_unity.met : GbtSurfaces.Section_3_4.thm_4_unity.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_1.proved : GbtSurfaces.Section_3_4.eq_25_1.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_1.met : GbtSurfaces.Section_3_4.eq_25_1.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_2_a.refuted : ~ GbtSurfaces.Section_3_4.eq_25_2_a.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_2_a_corrected.proved : GbtSurfaces.Section_3_4.eq_25_2_a_corrected.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_2_a_corrected.met : GbtSurfaces.Section_3_4.eq_25_2_a_corrected.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_2_b.refuted : ~ GbtSurfaces.Section_3_4.eq_25_2_b.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_2_b_corrected.proved : GbtSurfaces.Section_3_4.eq_25_2_b_corrected.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_2_b_corrected.met : GbtSurfaces.Section_3_4.eq_25_2_b_corrected.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_2_c.proved : GbtSurfaces.Section_3_4.eq_25_2_c.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_2_c.met : GbtSurfaces.Section_3_4.eq_25_2_c.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_3.proved : GbtSurfaces.Section_3_4.eq_25_3.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_3.met : GbtSurfaces.Section_3_4.eq_25_3.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_a.refuted : ~ GbtSurfaces.Section_3_4.eq_25_4_a.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_a_corrected.proved : GbtSurfaces.Section_3_4.eq_25_4_a_corrected.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_a_corrected.met : GbtSurfaces.Section_3_4.eq_25_4_a_corrected.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_b.refuted : ~ GbtSurfaces.Section_3_4.eq_25_4_b.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_b_corrected.proved : GbtSurfaces.Section_3_4.eq_25_4_b_corrected.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_b_corrected.met : GbtSurfaces.Section_3_4.eq_25_4_b_corrected.instance).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_c.proved : GbtSurfaces.Section_3_4.eq_25_4_c.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_25_4_c.met : GbtSurfaces.Section_3_4.eq_25_4_c.instance).
Check (GbtSurfaces.Section_3_4_proofs.thm_4_degree.refuted : ~ GbtSurfaces.Section_3_4.thm_4_degree.statement).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_features_a.proved : GbtSurfaces.Section_3_4.sec_3_4_features_a.statement).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_features_a.met : GbtSurfaces.Section_3_4.sec_3_4_features_a.instance).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_pc.proved : GbtSurfaces.Section_3_4.sec_3_4_continuity_pc.statement).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_pc.met : GbtSurfaces.Section_3_4.sec_3_4_continuity_pc.instance).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_tc.proved : GbtSurfaces.Section_3_4.sec_3_4_continuity_tc.statement).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_tc.met : GbtSurfaces.Section_3_4.sec_3_4_continuity_tc.instance).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_closed.proved : GbtSurfaces.Section_3_4.sec_3_4_closed.statement).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_closed.met : GbtSurfaces.Section_3_4.sec_3_4_closed.instance).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution.proved : GbtSurfaces.Section_3_4.sec_3_4_revolution.statement).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution.met : GbtSurfaces.Section_3_4.sec_3_4_revolution.instance).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_quarter.proved : GbtSurfaces.Section_3_4.sec_3_4_revolution_not_tensor_quarter.statement).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_quarter.met : GbtSurfaces.Section_3_4.sec_3_4_revolution_not_tensor_quarter.instance).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_cubic.proved : GbtSurfaces.Section_3_4.sec_3_4_revolution_not_tensor_cubic.statement).
Check (GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_cubic.met : GbtSurfaces.Section_3_4.sec_3_4_revolution_not_tensor_cubic.instance).
Check (GbtSurfaces.Section_3_4_proofs.alg_4_a.proved : GbtSurfaces.Section_3_4.alg_4_a.statement).
Check (GbtSurfaces.Section_3_4_proofs.alg_4_a.met : GbtSurfaces.Section_3_4.alg_4_a.instance).
Check (GbtSurfaces.Section_3_4_proofs.alg_4_b.refuted : ~ GbtSurfaces.Section_3_4.alg_4_b.statement).
Check (GbtSurfaces.Section_3_4_proofs.eq_26.proved : GbtSurfaces.Section_3_4.eq_26.statement).
Check (GbtSurfaces.Section_3_4_proofs.ex_3_4_scaling.proved : GbtSurfaces.Section_3_4.ex_3_4_scaling.statement).
Check (GbtSurfaces.Section_3_4_proofs.ex_3_4_scaling.met : GbtSurfaces.Section_3_4.ex_3_4_scaling.instance).
Check (GbtSurfaces.Section_3_4_proofs.fig_16_lambda_between_the_panels.proved : GbtSurfaces.Section_3_4.fig_16_lambda_between_the_panels.statement).
Check (GbtSurfaces.Section_3_4_proofs.fig_16_lambda_between_the_panels.met : GbtSurfaces.Section_3_4.fig_16_lambda_between_the_panels.instance).
Check (GbtSurfaces.Section_3_4_proofs.fig_16_lambda_between_the_surfaces.refuted : ~ GbtSurfaces.Section_3_4.fig_16_lambda_between_the_surfaces.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.eq_27.proved : GbtSurfaces.Section_3_5_printed.eq_27.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.eq_27.met : GbtSurfaces.Section_3_5_printed.eq_27.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.sec_3_5_categories.proved : GbtSurfaces.Section_3_5_printed.sec_3_5_categories.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.sec_3_5_not_expressible_sine.proved : GbtSurfaces.Section_3_5_printed.sec_3_5_not_expressible_sine.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.sec_3_5_not_expressible_sine.met : GbtSurfaces.Section_3_5_printed.sec_3_5_not_expressible_sine.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.eq_29.proved : GbtSurfaces.Section_3_5_printed.eq_29.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.eq_29.met : GbtSurfaces.Section_3_5_printed.eq_29.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.eq_30.proved : GbtSurfaces.Section_3_5_printed.eq_30.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.eq_30.met : GbtSurfaces.Section_3_5_printed.eq_30.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.eq_31_2.proved : GbtSurfaces.Section_3_5_printed.eq_31_2.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.eq_31_2.met : GbtSurfaces.Section_3_5_printed.eq_31_2.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.eq_31_3.proved : GbtSurfaces.Section_3_5_printed.eq_31_3.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.eq_31_3.met : GbtSurfaces.Section_3_5_printed.eq_31_3.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.eq_31_4.proved : GbtSurfaces.Section_3_5_printed.eq_31_4.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.eq_31_4.met : GbtSurfaces.Section_3_5_printed.eq_31_4.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.eq_31_5.proved : GbtSurfaces.Section_3_5_printed.eq_31_5.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.eq_31_5.met : GbtSurfaces.Section_3_5_printed.eq_31_5.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.prop_3_7_1_a.proved : GbtSurfaces.Section_3_5_printed.prop_3_7_1_a.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.prop_3_7_1_a.met : GbtSurfaces.Section_3_5_printed.prop_3_7_1_a.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.prop_3_7_2a.proved : GbtSurfaces.Section_3_5_printed.prop_3_7_2a.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.prop_3_7_2a.met : GbtSurfaces.Section_3_5_printed.prop_3_7_2a.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.prop_3_7_2b.proved : GbtSurfaces.Section_3_5_printed.prop_3_7_2b.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.prop_3_7_2b.met : GbtSurfaces.Section_3_5_printed.prop_3_7_2b.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.alg_5_a.proved : GbtSurfaces.Section_3_5_printed.alg_5_a.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.alg_5_a.met : GbtSurfaces.Section_3_5_printed.alg_5_a.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.alg_5_b.refuted : ~ GbtSurfaces.Section_3_5_printed.alg_5_b.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_sections.proved : GbtSurfaces.Section_3_5_printed.ex_3_5_sections.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_trajectories.proved : GbtSurfaces.Section_3_5_printed.ex_3_5_trajectories.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c1_sections.proved : GbtSurfaces.Section_3_5_printed.ex_3_5_c1_sections.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c1_sections.met : GbtSurfaces.Section_3_5_printed.ex_3_5_c1_sections.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c1_trajectories.proved : GbtSurfaces.Section_3_5_printed.ex_3_5_c1_trajectories.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c1_trajectories.met : GbtSurfaces.Section_3_5_printed.ex_3_5_c1_trajectories.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c2_sections.proved : GbtSurfaces.Section_3_5_printed.ex_3_5_c2_sections.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c2_sections.met : GbtSurfaces.Section_3_5_printed.ex_3_5_c2_sections.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c2_trajectories.refuted : ~ GbtSurfaces.Section_3_5_printed.ex_3_5_c2_trajectories.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c2_trajectories_true.proved : GbtSurfaces.Section_3_5_printed.ex_3_5_c2_trajectories_true.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c2_trajectories_true.met : GbtSurfaces.Section_3_5_printed.ex_3_5_c2_trajectories_true.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c2_trajectories_moved.proved : GbtSurfaces.Section_3_5_printed.ex_3_5_c2_trajectories_moved.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c2_trajectories_moved.met : GbtSurfaces.Section_3_5_printed.ex_3_5_c2_trajectories_moved.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_contiguous_each_with_its_own.refuted : ~ GbtSurfaces.Section_3_5_printed.ex_3_5_contiguous_each_with_its_own.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_contiguous_one_trajectory.proved : GbtSurfaces.Section_3_5_printed.ex_3_5_contiguous_one_trajectory.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_contiguous_one_trajectory.met : GbtSurfaces.Section_3_5_printed.ex_3_5_contiguous_one_trajectory.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_contiguous_one_section.proved : GbtSurfaces.Section_3_5_printed.ex_3_5_contiguous_one_section.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_contiguous_one_section.met : GbtSurfaces.Section_3_5_printed.ex_3_5_contiguous_one_section.instance).
Check (GbtSurfaces.Section_3_5_printed_proofs.sec_3_5_unnecessary.proved : GbtSurfaces.Section_3_5_printed.sec_3_5_unnecessary.statement).
Check (GbtSurfaces.Section_3_5_printed_proofs.sec_3_5_unnecessary.met : GbtSurfaces.Section_3_5_printed.sec_3_5_unnecessary.instance).
Check (GbtSurfaces.Section_3_5_proofs.eq_27.proved : GbtSurfaces.Section_3_5.eq_27.statement).
Check (GbtSurfaces.Section_3_5_proofs.eq_27.met : GbtSurfaces.Section_3_5.eq_27.instance).
Check (GbtSurfaces.Section_3_5_proofs.sec_3_5_categories.proved : GbtSurfaces.Section_3_5.sec_3_5_categories.statement).
Check (GbtSurfaces.Section_3_5_proofs.sec_3_5_not_expressible_sine.proved : GbtSurfaces.Section_3_5.sec_3_5_not_expressible_sine.statement).
Check (GbtSurfaces.Section_3_5_proofs.sec_3_5_not_expressible_sine.met : GbtSurfaces.Section_3_5.sec_3_5_not_expressible_sine.instance).
Check (GbtSurfaces.Section_3_5_proofs.eq_29.proved : GbtSurfaces.Section_3_5.eq_29.statement).
Check (GbtSurfaces.Section_3_5_proofs.eq_29.met : GbtSurfaces.Section_3_5.eq_29.instance).
Check (GbtSurfaces.Section_3_5_proofs.eq_30.proved : GbtSurfaces.Section_3_5.eq_30.statement).
Check (GbtSurfaces.Section_3_5_proofs.eq_30.met : GbtSurfaces.Section_3_5.eq_30.instance).
Check (GbtSurfaces.Section_3_5_proofs.eq_31_2.proved : GbtSurfaces.Section_3_5.eq_31_2.statement).
Check (GbtSurfaces.Section_3_5_proofs.eq_31_2.met : GbtSurfaces.Section_3_5.eq_31_2.instance).
Check (GbtSurfaces.Section_3_5_proofs.eq_31_3.proved : GbtSurfaces.Section_3_5.eq_31_3.statement).
Check (GbtSurfaces.Section_3_5_proofs.eq_31_3.met : GbtSurfaces.Section_3_5.eq_31_3.instance).
Check (GbtSurfaces.Section_3_5_proofs.eq_31_4.proved : GbtSurfaces.Section_3_5.eq_31_4.statement).
Check (GbtSurfaces.Section_3_5_proofs.eq_31_4.met : GbtSurfaces.Section_3_5.eq_31_4.instance).
Check (GbtSurfaces.Section_3_5_proofs.eq_31_5.proved : GbtSurfaces.Section_3_5.eq_31_5.statement).
Check (GbtSurfaces.Section_3_5_proofs.eq_31_5.met : GbtSurfaces.Section_3_5.eq_31_5.instance).
Check (GbtSurfaces.Section_3_5_proofs.prop_3_7_1_a.proved : GbtSurfaces.Section_3_5.prop_3_7_1_a.statement).
Check (GbtSurfaces.Section_3_5_proofs.prop_3_7_1_a.met : GbtSurfaces.Section_3_5.prop_3_7_1_a.instance).
Check (GbtSurfaces.Section_3_5_proofs.prop_3_7_2a.proved : GbtSurfaces.Section_3_5.prop_3_7_2a.statement).
Check (GbtSurfaces.Section_3_5_proofs.prop_3_7_2a.met : GbtSurfaces.Section_3_5.prop_3_7_2a.instance).
Check (GbtSurfaces.Section_3_5_proofs.prop_3_7_2b.proved : GbtSurfaces.Section_3_5.prop_3_7_2b.statement).
Check (GbtSurfaces.Section_3_5_proofs.prop_3_7_2b.met : GbtSurfaces.Section_3_5.prop_3_7_2b.instance).
Check (GbtSurfaces.Section_3_5_proofs.alg_5_a.proved : GbtSurfaces.Section_3_5.alg_5_a.statement).
Check (GbtSurfaces.Section_3_5_proofs.alg_5_a.met : GbtSurfaces.Section_3_5.alg_5_a.instance).
Check (GbtSurfaces.Section_3_5_proofs.alg_5_b.refuted : ~ GbtSurfaces.Section_3_5.alg_5_b.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_sections.proved : GbtSurfaces.Section_3_5.ex_3_5_sections.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_trajectories.proved : GbtSurfaces.Section_3_5.ex_3_5_trajectories.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_sections.proved : GbtSurfaces.Section_3_5.ex_3_5_c1_sections.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_sections.met : GbtSurfaces.Section_3_5.ex_3_5_c1_sections.instance).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_trajectories.proved : GbtSurfaces.Section_3_5.ex_3_5_c1_trajectories.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_trajectories.met : GbtSurfaces.Section_3_5.ex_3_5_c1_trajectories.instance).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_sections.proved : GbtSurfaces.Section_3_5.ex_3_5_c2_sections.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_sections.met : GbtSurfaces.Section_3_5.ex_3_5_c2_sections.instance).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories.refuted : ~ GbtSurfaces.Section_3_5.ex_3_5_c2_trajectories.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories_true.proved : GbtSurfaces.Section_3_5.ex_3_5_c2_trajectories_true.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories_true.met : GbtSurfaces.Section_3_5.ex_3_5_c2_trajectories_true.instance).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories_moved.proved : GbtSurfaces.Section_3_5.ex_3_5_c2_trajectories_moved.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories_moved.met : GbtSurfaces.Section_3_5.ex_3_5_c2_trajectories_moved.instance).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_each_with_its_own.refuted : ~ GbtSurfaces.Section_3_5.ex_3_5_contiguous_each_with_its_own.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_trajectory.proved : GbtSurfaces.Section_3_5.ex_3_5_contiguous_one_trajectory.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_trajectory.met : GbtSurfaces.Section_3_5.ex_3_5_contiguous_one_trajectory.instance).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_section.proved : GbtSurfaces.Section_3_5.ex_3_5_contiguous_one_section.statement).
Check (GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_section.met : GbtSurfaces.Section_3_5.ex_3_5_contiguous_one_section.instance).
Check (GbtSurfaces.Section_3_5_proofs.sec_3_5_unnecessary.proved : GbtSurfaces.Section_3_5.sec_3_5_unnecessary.statement).
Check (GbtSurfaces.Section_3_5_proofs.sec_3_5_unnecessary.met : GbtSurfaces.Section_3_5.sec_3_5_unnecessary.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.eq_32_matrix.refuted : ~ GbtSurfaces.Section_3_6_printed.eq_32_matrix.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.eq_32_matrix_corrected.proved : GbtSurfaces.Section_3_6_printed.eq_32_matrix_corrected.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.eq_32_matrix_corrected.met : GbtSurfaces.Section_3_6_printed.eq_32_matrix_corrected.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.eq_32_components.proved : GbtSurfaces.Section_3_6_printed.eq_32_components.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.eq_32_components.met : GbtSurfaces.Section_3_6_printed.eq_32_components.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_rounding_rational.proved : GbtSurfaces.Section_3_6_printed.sec_3_6_rounding_rational.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_rounding_rational.met : GbtSurfaces.Section_3_6_printed.sec_3_6_rounding_rational.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_revolving.proved : GbtSurfaces.Section_3_6_printed.sec_3_6_revolving.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_revolving.met : GbtSurfaces.Section_3_6_printed.sec_3_6_revolving.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_plane_generating_line.proved : GbtSurfaces.Section_3_6_printed.sec_3_6_plane_generating_line.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_plane_generating_line.met : GbtSurfaces.Section_3_6_printed.sec_3_6_plane_generating_line.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_plane_surface.refuted : ~ GbtSurfaces.Section_3_6_printed.sec_3_6_plane_surface.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_c1c2.proved : GbtSurfaces.Section_3_6_printed.sec_3_6_c1c2.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_c1c2.met : GbtSurfaces.Section_3_6_printed.sec_3_6_c1c2.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.eq_33_T.proved : GbtSurfaces.Section_3_6_printed.eq_33_T.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.eq_33_T.met : GbtSurfaces.Section_3_6_printed.eq_33_T.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.eq_33_Ttilde.proved : GbtSurfaces.Section_3_6_printed.eq_33_Ttilde.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.eq_33_Ttilde.met : GbtSurfaces.Section_3_6_printed.eq_33_Ttilde.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.eq_33_circle.proved : GbtSurfaces.Section_3_6_printed.eq_33_circle.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.eq_33_circle.met : GbtSurfaces.Section_3_6_printed.eq_33_circle.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.thm_6_symmetric.proved : GbtSurfaces.Section_3_6_printed.thm_6_symmetric.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.thm_6_symmetric.met : GbtSurfaces.Section_3_6_printed.thm_6_symmetric.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.thm_6_complete.proved : GbtSurfaces.Section_3_6_printed.thm_6_complete.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.thm_6_complete.met : GbtSurfaces.Section_3_6_printed.thm_6_complete.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.eq_34.proved : GbtSurfaces.Section_3_6_printed.eq_34.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.eq_34.met : GbtSurfaces.Section_3_6_printed.eq_34.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_other_axes.proved : GbtSurfaces.Section_3_6_printed.sec_3_6_other_axes.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_other_axes.met : GbtSurfaces.Section_3_6_printed.sec_3_6_other_axes.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.prop_3_8_a_linear.proved : GbtSurfaces.Section_3_6_printed.prop_3_8_a_linear.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.prop_3_8_a_linear.met : GbtSurfaces.Section_3_6_printed.prop_3_8_a_linear.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.prop_3_8_a_true.proved : GbtSurfaces.Section_3_6_printed.prop_3_8_a_true.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.prop_3_8_a_true.met : GbtSurfaces.Section_3_6_printed.prop_3_8_a_true.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.prop_3_8_b.refuted : ~ GbtSurfaces.Section_3_6_printed.prop_3_8_b.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.prop_3_8_b_true.proved : GbtSurfaces.Section_3_6_printed.prop_3_8_b_true.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.prop_3_8_b_true.met : GbtSurfaces.Section_3_6_printed.prop_3_8_b_true.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.prop_3_8_b_exact.proved : GbtSurfaces.Section_3_6_printed.prop_3_8_b_exact.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.prop_3_8_b_exact.met : GbtSurfaces.Section_3_6_printed.prop_3_8_b_exact.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.prop_3_9_a_composite_line.proved : GbtSurfaces.Section_3_6_printed.prop_3_9_a_composite_line.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.prop_3_9_a_composite_line.met : GbtSurfaces.Section_3_6_printed.prop_3_9_a_composite_line.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.prop_3_9_a_one_segment.refuted : ~ GbtSurfaces.Section_3_6_printed.prop_3_9_a_one_segment.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.prop_3_9_b.proved : GbtSurfaces.Section_3_6_printed.prop_3_9_b.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.prop_3_9_b.met : GbtSurfaces.Section_3_6_printed.prop_3_9_b.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.alg_6.proved : GbtSurfaces.Section_3_6_printed.alg_6.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.alg_6.met : GbtSurfaces.Section_3_6_printed.alg_6.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.eq_35.proved : GbtSurfaces.Section_3_6_printed.eq_35.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.ex_3_6_curve.proved : GbtSurfaces.Section_3_6_printed.ex_3_6_curve.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.ex_3_6_curve.met : GbtSurfaces.Section_3_6_printed.ex_3_6_curve.instance).
Check (GbtSurfaces.Section_3_6_printed_proofs.eq_36.proved : GbtSurfaces.Section_3_6_printed.eq_36.statement).
Check (GbtSurfaces.Section_3_6_printed_proofs.eq_36.met : GbtSurfaces.Section_3_6_printed.eq_36.instance).
Check (GbtSurfaces.Section_3_6_proofs.eq_32_matrix.refuted : ~ GbtSurfaces.Section_3_6.eq_32_matrix.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_32_matrix_corrected.proved : GbtSurfaces.Section_3_6.eq_32_matrix_corrected.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_32_matrix_corrected.met : GbtSurfaces.Section_3_6.eq_32_matrix_corrected.instance).
Check (GbtSurfaces.Section_3_6_proofs.eq_32_components.proved : GbtSurfaces.Section_3_6.eq_32_components.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_32_components.met : GbtSurfaces.Section_3_6.eq_32_components.instance).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_rounding_rational.proved : GbtSurfaces.Section_3_6.sec_3_6_rounding_rational.statement).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_rounding_rational.met : GbtSurfaces.Section_3_6.sec_3_6_rounding_rational.instance).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_revolving.proved : GbtSurfaces.Section_3_6.sec_3_6_revolving.statement).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_revolving.met : GbtSurfaces.Section_3_6.sec_3_6_revolving.instance).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_plane_generating_line.proved : GbtSurfaces.Section_3_6.sec_3_6_plane_generating_line.statement).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_plane_generating_line.met : GbtSurfaces.Section_3_6.sec_3_6_plane_generating_line.instance).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_plane_surface.refuted : ~ GbtSurfaces.Section_3_6.sec_3_6_plane_surface.statement).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_c1c2.proved : GbtSurfaces.Section_3_6.sec_3_6_c1c2.statement).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_c1c2.met : GbtSurfaces.Section_3_6.sec_3_6_c1c2.instance).
Check (GbtSurfaces.Section_3_6_proofs.eq_33_T.proved : GbtSurfaces.Section_3_6.eq_33_T.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_33_T.met : GbtSurfaces.Section_3_6.eq_33_T.instance).
Check (GbtSurfaces.Section_3_6_proofs.eq_33_Ttilde.proved : GbtSurfaces.Section_3_6.eq_33_Ttilde.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_33_Ttilde.met : GbtSurfaces.Section_3_6.eq_33_Ttilde.instance).
Check (GbtSurfaces.Section_3_6_proofs.eq_33_circle.proved : GbtSurfaces.Section_3_6.eq_33_circle.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_33_circle.met : GbtSurfaces.Section_3_6.eq_33_circle.instance).
Check (GbtSurfaces.Section_3_6_proofs.thm_6_symmetric.proved : GbtSurfaces.Section_3_6.thm_6_symmetric.statement).
Check (GbtSurfaces.Section_3_6_proofs.thm_6_symmetric.met : GbtSurfaces.Section_3_6.thm_6_symmetric.instance).
Check (GbtSurfaces.Section_3_6_proofs.thm_6_complete.proved : GbtSurfaces.Section_3_6.thm_6_complete.statement).
Check (GbtSurfaces.Section_3_6_proofs.thm_6_complete.met : GbtSurfaces.Section_3_6.thm_6_complete.instance).
Check (GbtSurfaces.Section_3_6_proofs.eq_34.proved : GbtSurfaces.Section_3_6.eq_34.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_34.met : GbtSurfaces.Section_3_6.eq_34.instance).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_other_axes.proved : GbtSurfaces.Section_3_6.sec_3_6_other_axes.statement).
Check (GbtSurfaces.Section_3_6_proofs.sec_3_6_other_axes.met : GbtSurfaces.Section_3_6.sec_3_6_other_axes.instance).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_a_linear.proved : GbtSurfaces.Section_3_6.prop_3_8_a_linear.statement).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_a_linear.met : GbtSurfaces.Section_3_6.prop_3_8_a_linear.instance).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_a_true.proved : GbtSurfaces.Section_3_6.prop_3_8_a_true.statement).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_a_true.met : GbtSurfaces.Section_3_6.prop_3_8_a_true.instance).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_b.refuted : ~ GbtSurfaces.Section_3_6.prop_3_8_b.statement).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_b_true.proved : GbtSurfaces.Section_3_6.prop_3_8_b_true.statement).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_b_true.met : GbtSurfaces.Section_3_6.prop_3_8_b_true.instance).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_b_exact.proved : GbtSurfaces.Section_3_6.prop_3_8_b_exact.statement).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_8_b_exact.met : GbtSurfaces.Section_3_6.prop_3_8_b_exact.instance).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_9_a_composite_line.proved : GbtSurfaces.Section_3_6.prop_3_9_a_composite_line.statement).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_9_a_composite_line.met : GbtSurfaces.Section_3_6.prop_3_9_a_composite_line.instance).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_9_a_one_segment.refuted : ~ GbtSurfaces.Section_3_6.prop_3_9_a_one_segment.statement).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_9_b.proved : GbtSurfaces.Section_3_6.prop_3_9_b.statement).
Check (GbtSurfaces.Section_3_6_proofs.prop_3_9_b.met : GbtSurfaces.Section_3_6.prop_3_9_b.instance).
Check (GbtSurfaces.Section_3_6_proofs.alg_6.proved : GbtSurfaces.Section_3_6.alg_6.statement).
Check (GbtSurfaces.Section_3_6_proofs.alg_6.met : GbtSurfaces.Section_3_6.alg_6.instance).
Check (GbtSurfaces.Section_3_6_proofs.eq_35.proved : GbtSurfaces.Section_3_6.eq_35.statement).
Check (GbtSurfaces.Section_3_6_proofs.ex_3_6_curve.proved : GbtSurfaces.Section_3_6.ex_3_6_curve.statement).
Check (GbtSurfaces.Section_3_6_proofs.ex_3_6_curve.met : GbtSurfaces.Section_3_6.ex_3_6_curve.instance).
Check (GbtSurfaces.Section_3_6_proofs.eq_36.proved : GbtSurfaces.Section_3_6.eq_36.statement).
Check (GbtSurfaces.Section_3_6_proofs.eq_36.met : GbtSurfaces.Section_3_6.eq_36.instance).
Check (GbtSurfaces.Section_4_printed_proofs.abs_features_the_features_of_Sect__2_2.proved : GbtSurfaces.Section_4_printed.abs_features_the_features_of_Sect__2_2.statement).
Check (GbtSurfaces.Section_4_printed_proofs.abs_features_the_features_of_Sect__2_2.met : GbtSurfaces.Section_4_printed.abs_features_the_features_of_Sect__2_2.instance).
Check (GbtSurfaces.Section_4_printed_proofs.abs_features_every_feature.refuted : ~ GbtSurfaces.Section_4_printed.abs_features_every_feature.statement).
Check (GbtSurfaces.Section_4_printed_proofs.sec_4_six_tensor_with_rotation_surfaces.refuted : ~ GbtSurfaces.Section_4_printed.sec_4_six_tensor_with_rotation_surfaces.statement).
Check (GbtSurfaces.Section_4_printed_proofs.sec_4_six_tensor_without.proved : GbtSurfaces.Section_4_printed.sec_4_six_tensor_without.statement).
Check (GbtSurfaces.Section_4_printed_proofs.sec_4_six_tensor_without.met : GbtSurfaces.Section_4_printed.sec_4_six_tensor_without.instance).
Check (GbtSurfaces.Section_4_printed_proofs.sec_4_composite_by_the_printed_conditions.refuted : ~ GbtSurfaces.Section_4_printed.sec_4_composite_by_the_printed_conditions.statement).
Check (GbtSurfaces.Section_4_printed_proofs.sec_4_composite_there_are_such_compositions.proved : GbtSurfaces.Section_4_printed.sec_4_composite_there_are_such_compositions.statement).
Check (GbtSurfaces.Section_4_printed_proofs.sec_4_composite_there_are_such_compositions.met : GbtSurfaces.Section_4_printed.sec_4_composite_there_are_such_compositions.instance).
Check (GbtSurfaces.Section_4_printed_proofs.sec_4_tensor.proved : GbtSurfaces.Section_4_printed.sec_4_tensor.statement).
Check (GbtSurfaces.Section_4_printed_proofs.sec_4_tensor.met : GbtSurfaces.Section_4_printed.sec_4_tensor.instance).
Check (GbtSurfaces.Section_4_printed_proofs.sec_4_convex_hull.proved : GbtSurfaces.Section_4_printed.sec_4_convex_hull.statement).
Check (GbtSurfaces.Section_4_proofs.abs_features_the_features_of_Sect__2_2.proved : GbtSurfaces.Section_4.abs_features_the_features_of_Sect__2_2.statement).
Check (GbtSurfaces.Section_4_proofs.abs_features_the_features_of_Sect__2_2.met : GbtSurfaces.Section_4.abs_features_the_features_of_Sect__2_2.instance).
Check (GbtSurfaces.Section_4_proofs.abs_features_every_feature.refuted : ~ GbtSurfaces.Section_4.abs_features_every_feature.statement).
Check (GbtSurfaces.Section_4_proofs.sec_4_six_tensor_with_rotation_surfaces.refuted : ~ GbtSurfaces.Section_4.sec_4_six_tensor_with_rotation_surfaces.statement).
Check (GbtSurfaces.Section_4_proofs.sec_4_six_tensor_without.proved : GbtSurfaces.Section_4.sec_4_six_tensor_without.statement).
Check (GbtSurfaces.Section_4_proofs.sec_4_six_tensor_without.met : GbtSurfaces.Section_4.sec_4_six_tensor_without.instance).
Check (GbtSurfaces.Section_4_proofs.sec_4_composite_by_the_printed_conditions.refuted : ~ GbtSurfaces.Section_4.sec_4_composite_by_the_printed_conditions.statement).
Check (GbtSurfaces.Section_4_proofs.sec_4_composite_there_are_such_compositions.proved : GbtSurfaces.Section_4.sec_4_composite_there_are_such_compositions.statement).
Check (GbtSurfaces.Section_4_proofs.sec_4_composite_there_are_such_compositions.met : GbtSurfaces.Section_4.sec_4_composite_there_are_such_compositions.instance).
Check (GbtSurfaces.Section_4_proofs.sec_4_tensor.proved : GbtSurfaces.Section_4.sec_4_tensor.statement).
Check (GbtSurfaces.Section_4_proofs.sec_4_tensor.met : GbtSurfaces.Section_4.sec_4_tensor.instance).
Check (GbtSurfaces.Section_4_proofs.sec_4_convex_hull.proved : GbtSurfaces.Section_4.sec_4_convex_hull.statement).
Definition all_theorems : True :=
let _ := GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_a.proved in
let _ := GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_a.met in
let _ := GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_b_name.proved in
let _ := GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_b_name.met in
let _ := GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_b_basis.refuted in
let _ := GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_order_2.proved in
let _ := GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_order_2.met in
let _ := GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_cubic.proved in
let _ := GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_cubic.met in
let _ := GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_all.proved in
let _ := GbtSurfaces.Part_Abstract_printed_proofs.abs_basis_all.met in
let _ := GbtSurfaces.Part_Abstract_printed_proofs.abs_continuity_a.proved in
let _ := GbtSurfaces.Part_Abstract_printed_proofs.abs_continuity_a.met in
let _ := GbtSurfaces.Part_Abstract_printed_proofs.abs_continuity_rows.proved in
let _ := GbtSurfaces.Part_Abstract_printed_proofs.abs_continuity_rows.met in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_a.proved in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_a.met in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_b_name.proved in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_b_name.met in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_b_basis.refuted in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_order_2.proved in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_order_2.met in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_cubic.proved in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_cubic.met in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_all.proved in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_basis_all.met in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_continuity_a.proved in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_continuity_a.met in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_continuity_rows.proved in
let _ := GbtSurfaces.Part_Abstract_proofs.abs_continuity_rows.met in
let _ := GbtSurfaces.Part_Table_printed_proofs.tab_1_1_proposed.proved in
let _ := GbtSurfaces.Part_Table_printed_proofs.tab_1_1_proposed.met in
let _ := GbtSurfaces.Part_Table_printed_proofs.tab_1_2_proposed.proved in
let _ := GbtSurfaces.Part_Table_printed_proofs.tab_1_2_proposed.met in
let _ := GbtSurfaces.Part_Table_printed_proofs.tab_1_3_proposed.proved in
let _ := GbtSurfaces.Part_Table_printed_proofs.tab_1_3_proposed.met in
let _ := GbtSurfaces.Part_Table_printed_proofs.tab_1_4_proposed.proved in
let _ := GbtSurfaces.Part_Table_printed_proofs.tab_1_4_proposed.met in
let _ := GbtSurfaces.Part_Table_printed_proofs.tab_1_5_proposed.proved in
let _ := GbtSurfaces.Part_Table_printed_proofs.tab_1_5_proposed.met in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_1_proposed.proved in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_1_proposed.met in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_2_proposed.proved in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_2_proposed.met in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_3_proposed.proved in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_3_proposed.met in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_4_proposed.proved in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_4_proposed.met in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_5_proposed.proved in
let _ := GbtSurfaces.Part_Table_proofs.tab_1_5_proposed.met in
let _ := GbtSurfaces.Section_1_printed_proofs.sec_1_contrib_1.proved in
let _ := GbtSurfaces.Section_1_printed_proofs.sec_1_contrib_1.met in
let _ := GbtSurfaces.Section_1_printed_proofs.sec_1_contrib_2.proved in
let _ := GbtSurfaces.Section_1_printed_proofs.sec_1_contrib_2.met in
let _ := GbtSurfaces.Section_1_printed_proofs.sec_1_contrib_3_by_the_printed_conditions.refuted in
let _ := GbtSurfaces.Section_1_printed_proofs.sec_1_contrib_3_there_are_such_compositions.proved in
let _ := GbtSurfaces.Section_1_printed_proofs.sec_1_contrib_3_there_are_such_compositions.met in
let _ := GbtSurfaces.Section_1_proofs.sec_1_contrib_1.proved in
let _ := GbtSurfaces.Section_1_proofs.sec_1_contrib_1.met in
let _ := GbtSurfaces.Section_1_proofs.sec_1_contrib_2.proved in
let _ := GbtSurfaces.Section_1_proofs.sec_1_contrib_2.met in
let _ := GbtSurfaces.Section_1_proofs.sec_1_contrib_3_by_the_printed_conditions.refuted in
let _ := GbtSurfaces.Section_1_proofs.sec_1_contrib_3_there_are_such_compositions.proved in
let _ := GbtSurfaces.Section_1_proofs.sec_1_contrib_3_there_are_such_compositions.met in
let _ := GbtSurfaces.Section_2_1_printed_proofs.eq_1_f0.proved in
let _ := GbtSurfaces.Section_2_1_printed_proofs.eq_1_f0.met in
let _ := GbtSurfaces.Section_2_1_printed_proofs.eq_1_f1.proved in
let _ := GbtSurfaces.Section_2_1_printed_proofs.eq_1_f1.met in
let _ := GbtSurfaces.Section_2_1_printed_proofs.eq_1_f2.proved in
let _ := GbtSurfaces.Section_2_1_printed_proofs.eq_1_f2.met in
let _ := GbtSurfaces.Section_2_1_printed_proofs.eq_2.proved in
let _ := GbtSurfaces.Section_2_1_printed_proofs.eq_2.met in
let _ := GbtSurfaces.Section_2_1_printed_proofs.eq_2_zero.refuted in
let _ := GbtSurfaces.Section_2_1_printed_proofs.eq_2_zero_true.proved in
let _ := GbtSurfaces.Section_2_1_printed_proofs.eq_2_zero_true.met in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_1_formal.proved in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_1_formal.met in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_1_as_functions.refuted in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_1_true.proved in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_1_true.met in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_1_blend.proved in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_1_blend.met in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_2_Definition_1.refuted in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_2_where_curves_are_defined.proved in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_2_where_curves_are_defined.met in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_3.proved in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_3.met in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_4.proved in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_4.met in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d1_0_values.proved in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d1_0_values.met in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d1_1_values.proved in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d1_1_values.met in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d2_0_values.proved in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d2_0_values.met in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d2_1_values.proved in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d2_1_values.met in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d3_0_values.proved in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d3_0_values.met in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d3_1_values.proved in
let _ := GbtSurfaces.Section_2_1_printed_proofs.thm_1_5_d3_1_values.met in
let _ := GbtSurfaces.Section_2_1_proofs.eq_1_f0.proved in
let _ := GbtSurfaces.Section_2_1_proofs.eq_1_f0.met in
let _ := GbtSurfaces.Section_2_1_proofs.eq_1_f1.proved in
let _ := GbtSurfaces.Section_2_1_proofs.eq_1_f1.met in
let _ := GbtSurfaces.Section_2_1_proofs.eq_1_f2.proved in
let _ := GbtSurfaces.Section_2_1_proofs.eq_1_f2.met in
let _ := GbtSurfaces.Section_2_1_proofs.eq_2.proved in
let _ := GbtSurfaces.Section_2_1_proofs.eq_2.met in
let _ := GbtSurfaces.Section_2_1_proofs.eq_2_zero.refuted in
let _ := GbtSurfaces.Section_2_1_proofs.eq_2_zero_true.proved in
let _ := GbtSurfaces.Section_2_1_proofs.eq_2_zero_true.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_1_formal.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_1_formal.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_1_as_functions.refuted in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_1_true.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_1_true.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_1_blend.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_1_blend.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_2_Definition_1.refuted in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_2_where_curves_are_defined.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_2_where_curves_are_defined.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_3.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_3.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_4.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_4.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_0_values.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_0_values.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_1_values.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d1_1_values.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_0_values.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_0_values.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_1_values.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d2_1_values.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_0_values.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_0_values.met in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_1_values.proved in
let _ := GbtSurfaces.Section_2_1_proofs.thm_1_5_d3_1_values.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.def_2_points.refuted in
let _ := GbtSurfaces.Section_2_2_printed_proofs.eq_3.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.eq_3.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_symmetry_as_in_Theorem_1.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_symmetry_as_in_Theorem_1.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_symmetry_parameters_exchanged.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_symmetry_parameters_exchanged.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_symmetry_as_for_B_zier_curves.refuted in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_convex_hull.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_convex_hull.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_variation_diminishing_order_2.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_variation_diminishing_order_2.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_invariance.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_invariance.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_shape_adjustable.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_shape_adjustable.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_terminal_0_values.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_terminal_0_values.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_terminal_1_values.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_terminal_1_values.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_interpolation.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_interpolation.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_end_derivatives.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.sec_2_2_end_derivatives.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_setting.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_setting.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_1.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_1.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.eq_4_Q11.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.eq_4_Q11.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_2.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_2.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.eq_5_Q12.refuted in
let _ := GbtSurfaces.Section_2_2_printed_proofs.eq_5_Q12_corrected.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.eq_5_Q12_corrected.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.eq_5_Q12_true.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.eq_5_Q12_true.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_a.refuted in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_b.refuted in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_true.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_true.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_iff.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_iff.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_necessary.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_necessary.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_sufficient.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_sufficient.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_jump.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_jump.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_when.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_3_when.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.eq_6_Q11.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.eq_6_Q11.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.eq_6_Q12.refuted in
let _ := GbtSurfaces.Section_2_2_printed_proofs.eq_6_Q12_corrected.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.eq_6_Q12_corrected.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.eq_6_Q13.refuted in
let _ := GbtSurfaces.Section_2_2_printed_proofs.eq_6_Q13_true.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.eq_6_Q13_true.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_a.refuted in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_c.refuted in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_b.refuted in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_true.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_true.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_iff.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_iff.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_necessary.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_necessary.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_sufficient.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_sufficient.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_sufficient_quintic.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_sufficient_quintic.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_cubic.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_4_cubic.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_a.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_a.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_a1.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_a1.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_a1_sign.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_a1_sign.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_a2.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_a2.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_a3.refuted in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_a3_corrected.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_a3_corrected.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_a3_true.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_a3_true.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_b1.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_b1.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_b1_sign.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_b1_sign.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_b2.refuted in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_b2_true.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_b2_true.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_b3.refuted in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_b3_corrected.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_b3_corrected.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_b3_true.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_b3_true.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_b4.refuted in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_b4_corrected.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_b4_corrected.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_b4_true.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_b4_true.met in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_c1.proved in
let _ := GbtSurfaces.Section_2_2_printed_proofs.thm_2_c1.met in
let _ := GbtSurfaces.Section_2_2_proofs.def_2_points.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.eq_3.proved in
let _ := GbtSurfaces.Section_2_2_proofs.eq_3.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_as_in_Theorem_1.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_as_in_Theorem_1.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_parameters_exchanged.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_parameters_exchanged.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_symmetry_as_for_B_zier_curves.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_convex_hull.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_convex_hull.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_variation_diminishing_order_2.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_variation_diminishing_order_2.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_invariance.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_invariance.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_shape_adjustable.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_shape_adjustable.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_0_values.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_0_values.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_1_values.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_terminal_1_values.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_interpolation.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_interpolation.met in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_end_derivatives.proved in
let _ := GbtSurfaces.Section_2_2_proofs.sec_2_2_end_derivatives.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_setting.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_setting.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_1.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_1.met in
let _ := GbtSurfaces.Section_2_2_proofs.eq_4_Q11.proved in
let _ := GbtSurfaces.Section_2_2_proofs.eq_4_Q11.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_2.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_2.met in
let _ := GbtSurfaces.Section_2_2_proofs.eq_5_Q12.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.eq_5_Q12_corrected.proved in
let _ := GbtSurfaces.Section_2_2_proofs.eq_5_Q12_corrected.met in
let _ := GbtSurfaces.Section_2_2_proofs.eq_5_Q12_true.proved in
let _ := GbtSurfaces.Section_2_2_proofs.eq_5_Q12_true.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_a.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_b.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_true.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_true.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_iff.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_iff.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_necessary.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_necessary.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_sufficient.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_sufficient.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_jump.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_jump.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_when.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_3_when.met in
let _ := GbtSurfaces.Section_2_2_proofs.eq_6_Q11.proved in
let _ := GbtSurfaces.Section_2_2_proofs.eq_6_Q11.met in
let _ := GbtSurfaces.Section_2_2_proofs.eq_6_Q12.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.eq_6_Q12_corrected.proved in
let _ := GbtSurfaces.Section_2_2_proofs.eq_6_Q12_corrected.met in
let _ := GbtSurfaces.Section_2_2_proofs.eq_6_Q13.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.eq_6_Q13_true.proved in
let _ := GbtSurfaces.Section_2_2_proofs.eq_6_Q13_true.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_a.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_c.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_b.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_true.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_true.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_iff.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_iff.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_necessary.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_necessary.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient_quintic.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_sufficient_quintic.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_cubic.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_4_cubic.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a1.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a1.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a1_sign.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a1_sign.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a2.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a2.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a3.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a3_corrected.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a3_corrected.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a3_true.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_a3_true.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b1.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b1.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b1_sign.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b1_sign.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b2.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b2_true.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b2_true.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b3.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b3_corrected.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b3_corrected.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b3_true.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b3_true.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b4.refuted in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b4_corrected.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b4_corrected.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b4_true.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_b4_true.met in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_c1.proved in
let _ := GbtSurfaces.Section_2_2_proofs.thm_2_c1.met in
let _ := GbtSurfaces.Section_2_3_printed_proofs.eq_7.proved in
let _ := GbtSurfaces.Section_2_3_printed_proofs.eq_7.met in
let _ := GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_features_a.proved in
let _ := GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_features_a.met in
let _ := GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_features_b.proved in
let _ := GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_features_b.met in
let _ := GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_features_c.proved in
let _ := GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_features_c.met in
let _ := GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_features_d.proved in
let _ := GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_features_d.met in
let _ := GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_classical_the_features_of_Sect__2_2.proved in
let _ := GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_classical_the_features_of_Sect__2_2.met in
let _ := GbtSurfaces.Section_2_3_printed_proofs.sec_2_3_classical_every_property.refuted in
let _ := GbtSurfaces.Section_2_3_proofs.eq_7.proved in
let _ := GbtSurfaces.Section_2_3_proofs.eq_7.met in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_features_a.proved in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_features_a.met in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_features_b.proved in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_features_b.met in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_features_c.proved in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_features_c.met in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_features_d.proved in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_features_d.met in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_classical_the_features_of_Sect__2_2.proved in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_classical_the_features_of_Sect__2_2.met in
let _ := GbtSurfaces.Section_2_3_proofs.sec_2_3_classical_every_property.refuted in
let _ := GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_i.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_i.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_8_1.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_8_1.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_8_2.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_8_2.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.prop_3_1.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.prop_3_1.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_translating.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_translating.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_not_tensor_literal.refuted in
let _ := GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_not_tensor_as_it_stands.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_not_tensor_as_it_stands.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_order_one_missing_none.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_order_one_missing_none.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_10.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_10.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_10_bernstein.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_10_bernstein.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_10_extending.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_10_extending.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_11.refuted in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_11_corrected.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_11_corrected.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_11_points.refuted in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_11_points_corrected.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_11_points_corrected.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_11_parameters.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_11_parameters.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_12_1.refuted in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_12_1_corrected.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_12_1_corrected.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_12_2.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_12_2.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_12_3.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_12_3.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_12_4.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_12_4.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.thm_3.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.thm_3.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_benefits.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_benefits.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_any_shape_literal.refuted in
let _ := GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_any_shape_the_shape_changes.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_any_shape_the_shape_changes.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.alg_1.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.alg_1.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.ex_3_1_points.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.ex_3_1_normal.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_13.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.eq_13.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.ex_3_1_net.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.ex_3_1_mesh_count.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.ex_3_1_hull.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.ex_3_1_hull.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_effect.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.sec_3_1_effect.met in
let _ := GbtSurfaces.Section_3_1_printed_proofs.prop_3_1_translation.proved in
let _ := GbtSurfaces.Section_3_1_printed_proofs.prop_3_1_translation.met in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_i.proved in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_i.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_8_1.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_8_1.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_8_2.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_8_2.met in
let _ := GbtSurfaces.Section_3_1_proofs.prop_3_1.proved in
let _ := GbtSurfaces.Section_3_1_proofs.prop_3_1.met in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_translating.proved in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_translating.met in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_not_tensor_literal.refuted in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_not_tensor_as_it_stands.proved in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_not_tensor_as_it_stands.met in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_order_one_missing_none.proved in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_order_one_missing_none.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_10.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_10.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_10_bernstein.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_10_bernstein.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_10_extending.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_10_extending.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_11.refuted in
let _ := GbtSurfaces.Section_3_1_proofs.eq_11_corrected.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_11_corrected.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_11_points.refuted in
let _ := GbtSurfaces.Section_3_1_proofs.eq_11_points_corrected.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_11_points_corrected.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_11_parameters.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_11_parameters.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_12_1.refuted in
let _ := GbtSurfaces.Section_3_1_proofs.eq_12_1_corrected.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_12_1_corrected.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_12_2.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_12_2.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_12_3.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_12_3.met in
let _ := GbtSurfaces.Section_3_1_proofs.eq_12_4.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_12_4.met in
let _ := GbtSurfaces.Section_3_1_proofs.thm_3.proved in
let _ := GbtSurfaces.Section_3_1_proofs.thm_3.met in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_benefits.proved in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_benefits.met in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_any_shape_literal.refuted in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_any_shape_the_shape_changes.proved in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_any_shape_the_shape_changes.met in
let _ := GbtSurfaces.Section_3_1_proofs.alg_1.proved in
let _ := GbtSurfaces.Section_3_1_proofs.alg_1.met in
let _ := GbtSurfaces.Section_3_1_proofs.ex_3_1_points.proved in
let _ := GbtSurfaces.Section_3_1_proofs.ex_3_1_normal.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_13.proved in
let _ := GbtSurfaces.Section_3_1_proofs.eq_13.met in
let _ := GbtSurfaces.Section_3_1_proofs.ex_3_1_net.proved in
let _ := GbtSurfaces.Section_3_1_proofs.ex_3_1_mesh_count.proved in
let _ := GbtSurfaces.Section_3_1_proofs.ex_3_1_hull.proved in
let _ := GbtSurfaces.Section_3_1_proofs.ex_3_1_hull.met in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_effect.proved in
let _ := GbtSurfaces.Section_3_1_proofs.sec_3_1_effect.met in
let _ := GbtSurfaces.Section_3_1_proofs.prop_3_1_translation.proved in
let _ := GbtSurfaces.Section_3_1_proofs.prop_3_1_translation.met in
let _ := GbtSurfaces.Section_3_2_printed_proofs.eq_14.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.eq_14.met in
let _ := GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_segments.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_segments.met in
let _ := GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_linear.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_linear.met in
let _ := GbtSurfaces.Section_3_2_printed_proofs.prop_3_2_a.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.prop_3_2_a.met in
let _ := GbtSurfaces.Section_3_2_printed_proofs.prop_3_2_b.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.prop_3_2_b.met in
let _ := GbtSurfaces.Section_3_2_printed_proofs.prop_3_2_c.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.prop_3_2_c.met in
let _ := GbtSurfaces.Section_3_2_printed_proofs.eq_15.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.eq_15.met in
let _ := GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_fixed.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_fixed.met in
let _ := GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_list_1.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_list_1.met in
let _ := GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_list_2.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_list_2.met in
let _ := GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_list_3.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.sec_3_2_list_3.met in
let _ := GbtSurfaces.Section_3_2_printed_proofs.alg_2_1.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.alg_2_1.met in
let _ := GbtSurfaces.Section_3_2_printed_proofs.alg_2_2.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.alg_2_2.met in
let _ := GbtSurfaces.Section_3_2_printed_proofs.alg_2_2_irregular.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.alg_2_2_irregular.met in
let _ := GbtSurfaces.Section_3_2_printed_proofs.eq_16.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.eq_16.met in
let _ := GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_corners.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_corners.met in
let _ := GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_division_z_lines.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_division_Q0l.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_division_Q3l.refuted in
let _ := GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_division_Q3l_corrected.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_equal_parts_a.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_equal_parts_b.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_equal_parts_c.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_equal_parts_d.refuted in
let _ := GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_equal_parts_d_corrected.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_interior.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_equation.refuted in
let _ := GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_sixteen.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_coplanar.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_noncoplanar_possible.proved in
let _ := GbtSurfaces.Section_3_2_printed_proofs.ex_3_2_noncoplanar_possible.met in
let _ := GbtSurfaces.Section_3_2_proofs.eq_14.proved in
let _ := GbtSurfaces.Section_3_2_proofs.eq_14.met in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_segments.proved in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_segments.met in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_linear.proved in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_linear.met in
let _ := GbtSurfaces.Section_3_2_proofs.prop_3_2_a.proved in
let _ := GbtSurfaces.Section_3_2_proofs.prop_3_2_a.met in
let _ := GbtSurfaces.Section_3_2_proofs.prop_3_2_b.proved in
let _ := GbtSurfaces.Section_3_2_proofs.prop_3_2_b.met in
let _ := GbtSurfaces.Section_3_2_proofs.prop_3_2_c.proved in
let _ := GbtSurfaces.Section_3_2_proofs.prop_3_2_c.met in
let _ := GbtSurfaces.Section_3_2_proofs.eq_15.proved in
let _ := GbtSurfaces.Section_3_2_proofs.eq_15.met in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_fixed.proved in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_fixed.met in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_list_1.proved in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_list_1.met in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_list_2.proved in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_list_2.met in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_list_3.proved in
let _ := GbtSurfaces.Section_3_2_proofs.sec_3_2_list_3.met in
let _ := GbtSurfaces.Section_3_2_proofs.alg_2_1.proved in
let _ := GbtSurfaces.Section_3_2_proofs.alg_2_1.met in
let _ := GbtSurfaces.Section_3_2_proofs.alg_2_2.proved in
let _ := GbtSurfaces.Section_3_2_proofs.alg_2_2.met in
let _ := GbtSurfaces.Section_3_2_proofs.alg_2_2_irregular.proved in
let _ := GbtSurfaces.Section_3_2_proofs.alg_2_2_irregular.met in
let _ := GbtSurfaces.Section_3_2_proofs.eq_16.proved in
let _ := GbtSurfaces.Section_3_2_proofs.eq_16.met in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_corners.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_corners.met in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_division_z_lines.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_division_Q0l.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_division_Q3l.refuted in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_division_Q3l_corrected.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_a.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_b.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_c.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_d.refuted in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_equal_parts_d_corrected.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_interior.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_equation.refuted in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_sixteen.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_coplanar.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_noncoplanar_possible.proved in
let _ := GbtSurfaces.Section_3_2_proofs.ex_3_2_noncoplanar_possible.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_generatrix.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_generatrix.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_same_degree_literal.refuted in
let _ := GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_same_degree_in_general.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_same_degree_in_general.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_17_0.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_17_0.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_17_1.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_17_1.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_condition_1.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_condition_1.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_condition_2.refuted in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_18.refuted in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_18_corrected.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_18_corrected.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_18_true.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_18_true.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_18_sufficient.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_18_sufficient.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_18_necessary.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_18_necessary.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_18_defect.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_18_defect.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_18_tensor.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_18_tensor.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_benefits_a.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.sec_3_3_benefits_a.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.prop_3_3_a.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.prop_3_3_a.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.prop_3_3_b.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.prop_3_3_b.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.prop_3_4_a.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.prop_3_4_a.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.prop_3_4_a_net.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.prop_3_4_a_net.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.prop_3_4_b.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.prop_3_4_b.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.alg_3_a.refuted in
let _ := GbtSurfaces.Section_3_3_printed_proofs.alg_3_a_corrected.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.alg_3_a_corrected.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.alg_3_b.refuted in
let _ := GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_curves.refuted in
let _ := GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_curves_corrected.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_curves_corrected.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_19.refuted in
let _ := GbtSurfaces.Section_3_3_printed_proofs.eq_19_tensor.refuted in
let _ := GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_gl_0.refuted in
let _ := GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_gl_0_corrected.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_gl_0_corrected.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_gl_1.refuted in
let _ := GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_gl_1_corrected.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_gl_1_corrected.met in
let _ := GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_composite.proved in
let _ := GbtSurfaces.Section_3_3_printed_proofs.ex_3_3_composite.met in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_generatrix.proved in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_generatrix.met in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_same_degree_literal.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_same_degree_in_general.proved in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_same_degree_in_general.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_17_0.proved in
let _ := GbtSurfaces.Section_3_3_proofs.eq_17_0.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_17_1.proved in
let _ := GbtSurfaces.Section_3_3_proofs.eq_17_1.met in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_1.proved in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_1.met in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_condition_2.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_corrected.proved in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_corrected.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_true.proved in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_true.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_sufficient.proved in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_sufficient.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_necessary.proved in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_necessary.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_defect.proved in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_defect.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_tensor.proved in
let _ := GbtSurfaces.Section_3_3_proofs.eq_18_tensor.met in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_benefits_a.proved in
let _ := GbtSurfaces.Section_3_3_proofs.sec_3_3_benefits_a.met in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_3_a.proved in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_3_a.met in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_3_b.proved in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_3_b.met in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_4_a.proved in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_4_a.met in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_4_a_net.proved in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_4_a_net.met in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_4_b.proved in
let _ := GbtSurfaces.Section_3_3_proofs.prop_3_4_b.met in
let _ := GbtSurfaces.Section_3_3_proofs.alg_3_a.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.alg_3_a_corrected.proved in
let _ := GbtSurfaces.Section_3_3_proofs.alg_3_a_corrected.met in
let _ := GbtSurfaces.Section_3_3_proofs.alg_3_b.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_curves.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_curves_corrected.proved in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_curves_corrected.met in
let _ := GbtSurfaces.Section_3_3_proofs.eq_19.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.eq_19_tensor.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_0.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_0_corrected.proved in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_0_corrected.met in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_1.refuted in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_1_corrected.proved in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_gl_1_corrected.met in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_composite.proved in
let _ := GbtSurfaces.Section_3_3_proofs.ex_3_3_composite.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_20_profile.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_20_profile.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_20_trajectory.refuted in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_20_trajectory_corrected.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_20_trajectory_corrected.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_21.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_21.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_22.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_22.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.prop_3_5.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.prop_3_5.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.prop_3_6_1.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.prop_3_6_1.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.prop_3_6_2.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.prop_3_6_2.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_23.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_23.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.thm_4_elements.refuted in
let _ := GbtSurfaces.Section_3_4_printed_proofs.thm_4_elements_corrected.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.thm_4_elements_corrected.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.thm_4_parameters.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.thm_4_parameters.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_24.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_24.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.thm_4_unity.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.thm_4_unity.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_1.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_1.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_2_a.refuted in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_2_a_corrected.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_2_a_corrected.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_2_b.refuted in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_2_b_corrected.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_2_b_corrected.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_2_c.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_2_c.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_3.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_3.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_4_a.refuted in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_4_a_corrected.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_4_a_corrected.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_4_b.refuted in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_4_b_corrected.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_4_b_corrected.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_4_c.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_25_4_c.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.thm_4_degree.refuted in
let _ := GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_features_a.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_features_a.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_continuity_pc.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_continuity_pc.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_continuity_tc.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_continuity_tc.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_closed.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_closed.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_revolution.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_revolution.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_revolution_not_tensor_quarter.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_revolution_not_tensor_quarter.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_revolution_not_tensor_cubic.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.sec_3_4_revolution_not_tensor_cubic.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.alg_4_a.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.alg_4_a.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.alg_4_b.refuted in
let _ := GbtSurfaces.Section_3_4_printed_proofs.eq_26.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.ex_3_4_scaling.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.ex_3_4_scaling.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.fig_16_lambda_between_the_panels.proved in
let _ := GbtSurfaces.Section_3_4_printed_proofs.fig_16_lambda_between_the_panels.met in
let _ := GbtSurfaces.Section_3_4_printed_proofs.fig_16_lambda_between_the_surfaces.refuted in
let _ := GbtSurfaces.Section_3_4_proofs.eq_20_profile.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_20_profile.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_20_trajectory.refuted in
let _ := GbtSurfaces.Section_3_4_proofs.eq_20_trajectory_corrected.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_20_trajectory_corrected.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_21.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_21.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_22.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_22.met in
let _ := GbtSurfaces.Section_3_4_proofs.prop_3_5.proved in
let _ := GbtSurfaces.Section_3_4_proofs.prop_3_5.met in
let _ := GbtSurfaces.Section_3_4_proofs.prop_3_6_1.proved in
let _ := GbtSurfaces.Section_3_4_proofs.prop_3_6_1.met in
let _ := GbtSurfaces.Section_3_4_proofs.prop_3_6_2.proved in
let _ := GbtSurfaces.Section_3_4_proofs.prop_3_6_2.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_23.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_23.met in
let _ := GbtSurfaces.Section_3_4_proofs.thm_4_elements.refuted in
let _ := GbtSurfaces.Section_3_4_proofs.thm_4_elements_corrected.proved in
let _ := GbtSurfaces.Section_3_4_proofs.thm_4_elements_corrected.met in
let _ := GbtSurfaces.Section_3_4_proofs.thm_4_parameters.proved in
let _ := GbtSurfaces.Section_3_4_proofs.thm_4_parameters.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_24.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_24.met in
let _ := GbtSurfaces.Section_3_4_proofs.thm_4_unity.proved in
let _ := GbtSurfaces.Section_3_4_proofs.thm_4_unity.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_1.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_1.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_2_a.refuted in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_2_a_corrected.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_2_a_corrected.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_2_b.refuted in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_2_b_corrected.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_2_b_corrected.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_2_c.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_2_c.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_3.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_3.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_4_a.refuted in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_4_a_corrected.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_4_a_corrected.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_4_b.refuted in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_4_b_corrected.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_4_b_corrected.met in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_4_c.proved in
let _ := GbtSurfaces.Section_3_4_proofs.eq_25_4_c.met in
let _ := GbtSurfaces.Section_3_4_proofs.thm_4_degree.refuted in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_features_a.proved in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_features_a.met in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_pc.proved in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_pc.met in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_tc.proved in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_continuity_tc.met in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_closed.proved in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_closed.met in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution.proved in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution.met in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_quarter.proved in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_quarter.met in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_cubic.proved in
let _ := GbtSurfaces.Section_3_4_proofs.sec_3_4_revolution_not_tensor_cubic.met in
let _ := GbtSurfaces.Section_3_4_proofs.alg_4_a.proved in
let _ := GbtSurfaces.Section_3_4_proofs.alg_4_a.met in
let _ := GbtSurfaces.Section_3_4_proofs.alg_4_b.refuted in
let _ := GbtSurfaces.Section_3_4_proofs.eq_26.proved in
let _ := GbtSurfaces.Section_3_4_proofs.ex_3_4_scaling.proved in
let _ := GbtSurfaces.Section_3_4_proofs.ex_3_4_scaling.met in
let _ := GbtSurfaces.Section_3_4_proofs.fig_16_lambda_between_the_panels.proved in
let _ := GbtSurfaces.Section_3_4_proofs.fig_16_lambda_between_the_panels.met in
let _ := GbtSurfaces.Section_3_4_proofs.fig_16_lambda_between_the_surfaces.refuted in
let _ := GbtSurfaces.Section_3_5_printed_proofs.eq_27.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.eq_27.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.sec_3_5_categories.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.sec_3_5_not_expressible_sine.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.sec_3_5_not_expressible_sine.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.eq_29.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.eq_29.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.eq_30.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.eq_30.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.eq_31_2.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.eq_31_2.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.eq_31_3.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.eq_31_3.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.eq_31_4.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.eq_31_4.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.eq_31_5.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.eq_31_5.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.prop_3_7_1_a.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.prop_3_7_1_a.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.prop_3_7_2a.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.prop_3_7_2a.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.prop_3_7_2b.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.prop_3_7_2b.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.alg_5_a.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.alg_5_a.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.alg_5_b.refuted in
let _ := GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_sections.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_trajectories.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c1_sections.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c1_sections.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c1_trajectories.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c1_trajectories.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c2_sections.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c2_sections.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c2_trajectories.refuted in
let _ := GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c2_trajectories_true.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c2_trajectories_true.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c2_trajectories_moved.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_c2_trajectories_moved.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_contiguous_each_with_its_own.refuted in
let _ := GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_contiguous_one_trajectory.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_contiguous_one_trajectory.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_contiguous_one_section.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.ex_3_5_contiguous_one_section.met in
let _ := GbtSurfaces.Section_3_5_printed_proofs.sec_3_5_unnecessary.proved in
let _ := GbtSurfaces.Section_3_5_printed_proofs.sec_3_5_unnecessary.met in
let _ := GbtSurfaces.Section_3_5_proofs.eq_27.proved in
let _ := GbtSurfaces.Section_3_5_proofs.eq_27.met in
let _ := GbtSurfaces.Section_3_5_proofs.sec_3_5_categories.proved in
let _ := GbtSurfaces.Section_3_5_proofs.sec_3_5_not_expressible_sine.proved in
let _ := GbtSurfaces.Section_3_5_proofs.sec_3_5_not_expressible_sine.met in
let _ := GbtSurfaces.Section_3_5_proofs.eq_29.proved in
let _ := GbtSurfaces.Section_3_5_proofs.eq_29.met in
let _ := GbtSurfaces.Section_3_5_proofs.eq_30.proved in
let _ := GbtSurfaces.Section_3_5_proofs.eq_30.met in
let _ := GbtSurfaces.Section_3_5_proofs.eq_31_2.proved in
let _ := GbtSurfaces.Section_3_5_proofs.eq_31_2.met in
let _ := GbtSurfaces.Section_3_5_proofs.eq_31_3.proved in
let _ := GbtSurfaces.Section_3_5_proofs.eq_31_3.met in
let _ := GbtSurfaces.Section_3_5_proofs.eq_31_4.proved in
let _ := GbtSurfaces.Section_3_5_proofs.eq_31_4.met in
let _ := GbtSurfaces.Section_3_5_proofs.eq_31_5.proved in
let _ := GbtSurfaces.Section_3_5_proofs.eq_31_5.met in
let _ := GbtSurfaces.Section_3_5_proofs.prop_3_7_1_a.proved in
let _ := GbtSurfaces.Section_3_5_proofs.prop_3_7_1_a.met in
let _ := GbtSurfaces.Section_3_5_proofs.prop_3_7_2a.proved in
let _ := GbtSurfaces.Section_3_5_proofs.prop_3_7_2a.met in
let _ := GbtSurfaces.Section_3_5_proofs.prop_3_7_2b.proved in
let _ := GbtSurfaces.Section_3_5_proofs.prop_3_7_2b.met in
let _ := GbtSurfaces.Section_3_5_proofs.alg_5_a.proved in
let _ := GbtSurfaces.Section_3_5_proofs.alg_5_a.met in
let _ := GbtSurfaces.Section_3_5_proofs.alg_5_b.refuted in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_sections.proved in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_trajectories.proved in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_sections.proved in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_sections.met in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_trajectories.proved in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c1_trajectories.met in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_sections.proved in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_sections.met in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories.refuted in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories_true.proved in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories_true.met in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories_moved.proved in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_c2_trajectories_moved.met in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_each_with_its_own.refuted in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_trajectory.proved in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_trajectory.met in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_section.proved in
let _ := GbtSurfaces.Section_3_5_proofs.ex_3_5_contiguous_one_section.met in
let _ := GbtSurfaces.Section_3_5_proofs.sec_3_5_unnecessary.proved in
let _ := GbtSurfaces.Section_3_5_proofs.sec_3_5_unnecessary.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.eq_32_matrix.refuted in
let _ := GbtSurfaces.Section_3_6_printed_proofs.eq_32_matrix_corrected.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.eq_32_matrix_corrected.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.eq_32_components.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.eq_32_components.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_rounding_rational.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_rounding_rational.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_revolving.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_revolving.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_plane_generating_line.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_plane_generating_line.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_plane_surface.refuted in
let _ := GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_c1c2.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_c1c2.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.eq_33_T.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.eq_33_T.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.eq_33_Ttilde.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.eq_33_Ttilde.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.eq_33_circle.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.eq_33_circle.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.thm_6_symmetric.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.thm_6_symmetric.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.thm_6_complete.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.thm_6_complete.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.eq_34.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.eq_34.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_other_axes.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.sec_3_6_other_axes.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.prop_3_8_a_linear.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.prop_3_8_a_linear.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.prop_3_8_a_true.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.prop_3_8_a_true.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.prop_3_8_b.refuted in
let _ := GbtSurfaces.Section_3_6_printed_proofs.prop_3_8_b_true.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.prop_3_8_b_true.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.prop_3_8_b_exact.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.prop_3_8_b_exact.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.prop_3_9_a_composite_line.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.prop_3_9_a_composite_line.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.prop_3_9_a_one_segment.refuted in
let _ := GbtSurfaces.Section_3_6_printed_proofs.prop_3_9_b.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.prop_3_9_b.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.alg_6.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.alg_6.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.eq_35.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.ex_3_6_curve.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.ex_3_6_curve.met in
let _ := GbtSurfaces.Section_3_6_printed_proofs.eq_36.proved in
let _ := GbtSurfaces.Section_3_6_printed_proofs.eq_36.met in
let _ := GbtSurfaces.Section_3_6_proofs.eq_32_matrix.refuted in
let _ := GbtSurfaces.Section_3_6_proofs.eq_32_matrix_corrected.proved in
let _ := GbtSurfaces.Section_3_6_proofs.eq_32_matrix_corrected.met in
let _ := GbtSurfaces.Section_3_6_proofs.eq_32_components.proved in
let _ := GbtSurfaces.Section_3_6_proofs.eq_32_components.met in
let _ := GbtSurfaces.Section_3_6_proofs.sec_3_6_rounding_rational.proved in
let _ := GbtSurfaces.Section_3_6_proofs.sec_3_6_rounding_rational.met in
let _ := GbtSurfaces.Section_3_6_proofs.sec_3_6_revolving.proved in
let _ := GbtSurfaces.Section_3_6_proofs.sec_3_6_revolving.met in
let _ := GbtSurfaces.Section_3_6_proofs.sec_3_6_plane_generating_line.proved in
let _ := GbtSurfaces.Section_3_6_proofs.sec_3_6_plane_generating_line.met in
let _ := GbtSurfaces.Section_3_6_proofs.sec_3_6_plane_surface.refuted in
let _ := GbtSurfaces.Section_3_6_proofs.sec_3_6_c1c2.proved in
let _ := GbtSurfaces.Section_3_6_proofs.sec_3_6_c1c2.met in
let _ := GbtSurfaces.Section_3_6_proofs.eq_33_T.proved in
let _ := GbtSurfaces.Section_3_6_proofs.eq_33_T.met in
let _ := GbtSurfaces.Section_3_6_proofs.eq_33_Ttilde.proved in
let _ := GbtSurfaces.Section_3_6_proofs.eq_33_Ttilde.met in
let _ := GbtSurfaces.Section_3_6_proofs.eq_33_circle.proved in
let _ := GbtSurfaces.Section_3_6_proofs.eq_33_circle.met in
let _ := GbtSurfaces.Section_3_6_proofs.thm_6_symmetric.proved in
let _ := GbtSurfaces.Section_3_6_proofs.thm_6_symmetric.met in
let _ := GbtSurfaces.Section_3_6_proofs.thm_6_complete.proved in
let _ := GbtSurfaces.Section_3_6_proofs.thm_6_complete.met in
let _ := GbtSurfaces.Section_3_6_proofs.eq_34.proved in
let _ := GbtSurfaces.Section_3_6_proofs.eq_34.met in
let _ := GbtSurfaces.Section_3_6_proofs.sec_3_6_other_axes.proved in
let _ := GbtSurfaces.Section_3_6_proofs.sec_3_6_other_axes.met in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_8_a_linear.proved in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_8_a_linear.met in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_8_a_true.proved in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_8_a_true.met in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_8_b.refuted in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_8_b_true.proved in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_8_b_true.met in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_8_b_exact.proved in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_8_b_exact.met in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_9_a_composite_line.proved in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_9_a_composite_line.met in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_9_a_one_segment.refuted in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_9_b.proved in
let _ := GbtSurfaces.Section_3_6_proofs.prop_3_9_b.met in
let _ := GbtSurfaces.Section_3_6_proofs.alg_6.proved in
let _ := GbtSurfaces.Section_3_6_proofs.alg_6.met in
let _ := GbtSurfaces.Section_3_6_proofs.eq_35.proved in
let _ := GbtSurfaces.Section_3_6_proofs.ex_3_6_curve.proved in
let _ := GbtSurfaces.Section_3_6_proofs.ex_3_6_curve.met in
let _ := GbtSurfaces.Section_3_6_proofs.eq_36.proved in
let _ := GbtSurfaces.Section_3_6_proofs.eq_36.met in
let _ := GbtSurfaces.Section_4_printed_proofs.abs_features_the_features_of_Sect__2_2.proved in
let _ := GbtSurfaces.Section_4_printed_proofs.abs_features_the_features_of_Sect__2_2.met in
let _ := GbtSurfaces.Section_4_printed_proofs.abs_features_every_feature.refuted in
let _ := GbtSurfaces.Section_4_printed_proofs.sec_4_six_tensor_with_rotation_surfaces.refuted in
let _ := GbtSurfaces.Section_4_printed_proofs.sec_4_six_tensor_without.proved in
let _ := GbtSurfaces.Section_4_printed_proofs.sec_4_six_tensor_without.met in
let _ := GbtSurfaces.Section_4_printed_proofs.sec_4_composite_by_the_printed_conditions.refuted in
let _ := GbtSurfaces.Section_4_printed_proofs.sec_4_composite_there_are_such_compositions.proved in
let _ := GbtSurfaces.Section_4_printed_proofs.sec_4_composite_there_are_such_compositions.met in
let _ := GbtSurfaces.Section_4_printed_proofs.sec_4_tensor.proved in
let _ := GbtSurfaces.Section_4_printed_proofs.sec_4_tensor.met in
let _ := GbtSurfaces.Section_4_printed_proofs.sec_4_convex_hull.proved in
let _ := GbtSurfaces.Section_4_proofs.abs_features_the_features_of_Sect__2_2.proved in
let _ := GbtSurfaces.Section_4_proofs.abs_features_the_features_of_Sect__2_2.met in
let _ := GbtSurfaces.Section_4_proofs.abs_features_every_feature.refuted in
let _ := GbtSurfaces.Section_4_proofs.sec_4_six_tensor_with_rotation_surfaces.refuted in
let _ := GbtSurfaces.Section_4_proofs.sec_4_six_tensor_without.proved in
let _ := GbtSurfaces.Section_4_proofs.sec_4_six_tensor_without.met in
let _ := GbtSurfaces.Section_4_proofs.sec_4_composite_by_the_printed_conditions.refuted in
let _ := GbtSurfaces.Section_4_proofs.sec_4_composite_there_are_such_compositions.proved in
let _ := GbtSurfaces.Section_4_proofs.sec_4_composite_there_are_such_compositions.met in
let _ := GbtSurfaces.Section_4_proofs.sec_4_tensor.proved in
let _ := GbtSurfaces.Section_4_proofs.sec_4_tensor.met in
let _ := GbtSurfaces.Section_4_proofs.sec_4_convex_hull.proved in
I.
