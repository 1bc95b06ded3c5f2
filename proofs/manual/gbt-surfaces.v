(* Scripts of theorems of gbt-surfaces whose proofs have an idea of their own: nobody has to read them. This is no file for the
   kernel: `torse prove` reads each script by its claim and its name, and writes it below the statement. *)

(* gbt-surfaces/abs.basis.b.basis (printed) *)
Theorem refuted.
Proof.
  intro all; apply proved_there; hnf; intros mu nu x c1 c2 c3 k c c4 c5 i c6; exact (all mu nu c1 c2 k c
    c4 c5 i c6).
Qed.

(* gbt-surfaces/abs.basis.b.basis *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not f]; intro no;
  specialize (no (-1) (-1) 0 ltac:(lra) ltac:(lra) ltac:(lra) 2%Z (unit 1) ltac:(lia));
  assert (H : unit 1 1 = 0) by (apply no; [ intros; cbv delta [unit]; compute_goal; circles; equal | lia ]);
  rewrite unit_one in H by reflexivity; lra.
Qed.

(* gbt-surfaces/abs.basis.cubic *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f K K_]; prepared; unknown c0; unknown c1; unknown c2; unknown c3; finished.
Qed.

(* gbt-surfaces/abs.basis.order-2 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f K K_]; prepared; unknown c0; unknown c1; unknown c2; finished.
Qed.

(* gbt-surfaces/abs.continuity.a *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement a1 b1 f a join1 a2 a3_true join2 b2_true c1 b3_true b5_true b4_true join3
    next onF F next_ onF_ F_]; sums_at_ends; intros; conjuncts; parts; field; nonzero.
Qed.

(* gbt-surfaces/abs.continuity.rows *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f second s first r second_ first_ a1 a2 b1 c1 b3_true b2_true b5_true];
  intros; conjuncts; ends_of_sums; field.
Qed.

(* gbt-surfaces/alg-3.b.by the printed conditions *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement a printed11 a1 a2 a3 printed12 b1 b2 c1 b3 b4 printed13 third
    fourth f F1 other F pair F1_ other_ F_ pair_] in no;
  refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0; 1;
        -1; 16] 0) (fun _ => 0) (fun _ => 0) 1 (-1) (-1) 0 1).
Qed.

(* gbt-surfaces/alg-3.b.there are such connections *)
Theorem met.
Proof.
  cbv beta zeta delta [instance a1 b1]; exists 3%Z, (fun _ => 0), (fun _ => 0), 0, 0, 0; conjuncts;
  first [ lia | intros; lia | lra | numeric ].
Qed.

(* gbt-surfaces/alg-3.b.there are such connections *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement a1 a2 b1 c1 b3_true f a join1 a3_true join2 b2_true b5_true b4_true join3
    next next_ other other_ pair pair_ F F_]; intros; conjuncts; ends_of_sums; field; nonzero.
Qed.

(* gbt-surfaces/alg-4.b.by the printed conditions *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement a a1 a2 a3 third f FX2 FZ2 FX FZ FX2_ FZ2_ FX_ FZ_ swung second
    first second_ first_] in no; refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1;
        0] 0) (fun i => nth (Z.to_nat i) [0; 1; -1; 16] 0) (fun _ => 0) (fun _ => 0) 1 1 (-1) (-1) 0 1 1).
Qed.

(* gbt-surfaces/alg-4.b.there are such connections *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f a1 a join1 a2 a3_true join2 next FX FZ next_ FX_ FZ_ swung second first
    second_ first_]; lists; intros; conjuncts; parts; ends_of_sums; field; nonzero.
Qed.

(* gbt-surfaces/alg-5.b.by the printed conditions *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement a printed11 a1 a2 a3 printed12 f F1 after F before F1_ after_ F_
    before_] in no; refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1;
        0] 0) (fun i => nth (Z.to_nat i) [0; 1; -1; 16] 0) 0 1 (-1) (-1) 0).
Qed.

(* gbt-surfaces/alg-5.b.there are such connections *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f a1 a join1 a2 a3_true join2 next after F before next_ after_ F_ before_];
  intros; conjuncts; ends_of_sums; field; nonzero.
Qed.

(* gbt-surfaces/alg-6 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement]; intros m X Z_ mu nu q z _ _ _ _ _ N _;
  generalize (FX X m mu nu z) (FZ Z_ m mu nu z); intros x w; cbv beta zeta delta [at_angle T Tm cosine sine];
  rewrite (arc_cos _ _ (square_sum _) N), (arc_sin _ _ (square_sum _) N), half_cos, half_sin; split;
  reflexivity.
Qed.

(* gbt-surfaces/eq-16 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 2%Z, 2%Z, (fun _ _ => 0), 0, 0, 0, 0, 0, 0; conjuncts;
  first [ lia | intros; lia | lra ].
Qed.

(* gbt-surfaces/eq-16 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement T T_ R_]; intros m n G mu mu1 nu nu1 z z1; intros; split;
  [ rewrite sum_swap; apply sum_ext; intros; rewrite <- sum_scal; apply sum_ext; intros; ring | conjuncts;
    cbv beta delta [f]; first [ apply sum_ext; intros; f_equal | idtac ]; at_ends; reflexivity ].
Qed.

(* gbt-surfaces/eq-18.necessary *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement b f printed_ L1]; intros; conjuncts; closed_parts; ends_of_sums; field.
Qed.

(* gbt-surfaces/eq-25.4.a *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement f not]; intro no;
  refuting (no 2%Z 2%Z (fun _ => 0) (fun _ => 1) 1 0 0 0 0 0 0).
Qed.

(* gbt-surfaces/eq-25.4.b *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement f not]; intro no;
  refuting (no 2%Z 2%Z (fun _ => 0) (fun _ => 1) (fun _ => 1) 1 0 0 0 0 0 0).
Qed.

(* gbt-surfaces/eq-33.T *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement at_angle at_angle_ T cosine sine]; intros q w x Q N M A B;
  refine (conj _ (conj _ (conj _ _))); [ rewrite (arc_cos _ _ (square_sum _) N), (arc_sin _ _ (square_sum _)
      N), half_cos, half_sin; reflexivity | special; field; special; lra | special; field; special; lra
    | apply arc_range; assumption ].
Qed.

(* gbt-surfaces/eq-33.Ttilde *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement at_angle at_angle_ Tm cosine sine]; intros q w x Q N M A B;
  refine (conj _ (conj _ (conj _ _))); [ rewrite (arc_cos _ _ (square_sum _) N), (arc_sin _ _ (square_sum _)
      N), half_cos, half_sin; reflexivity | special; field; special; lra | special; field; special; lra
    | apply arc_range; assumption ].
Qed.

(* gbt-surfaces/eq-36 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement at_angle T Tm cosine sine]; intros mu nu q z M N Q Z K S D;
  generalize (entry (F4 mu nu z) 1) (entry (F4 mu nu z) 3); intros x w; split;
  rewrite (arc_cos _ _ (square_sum _) S), (arc_sin _ _ (square_sum _) S), half_cos, half_sin; parts; ring.
Qed.

(* gbt-surfaces/eq-5.Q12 *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement f F1 F F1_ F_ a1 a2 a3] in no;
  refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0; 1;
        -3; -1] 0) 1 (-1) (-1) 0).
