(* What is printed follows from what is proved: nothing here has to be read. *)
From Torse Require Import Defs Follows.
From GbtSurfaces Require Section_4_printed Section_4_proofs.
Open Scope R_scope.

Module abs_features_the_features_of_Sect__2_2.
Import GbtSurfaces.Section_4_printed.abs_features_the_features_of_Sect__2_2.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_4_proofs.abs_features_the_features_of_Sect__2_2.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_4_proofs.abs_features_the_features_of_Sect__2_2.met. Qed.
End abs_features_the_features_of_Sect__2_2.

Module abs_features_every_feature.
Import GbtSurfaces.Section_4_printed.abs_features_every_feature.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_4_proofs.abs_features_every_feature.refuted. Qed.
End abs_features_every_feature.

Module sec_4_six_tensor_with_rotation_surfaces.
Import GbtSurfaces.Section_4_printed.sec_4_six_tensor_with_rotation_surfaces.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_4_proofs.sec_4_six_tensor_with_rotation_surfaces.refuted. Qed.
End sec_4_six_tensor_with_rotation_surfaces.

Module sec_4_six_tensor_without.
Import GbtSurfaces.Section_4_printed.sec_4_six_tensor_without.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_4_proofs.sec_4_six_tensor_without.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_4_proofs.sec_4_six_tensor_without.met. Qed.
End sec_4_six_tensor_without.

Module sec_4_composite_by_the_printed_conditions.
Import GbtSurfaces.Section_4_printed.sec_4_composite_by_the_printed_conditions.
Theorem refuted : ~ statement.
Proof. follows GbtSurfaces.Section_4_proofs.sec_4_composite_by_the_printed_conditions.refuted. Qed.
End sec_4_composite_by_the_printed_conditions.

Module sec_4_composite_there_are_such_compositions.
Import GbtSurfaces.Section_4_printed.sec_4_composite_there_are_such_compositions.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_4_proofs.sec_4_composite_there_are_such_compositions.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_4_proofs.sec_4_composite_there_are_such_compositions.met. Qed.
End sec_4_composite_there_are_such_compositions.

Module sec_4_tensor.
Import GbtSurfaces.Section_4_printed.sec_4_tensor.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_4_proofs.sec_4_tensor.proved. Qed.
Theorem met : instance.
Proof. follows GbtSurfaces.Section_4_proofs.sec_4_tensor.met. Qed.
End sec_4_tensor.

Module sec_4_convex_hull.
Import GbtSurfaces.Section_4_printed.sec_4_convex_hull.
Theorem proved : statement.
Proof. follows GbtSurfaces.Section_4_proofs.sec_4_convex_hull.proved. Qed.
End sec_4_convex_hull.
