(* Proofs: nothing here has to be read. *)
From Torse Require Import Defs Series Theory Bounds Tactics Exponentials Signs Sums Combinations Unknowns Stages Rationals Solved Forms Consequences Radicals Bernstein Mixed Smooth Planes Ends Joins Hermite Positive.
From Bezier Require Part_Powers.
Open Scope R_scope.

Module power_next.
Import Bezier.Part_Powers.power_next.
Theorem proved : statement.
Proof. cbv delta [statement]; intros; rewrite !natural_power by lia; replace (Z.to_nat (m + 1)) with (S (Z.to_nat m)) by lia; cbn [pow]; ring. Qed.
Theorem met : instance.
Proof. cbv delta [instance]; exists 3%Z, 0; repeat split; (lra || lia || (left; lia)). Qed.
End power_next.

Module power_rate.
Import Bezier.Part_Powers.power_rate.
Theorem proved : statement.
Proof. cbv delta [statement]; intros; rewrite (Derive_n_ext _ (fun t => (1 - t) ^ Z.to_nat m)) by (intro; apply natural_power; lia); rewrite natural_power by lia; apply is_derive_unique; auto_derive; [ exact I | rewrite INR_IZR_INZ, Z2Nat.id by lia; replace (pred (Z.to_nat m)) with (Z.to_nat (m - 1)) by lia; replace (1 + - x) with (1 - x) by ring; ring ]. Qed.
Theorem met : instance.
Proof. cbv delta [instance]; exists 3%Z, 0; refine (conj _ (conj _ (conj _ (conj _ _)))); [ lia | lra | apply filter_forall; intro; left; lia | apply ex_derive_ext with (fun t => (1 - t) ^ 3); [ intro; reflexivity | auto_derive; exact I ] | left; lia ]. Qed.
End power_rate.

Module power_rate_slip.
Import Bezier.Part_Powers.power_rate_slip.
Theorem refuted : ~ statement.
Proof. cbv delta [statement not]; intro no; assert (E : Derive_n (fun x_ => powerRZ (1 - x_) 3) 1 0 = IZR 3 * powerRZ (1 - 0) (3 - 1)) by (apply no; [ lia | lra | apply filter_forall; intro; left; lia | apply ex_derive_ext with (fun t => (1 - t) ^ 3); [ intro; reflexivity | auto_derive; exact I ] | left; lia ]); assert (F : Derive_n (fun x_ => powerRZ (1 - x_) 3) 1 0 = - 3) by (apply is_derive_unique; apply is_derive_ext with (fun t => (1 - t) ^ 3); [ intro; reflexivity | auto_derive; [ exact I | cbn; ring ] ]); rewrite F in E; change (powerRZ (1 - 0) (3 - 1)) with ((1 - 0) * ((1 - 0) * 1)) in E; lra. Qed.
End power_rate_slip.

Module power_rate_slip_corrected.
Import Bezier.Part_Powers.power_rate_slip_corrected.
Theorem proved : statement.
Proof. cbv delta [statement]; intros; rewrite (Derive_n_ext _ (fun t => (1 - t) ^ Z.to_nat m)) by (intro; apply natural_power; lia); rewrite natural_power by lia; apply is_derive_unique; auto_derive; [ exact I | rewrite INR_IZR_INZ, Z2Nat.id by lia; replace (pred (Z.to_nat m)) with (Z.to_nat (m - 1)) by lia; replace (1 + - x) with (1 - x) by ring; ring ]. Qed.
Theorem met : instance.
Proof. cbv delta [instance]; exists 3%Z, 0; refine (conj _ (conj _ (conj _ (conj _ _)))); [ lia | lra | apply filter_forall; intro; left; lia | apply ex_derive_ext with (fun t => (1 - t) ^ 3); [ intro; reflexivity | auto_derive; exact I ] | left; lia ]. Qed.
End power_rate_slip_corrected.

Module power_product.
Import Bezier.Part_Powers.power_product.
Theorem proved : statement.
Proof. cbv delta [statement]; intros; rewrite !natural_power by lia; rewrite Z2Nat.inj_add, pow_add, Rpow_mult_distr by lia; ring. Qed.
Theorem met : instance.
Proof. cbv delta [instance]; exists 0%Z, 3%Z, 1, 1; repeat split; (lia || (left; lia)). Qed.
End power_product.

Module power_ends.
Import Bezier.Part_Powers.power_ends.
Theorem proved : statement.
Proof. cbv beta delta [statement B]; intros m x M; intros; rewrite !basis_bernstein by lia; rewrite !natural_power by lia; rewrite Z.sub_0_r, Z.sub_diag; assert (F : forall n, falling (INR n) n = 1) by (let n := fresh in intro n; induction n as [|n IH]; [ reflexivity | pose proof (not_zero n); apply Rmult_eq_reg_r with (INR (S n)); [ rewrite S_INR at 1; rewrite lowered, IH, S_INR; ring | assumption ] ]); assert (B0 : binom (IZR m) 0 = 1) by reflexivity; assert (B1 : binom (IZR m) m = 1) by (unfold binom; destruct (Z.leb_spec 0 m); [ | lia ]; transitivity (falling (INR (Z.to_nat m)) (Z.to_nat m)); [ | apply F ]; f_equal; rewrite INR_IZR_INZ, Z2Nat.id by lia; reflexivity); rewrite B0, B1; cbn [Z.to_nat pow]; split; ring. Qed.
Theorem met : instance.
Proof. cbv delta [instance]; exists 3%Z, 0; repeat split; (lra || lia || (left; lia)). Qed.
End power_ends.

Module power_binomial.
Import Bezier.Part_Powers.power_binomial.
Theorem proved : statement.
Proof. cbv delta [statement]; intros m u v M _ _ _; assert (S : forall n c, pw u v n (fun _ => c) = c * (u + v) ^ n) by (let n := fresh in intro n; induction n as [|n IH]; intro c; cbn [pw pow]; [ ring | rewrite IH; ring ]); rewrite natural_power by lia; transitivity (sum 0 m (fun i => basis u v [1] i m * 1)); [ rewrite curve_bernstein; apply sum_ext; intros; ring | rewrite curve1 by lia; rewrite (pw_ext _ _ _ _ (fun _ => 1)) by (intro; unfold seed3; ring); rewrite S; ring ]. Qed.
Theorem met : instance.
Proof. cbv delta [instance]; exists 3%Z, 1, 1; repeat split; intros; (lia || (left; lia)). Qed.
End power_binomial.