Qed.

(* gbt-surfaces/eq-5.Q12 (corrected) *)
Theorem met.
Proof.
  cbv beta zeta delta [instance f F1 F F1_ F_ a1 a2 a];
  exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal;
  conjuncts; first [ lia | intros; lia | lra | numeric ].
Qed.

(* gbt-surfaces/eq-5.Q12 (corrected) *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f F1 F F1_ F_ a1 a2 a]; sums_at_ends; intros m n Q P mu mu1 nu nu1; intros;
  assert (V : P 1%Z = Q m + (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + mu1)) * (Q m - Q
      (m - 1)%Z)) by second_point P n mu1; third_point P n mu1 nu1.
Qed.

(* gbt-surfaces/eq-5.Q12.true *)
Theorem met.
Proof.
  cbv beta zeta delta [instance f F1 F F1_ F_ a1 a2 a a3_true join2 join12];
  exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal;
  conjuncts; first [ lia | intros; lia | lra | numeric ].
Qed.

(* gbt-surfaces/eq-5.Q12.true *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f F1 F F1_ F_ a1 a2 a a3_true join2 join12]; sums_at_ends;
  intros m n Q P mu mu1 nu nu1; intros; assert (V : P 1%Z = Q m + (2 * (IZR m - 2) + PI * (1 + nu)) / (2 *
      (IZR n - 2) + PI * (1 + mu1)) * (Q m - Q (m - 1)%Z)) by second_point P n mu1; third_point P n mu1 nu1.
Qed.

(* gbt-surfaces/eq-6.Q12 *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement f F1 F F1_ F_ a1 a2 a3] in no;
  refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0; 1;
        -3; -1] 0) 1 (-1) (-1) 0).
Qed.

(* gbt-surfaces/eq-6.Q12 (corrected) *)
Theorem met.
Proof.
  cbv beta zeta delta [instance f F1 F F1_ F_ a1 a2 a];
  exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal;
  conjuncts; first [ lia | intros; lia | lra | numeric ].
Qed.

(* gbt-surfaces/eq-6.Q12 (corrected) *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f F1 F F1_ F_ a1 a2 a]; sums_at_ends; intros m n Q P mu mu1 nu nu1; intros;
  assert (V : P 1%Z = Q m + (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + mu1)) * (Q m - Q
      (m - 1)%Z)) by second_point P n mu1; third_point P n mu1 nu1.
Qed.

(* gbt-surfaces/eq-6.Q13 *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement f F1 F F1_ F_ b1 a1 b2 a2 c1 b3 a3 a b4 printed13] in no;
  refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0; 1;
        -3; -1] 0) 1 (-1) (-1) 0).
Qed.

(* gbt-surfaces/eq-6.Q13.true *)
Theorem met.
Proof.
  cbv beta zeta delta [instance f F1 F F1_ F_ a1 b1];
  exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal;
  conjuncts; first [ lia | intros; lia | lra | numeric ].
Qed.

(* gbt-surfaces/eq-6.Q13.true *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f F F1 F1_ F_ a3_true b4_true join3 join13]; sums_at_ends;
  intros m n Q P mu mu1 nu nu1; intros; assert (V : P 1%Z = Q m + a m mu1 n nu * (Q m - Q (m - 1)%Z)) by
  (unfold a; second_point P n mu1); assert (W : P 2%Z = join12 Q m mu mu1 n nu nu1) by (unfold join12, join2,
    Section_2_2.Definitions.join2, a3_true, Section_2_2.Definitions.a3_true, a1, a2, a in *;
    third_point P n mu1 nu1); unfold join12, join2, Section_2_2.Definitions.join2, a3_true,
  Section_2_2.Definitions.a3_true in W; unfold a3_true, Section_2_2.Definitions.a3_true;
  fourth_point P n mu1 nu1 Q m (a m mu1 n nu).
Qed.

(* gbt-surfaces/ex-3.1.normal *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement V31 Q31]; compute_goal; conjuncts;
  [ ring | ring | ring | ring | transitivity (sqrt 1); [ f_equal; ring | apply sqrt_1 ] ].
Qed.

(* gbt-surfaces/ex-3.2.corners *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement Q00 Q10 Q20 Q30 Q01 Q11 Q21 Q31 Q02 Q12 Q22 Q03 Q13 Q23 Q33 f row_ sixteen];
  intros; repeat vector_at_end; repeat split.
Qed.

(* gbt-surfaces/ex-3.2.equation *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not row_ sixteen four]; intro no;
  specialize (no 0 1 0 0 0 (1 / 2) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra));
  revert no; cbv beta delta [f]; repeat vector_at_end; cbv beta delta [Q00 Q01 Q02 Q03 Q30 Q33 b];
  compute_goal; special; intro C; contradiction_in C.
Qed.

(* gbt-surfaces/ex-3.3.composite *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f a join1 a1 a2 a3_true join2 next cubic left_ next_ cubic_ left__ quartic
    quartic_]; intros; conjuncts; ends_of_sums; members_at_ends; members;
  cbv beta delta [join3 b1 b2_true c1 b3_true b5_true b4_true a a1 a2 a3_true] in *; field; nonzero.
Qed.

(* gbt-surfaces/ex-3.3.gl-0 *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not f]; intro no; refuting (no 0 0 0 0 0 1 0 0 0).
Qed.

(* gbt-surfaces/ex-3.3.gl-1 *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not f]; intro no; refuting (no 0 1 0 0 0 0 0 0 0).
Qed.

