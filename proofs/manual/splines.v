(* Scripts of theorems of splines whose proofs have an idea of their own: nobody has to read them. This is no file for the
   kernel: `torse prove` reads each script by its claim and its name, and writes it below the statement. *)

(* splines/knots.nonnegative.cubic *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists IZR, 3; conjuncts; lra.
Qed.

(* splines/knots.nonnegative.cubic *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement N_]; compute_goal; intros; split; apply Rle_ge;
  repeat first [ lra | match goal with |- 0 <= _ + _ => apply Rplus_le_le_0_compat
    | |- 0 <= _ * _ => apply Rmult_le_pos | |- 0 <= _ / _ => apply Rmult_le_pos | |- 0 <= / _ => left;
    apply Rinv_0_lt_compat end ].
Qed.

(* splines/knots.nonnegative.ends *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists IZR, 2; conjuncts; lra.
Qed.

(* splines/knots.nonnegative.ends *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement N_]; compute_goal; intros; split; apply Rle_ge;
  repeat first [ lra | match goal with |- 0 <= _ + _ => apply Rplus_le_le_0_compat
    | |- 0 <= _ * _ => apply Rmult_le_pos | |- 0 <= _ / _ => apply Rmult_le_pos | |- 0 <= / _ => left;
    apply Rinv_0_lt_compat end ].
Qed.

(* splines/knots.nonnegative.middle *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 1, (1 / 2), (1 / 2), IZR, 1, (5 / 2); conjuncts; lra.
Qed.

(* splines/knots.nonnegative.middle *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement N_]; compute_goal; intros; apply Rlt_gt;
  rewrite ?Rplus_0_l, ?Rplus_0_r, ?Rmult_1_r; apply Rplus_lt_0_compat; apply Rmult_lt_0_compat;
  apply Rdiv_lt_0_compat; lra.
Qed.

(* splines/uniform.bound *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 0%Z, 0; split; [ lia | lra ].
Qed.

(* splines/uniform.bound *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement U]; intros i s I S; assert (J : (i = 0 \/ i = 1 \/ i = 2 \/ i = 3)%Z) by lia;
  assert (0 <= s * s * (2 - s)) by (repeat apply Rmult_le_pos; lra);
  assert (0 <= (1 - s) * (1 - s) * (1 + s)) by (repeat apply Rmult_le_pos; lra);
  assert (0 <= s * s * s) by (repeat apply Rmult_le_pos; lra);
  assert (0 <= (1 - s) * (1 - s) * (1 - s)) by (repeat apply Rmult_le_pos; lra);
  assert (0 <= s * s * (1 - s)) by (repeat apply Rmult_le_pos; lra);
  assert (0 <= (1 - s) * (1 - s) * s) by (repeat apply Rmult_le_pos; lra);
  assert (0 <= s * (1 - s)) by (apply Rmult_le_pos; lra); destruct J as [J|[J|[J|J]]]; subst i; compute_goal;
  lra.
Qed.

(* splines/uniform.nonnegative *)
Theorem met.
Proof.
  cbv beta zeta delta [instance]; exists 0%Z, 0; split; [ lia | lra ].
Qed.

(* splines/uniform.nonnegative *)
Theorem proved.
Proof.
  cbv beta zeta delta [statement U]; intros i s I S; assert (J : (i = 0 \/ i = 1 \/ i = 2 \/ i = 3)%Z) by lia;
  assert (0 <= s * s * (2 - s)) by (repeat apply Rmult_le_pos; lra);
  assert (0 <= (1 - s) * (1 - s) * (1 + s)) by (repeat apply Rmult_le_pos; lra);
  assert (0 <= s * s * s) by (repeat apply Rmult_le_pos; lra);
  assert (0 <= (1 - s) * (1 - s) * (1 - s)) by (repeat apply Rmult_le_pos; lra);
  assert (0 <= s * s * (1 - s)) by (repeat apply Rmult_le_pos; lra);
  assert (0 <= (1 - s) * (1 - s) * s) by (repeat apply Rmult_le_pos; lra);
  assert (0 <= s * (1 - s)) by (apply Rmult_le_pos; lra); destruct J as [J|[J|[J|J]]]; subst i; compute_goal;
  lra.
Qed.
