(* Statements of gbt-developable, Section 3 4. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition g (x : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)); 1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k.
Definition H (Q : Z -> R) (k : Z) (mu : R) (nu : R) (x : R) : R :=
  sum 0%Z k (fun i => g x mu nu i k * Q i).
Definition HT (T : Z -> list R) (k : Z) (mu : R) (nu : R) (x : R) : list R :=
  vsum 4 0%Z k (fun i => vscale (g x mu nu i k) (T i)).
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition direction (P : list R) (D_ : list R) : list R :=
  cross (normal P) (normal D_).
Definition moment (P : list R) (D_ : list R) : list R :=
  vsub (vscale (entry D_ 4) (normal P)) (vscale (entry P 4) (normal D_)).
Definition start (Q : Z -> R) (k : Z) (mu : R) (nu : R) : list (list R) :=
  [[Derive_n (fun t => H (update1 Q 0%Z t) k mu nu 0) 1 (Q 0%Z); Derive_n (fun t => H (update1 Q 1%Z t) k mu nu 0) 1 (Q 1%Z); Derive_n (fun t => H (update1 Q 2%Z t) k mu nu 0) 1 (Q 2%Z)]; [Derive_n (fun t => Derive_n (fun x => H (update1 Q 0%Z t) k mu nu x) 1 0) 1 (Q 0%Z); Derive_n (fun t => Derive_n (fun x => H (update1 Q 1%Z t) k mu nu x) 1 0) 1 (Q 1%Z); Derive_n (fun t => Derive_n (fun x => H (update1 Q 2%Z t) k mu nu x) 1 0) 1 (Q 2%Z)]; [Derive_n (fun t => Derive_n (fun x => H (update1 Q 0%Z t) k mu nu x) 2 0) 1 (Q 0%Z); Derive_n (fun t => Derive_n (fun x => H (update1 Q 1%Z t) k mu nu x) 2 0) 1 (Q 1%Z); Derive_n (fun t => Derive_n (fun x => H (update1 Q 2%Z t) k mu nu x) 2 0) 1 (Q 2%Z)]].
Definition k1 (k : Z) (mu : R) : R :=
  (IZR k - 2) * (IZR k - 3 + PI * (1 + mu)).
Definition end_ (Q : Z -> R) (k : Z) (mu : R) (nu : R) : list (list R) :=
  [[Derive_n (fun t => H (update1 Q k t) k mu nu 1) 1 (Q k); Derive_n (fun t => H (update1 Q (k - 1)%Z t) k mu nu 1) 1 (Q (k - 1)%Z); Derive_n (fun t => H (update1 Q (k - 2)%Z t) k mu nu 1) 1 (Q (k - 2)%Z)]; [Derive_n (fun t => Derive_n (fun x => H (update1 Q k t) k mu nu x) 1 1) 1 (Q k); Derive_n (fun t => Derive_n (fun x => H (update1 Q (k - 1)%Z t) k mu nu x) 1 1) 1 (Q (k - 1)%Z); Derive_n (fun t => Derive_n (fun x => H (update1 Q (k - 2)%Z t) k mu nu x) 1 1) 1 (Q (k - 2)%Z)]; [Derive_n (fun t => Derive_n (fun x => H (update1 Q k t) k mu nu x) 2 1) 1 (Q k); Derive_n (fun t => Derive_n (fun x => H (update1 Q (k - 1)%Z t) k mu nu x) 2 1) 1 (Q (k - 1)%Z); Derive_n (fun t => Derive_n (fun x => H (update1 Q (k - 2)%Z t) k mu nu x) 2 1) 1 (Q (k - 2)%Z)]].
Definition k2 (k : Z) (nu : R) : R :=
  (IZR k - 2) * (IZR k - 3 + PI * (1 + nu)).
Definition meet (A : list R) (B : list R) (C_ : list R) : list R :=
  vdiv [det [[entry A 4; entry A 2; entry A 3]; [entry B 4; entry B 2; entry B 3]; [entry C_ 4; entry C_ 2; entry C_ 3]]; det [[entry A 1; entry A 4; entry A 3]; [entry B 1; entry B 4; entry B 3]; [entry C_ 1; entry C_ 4; entry C_ 3]]; det [[entry A 1; entry A 2; entry A 4]; [entry B 1; entry B 2; entry B 4]; [entry C_ 1; entry C_ 2; entry C_ 4]]] (det [normal A; normal B; normal C_]).
End Definitions.
Import Definitions.

Module eq_3_11_a.
(* gbt-developable/eq-3.11.a, Sect. 3.4, eq. (3.11), first line
   printed: H(0, μ, ν) = Q_0
   stated: H(0) == Q[0] *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 0 <= k)%Z ->
  H Q k mu nu 0 = Q 0%Z.
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= 0 <= k)%Z.
End eq_3_11_a.

Module eq_3_11_b.
(* gbt-developable/eq-3.11.b, Sect. 3.4, eq. (3.11), second line
   printed: H'(0, μ, ν) = 1/2 (2(k − 2) + π(1 + μ)) (Q_1 − Q_0)
   stated: H'(0) == 1/2*(2*(k - 2) + pi*(1 + mu))*(Q[1] - Q[0]) *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 1 <= k)%Z ->
  (0 <= 0 <= k)%Z ->
  Derive_n (fun x => H Q k mu nu x) 1 0 = 1 / 2 * (2 * (IZR k - 2) + PI * (1 + mu)) * (Q 1%Z - Q 0%Z).
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= 1 <= k)%Z /\
  (0 <= 0 <= k)%Z.
End eq_3_11_b.

Module eq_3_11_c.
(* gbt-developable/eq-3.11.c, Sect. 3.4, eq. (3.11), third line
   printed: H''(0, μ, ν) = 1/4 [4(k − 2)(k − 3 + π(1 + μ))(Q_0 − 2 Q_1 + Q_2) + 2π² μ (Q_0 − Q_1) − π² (1 − ν)(Q_1 − Q_2)]
   stated: H''(0) == 1/4*(4*(k - 2)*(k - 3 + pi*(1 + mu))*(Q[0] - 2*Q[1] + Q[2]) + 2*pi^2*mu*(Q[0] - Q[1]) - pi^2*(1 - nu)*(Q[1] - Q[2])) *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 0 <= k)%Z ->
  (0 <= 1 <= k)%Z ->
  (0 <= 2 <= k)%Z ->
  Derive_n (fun x => H Q k mu nu x) 2 0 = 1 / 4 * (4 * (IZR k - 2) * (IZR k - 3 + PI * (1 + mu)) * (Q 0%Z - 2 * Q 1%Z + Q 2%Z) + 2 * PI ^ 2 * mu * (Q 0%Z - Q 1%Z) - PI ^ 2 * (1 - nu) * (Q 1%Z - Q 2%Z)).
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= 0 <= k)%Z /\
  (0 <= 1 <= k)%Z /\
  (0 <= 2 <= k)%Z.
End eq_3_11_c.

Module eq_3_12_a.
(* gbt-developable/eq-3.12.a, Sect. 3.4, eq. (3.12), first line
   printed: H(1, μ, ν) = Q_k
   stated: H(1) == Q[k] *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= k <= k)%Z ->
  H Q k mu nu 1 = Q k.
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= k <= k)%Z.
End eq_3_12_a.