(* gbt-surfaces/ex-3.5.c1-sections *)
Theorem met.
Proof.
  cbv beta zeta delta [instance gap]; exists 0, 0, 0, 0; conjuncts;
  first [ lra | intros; lia | rows_added first S1; rows_added second S2;
    repeat match goal with E : forall _, _ |- _ => rewrite !E; clear E end; cbv beta delta [f S1 S2]; orders;
    cbn [row nth pred]; written_out; ends_of_sums; parts; field ].
Qed.

(* gbt-surfaces/ex-3.5.c1-sections *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement gap]; intros mu mu1 nu nu1 _ N _ _; rows_added first S1;
  rows_added second S2; repeat match goal with E : forall _, _ |- _ => rewrite !E; clear E end;
  cbv beta delta [f S1 S2]; orders; cbn [row nth pred]; written_out; ends_of_sums; intro E; equations;
  assert (mu1 = nu) by (apply Rmult_eq_reg_l with PI; [ lra | apply PI_neq0 ]); repeat split; parts; lra.
Qed.

(* gbt-surfaces/ex-3.5.c1-trajectories *)
Theorem met.
Proof.
  cbv beta zeta delta [instance gap]; exists 0, 0, 0, 0; conjuncts;
  first [ lra | intros; lia | rows_added first T1; rows_added second T2;
    repeat match goal with E : forall _, _ |- _ => rewrite !E; clear E end; cbv beta delta [f T1 T2]; orders;
    cbn [row nth pred]; written_out; ends_of_sums; parts; field ].
Qed.

(* gbt-surfaces/ex-3.5.c1-trajectories *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement gap]; intros mu mu1 nu nu1 _ N _ _; rows_added first T1;
  rows_added second T2; repeat match goal with E : forall _, _ |- _ => rewrite !E; clear E end;
  cbv beta delta [f T1 T2]; orders; cbn [row nth pred]; written_out; ends_of_sums; intro E; equations;
  assert (mu1 = nu) by (apply Rmult_eq_reg_l with PI; [ lra | apply PI_neq0 ]); repeat split; parts; lra.
Qed.

(* gbt-surfaces/ex-3.5.c2-sections *)
Theorem met.
Proof.
  cbv beta zeta delta [instance gap]; exists 0, (- 2 / (2 + PI)), (- 2 / (2 + PI)), (0); pose proof PI_RGT_0;
  conjuncts; first [ lra | intros; lia | rows_added first S1; rows_added second S2;
    repeat match goal with E : forall _, _ |- _ => rewrite !E; clear E end; cbv beta delta [f S1 S2]; orders;
    cbn [row nth pred]; written_out; ends_of_sums; parts; field; lra ].
Qed.

(* gbt-surfaces/ex-3.5.c2-sections *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement gap]; intros mu mu1 nu nu1 H N; rows_added first S1; rows_added second S2;
  repeat match goal with E : forall _, _ |- _ => rewrite !E; clear E end; cbv beta delta [f S1 S2]; orders;
  cbn [row nth pred]; written_out; ends_of_sums; intros E1 E2 D; injection E1; injection E2; clear E1 E2;
  intros; pose proof PI_RGT_0 as P; assert (mu1 = nu) by (apply Rmult_eq_reg_l with PI;
    [ lra | apply PI_neq0 ]); subst mu1; assert (Q : PI ^ 2 <> 0) by (apply pow_nonzero, PI_neq0);
  assert (M : nu1 = mu) by (apply Rmult_eq_reg_l with (PI ^ 2); [ lra | exact Q ]);
  assert (V : (2 + PI) * nu = - 2) by (subst nu1; apply Rmult_eq_reg_l with PI; [ lra | apply PI_neq0 ]);
  repeat split; try lra; [ parts; ring | apply Rmult_eq_reg_l with (2 + PI);
    [ rewrite V; field; exact D | exact D ] | nra | nra ].
Qed.

(* gbt-surfaces/ex-3.5.c2-trajectories *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement gap not]; intro no;
  specialize (no 1 (- 2 / (2 + PI)) (- 2 / (2 + PI)) ((10 + PI) / (2 + PI)) ltac:(lra) ltac:(intros; lia));
  revert no; rows_added first T1; rows_added second T2;
  repeat match goal with E : forall _, _ |- _ => rewrite !E; clear E end; cbv beta delta [f T1 T2]; orders;
  cbn [row nth pred]; written_out; ends_of_sums; intro no; pose proof PI_RGT_0;
  destruct (no ltac:(parts; field; lra) ltac:(parts; field; lra)) as (_ & _ & _ & C); revert C;
  apply Rlt_not_le; numeric.
Qed.

(* gbt-surfaces/ex-3.5.c2-trajectories.true *)
Theorem met.
Proof.
  cbv beta zeta delta [instance gap]; exists 0, (- 2 / (2 + PI)), (- 2 / (2 + PI)), (2 + 8 / (2 + PI));
  pose proof PI_RGT_0; conjuncts; first [ lra | intros; lia | rows_added first T1; rows_added second T2;
    repeat match goal with E : forall _, _ |- _ => rewrite !E; clear E end; cbv beta delta [f T1 T2]; orders;
    cbn [row nth pred]; written_out; ends_of_sums; parts; field; lra ].
Qed.

(* gbt-surfaces/ex-3.5.c2-trajectories.true *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement gap]; intros mu mu1 nu nu1 H N; rows_added first T1; rows_added second T2;
  repeat match goal with E : forall _, _ |- _ => rewrite !E; clear E end; cbv beta delta [f T1 T2]; orders;
  cbn [row nth pred]; written_out; ends_of_sums; intros E1 E2 D; injection E1; injection E2; clear E1 E2;
  intros; pose proof PI_RGT_0 as P; assert (mu1 = nu) by (apply Rmult_eq_reg_l with PI;
    [ lra | apply PI_neq0 ]); subst mu1; assert (Q : PI ^ 2 <> 0) by (apply pow_nonzero, PI_neq0);
  assert (V : (2 + PI) * nu = - 2) by (apply Rmult_eq_reg_l with PI; [ lra | apply PI_neq0 ]);
  assert (V' : nu = - 2 / (2 + PI)) by (apply Rmult_eq_reg_l with (2 + PI);
    [ rewrite V; field; exact D | exact D ]);
  assert (M : nu1 = 2 - 4 * nu - mu) by (apply Rmult_eq_reg_l with (PI ^ 2); [ lra | exact Q ]); repeat split;
  [ exact V' | rewrite M, V'; field; exact D | assert (nu < 0) by nra; lra ].
Qed.

