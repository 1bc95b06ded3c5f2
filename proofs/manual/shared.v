(* Tactics that several scripts use: nobody has to read them. `torse prove` defines each in front of the scripts that
   use it. *)

Ltac end_values :=
  fun m known Q k mu nu => let E := fresh in assert (E : m Q k mu nu = _) by exact (known Q k mu nu
    ltac:(lia)); rewrite E; clear E.

Ltac fourth_coefficients :=
  fun _ => (intros m n Q P mu mu1 nu nu1 p0 p1 p2 p3 r0 r1 r2 r3 s0 s1 s2 s3 Hm ? ? Hn ? ? _ _ _ _ _ _ _ _ _ _
    _ B D _ _ _ _ _ _ V W U T _ _ _ _ V' W' U' T' _ _ _ _ V'' W'' U'' T'';
    set (w := (2 * (IZR m - 2) + PI * (1 + nu)) / (2 * (IZR n - 2) + PI * (1 + mu1)));
    pose (L := fun x y z v : R => b3_true mu1 n nu1 * ((8 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^
          2 * (1 + 2 * mu1 - nu1)) * (w * (x - y)) + a2 m nu * (x - 2 * y + z) + 2 * PI ^ 2 * nu * (x - y) -
        PI ^ 2 * (1 - mu) * (y - z)) / a1 mu1 n nu1 - (3 * c1 mu1 n + 6 * (IZR n - 2) * PI ^ 2 * (1 + 4 * mu1
          - nu1) - PI ^ 3 * (1 + mu1)) * (w * (x - y)) + 4 * (IZR m - 2) * (IZR m - 3) * (2 * (IZR m - 4) + 3
        * PI * (1 + nu)) * (x - 3 * y + 3 * z - v) - 6 * (IZR m - 2) * PI ^ 2 * ((1 - mu) * (y - 2 * z + v) -
        2 * nu * (x - 2 * y + z)) - PI ^ 3 * (1 + nu) * (x - y));
    let formed V W U T f x g d := rewrite (slope_of_line f g x d);
    [ | let t := fresh in intro t; pose proof (second_joined_alone _ _ n m mu1 nu1 mu nu ltac:(lia) ltac:(lia)
        (V t) (W t) D) as E; pose proof (third_joined _ _ n m mu1 nu1 mu nu ltac:(lia) ltac:(lia) (V t) (U t))
      as G; pose proof (fourth_joined _ _ n m mu1 nu1 mu nu ltac:(lia) ltac:(lia) (V t) (T t)) as J;
      cbv zeta in J; updated_in E; updated_in G; updated_in J; updated;
      change (4 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 - nu1)) with (a1 mu1 n nu1) in G;
      rewrite E in G, J; match type of G with ?b * (?p - ?q) = ?r => assert (K : p - q = r / b) by (rewrite <-
        G; field; exact B); rewrite K in J; clear K end; unfold b1; rewrite J; unfold L, b3_true, c1, a2;
      fold w; field; exact B | intro; unfold L; field; exact B ] in unfold b3, a3, b4_true; lists;
    match goal with |- context [Derive_n ?f 1 (Q (m - 1)%Z)] => formed V W U T f (Q (m - 1)%Z) (fun t => L (Q
        m) t (Q (m - 2)%Z) (Q (m - 3)%Z)) (L 0 1 0 0) end;
    match goal with |- context [Derive_n ?f 1 (Q (m - 2)%Z)] => formed V' W' U' T' f (Q (m - 2)%Z) (fun t => L
      (Q m) (Q (m - 1)%Z) t (Q (m - 3)%Z)) (L 0 0 1 0) end;
    match goal with |- context [Derive_n ?f 1 (Q (m - 3)%Z)] => formed V'' W'' U'' T'' f (Q (m - 3)%Z) (fun t
      => L (Q m) (Q (m - 1)%Z) (Q (m - 2)%Z) t) (L 0 0 0 1) end; unfold L, a3_true;
    change (a m mu1 n nu) with w; replace (8 * (IZR n - 2) * (IZR n - 3 + PI * (1 + mu1)) + PI ^ 2 * (1 + 2 *
        mu1 - nu1)) with (2 * a1 mu1 n nu1 - PI ^ 2 * (1 - 2 * mu1 - nu1)) by (unfold a1; ring); field;
    exact B).