Module eq_3_12_b.
(* gbt-developable/eq-3.12.b, Sect. 3.4, eq. (3.12), second line
   printed: H'(1, μ, ν) = 1/2 (2(k − 2) + π(1 + ν)) (Q_k − Q_{k−1})
   stated: H'(1) == 1/2*(2*(k - 2) + pi*(1 + nu))*(Q[k] - Q[k-1]) *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= k <= k)%Z ->
  (0 <= k - 1 <= k)%Z ->
  Derive_n (fun x => H Q k mu nu x) 1 1 = 1 / 2 * (2 * (IZR k - 2) + PI * (1 + nu)) * (Q k - Q (k - 1)%Z).
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= k <= k)%Z /\
  (0 <= k - 1 <= k)%Z.
End eq_3_12_b.

Module eq_3_12_c.
(* gbt-developable/eq-3.12.c, Sect. 3.4, eq. (3.12), third line
   printed: H''(1, μ, ν) = 1/4 [4(k − 2)(k − 3 + π(1 + ν))(Q_{k−2} − 2 Q_{k−1} + Q_k) + π² (1 − μ)(Q_{k−2} − Q_{k−1}) − 2π² ν (Q_{k−1} − Q_k)]
   stated: H''(1) == 1/4*(4*(k - 2)*(k - 3 + pi*(1 + nu))*(Q[k-2] - 2*Q[k-1] + Q[k]) + pi^2*(1 - mu)*(Q[k-2] - Q[k-1]) - 2*pi^2*nu*(Q[k-1] - Q[k])) *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= k - 2 <= k)%Z ->
  (0 <= k - 1 <= k)%Z ->
  (0 <= k <= k)%Z ->
  Derive_n (fun x => H Q k mu nu x) 2 1 = 1 / 4 * (4 * (IZR k - 2) * (IZR k - 3 + PI * (1 + nu)) * (Q (k - 2)%Z - 2 * Q (k - 1)%Z + Q k) + PI ^ 2 * (1 - mu) * (Q (k - 2)%Z - Q (k - 1)%Z) - 2 * PI ^ 2 * nu * (Q (k - 1)%Z - Q k)).
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= k - 2 <= k)%Z /\
  (0 <= k - 1 <= k)%Z /\
  (0 <= k <= k)%Z.
End eq_3_12_c.

Module sec_3_4_tangent_ends.
(* gbt-developable/sec-3.4.tangent-ends, Sect. 3.4, paragraph after (3.12)
   printed: at x = 0 and x = 1, these two planes are tangent to the defined developable GBT-Bézier surface with its generators J(x; μ, ν)
   read as: Both tangent vectors of (3.7) at x = 0 lie in the plane Q_0, those at x = 1 in Q_k, for every x1. h, d, dd stand for H(0), H'(0), H''(0), and e, f, ff for H(1), H'(1), H''(1); of them the end planes are put in, the others are any planes.
   stated: h == T[0] and dot(normal(T[0]), J0(0)) == T[0][4] and dot(normal(T[0]), direction(h, d)) == 0 and dot(normal(h), J0'(0)) == 0 and e == T[k] and dot(normal(T[k]), J1(0)) == T[k][4] and dot(normal(T[k]), direction(e, f)) == 0 and dot(normal(e), J1'(0)) == 0 *)
Definition P (d : list R) (dd : list R) (h : list R) (t : R) : list R :=
  vadd (vadd h (vscale t d)) (vscale (t ^ 2 / 2) dd).
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition direction (P : list R) (D_ : list R) : list R :=
  cross (normal P) (normal D_).
Definition moment (P : list R) (D_ : list R) : list R :=
  vsub (vscale (entry D_ 4) (normal P)) (vscale (entry P 4) (normal D_)).
Definition foot (P : list R) (D_ : list R) : list R :=
  vdiv (cross (direction P D_) (moment P D_)) (dot (direction P D_) (direction P D_)).
Definition J0 (d : list R) (dd : list R) (h : list R) (x1 : R) (t : R) : list R :=
  vadd (vscale x1 (direction (P d dd h t) (vDerive 4 (fun t => P d dd h t) 1 t))) (foot (P d dd h t) (vDerive 4 (fun t => P d dd h t) 1 t)).
Definition O_ (e : list R) (f : list R) (ff : list R) (t : R) : list R :=
  vadd (vadd e (vscale t f)) (vscale (t ^ 2 / 2) ff).
Definition J1 (e : list R) (f : list R) (ff : list R) (x1 : R) (t : R) : list R :=
  vadd (vscale x1 (direction (O_ e f ff t) (vDerive 4 (fun t => O_ e f ff t) 1 t))) (foot (O_ e f ff t) (vDerive 4 (fun t => O_ e f ff t) 1 t)).