(* gbt-surfaces/fig-16.lambda.between the panels *)
Theorem met.
Proof.
  cbv beta zeta delta [instance a]; exists 3%Z, 3%Z, (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun _ => 0),
  1, 0, 0, 0, 0, 0, 0; conjuncts; first [ lia | intros; lia | lra | numeric | ring ].
Qed.

(* gbt-surfaces/fig-16.lambda.between the panels *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement along_profiles swung FX FZ FX2 FZ2 f a]; lists; intros; split; parts;
  ends_of_sums; rewritten; field; nonzero.
Qed.

(* gbt-surfaces/prop-3.3.b *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f]; intros; intro no; refuting (no 1 0 0 0 (1 / 2)).
Qed.

(* gbt-surfaces/prop-3.4.a.net *)
Theorem met.
Proof.
  cbv beta zeta delta [instance any any_ line line_ f]; exists (fun _ => 0), (fun _ => 0), 0, 0, 0, 0, 0;
  lists; conjuncts; first [ lra | ends_of_sums; ring ].
Qed.

(* gbt-surfaces/prop-3.4.a.net *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement any any_ line line_ f]; intros; intro no;
  refuting_at_ends (no (fun i => nth (Z.to_nat i) [0; 1; 0] 0) (fun _ => 0) 0 (-1) 0 0 (1 / 2)).
Qed.

(* gbt-surfaces/prop-3.4.b *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement M0 M1 S2 jump jump0 jump1 S2_ S__ jump_ f L0 L1 S_ b printed_ tensor
    own4]; lists; intros; conjuncts; spread; ring.
Qed.

(* gbt-surfaces/prop-3.7.2b *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement section2 along_sections jump_section trajectory2 along_trajectories
    jump_trajectory f section trajectory T S1 S2 T1 T2 second first gap first_]; lists;
  intros; conjuncts; spread; ring.
Qed.

(* gbt-surfaces/prop-3.8.a.true *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement at_angle at_angle_ T cosine sine]; intros q w x Q N M A B L;
  refine (conj _ (conj _ (conj _ _))); [ rewrite (arc_cos _ _ (square_sum _) N), (arc_sin _ _ (square_sum _)
      N), half_cos, half_sin; reflexivity | special; field; special; lra | special; field; special; lra
    | apply arc_rate; assumption ].
Qed.

(* gbt-surfaces/prop-3.8.b *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement not Tm cosine sine]; intro no;
  specialize (no (1 / 3) 0 1 ltac:(lra) ltac:(lra)); injection no; intros _ H; revert H;
  replace (PI * (2 - 1 / 3)) with (2 * PI - PI / 3) by field; rewrite cos_2PI_minus, cos_PI3;
  match goal with |- ?a = ?b -> _ => change (a <> b) end; numeric.
Qed.

(* gbt-surfaces/prop-3.8.b.true *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement at_angle at_angle_ Tm cosine sine]; intros q w x Q N M A B L;
  refine (conj _ (conj _ (conj _ _))); [ rewrite (arc_cos _ _ (square_sum _) N), (arc_sin _ _ (square_sum _)
      N); replace (PI * (2 - q)) with (2 * PI - PI * q) by ring;
    rewrite cos_2PI_minus, sin_2PI_minus, half_cos, half_sin; parts; ring | special; field; special; lra
    | special; field; special; lra | apply arc_rate; assumption ].
Qed.

(* gbt-surfaces/sec-1.contrib-1 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f Tz0 Tz1end Tz1 Tzz1end]; intros; conjuncts; intro no;
  refuting_at_ends (no 3%Z 3%Z (fun i j => IZR (i + j)) 0 0 0 0).
Qed.

(* gbt-surfaces/sec-1.contrib-2 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f F cylinder F_ G ruled G_ swept FX FZ swung FX_ FZ_ N_ N__]; intros;
  conjuncts; intro no; refuting_at_ends (no 3%Z 3%Z (fun i _ => IZR i) (fun i => IZR i) (fun i => IZR i) 0 0
    (fun i => IZR i) (fun i => IZR i) 1 1 0 0 1 1 0).
Qed.

(* gbt-surfaces/sec-1.contrib-3.by the printed conditions *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement a printed11 a1 a2 a3 printed12 b1 b2 c1 b3 b4 printed13 f F1 F] in
  no; refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0;
        1; -1; 16] 0) 1 (-1) (-1) 0).
Qed.

(* gbt-surfaces/sec-1.contrib-3.there are such compositions *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement a1 b1 f a join1 a2 a3_true join2 b2_true c1 b3_true b5_true b4_true join3
    next onF F next_ onF_ F_]; sums_at_ends; intros; conjuncts; parts; field; nonzero.
Qed.

(* gbt-surfaces/sec-2.2.end-derivatives *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f F F_]; intros; conjuncts;
  first [ intro no; refuting_at_ends (no 2%Z (fun i => IZR i) 0 0) | ends_of_sums; field ].
Qed.

(* gbt-surfaces/sec-2.2.variation-diminishing.order-2 *)
Theorem met.
Proof.
  exists 0, 0, 0; repeat split; lra.
Qed.