Ltac fourth_point :=
  fun P l mu nu Q m w => match goal with |- P 3%Z = Q m + 1 / ?b * ?t => let B := fresh in assert (B : b <> 0)
  by assumption; apply (Rmult_eq_reg_l b); [ transitivity (b * Q m + t);
    [ match goal with E : P 0%Z = _, V : P 1%Z = _, W : P 2%Z = _, G : _ - (1 + mu) * (PI / 2) ^ 3 * (P 1%Z -
        P 0%Z) = ?r |- _ => transitivity (b * Q m + (8 * r - 6 * (IZR l - 2) * PI ^ 2 * (1 - nu - 2 * mu) * (P
            2%Z - Q m - 2 * (P 1%Z - Q m)) + (1 + mu) * PI ^ 3 * (P 1%Z - Q m) + 3 * b * (P 2%Z - Q m - (P 1%Z
              - Q m)))); [ rewrite <- G, E; unfold b1; field | rewrite V, W;
        unfold b1, b2_true, b3_true, b5_true;
        change (4 * (IZR l - 2) * (IZR l - 3) * (2 * (IZR l - 4) + 3 * PI * (1 + mu))) with (c1 mu l);
        generalize dependent w; generalize dependent (a1 mu l nu); generalize dependent (c1 mu l); unfold a2;
        intros; field; assumption ] end | field; repeat split; assumption ] | exact B ] end.

Ltac halves :=
  fun a t => (let is x v := (try replace (exp x) with v by (rewrite <- exp_plus; f_equal;
        field)) in is ((a - t) / 2) (exp (a / 2) * exp (- (t / 2)));
    is (- ((a - t) / 2)) (exp (- (a / 2)) * exp (t / 2)); is a (exp (a / 2) * exp (a / 2));
    is (- a) (exp (- (a / 2)) * exp (- (a / 2))); is t (exp (t / 2) * exp (t / 2));
    is (- t) (exp (- (t / 2)) * exp (- (t / 2))); pose proof (exp_inverse (a / 2));
    pose proof (exp_inverse (t / 2)); generalize dependent (exp (a / 2));
    generalize dependent (exp (- (a / 2))); generalize dependent (exp (t / 2));
    generalize dependent (exp (- (t / 2))); intros; divisors; parts;
    match goal with E : ?e * ?m = 1, F : ?x * ?y = 1 |- _ => lazymatch e with x => fail | _ => idtac end;
    field_simplify_eq; [ring [E F] | nonzero] end).

Ltac joined_planes :=
  fun _ => (exists (fun _ => 0), (fun i => nth (Z.to_nat i) [- 20; - 10; 10;
        20] 0), (fun i => nth (Z.to_nat i) [10; 20; 20;
        10] 0), (fun _ => 400), (fun _ => 0), (fun i => nth (Z.to_nat i) [20; 30; 30 + 5 * PI;
        0] 0), (fun i => nth (Z.to_nat i) [10; 0; - 20 - 5 * PI; 0] 0), (fun _ => 400); lists; conjuncts;
    parts; ends_of_sums; compute_goal; try reflexivity; field).