Definition statement : Prop :=
forall (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (d'1 d'2 d'3 d'4 : R) (dd'1 dd'2 dd'3 dd'4 : R) (e'1 e'2 e'3 e'4 : R) (f'1 f'2 f'3 f'4 : R) (ff'1 ff'2 ff'3 ff'4 : R) (h'1 h'2 h'3 h'4 : R) (mu : R) (nu : R) (x1 : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  let d := [d'1; d'2; d'3; d'4] in
  let dd := [dd'1; dd'2; dd'3; dd'4] in
  let e := [e'1; e'2; e'3; e'4] in
  let f := [f'1; f'2; f'3; f'4] in
  let ff := [ff'1; ff'2; ff'3; ff'4] in
  let h := [h'1; h'2; h'3; h'4] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  h = HT T k mu nu 0 ->
  e = HT T k mu nu 1 ->
  (0 <= 0 <= k)%Z ->
  dot (direction (P d dd h 0) (vDerive 4 (fun t => P d dd h t) 1 0)) (direction (P d dd h 0) (vDerive 4 (fun t => P d dd h t) 1 0)) <> 0 ->
  locally 0 (fun t => dot (direction (P d dd h t) (vDerive 4 (fun t => P d dd h t) 1 t)) (direction (P d dd h t) (vDerive 4 (fun t => P d dd h t) 1 t)) <> 0) ->
  (0 <= k <= k)%Z ->
  dot (direction (O_ e f ff 0) (vDerive 4 (fun t => O_ e f ff t) 1 0)) (direction (O_ e f ff 0) (vDerive 4 (fun t => O_ e f ff t) 1 0)) <> 0 ->
  locally 0 (fun t => dot (direction (O_ e f ff t) (vDerive 4 (fun t => O_ e f ff t) 1 t)) (direction (O_ e f ff t) (vDerive 4 (fun t => O_ e f ff t) 1 t)) <> 0) ->
  entry d 1 ^ 2 * entry h 2 ^ 2 + entry d 1 ^ 2 * entry h 3 ^ 2 - 2 * entry d 1 * entry d 2 * entry h 1 * entry h 2 - 2 * entry d 1 * entry d 3 * entry h 1 * entry h 3 + entry d 2 ^ 2 * entry h 1 ^ 2 + entry d 2 ^ 2 * entry h 3 ^ 2 - 2 * entry d 2 * entry d 3 * entry h 2 * entry h 3 + entry d 3 ^ 2 * entry h 1 ^ 2 + entry d 3 ^ 2 * entry h 2 ^ 2 <> 0 ->
  entry e 1 ^ 2 * entry f 2 ^ 2 + entry e 1 ^ 2 * entry f 3 ^ 2 - 2 * entry e 1 * entry e 2 * entry f 1 * entry f 2 - 2 * entry e 1 * entry e 3 * entry f 1 * entry f 3 + entry e 2 ^ 2 * entry f 1 ^ 2 + entry e 2 ^ 2 * entry f 3 ^ 2 - 2 * entry e 2 * entry e 3 * entry f 2 * entry f 3 + entry e 3 ^ 2 * entry f 1 ^ 2 + entry e 3 ^ 2 * entry f 2 ^ 2 <> 0 ->
  h = T 0%Z /\ dot (normal (T 0%Z)) (J0 d dd h x1 0) = entry (T 0%Z) 4 /\ dot (normal (T 0%Z)) (direction h d) = 0 /\ dot (normal h) (vDerive 3 (fun t => J0 d dd h x1 t) 1 0) = 0 /\ e = T k /\ dot (normal (T k)) (J1 e f ff x1 0) = entry (T k) 4 /\ dot (normal (T k)) (direction e f) = 0 /\ dot (normal e) (vDerive 3 (fun t => J1 e f ff x1 t) 1 0) = 0.
Definition instance : Prop :=
exists (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (d'1 d'2 d'3 d'4 : R) (dd'1 dd'2 dd'3 dd'4 : R) (e'1 e'2 e'3 e'4 : R) (f'1 f'2 f'3 f'4 : R) (ff'1 ff'2 ff'3 ff'4 : R) (h'1 h'2 h'3 h'4 : R) (mu : R) (nu : R) (x1 : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  let d := [d'1; d'2; d'3; d'4] in
  let dd := [dd'1; dd'2; dd'3; dd'4] in
  let e := [e'1; e'2; e'3; e'4] in
  let f := [f'1; f'2; f'3; f'4] in
  let ff := [ff'1; ff'2; ff'3; ff'4] in
  let h := [h'1; h'2; h'3; h'4] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  h = HT T k mu nu 0 /\
  e = HT T k mu nu 1 /\
  (0 <= 0 <= k)%Z /\
  dot (direction (P d dd h 0) (vDerive 4 (fun t => P d dd h t) 1 0)) (direction (P d dd h 0) (vDerive 4 (fun t => P d dd h t) 1 0)) <> 0 /\
  locally 0 (fun t => dot (direction (P d dd h t) (vDerive 4 (fun t => P d dd h t) 1 t)) (direction (P d dd h t) (vDerive 4 (fun t => P d dd h t) 1 t)) <> 0) /\
  (0 <= k <= k)%Z /\
  dot (direction (O_ e f ff 0) (vDerive 4 (fun t => O_ e f ff t) 1 0)) (direction (O_ e f ff 0) (vDerive 4 (fun t => O_ e f ff t) 1 0)) <> 0 /\
  locally 0 (fun t => dot (direction (O_ e f ff t) (vDerive 4 (fun t => O_ e f ff t) 1 t)) (direction (O_ e f ff t) (vDerive 4 (fun t => O_ e f ff t) 1 t)) <> 0) /\
  entry d 1 ^ 2 * entry h 2 ^ 2 + entry d 1 ^ 2 * entry h 3 ^ 2 - 2 * entry d 1 * entry d 2 * entry h 1 * entry h 2 - 2 * entry d 1 * entry d 3 * entry h 1 * entry h 3 + entry d 2 ^ 2 * entry h 1 ^ 2 + entry d 2 ^ 2 * entry h 3 ^ 2 - 2 * entry d 2 * entry d 3 * entry h 2 * entry h 3 + entry d 3 ^ 2 * entry h 1 ^ 2 + entry d 3 ^ 2 * entry h 2 ^ 2 <> 0 /\
  entry e 1 ^ 2 * entry f 2 ^ 2 + entry e 1 ^ 2 * entry f 3 ^ 2 - 2 * entry e 1 * entry e 2 * entry f 1 * entry f 2 - 2 * entry e 1 * entry e 3 * entry f 1 * entry f 3 + entry e 2 ^ 2 * entry f 1 ^ 2 + entry e 2 ^ 2 * entry f 3 ^ 2 - 2 * entry e 2 * entry e 3 * entry f 2 * entry f 3 + entry e 3 ^ 2 * entry f 1 ^ 2 + entry e 3 ^ 2 * entry f 2 ^ 2 <> 0.
End sec_3_4_tangent_ends.

Module eq_3_13.
(* gbt-developable/eq-3.13, Sect. 3.4, eq. (3.13)
   printed: t_0 . W = s_0;  (k − 2 + π/2 (1 + μ)) (t_1 − t_0) . W = (k − 2 + π/2 (1 + μ)) (s_1 − s_0),  where t_0 = (p_0, q_0, r_0), t_1 = (p_1, q_1, r_1), W = (X, Y, Z)
   stated: dot(normal(HT(0)), W) - HT(0)[4] == dot(normal(T[0]), W) - T[0][4] and dot(normal(HT'(0)), W) - HT'(0)[4] == (k - 2 + pi/2*(1 + mu))*dot(normal(T[1]) - normal(T[0]), W) - (k - 2 + pi/2*(1 + mu))*(T[1][4] - T[0][4]) *)
Definition W (X : R) (Y : R) (Z_ : R) : list R :=
  [X; Y; Z_].
Definition statement : Prop :=
forall (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (X : R) (Y : R) (Z_ : R) (mu : R) (nu : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 0 <= k)%Z ->
  (0 <= 1 <= k)%Z ->
  dot (normal (HT T k mu nu 0)) (W X Y Z_) - entry (HT T k mu nu 0) 4 = dot (normal (T 0%Z)) (W X Y Z_) - entry (T 0%Z) 4 /\ dot (normal (vDerive 4 (fun x => HT T k mu nu x) 1 0)) (W X Y Z_) - entry (vDerive 4 (fun x => HT T k mu nu x) 1 0) 4 = (IZR k - 2 + PI / 2 * (1 + mu)) * dot (vsub (normal (T 1%Z)) (normal (T 0%Z))) (W X Y Z_) - (IZR k - 2 + PI / 2 * (1 + mu)) * (entry (T 1%Z) 4 - entry (T 0%Z) 4).
Definition instance : Prop :=
exists (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (X : R) (Y : R) (Z_ : R) (mu : R) (nu : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= 0 <= k)%Z /\
  (0 <= 1 <= k)%Z.
End eq_3_13.

Module sec_3_4_J0.
(* gbt-developable/sec-3.4.J0, Sect. 3.4, after (3.13)
   printed: from interpretation of 1st two planes of (3.13), the control plane Q_1 can be attained. Thus J(0; μ, ν), the starting generator is the intersection of control plane Q_0 and control plane Q_1.
   stated: direction(T[0], T[1]) == direction(HT(0), HT'(0))/(k - 2 + pi/2*(1 + mu)) and moment(T[0], T[1]) == moment(HT(0), HT'(0))/(k - 2 + pi/2*(1 + mu)) *)
Definition statement : Prop :=
forall (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 0 <= k)%Z ->
  (0 <= 1 <= k)%Z ->
  IZR k - 2 + PI / 2 * (1 + mu) <> 0 ->
  2 * (IZR k - 2) + PI * (1 + mu) <> 0 ->
  direction (T 0%Z) (T 1%Z) = vdiv (direction (HT T k mu nu 0) (vDerive 4 (fun x => HT T k mu nu x) 1 0)) (IZR k - 2 + PI / 2 * (1 + mu)) /\ moment (T 0%Z) (T 1%Z) = vdiv (moment (HT T k mu nu 0) (vDerive 4 (fun x => HT T k mu nu x) 1 0)) (IZR k - 2 + PI / 2 * (1 + mu)).
Definition instance : Prop :=
exists (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= 0 <= k)%Z /\
  (0 <= 1 <= k)%Z /\
  IZR k - 2 + PI / 2 * (1 + mu) <> 0 /\
  2 * (IZR k - 2) + PI * (1 + mu) <> 0.
End sec_3_4_J0.

Module sec_3_4_dual.
(* gbt-developable/sec-3.4.dual, Sect. 3.4, after (3.13)
   printed: J(0; μ, ν) is tangent to the GBT-Bézier curve described by the control points Q_i (i = 0, 1, ..., k) as J(0; μ, ν) is dual to the line connecting the points Q_0 and Q_1
   stated: Q[1] - Q[0] == H'(0)/(k - 2 + pi/2*(1 + mu)) *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 1 <= k)%Z ->
  (0 <= 0 <= k)%Z ->
  IZR k - 2 + PI / 2 * (1 + mu) <> 0 ->
  2 * (IZR k - 2) + PI * (1 + mu) <> 0 ->
  Q 1%Z - Q 0%Z = Derive_n (fun x => H Q k mu nu x) 1 0 / (IZR k - 2 + PI / 2 * (1 + mu)).
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= 1 <= k)%Z /\
  (0 <= 0 <= k)%Z /\
  IZR k - 2 + PI / 2 * (1 + mu) <> 0 /\
  2 * (IZR k - 2) + PI * (1 + mu) <> 0.
End sec_3_4_dual.

Module sec_3_4_J1.
(* gbt-developable/sec-3.4.J1, Sect. 3.4, after (3.13)
   printed: at x = 1 the last two control planes, control plane Q_{k−1} and control plane Q_k, represent the ending generator of a developable GBT-Bézier surface denoted as J(1; μ, ν)
   stated: direction(T[k], T[k-1]) == -direction(HT(1), HT'(1))/(k - 2 + pi/2*(1 + nu)) and moment(T[k], T[k-1]) == -moment(HT(1), HT'(1))/(k - 2 + pi/2*(1 + nu)) *)
Definition statement : Prop :=
forall (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= k <= k)%Z ->
  (0 <= k - 1 <= k)%Z ->
  IZR k - 2 + PI / 2 * (1 + nu) <> 0 ->
  2 * (IZR k - 2) + PI * (1 + nu) <> 0 ->
  direction (T k) (T (k - 1)%Z) = vdiv (vopp (direction (HT T k mu nu 1) (vDerive 4 (fun x => HT T k mu nu x) 1 1))) (IZR k - 2 + PI / 2 * (1 + nu)) /\ moment (T k) (T (k - 1)%Z) = vdiv (vopp (moment (HT T k mu nu 1) (vDerive 4 (fun x => HT T k mu nu x) 1 1))) (IZR k - 2 + PI / 2 * (1 + nu)).
Definition instance : Prop :=
exists (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= k <= k)%Z /\
  (0 <= k - 1 <= k)%Z /\
  IZR k - 2 + PI / 2 * (1 + nu) <> 0 /\
  2 * (IZR k - 2) + PI * (1 + nu) <> 0.
End sec_3_4_J1.

Module sec_3_4_m0_r1.
(* gbt-developable/sec-3.4.m0-r1, Sect. 3.4, first matrix, row 1
   printed: Q_0 = [1, 0, 0] . (H(0), H'(0), H''(0))
   stated: Q[0] == 1*H(0) + 0*H'(0) + 0*H''(0) *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 0 <= k)%Z ->
  Q 0%Z = 1 * H Q k mu nu 0 + 0 * Derive_n (fun x => H Q k mu nu x) 1 0 + 0 * Derive_n (fun x => H Q k mu nu x) 2 0.
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= 0 <= k)%Z.
End sec_3_4_m0_r1.

Module sec_3_4_m0_r2.
(* gbt-developable/sec-3.4.m0-r2, Sect. 3.4, first matrix, row 2
   printed: Q_1 = [1, 2/(2(k−2) + π(1+μ)), 0] . (H(0), H'(0), H''(0))
   stated: Q[1] == 1*H(0) + 2/(2*(k - 2) + pi*(1 + mu))*H'(0) + 0*H''(0) *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 1 <= k)%Z ->
  2 * (IZR k - 2) + PI * (1 + mu) <> 0 ->
  Q 1%Z = 1 * H Q k mu nu 0 + 2 / (2 * (IZR k - 2) + PI * (1 + mu)) * Derive_n (fun x => H Q k mu nu x) 1 0 + 0 * Derive_n (fun x => H Q k mu nu x) 2 0.
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= 1 <= k)%Z /\
  2 * (IZR k - 2) + PI * (1 + mu) <> 0.
End sec_3_4_m0_r2.

Module sec_3_4_m0_r3_c1.
(* gbt-developable/sec-3.4.m0-r3.c1, Sect. 3.4, first matrix, row 3, entry 1
   printed: 1
   stated: inverse(start)[3,1] == 1 *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 0 <= k)%Z ->
  (0 <= 1 <= k)%Z ->
  (0 <= 2 <= k)%Z ->
  det (start Q k mu nu) <> 0 ->
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + mu) + PI ^ 2 * (1 - nu) <> 0 ->
  2 * (IZR k - 2) + PI * (1 + mu) <> 0 ->
  entry (row (inverse (start Q k mu nu)) 3) 1 = 1.
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= 0 <= k)%Z /\
  (0 <= 1 <= k)%Z /\
  (0 <= 2 <= k)%Z /\
  det (start Q k mu nu) <> 0 /\
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + mu) + PI ^ 2 * (1 - nu) <> 0 /\
  2 * (IZR k - 2) + PI * (1 + mu) <> 0.
End sec_3_4_m0_r3_c1.

Module sec_3_4_m0_r3_c2.
(* gbt-developable/sec-3.4.m0-r3.c2, Sect. 3.4, first matrix, row 3, entry 2
   printed: 2(8 k_1 + π²(1 − ν + 2μ) / ((2(k−2) + π(1+μ)) (4 k_1 − π²(1 − ν)))
   read as: Unbalanced bracket as printed; read as 2(8 k_1 + π²(1 − ν + 2μ)) over the product.
   stated: inverse(start)[3,2] == 2*(8*k1 + pi^2*(1 - nu + 2*mu))/((2*(k - 2) + pi*(1 + mu))*(4*k1 - pi^2*(1 - nu))) *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 0 <= k)%Z ->
  (0 <= 1 <= k)%Z ->
  (0 <= 2 <= k)%Z ->
  det (start Q k mu nu) <> 0 ->
  (2 * (IZR k - 2) + PI * (1 + mu)) * (4 * k1 k mu - PI ^ 2 * (1 - nu)) <> 0 ->
  entry (row (inverse (start Q k mu nu)) 3) 2 = 2 * (8 * k1 k mu + PI ^ 2 * (1 - nu + 2 * mu)) / ((2 * (IZR k - 2) + PI * (1 + mu)) * (4 * k1 k mu - PI ^ 2 * (1 - nu))).
End sec_3_4_m0_r3_c2.

Module sec_3_4_m0_r3_c2_corrected.
(* gbt-developable/sec-3.4.m0-r3.c2 (corrected), Sect. 3.4, first matrix, row 3, entry 2
   printed: 2(8 k_1 + π²(1 − ν + 2μ) / ((2(k−2) + π(1+μ)) (4 k_1 − π²(1 − ν)))
   read as: Unbalanced bracket as printed; read as 2(8 k_1 + π²(1 − ν + 2μ)) over the product.
   stated: inverse(start)[3,2] == 2*(8*k1 + pi^2*(1 - nu + 2*mu))/((2*(k - 2) + pi*(1 + mu))*(4*k1 + pi^2*(1 - nu))) *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 0 <= k)%Z ->
  (0 <= 1 <= k)%Z ->
  (0 <= 2 <= k)%Z ->
  det (start Q k mu nu) <> 0 ->
  (2 * (IZR k - 2) + PI * (1 + mu)) * (4 * k1 k mu + PI ^ 2 * (1 - nu)) <> 0 ->
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + mu) + PI ^ 2 * (1 - nu) <> 0 ->
  2 * (IZR k - 2) + PI * (1 + mu) <> 0 ->
  entry (row (inverse (start Q k mu nu)) 3) 2 = 2 * (8 * k1 k mu + PI ^ 2 * (1 - nu + 2 * mu)) / ((2 * (IZR k - 2) + PI * (1 + mu)) * (4 * k1 k mu + PI ^ 2 * (1 - nu))).
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= 0 <= k)%Z /\
  (0 <= 1 <= k)%Z /\
  (0 <= 2 <= k)%Z /\
  det (start Q k mu nu) <> 0 /\
  (2 * (IZR k - 2) + PI * (1 + mu)) * (4 * k1 k mu + PI ^ 2 * (1 - nu)) <> 0 /\
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + mu) + PI ^ 2 * (1 - nu) <> 0 /\
  2 * (IZR k - 2) + PI * (1 + mu) <> 0.
End sec_3_4_m0_r3_c2_corrected.

Module sec_3_4_m0_r3_true.
(* gbt-developable/sec-3.4.m0-r3.true, Sect. 3.4, first matrix, row 3
   printed: Q_2 from H(0), H'(0) and H''(0): the true third row of the first matrix.
   stated: Q[2] == H(0) + 2*(8*k1 + pi^2*(1 - nu + 2*mu))/((2*(k - 2) + pi*(1 + mu))*(4*k1 + pi^2*(1 - nu)))*H'(0) + 1/(k1 + 1/4*pi^2*(1 - nu))*H''(0) *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 2 <= k)%Z ->
  (2 * (IZR k - 2) + PI * (1 + mu)) * (4 * k1 k mu + PI ^ 2 * (1 - nu)) <> 0 ->
  k1 k mu + 1 / 4 * PI ^ 2 * (1 - nu) <> 0 ->
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + mu) + PI ^ 2 * (1 - nu) <> 0 ->
  2 * (IZR k - 2) + PI * (1 + mu) <> 0 ->
  Q 2%Z = H Q k mu nu 0 + 2 * (8 * k1 k mu + PI ^ 2 * (1 - nu + 2 * mu)) / ((2 * (IZR k - 2) + PI * (1 + mu)) * (4 * k1 k mu + PI ^ 2 * (1 - nu))) * Derive_n (fun x => H Q k mu nu x) 1 0 + 1 / (k1 k mu + 1 / 4 * PI ^ 2 * (1 - nu)) * Derive_n (fun x => H Q k mu nu x) 2 0.
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= 2 <= k)%Z /\
  (2 * (IZR k - 2) + PI * (1 + mu)) * (4 * k1 k mu + PI ^ 2 * (1 - nu)) <> 0 /\
  k1 k mu + 1 / 4 * PI ^ 2 * (1 - nu) <> 0 /\
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + mu) + PI ^ 2 * (1 - nu) <> 0 /\
  2 * (IZR k - 2) + PI * (1 + mu) <> 0.
End sec_3_4_m0_r3_true.

Module sec_3_4_m0_r3_c3.
(* gbt-developable/sec-3.4.m0-r3.c3, Sect. 3.4, first matrix, row 3, entry 3
   printed: 1/(k_1 − 1/4 π² (1 − ν))
   read as: The printed entry ends with one more ')' than it opens.
   stated: inverse(start)[3,3] == 1/(k1 - 1/4*pi^2*(1 - nu)) *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 0 <= k)%Z ->
  (0 <= 1 <= k)%Z ->
  (0 <= 2 <= k)%Z ->
  det (start Q k mu nu) <> 0 ->
  k1 k mu - 1 / 4 * PI ^ 2 * (1 - nu) <> 0 ->
  entry (row (inverse (start Q k mu nu)) 3) 3 = 1 / (k1 k mu - 1 / 4 * PI ^ 2 * (1 - nu)).
End sec_3_4_m0_r3_c3.

Module sec_3_4_m0_r3_c3_corrected.
(* gbt-developable/sec-3.4.m0-r3.c3 (corrected), Sect. 3.4, first matrix, row 3, entry 3
   printed: 1/(k_1 − 1/4 π² (1 − ν))
   read as: The printed entry ends with one more ')' than it opens.
   stated: inverse(start)[3,3] == 1/(k1 + 1/4*pi^2*(1 - nu)) *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 0 <= k)%Z ->
  (0 <= 1 <= k)%Z ->
  (0 <= 2 <= k)%Z ->
  det (start Q k mu nu) <> 0 ->
  k1 k mu + 1 / 4 * PI ^ 2 * (1 - nu) <> 0 ->
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + mu) + PI ^ 2 * (1 - nu) <> 0 ->
  2 * (IZR k - 2) + PI * (1 + mu) <> 0 ->
  entry (row (inverse (start Q k mu nu)) 3) 3 = 1 / (k1 k mu + 1 / 4 * PI ^ 2 * (1 - nu)).
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= 0 <= k)%Z /\
  (0 <= 1 <= k)%Z /\
  (0 <= 2 <= k)%Z /\
  det (start Q k mu nu) <> 0 /\
  k1 k mu + 1 / 4 * PI ^ 2 * (1 - nu) <> 0 /\
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + mu) + PI ^ 2 * (1 - nu) <> 0 /\
  2 * (IZR k - 2) + PI * (1 + mu) <> 0.
End sec_3_4_m0_r3_c3_corrected.

Module sec_3_4_m1_r1.
(* gbt-developable/sec-3.4.m1-r1, Sect. 3.4, second matrix, row 1
   printed: Q_k = [1, 0, 0] . (H(1), H'(1), H''(1))
   stated: Q[k] == 1*H(1) + 0*H'(1) + 0*H''(1) *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= k <= k)%Z ->
  Q k = 1 * H Q k mu nu 1 + 0 * Derive_n (fun x => H Q k mu nu x) 1 1 + 0 * Derive_n (fun x => H Q k mu nu x) 2 1.
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= k <= k)%Z.
End sec_3_4_m1_r1.

Module sec_3_4_m1_r2.
(* gbt-developable/sec-3.4.m1-r2, Sect. 3.4, second matrix, row 2
   printed: Q_{k−1} = [1, −2/(2(k−2) + π(1+ν)), 0] . (H(1), H'(1), H''(1))
   stated: Q[k-1] == 1*H(1) - 2/(2*(k - 2) + pi*(1 + nu))*H'(1) + 0*H''(1) *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= k - 1 <= k)%Z ->
  2 * (IZR k - 2) + PI * (1 + nu) <> 0 ->
  Q (k - 1)%Z = 1 * H Q k mu nu 1 - 2 / (2 * (IZR k - 2) + PI * (1 + nu)) * Derive_n (fun x => H Q k mu nu x) 1 1 + 0 * Derive_n (fun x => H Q k mu nu x) 2 1.
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= k - 1 <= k)%Z /\
  2 * (IZR k - 2) + PI * (1 + nu) <> 0.
End sec_3_4_m1_r2.

Module sec_3_4_m1_r3_c1.
(* gbt-developable/sec-3.4.m1-r3.c1, Sect. 3.4, second matrix, row 3, entry 1
   printed: 1
   stated: inverse(end)[3,1] == 1 *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= k <= k)%Z ->
  (0 <= k - 1 <= k)%Z ->
  (0 <= k - 2 <= k)%Z ->
  det (end_ Q k mu nu) <> 0 ->
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + nu) + PI ^ 2 * (1 - mu) <> 0 ->
  2 * (IZR k - 2) + PI * (1 + nu) <> 0 ->
  entry (row (inverse (end_ Q k mu nu)) 3) 1 = 1.
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= k <= k)%Z /\
  (0 <= k - 1 <= k)%Z /\
  (0 <= k - 2 <= k)%Z /\
  det (end_ Q k mu nu) <> 0 /\
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + nu) + PI ^ 2 * (1 - mu) <> 0 /\
  2 * (IZR k - 2) + PI * (1 + nu) <> 0.