(* gbt-surfaces/sec-2.2.variation-diminishing.order-2 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement w f]; compute_goal; intros mu nu z; intros; derivatives;
  pose proof (sin2_cos2 (PI / 2 * z)) as E; unfold Rsqr in E; pose proof PI_RGT_0;
  assert (S : 0 <= sin (PI / 2 * z)) by (apply sin_ge_0; nra);
  assert (C : 0 <= cos (PI / 2 * z)) by (apply cos_ge_0; nra);
  assert (S1 : sin (PI / 2 * z) <= 1) by apply SIN_bound;
  assert (C1 : cos (PI / 2 * z) <= 1) by apply COS_bound; generalize dependent (sin (PI / 2 * z));
  generalize dependent (cos (PI / 2 * z)); generalize dependent PI; intros p P c C C1 s E S S1;
  assert (F : c * c = 1 - s * s) by lra; repeat split; apply Rle_ge;
  [ apply Rle_trans with (p / 8 * (((1 + mu) * (1 + nu)) * (2 * ((1 - s) * (1 - s)) * (2 - c + s)) + ((1 + mu)
          * (1 - nu)) * (2 * c * ((1 - s) * (1 - s))) + ((1 - mu) * (1 + nu)) * (2 * s * (c * c))));
    [ repeat first [ lra | match goal with |- 0 <= _ + _ => apply Rplus_le_le_0_compat
        | |- 0 <= _ * _ => apply Rmult_le_pos end ] | right; field_simplify_eq; ring [F] ]
    | apply Rle_trans with (p / 8 * (((1 + mu) * (1 + nu)) * (2 * ((1 - c) * (1 - c)) * (2 - s + c)) + ((1 -
            mu) * (1 + nu)) * (2 * s * ((1 - c) * (1 - c))) + ((1 + mu) * (1 - nu)) * (2 * c * (s * s))));
    [ repeat first [ lra | match goal with |- 0 <= _ + _ => apply Rplus_le_le_0_compat
        | |- 0 <= _ * _ => apply Rmult_le_pos end ] | right; field_simplify_eq; ring [F] ]
    | apply Rle_trans with (p / 4 * ((1 - s) * ((1 + mu) * (1 - s) + (1 - mu) * (1 + s)) * s * ((1 + nu) * (1
            - c) + (1 - nu) * c) + (1 - c) * ((1 + nu) * (1 - c) + (1 - nu) * (1 + c)) * c * ((1 + mu) * (1 -
            s) + (1 - mu) * s))); [ repeat first [ lra
        | match goal with |- 0 <= _ + _ => apply Rplus_le_le_0_compat
        | |- 0 <= _ * _ => apply Rmult_le_pos end ] | right; field_simplify_eq; ring [F] ]
    | apply Rle_trans with (1 / 32 * (p * p * p) * (((1 + mu) * (1 + nu)) * (4 * (1 - s) * (1 - c) + 4 * s *
          (c * c) * (1 - c) + 4 * (s * s) * c * (1 - s)) + ((1 + mu) * (1 - nu)) * (4 * c * (1 - s) * (1 + s))
        + ((1 - mu) * (1 + nu)) * (4 * s * (1 - c) * (1 + c))));
    [ repeat first [ lra | match goal with |- 0 <= _ + _ => apply Rplus_le_le_0_compat
        | |- 0 <= _ * _ => apply Rmult_le_pos end ] | right; field_simplify_eq; ring [F] ] ].
Qed.

(* gbt-surfaces/sec-2.3.classical.the features of Sect. 2.2 (printed) *)
Theorem proved.
Proof.
  hnf; intros m n G mu mu1 nu nu1 z z1 c1 c2 c3 c4 c5 c6 c7 c8 c9 c10 c11 c12 c13 c14; pose proof (fun y
    cy => proved_there m n G mu mu1 nu nu1 y z1 c1 c2 c3 c4 c5 c6 cy c8 c9 c10 c11 c12 c13 c14) as all;
    exact (conj (fun y cy => proj1 (all y cy)) (proj2 (all z c7))).
Qed.

(* gbt-surfaces/sec-2.3.classical.the features of Sect. 2.2 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f T T_ Tz0 Tz1 Tu0 Tu1]; intros; conjuncts;
  first [ intro no; refuting_at_ends (no 2%Z 2%Z (fun i j => IZR (i + j)) 0 0 0 0 0 0) | symbolic ].
Qed.

(* gbt-surfaces/sec-2.3.features.c *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f Tz0 Tz1 Tu0 Tu1]; intros; conjuncts; intro no;
  refuting_at_ends (no 2%Z 2%Z (fun i j => IZR (i + j)) 0 0 0 0).
Qed.

(* gbt-surfaces/sec-3.1.benefits (printed) *)
Theorem proved.
Proof.
  hnf; intros m Q V alpha mu nu z z1 c1 c2 c3 c4 c5 c6 c7 c8 c9; pose proof (fun y cy => proved_there m Q
    V alpha mu nu y z1 c1 c2 c3 c4 cy c6 c7 c8 c9) as all; destruct (all z c5) as (a1 & _ & _ & rest); exact
    (conj a1 (conj (fun y cy => proj1 (proj2 (all y cy))) (conj (fun y cy => proj1 (proj2 (proj2 (all y
    cy)))) rest))).
Qed.

(* gbt-surfaces/sec-3.1.not-tensor.literal *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement]; intro no; apply (no 2%Z (fun _ => 0) 0 1 0 0 0 0);
  [ lra | lia | lra | lra | lra | lra | ]; clear; intros m Q V alpha mu nu z z1 _ _ _ _ _ _ _;
  cbv beta delta [T net3]; apply sum_ext; intros k _; generalize (f z mu nu k m); intro g; rewrite Rmult_comm;
  f_equal; cbv beta delta [f]; compute_goal; pose proof (sin2_cos2 (PI / 2 * z1)) as E; unfold Rsqr in E;
  generalize dependent (sin (PI / 2 * z1)); generalize dependent (cos (PI / 2 * z1)); intros c s E;
  assert (F : s * s = 1 - c * c) by lra; ring [F].
Qed.

(* gbt-surfaces/sec-3.2.list-2 (printed) *)
Theorem proved.
Proof.
  hnf; intros m n A B G mu mu1 nu nu1 t z z1 c1 c2 c3 c4 c5 c6 c7 c8 c9 c10 c11 c12 c13 c14; destruct
    (proved_there m n A B G mu mu1 nu nu1 t z z1 c1 c2 c3 c4 c5 c6 c7 c8 c9 c10 c11 c12 c13 c14) as (a1 & a2
    & a3 & a4 & a5 & _); refine (conj a1 (conj a2 (conj a3 (conj a4 (conj a5 _))))); intros y cy; exact
    (proj2 (proj2 (proj2 (proj2 (proj2 (proved_there m n A B G mu mu1 nu nu1 t y z1 c1 c2 c3 c4 c5 c6 cy c8
    c9 c10 c11 c12 c13 c14)))))).
Qed.

(* gbt-surfaces/sec-3.2.list-2 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 2%Z, 2%Z, 0, 0, (fun _ _ => 0), 0, 0, 0, 0, (fun _ => 0), 0, 0;
  conjuncts; first [ lia | intros; lia | lra ].
Qed.

(* gbt-surfaces/sec-3.2.list-2 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement R_ T f]; intros; repeat split;
  [ apply sum_ext; intros; f_equal; curve_at_end; reflexivity .. | | ];
  [ rewrite (sum_ext 0 m _ (fun k => A * basis (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 *
              z)); 1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu
            * cos (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] k m + (B - A) * (basis
          (1 - z) z [(1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z));
            1 - (1 - sin (PI / 2 * z)) * (1 - mu * sin (PI / 2 * z)) - (1 - cos (PI / 2 * z)) * (1 - nu * cos
              (PI / 2 * z)); (1 - cos (PI / 2 * z)) * (1 - nu * cos (PI / 2 * z))] k m * t k))) by (intros;
      ring); rewrite sum_plus, !sum_scal; rewrite unity_of_three by (lia || lra); ring | intros; nonnegative ].