Ltac line_at :=
  fun E E_ z => (cbv beta delta [foot length2];
    let a := fresh "directions" in let b := fresh "moments" in let A := fresh in let B := fresh in let
    simplified := (cbv beta delta [direction moment normal E E_ g E1_0 E1_1 E1_2 E1_3 E2_0 E2_1];
      etransitivity; [ repeat first [ rewrite vector_start_value by reflexivity
          | rewrite vector_end_value by reflexivity | rewrite vector_start_rate by reflexivity
          | rewrite vector_end_rate by reflexivity ];
        match goal with |- context [1 + PI / 2 * (1 + ?m)] => set (1 + PI / 2 * (1 + m)) end; lists;
        repeat (refine (f_equal2 (@cons _) _ _); [ ring_simplify; reflexivity |]); reflexivity
        | reflexivity ]) in pose (a := fun x y => direction (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR
          z))); pose (b := fun x y => moment (E x y z) (vDerive 4 (fun t => E_ x y t) 1 (IZR z)));
    change (direction (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (a x y);
    change (moment (E ?x ?y z) (vDerive 4 (fun t => E_ ?x ?y t) 1 (IZR z))) with (b x y);
    eassert (A : a = _) by (subst a; arguments; simplified);
    eassert (B : b = _) by (subst b; arguments; simplified); rewrite A, ?B; clear A B a b; cbv beta).

Ltac lines :=
  fun _ => (compute_goal; intros; repeat match goal with L : locally _ _ |- _ => apply locally_singleton in L;
    cbv beta in L end; conjuncts; parts; derivatives; roots; equal).

Ltac of_exponentials :=
  fun powers => (pose proof ln_lt_2; conjuncts; lazymatch goal with |- locally _ _ => apply filter_forall;
    let y := fresh in intro y; pose proof (exp_pos y); pose proof (exp_pos (- y)); lra
    | |- forall _, _ => intros; powers tt; numeric
    | |- _ => first [lia | powers tt; first [numeric | lra]] end).

Ltac one_curve :=
  fun F F_ E E_ => (first [ change F with E; change F_ with E_ | change F with (fun x y => E y x);
      change F_ with (fun x y => E_ y x) ]; cbv beta).

Ltac powers_of_two :=
  fun _ => (let E := fresh in assert (E : exp (ln 2) = 2) by (apply exp_ln; lra);
    let is v x y := (replace (exp x) with v by (symmetry; transitivity (exp y);
        [f_equal; field | rewrite ?exp_Ropp, ?exp_plus, ?exp_0, ?E;
          field])) in repeat match goal with |- context [exp ?x] => first [is 1 x 0 | is 2 x (ln 2)
      | is (/ 2) x (- ln 2) | is 4 x (ln 2 + ln 2) | is (/ 4) x (- (ln 2 + ln 2))
      | is 16 x (ln 2 + ln 2 + (ln 2 + ln 2)) | is (/ 16) x (- (ln 2 + ln 2 + (ln 2 + ln 2)))] end; clear E).

Ltac rows_added :=
  fun F M => assert (forall mu nu, F mu nu M = fun z => vadd (vadd (vadd (vscale (f z mu nu 0%Z 3%Z) (row M
            1)) (vscale (f z mu nu 1%Z 3%Z) (row M 2))) (vscale (f z mu nu 2%Z 3%Z) (row M 3))) (vscale (f z
        mu nu 3%Z 3%Z) (row M 4))) by (intros; apply FunctionalExtensionality.functional_extensionality;
    intro; cbv beta delta [F M]; written_out; parts; ring).

Ltac second_point :=
  fun P l mu => match goal with E : P 0%Z = _, F : _ * (P 1%Z - P 0%Z) = _ |- _ => apply (Rmult_eq_reg_l (IZR
      l - 2 + PI / 2 * (1 + mu))); [ transitivity ((IZR l - 2 + PI / 2 * (1 + mu)) * (P 1%Z - P 0%Z) + (IZR l
        - 2 + PI / 2 * (1 + mu)) * P 0%Z); [ ring | rewrite F, E; field; nonzero ] | nonzero ] end.

Ltac third_coefficient :=
  fun _ => (intros m n Q P mu mu1 nu nu1 p0 p1 p2 ? ? ? ? ? ? _ _ _ _ _ _ _ _ _ D _ _ _ _ V W U;
    unfold a3_true; lists; match goal with |- Derive_n ?f 1 ?x = ?d => apply (slope_of_line f (fun t => d * t
        - d * Q (m - 1)%Z)); [ intro t; pose proof (second_joined_alone _ _ n m mu1 nu1 mu nu ltac:(lia)
        ltac:(lia) (V t) (W t) D) as E; pose proof (third_joined _ _ n m mu1 nu1 mu nu ltac:(lia) ltac:(lia)
        (V t) (U t)) as G; updated_in E; updated_in G; updated; unfold a1, a2; rewrite G, E; unfold a; field;
      exact D | intro; ring ] end).

Ltac third_point :=
  fun P l mu nu => match goal with E : P 0%Z = _, V : P 1%Z = _, G : ?t = _ |- _ => match t with _ + _ * P 2%Z
  => idtac end; apply (Rmult_eq_reg_l (4 * (IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + PI ^ 2 * (1 - nu)));
  [ transitivity (4 * t - 4 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu)) + 2 * mu * (PI / 2) ^ 2) * P 0%Z + 4
      * (2 * ((IZR l - 2) * (IZR l - 3 + PI * (1 + mu))) + (2 * mu + 1 - nu) * (PI / 2) ^ 2) * P 1%Z);
    [ field | rewrite G, V, E; field; nonzero ] | nonzero ] end.