End sec_3_4_m1_r3_c1.

Module sec_3_4_m1_r3_c2.
(* gbt-developable/sec-3.4.m1-r3.c2, Sect. 3.4, second matrix, row 3, entry 2
   printed: −2(8 k_2 + π²(1 − μ + 2ν) / ((2(k−2) + π(1+ν)) (4 k_2 − π²(1 − μ)))
   read as: Unbalanced bracket as printed; read as −2(8 k_2 + π²(1 − μ + 2ν)) over the product.
   stated: inverse(end)[3,2] == -2*(8*k2 + pi^2*(1 - mu + 2*nu))/((2*(k - 2) + pi*(1 + nu))*(4*k2 - pi^2*(1 - mu))) *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= k <= k)%Z ->
  (0 <= k - 1 <= k)%Z ->
  (0 <= k - 2 <= k)%Z ->
  det (end_ Q k mu nu) <> 0 ->
  (2 * (IZR k - 2) + PI * (1 + nu)) * (4 * k2 k nu - PI ^ 2 * (1 - mu)) <> 0 ->
  entry (row (inverse (end_ Q k mu nu)) 3) 2 = - 2 * (8 * k2 k nu + PI ^ 2 * (1 - mu + 2 * nu)) / ((2 * (IZR k - 2) + PI * (1 + nu)) * (4 * k2 k nu - PI ^ 2 * (1 - mu))).
End sec_3_4_m1_r3_c2.

Module sec_3_4_m1_r3_c2_corrected.
(* gbt-developable/sec-3.4.m1-r3.c2 (corrected), Sect. 3.4, second matrix, row 3, entry 2
   printed: −2(8 k_2 + π²(1 − μ + 2ν) / ((2(k−2) + π(1+ν)) (4 k_2 − π²(1 − μ)))
   read as: Unbalanced bracket as printed; read as −2(8 k_2 + π²(1 − μ + 2ν)) over the product.
   stated: inverse(end)[3,2] == -2*(8*k2 + pi^2*(1 - mu + 2*nu))/((2*(k - 2) + pi*(1 + nu))*(4*k2 + pi^2*(1 - mu))) *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= k <= k)%Z ->
  (0 <= k - 1 <= k)%Z ->
  (0 <= k - 2 <= k)%Z ->
  det (end_ Q k mu nu) <> 0 ->
  (2 * (IZR k - 2) + PI * (1 + nu)) * (4 * k2 k nu + PI ^ 2 * (1 - mu)) <> 0 ->
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + nu) + PI ^ 2 * (1 - mu) <> 0 ->
  2 * (IZR k - 2) + PI * (1 + nu) <> 0 ->
  entry (row (inverse (end_ Q k mu nu)) 3) 2 = - 2 * (8 * k2 k nu + PI ^ 2 * (1 - mu + 2 * nu)) / ((2 * (IZR k - 2) + PI * (1 + nu)) * (4 * k2 k nu + PI ^ 2 * (1 - mu))).
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= k <= k)%Z /\
  (0 <= k - 1 <= k)%Z /\
  (0 <= k - 2 <= k)%Z /\
  det (end_ Q k mu nu) <> 0 /\
  (2 * (IZR k - 2) + PI * (1 + nu)) * (4 * k2 k nu + PI ^ 2 * (1 - mu)) <> 0 /\
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + nu) + PI ^ 2 * (1 - mu) <> 0 /\
  2 * (IZR k - 2) + PI * (1 + nu) <> 0.