Qed.

(* gbt-surfaces/sec-3.2.list-3 *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 2%Z, 2%Z, (fun _ _ => 0), 0, 0, 0, 0, 0, 0; conjuncts;
  first [ lia | intros; lia | lra ].
Qed.

(* gbt-surfaces/sec-3.2.list-3 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement T R_]; intros m n G mu mu1 nu nu1 z z1; intros;
  transitivity (sum 0 n (fun l => sum 0 m (fun k => f z1 mu1 nu1 l n * (f z mu nu k m * G k l))));
  [ apply sum_ext; intros; symmetry; apply sum_scal | rewrite sum_swap; apply sum_ext; intros;
    rewrite <- sum_scal; apply sum_ext; intros; ring ].
Qed.

(* gbt-surfaces/sec-3.3.same-degree.in general *)
Theorem met.
Proof.
  cbv beta zeta delta [instance quartic quartic_ cubic cubic_ f]; exists (fun _ => 0), (fun _ => 0), 0; lists;
  conjuncts; first [ lra | ends_of_sums; ring ].
Qed.

(* gbt-surfaces/sec-3.3.same-degree.in general *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement quartic quartic_ cubic cubic_ f]; intros; intro no;
  refuting_at_ends (no (fun i => nth (Z.to_nat i) [0; 0; 0; 1] 0) (fun i => nth (Z.to_nat i) [0; 0; 0;
        2 / (4 + PI); 1] 0) (1 / 2)).
Qed.

(* gbt-surfaces/sec-3.3.same-degree.literal *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement]; intro no; apply (no (fun _ => 0) 0 0 0 0 0);
  [ lra | lra | clear; intros B P R_ W z z1 _ _; cbv beta delta [cubic quartic raised f b]; compute_goal;
    pose proof (sin2_cos2 (PI / 2 * z)) as E; unfold Rsqr in E; generalize dependent (sin (PI / 2 * z));
    generalize dependent (cos (PI / 2 * z)); intros c s E; assert (F : s * s = 1 - c * c) by lra;
    field_simplify_eq; ring [F] ].
Qed.

(* gbt-surfaces/sec-3.4.closed *)
Theorem met.
Proof.
  cbv beta zeta delta [instance gapz gapz1 swung]; exists 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0; lists;
  conjuncts; first [ lra | cbn; ring ].
Qed.

(* gbt-surfaces/sec-3.4.closed *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement gapz gapz1 gapz_ gapz1_ swung]; lists;
  intros lambda r theta u0 u1 v0 v1 w w0 w1 x x0 x1 L R0 A B C D N X; pose proof (sin2_cos2 theta) as E;
  unfold Rsqr in E; assert (K : lambda <> 0) by lra;
  assert (A' : lambda * r * (x1 - x0) = 0) by (transitivity (lambda * r * (x1 - x0) * (sin theta * sin theta +
        cos theta * cos theta)); [ rewrite E; ring | rewrite <- A; cbn; ring ]);
  assert (x1 = x0) by (assert (G : x1 - x0 = 0) by (apply (Rmult_eq_reg_l (lambda * r));
      [ rewrite A'; ring | apply Rmult_integral_contrapositive_currified; assumption ]); lra);
  assert (w1 = w0) by (cbn in B; lra); assert (P : lambda * x <> 0) by (apply
    Rmult_integral_contrapositive_currified; assumption);
  assert (u1 = u0) by (apply (Rmult_eq_reg_l (lambda * x)); [ cbn in C; lra | exact P ]);
  assert (v1 = v0) by (apply (Rmult_eq_reg_l (lambda * x)); [ cbn in D; lra | exact P ]); repeat split;
  try assumption; compute_goal; parts; ring.
Qed.

(* gbt-surfaces/sec-3.4.continuity-pc *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement along_profiles f FX FX2 FZ2 FZ swung jumpX jumpZ]; lists; intros; conjuncts;
  parts; spread; ring.
Qed.

(* gbt-surfaces/sec-3.4.continuity-tc *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f FU2 FV2 FU FV swung along_trajectories jumpU jumpV]; lists; intros;
  conjuncts; parts; spread; ring.
Qed.

(* gbt-surfaces/sec-3.4.revolution-not-tensor.cubic *)
Theorem met.
Proof.
  cbv beta zeta delta [instance f K K_]; exists 1, 1, 1, 1, 0, 0, 0; met.
Qed.

(* gbt-surfaces/sec-3.4.revolution-not-tensor.cubic *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f K K_]; prepared; unknown c0; unknown c1; unknown c2; unknown c3; finished.
Qed.

(* gbt-surfaces/sec-3.6.c1c2 *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f line2X line2Z FX FZ jumpX jumpZ turned jump]; lists; intros; conjuncts;
  parts; spread; ring.
Qed.

(* gbt-surfaces/sec-3.6.plane.generating line *)
Theorem proved.
Proof.
  hnf; intros phi psi w x c e; cbn in e; assert (P : sin phi * x = 0) by lra; destruct (Rmult_integral _ _
    P); [ right | left ]; assumption.
Qed.

(* gbt-surfaces/sec-4.composite.by the printed conditions *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement a printed11 a1 a2 a3 printed12 b1 b2 c1 b3 b4 printed13 f F1 F] in
  no; refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0;
        1; -1; 16] 0) 1 (-1) (-1) 0).
Qed.

(* gbt-surfaces/sec-4.composite.there are such compositions *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement a1 b1 f a join1 a2 a3_true join2 b2_true c1 b3_true b5_true b4_true join3
    next F next_ F_]; sums_at_ends; intros; conjuncts; parts; field; nonzero.
Qed.

(* gbt-surfaces/sec-4.six-tensor.without (printed) *)
Theorem met.
Proof.
  destruct proved_there as (m & n & A & B & Q & U & V & X & Z & mu & mu1 & nu & nu1 & z & z1 & c1 & c2 &
    c3 & c4 & c5 & c6 & c7 & c8 & c9 & c10 & c11 & c12 & c13); exists m, n, A, B, Q, U, V, X, Z, mu, mu1,
    nu, nu1, z, z1; refine (conj c1 (conj c2 (conj c3 (conj c4 (conj c5 (conj c6 (conj c7 (conj c8 (conj c9
    (conj c10 (conj c11 (conj c12 (conj c13 _))))))))))))); intros; apply (BinInt.Z.le_trans 2 3 n); [
    discriminate | exact c4 ].
