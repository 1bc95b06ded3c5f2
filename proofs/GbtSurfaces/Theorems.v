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
Check (Part_Abstract_printed_proofs.abs_basis_a.proved : Part_Abstract_printed.abs_basis_a.statement).
Check (Part_Abstract_printed_proofs.abs_basis_a.met : Part_Abstract_printed.abs_basis_a.instance).
Check (Part_Abstract_printed_proofs.abs_basis_b_name.proved : Part_Abstract_printed.abs_basis_b_name.statement).
Check (Part_Abstract_printed_proofs.abs_basis_b_name.met : Part_Abstract_printed.abs_basis_b_name.instance).
Check (Part_Abstract_printed_proofs.abs_basis_b_basis.refuted : ~ Part_Abstract_printed.abs_basis_b_basis.statement).
Check (Part_Abstract_printed_proofs.abs_basis_order_2.proved : Part_Abstract_printed.abs_basis_order_2.statement).
Check (Part_Abstract_printed_proofs.abs_basis_order_2.met : Part_Abstract_printed.abs_basis_order_2.instance).
Check (Part_Abstract_printed_proofs.abs_basis_cubic.proved : Part_Abstract_printed.abs_basis_cubic.statement).
Check (Part_Abstract_printed_proofs.abs_basis_cubic.met : Part_Abstract_printed.abs_basis_cubic.instance).
Check (Part_Abstract_printed_proofs.abs_basis_all.proved : Part_Abstract_printed.abs_basis_all.statement).
Check (Part_Abstract_printed_proofs.abs_basis_all.met : Part_Abstract_printed.abs_basis_all.instance).
Check (Part_Abstract_printed_proofs.abs_continuity_a.proved : Part_Abstract_printed.abs_continuity_a.statement).
Check (Part_Abstract_printed_proofs.abs_continuity_a.met : Part_Abstract_printed.abs_continuity_a.instance).
Check (Part_Abstract_printed_proofs.abs_continuity_rows.proved : Part_Abstract_printed.abs_continuity_rows.statement).
Check (Part_Abstract_printed_proofs.abs_continuity_rows.met : Part_Abstract_printed.abs_continuity_rows.instance).
Check (Part_Abstract_proofs.abs_basis_a.proved : Part_Abstract.abs_basis_a.statement).
Check (Part_Abstract_proofs.abs_basis_a.met : Part_Abstract.abs_basis_a.instance).
Check (Part_Abstract_proofs.abs_basis_b_name.proved : Part_Abstract.abs_basis_b_name.statement).
Check (Part_Abstract_proofs.abs_basis_b_name.met : Part_Abstract.abs_basis_b_name.instance).
Check (Part_Abstract_proofs.abs_basis_b_basis.refuted : ~ Part_Abstract.abs_basis_b_basis.statement).
Check (Part_Abstract_proofs.abs_basis_order_2.proved : Part_Abstract.abs_basis_order_2.statement).
Check (Part_Abstract_proofs.abs_basis_order_2.met : Part_Abstract.abs_basis_order_2.instance).
Check (Part_Abstract_proofs.abs_basis_cubic.proved : Part_Abstract.abs_basis_cubic.statement).
Check (Part_Abstract_proofs.abs_basis_cubic.met : Part_Abstract.abs_basis_cubic.instance).
Check (Part_Abstract_proofs.abs_basis_all.proved : Part_Abstract.abs_basis_all.statement).
Check (Part_Abstract_proofs.abs_basis_all.met : Part_Abstract.abs_basis_all.instance).
Check (Part_Abstract_proofs.abs_continuity_a.proved : Part_Abstract.abs_continuity_a.statement).
Check (Part_Abstract_proofs.abs_continuity_a.met : Part_Abstract.abs_continuity_a.instance).
Check (Part_Abstract_proofs.abs_continuity_rows.proved : Part_Abstract.abs_continuity_rows.statement).
Check (Part_Abstract_proofs.abs_continuity_rows.met : Part_Abstract.abs_continuity_rows.instance).
Check (Part_Table_printed_proofs.tab_1_1_proposed.proved : Part_Table_printed.tab_1_1_proposed.statement).
Check (Part_Table_printed_proofs.tab_1_1_proposed.met : Part_Table_printed.tab_1_1_proposed.instance).
Check (Part_Table_printed_proofs.tab_1_2_proposed.proved : Part_Table_printed.tab_1_2_proposed.statement).
Check (Part_Table_printed_proofs.tab_1_2_proposed.met : Part_Table_printed.tab_1_2_proposed.instance).
Check (Part_Table_printed_proofs.tab_1_3_proposed.proved : Part_Table_printed.tab_1_3_proposed.statement).
Check (Part_Table_printed_proofs.tab_1_3_proposed.met : Part_Table_printed.tab_1_3_proposed.instance).
Check (Part_Table_printed_proofs.tab_1_4_proposed.proved : Part_Table_printed.tab_1_4_proposed.statement).
Check (Part_Table_printed_proofs.tab_1_4_proposed.met : Part_Table_printed.tab_1_4_proposed.instance).
Check (Part_Table_printed_proofs.tab_1_5_proposed.proved : Part_Table_printed.tab_1_5_proposed.statement).
Check (Part_Table_printed_proofs.tab_1_5_proposed.met : Part_Table_printed.tab_1_5_proposed.instance).
Check (Part_Table_proofs.tab_1_1_proposed.proved : Part_Table.tab_1_1_proposed.statement).
Check (Part_Table_proofs.tab_1_1_proposed.met : Part_Table.tab_1_1_proposed.instance).
Check (Part_Table_proofs.tab_1_2_proposed.proved : Part_Table.tab_1_2_proposed.statement).
Check (Part_Table_proofs.tab_1_2_proposed.met : Part_Table.tab_1_2_proposed.instance).
Check (Part_Table_proofs.tab_1_3_proposed.proved : Part_Table.tab_1_3_proposed.statement).
Check (Part_Table_proofs.tab_1_3_proposed.met : Part_Table.tab_1_3_proposed.instance).
Check (Part_Table_proofs.tab_1_4_proposed.proved : Part_Table.tab_1_4_proposed.statement).
Check (Part_Table_proofs.tab_1_4_proposed.met : Part_Table.tab_1_4_proposed.instance).
Check (Part_Table_proofs.tab_1_5_proposed.proved : Part_Table.tab_1_5_proposed.statement).
Check (Part_Table_proofs.tab_1_5_proposed.met : Part_Table.tab_1_5_proposed.instance).
Check (Section_1_printed_proofs.sec_1_contrib_1.proved : Section_1_printed.sec_1_contrib_1.statement).
Check (Section_1_printed_proofs.sec_1_contrib_1.met : Section_1_printed.sec_1_contrib_1.instance).
Check (Section_1_printed_proofs.sec_1_contrib_2.proved : Section_1_printed.sec_1_contrib_2.statement).
Check (Section_1_printed_proofs.sec_1_contrib_2.met : Section_1_printed.sec_1_contrib_2.instance).
Check (Section_1_printed_proofs.sec_1_contrib_3_by_the_printed_conditions.refuted : ~ Section_1_printed.sec_1_contrib_3_by_the_printed_conditions.statement).
Check (Section_1_printed_proofs.sec_1_contrib_3_there_are_such_compositions.proved : Section_1_printed.sec_1_contrib_3_there_are_such_compositions.statement).
Check (Section_1_printed_proofs.sec_1_contrib_3_there_are_such_compositions.met : Section_1_printed.sec_1_contrib_3_there_are_such_compositions.instance).
Check (Section_1_proofs.sec_1_contrib_1.proved : Section_1.sec_1_contrib_1.statement).
Check (Section_1_proofs.sec_1_contrib_1.met : Section_1.sec_1_contrib_1.instance).
Check (Section_1_proofs.sec_1_contrib_2.proved : Section_1.sec_1_contrib_2.statement).
Check (Section_1_proofs.sec_1_contrib_2.met : Section_1.sec_1_contrib_2.instance).
Check (Section_1_proofs.sec_1_contrib_3_by_the_printed_conditions.refuted : ~ Section_1.sec_1_contrib_3_by_the_printed_conditions.statement).
Check (Section_1_proofs.sec_1_contrib_3_there_are_such_compositions.proved : Section_1.sec_1_contrib_3_there_are_such_compositions.statement).
Check (Section_1_proofs.sec_1_contrib_3_there_are_such_compositions.met : Section_1.sec_1_contrib_3_there_are_such_compositions.instance).
Check (Section_2_1_printed_proofs.eq_1_f0.proved : Section_2_1_printed.eq_1_f0.statement).
Check (Section_2_1_printed_proofs.eq_1_f0.met : Section_2_1_printed.eq_1_f0.instance).
Check (Section_2_1_printed_proofs.eq_1_f1.proved : Section_2_1_printed.eq_1_f1.statement).
Check (Section_2_1_printed_proofs.eq_1_f1.met : Section_2_1_printed.eq_1_f1.instance).
Check (Section_2_1_printed_proofs.eq_1_f2.proved : Section_2_1_printed.eq_1_f2.statement).
Check (Section_2_1_printed_proofs.eq_1_f2.met : Section_2_1_printed.eq_1_f2.instance).
Check (Section_2_1_printed_proofs.eq_2.proved : Section_2_1_printed.eq_2.statement).
Check (Section_2_1_printed_proofs.eq_2.met : Section_2_1_printed.eq_2.instance).
Check (Section_2_1_printed_proofs.eq_2_zero.refuted : ~ Section_2_1_printed.eq_2_zero.statement).
Check (Section_2_1_printed_proofs.eq_2_zero_true.proved : Section_2_1_printed.eq_2_zero_true.statement).
Check (Section_2_1_printed_proofs.eq_2_zero_true.met : Section_2_1_printed.eq_2_zero_true.instance).
Check (Section_2_1_printed_proofs.thm_1_1_formal.proved : Section_2_1_printed.thm_1_1_formal.statement).
Check (Section_2_1_printed_proofs.thm_1_1_formal.met : Section_2_1_printed.thm_1_1_formal.instance).
Check (Section_2_1_printed_proofs.thm_1_1_as_functions.refuted : ~ Section_2_1_printed.thm_1_1_as_functions.statement).
Check (Section_2_1_printed_proofs.thm_1_1_true.proved : Section_2_1_printed.thm_1_1_true.statement).
Check (Section_2_1_printed_proofs.thm_1_1_true.met : Section_2_1_printed.thm_1_1_true.instance).
Check (Section_2_1_printed_proofs.thm_1_1_blend.proved : Section_2_1_printed.thm_1_1_blend.statement).
Check (Section_2_1_printed_proofs.thm_1_1_blend.met : Section_2_1_printed.thm_1_1_blend.instance).
Check (Section_2_1_printed_proofs.thm_1_2_Definition_1.refuted : ~ Section_2_1_printed.thm_1_2_Definition_1.statement).
Check (Section_2_1_printed_proofs.thm_1_2_where_curves_are_defined.proved : Section_2_1_printed.thm_1_2_where_curves_are_defined.statement).
Check (Section_2_1_printed_proofs.thm_1_2_where_curves_are_defined.met : Section_2_1_printed.thm_1_2_where_curves_are_defined.instance).
Check (Section_2_1_printed_proofs.thm_1_3.proved : Section_2_1_printed.thm_1_3.statement).
Check (Section_2_1_printed_proofs.thm_1_3.met : Section_2_1_printed.thm_1_3.instance).
Check (Section_2_1_printed_proofs.thm_1_4.proved : Section_2_1_printed.thm_1_4.statement).
Check (Section_2_1_printed_proofs.thm_1_4.met : Section_2_1_printed.thm_1_4.instance).
Check (Section_2_1_printed_proofs.thm_1_5_d1_0_values.proved : Section_2_1_printed.thm_1_5_d1_0_values.statement).
Check (Section_2_1_printed_proofs.thm_1_5_d1_0_values.met : Section_2_1_printed.thm_1_5_d1_0_values.instance).
Check (Section_2_1_printed_proofs.thm_1_5_d1_1_values.proved : Section_2_1_printed.thm_1_5_d1_1_values.statement).
Check (Section_2_1_printed_proofs.thm_1_5_d1_1_values.met : Section_2_1_printed.thm_1_5_d1_1_values.instance).
Check (Section_2_1_printed_proofs.thm_1_5_d2_0_values.proved : Section_2_1_printed.thm_1_5_d2_0_values.statement).
Check (Section_2_1_printed_proofs.thm_1_5_d2_0_values.met : Section_2_1_printed.thm_1_5_d2_0_values.instance).
Check (Section_2_1_printed_proofs.thm_1_5_d2_1_values.proved : Section_2_1_printed.thm_1_5_d2_1_values.statement).
Check (Section_2_1_printed_proofs.thm_1_5_d2_1_values.met : Section_2_1_printed.thm_1_5_d2_1_values.instance).
Check (Section_2_1_printed_proofs.thm_1_5_d3_0_values.proved : Section_2_1_printed.thm_1_5_d3_0_values.statement).
Check (Section_2_1_printed_proofs.thm_1_5_d3_0_values.met : Section_2_1_printed.thm_1_5_d3_0_values.instance).
Check (Section_2_1_printed_proofs.thm_1_5_d3_1_values.proved : Section_2_1_printed.thm_1_5_d3_1_values.statement).
Check (Section_2_1_printed_proofs.thm_1_5_d3_1_values.met : Section_2_1_printed.thm_1_5_d3_1_values.instance).
Check (Section_2_1_proofs.eq_1_f0.proved : Section_2_1.eq_1_f0.statement).
Check (Section_2_1_proofs.eq_1_f0.met : Section_2_1.eq_1_f0.instance).
Check (Section_2_1_proofs.eq_1_f1.proved : Section_2_1.eq_1_f1.statement).
Check (Section_2_1_proofs.eq_1_f1.met : Section_2_1.eq_1_f1.instance).
Check (Section_2_1_proofs.eq_1_f2.proved : Section_2_1.eq_1_f2.statement).
Check (Section_2_1_proofs.eq_1_f2.met : Section_2_1.eq_1_f2.instance).
Check (Section_2_1_proofs.eq_2.proved : Section_2_1.eq_2.statement).
Check (Section_2_1_proofs.eq_2.met : Section_2_1.eq_2.instance).
Check (Section_2_1_proofs.eq_2_zero.refuted : ~ Section_2_1.eq_2_zero.statement).
Check (Section_2_1_proofs.eq_2_zero_true.proved : Section_2_1.eq_2_zero_true.statement).
Check (Section_2_1_proofs.eq_2_zero_true.met : Section_2_1.eq_2_zero_true.instance).
Check (Section_2_1_proofs.thm_1_1_formal.proved : Section_2_1.thm_1_1_formal.statement).
Check (Section_2_1_proofs.thm_1_1_formal.met : Section_2_1.thm_1_1_formal.instance).
Check (Section_2_1_proofs.thm_1_1_as_functions.refuted : ~ Section_2_1.thm_1_1_as_functions.statement).
Check (Section_2_1_proofs.thm_1_1_true.proved : Section_2_1.thm_1_1_true.statement).
Check (Section_2_1_proofs.thm_1_1_true.met : Section_2_1.thm_1_1_true.instance).
Check (Section_2_1_proofs.thm_1_1_blend.proved : Section_2_1.thm_1_1_blend.statement).
Check (Section_2_1_proofs.thm_1_1_blend.met : Section_2_1.thm_1_1_blend.instance).
Check (Section_2_1_proofs.thm_1_2_Definition_1.refuted : ~ Section_2_1.thm_1_2_Definition_1.statement).
Check (Section_2_1_proofs.thm_1_2_where_curves_are_defined.proved : Section_2_1.thm_1_2_where_curves_are_defined.statement).
Check (Section_2_1_proofs.thm_1_2_where_curves_are_defined.met : Section_2_1.thm_1_2_where_curves_are_defined.instance).
Check (Section_2_1_proofs.thm_1_3.proved : Section_2_1.thm_1_3.statement).
Check (Section_2_1_proofs.thm_1_3.met : Section_2_1.thm_1_3.instance).
Check (Section_2_1_proofs.thm_1_4.proved : Section_2_1.thm_1_4.statement).
Check (Section_2_1_proofs.thm_1_4.met : Section_2_1.thm_1_4.instance).
Check (Section_2_1_proofs.thm_1_5_d1_0_values.proved : Section_2_1.thm_1_5_d1_0_values.statement).
Check (Section_2_1_proofs.thm_1_5_d1_0_values.met : Section_2_1.thm_1_5_d1_0_values.instance).
Check (Section_2_1_proofs.thm_1_5_d1_1_values.proved : Section_2_1.thm_1_5_d1_1_values.statement).
Check (Section_2_1_proofs.thm_1_5_d1_1_values.met : Section_2_1.thm_1_5_d1_1_values.instance).
Check (Section_2_1_proofs.thm_1_5_d2_0_values.proved : Section_2_1.thm_1_5_d2_0_values.statement).
Check (Section_2_1_proofs.thm_1_5_d2_0_values.met : Section_2_1.thm_1_5_d2_0_values.instance).
Check (Section_2_1_proofs.thm_1_5_d2_1_values.proved : Section_2_1.thm_1_5_d2_1_values.statement).
Check (Section_2_1_proofs.thm_1_5_d2_1_values.met : Section_2_1.thm_1_5_d2_1_values.instance).
Check (Section_2_1_proofs.thm_1_5_d3_0_values.proved : Section_2_1.thm_1_5_d3_0_values.statement).
Check (Section_2_1_proofs.thm_1_5_d3_0_values.met : Section_2_1.thm_1_5_d3_0_values.instance).
Check (Section_2_1_proofs.thm_1_5_d3_1_values.proved : Section_2_1.thm_1_5_d3_1_values.statement).
Check (Section_2_1_proofs.thm_1_5_d3_1_values.met : Section_2_1.thm_1_5_d3_1_values.instance).
Check (Section_2_2_printed_proofs.def_2_points.refuted : ~ Section_2_2_printed.def_2_points.statement).
Check (Section_2_2_printed_proofs.eq_3.proved : Section_2_2_printed.eq_3.statement).
Check (Section_2_2_printed_proofs.eq_3.met : Section_2_2_printed.eq_3.instance).
Check (Section_2_2_printed_proofs.sec_2_2_symmetry_as_in_Theorem_1.proved : Section_2_2_printed.sec_2_2_symmetry_as_in_Theorem_1.statement).
Check (Section_2_2_printed_proofs.sec_2_2_symmetry_as_in_Theorem_1.met : Section_2_2_printed.sec_2_2_symmetry_as_in_Theorem_1.instance).
Check (Section_2_2_printed_proofs.sec_2_2_symmetry_parameters_exchanged.proved : Section_2_2_printed.sec_2_2_symmetry_parameters_exchanged.statement).
Check (Section_2_2_printed_proofs.sec_2_2_symmetry_parameters_exchanged.met : Section_2_2_printed.sec_2_2_symmetry_parameters_exchanged.instance).
Check (Section_2_2_printed_proofs.sec_2_2_symmetry_as_for_B_zier_curves.refuted : ~ Section_2_2_printed.sec_2_2_symmetry_as_for_B_zier_curves.statement).
Check (Section_2_2_printed_proofs.sec_2_2_convex_hull.proved : Section_2_2_printed.sec_2_2_convex_hull.statement).
Check (Section_2_2_printed_proofs.sec_2_2_convex_hull.met : Section_2_2_printed.sec_2_2_convex_hull.instance).
Check (Section_2_2_printed_proofs.sec_2_2_variation_diminishing_order_2.proved : Section_2_2_printed.sec_2_2_variation_diminishing_order_2.statement).
Check (Section_2_2_printed_proofs.sec_2_2_variation_diminishing_order_2.met : Section_2_2_printed.sec_2_2_variation_diminishing_order_2.instance).
Check (Section_2_2_printed_proofs.sec_2_2_invariance.proved : Section_2_2_printed.sec_2_2_invariance.statement).
Check (Section_2_2_printed_proofs.sec_2_2_invariance.met : Section_2_2_printed.sec_2_2_invariance.instance).
Check (Section_2_2_printed_proofs.sec_2_2_shape_adjustable.proved : Section_2_2_printed.sec_2_2_shape_adjustable.statement).
Check (Section_2_2_printed_proofs.sec_2_2_shape_adjustable.met : Section_2_2_printed.sec_2_2_shape_adjustable.instance).
Check (Section_2_2_printed_proofs.sec_2_2_terminal_0_values.proved : Section_2_2_printed.sec_2_2_terminal_0_values.statement).
Check (Section_2_2_printed_proofs.sec_2_2_terminal_0_values.met : Section_2_2_printed.sec_2_2_terminal_0_values.instance).
Check (Section_2_2_printed_proofs.sec_2_2_terminal_1_values.proved : Section_2_2_printed.sec_2_2_terminal_1_values.statement).
Check (Section_2_2_printed_proofs.sec_2_2_terminal_1_values.met : Section_2_2_printed.sec_2_2_terminal_1_values.instance).
Check (Section_2_2_printed_proofs.sec_2_2_interpolation.proved : Section_2_2_printed.sec_2_2_interpolation.statement).
Check (Section_2_2_printed_proofs.sec_2_2_interpolation.met : Section_2_2_printed.sec_2_2_interpolation.instance).
Check (Section_2_2_printed_proofs.sec_2_2_end_derivatives.proved : Section_2_2_printed.sec_2_2_end_derivatives.statement).
Check (Section_2_2_printed_proofs.sec_2_2_end_derivatives.met : Section_2_2_printed.sec_2_2_end_derivatives.instance).
Check (Section_2_2_printed_proofs.thm_2_setting.proved : Section_2_2_printed.thm_2_setting.statement).
Check (Section_2_2_printed_proofs.thm_2_setting.met : Section_2_2_printed.thm_2_setting.instance).
Check (Section_2_2_printed_proofs.thm_2_1.proved : Section_2_2_printed.thm_2_1.statement).
Check (Section_2_2_printed_proofs.thm_2_1.met : Section_2_2_printed.thm_2_1.instance).
Check (Section_2_2_printed_proofs.eq_4_Q11.proved : Section_2_2_printed.eq_4_Q11.statement).
Check (Section_2_2_printed_proofs.eq_4_Q11.met : Section_2_2_printed.eq_4_Q11.instance).
Check (Section_2_2_printed_proofs.thm_2_2.proved : Section_2_2_printed.thm_2_2.statement).
Check (Section_2_2_printed_proofs.thm_2_2.met : Section_2_2_printed.thm_2_2.instance).
Check (Section_2_2_printed_proofs.eq_5_Q12.refuted : ~ Section_2_2_printed.eq_5_Q12.statement).
Check (Section_2_2_printed_proofs.eq_5_Q12_corrected.proved : Section_2_2_printed.eq_5_Q12_corrected.statement).
Check (Section_2_2_printed_proofs.eq_5_Q12_corrected.met : Section_2_2_printed.eq_5_Q12_corrected.instance).
Check (Section_2_2_printed_proofs.eq_5_Q12_true.proved : Section_2_2_printed.eq_5_Q12_true.statement).
Check (Section_2_2_printed_proofs.eq_5_Q12_true.met : Section_2_2_printed.eq_5_Q12_true.instance).
Check (Section_2_2_printed_proofs.thm_2_3_a.refuted : ~ Section_2_2_printed.thm_2_3_a.statement).
Check (Section_2_2_printed_proofs.thm_2_3_b.refuted : ~ Section_2_2_printed.thm_2_3_b.statement).
Check (Section_2_2_printed_proofs.thm_2_3_true.proved : Section_2_2_printed.thm_2_3_true.statement).
Check (Section_2_2_printed_proofs.thm_2_3_true.met : Section_2_2_printed.thm_2_3_true.instance).
Check (Section_2_2_printed_proofs.thm_2_3_iff.proved : Section_2_2_printed.thm_2_3_iff.statement).
Check (Section_2_2_printed_proofs.thm_2_3_iff.met : Section_2_2_printed.thm_2_3_iff.instance).
Check (Section_2_2_printed_proofs.thm_2_3_necessary.proved : Section_2_2_printed.thm_2_3_necessary.statement).
Check (Section_2_2_printed_proofs.thm_2_3_necessary.met : Section_2_2_printed.thm_2_3_necessary.instance).
Check (Section_2_2_printed_proofs.thm_2_3_sufficient.proved : Section_2_2_printed.thm_2_3_sufficient.statement).
Check (Section_2_2_printed_proofs.thm_2_3_sufficient.met : Section_2_2_printed.thm_2_3_sufficient.instance).
Check (Section_2_2_printed_proofs.thm_2_3_jump.proved : Section_2_2_printed.thm_2_3_jump.statement).
Check (Section_2_2_printed_proofs.thm_2_3_jump.met : Section_2_2_printed.thm_2_3_jump.instance).
Check (Section_2_2_printed_proofs.thm_2_3_when.proved : Section_2_2_printed.thm_2_3_when.statement).
Check (Section_2_2_printed_proofs.thm_2_3_when.met : Section_2_2_printed.thm_2_3_when.instance).
Check (Section_2_2_printed_proofs.eq_6_Q11.proved : Section_2_2_printed.eq_6_Q11.statement).
Check (Section_2_2_printed_proofs.eq_6_Q11.met : Section_2_2_printed.eq_6_Q11.instance).
Check (Section_2_2_printed_proofs.eq_6_Q12.refuted : ~ Section_2_2_printed.eq_6_Q12.statement).
Check (Section_2_2_printed_proofs.eq_6_Q12_corrected.proved : Section_2_2_printed.eq_6_Q12_corrected.statement).
Check (Section_2_2_printed_proofs.eq_6_Q12_corrected.met : Section_2_2_printed.eq_6_Q12_corrected.instance).
Check (Section_2_2_printed_proofs.eq_6_Q13.refuted : ~ Section_2_2_printed.eq_6_Q13.statement).
Check (Section_2_2_printed_proofs.eq_6_Q13_true.proved : Section_2_2_printed.eq_6_Q13_true.statement).
Check (Section_2_2_printed_proofs.eq_6_Q13_true.met : Section_2_2_printed.eq_6_Q13_true.instance).
Check (Section_2_2_printed_proofs.thm_2_4_a.refuted : ~ Section_2_2_printed.thm_2_4_a.statement).
Check (Section_2_2_printed_proofs.thm_2_4_c.refuted : ~ Section_2_2_printed.thm_2_4_c.statement).
Check (Section_2_2_printed_proofs.thm_2_4_b.refuted : ~ Section_2_2_printed.thm_2_4_b.statement).
Check (Section_2_2_printed_proofs.thm_2_4_true.proved : Section_2_2_printed.thm_2_4_true.statement).
Check (Section_2_2_printed_proofs.thm_2_4_true.met : Section_2_2_printed.thm_2_4_true.instance).
Check (Section_2_2_printed_proofs.thm_2_4_iff.proved : Section_2_2_printed.thm_2_4_iff.statement).
Check (Section_2_2_printed_proofs.thm_2_4_iff.met : Section_2_2_printed.thm_2_4_iff.instance).
Check (Section_2_2_printed_proofs.thm_2_4_necessary.proved : Section_2_2_printed.thm_2_4_necessary.statement).
Check (Section_2_2_printed_proofs.thm_2_4_necessary.met : Section_2_2_printed.thm_2_4_necessary.instance).
Check (Section_2_2_printed_proofs.thm_2_4_sufficient.proved : Section_2_2_printed.thm_2_4_sufficient.statement).
Check (Section_2_2_printed_proofs.thm_2_4_sufficient.met : Section_2_2_printed.thm_2_4_sufficient.instance).
Check (Section_2_2_printed_proofs.thm_2_4_sufficient_quintic.proved : Section_2_2_printed.thm_2_4_sufficient_quintic.statement).
Check (Section_2_2_printed_proofs.thm_2_4_sufficient_quintic.met : Section_2_2_printed.thm_2_4_sufficient_quintic.instance).
Check (Section_2_2_printed_proofs.thm_2_4_cubic.proved : Section_2_2_printed.thm_2_4_cubic.statement).
Check (Section_2_2_printed_proofs.thm_2_4_cubic.met : Section_2_2_printed.thm_2_4_cubic.instance).
Check (Section_2_2_printed_proofs.thm_2_a.proved : Section_2_2_printed.thm_2_a.statement).
Check (Section_2_2_printed_proofs.thm_2_a.met : Section_2_2_printed.thm_2_a.instance).
Check (Section_2_2_printed_proofs.thm_2_a1.proved : Section_2_2_printed.thm_2_a1.statement).
Check (Section_2_2_printed_proofs.thm_2_a1.met : Section_2_2_printed.thm_2_a1.instance).
Check (Section_2_2_printed_proofs.thm_2_a1_sign.proved : Section_2_2_printed.thm_2_a1_sign.statement).
Check (Section_2_2_printed_proofs.thm_2_a1_sign.met : Section_2_2_printed.thm_2_a1_sign.instance).
Check (Section_2_2_printed_proofs.thm_2_a2.proved : Section_2_2_printed.thm_2_a2.statement).
Check (Section_2_2_printed_proofs.thm_2_a2.met : Section_2_2_printed.thm_2_a2.instance).
Check (Section_2_2_printed_proofs.thm_2_a3.refuted : ~ Section_2_2_printed.thm_2_a3.statement).
Check (Section_2_2_printed_proofs.thm_2_a3_corrected.proved : Section_2_2_printed.thm_2_a3_corrected.statement).
Check (Section_2_2_printed_proofs.thm_2_a3_corrected.met : Section_2_2_printed.thm_2_a3_corrected.instance).
Check (Section_2_2_printed_proofs.thm_2_a3_true.proved : Section_2_2_printed.thm_2_a3_true.statement).
Check (Section_2_2_printed_proofs.thm_2_a3_true.met : Section_2_2_printed.thm_2_a3_true.instance).
Check (Section_2_2_printed_proofs.thm_2_b1.proved : Section_2_2_printed.thm_2_b1.statement).
Check (Section_2_2_printed_proofs.thm_2_b1.met : Section_2_2_printed.thm_2_b1.instance).
Check (Section_2_2_printed_proofs.thm_2_b1_sign.proved : Section_2_2_printed.thm_2_b1_sign.statement).
Check (Section_2_2_printed_proofs.thm_2_b1_sign.met : Section_2_2_printed.thm_2_b1_sign.instance).
Check (Section_2_2_printed_proofs.thm_2_b2.refuted : ~ Section_2_2_printed.thm_2_b2.statement).
Check (Section_2_2_printed_proofs.thm_2_b2_true.proved : Section_2_2_printed.thm_2_b2_true.statement).
Check (Section_2_2_printed_proofs.thm_2_b2_true.met : Section_2_2_printed.thm_2_b2_true.instance).
Check (Section_2_2_printed_proofs.thm_2_b3.refuted : ~ Section_2_2_printed.thm_2_b3.statement).
Check (Section_2_2_printed_proofs.thm_2_b3_corrected.proved : Section_2_2_printed.thm_2_b3_corrected.statement).
Check (Section_2_2_printed_proofs.thm_2_b3_corrected.met : Section_2_2_printed.thm_2_b3_corrected.instance).
Check (Section_2_2_printed_proofs.thm_2_b3_true.proved : Section_2_2_printed.thm_2_b3_true.statement).
Check (Section_2_2_printed_proofs.thm_2_b3_true.met : Section_2_2_printed.thm_2_b3_true.instance).
Check (Section_2_2_printed_proofs.thm_2_b4.refuted : ~ Section_2_2_printed.thm_2_b4.statement).
Check (Section_2_2_printed_proofs.thm_2_b4_corrected.proved : Section_2_2_printed.thm_2_b4_corrected.statement).
Check (Section_2_2_printed_proofs.thm_2_b4_corrected.met : Section_2_2_printed.thm_2_b4_corrected.instance).
Check (Section_2_2_printed_proofs.thm_2_b4_true.proved : Section_2_2_printed.thm_2_b4_true.statement).
Check (Section_2_2_printed_proofs.thm_2_b4_true.met : Section_2_2_printed.thm_2_b4_true.instance).
Check (Section_2_2_printed_proofs.thm_2_c1.proved : Section_2_2_printed.thm_2_c1.statement).
Check (Section_2_2_printed_proofs.thm_2_c1.met : Section_2_2_printed.thm_2_c1.instance).
Check (Section_2_2_proofs.def_2_points.refuted : ~ Section_2_2.def_2_points.statement).
Check (Section_2_2_proofs.eq_3.proved : Section_2_2.eq_3.statement).
Check (Section_2_2_proofs.eq_3.met : Section_2_2.eq_3.instance).
Check (Section_2_2_proofs.sec_2_2_symmetry_as_in_Theorem_1.proved : Section_2_2.sec_2_2_symmetry_as_in_Theorem_1.statement).
Check (Section_2_2_proofs.sec_2_2_symmetry_as_in_Theorem_1.met : Section_2_2.sec_2_2_symmetry_as_in_Theorem_1.instance).
Check (Section_2_2_proofs.sec_2_2_symmetry_parameters_exchanged.proved : Section_2_2.sec_2_2_symmetry_parameters_exchanged.statement).
Check (Section_2_2_proofs.sec_2_2_symmetry_parameters_exchanged.met : Section_2_2.sec_2_2_symmetry_parameters_exchanged.instance).
Check (Section_2_2_proofs.sec_2_2_symmetry_as_for_B_zier_curves.refuted : ~ Section_2_2.sec_2_2_symmetry_as_for_B_zier_curves.statement).
Check (Section_2_2_proofs.sec_2_2_convex_hull.proved : Section_2_2.sec_2_2_convex_hull.statement).
Check (Section_2_2_proofs.sec_2_2_convex_hull.met : Section_2_2.sec_2_2_convex_hull.instance).
Check (Section_2_2_proofs.sec_2_2_variation_diminishing_order_2.proved : Section_2_2.sec_2_2_variation_diminishing_order_2.statement).
Check (Section_2_2_proofs.sec_2_2_variation_diminishing_order_2.met : Section_2_2.sec_2_2_variation_diminishing_order_2.instance).
Check (Section_2_2_proofs.sec_2_2_invariance.proved : Section_2_2.sec_2_2_invariance.statement).
Check (Section_2_2_proofs.sec_2_2_invariance.met : Section_2_2.sec_2_2_invariance.instance).
Check (Section_2_2_proofs.sec_2_2_shape_adjustable.proved : Section_2_2.sec_2_2_shape_adjustable.statement).
Check (Section_2_2_proofs.sec_2_2_shape_adjustable.met : Section_2_2.sec_2_2_shape_adjustable.instance).
Check (Section_2_2_proofs.sec_2_2_terminal_0_values.proved : Section_2_2.sec_2_2_terminal_0_values.statement).
Check (Section_2_2_proofs.sec_2_2_terminal_0_values.met : Section_2_2.sec_2_2_terminal_0_values.instance).
Check (Section_2_2_proofs.sec_2_2_terminal_1_values.proved : Section_2_2.sec_2_2_terminal_1_values.statement).
Check (Section_2_2_proofs.sec_2_2_terminal_1_values.met : Section_2_2.sec_2_2_terminal_1_values.instance).
Check (Section_2_2_proofs.sec_2_2_interpolation.proved : Section_2_2.sec_2_2_interpolation.statement).
Check (Section_2_2_proofs.sec_2_2_interpolation.met : Section_2_2.sec_2_2_interpolation.instance).
Check (Section_2_2_proofs.sec_2_2_end_derivatives.proved : Section_2_2.sec_2_2_end_derivatives.statement).
Check (Section_2_2_proofs.sec_2_2_end_derivatives.met : Section_2_2.sec_2_2_end_derivatives.instance).
Check (Section_2_2_proofs.thm_2_setting.proved : Section_2_2.thm_2_setting.statement).
Check (Section_2_2_proofs.thm_2_setting.met : Section_2_2.thm_2_setting.instance).
Check (Section_2_2_proofs.thm_2_1.proved : Section_2_2.thm_2_1.statement).
Check (Section_2_2_proofs.thm_2_1.met : Section_2_2.thm_2_1.instance).
Check (Section_2_2_proofs.eq_4_Q11.proved : Section_2_2.eq_4_Q11.statement).
Check (Section_2_2_proofs.eq_4_Q11.met : Section_2_2.eq_4_Q11.instance).
Check (Section_2_2_proofs.thm_2_2.proved : Section_2_2.thm_2_2.statement).
Check (Section_2_2_proofs.thm_2_2.met : Section_2_2.thm_2_2.instance).
Check (Section_2_2_proofs.eq_5_Q12.refuted : ~ Section_2_2.eq_5_Q12.statement).
Check (Section_2_2_proofs.eq_5_Q12_corrected.proved : Section_2_2.eq_5_Q12_corrected.statement).
Check (Section_2_2_proofs.eq_5_Q12_corrected.met : Section_2_2.eq_5_Q12_corrected.instance).
Check (Section_2_2_proofs.eq_5_Q12_true.proved : Section_2_2.eq_5_Q12_true.statement).
Check (Section_2_2_proofs.eq_5_Q12_true.met : Section_2_2.eq_5_Q12_true.instance).
Check (Section_2_2_proofs.thm_2_3_a.refuted : ~ Section_2_2.thm_2_3_a.statement).
Check (Section_2_2_proofs.thm_2_3_b.refuted : ~ Section_2_2.thm_2_3_b.statement).
Check (Section_2_2_proofs.thm_2_3_true.proved : Section_2_2.thm_2_3_true.statement).
Check (Section_2_2_proofs.thm_2_3_true.met : Section_2_2.thm_2_3_true.instance).
Check (Section_2_2_proofs.thm_2_3_iff.proved : Section_2_2.thm_2_3_iff.statement).
Check (Section_2_2_proofs.thm_2_3_iff.met : Section_2_2.thm_2_3_iff.instance).
Check (Section_2_2_proofs.thm_2_3_necessary.proved : Section_2_2.thm_2_3_necessary.statement).
Check (Section_2_2_proofs.thm_2_3_necessary.met : Section_2_2.thm_2_3_necessary.instance).
Check (Section_2_2_proofs.thm_2_3_sufficient.proved : Section_2_2.thm_2_3_sufficient.statement).
Check (Section_2_2_proofs.thm_2_3_sufficient.met : Section_2_2.thm_2_3_sufficient.instance).
Check (Section_2_2_proofs.thm_2_3_jump.proved : Section_2_2.thm_2_3_jump.statement).
Check (Section_2_2_proofs.thm_2_3_jump.met : Section_2_2.thm_2_3_jump.instance).
Check (Section_2_2_proofs.thm_2_3_when.proved : Section_2_2.thm_2_3_when.statement).
Check (Section_2_2_proofs.thm_2_3_when.met : Section_2_2.thm_2_3_when.instance).
Check (Section_2_2_proofs.eq_6_Q11.proved : Section_2_2.eq_6_Q11.statement).
Check (Section_2_2_proofs.eq_6_Q11.met : Section_2_2.eq_6_Q11.instance).
Check (Section_2_2_proofs.eq_6_Q12.refuted : ~ Section_2_2.eq_6_Q12.statement).
Check (Section_2_2_proofs.eq_6_Q12_corrected.proved : Section_2_2.eq_6_Q12_corrected.statement).
Check (Section_2_2_proofs.eq_6_Q12_corrected.met : Section_2_2.eq_6_Q12_corrected.instance).
Check (Section_2_2_proofs.eq_6_Q13.refuted : ~ Section_2_2.eq_6_Q13.statement).
Check (Section_2_2_proofs.eq_6_Q13_true.proved : Section_2_2.eq_6_Q13_true.statement).
Check (Section_2_2_proofs.eq_6_Q13_true.met : Section_2_2.eq_6_Q13_true.instance).
Check (Section_2_2_proofs.thm_2_4_a.refuted : ~ Section_2_2.thm_2_4_a.statement).
Check (Section_2_2_proofs.thm_2_4_c.refuted : ~ Section_2_2.thm_2_4_c.statement).
Check (Section_2_2_proofs.thm_2_4_b.refuted : ~ Section_2_2.thm_2_4_b.statement).
Check (Section_2_2_proofs.thm_2_4_true.proved : Section_2_2.thm_2_4_true.statement).
Check (Section_2_2_proofs.thm_2_4_true.met : Section_2_2.thm_2_4_true.instance).
Check (Section_2_2_proofs.thm_2_4_iff.proved : Section_2_2.thm_2_4_iff.statement).
Check (Section_2_2_proofs.thm_2_4_iff.met : Section_2_2.thm_2_4_iff.instance).
Check (Section_2_2_proofs.thm_2_4_necessary.proved : Section_2_2.thm_2_4_necessary.statement).
Check (Section_2_2_proofs.thm_2_4_necessary.met : Section_2_2.thm_2_4_necessary.instance).
Check (Section_2_2_proofs.thm_2_4_sufficient.proved : Section_2_2.thm_2_4_sufficient.statement).
Check (Section_2_2_proofs.thm_2_4_sufficient.met : Section_2_2.thm_2_4_sufficient.instance).
Check (Section_2_2_proofs.thm_2_4_sufficient_quintic.proved : Section_2_2.thm_2_4_sufficient_quintic.statement).
Check (Section_2_2_proofs.thm_2_4_sufficient_quintic.met : Section_2_2.thm_2_4_sufficient_quintic.instance).
Check (Section_2_2_proofs.thm_2_4_cubic.proved : Section_2_2.thm_2_4_cubic.statement).
Check (Section_2_2_proofs.thm_2_4_cubic.met : Section_2_2.thm_2_4_cubic.instance).
Check (Section_2_2_proofs.thm_2_a.proved : Section_2_2.thm_2_a.statement).
Check (Section_2_2_proofs.thm_2_a.met : Section_2_2.thm_2_a.instance).
Check (Section_2_2_proofs.thm_2_a1.proved : Section_2_2.thm_2_a1.statement).
Check (Section_2_2_proofs.thm_2_a1.met : Section_2_2.thm_2_a1.instance).
Check (Section_2_2_proofs.thm_2_a1_sign.proved : Section_2_2.thm_2_a1_sign.statement).
Check (Section_2_2_proofs.thm_2_a1_sign.met : Section_2_2.thm_2_a1_sign.instance).
Check (Section_2_2_proofs.thm_2_a2.proved : Section_2_2.thm_2_a2.statement).
Check (Section_2_2_proofs.thm_2_a2.met : Section_2_2.thm_2_a2.instance).
Check (Section_2_2_proofs.thm_2_a3.refuted : ~ Section_2_2.thm_2_a3.statement).
Check (Section_2_2_proofs.thm_2_a3_corrected.proved : Section_2_2.thm_2_a3_corrected.statement).
Check (Section_2_2_proofs.thm_2_a3_corrected.met : Section_2_2.thm_2_a3_corrected.instance).
Check (Section_2_2_proofs.thm_2_a3_true.proved : Section_2_2.thm_2_a3_true.statement).
Check (Section_2_2_proofs.thm_2_a3_true.met : Section_2_2.thm_2_a3_true.instance).
Check (Section_2_2_proofs.thm_2_b1.proved : Section_2_2.thm_2_b1.statement).
Check (Section_2_2_proofs.thm_2_b1.met : Section_2_2.thm_2_b1.instance).
Check (Section_2_2_proofs.thm_2_b1_sign.proved : Section_2_2.thm_2_b1_sign.statement).
Check (Section_2_2_proofs.thm_2_b1_sign.met : Section_2_2.thm_2_b1_sign.instance).
Check (Section_2_2_proofs.thm_2_b2.refuted : ~ Section_2_2.thm_2_b2.statement).
Check (Section_2_2_proofs.thm_2_b2_true.proved : Section_2_2.thm_2_b2_true.statement).
Check (Section_2_2_proofs.thm_2_b2_true.met : Section_2_2.thm_2_b2_true.instance).
Check (Section_2_2_proofs.thm_2_b3.refuted : ~ Section_2_2.thm_2_b3.statement).
Check (Section_2_2_proofs.thm_2_b3_corrected.proved : Section_2_2.thm_2_b3_corrected.statement).
Check (Section_2_2_proofs.thm_2_b3_corrected.met : Section_2_2.thm_2_b3_corrected.instance).
Check (Section_2_2_proofs.thm_2_b3_true.proved : Section_2_2.thm_2_b3_true.statement).
Check (Section_2_2_proofs.thm_2_b3_true.met : Section_2_2.thm_2_b3_true.instance).
Check (Section_2_2_proofs.thm_2_b4.refuted : ~ Section_2_2.thm_2_b4.statement).
Check (Section_2_2_proofs.thm_2_b4_corrected.proved : Section_2_2.thm_2_b4_corrected.statement).
Check (Section_2_2_proofs.thm_2_b4_corrected.met : Section_2_2.thm_2_b4_corrected.instance).
Check (Section_2_2_proofs.thm_2_b4_true.proved : Section_2_2.thm_2_b4_true.statement).
Check (Section_2_2_proofs.thm_2_b4_true.met : Section_2_2.thm_2_b4_true.instance).
Check (Section_2_2_proofs.thm_2_c1.proved : Section_2_2.thm_2_c1.statement).
Check (Section_2_2_proofs.thm_2_c1.met : Section_2_2.thm_2_c1.instance).
Check (Section_2_3_printed_proofs.eq_7.proved : Section_2_3_printed.eq_7.statement).
Check (Section_2_3_printed_proofs.eq_7.met : Section_2_3_printed.eq_7.instance).
Check (Section_2_3_printed_proofs.sec_2_3_features_a.proved : Section_2_3_printed.sec_2_3_features_a.statement).
Check (Section_2_3_printed_proofs.sec_2_3_features_a.met : Section_2_3_printed.sec_2_3_features_a.instance).
Check (Section_2_3_printed_proofs.sec_2_3_features_b.proved : Section_2_3_printed.sec_2_3_features_b.statement).
Check (Section_2_3_printed_proofs.sec_2_3_features_b.met : Section_2_3_printed.sec_2_3_features_b.instance).
Check (Section_2_3_printed_proofs.sec_2_3_features_c.proved : Section_2_3_printed.sec_2_3_features_c.statement).
Check (Section_2_3_printed_proofs.sec_2_3_features_c.met : Section_2_3_printed.sec_2_3_features_c.instance).
Check (Section_2_3_printed_proofs.sec_2_3_features_d.proved : Section_2_3_printed.sec_2_3_features_d.statement).
Check (Section_2_3_printed_proofs.sec_2_3_features_d.met : Section_2_3_printed.sec_2_3_features_d.instance).
Check (Section_2_3_printed_proofs.sec_2_3_classical_the_features_of_Sect__2_2.proved : Section_2_3_printed.sec_2_3_classical_the_features_of_Sect__2_2.statement).
Check (Section_2_3_printed_proofs.sec_2_3_classical_the_features_of_Sect__2_2.met : Section_2_3_printed.sec_2_3_classical_the_features_of_Sect__2_2.instance).
Check (Section_2_3_printed_proofs.sec_2_3_classical_every_property.refuted : ~ Section_2_3_printed.sec_2_3_classical_every_property.statement).
Check (Section_2_3_proofs.eq_7.proved : Section_2_3.eq_7.statement).
Check (Section_2_3_proofs.eq_7.met : Section_2_3.eq_7.instance).
Check (Section_2_3_proofs.sec_2_3_features_a.proved : Section_2_3.sec_2_3_features_a.statement).
Check (Section_2_3_proofs.sec_2_3_features_a.met : Section_2_3.sec_2_3_features_a.instance).
Check (Section_2_3_proofs.sec_2_3_features_b.proved : Section_2_3.sec_2_3_features_b.statement).
Check (Section_2_3_proofs.sec_2_3_features_b.met : Section_2_3.sec_2_3_features_b.instance).
Check (Section_2_3_proofs.sec_2_3_features_c.proved : Section_2_3.sec_2_3_features_c.statement).
Check (Section_2_3_proofs.sec_2_3_features_c.met : Section_2_3.sec_2_3_features_c.instance).
Check (Section_2_3_proofs.sec_2_3_features_d.proved : Section_2_3.sec_2_3_features_d.statement).
Check (Section_2_3_proofs.sec_2_3_features_d.met : Section_2_3.sec_2_3_features_d.instance).
Check (Section_2_3_proofs.sec_2_3_classical_the_features_of_Sect__2_2.proved : Section_2_3.sec_2_3_classical_the_features_of_Sect__2_2.statement).
Check (Section_2_3_proofs.sec_2_3_classical_the_features_of_Sect__2_2.met : Section_2_3.sec_2_3_classical_the_features_of_Sect__2_2.instance).
Check (Section_2_3_proofs.sec_2_3_classical_every_property.refuted : ~ Section_2_3.sec_2_3_classical_every_property.statement).
Check (Section_3_1_printed_proofs.sec_3_1_i.proved : Section_3_1_printed.sec_3_1_i.statement).
Check (Section_3_1_printed_proofs.sec_3_1_i.met : Section_3_1_printed.sec_3_1_i.instance).
Check (Section_3_1_printed_proofs.eq_8_1.proved : Section_3_1_printed.eq_8_1.statement).
Check (Section_3_1_printed_proofs.eq_8_1.met : Section_3_1_printed.eq_8_1.instance).
Check (Section_3_1_printed_proofs.eq_8_2.proved : Section_3_1_printed.eq_8_2.statement).
Check (Section_3_1_printed_proofs.eq_8_2.met : Section_3_1_printed.eq_8_2.instance).
Check (Section_3_1_printed_proofs.prop_3_1.proved : Section_3_1_printed.prop_3_1.statement).
Check (Section_3_1_printed_proofs.prop_3_1.met : Section_3_1_printed.prop_3_1.instance).
Check (Section_3_1_printed_proofs.sec_3_1_translating.proved : Section_3_1_printed.sec_3_1_translating.statement).
Check (Section_3_1_printed_proofs.sec_3_1_translating.met : Section_3_1_printed.sec_3_1_translating.instance).
Check (Section_3_1_printed_proofs.sec_3_1_not_tensor_literal.refuted : ~ Section_3_1_printed.sec_3_1_not_tensor_literal.statement).
Check (Section_3_1_printed_proofs.sec_3_1_not_tensor_as_it_stands.proved : Section_3_1_printed.sec_3_1_not_tensor_as_it_stands.statement).
Check (Section_3_1_printed_proofs.sec_3_1_not_tensor_as_it_stands.met : Section_3_1_printed.sec_3_1_not_tensor_as_it_stands.instance).
Check (Section_3_1_printed_proofs.sec_3_1_order_one_missing_none.proved : Section_3_1_printed.sec_3_1_order_one_missing_none.statement).
Check (Section_3_1_printed_proofs.sec_3_1_order_one_missing_none.met : Section_3_1_printed.sec_3_1_order_one_missing_none.instance).
Check (Section_3_1_printed_proofs.eq_10.proved : Section_3_1_printed.eq_10.statement).
Check (Section_3_1_printed_proofs.eq_10.met : Section_3_1_printed.eq_10.instance).
Check (Section_3_1_printed_proofs.eq_10_bernstein.proved : Section_3_1_printed.eq_10_bernstein.statement).
Check (Section_3_1_printed_proofs.eq_10_bernstein.met : Section_3_1_printed.eq_10_bernstein.instance).
Check (Section_3_1_printed_proofs.eq_10_extending.proved : Section_3_1_printed.eq_10_extending.statement).
Check (Section_3_1_printed_proofs.eq_10_extending.met : Section_3_1_printed.eq_10_extending.instance).
Check (Section_3_1_printed_proofs.eq_11.refuted : ~ Section_3_1_printed.eq_11.statement).
Check (Section_3_1_printed_proofs.eq_11_corrected.proved : Section_3_1_printed.eq_11_corrected.statement).
Check (Section_3_1_printed_proofs.eq_11_corrected.met : Section_3_1_printed.eq_11_corrected.instance).
Check (Section_3_1_printed_proofs.eq_11_points.refuted : ~ Section_3_1_printed.eq_11_points.statement).
Check (Section_3_1_printed_proofs.eq_11_points_corrected.proved : Section_3_1_printed.eq_11_points_corrected.statement).
Check (Section_3_1_printed_proofs.eq_11_points_corrected.met : Section_3_1_printed.eq_11_points_corrected.instance).
Check (Section_3_1_printed_proofs.eq_11_parameters.proved : Section_3_1_printed.eq_11_parameters.statement).
Check (Section_3_1_printed_proofs.eq_11_parameters.met : Section_3_1_printed.eq_11_parameters.instance).
Check (Section_3_1_printed_proofs.eq_12_1.refuted : ~ Section_3_1_printed.eq_12_1.statement).
Check (Section_3_1_printed_proofs.eq_12_1_corrected.proved : Section_3_1_printed.eq_12_1_corrected.statement).
Check (Section_3_1_printed_proofs.eq_12_1_corrected.met : Section_3_1_printed.eq_12_1_corrected.instance).
Check (Section_3_1_printed_proofs.eq_12_2.proved : Section_3_1_printed.eq_12_2.statement).
Check (Section_3_1_printed_proofs.eq_12_2.met : Section_3_1_printed.eq_12_2.instance).
Check (Section_3_1_printed_proofs.eq_12_3.proved : Section_3_1_printed.eq_12_3.statement).
Check (Section_3_1_printed_proofs.eq_12_3.met : Section_3_1_printed.eq_12_3.instance).
Check (Section_3_1_printed_proofs.eq_12_4.proved : Section_3_1_printed.eq_12_4.statement).
Check (Section_3_1_printed_proofs.eq_12_4.met : Section_3_1_printed.eq_12_4.instance).
Check (Section_3_1_printed_proofs.thm_3.proved : Section_3_1_printed.thm_3.statement).
Check (Section_3_1_printed_proofs.thm_3.met : Section_3_1_printed.thm_3.instance).
Check (Section_3_1_printed_proofs.sec_3_1_benefits.proved : Section_3_1_printed.sec_3_1_benefits.statement).
Check (Section_3_1_printed_proofs.sec_3_1_benefits.met : Section_3_1_printed.sec_3_1_benefits.instance).
Check (Section_3_1_printed_proofs.sec_3_1_any_shape_literal.refuted : ~ Section_3_1_printed.sec_3_1_any_shape_literal.statement).
Check (Section_3_1_printed_proofs.sec_3_1_any_shape_the_shape_changes.proved : Section_3_1_printed.sec_3_1_any_shape_the_shape_changes.statement).
Check (Section_3_1_printed_proofs.sec_3_1_any_shape_the_shape_changes.met : Section_3_1_printed.sec_3_1_any_shape_the_shape_changes.instance).
Check (Section_3_1_printed_proofs.alg_1.proved : Section_3_1_printed.alg_1.statement).
Check (Section_3_1_printed_proofs.alg_1.met : Section_3_1_printed.alg_1.instance).
Check (Section_3_1_printed_proofs.ex_3_1_points.proved : Section_3_1_printed.ex_3_1_points.statement).
Check (Section_3_1_printed_proofs.ex_3_1_normal.proved : Section_3_1_printed.ex_3_1_normal.statement).
Check (Section_3_1_printed_proofs.eq_13.proved : Section_3_1_printed.eq_13.statement).
Check (Section_3_1_printed_proofs.eq_13.met : Section_3_1_printed.eq_13.instance).
Check (Section_3_1_printed_proofs.ex_3_1_net.proved : Section_3_1_printed.ex_3_1_net.statement).
Check (Section_3_1_printed_proofs.ex_3_1_mesh_count.proved : Section_3_1_printed.ex_3_1_mesh_count.statement).
Check (Section_3_1_printed_proofs.ex_3_1_hull.proved : Section_3_1_printed.ex_3_1_hull.statement).
Check (Section_3_1_printed_proofs.ex_3_1_hull.met : Section_3_1_printed.ex_3_1_hull.instance).
Check (Section_3_1_printed_proofs.sec_3_1_effect.proved : Section_3_1_printed.sec_3_1_effect.statement).
Check (Section_3_1_printed_proofs.sec_3_1_effect.met : Section_3_1_printed.sec_3_1_effect.instance).
Check (Section_3_1_printed_proofs.prop_3_1_translation.proved : Section_3_1_printed.prop_3_1_translation.statement).
Check (Section_3_1_printed_proofs.prop_3_1_translation.met : Section_3_1_printed.prop_3_1_translation.instance).
Check (Section_3_1_proofs.sec_3_1_i.proved : Section_3_1.sec_3_1_i.statement).
Check (Section_3_1_proofs.sec_3_1_i.met : Section_3_1.sec_3_1_i.instance).
Check (Section_3_1_proofs.eq_8_1.proved : Section_3_1.eq_8_1.statement).
Check (Section_3_1_proofs.eq_8_1.met : Section_3_1.eq_8_1.instance).
Check (Section_3_1_proofs.eq_8_2.proved : Section_3_1.eq_8_2.statement).
Check (Section_3_1_proofs.eq_8_2.met : Section_3_1.eq_8_2.instance).
Check (Section_3_1_proofs.prop_3_1.proved : Section_3_1.prop_3_1.statement).
Check (Section_3_1_proofs.prop_3_1.met : Section_3_1.prop_3_1.instance).
Check (Section_3_1_proofs.sec_3_1_translating.proved : Section_3_1.sec_3_1_translating.statement).
Check (Section_3_1_proofs.sec_3_1_translating.met : Section_3_1.sec_3_1_translating.instance).
Check (Section_3_1_proofs.sec_3_1_not_tensor_literal.refuted : ~ Section_3_1.sec_3_1_not_tensor_literal.statement).
Check (Section_3_1_proofs.sec_3_1_not_tensor_as_it_stands.proved : Section_3_1.sec_3_1_not_tensor_as_it_stands.statement).
Check (Section_3_1_proofs.sec_3_1_not_tensor_as_it_stands.met : Section_3_1.sec_3_1_not_tensor_as_it_stands.instance).
Check (Section_3_1_proofs.sec_3_1_order_one_missing_none.proved : Section_3_1.sec_3_1_order_one_missing_none.statement).
Check (Section_3_1_proofs.sec_3_1_order_one_missing_none.met : Section_3_1.sec_3_1_order_one_missing_none.instance).
Check (Section_3_1_proofs.eq_10.proved : Section_3_1.eq_10.statement).
Check (Section_3_1_proofs.eq_10.met : Section_3_1.eq_10.instance).
Check (Section_3_1_proofs.eq_10_bernstein.proved : Section_3_1.eq_10_bernstein.statement).
Check (Section_3_1_proofs.eq_10_bernstein.met : Section_3_1.eq_10_bernstein.instance).
Check (Section_3_1_proofs.eq_10_extending.proved : Section_3_1.eq_10_extending.statement).
Check (Section_3_1_proofs.eq_10_extending.met : Section_3_1.eq_10_extending.instance).
Check (Section_3_1_proofs.eq_11.refuted : ~ Section_3_1.eq_11.statement).
Check (Section_3_1_proofs.eq_11_corrected.proved : Section_3_1.eq_11_corrected.statement).
Check (Section_3_1_proofs.eq_11_corrected.met : Section_3_1.eq_11_corrected.instance).
Check (Section_3_1_proofs.eq_11_points.refuted : ~ Section_3_1.eq_11_points.statement).
Check (Section_3_1_proofs.eq_11_points_corrected.proved : Section_3_1.eq_11_points_corrected.statement).
Check (Section_3_1_proofs.eq_11_points_corrected.met : Section_3_1.eq_11_points_corrected.instance).
Check (Section_3_1_proofs.eq_11_parameters.proved : Section_3_1.eq_11_parameters.statement).
Check (Section_3_1_proofs.eq_11_parameters.met : Section_3_1.eq_11_parameters.instance).
Check (Section_3_1_proofs.eq_12_1.refuted : ~ Section_3_1.eq_12_1.statement).
Check (Section_3_1_proofs.eq_12_1_corrected.proved : Section_3_1.eq_12_1_corrected.statement).
Check (Section_3_1_proofs.eq_12_1_corrected.met : Section_3_1.eq_12_1_corrected.instance).
Check (Section_3_1_proofs.eq_12_2.proved : Section_3_1.eq_12_2.statement).
Check (Section_3_1_proofs.eq_12_2.met : Section_3_1.eq_12_2.instance).
Check (Section_3_1_proofs.eq_12_3.proved : Section_3_1.eq_12_3.statement).
Check (Section_3_1_proofs.eq_12_3.met : Section_3_1.eq_12_3.instance).
Check (Section_3_1_proofs.eq_12_4.proved : Section_3_1.eq_12_4.statement).
Check (Section_3_1_proofs.eq_12_4.met : Section_3_1.eq_12_4.instance).
Check (Section_3_1_proofs.thm_3.proved : Section_3_1.thm_3.statement).
Check (Section_3_1_proofs.thm_3.met : Section_3_1.thm_3.instance).
Check (Section_3_1_proofs.sec_3_1_benefits.proved : Section_3_1.sec_3_1_benefits.statement).
Check (Section_3_1_proofs.sec_3_1_benefits.met : Section_3_1.sec_3_1_benefits.instance).
Check (Section_3_1_proofs.sec_3_1_any_shape_literal.refuted : ~ Section_3_1.sec_3_1_any_shape_literal.statement).
Check (Section_3_1_proofs.sec_3_1_any_shape_the_shape_changes.proved : Section_3_1.sec_3_1_any_shape_the_shape_changes.statement).
Check (Section_3_1_proofs.sec_3_1_any_shape_the_shape_changes.met : Section_3_1.sec_3_1_any_shape_the_shape_changes.instance).
Check (Section_3_1_proofs.alg_1.proved : Section_3_1.alg_1.statement).
Check (Section_3_1_proofs.alg_1.met : Section_3_1.alg_1.instance).
Check (Section_3_1_proofs.ex_3_1_points.proved : Section_3_1.ex_3_1_points.statement).
Check (Section_3_1_proofs.ex_3_1_normal.proved : Section_3_1.ex_3_1_normal.statement).
Check (Section_3_1_proofs.eq_13.proved : Section_3_1.eq_13.statement).
Check (Section_3_1_proofs.eq_13.met : Section_3_1.eq_13.instance).
Check (Section_3_1_proofs.ex_3_1_net.proved : Section_3_1.ex_3_1_net.statement).
Check (Section_3_1_proofs.ex_3_1_mesh_count.proved : Section_3_1.ex_3_1_mesh_count.statement).
Check (Section_3_1_proofs.ex_3_1_hull.proved : Section_3_1.ex_3_1_hull.statement).
Check (Section_3_1_proofs.ex_3_1_hull.met : Section_3_1.ex_3_1_hull.instance).
Check (Section_3_1_proofs.sec_3_1_effect.proved : Section_3_1.sec_3_1_effect.statement).
Check (Section_3_1_proofs.sec_3_1_effect.met : Section_3_1.sec_3_1_effect.instance).
Check (Section_3_1_proofs.prop_3_1_translation.proved : Section_3_1.prop_3_1_translation.statement).
Check (Section_3_1_proofs.prop_3_1_translation.met : Section_3_1.prop_3_1_translation.instance).
Check (Section_3_2_printed_proofs.eq_14.proved : Section_3_2_printed.eq_14.statement).
Check (Section_3_2_printed_proofs.eq_14.met : Section_3_2_printed.eq_14.instance).
Check (Section_3_2_printed_proofs.sec_3_2_segments.proved : Section_3_2_printed.sec_3_2_segments.statement).
Check (Section_3_2_printed_proofs.sec_3_2_segments.met : Section_3_2_printed.sec_3_2_segments.instance).
Check (Section_3_2_printed_proofs.sec_3_2_linear.proved : Section_3_2_printed.sec_3_2_linear.statement).
Check (Section_3_2_printed_proofs.sec_3_2_linear.met : Section_3_2_printed.sec_3_2_linear.instance).
Check (Section_3_2_printed_proofs.prop_3_2_a.proved : Section_3_2_printed.prop_3_2_a.statement).
Check (Section_3_2_printed_proofs.prop_3_2_a.met : Section_3_2_printed.prop_3_2_a.instance).
Check (Section_3_2_printed_proofs.prop_3_2_b.proved : Section_3_2_printed.prop_3_2_b.statement).
Check (Section_3_2_printed_proofs.prop_3_2_b.met : Section_3_2_printed.prop_3_2_b.instance).
Check (Section_3_2_printed_proofs.prop_3_2_c.proved : Section_3_2_printed.prop_3_2_c.statement).
Check (Section_3_2_printed_proofs.prop_3_2_c.met : Section_3_2_printed.prop_3_2_c.instance).
Check (Section_3_2_printed_proofs.eq_15.proved : Section_3_2_printed.eq_15.statement).
Check (Section_3_2_printed_proofs.eq_15.met : Section_3_2_printed.eq_15.instance).
Check (Section_3_2_printed_proofs.sec_3_2_fixed.proved : Section_3_2_printed.sec_3_2_fixed.statement).
Check (Section_3_2_printed_proofs.sec_3_2_fixed.met : Section_3_2_printed.sec_3_2_fixed.instance).
Check (Section_3_2_printed_proofs.sec_3_2_list_1.proved : Section_3_2_printed.sec_3_2_list_1.statement).
Check (Section_3_2_printed_proofs.sec_3_2_list_1.met : Section_3_2_printed.sec_3_2_list_1.instance).
Check (Section_3_2_printed_proofs.sec_3_2_list_2.proved : Section_3_2_printed.sec_3_2_list_2.statement).
Check (Section_3_2_printed_proofs.sec_3_2_list_2.met : Section_3_2_printed.sec_3_2_list_2.instance).
Check (Section_3_2_printed_proofs.sec_3_2_list_3.proved : Section_3_2_printed.sec_3_2_list_3.statement).
Check (Section_3_2_printed_proofs.sec_3_2_list_3.met : Section_3_2_printed.sec_3_2_list_3.instance).
Check (Section_3_2_printed_proofs.alg_2_1.proved : Section_3_2_printed.alg_2_1.statement).
Check (Section_3_2_printed_proofs.alg_2_1.met : Section_3_2_printed.alg_2_1.instance).
Check (Section_3_2_printed_proofs.alg_2_2.proved : Section_3_2_printed.alg_2_2.statement).
Check (Section_3_2_printed_proofs.alg_2_2.met : Section_3_2_printed.alg_2_2.instance).
Check (Section_3_2_printed_proofs.alg_2_2_irregular.proved : Section_3_2_printed.alg_2_2_irregular.statement).
Check (Section_3_2_printed_proofs.alg_2_2_irregular.met : Section_3_2_printed.alg_2_2_irregular.instance).
Check (Section_3_2_printed_proofs.eq_16.proved : Section_3_2_printed.eq_16.statement).
Check (Section_3_2_printed_proofs.eq_16.met : Section_3_2_printed.eq_16.instance).
Check (Section_3_2_printed_proofs.ex_3_2_corners.proved : Section_3_2_printed.ex_3_2_corners.statement).
Check (Section_3_2_printed_proofs.ex_3_2_corners.met : Section_3_2_printed.ex_3_2_corners.instance).
Check (Section_3_2_printed_proofs.ex_3_2_division_z_lines.proved : Section_3_2_printed.ex_3_2_division_z_lines.statement).
Check (Section_3_2_printed_proofs.ex_3_2_division_Q0l.proved : Section_3_2_printed.ex_3_2_division_Q0l.statement).
Check (Section_3_2_printed_proofs.ex_3_2_division_Q3l.refuted : ~ Section_3_2_printed.ex_3_2_division_Q3l.statement).
Check (Section_3_2_printed_proofs.ex_3_2_division_Q3l_corrected.proved : Section_3_2_printed.ex_3_2_division_Q3l_corrected.statement).
Check (Section_3_2_printed_proofs.ex_3_2_equal_parts_a.proved : Section_3_2_printed.ex_3_2_equal_parts_a.statement).
Check (Section_3_2_printed_proofs.ex_3_2_equal_parts_b.proved : Section_3_2_printed.ex_3_2_equal_parts_b.statement).
Check (Section_3_2_printed_proofs.ex_3_2_equal_parts_c.proved : Section_3_2_printed.ex_3_2_equal_parts_c.statement).
Check (Section_3_2_printed_proofs.ex_3_2_equal_parts_d.refuted : ~ Section_3_2_printed.ex_3_2_equal_parts_d.statement).
Check (Section_3_2_printed_proofs.ex_3_2_equal_parts_d_corrected.proved : Section_3_2_printed.ex_3_2_equal_parts_d_corrected.statement).
Check (Section_3_2_printed_proofs.ex_3_2_interior.proved : Section_3_2_printed.ex_3_2_interior.statement).
Check (Section_3_2_printed_proofs.ex_3_2_equation.refuted : ~ Section_3_2_printed.ex_3_2_equation.statement).
Check (Section_3_2_printed_proofs.ex_3_2_sixteen.proved : Section_3_2_printed.ex_3_2_sixteen.statement).
Check (Section_3_2_printed_proofs.ex_3_2_coplanar.proved : Section_3_2_printed.ex_3_2_coplanar.statement).
Check (Section_3_2_printed_proofs.ex_3_2_noncoplanar_possible.proved : Section_3_2_printed.ex_3_2_noncoplanar_possible.statement).
Check (Section_3_2_printed_proofs.ex_3_2_noncoplanar_possible.met : Section_3_2_printed.ex_3_2_noncoplanar_possible.instance).
Check (Section_3_2_proofs.eq_14.proved : Section_3_2.eq_14.statement).
Check (Section_3_2_proofs.eq_14.met : Section_3_2.eq_14.instance).
Check (Section_3_2_proofs.sec_3_2_segments.proved : Section_3_2.sec_3_2_segments.statement).
Check (Section_3_2_proofs.sec_3_2_segments.met : Section_3_2.sec_3_2_segments.instance).
Check (Section_3_2_proofs.sec_3_2_linear.proved : Section_3_2.sec_3_2_linear.statement).
Check (Section_3_2_proofs.sec_3_2_linear.met : Section_3_2.sec_3_2_linear.instance).
Check (Section_3_2_proofs.prop_3_2_a.proved : Section_3_2.prop_3_2_a.statement).
Check (Section_3_2_proofs.prop_3_2_a.met : Section_3_2.prop_3_2_a.instance).
Check (Section_3_2_proofs.prop_3_2_b.proved : Section_3_2.prop_3_2_b.statement).
Check (Section_3_2_proofs.prop_3_2_b.met : Section_3_2.prop_3_2_b.instance).
Check (Section_3_2_proofs.prop_3_2_c.proved : Section_3_2.prop_3_2_c.statement).
Check (Section_3_2_proofs.prop_3_2_c.met : Section_3_2.prop_3_2_c.instance).
Check (Section_3_2_proofs.eq_15.proved : Section_3_2.eq_15.statement).
Check (Section_3_2_proofs.eq_15.met : Section_3_2.eq_15.instance).
Check (Section_3_2_proofs.sec_3_2_fixed.proved : Section_3_2.sec_3_2_fixed.statement).
Check (Section_3_2_proofs.sec_3_2_fixed.met : Section_3_2.sec_3_2_fixed.instance).
Check (Section_3_2_proofs.sec_3_2_list_1.proved : Section_3_2.sec_3_2_list_1.statement).
Check (Section_3_2_proofs.sec_3_2_list_1.met : Section_3_2.sec_3_2_list_1.instance).
Check (Section_3_2_proofs.sec_3_2_list_2.proved : Section_3_2.sec_3_2_list_2.statement).
Check (Section_3_2_proofs.sec_3_2_list_2.met : Section_3_2.sec_3_2_list_2.instance).
Check (Section_3_2_proofs.sec_3_2_list_3.proved : Section_3_2.sec_3_2_list_3.statement).
Check (Section_3_2_proofs.sec_3_2_list_3.met : Section_3_2.sec_3_2_list_3.instance).
Check (Section_3_2_proofs.alg_2_1.proved : Section_3_2.alg_2_1.statement).
Check (Section_3_2_proofs.alg_2_1.met : Section_3_2.alg_2_1.instance).
Check (Section_3_2_proofs.alg_2_2.proved : Section_3_2.alg_2_2.statement).
Check (Section_3_2_proofs.alg_2_2.met : Section_3_2.alg_2_2.instance).
Check (Section_3_2_proofs.alg_2_2_irregular.proved : Section_3_2.alg_2_2_irregular.statement).
Check (Section_3_2_proofs.alg_2_2_irregular.met : Section_3_2.alg_2_2_irregular.instance).
Check (Section_3_2_proofs.eq_16.proved : Section_3_2.eq_16.statement).
Check (Section_3_2_proofs.eq_16.met : Section_3_2.eq_16.instance).
Check (Section_3_2_proofs.ex_3_2_corners.proved : Section_3_2.ex_3_2_corners.statement).
Check (Section_3_2_proofs.ex_3_2_corners.met : Section_3_2.ex_3_2_corners.instance).
Check (Section_3_2_proofs.ex_3_2_division_z_lines.proved : Section_3_2.ex_3_2_division_z_lines.statement).
Check (Section_3_2_proofs.ex_3_2_division_Q0l.proved : Section_3_2.ex_3_2_division_Q0l.statement).
Check (Section_3_2_proofs.ex_3_2_division_Q3l.refuted : ~ Section_3_2.ex_3_2_division_Q3l.statement).
Check (Section_3_2_proofs.ex_3_2_division_Q3l_corrected.proved : Section_3_2.ex_3_2_division_Q3l_corrected.statement).
Check (Section_3_2_proofs.ex_3_2_equal_parts_a.proved : Section_3_2.ex_3_2_equal_parts_a.statement).
Check (Section_3_2_proofs.ex_3_2_equal_parts_b.proved : Section_3_2.ex_3_2_equal_parts_b.statement).
Check (Section_3_2_proofs.ex_3_2_equal_parts_c.proved : Section_3_2.ex_3_2_equal_parts_c.statement).
Check (Section_3_2_proofs.ex_3_2_equal_parts_d.refuted : ~ Section_3_2.ex_3_2_equal_parts_d.statement).
Check (Section_3_2_proofs.ex_3_2_equal_parts_d_corrected.proved : Section_3_2.ex_3_2_equal_parts_d_corrected.statement).
Check (Section_3_2_proofs.ex_3_2_interior.proved : Section_3_2.ex_3_2_interior.statement).
Check (Section_3_2_proofs.ex_3_2_equation.refuted : ~ Section_3_2.ex_3_2_equation.statement).
Check (Section_3_2_proofs.ex_3_2_sixteen.proved : Section_3_2.ex_3_2_sixteen.statement).
Check (Section_3_2_proofs.ex_3_2_coplanar.proved : Section_3_2.ex_3_2_coplanar.statement).
Check (Section_3_2_proofs.ex_3_2_noncoplanar_possible.proved : Section_3_2.ex_3_2_noncoplanar_possible.statement).
Check (Section_3_2_proofs.ex_3_2_noncoplanar_possible.met : Section_3_2.ex_3_2_noncoplanar_possible.instance).
Check (Section_3_3_printed_proofs.sec_3_3_generatrix.proved : Section_3_3_printed.sec_3_3_generatrix.statement).
Check (Section_3_3_printed_proofs.sec_3_3_generatrix.met : Section_3_3_printed.sec_3_3_generatrix.instance).
Check (Section_3_3_printed_proofs.sec_3_3_same_degree_literal.refuted : ~ Section_3_3_printed.sec_3_3_same_degree_literal.statement).
Check (Section_3_3_printed_proofs.sec_3_3_same_degree_in_general.proved : Section_3_3_printed.sec_3_3_same_degree_in_general.statement).
Check (Section_3_3_printed_proofs.sec_3_3_same_degree_in_general.met : Section_3_3_printed.sec_3_3_same_degree_in_general.instance).
Check (Section_3_3_printed_proofs.eq_17_0.proved : Section_3_3_printed.eq_17_0.statement).
Check (Section_3_3_printed_proofs.eq_17_0.met : Section_3_3_printed.eq_17_0.instance).
Check (Section_3_3_printed_proofs.eq_17_1.proved : Section_3_3_printed.eq_17_1.statement).
Check (Section_3_3_printed_proofs.eq_17_1.met : Section_3_3_printed.eq_17_1.instance).
Check (Section_3_3_printed_proofs.sec_3_3_condition_1.proved : Section_3_3_printed.sec_3_3_condition_1.statement).
Check (Section_3_3_printed_proofs.sec_3_3_condition_1.met : Section_3_3_printed.sec_3_3_condition_1.instance).
Check (Section_3_3_printed_proofs.sec_3_3_condition_2.refuted : ~ Section_3_3_printed.sec_3_3_condition_2.statement).
Check (Section_3_3_printed_proofs.eq_18.refuted : ~ Section_3_3_printed.eq_18.statement).
Check (Section_3_3_printed_proofs.eq_18_corrected.proved : Section_3_3_printed.eq_18_corrected.statement).
Check (Section_3_3_printed_proofs.eq_18_corrected.met : Section_3_3_printed.eq_18_corrected.instance).
Check (Section_3_3_printed_proofs.eq_18_true.proved : Section_3_3_printed.eq_18_true.statement).
Check (Section_3_3_printed_proofs.eq_18_true.met : Section_3_3_printed.eq_18_true.instance).
Check (Section_3_3_printed_proofs.eq_18_sufficient.proved : Section_3_3_printed.eq_18_sufficient.statement).
Check (Section_3_3_printed_proofs.eq_18_sufficient.met : Section_3_3_printed.eq_18_sufficient.instance).
Check (Section_3_3_printed_proofs.eq_18_necessary.proved : Section_3_3_printed.eq_18_necessary.statement).
Check (Section_3_3_printed_proofs.eq_18_necessary.met : Section_3_3_printed.eq_18_necessary.instance).
Check (Section_3_3_printed_proofs.eq_18_defect.proved : Section_3_3_printed.eq_18_defect.statement).
Check (Section_3_3_printed_proofs.eq_18_defect.met : Section_3_3_printed.eq_18_defect.instance).
Check (Section_3_3_printed_proofs.eq_18_tensor.proved : Section_3_3_printed.eq_18_tensor.statement).
Check (Section_3_3_printed_proofs.eq_18_tensor.met : Section_3_3_printed.eq_18_tensor.instance).
Check (Section_3_3_printed_proofs.sec_3_3_benefits_a.proved : Section_3_3_printed.sec_3_3_benefits_a.statement).
Check (Section_3_3_printed_proofs.sec_3_3_benefits_a.met : Section_3_3_printed.sec_3_3_benefits_a.instance).
Check (Section_3_3_printed_proofs.prop_3_3_a.proved : Section_3_3_printed.prop_3_3_a.statement).
Check (Section_3_3_printed_proofs.prop_3_3_a.met : Section_3_3_printed.prop_3_3_a.instance).
Check (Section_3_3_printed_proofs.prop_3_3_b.proved : Section_3_3_printed.prop_3_3_b.statement).
Check (Section_3_3_printed_proofs.prop_3_3_b.met : Section_3_3_printed.prop_3_3_b.instance).
Check (Section_3_3_printed_proofs.prop_3_4_a.proved : Section_3_3_printed.prop_3_4_a.statement).
Check (Section_3_3_printed_proofs.prop_3_4_a.met : Section_3_3_printed.prop_3_4_a.instance).
Check (Section_3_3_printed_proofs.prop_3_4_a_net.proved : Section_3_3_printed.prop_3_4_a_net.statement).
Check (Section_3_3_printed_proofs.prop_3_4_a_net.met : Section_3_3_printed.prop_3_4_a_net.instance).
Check (Section_3_3_printed_proofs.prop_3_4_b.proved : Section_3_3_printed.prop_3_4_b.statement).
Check (Section_3_3_printed_proofs.prop_3_4_b.met : Section_3_3_printed.prop_3_4_b.instance).
Check (Section_3_3_printed_proofs.alg_3_a.refuted : ~ Section_3_3_printed.alg_3_a.statement).
Check (Section_3_3_printed_proofs.alg_3_a_corrected.proved : Section_3_3_printed.alg_3_a_corrected.statement).
Check (Section_3_3_printed_proofs.alg_3_a_corrected.met : Section_3_3_printed.alg_3_a_corrected.instance).
Check (Section_3_3_printed_proofs.alg_3_b.refuted : ~ Section_3_3_printed.alg_3_b.statement).
Check (Section_3_3_printed_proofs.ex_3_3_curves.refuted : ~ Section_3_3_printed.ex_3_3_curves.statement).
Check (Section_3_3_printed_proofs.ex_3_3_curves_corrected.proved : Section_3_3_printed.ex_3_3_curves_corrected.statement).
Check (Section_3_3_printed_proofs.ex_3_3_curves_corrected.met : Section_3_3_printed.ex_3_3_curves_corrected.instance).
Check (Section_3_3_printed_proofs.eq_19.refuted : ~ Section_3_3_printed.eq_19.statement).
Check (Section_3_3_printed_proofs.eq_19_tensor.refuted : ~ Section_3_3_printed.eq_19_tensor.statement).
Check (Section_3_3_printed_proofs.ex_3_3_gl_0.refuted : ~ Section_3_3_printed.ex_3_3_gl_0.statement).
Check (Section_3_3_printed_proofs.ex_3_3_gl_0_corrected.proved : Section_3_3_printed.ex_3_3_gl_0_corrected.statement).
Check (Section_3_3_printed_proofs.ex_3_3_gl_0_corrected.met : Section_3_3_printed.ex_3_3_gl_0_corrected.instance).
Check (Section_3_3_printed_proofs.ex_3_3_gl_1.refuted : ~ Section_3_3_printed.ex_3_3_gl_1.statement).
Check (Section_3_3_printed_proofs.ex_3_3_gl_1_corrected.proved : Section_3_3_printed.ex_3_3_gl_1_corrected.statement).
Check (Section_3_3_printed_proofs.ex_3_3_gl_1_corrected.met : Section_3_3_printed.ex_3_3_gl_1_corrected.instance).
Check (Section_3_3_printed_proofs.ex_3_3_composite.proved : Section_3_3_printed.ex_3_3_composite.statement).
Check (Section_3_3_printed_proofs.ex_3_3_composite.met : Section_3_3_printed.ex_3_3_composite.instance).
Check (Section_3_3_proofs.sec_3_3_generatrix.proved : Section_3_3.sec_3_3_generatrix.statement).
Check (Section_3_3_proofs.sec_3_3_generatrix.met : Section_3_3.sec_3_3_generatrix.instance).
Check (Section_3_3_proofs.sec_3_3_same_degree_literal.refuted : ~ Section_3_3.sec_3_3_same_degree_literal.statement).
Check (Section_3_3_proofs.sec_3_3_same_degree_in_general.proved : Section_3_3.sec_3_3_same_degree_in_general.statement).
Check (Section_3_3_proofs.sec_3_3_same_degree_in_general.met : Section_3_3.sec_3_3_same_degree_in_general.instance).
Check (Section_3_3_proofs.eq_17_0.proved : Section_3_3.eq_17_0.statement).
Check (Section_3_3_proofs.eq_17_0.met : Section_3_3.eq_17_0.instance).
Check (Section_3_3_proofs.eq_17_1.proved : Section_3_3.eq_17_1.statement).
Check (Section_3_3_proofs.eq_17_1.met : Section_3_3.eq_17_1.instance).
Check (Section_3_3_proofs.sec_3_3_condition_1.proved : Section_3_3.sec_3_3_condition_1.statement).
Check (Section_3_3_proofs.sec_3_3_condition_1.met : Section_3_3.sec_3_3_condition_1.instance).
Check (Section_3_3_proofs.sec_3_3_condition_2.refuted : ~ Section_3_3.sec_3_3_condition_2.statement).
Check (Section_3_3_proofs.eq_18.refuted : ~ Section_3_3.eq_18.statement).
Check (Section_3_3_proofs.eq_18_corrected.proved : Section_3_3.eq_18_corrected.statement).
Check (Section_3_3_proofs.eq_18_corrected.met : Section_3_3.eq_18_corrected.instance).
Check (Section_3_3_proofs.eq_18_true.proved : Section_3_3.eq_18_true.statement).
Check (Section_3_3_proofs.eq_18_true.met : Section_3_3.eq_18_true.instance).
Check (Section_3_3_proofs.eq_18_sufficient.proved : Section_3_3.eq_18_sufficient.statement).
Check (Section_3_3_proofs.eq_18_sufficient.met : Section_3_3.eq_18_sufficient.instance).
Check (Section_3_3_proofs.eq_18_necessary.proved : Section_3_3.eq_18_necessary.statement).
Check (Section_3_3_proofs.eq_18_necessary.met : Section_3_3.eq_18_necessary.instance).
Check (Section_3_3_proofs.eq_18_defect.proved : Section_3_3.eq_18_defect.statement).
Check (Section_3_3_proofs.eq_18_defect.met : Section_3_3.eq_18_defect.instance).
Check (Section_3_3_proofs.eq_18_tensor.proved : Section_3_3.eq_18_tensor.statement).
Check (Section_3_3_proofs.eq_18_tensor.met : Section_3_3.eq_18_tensor.instance).
Check (Section_3_3_proofs.sec_3_3_benefits_a.proved : Section_3_3.sec_3_3_benefits_a.statement).
Check (Section_3_3_proofs.sec_3_3_benefits_a.met : Section_3_3.sec_3_3_benefits_a.instance).
Check (Section_3_3_proofs.prop_3_3_a.proved : Section_3_3.prop_3_3_a.statement).
Check (Section_3_3_proofs.prop_3_3_a.met : Section_3_3.prop_3_3_a.instance).
Check (Section_3_3_proofs.prop_3_3_b.proved : Section_3_3.prop_3_3_b.statement).
Check (Section_3_3_proofs.prop_3_3_b.met : Section_3_3.prop_3_3_b.instance).
Check (Section_3_3_proofs.prop_3_4_a.proved : Section_3_3.prop_3_4_a.statement).
Check (Section_3_3_proofs.prop_3_4_a.met : Section_3_3.prop_3_4_a.instance).
Check (Section_3_3_proofs.prop_3_4_a_net.proved : Section_3_3.prop_3_4_a_net.statement).
Check (Section_3_3_proofs.prop_3_4_a_net.met : Section_3_3.prop_3_4_a_net.instance).
Check (Section_3_3_proofs.prop_3_4_b.proved : Section_3_3.prop_3_4_b.statement).
Check (Section_3_3_proofs.prop_3_4_b.met : Section_3_3.prop_3_4_b.instance).
Check (Section_3_3_proofs.alg_3_a.refuted : ~ Section_3_3.alg_3_a.statement).
Check (Section_3_3_proofs.alg_3_a_corrected.proved : Section_3_3.alg_3_a_corrected.statement).
Check (Section_3_3_proofs.alg_3_a_corrected.met : Section_3_3.alg_3_a_corrected.instance).
Check (Section_3_3_proofs.alg_3_b.refuted : ~ Section_3_3.alg_3_b.statement).
Check (Section_3_3_proofs.ex_3_3_curves.refuted : ~ Section_3_3.ex_3_3_curves.statement).
Check (Section_3_3_proofs.ex_3_3_curves_corrected.proved : Section_3_3.ex_3_3_curves_corrected.statement).
Check (Section_3_3_proofs.ex_3_3_curves_corrected.met : Section_3_3.ex_3_3_curves_corrected.instance).
Check (Section_3_3_proofs.eq_19.refuted : ~ Section_3_3.eq_19.statement).
Check (Section_3_3_proofs.eq_19_tensor.refuted : ~ Section_3_3.eq_19_tensor.statement).
Check (Section_3_3_proofs.ex_3_3_gl_0.refuted : ~ Section_3_3.ex_3_3_gl_0.statement).
Check (Section_3_3_proofs.ex_3_3_gl_0_corrected.proved : Section_3_3.ex_3_3_gl_0_corrected.statement).
Check (Section_3_3_proofs.ex_3_3_gl_0_corrected.met : Section_3_3.ex_3_3_gl_0_corrected.instance).
Check (Section_3_3_proofs.ex_3_3_gl_1.refuted : ~ Section_3_3.ex_3_3_gl_1.statement).
Check (Section_3_3_proofs.ex_3_3_gl_1_corrected.proved : Section_3_3.ex_3_3_gl_1_corrected.statement).
Check (Section_3_3_proofs.ex_3_3_gl_1_corrected.met : Section_3_3.ex_3_3_gl_1_corrected.instance).
Check (Section_3_3_proofs.ex_3_3_composite.proved : Section_3_3.ex_3_3_composite.statement).
Check (Section_3_3_proofs.ex_3_3_composite.met : Section_3_3.ex_3_3_composite.instance).
Check (Section_3_4_printed_proofs.eq_20_profile.proved : Section_3_4_printed.eq_20_profile.statement).
Check (Section_3_4_printed_proofs.eq_20_profile.met : Section_3_4_printed.eq_20_profile.instance).
Check (Section_3_4_printed_proofs.eq_20_trajectory.refuted : ~ Section_3_4_printed.eq_20_trajectory.statement).
Check (Section_3_4_printed_proofs.eq_20_trajectory_corrected.proved : Section_3_4_printed.eq_20_trajectory_corrected.statement).
Check (Section_3_4_printed_proofs.eq_20_trajectory_corrected.met : Section_3_4_printed.eq_20_trajectory_corrected.instance).
Check (Section_3_4_printed_proofs.eq_21.proved : Section_3_4_printed.eq_21.statement).
Check (Section_3_4_printed_proofs.eq_21.met : Section_3_4_printed.eq_21.instance).
Check (Section_3_4_printed_proofs.eq_22.proved : Section_3_4_printed.eq_22.statement).
Check (Section_3_4_printed_proofs.eq_22.met : Section_3_4_printed.eq_22.instance).
Check (Section_3_4_printed_proofs.prop_3_5.proved : Section_3_4_printed.prop_3_5.statement).
Check (Section_3_4_printed_proofs.prop_3_5.met : Section_3_4_printed.prop_3_5.instance).
Check (Section_3_4_printed_proofs.prop_3_6_1.proved : Section_3_4_printed.prop_3_6_1.statement).
Check (Section_3_4_printed_proofs.prop_3_6_1.met : Section_3_4_printed.prop_3_6_1.instance).
Check (Section_3_4_printed_proofs.prop_3_6_2.proved : Section_3_4_printed.prop_3_6_2.statement).
Check (Section_3_4_printed_proofs.prop_3_6_2.met : Section_3_4_printed.prop_3_6_2.instance).
Check (Section_3_4_printed_proofs.eq_23.proved : Section_3_4_printed.eq_23.statement).
Check (Section_3_4_printed_proofs.eq_23.met : Section_3_4_printed.eq_23.instance).
Check (Section_3_4_printed_proofs.thm_4_elements.refuted : ~ Section_3_4_printed.thm_4_elements.statement).
Check (Section_3_4_printed_proofs.thm_4_elements_corrected.proved : Section_3_4_printed.thm_4_elements_corrected.statement).
Check (Section_3_4_printed_proofs.thm_4_elements_corrected.met : Section_3_4_printed.thm_4_elements_corrected.instance).
Check (Section_3_4_printed_proofs.thm_4_parameters.proved : Section_3_4_printed.thm_4_parameters.statement).
Check (Section_3_4_printed_proofs.thm_4_parameters.met : Section_3_4_printed.thm_4_parameters.instance).
Check (Section_3_4_printed_proofs.eq_24.proved : Section_3_4_printed.eq_24.statement).
Check (Section_3_4_printed_proofs.eq_24.met : Section_3_4_printed.eq_24.instance).
Check (Section_3_4_printed_proofs.thm_4_unity.proved : Section_3_4_printed.thm_4_unity.statement).
Check (Section_3_4_printed_proofs.thm_4_unity.met : Section_3_4_printed.thm_4_unity.instance).
Check (Section_3_4_printed_proofs.eq_25_1.proved : Section_3_4_printed.eq_25_1.statement).
Check (Section_3_4_printed_proofs.eq_25_1.met : Section_3_4_printed.eq_25_1.instance).
Check (Section_3_4_printed_proofs.eq_25_2_a.refuted : ~ Section_3_4_printed.eq_25_2_a.statement).
Check (Section_3_4_printed_proofs.eq_25_2_a_corrected.proved : Section_3_4_printed.eq_25_2_a_corrected.statement).
Check (Section_3_4_printed_proofs.eq_25_2_a_corrected.met : Section_3_4_printed.eq_25_2_a_corrected.instance).
Check (Section_3_4_printed_proofs.eq_25_2_b.refuted : ~ Section_3_4_printed.eq_25_2_b.statement).
Check (Section_3_4_printed_proofs.eq_25_2_b_corrected.proved : Section_3_4_printed.eq_25_2_b_corrected.statement).
Check (Section_3_4_printed_proofs.eq_25_2_b_corrected.met : Section_3_4_printed.eq_25_2_b_corrected.instance).
Check (Section_3_4_printed_proofs.eq_25_2_c.proved : Section_3_4_printed.eq_25_2_c.statement).
Check (Section_3_4_printed_proofs.eq_25_2_c.met : Section_3_4_printed.eq_25_2_c.instance).
Check (Section_3_4_printed_proofs.eq_25_3.proved : Section_3_4_printed.eq_25_3.statement).
Check (Section_3_4_printed_proofs.eq_25_3.met : Section_3_4_printed.eq_25_3.instance).
Check (Section_3_4_printed_proofs.eq_25_4_a.refuted : ~ Section_3_4_printed.eq_25_4_a.statement).
Check (Section_3_4_printed_proofs.eq_25_4_a_corrected.proved : Section_3_4_printed.eq_25_4_a_corrected.statement).
Check (Section_3_4_printed_proofs.eq_25_4_a_corrected.met : Section_3_4_printed.eq_25_4_a_corrected.instance).
Check (Section_3_4_printed_proofs.eq_25_4_b.refuted : ~ Section_3_4_printed.eq_25_4_b.statement).
Check (Section_3_4_printed_proofs.eq_25_4_b_corrected.proved : Section_3_4_printed.eq_25_4_b_corrected.statement).
Check (Section_3_4_printed_proofs.eq_25_4_b_corrected.met : Section_3_4_printed.eq_25_4_b_corrected.instance).
Check (Section_3_4_printed_proofs.eq_25_4_c.proved : Section_3_4_printed.eq_25_4_c.statement).
Check (Section_3_4_printed_proofs.eq_25_4_c.met : Section_3_4_printed.eq_25_4_c.instance).
Check (Section_3_4_printed_proofs.thm_4_degree.refuted : ~ Section_3_4_printed.thm_4_degree.statement).
Check (Section_3_4_printed_proofs.sec_3_4_features_a.proved : Section_3_4_printed.sec_3_4_features_a.statement).
Check (Section_3_4_printed_proofs.sec_3_4_features_a.met : Section_3_4_printed.sec_3_4_features_a.instance).
Check (Section_3_4_printed_proofs.sec_3_4_continuity_pc.proved : Section_3_4_printed.sec_3_4_continuity_pc.statement).
Check (Section_3_4_printed_proofs.sec_3_4_continuity_pc.met : Section_3_4_printed.sec_3_4_continuity_pc.instance).
Check (Section_3_4_printed_proofs.sec_3_4_continuity_tc.proved : Section_3_4_printed.sec_3_4_continuity_tc.statement).
Check (Section_3_4_printed_proofs.sec_3_4_continuity_tc.met : Section_3_4_printed.sec_3_4_continuity_tc.instance).
Check (Section_3_4_printed_proofs.sec_3_4_closed.proved : Section_3_4_printed.sec_3_4_closed.statement).
Check (Section_3_4_printed_proofs.sec_3_4_closed.met : Section_3_4_printed.sec_3_4_closed.instance).
Check (Section_3_4_printed_proofs.sec_3_4_revolution.proved : Section_3_4_printed.sec_3_4_revolution.statement).
Check (Section_3_4_printed_proofs.sec_3_4_revolution.met : Section_3_4_printed.sec_3_4_revolution.instance).
Check (Section_3_4_printed_proofs.sec_3_4_revolution_not_tensor_quarter.proved : Section_3_4_printed.sec_3_4_revolution_not_tensor_quarter.statement).
Check (Section_3_4_printed_proofs.sec_3_4_revolution_not_tensor_quarter.met : Section_3_4_printed.sec_3_4_revolution_not_tensor_quarter.instance).
Check (Section_3_4_printed_proofs.sec_3_4_revolution_not_tensor_cubic.proved : Section_3_4_printed.sec_3_4_revolution_not_tensor_cubic.statement).
Check (Section_3_4_printed_proofs.sec_3_4_revolution_not_tensor_cubic.met : Section_3_4_printed.sec_3_4_revolution_not_tensor_cubic.instance).
Check (Section_3_4_printed_proofs.alg_4_a.proved : Section_3_4_printed.alg_4_a.statement).
Check (Section_3_4_printed_proofs.alg_4_a.met : Section_3_4_printed.alg_4_a.instance).
Check (Section_3_4_printed_proofs.alg_4_b.refuted : ~ Section_3_4_printed.alg_4_b.statement).
Check (Section_3_4_printed_proofs.eq_26.proved : Section_3_4_printed.eq_26.statement).
Check (Section_3_4_printed_proofs.ex_3_4_scaling.proved : Section_3_4_printed.ex_3_4_scaling.statement).
Check (Section_3_4_printed_proofs.ex_3_4_scaling.met : Section_3_4_printed.ex_3_4_scaling.instance).
Check (Section_3_4_printed_proofs.fig_16_lambda_between_the_panels.proved : Section_3_4_printed.fig_16_lambda_between_the_panels.statement).
Check (Section_3_4_printed_proofs.fig_16_lambda_between_the_panels.met : Section_3_4_printed.fig_16_lambda_between_the_panels.instance).
Check (Section_3_4_printed_proofs.fig_16_lambda_between_the_surfaces.refuted : ~ Section_3_4_printed.fig_16_lambda_between_the_surfaces.statement).
Check (Section_3_4_proofs.eq_20_profile.proved : Section_3_4.eq_20_profile.statement).
Check (Section_3_4_proofs.eq_20_profile.met : Section_3_4.eq_20_profile.instance).
Check (Section_3_4_proofs.eq_20_trajectory.refuted : ~ Section_3_4.eq_20_trajectory.statement).
Check (Section_3_4_proofs.eq_20_trajectory_corrected.proved : Section_3_4.eq_20_trajectory_corrected.statement).
Check (Section_3_4_proofs.eq_20_trajectory_corrected.met : Section_3_4.eq_20_trajectory_corrected.instance).
Check (Section_3_4_proofs.eq_21.proved : Section_3_4.eq_21.statement).
Check (Section_3_4_proofs.eq_21.met : Section_3_4.eq_21.instance).
Check (Section_3_4_proofs.eq_22.proved : Section_3_4.eq_22.statement).
Check (Section_3_4_proofs.eq_22.met : Section_3_4.eq_22.instance).
Check (Section_3_4_proofs.prop_3_5.proved : Section_3_4.prop_3_5.statement).
Check (Section_3_4_proofs.prop_3_5.met : Section_3_4.prop_3_5.instance).
Check (Section_3_4_proofs.prop_3_6_1.proved : Section_3_4.prop_3_6_1.statement).
Check (Section_3_4_proofs.prop_3_6_1.met : Section_3_4.prop_3_6_1.instance).
Check (Section_3_4_proofs.prop_3_6_2.proved : Section_3_4.prop_3_6_2.statement).
Check (Section_3_4_proofs.prop_3_6_2.met : Section_3_4.prop_3_6_2.instance).
Check (Section_3_4_proofs.eq_23.proved : Section_3_4.eq_23.statement).
Check (Section_3_4_proofs.eq_23.met : Section_3_4.eq_23.instance).
Check (Section_3_4_proofs.thm_4_elements.refuted : ~ Section_3_4.thm_4_elements.statement).
Check (Section_3_4_proofs.thm_4_elements_corrected.proved : Section_3_4.thm_4_elements_corrected.statement).
Check (Section_3_4_proofs.thm_4_elements_corrected.met : Section_3_4.thm_4_elements_corrected.instance).
Check (Section_3_4_proofs.thm_4_parameters.proved : Section_3_4.thm_4_parameters.statement).
Check (Section_3_4_proofs.thm_4_parameters.met : Section_3_4.thm_4_parameters.instance).
Check (Section_3_4_proofs.eq_24.proved : Section_3_4.eq_24.statement).
Check (Section_3_4_proofs.eq_24.met : Section_3_4.eq_24.instance).
Check (Section_3_4_proofs.thm_4_unity.proved : Section_3_4.thm_4_unity.statement).
Check (Section_3_4_proofs.thm_4_unity.met : Section_3_4.thm_4_unity.instance).
Check (Section_3_4_proofs.eq_25_1.proved : Section_3_4.eq_25_1.statement).
Check (Section_3_4_proofs.eq_25_1.met : Section_3_4.eq_25_1.instance).
Check (Section_3_4_proofs.eq_25_2_a.refuted : ~ Section_3_4.eq_25_2_a.statement).
Check (Section_3_4_proofs.eq_25_2_a_corrected.proved : Section_3_4.eq_25_2_a_corrected.statement).
Check (Section_3_4_proofs.eq_25_2_a_corrected.met : Section_3_4.eq_25_2_a_corrected.instance).
Check (Section_3_4_proofs.eq_25_2_b.refuted : ~ Section_3_4.eq_25_2_b.statement).
Check (Section_3_4_proofs.eq_25_2_b_corrected.proved : Section_3_4.eq_25_2_b_corrected.statement).
Check (Section_3_4_proofs.eq_25_2_b_corrected.met : Section_3_4.eq_25_2_b_corrected.instance).
Check (Section_3_4_proofs.eq_25_2_c.proved : Section_3_4.eq_25_2_c.statement).
Check (Section_3_4_proofs.eq_25_2_c.met : Section_3_4.eq_25_2_c.instance).
Check (Section_3_4_proofs.eq_25_3.proved : Section_3_4.eq_25_3.statement).
Check (Section_3_4_proofs.eq_25_3.met : Section_3_4.eq_25_3.instance).
Check (Section_3_4_proofs.eq_25_4_a.refuted : ~ Section_3_4.eq_25_4_a.statement).
Check (Section_3_4_proofs.eq_25_4_a_corrected.proved : Section_3_4.eq_25_4_a_corrected.statement).
Check (Section_3_4_proofs.eq_25_4_a_corrected.met : Section_3_4.eq_25_4_a_corrected.instance).
Check (Section_3_4_proofs.eq_25_4_b.refuted : ~ Section_3_4.eq_25_4_b.statement).
Check (Section_3_4_proofs.eq_25_4_b_corrected.proved : Section_3_4.eq_25_4_b_corrected.statement).
Check (Section_3_4_proofs.eq_25_4_b_corrected.met : Section_3_4.eq_25_4_b_corrected.instance).
Check (Section_3_4_proofs.eq_25_4_c.proved : Section_3_4.eq_25_4_c.statement).
Check (Section_3_4_proofs.eq_25_4_c.met : Section_3_4.eq_25_4_c.instance).
Check (Section_3_4_proofs.thm_4_degree.refuted : ~ Section_3_4.thm_4_degree.statement).
Check (Section_3_4_proofs.sec_3_4_features_a.proved : Section_3_4.sec_3_4_features_a.statement).
Check (Section_3_4_proofs.sec_3_4_features_a.met : Section_3_4.sec_3_4_features_a.instance).
Check (Section_3_4_proofs.sec_3_4_continuity_pc.proved : Section_3_4.sec_3_4_continuity_pc.statement).
Check (Section_3_4_proofs.sec_3_4_continuity_pc.met : Section_3_4.sec_3_4_continuity_pc.instance).
Check (Section_3_4_proofs.sec_3_4_continuity_tc.proved : Section_3_4.sec_3_4_continuity_tc.statement).
Check (Section_3_4_proofs.sec_3_4_continuity_tc.met : Section_3_4.sec_3_4_continuity_tc.instance).
Check (Section_3_4_proofs.sec_3_4_closed.proved : Section_3_4.sec_3_4_closed.statement).
Check (Section_3_4_proofs.sec_3_4_closed.met : Section_3_4.sec_3_4_closed.instance).
Check (Section_3_4_proofs.sec_3_4_revolution.proved : Section_3_4.sec_3_4_revolution.statement).
Check (Section_3_4_proofs.sec_3_4_revolution.met : Section_3_4.sec_3_4_revolution.instance).
Check (Section_3_4_proofs.sec_3_4_revolution_not_tensor_quarter.proved : Section_3_4.sec_3_4_revolution_not_tensor_quarter.statement).
Check (Section_3_4_proofs.sec_3_4_revolution_not_tensor_quarter.met : Section_3_4.sec_3_4_revolution_not_tensor_quarter.instance).
Check (Section_3_4_proofs.sec_3_4_revolution_not_tensor_cubic.proved : Section_3_4.sec_3_4_revolution_not_tensor_cubic.statement).
Check (Section_3_4_proofs.sec_3_4_revolution_not_tensor_cubic.met : Section_3_4.sec_3_4_revolution_not_tensor_cubic.instance).
Check (Section_3_4_proofs.alg_4_a.proved : Section_3_4.alg_4_a.statement).
Check (Section_3_4_proofs.alg_4_a.met : Section_3_4.alg_4_a.instance).
Check (Section_3_4_proofs.alg_4_b.refuted : ~ Section_3_4.alg_4_b.statement).
Check (Section_3_4_proofs.eq_26.proved : Section_3_4.eq_26.statement).
Check (Section_3_4_proofs.ex_3_4_scaling.proved : Section_3_4.ex_3_4_scaling.statement).
Check (Section_3_4_proofs.ex_3_4_scaling.met : Section_3_4.ex_3_4_scaling.instance).
Check (Section_3_4_proofs.fig_16_lambda_between_the_panels.proved : Section_3_4.fig_16_lambda_between_the_panels.statement).
Check (Section_3_4_proofs.fig_16_lambda_between_the_panels.met : Section_3_4.fig_16_lambda_between_the_panels.instance).
Check (Section_3_4_proofs.fig_16_lambda_between_the_surfaces.refuted : ~ Section_3_4.fig_16_lambda_between_the_surfaces.statement).
Check (Section_3_5_printed_proofs.eq_27.proved : Section_3_5_printed.eq_27.statement).
Check (Section_3_5_printed_proofs.eq_27.met : Section_3_5_printed.eq_27.instance).
Check (Section_3_5_printed_proofs.sec_3_5_categories.proved : Section_3_5_printed.sec_3_5_categories.statement).
Check (Section_3_5_printed_proofs.sec_3_5_not_expressible_sine.proved : Section_3_5_printed.sec_3_5_not_expressible_sine.statement).
Check (Section_3_5_printed_proofs.sec_3_5_not_expressible_sine.met : Section_3_5_printed.sec_3_5_not_expressible_sine.instance).
Check (Section_3_5_printed_proofs.eq_29.proved : Section_3_5_printed.eq_29.statement).
Check (Section_3_5_printed_proofs.eq_29.met : Section_3_5_printed.eq_29.instance).
Check (Section_3_5_printed_proofs.eq_30.proved : Section_3_5_printed.eq_30.statement).
Check (Section_3_5_printed_proofs.eq_30.met : Section_3_5_printed.eq_30.instance).
Check (Section_3_5_printed_proofs.eq_31_2.proved : Section_3_5_printed.eq_31_2.statement).
Check (Section_3_5_printed_proofs.eq_31_2.met : Section_3_5_printed.eq_31_2.instance).
Check (Section_3_5_printed_proofs.eq_31_3.proved : Section_3_5_printed.eq_31_3.statement).
Check (Section_3_5_printed_proofs.eq_31_3.met : Section_3_5_printed.eq_31_3.instance).
Check (Section_3_5_printed_proofs.eq_31_4.proved : Section_3_5_printed.eq_31_4.statement).
Check (Section_3_5_printed_proofs.eq_31_4.met : Section_3_5_printed.eq_31_4.instance).
Check (Section_3_5_printed_proofs.eq_31_5.proved : Section_3_5_printed.eq_31_5.statement).
Check (Section_3_5_printed_proofs.eq_31_5.met : Section_3_5_printed.eq_31_5.instance).
Check (Section_3_5_printed_proofs.prop_3_7_1_a.proved : Section_3_5_printed.prop_3_7_1_a.statement).
Check (Section_3_5_printed_proofs.prop_3_7_1_a.met : Section_3_5_printed.prop_3_7_1_a.instance).
Check (Section_3_5_printed_proofs.prop_3_7_2a.proved : Section_3_5_printed.prop_3_7_2a.statement).
Check (Section_3_5_printed_proofs.prop_3_7_2a.met : Section_3_5_printed.prop_3_7_2a.instance).
Check (Section_3_5_printed_proofs.prop_3_7_2b.proved : Section_3_5_printed.prop_3_7_2b.statement).
Check (Section_3_5_printed_proofs.prop_3_7_2b.met : Section_3_5_printed.prop_3_7_2b.instance).
Check (Section_3_5_printed_proofs.alg_5_a.proved : Section_3_5_printed.alg_5_a.statement).
Check (Section_3_5_printed_proofs.alg_5_a.met : Section_3_5_printed.alg_5_a.instance).
Check (Section_3_5_printed_proofs.alg_5_b.refuted : ~ Section_3_5_printed.alg_5_b.statement).
Check (Section_3_5_printed_proofs.ex_3_5_sections.proved : Section_3_5_printed.ex_3_5_sections.statement).
Check (Section_3_5_printed_proofs.ex_3_5_trajectories.proved : Section_3_5_printed.ex_3_5_trajectories.statement).
Check (Section_3_5_printed_proofs.ex_3_5_c1_sections.proved : Section_3_5_printed.ex_3_5_c1_sections.statement).
Check (Section_3_5_printed_proofs.ex_3_5_c1_sections.met : Section_3_5_printed.ex_3_5_c1_sections.instance).
Check (Section_3_5_printed_proofs.ex_3_5_c1_trajectories.proved : Section_3_5_printed.ex_3_5_c1_trajectories.statement).
Check (Section_3_5_printed_proofs.ex_3_5_c1_trajectories.met : Section_3_5_printed.ex_3_5_c1_trajectories.instance).
Check (Section_3_5_printed_proofs.ex_3_5_c2_sections.proved : Section_3_5_printed.ex_3_5_c2_sections.statement).
Check (Section_3_5_printed_proofs.ex_3_5_c2_sections.met : Section_3_5_printed.ex_3_5_c2_sections.instance).
Check (Section_3_5_printed_proofs.ex_3_5_c2_trajectories.refuted : ~ Section_3_5_printed.ex_3_5_c2_trajectories.statement).
Check (Section_3_5_printed_proofs.ex_3_5_c2_trajectories_true.proved : Section_3_5_printed.ex_3_5_c2_trajectories_true.statement).
Check (Section_3_5_printed_proofs.ex_3_5_c2_trajectories_true.met : Section_3_5_printed.ex_3_5_c2_trajectories_true.instance).
Check (Section_3_5_printed_proofs.ex_3_5_c2_trajectories_moved.proved : Section_3_5_printed.ex_3_5_c2_trajectories_moved.statement).
Check (Section_3_5_printed_proofs.ex_3_5_c2_trajectories_moved.met : Section_3_5_printed.ex_3_5_c2_trajectories_moved.instance).
Check (Section_3_5_printed_proofs.ex_3_5_contiguous_each_with_its_own.refuted : ~ Section_3_5_printed.ex_3_5_contiguous_each_with_its_own.statement).
Check (Section_3_5_printed_proofs.ex_3_5_contiguous_one_trajectory.proved : Section_3_5_printed.ex_3_5_contiguous_one_trajectory.statement).
Check (Section_3_5_printed_proofs.ex_3_5_contiguous_one_trajectory.met : Section_3_5_printed.ex_3_5_contiguous_one_trajectory.instance).
Check (Section_3_5_printed_proofs.ex_3_5_contiguous_one_section.proved : Section_3_5_printed.ex_3_5_contiguous_one_section.statement).
Check (Section_3_5_printed_proofs.ex_3_5_contiguous_one_section.met : Section_3_5_printed.ex_3_5_contiguous_one_section.instance).
Check (Section_3_5_printed_proofs.sec_3_5_unnecessary.proved : Section_3_5_printed.sec_3_5_unnecessary.statement).
Check (Section_3_5_printed_proofs.sec_3_5_unnecessary.met : Section_3_5_printed.sec_3_5_unnecessary.instance).
Check (Section_3_5_proofs.eq_27.proved : Section_3_5.eq_27.statement).
Check (Section_3_5_proofs.eq_27.met : Section_3_5.eq_27.instance).
Check (Section_3_5_proofs.sec_3_5_categories.proved : Section_3_5.sec_3_5_categories.statement).
Check (Section_3_5_proofs.sec_3_5_not_expressible_sine.proved : Section_3_5.sec_3_5_not_expressible_sine.statement).
Check (Section_3_5_proofs.sec_3_5_not_expressible_sine.met : Section_3_5.sec_3_5_not_expressible_sine.instance).
Check (Section_3_5_proofs.eq_29.proved : Section_3_5.eq_29.statement).
Check (Section_3_5_proofs.eq_29.met : Section_3_5.eq_29.instance).
Check (Section_3_5_proofs.eq_30.proved : Section_3_5.eq_30.statement).
Check (Section_3_5_proofs.eq_30.met : Section_3_5.eq_30.instance).
Check (Section_3_5_proofs.eq_31_2.proved : Section_3_5.eq_31_2.statement).
Check (Section_3_5_proofs.eq_31_2.met : Section_3_5.eq_31_2.instance).
Check (Section_3_5_proofs.eq_31_3.proved : Section_3_5.eq_31_3.statement).
Check (Section_3_5_proofs.eq_31_3.met : Section_3_5.eq_31_3.instance).
Check (Section_3_5_proofs.eq_31_4.proved : Section_3_5.eq_31_4.statement).
Check (Section_3_5_proofs.eq_31_4.met : Section_3_5.eq_31_4.instance).
Check (Section_3_5_proofs.eq_31_5.proved : Section_3_5.eq_31_5.statement).
Check (Section_3_5_proofs.eq_31_5.met : Section_3_5.eq_31_5.instance).
Check (Section_3_5_proofs.prop_3_7_1_a.proved : Section_3_5.prop_3_7_1_a.statement).
Check (Section_3_5_proofs.prop_3_7_1_a.met : Section_3_5.prop_3_7_1_a.instance).
Check (Section_3_5_proofs.prop_3_7_2a.proved : Section_3_5.prop_3_7_2a.statement).
Check (Section_3_5_proofs.prop_3_7_2a.met : Section_3_5.prop_3_7_2a.instance).
Check (Section_3_5_proofs.prop_3_7_2b.proved : Section_3_5.prop_3_7_2b.statement).
Check (Section_3_5_proofs.prop_3_7_2b.met : Section_3_5.prop_3_7_2b.instance).
Check (Section_3_5_proofs.alg_5_a.proved : Section_3_5.alg_5_a.statement).
Check (Section_3_5_proofs.alg_5_a.met : Section_3_5.alg_5_a.instance).
Check (Section_3_5_proofs.alg_5_b.refuted : ~ Section_3_5.alg_5_b.statement).
Check (Section_3_5_proofs.ex_3_5_sections.proved : Section_3_5.ex_3_5_sections.statement).
Check (Section_3_5_proofs.ex_3_5_trajectories.proved : Section_3_5.ex_3_5_trajectories.statement).
Check (Section_3_5_proofs.ex_3_5_c1_sections.proved : Section_3_5.ex_3_5_c1_sections.statement).
Check (Section_3_5_proofs.ex_3_5_c1_sections.met : Section_3_5.ex_3_5_c1_sections.instance).
Check (Section_3_5_proofs.ex_3_5_c1_trajectories.proved : Section_3_5.ex_3_5_c1_trajectories.statement).
Check (Section_3_5_proofs.ex_3_5_c1_trajectories.met : Section_3_5.ex_3_5_c1_trajectories.instance).
Check (Section_3_5_proofs.ex_3_5_c2_sections.proved : Section_3_5.ex_3_5_c2_sections.statement).
Check (Section_3_5_proofs.ex_3_5_c2_sections.met : Section_3_5.ex_3_5_c2_sections.instance).
Check (Section_3_5_proofs.ex_3_5_c2_trajectories.refuted : ~ Section_3_5.ex_3_5_c2_trajectories.statement).
Check (Section_3_5_proofs.ex_3_5_c2_trajectories_true.proved : Section_3_5.ex_3_5_c2_trajectories_true.statement).
Check (Section_3_5_proofs.ex_3_5_c2_trajectories_true.met : Section_3_5.ex_3_5_c2_trajectories_true.instance).
Check (Section_3_5_proofs.ex_3_5_c2_trajectories_moved.proved : Section_3_5.ex_3_5_c2_trajectories_moved.statement).
Check (Section_3_5_proofs.ex_3_5_c2_trajectories_moved.met : Section_3_5.ex_3_5_c2_trajectories_moved.instance).
Check (Section_3_5_proofs.ex_3_5_contiguous_each_with_its_own.refuted : ~ Section_3_5.ex_3_5_contiguous_each_with_its_own.statement).
Check (Section_3_5_proofs.ex_3_5_contiguous_one_trajectory.proved : Section_3_5.ex_3_5_contiguous_one_trajectory.statement).
Check (Section_3_5_proofs.ex_3_5_contiguous_one_trajectory.met : Section_3_5.ex_3_5_contiguous_one_trajectory.instance).
Check (Section_3_5_proofs.ex_3_5_contiguous_one_section.proved : Section_3_5.ex_3_5_contiguous_one_section.statement).
Check (Section_3_5_proofs.ex_3_5_contiguous_one_section.met : Section_3_5.ex_3_5_contiguous_one_section.instance).
Check (Section_3_5_proofs.sec_3_5_unnecessary.proved : Section_3_5.sec_3_5_unnecessary.statement).
Check (Section_3_5_proofs.sec_3_5_unnecessary.met : Section_3_5.sec_3_5_unnecessary.instance).
Check (Section_3_6_printed_proofs.eq_32_matrix.refuted : ~ Section_3_6_printed.eq_32_matrix.statement).
Check (Section_3_6_printed_proofs.eq_32_matrix_corrected.proved : Section_3_6_printed.eq_32_matrix_corrected.statement).
Check (Section_3_6_printed_proofs.eq_32_matrix_corrected.met : Section_3_6_printed.eq_32_matrix_corrected.instance).
Check (Section_3_6_printed_proofs.eq_32_components.proved : Section_3_6_printed.eq_32_components.statement).
Check (Section_3_6_printed_proofs.eq_32_components.met : Section_3_6_printed.eq_32_components.instance).
Check (Section_3_6_printed_proofs.sec_3_6_rounding_rational.proved : Section_3_6_printed.sec_3_6_rounding_rational.statement).
Check (Section_3_6_printed_proofs.sec_3_6_rounding_rational.met : Section_3_6_printed.sec_3_6_rounding_rational.instance).
Check (Section_3_6_printed_proofs.sec_3_6_revolving.proved : Section_3_6_printed.sec_3_6_revolving.statement).
Check (Section_3_6_printed_proofs.sec_3_6_revolving.met : Section_3_6_printed.sec_3_6_revolving.instance).
Check (Section_3_6_printed_proofs.sec_3_6_plane_generating_line.proved : Section_3_6_printed.sec_3_6_plane_generating_line.statement).
Check (Section_3_6_printed_proofs.sec_3_6_plane_generating_line.met : Section_3_6_printed.sec_3_6_plane_generating_line.instance).
Check (Section_3_6_printed_proofs.sec_3_6_plane_surface.refuted : ~ Section_3_6_printed.sec_3_6_plane_surface.statement).
Check (Section_3_6_printed_proofs.sec_3_6_c1c2.proved : Section_3_6_printed.sec_3_6_c1c2.statement).
Check (Section_3_6_printed_proofs.sec_3_6_c1c2.met : Section_3_6_printed.sec_3_6_c1c2.instance).
Check (Section_3_6_printed_proofs.eq_33_T.proved : Section_3_6_printed.eq_33_T.statement).
Check (Section_3_6_printed_proofs.eq_33_T.met : Section_3_6_printed.eq_33_T.instance).
Check (Section_3_6_printed_proofs.eq_33_Ttilde.proved : Section_3_6_printed.eq_33_Ttilde.statement).
Check (Section_3_6_printed_proofs.eq_33_Ttilde.met : Section_3_6_printed.eq_33_Ttilde.instance).
Check (Section_3_6_printed_proofs.eq_33_circle.proved : Section_3_6_printed.eq_33_circle.statement).
Check (Section_3_6_printed_proofs.eq_33_circle.met : Section_3_6_printed.eq_33_circle.instance).
Check (Section_3_6_printed_proofs.thm_6_symmetric.proved : Section_3_6_printed.thm_6_symmetric.statement).
Check (Section_3_6_printed_proofs.thm_6_symmetric.met : Section_3_6_printed.thm_6_symmetric.instance).
Check (Section_3_6_printed_proofs.thm_6_complete.proved : Section_3_6_printed.thm_6_complete.statement).
Check (Section_3_6_printed_proofs.thm_6_complete.met : Section_3_6_printed.thm_6_complete.instance).
Check (Section_3_6_printed_proofs.eq_34.proved : Section_3_6_printed.eq_34.statement).
Check (Section_3_6_printed_proofs.eq_34.met : Section_3_6_printed.eq_34.instance).
Check (Section_3_6_printed_proofs.sec_3_6_other_axes.proved : Section_3_6_printed.sec_3_6_other_axes.statement).
Check (Section_3_6_printed_proofs.sec_3_6_other_axes.met : Section_3_6_printed.sec_3_6_other_axes.instance).
Check (Section_3_6_printed_proofs.prop_3_8_a_linear.proved : Section_3_6_printed.prop_3_8_a_linear.statement).
Check (Section_3_6_printed_proofs.prop_3_8_a_linear.met : Section_3_6_printed.prop_3_8_a_linear.instance).
Check (Section_3_6_printed_proofs.prop_3_8_a_true.proved : Section_3_6_printed.prop_3_8_a_true.statement).
Check (Section_3_6_printed_proofs.prop_3_8_a_true.met : Section_3_6_printed.prop_3_8_a_true.instance).
Check (Section_3_6_printed_proofs.prop_3_8_b.refuted : ~ Section_3_6_printed.prop_3_8_b.statement).
Check (Section_3_6_printed_proofs.prop_3_8_b_true.proved : Section_3_6_printed.prop_3_8_b_true.statement).
Check (Section_3_6_printed_proofs.prop_3_8_b_true.met : Section_3_6_printed.prop_3_8_b_true.instance).
Check (Section_3_6_printed_proofs.prop_3_8_b_exact.proved : Section_3_6_printed.prop_3_8_b_exact.statement).
Check (Section_3_6_printed_proofs.prop_3_8_b_exact.met : Section_3_6_printed.prop_3_8_b_exact.instance).
Check (Section_3_6_printed_proofs.prop_3_9_a_composite_line.proved : Section_3_6_printed.prop_3_9_a_composite_line.statement).
Check (Section_3_6_printed_proofs.prop_3_9_a_composite_line.met : Section_3_6_printed.prop_3_9_a_composite_line.instance).
Check (Section_3_6_printed_proofs.prop_3_9_a_one_segment.refuted : ~ Section_3_6_printed.prop_3_9_a_one_segment.statement).
Check (Section_3_6_printed_proofs.prop_3_9_b.proved : Section_3_6_printed.prop_3_9_b.statement).
Check (Section_3_6_printed_proofs.prop_3_9_b.met : Section_3_6_printed.prop_3_9_b.instance).
Check (Section_3_6_printed_proofs.alg_6.proved : Section_3_6_printed.alg_6.statement).
Check (Section_3_6_printed_proofs.alg_6.met : Section_3_6_printed.alg_6.instance).
Check (Section_3_6_printed_proofs.eq_35.proved : Section_3_6_printed.eq_35.statement).
Check (Section_3_6_printed_proofs.ex_3_6_curve.proved : Section_3_6_printed.ex_3_6_curve.statement).
Check (Section_3_6_printed_proofs.ex_3_6_curve.met : Section_3_6_printed.ex_3_6_curve.instance).
Check (Section_3_6_printed_proofs.eq_36.proved : Section_3_6_printed.eq_36.statement).
Check (Section_3_6_printed_proofs.eq_36.met : Section_3_6_printed.eq_36.instance).
Check (Section_3_6_proofs.eq_32_matrix.refuted : ~ Section_3_6.eq_32_matrix.statement).
Check (Section_3_6_proofs.eq_32_matrix_corrected.proved : Section_3_6.eq_32_matrix_corrected.statement).
Check (Section_3_6_proofs.eq_32_matrix_corrected.met : Section_3_6.eq_32_matrix_corrected.instance).
Check (Section_3_6_proofs.eq_32_components.proved : Section_3_6.eq_32_components.statement).
Check (Section_3_6_proofs.eq_32_components.met : Section_3_6.eq_32_components.instance).
Check (Section_3_6_proofs.sec_3_6_rounding_rational.proved : Section_3_6.sec_3_6_rounding_rational.statement).
Check (Section_3_6_proofs.sec_3_6_rounding_rational.met : Section_3_6.sec_3_6_rounding_rational.instance).
Check (Section_3_6_proofs.sec_3_6_revolving.proved : Section_3_6.sec_3_6_revolving.statement).
Check (Section_3_6_proofs.sec_3_6_revolving.met : Section_3_6.sec_3_6_revolving.instance).
Check (Section_3_6_proofs.sec_3_6_plane_generating_line.proved : Section_3_6.sec_3_6_plane_generating_line.statement).
Check (Section_3_6_proofs.sec_3_6_plane_generating_line.met : Section_3_6.sec_3_6_plane_generating_line.instance).
Check (Section_3_6_proofs.sec_3_6_plane_surface.refuted : ~ Section_3_6.sec_3_6_plane_surface.statement).
Check (Section_3_6_proofs.sec_3_6_c1c2.proved : Section_3_6.sec_3_6_c1c2.statement).
Check (Section_3_6_proofs.sec_3_6_c1c2.met : Section_3_6.sec_3_6_c1c2.instance).
Check (Section_3_6_proofs.eq_33_T.proved : Section_3_6.eq_33_T.statement).
Check (Section_3_6_proofs.eq_33_T.met : Section_3_6.eq_33_T.instance).
Check (Section_3_6_proofs.eq_33_Ttilde.proved : Section_3_6.eq_33_Ttilde.statement).
Check (Section_3_6_proofs.eq_33_Ttilde.met : Section_3_6.eq_33_Ttilde.instance).
Check (Section_3_6_proofs.eq_33_circle.proved : Section_3_6.eq_33_circle.statement).
Check (Section_3_6_proofs.eq_33_circle.met : Section_3_6.eq_33_circle.instance).
Check (Section_3_6_proofs.thm_6_symmetric.proved : Section_3_6.thm_6_symmetric.statement).
Check (Section_3_6_proofs.thm_6_symmetric.met : Section_3_6.thm_6_symmetric.instance).
Check (Section_3_6_proofs.thm_6_complete.proved : Section_3_6.thm_6_complete.statement).
Check (Section_3_6_proofs.thm_6_complete.met : Section_3_6.thm_6_complete.instance).
Check (Section_3_6_proofs.eq_34.proved : Section_3_6.eq_34.statement).
Check (Section_3_6_proofs.eq_34.met : Section_3_6.eq_34.instance).
Check (Section_3_6_proofs.sec_3_6_other_axes.proved : Section_3_6.sec_3_6_other_axes.statement).
Check (Section_3_6_proofs.sec_3_6_other_axes.met : Section_3_6.sec_3_6_other_axes.instance).
Check (Section_3_6_proofs.prop_3_8_a_linear.proved : Section_3_6.prop_3_8_a_linear.statement).
Check (Section_3_6_proofs.prop_3_8_a_linear.met : Section_3_6.prop_3_8_a_linear.instance).
Check (Section_3_6_proofs.prop_3_8_a_true.proved : Section_3_6.prop_3_8_a_true.statement).
Check (Section_3_6_proofs.prop_3_8_a_true.met : Section_3_6.prop_3_8_a_true.instance).
Check (Section_3_6_proofs.prop_3_8_b.refuted : ~ Section_3_6.prop_3_8_b.statement).
Check (Section_3_6_proofs.prop_3_8_b_true.proved : Section_3_6.prop_3_8_b_true.statement).
Check (Section_3_6_proofs.prop_3_8_b_true.met : Section_3_6.prop_3_8_b_true.instance).
Check (Section_3_6_proofs.prop_3_8_b_exact.proved : Section_3_6.prop_3_8_b_exact.statement).
Check (Section_3_6_proofs.prop_3_8_b_exact.met : Section_3_6.prop_3_8_b_exact.instance).
Check (Section_3_6_proofs.prop_3_9_a_composite_line.proved : Section_3_6.prop_3_9_a_composite_line.statement).
Check (Section_3_6_proofs.prop_3_9_a_composite_line.met : Section_3_6.prop_3_9_a_composite_line.instance).
Check (Section_3_6_proofs.prop_3_9_a_one_segment.refuted : ~ Section_3_6.prop_3_9_a_one_segment.statement).
Check (Section_3_6_proofs.prop_3_9_b.proved : Section_3_6.prop_3_9_b.statement).
Check (Section_3_6_proofs.prop_3_9_b.met : Section_3_6.prop_3_9_b.instance).
Check (Section_3_6_proofs.alg_6.proved : Section_3_6.alg_6.statement).
Check (Section_3_6_proofs.alg_6.met : Section_3_6.alg_6.instance).
Check (Section_3_6_proofs.eq_35.proved : Section_3_6.eq_35.statement).
Check (Section_3_6_proofs.ex_3_6_curve.proved : Section_3_6.ex_3_6_curve.statement).
Check (Section_3_6_proofs.ex_3_6_curve.met : Section_3_6.ex_3_6_curve.instance).
Check (Section_3_6_proofs.eq_36.proved : Section_3_6.eq_36.statement).
Check (Section_3_6_proofs.eq_36.met : Section_3_6.eq_36.instance).
Check (Section_4_printed_proofs.abs_features_the_features_of_Sect__2_2.proved : Section_4_printed.abs_features_the_features_of_Sect__2_2.statement).
Check (Section_4_printed_proofs.abs_features_the_features_of_Sect__2_2.met : Section_4_printed.abs_features_the_features_of_Sect__2_2.instance).
Check (Section_4_printed_proofs.abs_features_every_feature.refuted : ~ Section_4_printed.abs_features_every_feature.statement).
Check (Section_4_printed_proofs.sec_4_six_tensor_with_rotation_surfaces.refuted : ~ Section_4_printed.sec_4_six_tensor_with_rotation_surfaces.statement).
Check (Section_4_printed_proofs.sec_4_six_tensor_without.proved : Section_4_printed.sec_4_six_tensor_without.statement).
Check (Section_4_printed_proofs.sec_4_six_tensor_without.met : Section_4_printed.sec_4_six_tensor_without.instance).
Check (Section_4_printed_proofs.sec_4_composite_by_the_printed_conditions.refuted : ~ Section_4_printed.sec_4_composite_by_the_printed_conditions.statement).
Check (Section_4_printed_proofs.sec_4_composite_there_are_such_compositions.proved : Section_4_printed.sec_4_composite_there_are_such_compositions.statement).
Check (Section_4_printed_proofs.sec_4_composite_there_are_such_compositions.met : Section_4_printed.sec_4_composite_there_are_such_compositions.instance).
Check (Section_4_printed_proofs.sec_4_tensor.proved : Section_4_printed.sec_4_tensor.statement).
Check (Section_4_printed_proofs.sec_4_tensor.met : Section_4_printed.sec_4_tensor.instance).
Check (Section_4_printed_proofs.sec_4_convex_hull.proved : Section_4_printed.sec_4_convex_hull.statement).
Check (Section_4_proofs.abs_features_the_features_of_Sect__2_2.proved : Section_4.abs_features_the_features_of_Sect__2_2.statement).
Check (Section_4_proofs.abs_features_the_features_of_Sect__2_2.met : Section_4.abs_features_the_features_of_Sect__2_2.instance).
Check (Section_4_proofs.abs_features_every_feature.refuted : ~ Section_4.abs_features_every_feature.statement).
Check (Section_4_proofs.sec_4_six_tensor_with_rotation_surfaces.refuted : ~ Section_4.sec_4_six_tensor_with_rotation_surfaces.statement).
Check (Section_4_proofs.sec_4_six_tensor_without.proved : Section_4.sec_4_six_tensor_without.statement).
Check (Section_4_proofs.sec_4_six_tensor_without.met : Section_4.sec_4_six_tensor_without.instance).
Check (Section_4_proofs.sec_4_composite_by_the_printed_conditions.refuted : ~ Section_4.sec_4_composite_by_the_printed_conditions.statement).
Check (Section_4_proofs.sec_4_composite_there_are_such_compositions.proved : Section_4.sec_4_composite_there_are_such_compositions.statement).
Check (Section_4_proofs.sec_4_composite_there_are_such_compositions.met : Section_4.sec_4_composite_there_are_such_compositions.instance).
Check (Section_4_proofs.sec_4_tensor.proved : Section_4.sec_4_tensor.statement).
Check (Section_4_proofs.sec_4_tensor.met : Section_4.sec_4_tensor.instance).
Check (Section_4_proofs.sec_4_convex_hull.proved : Section_4.sec_4_convex_hull.statement).
Definition all_theorems : True :=
let _ := Part_Abstract_printed_proofs.abs_basis_a.proved in
let _ := Part_Abstract_printed_proofs.abs_basis_a.met in
let _ := Part_Abstract_printed_proofs.abs_basis_b_name.proved in
let _ := Part_Abstract_printed_proofs.abs_basis_b_name.met in
let _ := Part_Abstract_printed_proofs.abs_basis_b_basis.refuted in
let _ := Part_Abstract_printed_proofs.abs_basis_order_2.proved in
let _ := Part_Abstract_printed_proofs.abs_basis_order_2.met in
let _ := Part_Abstract_printed_proofs.abs_basis_cubic.proved in
let _ := Part_Abstract_printed_proofs.abs_basis_cubic.met in
let _ := Part_Abstract_printed_proofs.abs_basis_all.proved in
let _ := Part_Abstract_printed_proofs.abs_basis_all.met in
let _ := Part_Abstract_printed_proofs.abs_continuity_a.proved in
let _ := Part_Abstract_printed_proofs.abs_continuity_a.met in
let _ := Part_Abstract_printed_proofs.abs_continuity_rows.proved in
let _ := Part_Abstract_printed_proofs.abs_continuity_rows.met in
let _ := Part_Abstract_proofs.abs_basis_a.proved in
let _ := Part_Abstract_proofs.abs_basis_a.met in
let _ := Part_Abstract_proofs.abs_basis_b_name.proved in
let _ := Part_Abstract_proofs.abs_basis_b_name.met in
let _ := Part_Abstract_proofs.abs_basis_b_basis.refuted in
let _ := Part_Abstract_proofs.abs_basis_order_2.proved in
let _ := Part_Abstract_proofs.abs_basis_order_2.met in
let _ := Part_Abstract_proofs.abs_basis_cubic.proved in
let _ := Part_Abstract_proofs.abs_basis_cubic.met in
let _ := Part_Abstract_proofs.abs_basis_all.proved in
let _ := Part_Abstract_proofs.abs_basis_all.met in
let _ := Part_Abstract_proofs.abs_continuity_a.proved in
let _ := Part_Abstract_proofs.abs_continuity_a.met in
let _ := Part_Abstract_proofs.abs_continuity_rows.proved in
let _ := Part_Abstract_proofs.abs_continuity_rows.met in
let _ := Part_Table_printed_proofs.tab_1_1_proposed.proved in
let _ := Part_Table_printed_proofs.tab_1_1_proposed.met in
let _ := Part_Table_printed_proofs.tab_1_2_proposed.proved in
let _ := Part_Table_printed_proofs.tab_1_2_proposed.met in
let _ := Part_Table_printed_proofs.tab_1_3_proposed.proved in
let _ := Part_Table_printed_proofs.tab_1_3_proposed.met in
let _ := Part_Table_printed_proofs.tab_1_4_proposed.proved in
let _ := Part_Table_printed_proofs.tab_1_4_proposed.met in
let _ := Part_Table_printed_proofs.tab_1_5_proposed.proved in
let _ := Part_Table_printed_proofs.tab_1_5_proposed.met in
let _ := Part_Table_proofs.tab_1_1_proposed.proved in
let _ := Part_Table_proofs.tab_1_1_proposed.met in
let _ := Part_Table_proofs.tab_1_2_proposed.proved in
let _ := Part_Table_proofs.tab_1_2_proposed.met in
let _ := Part_Table_proofs.tab_1_3_proposed.proved in
let _ := Part_Table_proofs.tab_1_3_proposed.met in
let _ := Part_Table_proofs.tab_1_4_proposed.proved in
let _ := Part_Table_proofs.tab_1_4_proposed.met in
let _ := Part_Table_proofs.tab_1_5_proposed.proved in
let _ := Part_Table_proofs.tab_1_5_proposed.met in
let _ := Section_1_printed_proofs.sec_1_contrib_1.proved in
let _ := Section_1_printed_proofs.sec_1_contrib_1.met in
let _ := Section_1_printed_proofs.sec_1_contrib_2.proved in
let _ := Section_1_printed_proofs.sec_1_contrib_2.met in
let _ := Section_1_printed_proofs.sec_1_contrib_3_by_the_printed_conditions.refuted in
let _ := Section_1_printed_proofs.sec_1_contrib_3_there_are_such_compositions.proved in
let _ := Section_1_printed_proofs.sec_1_contrib_3_there_are_such_compositions.met in
let _ := Section_1_proofs.sec_1_contrib_1.proved in
let _ := Section_1_proofs.sec_1_contrib_1.met in
let _ := Section_1_proofs.sec_1_contrib_2.proved in
let _ := Section_1_proofs.sec_1_contrib_2.met in
let _ := Section_1_proofs.sec_1_contrib_3_by_the_printed_conditions.refuted in
let _ := Section_1_proofs.sec_1_contrib_3_there_are_such_compositions.proved in
let _ := Section_1_proofs.sec_1_contrib_3_there_are_such_compositions.met in
let _ := Section_2_1_printed_proofs.eq_1_f0.proved in
let _ := Section_2_1_printed_proofs.eq_1_f0.met in
let _ := Section_2_1_printed_proofs.eq_1_f1.proved in
let _ := Section_2_1_printed_proofs.eq_1_f1.met in
let _ := Section_2_1_printed_proofs.eq_1_f2.proved in
let _ := Section_2_1_printed_proofs.eq_1_f2.met in
let _ := Section_2_1_printed_proofs.eq_2.proved in
let _ := Section_2_1_printed_proofs.eq_2.met in
let _ := Section_2_1_printed_proofs.eq_2_zero.refuted in
let _ := Section_2_1_printed_proofs.eq_2_zero_true.proved in
let _ := Section_2_1_printed_proofs.eq_2_zero_true.met in
let _ := Section_2_1_printed_proofs.thm_1_1_formal.proved in
let _ := Section_2_1_printed_proofs.thm_1_1_formal.met in
let _ := Section_2_1_printed_proofs.thm_1_1_as_functions.refuted in
let _ := Section_2_1_printed_proofs.thm_1_1_true.proved in
let _ := Section_2_1_printed_proofs.thm_1_1_true.met in
let _ := Section_2_1_printed_proofs.thm_1_1_blend.proved in
let _ := Section_2_1_printed_proofs.thm_1_1_blend.met in
let _ := Section_2_1_printed_proofs.thm_1_2_Definition_1.refuted in
let _ := Section_2_1_printed_proofs.thm_1_2_where_curves_are_defined.proved in
let _ := Section_2_1_printed_proofs.thm_1_2_where_curves_are_defined.met in
let _ := Section_2_1_printed_proofs.thm_1_3.proved in
let _ := Section_2_1_printed_proofs.thm_1_3.met in
let _ := Section_2_1_printed_proofs.thm_1_4.proved in
let _ := Section_2_1_printed_proofs.thm_1_4.met in
let _ := Section_2_1_printed_proofs.thm_1_5_d1_0_values.proved in
let _ := Section_2_1_printed_proofs.thm_1_5_d1_0_values.met in
let _ := Section_2_1_printed_proofs.thm_1_5_d1_1_values.proved in
let _ := Section_2_1_printed_proofs.thm_1_5_d1_1_values.met in
let _ := Section_2_1_printed_proofs.thm_1_5_d2_0_values.proved in
let _ := Section_2_1_printed_proofs.thm_1_5_d2_0_values.met in
let _ := Section_2_1_printed_proofs.thm_1_5_d2_1_values.proved in
let _ := Section_2_1_printed_proofs.thm_1_5_d2_1_values.met in
let _ := Section_2_1_printed_proofs.thm_1_5_d3_0_values.proved in
let _ := Section_2_1_printed_proofs.thm_1_5_d3_0_values.met in
let _ := Section_2_1_printed_proofs.thm_1_5_d3_1_values.proved in
let _ := Section_2_1_printed_proofs.thm_1_5_d3_1_values.met in
let _ := Section_2_1_proofs.eq_1_f0.proved in
let _ := Section_2_1_proofs.eq_1_f0.met in
let _ := Section_2_1_proofs.eq_1_f1.proved in
let _ := Section_2_1_proofs.eq_1_f1.met in
let _ := Section_2_1_proofs.eq_1_f2.proved in
let _ := Section_2_1_proofs.eq_1_f2.met in
let _ := Section_2_1_proofs.eq_2.proved in
let _ := Section_2_1_proofs.eq_2.met in
let _ := Section_2_1_proofs.eq_2_zero.refuted in
let _ := Section_2_1_proofs.eq_2_zero_true.proved in
let _ := Section_2_1_proofs.eq_2_zero_true.met in
let _ := Section_2_1_proofs.thm_1_1_formal.proved in
let _ := Section_2_1_proofs.thm_1_1_formal.met in
let _ := Section_2_1_proofs.thm_1_1_as_functions.refuted in
let _ := Section_2_1_proofs.thm_1_1_true.proved in
let _ := Section_2_1_proofs.thm_1_1_true.met in
let _ := Section_2_1_proofs.thm_1_1_blend.proved in
let _ := Section_2_1_proofs.thm_1_1_blend.met in
let _ := Section_2_1_proofs.thm_1_2_Definition_1.refuted in
let _ := Section_2_1_proofs.thm_1_2_where_curves_are_defined.proved in
let _ := Section_2_1_proofs.thm_1_2_where_curves_are_defined.met in
let _ := Section_2_1_proofs.thm_1_3.proved in
let _ := Section_2_1_proofs.thm_1_3.met in
let _ := Section_2_1_proofs.thm_1_4.proved in
let _ := Section_2_1_proofs.thm_1_4.met in
let _ := Section_2_1_proofs.thm_1_5_d1_0_values.proved in
let _ := Section_2_1_proofs.thm_1_5_d1_0_values.met in
let _ := Section_2_1_proofs.thm_1_5_d1_1_values.proved in
let _ := Section_2_1_proofs.thm_1_5_d1_1_values.met in
let _ := Section_2_1_proofs.thm_1_5_d2_0_values.proved in
let _ := Section_2_1_proofs.thm_1_5_d2_0_values.met in
let _ := Section_2_1_proofs.thm_1_5_d2_1_values.proved in
let _ := Section_2_1_proofs.thm_1_5_d2_1_values.met in
let _ := Section_2_1_proofs.thm_1_5_d3_0_values.proved in
let _ := Section_2_1_proofs.thm_1_5_d3_0_values.met in
let _ := Section_2_1_proofs.thm_1_5_d3_1_values.proved in
let _ := Section_2_1_proofs.thm_1_5_d3_1_values.met in
let _ := Section_2_2_printed_proofs.def_2_points.refuted in
let _ := Section_2_2_printed_proofs.eq_3.proved in
let _ := Section_2_2_printed_proofs.eq_3.met in
let _ := Section_2_2_printed_proofs.sec_2_2_symmetry_as_in_Theorem_1.proved in
let _ := Section_2_2_printed_proofs.sec_2_2_symmetry_as_in_Theorem_1.met in
let _ := Section_2_2_printed_proofs.sec_2_2_symmetry_parameters_exchanged.proved in
let _ := Section_2_2_printed_proofs.sec_2_2_symmetry_parameters_exchanged.met in
let _ := Section_2_2_printed_proofs.sec_2_2_symmetry_as_for_B_zier_curves.refuted in
let _ := Section_2_2_printed_proofs.sec_2_2_convex_hull.proved in
let _ := Section_2_2_printed_proofs.sec_2_2_convex_hull.met in
let _ := Section_2_2_printed_proofs.sec_2_2_variation_diminishing_order_2.proved in
let _ := Section_2_2_printed_proofs.sec_2_2_variation_diminishing_order_2.met in
let _ := Section_2_2_printed_proofs.sec_2_2_invariance.proved in
let _ := Section_2_2_printed_proofs.sec_2_2_invariance.met in
let _ := Section_2_2_printed_proofs.sec_2_2_shape_adjustable.proved in
let _ := Section_2_2_printed_proofs.sec_2_2_shape_adjustable.met in
let _ := Section_2_2_printed_proofs.sec_2_2_terminal_0_values.proved in
let _ := Section_2_2_printed_proofs.sec_2_2_terminal_0_values.met in
let _ := Section_2_2_printed_proofs.sec_2_2_terminal_1_values.proved in
let _ := Section_2_2_printed_proofs.sec_2_2_terminal_1_values.met in
let _ := Section_2_2_printed_proofs.sec_2_2_interpolation.proved in
let _ := Section_2_2_printed_proofs.sec_2_2_interpolation.met in
let _ := Section_2_2_printed_proofs.sec_2_2_end_derivatives.proved in
let _ := Section_2_2_printed_proofs.sec_2_2_end_derivatives.met in
let _ := Section_2_2_printed_proofs.thm_2_setting.proved in
let _ := Section_2_2_printed_proofs.thm_2_setting.met in
let _ := Section_2_2_printed_proofs.thm_2_1.proved in
let _ := Section_2_2_printed_proofs.thm_2_1.met in
let _ := Section_2_2_printed_proofs.eq_4_Q11.proved in
let _ := Section_2_2_printed_proofs.eq_4_Q11.met in
let _ := Section_2_2_printed_proofs.thm_2_2.proved in
let _ := Section_2_2_printed_proofs.thm_2_2.met in
let _ := Section_2_2_printed_proofs.eq_5_Q12.refuted in
let _ := Section_2_2_printed_proofs.eq_5_Q12_corrected.proved in
let _ := Section_2_2_printed_proofs.eq_5_Q12_corrected.met in
let _ := Section_2_2_printed_proofs.eq_5_Q12_true.proved in
let _ := Section_2_2_printed_proofs.eq_5_Q12_true.met in
let _ := Section_2_2_printed_proofs.thm_2_3_a.refuted in
let _ := Section_2_2_printed_proofs.thm_2_3_b.refuted in
let _ := Section_2_2_printed_proofs.thm_2_3_true.proved in
let _ := Section_2_2_printed_proofs.thm_2_3_true.met in
let _ := Section_2_2_printed_proofs.thm_2_3_iff.proved in
let _ := Section_2_2_printed_proofs.thm_2_3_iff.met in
let _ := Section_2_2_printed_proofs.thm_2_3_necessary.proved in
let _ := Section_2_2_printed_proofs.thm_2_3_necessary.met in
let _ := Section_2_2_printed_proofs.thm_2_3_sufficient.proved in
let _ := Section_2_2_printed_proofs.thm_2_3_sufficient.met in
let _ := Section_2_2_printed_proofs.thm_2_3_jump.proved in
let _ := Section_2_2_printed_proofs.thm_2_3_jump.met in
let _ := Section_2_2_printed_proofs.thm_2_3_when.proved in
let _ := Section_2_2_printed_proofs.thm_2_3_when.met in
let _ := Section_2_2_printed_proofs.eq_6_Q11.proved in
let _ := Section_2_2_printed_proofs.eq_6_Q11.met in
let _ := Section_2_2_printed_proofs.eq_6_Q12.refuted in
let _ := Section_2_2_printed_proofs.eq_6_Q12_corrected.proved in
let _ := Section_2_2_printed_proofs.eq_6_Q12_corrected.met in
let _ := Section_2_2_printed_proofs.eq_6_Q13.refuted in
let _ := Section_2_2_printed_proofs.eq_6_Q13_true.proved in
let _ := Section_2_2_printed_proofs.eq_6_Q13_true.met in
let _ := Section_2_2_printed_proofs.thm_2_4_a.refuted in
let _ := Section_2_2_printed_proofs.thm_2_4_c.refuted in
let _ := Section_2_2_printed_proofs.thm_2_4_b.refuted in
let _ := Section_2_2_printed_proofs.thm_2_4_true.proved in
let _ := Section_2_2_printed_proofs.thm_2_4_true.met in
let _ := Section_2_2_printed_proofs.thm_2_4_iff.proved in
let _ := Section_2_2_printed_proofs.thm_2_4_iff.met in
let _ := Section_2_2_printed_proofs.thm_2_4_necessary.proved in
let _ := Section_2_2_printed_proofs.thm_2_4_necessary.met in
let _ := Section_2_2_printed_proofs.thm_2_4_sufficient.proved in
let _ := Section_2_2_printed_proofs.thm_2_4_sufficient.met in
let _ := Section_2_2_printed_proofs.thm_2_4_sufficient_quintic.proved in
let _ := Section_2_2_printed_proofs.thm_2_4_sufficient_quintic.met in
let _ := Section_2_2_printed_proofs.thm_2_4_cubic.proved in
let _ := Section_2_2_printed_proofs.thm_2_4_cubic.met in
let _ := Section_2_2_printed_proofs.thm_2_a.proved in
let _ := Section_2_2_printed_proofs.thm_2_a.met in
let _ := Section_2_2_printed_proofs.thm_2_a1.proved in
let _ := Section_2_2_printed_proofs.thm_2_a1.met in
let _ := Section_2_2_printed_proofs.thm_2_a1_sign.proved in
let _ := Section_2_2_printed_proofs.thm_2_a1_sign.met in
let _ := Section_2_2_printed_proofs.thm_2_a2.proved in
let _ := Section_2_2_printed_proofs.thm_2_a2.met in
let _ := Section_2_2_printed_proofs.thm_2_a3.refuted in
let _ := Section_2_2_printed_proofs.thm_2_a3_corrected.proved in
let _ := Section_2_2_printed_proofs.thm_2_a3_corrected.met in
let _ := Section_2_2_printed_proofs.thm_2_a3_true.proved in
let _ := Section_2_2_printed_proofs.thm_2_a3_true.met in
let _ := Section_2_2_printed_proofs.thm_2_b1.proved in
let _ := Section_2_2_printed_proofs.thm_2_b1.met in
let _ := Section_2_2_printed_proofs.thm_2_b1_sign.proved in
let _ := Section_2_2_printed_proofs.thm_2_b1_sign.met in
let _ := Section_2_2_printed_proofs.thm_2_b2.refuted in
let _ := Section_2_2_printed_proofs.thm_2_b2_true.proved in
let _ := Section_2_2_printed_proofs.thm_2_b2_true.met in
let _ := Section_2_2_printed_proofs.thm_2_b3.refuted in
let _ := Section_2_2_printed_proofs.thm_2_b3_corrected.proved in
let _ := Section_2_2_printed_proofs.thm_2_b3_corrected.met in
let _ := Section_2_2_printed_proofs.thm_2_b3_true.proved in
let _ := Section_2_2_printed_proofs.thm_2_b3_true.met in
let _ := Section_2_2_printed_proofs.thm_2_b4.refuted in
let _ := Section_2_2_printed_proofs.thm_2_b4_corrected.proved in
let _ := Section_2_2_printed_proofs.thm_2_b4_corrected.met in
let _ := Section_2_2_printed_proofs.thm_2_b4_true.proved in
let _ := Section_2_2_printed_proofs.thm_2_b4_true.met in
let _ := Section_2_2_printed_proofs.thm_2_c1.proved in
let _ := Section_2_2_printed_proofs.thm_2_c1.met in
let _ := Section_2_2_proofs.def_2_points.refuted in
let _ := Section_2_2_proofs.eq_3.proved in
let _ := Section_2_2_proofs.eq_3.met in
let _ := Section_2_2_proofs.sec_2_2_symmetry_as_in_Theorem_1.proved in
let _ := Section_2_2_proofs.sec_2_2_symmetry_as_in_Theorem_1.met in
let _ := Section_2_2_proofs.sec_2_2_symmetry_parameters_exchanged.proved in
let _ := Section_2_2_proofs.sec_2_2_symmetry_parameters_exchanged.met in
let _ := Section_2_2_proofs.sec_2_2_symmetry_as_for_B_zier_curves.refuted in
let _ := Section_2_2_proofs.sec_2_2_convex_hull.proved in
let _ := Section_2_2_proofs.sec_2_2_convex_hull.met in
let _ := Section_2_2_proofs.sec_2_2_variation_diminishing_order_2.proved in
let _ := Section_2_2_proofs.sec_2_2_variation_diminishing_order_2.met in
let _ := Section_2_2_proofs.sec_2_2_invariance.proved in
let _ := Section_2_2_proofs.sec_2_2_invariance.met in
let _ := Section_2_2_proofs.sec_2_2_shape_adjustable.proved in
let _ := Section_2_2_proofs.sec_2_2_shape_adjustable.met in
let _ := Section_2_2_proofs.sec_2_2_terminal_0_values.proved in
let _ := Section_2_2_proofs.sec_2_2_terminal_0_values.met in
let _ := Section_2_2_proofs.sec_2_2_terminal_1_values.proved in
let _ := Section_2_2_proofs.sec_2_2_terminal_1_values.met in
let _ := Section_2_2_proofs.sec_2_2_interpolation.proved in
let _ := Section_2_2_proofs.sec_2_2_interpolation.met in
let _ := Section_2_2_proofs.sec_2_2_end_derivatives.proved in
let _ := Section_2_2_proofs.sec_2_2_end_derivatives.met in
let _ := Section_2_2_proofs.thm_2_setting.proved in
let _ := Section_2_2_proofs.thm_2_setting.met in
let _ := Section_2_2_proofs.thm_2_1.proved in
let _ := Section_2_2_proofs.thm_2_1.met in
let _ := Section_2_2_proofs.eq_4_Q11.proved in
let _ := Section_2_2_proofs.eq_4_Q11.met in
let _ := Section_2_2_proofs.thm_2_2.proved in
let _ := Section_2_2_proofs.thm_2_2.met in
let _ := Section_2_2_proofs.eq_5_Q12.refuted in
let _ := Section_2_2_proofs.eq_5_Q12_corrected.proved in
let _ := Section_2_2_proofs.eq_5_Q12_corrected.met in
let _ := Section_2_2_proofs.eq_5_Q12_true.proved in
let _ := Section_2_2_proofs.eq_5_Q12_true.met in
let _ := Section_2_2_proofs.thm_2_3_a.refuted in
let _ := Section_2_2_proofs.thm_2_3_b.refuted in
let _ := Section_2_2_proofs.thm_2_3_true.proved in
let _ := Section_2_2_proofs.thm_2_3_true.met in
let _ := Section_2_2_proofs.thm_2_3_iff.proved in
let _ := Section_2_2_proofs.thm_2_3_iff.met in
let _ := Section_2_2_proofs.thm_2_3_necessary.proved in
let _ := Section_2_2_proofs.thm_2_3_necessary.met in
let _ := Section_2_2_proofs.thm_2_3_sufficient.proved in
let _ := Section_2_2_proofs.thm_2_3_sufficient.met in
let _ := Section_2_2_proofs.thm_2_3_jump.proved in
let _ := Section_2_2_proofs.thm_2_3_jump.met in
let _ := Section_2_2_proofs.thm_2_3_when.proved in
let _ := Section_2_2_proofs.thm_2_3_when.met in
let _ := Section_2_2_proofs.eq_6_Q11.proved in
let _ := Section_2_2_proofs.eq_6_Q11.met in
let _ := Section_2_2_proofs.eq_6_Q12.refuted in
let _ := Section_2_2_proofs.eq_6_Q12_corrected.proved in
let _ := Section_2_2_proofs.eq_6_Q12_corrected.met in
let _ := Section_2_2_proofs.eq_6_Q13.refuted in
let _ := Section_2_2_proofs.eq_6_Q13_true.proved in
let _ := Section_2_2_proofs.eq_6_Q13_true.met in
let _ := Section_2_2_proofs.thm_2_4_a.refuted in
let _ := Section_2_2_proofs.thm_2_4_c.refuted in
let _ := Section_2_2_proofs.thm_2_4_b.refuted in
let _ := Section_2_2_proofs.thm_2_4_true.proved in
let _ := Section_2_2_proofs.thm_2_4_true.met in
let _ := Section_2_2_proofs.thm_2_4_iff.proved in
let _ := Section_2_2_proofs.thm_2_4_iff.met in
let _ := Section_2_2_proofs.thm_2_4_necessary.proved in
let _ := Section_2_2_proofs.thm_2_4_necessary.met in
let _ := Section_2_2_proofs.thm_2_4_sufficient.proved in
let _ := Section_2_2_proofs.thm_2_4_sufficient.met in
let _ := Section_2_2_proofs.thm_2_4_sufficient_quintic.proved in
let _ := Section_2_2_proofs.thm_2_4_sufficient_quintic.met in
let _ := Section_2_2_proofs.thm_2_4_cubic.proved in
let _ := Section_2_2_proofs.thm_2_4_cubic.met in
let _ := Section_2_2_proofs.thm_2_a.proved in
let _ := Section_2_2_proofs.thm_2_a.met in
let _ := Section_2_2_proofs.thm_2_a1.proved in
let _ := Section_2_2_proofs.thm_2_a1.met in
let _ := Section_2_2_proofs.thm_2_a1_sign.proved in
let _ := Section_2_2_proofs.thm_2_a1_sign.met in
let _ := Section_2_2_proofs.thm_2_a2.proved in
let _ := Section_2_2_proofs.thm_2_a2.met in
let _ := Section_2_2_proofs.thm_2_a3.refuted in
let _ := Section_2_2_proofs.thm_2_a3_corrected.proved in
let _ := Section_2_2_proofs.thm_2_a3_corrected.met in
let _ := Section_2_2_proofs.thm_2_a3_true.proved in
let _ := Section_2_2_proofs.thm_2_a3_true.met in
let _ := Section_2_2_proofs.thm_2_b1.proved in
let _ := Section_2_2_proofs.thm_2_b1.met in
let _ := Section_2_2_proofs.thm_2_b1_sign.proved in
let _ := Section_2_2_proofs.thm_2_b1_sign.met in
let _ := Section_2_2_proofs.thm_2_b2.refuted in
let _ := Section_2_2_proofs.thm_2_b2_true.proved in
let _ := Section_2_2_proofs.thm_2_b2_true.met in
let _ := Section_2_2_proofs.thm_2_b3.refuted in
let _ := Section_2_2_proofs.thm_2_b3_corrected.proved in
let _ := Section_2_2_proofs.thm_2_b3_corrected.met in
let _ := Section_2_2_proofs.thm_2_b3_true.proved in
let _ := Section_2_2_proofs.thm_2_b3_true.met in
let _ := Section_2_2_proofs.thm_2_b4.refuted in
let _ := Section_2_2_proofs.thm_2_b4_corrected.proved in
let _ := Section_2_2_proofs.thm_2_b4_corrected.met in
let _ := Section_2_2_proofs.thm_2_b4_true.proved in
let _ := Section_2_2_proofs.thm_2_b4_true.met in
let _ := Section_2_2_proofs.thm_2_c1.proved in
let _ := Section_2_2_proofs.thm_2_c1.met in
let _ := Section_2_3_printed_proofs.eq_7.proved in
let _ := Section_2_3_printed_proofs.eq_7.met in
let _ := Section_2_3_printed_proofs.sec_2_3_features_a.proved in
let _ := Section_2_3_printed_proofs.sec_2_3_features_a.met in
let _ := Section_2_3_printed_proofs.sec_2_3_features_b.proved in
let _ := Section_2_3_printed_proofs.sec_2_3_features_b.met in
let _ := Section_2_3_printed_proofs.sec_2_3_features_c.proved in
let _ := Section_2_3_printed_proofs.sec_2_3_features_c.met in
let _ := Section_2_3_printed_proofs.sec_2_3_features_d.proved in
let _ := Section_2_3_printed_proofs.sec_2_3_features_d.met in
let _ := Section_2_3_printed_proofs.sec_2_3_classical_the_features_of_Sect__2_2.proved in
let _ := Section_2_3_printed_proofs.sec_2_3_classical_the_features_of_Sect__2_2.met in
let _ := Section_2_3_printed_proofs.sec_2_3_classical_every_property.refuted in
let _ := Section_2_3_proofs.eq_7.proved in
let _ := Section_2_3_proofs.eq_7.met in
let _ := Section_2_3_proofs.sec_2_3_features_a.proved in
let _ := Section_2_3_proofs.sec_2_3_features_a.met in
let _ := Section_2_3_proofs.sec_2_3_features_b.proved in
let _ := Section_2_3_proofs.sec_2_3_features_b.met in
let _ := Section_2_3_proofs.sec_2_3_features_c.proved in
let _ := Section_2_3_proofs.sec_2_3_features_c.met in
let _ := Section_2_3_proofs.sec_2_3_features_d.proved in
let _ := Section_2_3_proofs.sec_2_3_features_d.met in
let _ := Section_2_3_proofs.sec_2_3_classical_the_features_of_Sect__2_2.proved in
let _ := Section_2_3_proofs.sec_2_3_classical_the_features_of_Sect__2_2.met in
let _ := Section_2_3_proofs.sec_2_3_classical_every_property.refuted in
let _ := Section_3_1_printed_proofs.sec_3_1_i.proved in
let _ := Section_3_1_printed_proofs.sec_3_1_i.met in
let _ := Section_3_1_printed_proofs.eq_8_1.proved in
let _ := Section_3_1_printed_proofs.eq_8_1.met in
let _ := Section_3_1_printed_proofs.eq_8_2.proved in
let _ := Section_3_1_printed_proofs.eq_8_2.met in
let _ := Section_3_1_printed_proofs.prop_3_1.proved in
let _ := Section_3_1_printed_proofs.prop_3_1.met in
let _ := Section_3_1_printed_proofs.sec_3_1_translating.proved in
let _ := Section_3_1_printed_proofs.sec_3_1_translating.met in
let _ := Section_3_1_printed_proofs.sec_3_1_not_tensor_literal.refuted in
let _ := Section_3_1_printed_proofs.sec_3_1_not_tensor_as_it_stands.proved in
let _ := Section_3_1_printed_proofs.sec_3_1_not_tensor_as_it_stands.met in
let _ := Section_3_1_printed_proofs.sec_3_1_order_one_missing_none.proved in
let _ := Section_3_1_printed_proofs.sec_3_1_order_one_missing_none.met in
let _ := Section_3_1_printed_proofs.eq_10.proved in
let _ := Section_3_1_printed_proofs.eq_10.met in
let _ := Section_3_1_printed_proofs.eq_10_bernstein.proved in
let _ := Section_3_1_printed_proofs.eq_10_bernstein.met in
let _ := Section_3_1_printed_proofs.eq_10_extending.proved in
let _ := Section_3_1_printed_proofs.eq_10_extending.met in
let _ := Section_3_1_printed_proofs.eq_11.refuted in
let _ := Section_3_1_printed_proofs.eq_11_corrected.proved in
let _ := Section_3_1_printed_proofs.eq_11_corrected.met in
let _ := Section_3_1_printed_proofs.eq_11_points.refuted in
let _ := Section_3_1_printed_proofs.eq_11_points_corrected.proved in
let _ := Section_3_1_printed_proofs.eq_11_points_corrected.met in
let _ := Section_3_1_printed_proofs.eq_11_parameters.proved in
let _ := Section_3_1_printed_proofs.eq_11_parameters.met in
let _ := Section_3_1_printed_proofs.eq_12_1.refuted in
let _ := Section_3_1_printed_proofs.eq_12_1_corrected.proved in
let _ := Section_3_1_printed_proofs.eq_12_1_corrected.met in
let _ := Section_3_1_printed_proofs.eq_12_2.proved in
let _ := Section_3_1_printed_proofs.eq_12_2.met in
let _ := Section_3_1_printed_proofs.eq_12_3.proved in
let _ := Section_3_1_printed_proofs.eq_12_3.met in
let _ := Section_3_1_printed_proofs.eq_12_4.proved in
let _ := Section_3_1_printed_proofs.eq_12_4.met in
let _ := Section_3_1_printed_proofs.thm_3.proved in
let _ := Section_3_1_printed_proofs.thm_3.met in
let _ := Section_3_1_printed_proofs.sec_3_1_benefits.proved in
let _ := Section_3_1_printed_proofs.sec_3_1_benefits.met in
let _ := Section_3_1_printed_proofs.sec_3_1_any_shape_literal.refuted in
let _ := Section_3_1_printed_proofs.sec_3_1_any_shape_the_shape_changes.proved in
let _ := Section_3_1_printed_proofs.sec_3_1_any_shape_the_shape_changes.met in
let _ := Section_3_1_printed_proofs.alg_1.proved in
let _ := Section_3_1_printed_proofs.alg_1.met in
let _ := Section_3_1_printed_proofs.ex_3_1_points.proved in
let _ := Section_3_1_printed_proofs.ex_3_1_normal.proved in
let _ := Section_3_1_printed_proofs.eq_13.proved in
let _ := Section_3_1_printed_proofs.eq_13.met in
let _ := Section_3_1_printed_proofs.ex_3_1_net.proved in
let _ := Section_3_1_printed_proofs.ex_3_1_mesh_count.proved in
let _ := Section_3_1_printed_proofs.ex_3_1_hull.proved in
let _ := Section_3_1_printed_proofs.ex_3_1_hull.met in
let _ := Section_3_1_printed_proofs.sec_3_1_effect.proved in
let _ := Section_3_1_printed_proofs.sec_3_1_effect.met in
let _ := Section_3_1_printed_proofs.prop_3_1_translation.proved in
let _ := Section_3_1_printed_proofs.prop_3_1_translation.met in
let _ := Section_3_1_proofs.sec_3_1_i.proved in
let _ := Section_3_1_proofs.sec_3_1_i.met in
let _ := Section_3_1_proofs.eq_8_1.proved in
let _ := Section_3_1_proofs.eq_8_1.met in
let _ := Section_3_1_proofs.eq_8_2.proved in
let _ := Section_3_1_proofs.eq_8_2.met in
let _ := Section_3_1_proofs.prop_3_1.proved in
let _ := Section_3_1_proofs.prop_3_1.met in
let _ := Section_3_1_proofs.sec_3_1_translating.proved in
let _ := Section_3_1_proofs.sec_3_1_translating.met in
let _ := Section_3_1_proofs.sec_3_1_not_tensor_literal.refuted in
let _ := Section_3_1_proofs.sec_3_1_not_tensor_as_it_stands.proved in
let _ := Section_3_1_proofs.sec_3_1_not_tensor_as_it_stands.met in
let _ := Section_3_1_proofs.sec_3_1_order_one_missing_none.proved in
let _ := Section_3_1_proofs.sec_3_1_order_one_missing_none.met in
let _ := Section_3_1_proofs.eq_10.proved in
let _ := Section_3_1_proofs.eq_10.met in
let _ := Section_3_1_proofs.eq_10_bernstein.proved in
let _ := Section_3_1_proofs.eq_10_bernstein.met in
let _ := Section_3_1_proofs.eq_10_extending.proved in
let _ := Section_3_1_proofs.eq_10_extending.met in
let _ := Section_3_1_proofs.eq_11.refuted in
let _ := Section_3_1_proofs.eq_11_corrected.proved in
let _ := Section_3_1_proofs.eq_11_corrected.met in
let _ := Section_3_1_proofs.eq_11_points.refuted in
let _ := Section_3_1_proofs.eq_11_points_corrected.proved in
let _ := Section_3_1_proofs.eq_11_points_corrected.met in
let _ := Section_3_1_proofs.eq_11_parameters.proved in
let _ := Section_3_1_proofs.eq_11_parameters.met in
let _ := Section_3_1_proofs.eq_12_1.refuted in
let _ := Section_3_1_proofs.eq_12_1_corrected.proved in
let _ := Section_3_1_proofs.eq_12_1_corrected.met in
let _ := Section_3_1_proofs.eq_12_2.proved in
let _ := Section_3_1_proofs.eq_12_2.met in
let _ := Section_3_1_proofs.eq_12_3.proved in
let _ := Section_3_1_proofs.eq_12_3.met in
let _ := Section_3_1_proofs.eq_12_4.proved in
let _ := Section_3_1_proofs.eq_12_4.met in
let _ := Section_3_1_proofs.thm_3.proved in
let _ := Section_3_1_proofs.thm_3.met in
let _ := Section_3_1_proofs.sec_3_1_benefits.proved in
let _ := Section_3_1_proofs.sec_3_1_benefits.met in
let _ := Section_3_1_proofs.sec_3_1_any_shape_literal.refuted in
let _ := Section_3_1_proofs.sec_3_1_any_shape_the_shape_changes.proved in
let _ := Section_3_1_proofs.sec_3_1_any_shape_the_shape_changes.met in
let _ := Section_3_1_proofs.alg_1.proved in
let _ := Section_3_1_proofs.alg_1.met in
let _ := Section_3_1_proofs.ex_3_1_points.proved in
let _ := Section_3_1_proofs.ex_3_1_normal.proved in
let _ := Section_3_1_proofs.eq_13.proved in
let _ := Section_3_1_proofs.eq_13.met in
let _ := Section_3_1_proofs.ex_3_1_net.proved in
let _ := Section_3_1_proofs.ex_3_1_mesh_count.proved in
let _ := Section_3_1_proofs.ex_3_1_hull.proved in
let _ := Section_3_1_proofs.ex_3_1_hull.met in
let _ := Section_3_1_proofs.sec_3_1_effect.proved in
let _ := Section_3_1_proofs.sec_3_1_effect.met in
let _ := Section_3_1_proofs.prop_3_1_translation.proved in
let _ := Section_3_1_proofs.prop_3_1_translation.met in
let _ := Section_3_2_printed_proofs.eq_14.proved in
let _ := Section_3_2_printed_proofs.eq_14.met in
let _ := Section_3_2_printed_proofs.sec_3_2_segments.proved in
let _ := Section_3_2_printed_proofs.sec_3_2_segments.met in
let _ := Section_3_2_printed_proofs.sec_3_2_linear.proved in
let _ := Section_3_2_printed_proofs.sec_3_2_linear.met in
let _ := Section_3_2_printed_proofs.prop_3_2_a.proved in
let _ := Section_3_2_printed_proofs.prop_3_2_a.met in
let _ := Section_3_2_printed_proofs.prop_3_2_b.proved in
let _ := Section_3_2_printed_proofs.prop_3_2_b.met in
let _ := Section_3_2_printed_proofs.prop_3_2_c.proved in
let _ := Section_3_2_printed_proofs.prop_3_2_c.met in
let _ := Section_3_2_printed_proofs.eq_15.proved in
let _ := Section_3_2_printed_proofs.eq_15.met in
let _ := Section_3_2_printed_proofs.sec_3_2_fixed.proved in
let _ := Section_3_2_printed_proofs.sec_3_2_fixed.met in
let _ := Section_3_2_printed_proofs.sec_3_2_list_1.proved in
let _ := Section_3_2_printed_proofs.sec_3_2_list_1.met in
let _ := Section_3_2_printed_proofs.sec_3_2_list_2.proved in
let _ := Section_3_2_printed_proofs.sec_3_2_list_2.met in
let _ := Section_3_2_printed_proofs.sec_3_2_list_3.proved in
let _ := Section_3_2_printed_proofs.sec_3_2_list_3.met in
let _ := Section_3_2_printed_proofs.alg_2_1.proved in
let _ := Section_3_2_printed_proofs.alg_2_1.met in
let _ := Section_3_2_printed_proofs.alg_2_2.proved in
let _ := Section_3_2_printed_proofs.alg_2_2.met in
let _ := Section_3_2_printed_proofs.alg_2_2_irregular.proved in
let _ := Section_3_2_printed_proofs.alg_2_2_irregular.met in
let _ := Section_3_2_printed_proofs.eq_16.proved in
let _ := Section_3_2_printed_proofs.eq_16.met in
let _ := Section_3_2_printed_proofs.ex_3_2_corners.proved in
let _ := Section_3_2_printed_proofs.ex_3_2_corners.met in
let _ := Section_3_2_printed_proofs.ex_3_2_division_z_lines.proved in
let _ := Section_3_2_printed_proofs.ex_3_2_division_Q0l.proved in
let _ := Section_3_2_printed_proofs.ex_3_2_division_Q3l.refuted in
let _ := Section_3_2_printed_proofs.ex_3_2_division_Q3l_corrected.proved in
let _ := Section_3_2_printed_proofs.ex_3_2_equal_parts_a.proved in
let _ := Section_3_2_printed_proofs.ex_3_2_equal_parts_b.proved in
let _ := Section_3_2_printed_proofs.ex_3_2_equal_parts_c.proved in
let _ := Section_3_2_printed_proofs.ex_3_2_equal_parts_d.refuted in
let _ := Section_3_2_printed_proofs.ex_3_2_equal_parts_d_corrected.proved in
let _ := Section_3_2_printed_proofs.ex_3_2_interior.proved in
let _ := Section_3_2_printed_proofs.ex_3_2_equation.refuted in
let _ := Section_3_2_printed_proofs.ex_3_2_sixteen.proved in
let _ := Section_3_2_printed_proofs.ex_3_2_coplanar.proved in
let _ := Section_3_2_printed_proofs.ex_3_2_noncoplanar_possible.proved in
let _ := Section_3_2_printed_proofs.ex_3_2_noncoplanar_possible.met in
let _ := Section_3_2_proofs.eq_14.proved in
let _ := Section_3_2_proofs.eq_14.met in
let _ := Section_3_2_proofs.sec_3_2_segments.proved in
let _ := Section_3_2_proofs.sec_3_2_segments.met in
let _ := Section_3_2_proofs.sec_3_2_linear.proved in
let _ := Section_3_2_proofs.sec_3_2_linear.met in
let _ := Section_3_2_proofs.prop_3_2_a.proved in
let _ := Section_3_2_proofs.prop_3_2_a.met in
let _ := Section_3_2_proofs.prop_3_2_b.proved in
let _ := Section_3_2_proofs.prop_3_2_b.met in
let _ := Section_3_2_proofs.prop_3_2_c.proved in
let _ := Section_3_2_proofs.prop_3_2_c.met in
let _ := Section_3_2_proofs.eq_15.proved in
let _ := Section_3_2_proofs.eq_15.met in
let _ := Section_3_2_proofs.sec_3_2_fixed.proved in
let _ := Section_3_2_proofs.sec_3_2_fixed.met in
let _ := Section_3_2_proofs.sec_3_2_list_1.proved in
let _ := Section_3_2_proofs.sec_3_2_list_1.met in
let _ := Section_3_2_proofs.sec_3_2_list_2.proved in
let _ := Section_3_2_proofs.sec_3_2_list_2.met in
let _ := Section_3_2_proofs.sec_3_2_list_3.proved in
let _ := Section_3_2_proofs.sec_3_2_list_3.met in
let _ := Section_3_2_proofs.alg_2_1.proved in
let _ := Section_3_2_proofs.alg_2_1.met in
let _ := Section_3_2_proofs.alg_2_2.proved in
let _ := Section_3_2_proofs.alg_2_2.met in
let _ := Section_3_2_proofs.alg_2_2_irregular.proved in
let _ := Section_3_2_proofs.alg_2_2_irregular.met in
let _ := Section_3_2_proofs.eq_16.proved in
let _ := Section_3_2_proofs.eq_16.met in
let _ := Section_3_2_proofs.ex_3_2_corners.proved in
let _ := Section_3_2_proofs.ex_3_2_corners.met in
let _ := Section_3_2_proofs.ex_3_2_division_z_lines.proved in
let _ := Section_3_2_proofs.ex_3_2_division_Q0l.proved in
let _ := Section_3_2_proofs.ex_3_2_division_Q3l.refuted in
let _ := Section_3_2_proofs.ex_3_2_division_Q3l_corrected.proved in
let _ := Section_3_2_proofs.ex_3_2_equal_parts_a.proved in
let _ := Section_3_2_proofs.ex_3_2_equal_parts_b.proved in
let _ := Section_3_2_proofs.ex_3_2_equal_parts_c.proved in
let _ := Section_3_2_proofs.ex_3_2_equal_parts_d.refuted in
let _ := Section_3_2_proofs.ex_3_2_equal_parts_d_corrected.proved in
let _ := Section_3_2_proofs.ex_3_2_interior.proved in
let _ := Section_3_2_proofs.ex_3_2_equation.refuted in
let _ := Section_3_2_proofs.ex_3_2_sixteen.proved in
let _ := Section_3_2_proofs.ex_3_2_coplanar.proved in
let _ := Section_3_2_proofs.ex_3_2_noncoplanar_possible.proved in
let _ := Section_3_2_proofs.ex_3_2_noncoplanar_possible.met in
let _ := Section_3_3_printed_proofs.sec_3_3_generatrix.proved in
let _ := Section_3_3_printed_proofs.sec_3_3_generatrix.met in
let _ := Section_3_3_printed_proofs.sec_3_3_same_degree_literal.refuted in
let _ := Section_3_3_printed_proofs.sec_3_3_same_degree_in_general.proved in
let _ := Section_3_3_printed_proofs.sec_3_3_same_degree_in_general.met in
let _ := Section_3_3_printed_proofs.eq_17_0.proved in
let _ := Section_3_3_printed_proofs.eq_17_0.met in
let _ := Section_3_3_printed_proofs.eq_17_1.proved in
let _ := Section_3_3_printed_proofs.eq_17_1.met in
let _ := Section_3_3_printed_proofs.sec_3_3_condition_1.proved in
let _ := Section_3_3_printed_proofs.sec_3_3_condition_1.met in
let _ := Section_3_3_printed_proofs.sec_3_3_condition_2.refuted in
let _ := Section_3_3_printed_proofs.eq_18.refuted in
let _ := Section_3_3_printed_proofs.eq_18_corrected.proved in
let _ := Section_3_3_printed_proofs.eq_18_corrected.met in
let _ := Section_3_3_printed_proofs.eq_18_true.proved in
let _ := Section_3_3_printed_proofs.eq_18_true.met in
let _ := Section_3_3_printed_proofs.eq_18_sufficient.proved in
let _ := Section_3_3_printed_proofs.eq_18_sufficient.met in
let _ := Section_3_3_printed_proofs.eq_18_necessary.proved in
let _ := Section_3_3_printed_proofs.eq_18_necessary.met in
let _ := Section_3_3_printed_proofs.eq_18_defect.proved in
let _ := Section_3_3_printed_proofs.eq_18_defect.met in
let _ := Section_3_3_printed_proofs.eq_18_tensor.proved in
let _ := Section_3_3_printed_proofs.eq_18_tensor.met in
let _ := Section_3_3_printed_proofs.sec_3_3_benefits_a.proved in
let _ := Section_3_3_printed_proofs.sec_3_3_benefits_a.met in
let _ := Section_3_3_printed_proofs.prop_3_3_a.proved in
let _ := Section_3_3_printed_proofs.prop_3_3_a.met in
let _ := Section_3_3_printed_proofs.prop_3_3_b.proved in
let _ := Section_3_3_printed_proofs.prop_3_3_b.met in
let _ := Section_3_3_printed_proofs.prop_3_4_a.proved in
let _ := Section_3_3_printed_proofs.prop_3_4_a.met in
let _ := Section_3_3_printed_proofs.prop_3_4_a_net.proved in
let _ := Section_3_3_printed_proofs.prop_3_4_a_net.met in
let _ := Section_3_3_printed_proofs.prop_3_4_b.proved in
let _ := Section_3_3_printed_proofs.prop_3_4_b.met in
let _ := Section_3_3_printed_proofs.alg_3_a.refuted in
let _ := Section_3_3_printed_proofs.alg_3_a_corrected.proved in
let _ := Section_3_3_printed_proofs.alg_3_a_corrected.met in
let _ := Section_3_3_printed_proofs.alg_3_b.refuted in
let _ := Section_3_3_printed_proofs.ex_3_3_curves.refuted in
let _ := Section_3_3_printed_proofs.ex_3_3_curves_corrected.proved in
let _ := Section_3_3_printed_proofs.ex_3_3_curves_corrected.met in
let _ := Section_3_3_printed_proofs.eq_19.refuted in
let _ := Section_3_3_printed_proofs.eq_19_tensor.refuted in
let _ := Section_3_3_printed_proofs.ex_3_3_gl_0.refuted in
let _ := Section_3_3_printed_proofs.ex_3_3_gl_0_corrected.proved in
let _ := Section_3_3_printed_proofs.ex_3_3_gl_0_corrected.met in
let _ := Section_3_3_printed_proofs.ex_3_3_gl_1.refuted in
let _ := Section_3_3_printed_proofs.ex_3_3_gl_1_corrected.proved in
let _ := Section_3_3_printed_proofs.ex_3_3_gl_1_corrected.met in
let _ := Section_3_3_printed_proofs.ex_3_3_composite.proved in
let _ := Section_3_3_printed_proofs.ex_3_3_composite.met in
let _ := Section_3_3_proofs.sec_3_3_generatrix.proved in
let _ := Section_3_3_proofs.sec_3_3_generatrix.met in
let _ := Section_3_3_proofs.sec_3_3_same_degree_literal.refuted in
let _ := Section_3_3_proofs.sec_3_3_same_degree_in_general.proved in
let _ := Section_3_3_proofs.sec_3_3_same_degree_in_general.met in
let _ := Section_3_3_proofs.eq_17_0.proved in
let _ := Section_3_3_proofs.eq_17_0.met in
let _ := Section_3_3_proofs.eq_17_1.proved in
let _ := Section_3_3_proofs.eq_17_1.met in
let _ := Section_3_3_proofs.sec_3_3_condition_1.proved in
let _ := Section_3_3_proofs.sec_3_3_condition_1.met in
let _ := Section_3_3_proofs.sec_3_3_condition_2.refuted in
let _ := Section_3_3_proofs.eq_18.refuted in
let _ := Section_3_3_proofs.eq_18_corrected.proved in
let _ := Section_3_3_proofs.eq_18_corrected.met in
let _ := Section_3_3_proofs.eq_18_true.proved in
let _ := Section_3_3_proofs.eq_18_true.met in
let _ := Section_3_3_proofs.eq_18_sufficient.proved in
let _ := Section_3_3_proofs.eq_18_sufficient.met in
let _ := Section_3_3_proofs.eq_18_necessary.proved in
let _ := Section_3_3_proofs.eq_18_necessary.met in
let _ := Section_3_3_proofs.eq_18_defect.proved in
let _ := Section_3_3_proofs.eq_18_defect.met in
let _ := Section_3_3_proofs.eq_18_tensor.proved in
let _ := Section_3_3_proofs.eq_18_tensor.met in
let _ := Section_3_3_proofs.sec_3_3_benefits_a.proved in
let _ := Section_3_3_proofs.sec_3_3_benefits_a.met in
let _ := Section_3_3_proofs.prop_3_3_a.proved in
let _ := Section_3_3_proofs.prop_3_3_a.met in
let _ := Section_3_3_proofs.prop_3_3_b.proved in
let _ := Section_3_3_proofs.prop_3_3_b.met in
let _ := Section_3_3_proofs.prop_3_4_a.proved in
let _ := Section_3_3_proofs.prop_3_4_a.met in
let _ := Section_3_3_proofs.prop_3_4_a_net.proved in
let _ := Section_3_3_proofs.prop_3_4_a_net.met in
let _ := Section_3_3_proofs.prop_3_4_b.proved in
let _ := Section_3_3_proofs.prop_3_4_b.met in
let _ := Section_3_3_proofs.alg_3_a.refuted in
let _ := Section_3_3_proofs.alg_3_a_corrected.proved in
let _ := Section_3_3_proofs.alg_3_a_corrected.met in
let _ := Section_3_3_proofs.alg_3_b.refuted in
let _ := Section_3_3_proofs.ex_3_3_curves.refuted in
let _ := Section_3_3_proofs.ex_3_3_curves_corrected.proved in
let _ := Section_3_3_proofs.ex_3_3_curves_corrected.met in
let _ := Section_3_3_proofs.eq_19.refuted in
let _ := Section_3_3_proofs.eq_19_tensor.refuted in
let _ := Section_3_3_proofs.ex_3_3_gl_0.refuted in
let _ := Section_3_3_proofs.ex_3_3_gl_0_corrected.proved in
let _ := Section_3_3_proofs.ex_3_3_gl_0_corrected.met in
let _ := Section_3_3_proofs.ex_3_3_gl_1.refuted in
let _ := Section_3_3_proofs.ex_3_3_gl_1_corrected.proved in
let _ := Section_3_3_proofs.ex_3_3_gl_1_corrected.met in
let _ := Section_3_3_proofs.ex_3_3_composite.proved in
let _ := Section_3_3_proofs.ex_3_3_composite.met in
let _ := Section_3_4_printed_proofs.eq_20_profile.proved in
let _ := Section_3_4_printed_proofs.eq_20_profile.met in
let _ := Section_3_4_printed_proofs.eq_20_trajectory.refuted in
let _ := Section_3_4_printed_proofs.eq_20_trajectory_corrected.proved in
let _ := Section_3_4_printed_proofs.eq_20_trajectory_corrected.met in
let _ := Section_3_4_printed_proofs.eq_21.proved in
let _ := Section_3_4_printed_proofs.eq_21.met in
let _ := Section_3_4_printed_proofs.eq_22.proved in
let _ := Section_3_4_printed_proofs.eq_22.met in
let _ := Section_3_4_printed_proofs.prop_3_5.proved in
let _ := Section_3_4_printed_proofs.prop_3_5.met in
let _ := Section_3_4_printed_proofs.prop_3_6_1.proved in
let _ := Section_3_4_printed_proofs.prop_3_6_1.met in
let _ := Section_3_4_printed_proofs.prop_3_6_2.proved in
let _ := Section_3_4_printed_proofs.prop_3_6_2.met in
let _ := Section_3_4_printed_proofs.eq_23.proved in
let _ := Section_3_4_printed_proofs.eq_23.met in
let _ := Section_3_4_printed_proofs.thm_4_elements.refuted in
let _ := Section_3_4_printed_proofs.thm_4_elements_corrected.proved in
let _ := Section_3_4_printed_proofs.thm_4_elements_corrected.met in
let _ := Section_3_4_printed_proofs.thm_4_parameters.proved in
let _ := Section_3_4_printed_proofs.thm_4_parameters.met in
let _ := Section_3_4_printed_proofs.eq_24.proved in
let _ := Section_3_4_printed_proofs.eq_24.met in
let _ := Section_3_4_printed_proofs.thm_4_unity.proved in
let _ := Section_3_4_printed_proofs.thm_4_unity.met in
let _ := Section_3_4_printed_proofs.eq_25_1.proved in
let _ := Section_3_4_printed_proofs.eq_25_1.met in
let _ := Section_3_4_printed_proofs.eq_25_2_a.refuted in
let _ := Section_3_4_printed_proofs.eq_25_2_a_corrected.proved in
let _ := Section_3_4_printed_proofs.eq_25_2_a_corrected.met in
let _ := Section_3_4_printed_proofs.eq_25_2_b.refuted in
let _ := Section_3_4_printed_proofs.eq_25_2_b_corrected.proved in
let _ := Section_3_4_printed_proofs.eq_25_2_b_corrected.met in
let _ := Section_3_4_printed_proofs.eq_25_2_c.proved in
let _ := Section_3_4_printed_proofs.eq_25_2_c.met in
let _ := Section_3_4_printed_proofs.eq_25_3.proved in
let _ := Section_3_4_printed_proofs.eq_25_3.met in
let _ := Section_3_4_printed_proofs.eq_25_4_a.refuted in
let _ := Section_3_4_printed_proofs.eq_25_4_a_corrected.proved in
let _ := Section_3_4_printed_proofs.eq_25_4_a_corrected.met in
let _ := Section_3_4_printed_proofs.eq_25_4_b.refuted in
let _ := Section_3_4_printed_proofs.eq_25_4_b_corrected.proved in
let _ := Section_3_4_printed_proofs.eq_25_4_b_corrected.met in
let _ := Section_3_4_printed_proofs.eq_25_4_c.proved in
let _ := Section_3_4_printed_proofs.eq_25_4_c.met in
let _ := Section_3_4_printed_proofs.thm_4_degree.refuted in
let _ := Section_3_4_printed_proofs.sec_3_4_features_a.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_features_a.met in
let _ := Section_3_4_printed_proofs.sec_3_4_continuity_pc.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_continuity_pc.met in
let _ := Section_3_4_printed_proofs.sec_3_4_continuity_tc.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_continuity_tc.met in
let _ := Section_3_4_printed_proofs.sec_3_4_closed.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_closed.met in
let _ := Section_3_4_printed_proofs.sec_3_4_revolution.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_revolution.met in
let _ := Section_3_4_printed_proofs.sec_3_4_revolution_not_tensor_quarter.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_revolution_not_tensor_quarter.met in
let _ := Section_3_4_printed_proofs.sec_3_4_revolution_not_tensor_cubic.proved in
let _ := Section_3_4_printed_proofs.sec_3_4_revolution_not_tensor_cubic.met in
let _ := Section_3_4_printed_proofs.alg_4_a.proved in
let _ := Section_3_4_printed_proofs.alg_4_a.met in
let _ := Section_3_4_printed_proofs.alg_4_b.refuted in
let _ := Section_3_4_printed_proofs.eq_26.proved in
let _ := Section_3_4_printed_proofs.ex_3_4_scaling.proved in
let _ := Section_3_4_printed_proofs.ex_3_4_scaling.met in
let _ := Section_3_4_printed_proofs.fig_16_lambda_between_the_panels.proved in
let _ := Section_3_4_printed_proofs.fig_16_lambda_between_the_panels.met in
let _ := Section_3_4_printed_proofs.fig_16_lambda_between_the_surfaces.refuted in
let _ := Section_3_4_proofs.eq_20_profile.proved in
let _ := Section_3_4_proofs.eq_20_profile.met in
let _ := Section_3_4_proofs.eq_20_trajectory.refuted in
let _ := Section_3_4_proofs.eq_20_trajectory_corrected.proved in
let _ := Section_3_4_proofs.eq_20_trajectory_corrected.met in
let _ := Section_3_4_proofs.eq_21.proved in
let _ := Section_3_4_proofs.eq_21.met in
let _ := Section_3_4_proofs.eq_22.proved in
let _ := Section_3_4_proofs.eq_22.met in
let _ := Section_3_4_proofs.prop_3_5.proved in
let _ := Section_3_4_proofs.prop_3_5.met in
let _ := Section_3_4_proofs.prop_3_6_1.proved in
let _ := Section_3_4_proofs.prop_3_6_1.met in
let _ := Section_3_4_proofs.prop_3_6_2.proved in
let _ := Section_3_4_proofs.prop_3_6_2.met in
let _ := Section_3_4_proofs.eq_23.proved in
let _ := Section_3_4_proofs.eq_23.met in
let _ := Section_3_4_proofs.thm_4_elements.refuted in
let _ := Section_3_4_proofs.thm_4_elements_corrected.proved in
let _ := Section_3_4_proofs.thm_4_elements_corrected.met in
let _ := Section_3_4_proofs.thm_4_parameters.proved in
let _ := Section_3_4_proofs.thm_4_parameters.met in
let _ := Section_3_4_proofs.eq_24.proved in
let _ := Section_3_4_proofs.eq_24.met in
let _ := Section_3_4_proofs.thm_4_unity.proved in
let _ := Section_3_4_proofs.thm_4_unity.met in
let _ := Section_3_4_proofs.eq_25_1.proved in
let _ := Section_3_4_proofs.eq_25_1.met in
let _ := Section_3_4_proofs.eq_25_2_a.refuted in
let _ := Section_3_4_proofs.eq_25_2_a_corrected.proved in
let _ := Section_3_4_proofs.eq_25_2_a_corrected.met in
let _ := Section_3_4_proofs.eq_25_2_b.refuted in
let _ := Section_3_4_proofs.eq_25_2_b_corrected.proved in
let _ := Section_3_4_proofs.eq_25_2_b_corrected.met in
let _ := Section_3_4_proofs.eq_25_2_c.proved in
let _ := Section_3_4_proofs.eq_25_2_c.met in
let _ := Section_3_4_proofs.eq_25_3.proved in
let _ := Section_3_4_proofs.eq_25_3.met in
let _ := Section_3_4_proofs.eq_25_4_a.refuted in
let _ := Section_3_4_proofs.eq_25_4_a_corrected.proved in
let _ := Section_3_4_proofs.eq_25_4_a_corrected.met in
let _ := Section_3_4_proofs.eq_25_4_b.refuted in
let _ := Section_3_4_proofs.eq_25_4_b_corrected.proved in
let _ := Section_3_4_proofs.eq_25_4_b_corrected.met in
let _ := Section_3_4_proofs.eq_25_4_c.proved in
let _ := Section_3_4_proofs.eq_25_4_c.met in
let _ := Section_3_4_proofs.thm_4_degree.refuted in
let _ := Section_3_4_proofs.sec_3_4_features_a.proved in
let _ := Section_3_4_proofs.sec_3_4_features_a.met in
let _ := Section_3_4_proofs.sec_3_4_continuity_pc.proved in
let _ := Section_3_4_proofs.sec_3_4_continuity_pc.met in
let _ := Section_3_4_proofs.sec_3_4_continuity_tc.proved in
let _ := Section_3_4_proofs.sec_3_4_continuity_tc.met in
let _ := Section_3_4_proofs.sec_3_4_closed.proved in
let _ := Section_3_4_proofs.sec_3_4_closed.met in
let _ := Section_3_4_proofs.sec_3_4_revolution.proved in
let _ := Section_3_4_proofs.sec_3_4_revolution.met in
let _ := Section_3_4_proofs.sec_3_4_revolution_not_tensor_quarter.proved in
let _ := Section_3_4_proofs.sec_3_4_revolution_not_tensor_quarter.met in
let _ := Section_3_4_proofs.sec_3_4_revolution_not_tensor_cubic.proved in
let _ := Section_3_4_proofs.sec_3_4_revolution_not_tensor_cubic.met in
let _ := Section_3_4_proofs.alg_4_a.proved in
let _ := Section_3_4_proofs.alg_4_a.met in
let _ := Section_3_4_proofs.alg_4_b.refuted in
let _ := Section_3_4_proofs.eq_26.proved in
let _ := Section_3_4_proofs.ex_3_4_scaling.proved in
let _ := Section_3_4_proofs.ex_3_4_scaling.met in
let _ := Section_3_4_proofs.fig_16_lambda_between_the_panels.proved in
let _ := Section_3_4_proofs.fig_16_lambda_between_the_panels.met in
let _ := Section_3_4_proofs.fig_16_lambda_between_the_surfaces.refuted in
let _ := Section_3_5_printed_proofs.eq_27.proved in
let _ := Section_3_5_printed_proofs.eq_27.met in
let _ := Section_3_5_printed_proofs.sec_3_5_categories.proved in
let _ := Section_3_5_printed_proofs.sec_3_5_not_expressible_sine.proved in
let _ := Section_3_5_printed_proofs.sec_3_5_not_expressible_sine.met in
let _ := Section_3_5_printed_proofs.eq_29.proved in
let _ := Section_3_5_printed_proofs.eq_29.met in
let _ := Section_3_5_printed_proofs.eq_30.proved in
let _ := Section_3_5_printed_proofs.eq_30.met in
let _ := Section_3_5_printed_proofs.eq_31_2.proved in
let _ := Section_3_5_printed_proofs.eq_31_2.met in
let _ := Section_3_5_printed_proofs.eq_31_3.proved in
let _ := Section_3_5_printed_proofs.eq_31_3.met in
let _ := Section_3_5_printed_proofs.eq_31_4.proved in
let _ := Section_3_5_printed_proofs.eq_31_4.met in
let _ := Section_3_5_printed_proofs.eq_31_5.proved in
let _ := Section_3_5_printed_proofs.eq_31_5.met in
let _ := Section_3_5_printed_proofs.prop_3_7_1_a.proved in
let _ := Section_3_5_printed_proofs.prop_3_7_1_a.met in
let _ := Section_3_5_printed_proofs.prop_3_7_2a.proved in
let _ := Section_3_5_printed_proofs.prop_3_7_2a.met in
let _ := Section_3_5_printed_proofs.prop_3_7_2b.proved in
let _ := Section_3_5_printed_proofs.prop_3_7_2b.met in
let _ := Section_3_5_printed_proofs.alg_5_a.proved in
let _ := Section_3_5_printed_proofs.alg_5_a.met in
let _ := Section_3_5_printed_proofs.alg_5_b.refuted in
let _ := Section_3_5_printed_proofs.ex_3_5_sections.proved in
let _ := Section_3_5_printed_proofs.ex_3_5_trajectories.proved in
let _ := Section_3_5_printed_proofs.ex_3_5_c1_sections.proved in
let _ := Section_3_5_printed_proofs.ex_3_5_c1_sections.met in
let _ := Section_3_5_printed_proofs.ex_3_5_c1_trajectories.proved in
let _ := Section_3_5_printed_proofs.ex_3_5_c1_trajectories.met in
let _ := Section_3_5_printed_proofs.ex_3_5_c2_sections.proved in
let _ := Section_3_5_printed_proofs.ex_3_5_c2_sections.met in
let _ := Section_3_5_printed_proofs.ex_3_5_c2_trajectories.refuted in
let _ := Section_3_5_printed_proofs.ex_3_5_c2_trajectories_true.proved in
let _ := Section_3_5_printed_proofs.ex_3_5_c2_trajectories_true.met in
let _ := Section_3_5_printed_proofs.ex_3_5_c2_trajectories_moved.proved in
let _ := Section_3_5_printed_proofs.ex_3_5_c2_trajectories_moved.met in
let _ := Section_3_5_printed_proofs.ex_3_5_contiguous_each_with_its_own.refuted in
let _ := Section_3_5_printed_proofs.ex_3_5_contiguous_one_trajectory.proved in
let _ := Section_3_5_printed_proofs.ex_3_5_contiguous_one_trajectory.met in
let _ := Section_3_5_printed_proofs.ex_3_5_contiguous_one_section.proved in
let _ := Section_3_5_printed_proofs.ex_3_5_contiguous_one_section.met in
let _ := Section_3_5_printed_proofs.sec_3_5_unnecessary.proved in
let _ := Section_3_5_printed_proofs.sec_3_5_unnecessary.met in
let _ := Section_3_5_proofs.eq_27.proved in
let _ := Section_3_5_proofs.eq_27.met in
let _ := Section_3_5_proofs.sec_3_5_categories.proved in
let _ := Section_3_5_proofs.sec_3_5_not_expressible_sine.proved in
let _ := Section_3_5_proofs.sec_3_5_not_expressible_sine.met in
let _ := Section_3_5_proofs.eq_29.proved in
let _ := Section_3_5_proofs.eq_29.met in
let _ := Section_3_5_proofs.eq_30.proved in
let _ := Section_3_5_proofs.eq_30.met in
let _ := Section_3_5_proofs.eq_31_2.proved in
let _ := Section_3_5_proofs.eq_31_2.met in
let _ := Section_3_5_proofs.eq_31_3.proved in
let _ := Section_3_5_proofs.eq_31_3.met in
let _ := Section_3_5_proofs.eq_31_4.proved in
let _ := Section_3_5_proofs.eq_31_4.met in
let _ := Section_3_5_proofs.eq_31_5.proved in
let _ := Section_3_5_proofs.eq_31_5.met in
let _ := Section_3_5_proofs.prop_3_7_1_a.proved in
let _ := Section_3_5_proofs.prop_3_7_1_a.met in
let _ := Section_3_5_proofs.prop_3_7_2a.proved in
let _ := Section_3_5_proofs.prop_3_7_2a.met in
let _ := Section_3_5_proofs.prop_3_7_2b.proved in
let _ := Section_3_5_proofs.prop_3_7_2b.met in
let _ := Section_3_5_proofs.alg_5_a.proved in
let _ := Section_3_5_proofs.alg_5_a.met in
let _ := Section_3_5_proofs.alg_5_b.refuted in
let _ := Section_3_5_proofs.ex_3_5_sections.proved in
let _ := Section_3_5_proofs.ex_3_5_trajectories.proved in
let _ := Section_3_5_proofs.ex_3_5_c1_sections.proved in
let _ := Section_3_5_proofs.ex_3_5_c1_sections.met in
let _ := Section_3_5_proofs.ex_3_5_c1_trajectories.proved in
let _ := Section_3_5_proofs.ex_3_5_c1_trajectories.met in
let _ := Section_3_5_proofs.ex_3_5_c2_sections.proved in
let _ := Section_3_5_proofs.ex_3_5_c2_sections.met in
let _ := Section_3_5_proofs.ex_3_5_c2_trajectories.refuted in
let _ := Section_3_5_proofs.ex_3_5_c2_trajectories_true.proved in
let _ := Section_3_5_proofs.ex_3_5_c2_trajectories_true.met in
let _ := Section_3_5_proofs.ex_3_5_c2_trajectories_moved.proved in
let _ := Section_3_5_proofs.ex_3_5_c2_trajectories_moved.met in
let _ := Section_3_5_proofs.ex_3_5_contiguous_each_with_its_own.refuted in
let _ := Section_3_5_proofs.ex_3_5_contiguous_one_trajectory.proved in
let _ := Section_3_5_proofs.ex_3_5_contiguous_one_trajectory.met in
let _ := Section_3_5_proofs.ex_3_5_contiguous_one_section.proved in
let _ := Section_3_5_proofs.ex_3_5_contiguous_one_section.met in
let _ := Section_3_5_proofs.sec_3_5_unnecessary.proved in
let _ := Section_3_5_proofs.sec_3_5_unnecessary.met in
let _ := Section_3_6_printed_proofs.eq_32_matrix.refuted in
let _ := Section_3_6_printed_proofs.eq_32_matrix_corrected.proved in
let _ := Section_3_6_printed_proofs.eq_32_matrix_corrected.met in
let _ := Section_3_6_printed_proofs.eq_32_components.proved in
let _ := Section_3_6_printed_proofs.eq_32_components.met in
let _ := Section_3_6_printed_proofs.sec_3_6_rounding_rational.proved in
let _ := Section_3_6_printed_proofs.sec_3_6_rounding_rational.met in
let _ := Section_3_6_printed_proofs.sec_3_6_revolving.proved in
let _ := Section_3_6_printed_proofs.sec_3_6_revolving.met in
let _ := Section_3_6_printed_proofs.sec_3_6_plane_generating_line.proved in
let _ := Section_3_6_printed_proofs.sec_3_6_plane_generating_line.met in
let _ := Section_3_6_printed_proofs.sec_3_6_plane_surface.refuted in
let _ := Section_3_6_printed_proofs.sec_3_6_c1c2.proved in
let _ := Section_3_6_printed_proofs.sec_3_6_c1c2.met in
let _ := Section_3_6_printed_proofs.eq_33_T.proved in
let _ := Section_3_6_printed_proofs.eq_33_T.met in
let _ := Section_3_6_printed_proofs.eq_33_Ttilde.proved in
let _ := Section_3_6_printed_proofs.eq_33_Ttilde.met in
let _ := Section_3_6_printed_proofs.eq_33_circle.proved in
let _ := Section_3_6_printed_proofs.eq_33_circle.met in
let _ := Section_3_6_printed_proofs.thm_6_symmetric.proved in
let _ := Section_3_6_printed_proofs.thm_6_symmetric.met in
let _ := Section_3_6_printed_proofs.thm_6_complete.proved in
let _ := Section_3_6_printed_proofs.thm_6_complete.met in
let _ := Section_3_6_printed_proofs.eq_34.proved in
let _ := Section_3_6_printed_proofs.eq_34.met in
let _ := Section_3_6_printed_proofs.sec_3_6_other_axes.proved in
let _ := Section_3_6_printed_proofs.sec_3_6_other_axes.met in
let _ := Section_3_6_printed_proofs.prop_3_8_a_linear.proved in
let _ := Section_3_6_printed_proofs.prop_3_8_a_linear.met in
let _ := Section_3_6_printed_proofs.prop_3_8_a_true.proved in
let _ := Section_3_6_printed_proofs.prop_3_8_a_true.met in
let _ := Section_3_6_printed_proofs.prop_3_8_b.refuted in
let _ := Section_3_6_printed_proofs.prop_3_8_b_true.proved in
let _ := Section_3_6_printed_proofs.prop_3_8_b_true.met in
let _ := Section_3_6_printed_proofs.prop_3_8_b_exact.proved in
let _ := Section_3_6_printed_proofs.prop_3_8_b_exact.met in
let _ := Section_3_6_printed_proofs.prop_3_9_a_composite_line.proved in
let _ := Section_3_6_printed_proofs.prop_3_9_a_composite_line.met in
let _ := Section_3_6_printed_proofs.prop_3_9_a_one_segment.refuted in
let _ := Section_3_6_printed_proofs.prop_3_9_b.proved in
let _ := Section_3_6_printed_proofs.prop_3_9_b.met in
let _ := Section_3_6_printed_proofs.alg_6.proved in
let _ := Section_3_6_printed_proofs.alg_6.met in
let _ := Section_3_6_printed_proofs.eq_35.proved in
let _ := Section_3_6_printed_proofs.ex_3_6_curve.proved in
let _ := Section_3_6_printed_proofs.ex_3_6_curve.met in
let _ := Section_3_6_printed_proofs.eq_36.proved in
let _ := Section_3_6_printed_proofs.eq_36.met in
let _ := Section_3_6_proofs.eq_32_matrix.refuted in
let _ := Section_3_6_proofs.eq_32_matrix_corrected.proved in
let _ := Section_3_6_proofs.eq_32_matrix_corrected.met in
let _ := Section_3_6_proofs.eq_32_components.proved in
let _ := Section_3_6_proofs.eq_32_components.met in
let _ := Section_3_6_proofs.sec_3_6_rounding_rational.proved in
let _ := Section_3_6_proofs.sec_3_6_rounding_rational.met in
let _ := Section_3_6_proofs.sec_3_6_revolving.proved in
let _ := Section_3_6_proofs.sec_3_6_revolving.met in
let _ := Section_3_6_proofs.sec_3_6_plane_generating_line.proved in
let _ := Section_3_6_proofs.sec_3_6_plane_generating_line.met in
let _ := Section_3_6_proofs.sec_3_6_plane_surface.refuted in
let _ := Section_3_6_proofs.sec_3_6_c1c2.proved in
let _ := Section_3_6_proofs.sec_3_6_c1c2.met in
let _ := Section_3_6_proofs.eq_33_T.proved in
let _ := Section_3_6_proofs.eq_33_T.met in
let _ := Section_3_6_proofs.eq_33_Ttilde.proved in
let _ := Section_3_6_proofs.eq_33_Ttilde.met in
let _ := Section_3_6_proofs.eq_33_circle.proved in
let _ := Section_3_6_proofs.eq_33_circle.met in
let _ := Section_3_6_proofs.thm_6_symmetric.proved in
let _ := Section_3_6_proofs.thm_6_symmetric.met in
let _ := Section_3_6_proofs.thm_6_complete.proved in
let _ := Section_3_6_proofs.thm_6_complete.met in
let _ := Section_3_6_proofs.eq_34.proved in
let _ := Section_3_6_proofs.eq_34.met in
let _ := Section_3_6_proofs.sec_3_6_other_axes.proved in
let _ := Section_3_6_proofs.sec_3_6_other_axes.met in
let _ := Section_3_6_proofs.prop_3_8_a_linear.proved in
let _ := Section_3_6_proofs.prop_3_8_a_linear.met in
let _ := Section_3_6_proofs.prop_3_8_a_true.proved in
let _ := Section_3_6_proofs.prop_3_8_a_true.met in
let _ := Section_3_6_proofs.prop_3_8_b.refuted in
let _ := Section_3_6_proofs.prop_3_8_b_true.proved in
let _ := Section_3_6_proofs.prop_3_8_b_true.met in
let _ := Section_3_6_proofs.prop_3_8_b_exact.proved in
let _ := Section_3_6_proofs.prop_3_8_b_exact.met in
let _ := Section_3_6_proofs.prop_3_9_a_composite_line.proved in
let _ := Section_3_6_proofs.prop_3_9_a_composite_line.met in
let _ := Section_3_6_proofs.prop_3_9_a_one_segment.refuted in
let _ := Section_3_6_proofs.prop_3_9_b.proved in
let _ := Section_3_6_proofs.prop_3_9_b.met in
let _ := Section_3_6_proofs.alg_6.proved in
let _ := Section_3_6_proofs.alg_6.met in
let _ := Section_3_6_proofs.eq_35.proved in
let _ := Section_3_6_proofs.ex_3_6_curve.proved in
let _ := Section_3_6_proofs.ex_3_6_curve.met in
let _ := Section_3_6_proofs.eq_36.proved in
let _ := Section_3_6_proofs.eq_36.met in
let _ := Section_4_printed_proofs.abs_features_the_features_of_Sect__2_2.proved in
let _ := Section_4_printed_proofs.abs_features_the_features_of_Sect__2_2.met in
let _ := Section_4_printed_proofs.abs_features_every_feature.refuted in
let _ := Section_4_printed_proofs.sec_4_six_tensor_with_rotation_surfaces.refuted in
let _ := Section_4_printed_proofs.sec_4_six_tensor_without.proved in
let _ := Section_4_printed_proofs.sec_4_six_tensor_without.met in
let _ := Section_4_printed_proofs.sec_4_composite_by_the_printed_conditions.refuted in
let _ := Section_4_printed_proofs.sec_4_composite_there_are_such_compositions.proved in
let _ := Section_4_printed_proofs.sec_4_composite_there_are_such_compositions.met in
let _ := Section_4_printed_proofs.sec_4_tensor.proved in
let _ := Section_4_printed_proofs.sec_4_tensor.met in
let _ := Section_4_printed_proofs.sec_4_convex_hull.proved in
let _ := Section_4_proofs.abs_features_the_features_of_Sect__2_2.proved in
let _ := Section_4_proofs.abs_features_the_features_of_Sect__2_2.met in
let _ := Section_4_proofs.abs_features_every_feature.refuted in
let _ := Section_4_proofs.sec_4_six_tensor_with_rotation_surfaces.refuted in
let _ := Section_4_proofs.sec_4_six_tensor_without.proved in
let _ := Section_4_proofs.sec_4_six_tensor_without.met in
let _ := Section_4_proofs.sec_4_composite_by_the_printed_conditions.refuted in
let _ := Section_4_proofs.sec_4_composite_there_are_such_compositions.proved in
let _ := Section_4_proofs.sec_4_composite_there_are_such_compositions.met in
let _ := Section_4_proofs.sec_4_tensor.proved in
let _ := Section_4_proofs.sec_4_tensor.met in
let _ := Section_4_proofs.sec_4_convex_hull.proved in
I.