End sec_3_4_m1_r3_c2_corrected.

Module sec_3_4_m1_r3_true.
(* gbt-developable/sec-3.4.m1-r3.true, Sect. 3.4, second matrix, row 3
   printed: Q_{k−2} from H(1), H'(1) and H''(1): the true third row of the second matrix.
   stated: Q[k-2] == H(1) - 2*(8*k2 + pi^2*(1 - mu + 2*nu))/((2*(k - 2) + pi*(1 + nu))*(4*k2 + pi^2*(1 - mu)))*H'(1) + 1/(k2 + 1/4*pi^2*(1 - mu))*H''(1) *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= k - 2 <= k)%Z ->
  (2 * (IZR k - 2) + PI * (1 + nu)) * (4 * k2 k nu + PI ^ 2 * (1 - mu)) <> 0 ->
  k2 k nu + 1 / 4 * PI ^ 2 * (1 - mu) <> 0 ->
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + nu) + PI ^ 2 * (1 - mu) <> 0 ->
  2 * (IZR k - 2) + PI * (1 + nu) <> 0 ->
  Q (k - 2)%Z = H Q k mu nu 1 - 2 * (8 * k2 k nu + PI ^ 2 * (1 - mu + 2 * nu)) / ((2 * (IZR k - 2) + PI * (1 + nu)) * (4 * k2 k nu + PI ^ 2 * (1 - mu))) * Derive_n (fun x => H Q k mu nu x) 1 1 + 1 / (k2 k nu + 1 / 4 * PI ^ 2 * (1 - mu)) * Derive_n (fun x => H Q k mu nu x) 2 1.
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= k - 2 <= k)%Z /\
  (2 * (IZR k - 2) + PI * (1 + nu)) * (4 * k2 k nu + PI ^ 2 * (1 - mu)) <> 0 /\
  k2 k nu + 1 / 4 * PI ^ 2 * (1 - mu) <> 0 /\
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + nu) + PI ^ 2 * (1 - mu) <> 0 /\
  2 * (IZR k - 2) + PI * (1 + nu) <> 0.