Qed.

(* gbt-surfaces/sec-4.six-tensor.without (printed) *)
Theorem proved.
Proof.
  hnf; intros m n A B Q U V X Z mu mu1 nu nu1 z z1 c1 c2 c3 c4 c5 c6 c7 c8 c9 c10 c11 c12 c13 c14; exact
    (proved_there m n A B Q U V X Z mu mu1 nu nu1 z z1 c1 c2 c3 c4 c5 c6 c7 c8 c9 c10 c11 c12 c13).
Qed.

(* gbt-surfaces/tab-1.2.proposed *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f a1 a join1 a2 a3_true join2 next onF F next_ onF_ F_ cylinder]; intros;
  conjuncts; ends_of_sums; field; nonzero.
Qed.

(* gbt-surfaces/tab-1.3.proposed *)
Theorem met.
Proof.
  cbv beta zeta delta [instance a1 b1]; exists 3%Z, (fun _ => 0), (fun _ => 0), 0, 0, 0; conjuncts;
  first [ lia | intros; lia | lra | numeric ].
Qed.

(* gbt-surfaces/tab-1.3.proposed *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement a1 b1 f a join1 a2 a3_true join2 b2_true c1 b3_true b5_true b4_true join3
    next onF onG F G next_ onF_ onG_ F_ G_ ruled]; intros; conjuncts; ends_of_sums; field; nonzero.
Qed.

(* gbt-surfaces/tab-1.4.proposed *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f a1 a join1 a2 a3_true join2 next onX onZ FX FZ next_ onX_ onZ_ FX_ FZ_
    swung]; lists; intros; conjuncts; parts; ends_of_sums; field; nonzero.
Qed.

(* gbt-surfaces/tab-1.5.proposed *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f a1 a join1 a2 a3_true join2 next onF F next_ onF_ F_ swept]; intros;
  conjuncts; ends_of_sums; field; nonzero.
Qed.

(* gbt-surfaces/thm-1.2.Definition 1 *)
Theorem refuted.
Proof.
  cbv beta zeta delta [statement f]; intro no; destruct (no 0 0 1 ltac:(lra) ltac:(lra) ltac:(lra)) as [_ C];
  revert C; compute_goal; replace (PI / 2 * (- (1))) with (- (PI / 2)) by field;
  rewrite ?sin_neg, ?cos_neg, ?sin_PI2, ?cos_PI2; intro C; lra.
Qed.

(* gbt-surfaces/thm-1.5.d2-0.values *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f start second p0 p2]; intros; undifferentiated; members_at_ends; conjuncts;
  field.
Qed.

(* gbt-surfaces/thm-1.5.d3-0.values *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f start third p0 p2]; intros; undifferentiated; members_at_ends; conjuncts;
  field.
Qed.

(* gbt-surfaces/thm-2.3.a *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement a printed11 a1 a2 a3 printed12 f F1 F] in no;
  refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0; 1;
        -1; 16] 0) 1 (-1) (-1) 0).
Qed.

(* gbt-surfaces/thm-2.3.b *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement f F1 F F1_ F_ a1 a printed11 a2 a3 printed12] in no;
  refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0; 1;
        -3; -1] 0) 1 (-1) (-1) 0).
Qed.

(* gbt-surfaces/thm-2.3.necessary *)
Theorem met.
Proof.
  cbv beta zeta delta [instance f F1 F F1_ F_ a1 a join1 join11 a2 a3_true join2 join12];
  exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal;
  conjuncts; first [ lia | intros; lia | lra | numeric ].
Qed.

(* gbt-surfaces/thm-2.3.necessary *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f F1 F F1_ F_ a1 a join1 join11 a2 a3_true join2 join12]; sums_at_ends;
  intros m n Q P mu mu1 nu nu1; intros; split;
  [ assumption | lazymatch goal with |- ?A /\ _ => assert A by second_point P n mu1; split;
    [ assumption | third_point P n mu1 nu1 ] end ].
Qed.

(* gbt-surfaces/thm-2.4.a *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement a printed11 a1 a2 a3 printed12 b1 b2 c1 b3 b4 printed13 f F1 F] in
  no; refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1; 0] 0) (fun i => nth (Z.to_nat i) [0;
        1; -1; 16] 0) 1 (-1) (-1) 0).
Qed.

(* gbt-surfaces/thm-2.4.b *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement f F1 F F1_ F_ a1 b1 a printed11 a2 a3 printed12 b2 c1 b3 b4
    printed13] in no; refuting_at_ends (no 3%Z 3%Z (fun i => nth (Z.to_nat i) [0; 0; -1;
        0] 0) (fun i => nth (Z.to_nat i) [0; 1; -3; -1] 0) 1 (-1) (-1) 0).
Qed.

(* gbt-surfaces/thm-2.4.necessary *)
Theorem met.
Proof.
  cbv beta zeta delta [instance f F1 F F1_ F_ a1 b1];
  exists (3)%Z, (3)%Z, (fun _ => 0), (fun _ => 0), (0), (0), (0), (0); lists; ends_of_sums; compute_goal;
  conjuncts; first [ lia | intros; lia | lra | numeric ].
Qed.

(* gbt-surfaces/thm-2.4.necessary *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement f F F1 F1_ F_ a3_true b4_true join1 join11 join3 join13]; sums_at_ends;
  intros m n Q P mu mu1 nu nu1; intros; assert (V : P 1%Z = Q m + a m mu1 n nu * (Q m - Q (m - 1)%Z)) by
  (unfold a; second_point P n mu1); assert (W : P 2%Z = join12 Q m mu mu1 n nu nu1) by (unfold join12, join2,
    Section_2_2.Definitions.join2, a3_true, Section_2_2.Definitions.a3_true, a1, a2, a in *;
    third_point P n mu1 nu1); repeat split; [ assumption | exact V | exact W
    | unfold join12, join2, Section_2_2.Definitions.join2, a3_true, Section_2_2.Definitions.a3_true in W;
    unfold a3_true, Section_2_2.Definitions.a3_true; fourth_point P n mu1 nu1 Q m (a m mu1 n nu) ].
Qed.

