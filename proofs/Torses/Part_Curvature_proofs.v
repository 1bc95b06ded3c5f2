(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Torses Require Part_Curvature.
Import Torses.Part_Curvature.Definitions.
From Torses Require Import Part_Curvature_closed.
Open Scope R_scope.

Module ruled_asymptotic.
Import Torses.Part_Curvature.ruled_asymptotic.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage X_; stage N_; staged_goal K; identity. Qed.
End ruled_asymptotic.

Module ruled_mixed.
Import Torses.Part_Curvature.ruled_mixed.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage X_; stage N_; stage M; staged_goal delta; identity. Qed.
End ruled_mixed.

Module ruled_lagrange.
Import Torses.Part_Curvature.ruled_lagrange.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage E_; stage X_; stage G; stage F; staged_goal N_; identity. Qed.
End ruled_lagrange.

Module ruled_gauss.
Import Torses.Part_Curvature.ruled_gauss.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage X_; stage X__; stage N_; stage L; stage K; stage M; staged_goal delta; identity. Qed.
End ruled_gauss.

Module ruled_gauss_curvature.
Import Torses.Part_Curvature.ruled_gauss_curvature.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement L K M N_ E_ G F]; intros a1 a2 a3 c1 c2 c3 x y z q1 q2 q3 p1 p2 p3 r1 r2 r3 u v; assert (U : vDerive 3 (fun u_ => X [c1; c2; c3] [x; y; z] [p1; p2; p3] [r1; r2; r3] v u_) 1 0 = [c1 + v * p1; c2 + v * p2; c3 + v * p3]) by (cbv beta delta [X]; compute_goal; parts; derivatives; ring); assert (V : vDerive 3 (fun v_ => X_ [x; y; z] [r1; r2; r3] (v + v_)) 1 0 = [r1; r2; r3]) by (cbv beta delta [X_]; compute_goal; parts; derivatives; ring); assert (VV : vDerive 3 (fun v_ => X_ [x; y; z] [r1; r2; r3] (v + v_)) 2 0 = [0; 0; 0]) by (cbv beta delta [X_]; compute_goal; parts; derivatives; ring); assert (UV : vDerive 3 (fun v_ => vDerive 3 (fun u_ => X [c1; c2; c3] [x; y; z] [p1; p2; p3] [r1; r2; r3] (v + v_) u_) 1 0) 1 0 = [p1; p2; p3]) by (cbv beta delta [X]; compute_goal; parts; apply mixed_rate); rewrite ?U, ?V, ?VV, ?UV; clear U V VV UV; match goal with |- _ -> _ -> _ -> (dot ?a ?b * dot [0; 0; 0] ?n - dot ?p ?n ^ 2) / (?d) ^ 2 = _ / ?e ^ 2 => intros _ N _; replace (dot [0; 0; 0] n) with 0 by (compute_goal; ring); assert (S : d = e) by (compute_goal; ring); rewrite S in N |- *; assert (W : dot p n = delta [c1; c2; c3] [p1; p2; p3] [r1; r2; r3]) by (cbv beta delta [delta]; compute_goal; ring); rewrite W end; unfold Rdiv; f_equal; ring. Qed.
Theorem met : instance.
Proof. cbv beta zeta delta [instance]; exists 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0; cbv beta delta [N_ E_ G F X X_]; compute_goal; derivatives; repeat split; lra. Qed.
End ruled_gauss_curvature.

Module ruled_gauss_sign.
Import Torses.Part_Curvature.ruled_gauss_sign.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement L K M N_]; intros a1 a2 a3 c1 c2 c3 x y z q1 q2 q3 p1 p2 p3 r1 r2 r3 u v; assert (U : vDerive 3 (fun u_ => X_ [c1; c2; c3] [x; y; z] [p1; p2; p3] [r1; r2; r3] v u_) 1 0 = [c1 + v * p1; c2 + v * p2; c3 + v * p3]) by (cbv beta delta [X_]; compute_goal; parts; derivatives; ring); assert (V : vDerive 3 (fun v_ => X__ [x; y; z] [r1; r2; r3] (v + v_)) 1 0 = [r1; r2; r3]) by (cbv beta delta [X__]; compute_goal; parts; derivatives; ring); assert (VV : vDerive 3 (fun v_ => X__ [x; y; z] [r1; r2; r3] (v + v_)) 2 0 = [0; 0; 0]) by (cbv beta delta [X__]; compute_goal; parts; derivatives; ring); assert (UV : vDerive 3 (fun v_ => vDerive 3 (fun u_ => X_ [c1; c2; c3] [x; y; z] [p1; p2; p3] [r1; r2; r3] (v + v_) u_) 1 0) 1 0 = [p1; p2; p3]) by (cbv beta delta [X_]; compute_goal; parts; apply mixed_rate); rewrite ?U, ?V, ?VV, ?UV; match goal with |- dot ?a ?b * dot [0; 0; 0] ?n - ?m ^ 2 <= 0 => generalize m; intro w; replace (dot [0; 0; 0] n) with 0 by (compute_goal; ring) end; pose proof (pow2_ge_0 w); lra. Qed.
End ruled_gauss_sign.

Module ruled_gauss_slip.
Import Torses.Part_Curvature.ruled_gauss_slip.
Theorem refuted : ~ statement.
Proof. intro no; cbv beta zeta delta [statement X X_ X__ N_ L K M delta] in no; refuting (no 0 0 0 (0) (0) (1) 0 0 0 0 0 0 (0) (1) (0) (1) (0) (0) (0) (0)). Qed.
End ruled_gauss_slip.

Module ruled_gauss_slip_corrected.
Import Torses.Part_Curvature.ruled_gauss_slip_corrected.
Theorem proved : statement.
Proof. cbv beta zeta delta [statement]; stage X; stage X_; stage X__; stage N_; stage L; stage K; stage M; staged_goal delta; identity. Qed.
End ruled_gauss_slip_corrected.