End sec_3_4_m1_r3_true.

Module sec_3_4_m1_r3_c3.
(* gbt-developable/sec-3.4.m1-r3.c3, Sect. 3.4, second matrix, row 3, entry 3
   printed: 1/(k_2 + 1/4 π² (1 − μ))
   read as: The printed entry ends with one more ')' than it opens.
   stated: inverse(end)[3,3] == 1/(k2 + 1/4*pi^2*(1 - mu)) *)
Definition statement : Prop :=
forall (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= k <= k)%Z ->
  (0 <= k - 1 <= k)%Z ->
  (0 <= k - 2 <= k)%Z ->
  det (end_ Q k mu nu) <> 0 ->
  k2 k nu + 1 / 4 * PI ^ 2 * (1 - mu) <> 0 ->
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + nu) + PI ^ 2 * (1 - mu) <> 0 ->
  2 * (IZR k - 2) + PI * (1 + nu) <> 0 ->
  entry (row (inverse (end_ Q k mu nu)) 3) 3 = 1 / (k2 k nu + 1 / 4 * PI ^ 2 * (1 - mu)).
Definition instance : Prop :=
exists (k : Z) (Q : Z -> R) (mu : R) (nu : R),
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= k <= k)%Z /\
  (0 <= k - 1 <= k)%Z /\
  (0 <= k - 2 <= k)%Z /\
  det (end_ Q k mu nu) <> 0 /\
  k2 k nu + 1 / 4 * PI ^ 2 * (1 - mu) <> 0 /\
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + nu) + PI ^ 2 * (1 - mu) <> 0 /\
  2 * (IZR k - 2) + PI * (1 + nu) <> 0.