(* gbt-surfaces/thm-2.a *)
Theorem met.
Proof.
  exists 3%Z, 3%Z, (fun _ => 0), (fun _ => 0), 1, (-1), (-1), 0, (fun _ => 0), Ropp;
  cbv beta zeta delta [F F1 F_ F1_ f]; conjuncts; premise_of_join.
Qed.

(* gbt-surfaces/thm-2.a *)
Theorem proved.
Proof.
  intros m n Q P mu mu1 nu nu1 p0 p1 ? ? ? ? ? ? _ _ _ _ _ _ D _ _ V W; lists;
  match goal with |- - Derive_n ?f 1 ?x = ?w => transitivity (- - w);
  [ apply f_equal, (slope_of_line f (fun t => Q m + w * (Q m - t)));
    [ intro t; pose proof (second_joined_alone _ _ n m mu1 nu1 mu nu ltac:(lia) ltac:(lia) (V t) (W t) D) as
      E; updated_in E; updated; exact E | intro; ring ] | ring ] end.
Qed.

(* gbt-surfaces/thm-2.a1.sign *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement a1 a1_]; mixed.
Qed.

(* gbt-surfaces/thm-2.a3 *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement F F1 F_ F1_ f a1] in no;
  specialize (no 3%Z 3%Z (fun _ => 0) (fun _ => 0) 1 (-1) (-1) 0 (fun t => t) (fun t => 2 * t) (fun t => - 2 *
      t)); without_premises no; revert no; lists;
  match goal with |- Derive_n ?f 1 ?x = _ -> _ => rewrite (slope_of_line f (fun t => - 3 * PI ^ 2 * t) x (- 3
      * PI ^ 2)); [ unfold a1; intro C; apply (pow_nonzero PI 2 PI_neq0); lra | unfold a1, a2; intro;
    compute_goal; field | intro; ring ] end.
Qed.

(* gbt-surfaces/thm-2.a3 (corrected) *)
Theorem met.
Proof.
  exists 3%Z, 3%Z, (fun _ => 0), (fun _ => 0), 1, (-1), (-1), 0, (fun t => t), (fun t => 2 * t), (fun t => - 2
    * t); cbv beta zeta delta [F F1 F_ F1_ f a1]; conjuncts; premise_of_join.
Qed.

(* gbt-surfaces/thm-2.a3 (corrected) *)
Theorem proved.
Proof.
  third_coefficient ().
Qed.

(* gbt-surfaces/thm-2.a3.true *)
Theorem met.
Proof.
  exists 3%Z, 3%Z, (fun _ => 0), (fun _ => 0), 1, (-1), (-1), 0, (fun t => t), (fun t => 2 * t), (fun t => - 2
    * t); cbv beta zeta delta [F F1 F_ F1_ f a1]; conjuncts; premise_of_join.
Qed.

(* gbt-surfaces/thm-2.a3.true *)
Theorem proved.
Proof.
  third_coefficient ().
Qed.

(* gbt-surfaces/thm-2.b1.sign *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement b1 b1_]; mixed.
Qed.

(* gbt-surfaces/thm-2.b3 *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement f F1 c1] in no; refuting_at_ends (no 3%Z (fun _ => 0) 1 1).
Qed.

(* gbt-surfaces/thm-2.b4 *)
Theorem refuted.
Proof.
  intro no; cbv beta zeta delta [statement F F1 F_ F1_ f b3 a3 a1] in no;
  specialize (no 3%Z 3%Z (fun _ => 0) (fun _ => 0) 1 (-1) (-1) 0 (fun _ => 0) (fun t => - t) (fun t => 3 * t)
    (fun t => t) (fun _ => 0) (fun _ => 0) (fun _ => 0) (fun t => - 2 * t) (fun _ => 0) (fun _ => 0) (fun _ =>
      0) (fun _ => 0)); without_premises no; revert no; lists;
  let formed f x d := rewrite (slope_of_line f (fun t => d * t) x d);
  [ | unfold b1; intro; compute_goal; field | intro;
    ring ] in match goal with |- Derive_n ?f 1 ?x * _ + (Derive_n ?g 1 ?y * _ + (Derive_n ?h 1 ?z * _ + _)) -
  _ = _ -> _ => formed f x (6 * PI ^ 2); formed g y (- 12 * PI ^ 2); formed h z 0 end;
  unfold b3_true, a3_true, a, c1, a1; intro C; apply (pow_nonzero PI 2 PI_neq0); pose proof PI_neq0 as N;
  match type of C with ?l = ?r => transitivity ((l - r) / 6); [ | rewrite C ]; field; exact N end.
Qed.

(* gbt-surfaces/thm-2.b4 (corrected) *)
Theorem met.
Proof.
  exists 3%Z, 3%Z, (fun _ => 0), (fun _ => 0), 1, (-1), (-1), 0, (fun _ => 0), (fun t => - t), (fun t => 3 *
    t), (fun t => t), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun t => - 2 * t), (fun _ => 0), (fun _ =>
    0), (fun _ => 0), (fun _ => 0); cbv beta zeta delta [F F1 F_ F1_ f a1]; conjuncts; premise_of_join.
Qed.

(* gbt-surfaces/thm-2.b4 (corrected) *)
Theorem proved.
Proof.
  fourth_coefficients ().
Qed.

(* gbt-surfaces/thm-2.b4.true *)
Theorem met.
Proof.
  exists 3%Z, 3%Z, (fun _ => 0), (fun _ => 0), 1, (-1), (-1), 0, (fun _ => 0), (fun t => - t), (fun t => 3 *
    t), (fun t => t), (fun _ => 0), (fun _ => 0), (fun _ => 0), (fun t => - 2 * t), (fun _ => 0), (fun _ =>
    0), (fun _ => 0), (fun _ => 0); cbv beta zeta delta [F F1 F_ F1_ f a1]; conjuncts; premise_of_join.
Qed.

(* gbt-surfaces/thm-2.b4.true *)
Theorem proved.
Proof.
  fourth_coefficients ().
Qed.

(* gbt-surfaces/thm-6.complete *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement at_angle T Tm cosine sine]; intros q w x Q N M L; refine (conj _ (conj _ _));
  [ rewrite (arc_cos _ _ (square_sum _) N), (arc_sin _ _ (square_sum _) N), half_cos, half_sin; reflexivity
    | rewrite (arc_cos _ _ (square_sum _) N), (arc_sin _ _ (square_sum _) N), half_cos, half_sin; reflexivity
    | destruct (arc_range q Q N); repeat split; try assumption; apply arc_rate; exact N ].
Qed.