End sec_3_4_m1_r3_c3.

Module sec_3_4_S0.
(* gbt-developable/sec-3.4.S0, Sect. 3.4, last paragraph
   printed: the intersection of the control planes Q_0, Q_1, Q_2 is the characteristic point S(0) of the spine curve developable GBT-Bézier surfaces
   read as: S(0) is the common point of the three planes (3.9) at x = 0.
   stated: meet(T[0], T[1], T[2]) == meet(HT(0), HT'(0), HT''(0)) *)
Definition statement : Prop :=
forall (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 0 <= k)%Z ->
  (0 <= 1 <= k)%Z ->
  (0 <= 2 <= k)%Z ->
  det [normal (T 0%Z); normal (T 1%Z); normal (T 2%Z)] <> 0 ->
  det [normal (HT T k mu nu 0); normal (vDerive 4 (fun x => HT T k mu nu x) 1 0); normal (vDerive 4 (fun x => HT T k mu nu x) 2 0)] <> 0 ->
  entry (T 0%Z) 1 * entry (T 1%Z) 2 * entry (T 2%Z) 3 - entry (T 0%Z) 1 * entry (T 1%Z) 3 * entry (T 2%Z) 2 - entry (T 0%Z) 2 * entry (T 1%Z) 1 * entry (T 2%Z) 3 + entry (T 0%Z) 2 * entry (T 1%Z) 3 * entry (T 2%Z) 1 + entry (T 0%Z) 3 * entry (T 1%Z) 1 * entry (T 2%Z) 2 - entry (T 0%Z) 3 * entry (T 1%Z) 2 * entry (T 2%Z) 1 <> 0 ->
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + mu) + PI ^ 2 * (1 - nu) <> 0 ->
  2 * (IZR k - 2) + PI * (1 + mu) <> 0 ->
  meet (T 0%Z) (T 1%Z) (T 2%Z) = meet (HT T k mu nu 0) (vDerive 4 (fun x => HT T k mu nu x) 1 0) (vDerive 4 (fun x => HT T k mu nu x) 2 0).
Definition instance : Prop :=
exists (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= 0 <= k)%Z /\
  (0 <= 1 <= k)%Z /\
  (0 <= 2 <= k)%Z /\
  det [normal (T 0%Z); normal (T 1%Z); normal (T 2%Z)] <> 0 /\
  det [normal (HT T k mu nu 0); normal (vDerive 4 (fun x => HT T k mu nu x) 1 0); normal (vDerive 4 (fun x => HT T k mu nu x) 2 0)] <> 0 /\
  entry (T 0%Z) 1 * entry (T 1%Z) 2 * entry (T 2%Z) 3 - entry (T 0%Z) 1 * entry (T 1%Z) 3 * entry (T 2%Z) 2 - entry (T 0%Z) 2 * entry (T 1%Z) 1 * entry (T 2%Z) 3 + entry (T 0%Z) 2 * entry (T 1%Z) 3 * entry (T 2%Z) 1 + entry (T 0%Z) 3 * entry (T 1%Z) 1 * entry (T 2%Z) 2 - entry (T 0%Z) 3 * entry (T 1%Z) 2 * entry (T 2%Z) 1 <> 0 /\
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + mu) + PI ^ 2 * (1 - nu) <> 0 /\
  2 * (IZR k - 2) + PI * (1 + mu) <> 0.
End sec_3_4_S0.

Module sec_3_4_S0_gen.
(* gbt-developable/sec-3.4.S0-gen, Sect. 3.4, last paragraph
   printed: [S(0)] occurs on the starting generator V(x2, 0; μ, ν)
   read as: The starting generator is the line of the planes H(0) and H'(0); H'(0) is divided by its factor k − 2 + π/2 (1 + μ), which has to differ from zero for the line to be there.
   stated: dot(normal(HT(0)), S0) == HT(0)[4] and dot(normal(HT'(0)/kappa), S0) == HT'(0)[4]/kappa *)
Definition kappa (k : Z) (mu : R) : R :=
  IZR k - 2 + PI / 2 * (1 + mu).
Definition S0 (T : Z -> list R) : list R :=
  meet (T 0%Z) (T 1%Z) (T 2%Z).
Definition statement : Prop :=
forall (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= 0 <= k)%Z ->
  (0 <= 1 <= k)%Z ->
  (0 <= 2 <= k)%Z ->
  det [normal (T 0%Z); normal (T 1%Z); normal (T 2%Z)] <> 0 ->
  kappa k mu <> 0 ->
  entry (T 0%Z) 1 * entry (T 1%Z) 2 * entry (T 2%Z) 3 - entry (T 0%Z) 1 * entry (T 1%Z) 3 * entry (T 2%Z) 2 - entry (T 0%Z) 2 * entry (T 1%Z) 1 * entry (T 2%Z) 3 + entry (T 0%Z) 2 * entry (T 1%Z) 3 * entry (T 2%Z) 1 + entry (T 0%Z) 3 * entry (T 1%Z) 1 * entry (T 2%Z) 2 - entry (T 0%Z) 3 * entry (T 1%Z) 2 * entry (T 2%Z) 1 <> 0 ->
  2 * (IZR k - 2) + PI * (1 + mu) <> 0 ->
  dot (normal (HT T k mu nu 0)) (S0 T) = entry (HT T k mu nu 0) 4 /\ dot (normal (vdiv (vDerive 4 (fun x => HT T k mu nu x) 1 0) (kappa k mu))) (S0 T) = entry (vDerive 4 (fun x => HT T k mu nu x) 1 0) 4 / kappa k mu.
Definition instance : Prop :=
exists (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= 0 <= k)%Z /\
  (0 <= 1 <= k)%Z /\
  (0 <= 2 <= k)%Z /\
  det [normal (T 0%Z); normal (T 1%Z); normal (T 2%Z)] <> 0 /\
  kappa k mu <> 0 /\
  entry (T 0%Z) 1 * entry (T 1%Z) 2 * entry (T 2%Z) 3 - entry (T 0%Z) 1 * entry (T 1%Z) 3 * entry (T 2%Z) 2 - entry (T 0%Z) 2 * entry (T 1%Z) 1 * entry (T 2%Z) 3 + entry (T 0%Z) 2 * entry (T 1%Z) 3 * entry (T 2%Z) 1 + entry (T 0%Z) 3 * entry (T 1%Z) 1 * entry (T 2%Z) 2 - entry (T 0%Z) 3 * entry (T 1%Z) 2 * entry (T 2%Z) 1 <> 0 /\
  2 * (IZR k - 2) + PI * (1 + mu) <> 0.
End sec_3_4_S0_gen.

Module sec_3_4_S1.
(* gbt-developable/sec-3.4.S1, Sect. 3.4, last paragraph
   printed: the characteristic point S(1) of the spine curve ... can be achieved from the intersection of the control planes Q_{k−2}, Q_{k−1}, Q_k of expression (3.12)
   read as: S(1) is the common point of the three planes (3.9) at x = 1.
   stated: meet(T[k-2], T[k-1], T[k]) == meet(HT(1), HT'(1), HT''(1)) *)
Definition statement : Prop :=
forall (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= k - 2 <= k)%Z ->
  (0 <= k - 1 <= k)%Z ->
  (0 <= k <= k)%Z ->
  det [normal (T (k - 2)%Z); normal (T (k - 1)%Z); normal (T k)] <> 0 ->
  det [normal (HT T k mu nu 1); normal (vDerive 4 (fun x => HT T k mu nu x) 1 1); normal (vDerive 4 (fun x => HT T k mu nu x) 2 1)] <> 0 ->
  entry (T (k - 2)%Z) 1 * entry (T (k - 1)%Z) 2 * entry (T k) 3 - entry (T (k - 2)%Z) 1 * entry (T (k - 1)%Z) 3 * entry (T k) 2 - entry (T (k - 2)%Z) 2 * entry (T (k - 1)%Z) 1 * entry (T k) 3 + entry (T (k - 2)%Z) 2 * entry (T (k - 1)%Z) 3 * entry (T k) 1 + entry (T (k - 2)%Z) 3 * entry (T (k - 1)%Z) 1 * entry (T k) 2 - entry (T (k - 2)%Z) 3 * entry (T (k - 1)%Z) 2 * entry (T k) 1 <> 0 ->
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + nu) + PI ^ 2 * (1 - mu) <> 0 ->
  2 * (IZR k - 2) + PI * (1 + nu) <> 0 ->
  meet (T (k - 2)%Z) (T (k - 1)%Z) (T k) = meet (HT T k mu nu 1) (vDerive 4 (fun x => HT T k mu nu x) 1 1) (vDerive 4 (fun x => HT T k mu nu x) 2 1).
Definition instance : Prop :=
exists (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= k - 2 <= k)%Z /\
  (0 <= k - 1 <= k)%Z /\
  (0 <= k <= k)%Z /\
  det [normal (T (k - 2)%Z); normal (T (k - 1)%Z); normal (T k)] <> 0 /\
  det [normal (HT T k mu nu 1); normal (vDerive 4 (fun x => HT T k mu nu x) 1 1); normal (vDerive 4 (fun x => HT T k mu nu x) 2 1)] <> 0 /\
  entry (T (k - 2)%Z) 1 * entry (T (k - 1)%Z) 2 * entry (T k) 3 - entry (T (k - 2)%Z) 1 * entry (T (k - 1)%Z) 3 * entry (T k) 2 - entry (T (k - 2)%Z) 2 * entry (T (k - 1)%Z) 1 * entry (T k) 3 + entry (T (k - 2)%Z) 2 * entry (T (k - 1)%Z) 3 * entry (T k) 1 + entry (T (k - 2)%Z) 3 * entry (T (k - 1)%Z) 1 * entry (T k) 2 - entry (T (k - 2)%Z) 3 * entry (T (k - 1)%Z) 2 * entry (T k) 1 <> 0 /\
  4 * (IZR k - 2) * (IZR k - 3) + 4 * PI * (IZR k - 2) * (1 + nu) + PI ^ 2 * (1 - mu) <> 0 /\
  2 * (IZR k - 2) + PI * (1 + nu) <> 0.
End sec_3_4_S1.

Module sec_3_4_S1_gen.
(* gbt-developable/sec-3.4.S1-gen, Sect. 3.4, last paragraph
   printed: [S(1)] lies on ending generator V(x2, 1; μ, ν)
   read as: The ending generator is the line of the planes H(1) and H'(1); H'(1) is divided by its factor k − 2 + π/2 (1 + ν), which has to differ from zero for the line to be there.
   stated: dot(normal(HT(1)), S1) == HT(1)[4] and dot(normal(HT'(1)/kappa), S1) == HT'(1)[4]/kappa *)
Definition kappa (k : Z) (nu : R) : R :=
  IZR k - 2 + PI / 2 * (1 + nu).
Definition S1 (T : Z -> list R) (k : Z) : list R :=
  meet (T (k - 2)%Z) (T (k - 1)%Z) (T k).
Definition statement : Prop :=
forall (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  (0 <= k - 2 <= k)%Z ->
  (0 <= k - 1 <= k)%Z ->
  (0 <= k <= k)%Z ->
  det [normal (T (k - 2)%Z); normal (T (k - 1)%Z); normal (T k)] <> 0 ->
  kappa k nu <> 0 ->
  entry (T (k - 2)%Z) 1 * entry (T (k - 1)%Z) 2 * entry (T k) 3 - entry (T (k - 2)%Z) 1 * entry (T (k - 1)%Z) 3 * entry (T k) 2 - entry (T (k - 2)%Z) 2 * entry (T (k - 1)%Z) 1 * entry (T k) 3 + entry (T (k - 2)%Z) 2 * entry (T (k - 1)%Z) 3 * entry (T k) 1 + entry (T (k - 2)%Z) 3 * entry (T (k - 1)%Z) 1 * entry (T k) 2 - entry (T (k - 2)%Z) 3 * entry (T (k - 1)%Z) 2 * entry (T k) 1 <> 0 ->
  2 * (IZR k - 2) + PI * (1 + nu) <> 0 ->
  dot (normal (HT T k mu nu 1)) (S1 T k) = entry (HT T k mu nu 1) 4 /\ dot (normal (vdiv (vDerive 4 (fun x => HT T k mu nu x) 1 1) (kappa k nu))) (S1 T k) = entry (vDerive 4 (fun x => HT T k mu nu x) 1 1) 4 / kappa k nu.
Definition instance : Prop :=
exists (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (mu : R) (nu : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  (0 <= k - 2 <= k)%Z /\
  (0 <= k - 1 <= k)%Z /\
  (0 <= k <= k)%Z /\
  det [normal (T (k - 2)%Z); normal (T (k - 1)%Z); normal (T k)] <> 0 /\
  kappa k nu <> 0 /\
  entry (T (k - 2)%Z) 1 * entry (T (k - 1)%Z) 2 * entry (T k) 3 - entry (T (k - 2)%Z) 1 * entry (T (k - 1)%Z) 3 * entry (T k) 2 - entry (T (k - 2)%Z) 2 * entry (T (k - 1)%Z) 1 * entry (T k) 3 + entry (T (k - 2)%Z) 2 * entry (T (k - 1)%Z) 3 * entry (T k) 1 + entry (T (k - 2)%Z) 3 * entry (T (k - 1)%Z) 1 * entry (T k) 2 - entry (T (k - 2)%Z) 3 * entry (T (k - 1)%Z) 2 * entry (T k) 1 <> 0 /\
  2 * (IZR k - 2) + PI * (1 + nu) <> 0.
End sec_3_4_S1_gen.
