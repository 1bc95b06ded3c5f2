(* Statements of gbt-developable, Section 3 3. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition g (x : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)); 1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k.
Definition HT (T : Z -> list R) (k : Z) (mu : R) (nu : R) (x : R) : list R :=
  vsum 4 0%Z k (fun i => vscale (g x mu nu i k) (T i)).
Definition normal (P : list R) : list R :=
  [entry P 1; entry P 2; entry P 3].
Definition W (X : R) (Y : R) (Z_ : R) : list R :=
  [X; Y; Z_].
Definition F (T : Z -> list R) (X : R) (Y : R) (Z_ : R) (k : Z) (mu : R) (nu : R) (x : R) : R :=
  dot (normal (HT T k mu nu x)) (W X Y Z_) - entry (HT T k mu nu x) 4.
Definition a (a0 : R) (a1 : R) (a2 : R) : list R :=
  [a0; a1; a2].
Definition a' (a0' : R) (a1' : R) (a2' : R) : list R :=
  [a0'; a1'; a2'].
Definition a'' (a0'' : R) (a1'' : R) (a2'' : R) : list R :=
  [a0''; a1''; a2''].
Definition system (a0 : R) (a0' : R) (a0'' : R) (a1 : R) (a1' : R) (a1'' : R) (a2 : R) (a2' : R) (a2'' : R) : list (list R) :=
  [a a0 a1 a2; a' a0' a1' a2'; a'' a0'' a1'' a2''].
Definition cramer1 (a1 : R) (a1' : R) (a1'' : R) (a2 : R) (a2' : R) (a2'' : R) (a3 : R) (a3' : R) (a3'' : R) : R :=
  det [[a3; a1; a2]; [a3'; a1'; a2']; [a3''; a1''; a2'']].
Definition cramer2 (a0 : R) (a0' : R) (a0'' : R) (a2 : R) (a2' : R) (a2'' : R) (a3 : R) (a3' : R) (a3'' : R) : R :=
  det [[a0; a3; a2]; [a0'; a3'; a2']; [a0''; a3''; a2'']].
Definition cramer3 (a0 : R) (a0' : R) (a0'' : R) (a1 : R) (a1' : R) (a1'' : R) (a3 : R) (a3' : R) (a3'' : R) : R :=
  det [[a0; a1; a3]; [a0'; a1'; a3']; [a0''; a1''; a3'']].
Definition S_ (a0 : R) (a0' : R) (a0'' : R) (a1 : R) (a1' : R) (a1'' : R) (a2 : R) (a2' : R) (a2'' : R) (a3 : R) (a3' : R) (a3'' : R) : list R :=
  vdiv [cramer1 a1 a1' a1'' a2 a2' a2'' a3 a3' a3''; cramer2 a0 a0' a0'' a2 a2' a2'' a3 a3' a3''; cramer3 a0 a0' a0'' a1 a1' a1'' a3 a3' a3''] (det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'')).
Definition four (a0 : R) (a0' : R) (a0'' : R) (a0''' : R) (a1 : R) (a1' : R) (a1'' : R) (a1''' : R) (a2 : R) (a2' : R) (a2'' : R) (a2''' : R) (a3 : R) (a3' : R) (a3'' : R) (a3''' : R) : R :=
  det [[a0; a1; a2; a3]; [a0'; a1'; a2'; a3']; [a0''; a1''; a2''; a3'']; [a0'''; a1'''; a2'''; a3''']].
Definition a''' (a0''' : R) (a1''' : R) (a2''' : R) : list R :=
  [a0'''; a1'''; a2'''].
Definition A (a0 : R) (a0' : R) (a0'' : R) (a0''' : R) (a1 : R) (a1' : R) (a1'' : R) (a1''' : R) (a2 : R) (a2' : R) (a2'' : R) (a2''' : R) (e : R) : list R :=
  vadd (vadd (vadd (a a0 a1 a2) (vscale e (a' a0' a1' a2'))) (vscale (e ^ 2 / 2) (a'' a0'' a1'' a2''))) (vscale (e ^ 3 / 6) (a''' a0''' a1''' a2''')).
Definition A3 (a3 : R) (a3' : R) (a3'' : R) (a3''' : R) (e : R) : R :=
  a3 + e * a3' + e ^ 2 / 2 * a3'' + e ^ 3 / 6 * a3'''.
Definition phi (a0 : R) (a0' : R) (a1 : R) (a1' : R) (a2 : R) (a2' : R) : list R :=
  cross (a a0 a1 a2) (a' a0' a1' a2').
Definition meet (A : list R) (B : list R) (C_ : list R) : list R :=
  vdiv [det [[entry A 4; entry A 2; entry A 3]; [entry B 4; entry B 2; entry B 3]; [entry C_ 4; entry C_ 2; entry C_ 3]]; det [[entry A 1; entry A 4; entry A 3]; [entry B 1; entry B 4; entry B 3]; [entry C_ 1; entry C_ 4; entry C_ 3]]; det [[entry A 1; entry A 2; entry A 4]; [entry B 1; entry B 2; entry B 4]; [entry C_ 1; entry C_ 2; entry C_ 4]]] (det [normal A; normal B; normal C_]).
Definition spine (a0 : R) (a0' : R) (a0'' : R) (a0''' : R) (a1 : R) (a1' : R) (a1'' : R) (a1''' : R) (a2 : R) (a2' : R) (a2'' : R) (a2''' : R) (a3 : R) (a3' : R) (a3'' : R) (a3''' : R) (e : R) : list R :=
  meet [entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1; entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2; entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 3; A3 a3 a3' a3'' a3''' e] [entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 1; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 2; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 3; Derive_n (fun e => A3 a3 a3' a3'' a3''' e) 1 e] [entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 1; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 2; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 3; Derive_n (fun e => A3 a3 a3' a3'' a3''' e) 2 e].
End Definitions.
Import Definitions.

Module eq_3_8.
(* gbt-developable/eq-3.8, Sect. 3.3, eq. (3.8)
   printed: a''_0(x) X + a''_1(x) Y + a''_2(x) Z = a''_3(x)
   stated: F''(x) == HT''(x)[1]*X + HT''(x)[2]*Y + HT''(x)[3]*Z - HT''(x)[4] *)
Definition statement : Prop :=
forall (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (X : R) (Y : R) (Z_ : R) (mu : R) (nu : R) (x : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  Derive_n (fun x => F T X Y Z_ k mu nu x) 2 x = entry (vDerive 4 (fun x => HT T k mu nu x) 2 x) 1 * X + entry (vDerive 4 (fun x => HT T k mu nu x) 2 x) 2 * Y + entry (vDerive 4 (fun x => HT T k mu nu x) 2 x) 3 * Z_ - entry (vDerive 4 (fun x => HT T k mu nu x) 2 x) 4.
Definition instance : Prop :=
exists (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (X : R) (Y : R) (Z_ : R) (mu : R) (nu : R) (x : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End eq_3_8.

Module eq_3_9.
(* gbt-developable/eq-3.9, Sect. 3.3, eq. (3.9)
   printed: a0 X + a1 Y + a2 Z = a3;  a'_0 X + a'_1 Y + a'_2 Z = a'_3;  a''_0 X + a''_1 Y + a''_2 Z = a''_3
   read as: The three equations are (3.5), (3.6) and (3.8): compared with F and its first two derivatives.
   stated: [F(x), F'(x), F''(x)] == [HT(x)[1]*X + HT(x)[2]*Y + HT(x)[3]*Z - HT(x)[4], HT'(x)[1]*X + HT'(x)[2]*Y + HT'(x)[3]*Z - HT'(x)[4], HT''(x)[1]*X + HT''(x)[2]*Y + HT''(x)[3]*Z - HT''(x)[4]] *)
Definition statement : Prop :=
forall (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (X : R) (Y : R) (Z_ : R) (mu : R) (nu : R) (x : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z ->
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  [F T X Y Z_ k mu nu x; Derive_n (fun x => F T X Y Z_ k mu nu x) 1 x; Derive_n (fun x => F T X Y Z_ k mu nu x) 2 x] = [entry (HT T k mu nu x) 1 * X + entry (HT T k mu nu x) 2 * Y + entry (HT T k mu nu x) 3 * Z_ - entry (HT T k mu nu x) 4; entry (vDerive 4 (fun x => HT T k mu nu x) 1 x) 1 * X + entry (vDerive 4 (fun x => HT T k mu nu x) 1 x) 2 * Y + entry (vDerive 4 (fun x => HT T k mu nu x) 1 x) 3 * Z_ - entry (vDerive 4 (fun x => HT T k mu nu x) 1 x) 4; entry (vDerive 4 (fun x => HT T k mu nu x) 2 x) 1 * X + entry (vDerive 4 (fun x => HT T k mu nu x) 2 x) 2 * Y + entry (vDerive 4 (fun x => HT T k mu nu x) 2 x) 3 * Z_ - entry (vDerive 4 (fun x => HT T k mu nu x) 2 x) 4].
Definition instance : Prop :=
exists (k : Z) (T'1 T'2 T'3 T'4 : Z -> R) (X : R) (Y : R) (Z_ : R) (mu : R) (nu : R) (x : R),
  let T := fun i0 => [T'1 i0; T'2 i0; T'3 i0; T'4 i0] in
  (2 <= k)%Z /\
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1.
End eq_3_9.

Module sec_3_3_S_vec.
(* gbt-developable/sec-3.3.S-vec, Sect. 3.3, vector formula for S(x)
   printed: S(x) = ( a''_3 [a × a'] + a3 [a' × a''] + a'_3 [a'' × a'] ) / ( a [a' × a''] )
   stated: S == (a3''*cross(a, a') + a3*cross(a', a'') + a3'*cross(a'', a'))/dot(a, cross(a', a'')) *)
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a0'' : R) (a1 : R) (a1' : R) (a1'' : R) (a2 : R) (a2' : R) (a2'' : R) (a3 : R) (a3' : R) (a3'' : R),
  det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') <> 0 ->
  dot (a a0 a1 a2) (cross (a' a0' a1' a2') (a'' a0'' a1'' a2'')) <> 0 ->
  S_ a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3' a3'' = vdiv (vadd (vadd (vscale a3'' (cross (a a0 a1 a2) (a' a0' a1' a2'))) (vscale a3 (cross (a' a0' a1' a2') (a'' a0'' a1'' a2'')))) (vscale a3' (cross (a'' a0'' a1'' a2'') (a' a0' a1' a2')))) (dot (a a0 a1 a2) (cross (a' a0' a1' a2') (a'' a0'' a1'' a2''))).
End sec_3_3_S_vec.

Module sec_3_3_S_vec_corrected.
(* gbt-developable/sec-3.3.S-vec (corrected), Sect. 3.3, vector formula for S(x)
   printed: S(x) = ( a''_3 [a × a'] + a3 [a' × a''] + a'_3 [a'' × a'] ) / ( a [a' × a''] )
   stated: S == (a3''*cross(a, a') + a3*cross(a', a'') + a3'*cross(a'', a))/dot(a, cross(a', a'')) *)
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a0'' : R) (a1 : R) (a1' : R) (a1'' : R) (a2 : R) (a2' : R) (a2'' : R) (a3 : R) (a3' : R) (a3'' : R),
  det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') <> 0 ->
  dot (a a0 a1 a2) (cross (a' a0' a1' a2') (a'' a0'' a1'' a2'')) <> 0 ->
  a0 * a1' * a2'' - a0 * a1'' * a2' - a0' * a1 * a2'' + a0' * a1'' * a2 + a0'' * a1 * a2' - a0'' * a1' * a2 <> 0 ->
  S_ a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3' a3'' = vdiv (vadd (vadd (vscale a3'' (cross (a a0 a1 a2) (a' a0' a1' a2'))) (vscale a3 (cross (a' a0' a1' a2') (a'' a0'' a1'' a2'')))) (vscale a3' (cross (a'' a0'' a1'' a2'') (a a0 a1 a2)))) (dot (a a0 a1 a2) (cross (a' a0' a1' a2') (a'' a0'' a1'' a2''))).
Definition instance : Prop :=
exists (a0 : R) (a0' : R) (a0'' : R) (a1 : R) (a1' : R) (a1'' : R) (a2 : R) (a2' : R) (a2'' : R) (a3 : R) (a3' : R) (a3'' : R),
  det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') <> 0 /\
  dot (a a0 a1 a2) (cross (a' a0' a1' a2') (a'' a0'' a1'' a2'')) <> 0 /\
  a0 * a1' * a2'' - a0 * a1'' * a2' - a0' * a1 * a2'' + a0' * a1'' * a2 + a0'' * a1 * a2' - a0'' * a1' * a2 <> 0.
End sec_3_3_S_vec_corrected.

Module sec_3_3_S_x.
(* gbt-developable/sec-3.3.S-x, Sect. 3.3, expanded S(x), numerator, first component
   printed: a''_3 [a1 a'_2 − a2 a'_1] + a3 [a'_1 a''_2 − a'_2 a''_1] + a'_3 [a''_1 a2 − a''_2 a1]
   stated: cramer1 == a3''*(a1*a2' - a2*a1') + a3*(a1'*a2'' - a2'*a1'') + a3'*(a1''*a2 - a2''*a1) *)
Definition statement : Prop :=
forall (a1 : R) (a1' : R) (a1'' : R) (a2 : R) (a2' : R) (a2'' : R) (a3 : R) (a3' : R) (a3'' : R),
  cramer1 a1 a1' a1'' a2 a2' a2'' a3 a3' a3'' = a3'' * (a1 * a2' - a2 * a1') + a3 * (a1' * a2'' - a2' * a1'') + a3' * (a1'' * a2 - a2'' * a1).
End sec_3_3_S_x.

Module sec_3_3_S_y.
(* gbt-developable/sec-3.3.S-y, Sect. 3.3, expanded S(x), numerator, second component
   printed: a''_3 [a2 a'_0 − a0 a'_2] + a3 [a'_2 a''_0 − a'_0 a''_2] + a'_3 [a''_2 a0 − a''_0 a2]
   stated: cramer2 == a3''*(a2*a0' - a0*a2') + a3*(a2'*a0'' - a0'*a2'') + a3'*(a2''*a0 - a0''*a2) *)
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a0'' : R) (a2 : R) (a2' : R) (a2'' : R) (a3 : R) (a3' : R) (a3'' : R),
  cramer2 a0 a0' a0'' a2 a2' a2'' a3 a3' a3'' = a3'' * (a2 * a0' - a0 * a2') + a3 * (a2' * a0'' - a0' * a2'') + a3' * (a2'' * a0 - a0'' * a2).
End sec_3_3_S_y.

Module sec_3_3_S_z.
(* gbt-developable/sec-3.3.S-z, Sect. 3.3, expanded S(x), numerator, third component
   printed: a''_3 [a0 a'_1 − a1 a'_0] + a3 [a'_0 a''_1 − a'_1 a''_0] + a'_3 [a''_0 a1 − a''_1 a0]
   stated: cramer3 == a3''*(a0*a1' - a1*a0') + a3*(a0'*a1'' - a1'*a0'') + a3'*(a0''*a1 - a1''*a0) *)
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a0'' : R) (a1 : R) (a1' : R) (a1'' : R) (a3 : R) (a3' : R) (a3'' : R),
  cramer3 a0 a0' a0'' a1 a1' a1'' a3 a3' a3'' = a3'' * (a0 * a1' - a1 * a0') + a3 * (a0' * a1'' - a1' * a0'') + a3' * (a0'' * a1 - a1'' * a0).
End sec_3_3_S_z.

Module sec_3_3_S_den.
(* gbt-developable/sec-3.3.S-den, Sect. 3.3, expanded S(x), denominator
   printed: a0 [a'_1 a''_2 − a'_2 a''_1] + a1 [a'_2 a''_0 − a'_0 a''_2] + a2 [a'_0 a''_1 − a'_1 a''_0]
   stated: det(system) == a0*(a1'*a2'' - a2'*a1'') + a1*(a2'*a0'' - a0'*a2'') + a2*(a0'*a1'' - a1'*a0'') *)
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a0'' : R) (a1 : R) (a1' : R) (a1'' : R) (a2 : R) (a2' : R) (a2'' : R),
  det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') = a0 * (a1' * a2'' - a2' * a1'') + a1 * (a2' * a0'' - a0' * a2'') + a2 * (a0' * a1'' - a1' * a0'').
End sec_3_3_S_den.

Module sec_3_3_regression.
(* gbt-developable/sec-3.3.regression, Sect. 3.3, first sentence and the sentences before (3.10)
   printed: ... locus of this point is a curve, identified as a spine curve of the developable GBT-Bézier surface
   read as: S lies on the generator and moves along it, with a velocity that is not zero: it is a curve, and the generators are its tangents.
   stated: dot(a, S) == a3 and dot(a', S) == a3' and spine'(0)*det(system)^2/four == phi *)
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a0'' : R) (a0''' : R) (a1 : R) (a1' : R) (a1'' : R) (a1''' : R) (a2 : R) (a2' : R) (a2'' : R) (a2''' : R) (a3 : R) (a3' : R) (a3'' : R) (a3''' : R),
  det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') <> 0 ->
  four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''' <> 0 ->
  locally 0 (fun e => det [normal [entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1; entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2; entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 3; A3 a3 a3' a3'' a3''' e]; normal [entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 1; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 2; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 3; Derive_n (fun e => A3 a3 a3' a3'' a3''' e) 1 e]; normal [entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 1; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 2; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 3; Derive_n (fun e => A3 a3 a3' a3'' a3''' e) 2 e]] <> 0) ->
  dot (a a0 a1 a2) (S_ a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3' a3'') = a3 /\ dot (a' a0' a1' a2') (S_ a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3' a3'') = a3' /\ vdiv (vscale (det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') ^ 2) (vDerive 3 (fun e => spine a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''' e) 1 0)) (four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''') = phi a0 a0' a1 a1' a2 a2'.
Definition instance : Prop :=
exists (a0 : R) (a0' : R) (a0'' : R) (a0''' : R) (a1 : R) (a1' : R) (a1'' : R) (a1''' : R) (a2 : R) (a2' : R) (a2'' : R) (a2''' : R) (a3 : R) (a3' : R) (a3'' : R) (a3''' : R),
  det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') <> 0 /\
  four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''' <> 0 /\
  locally 0 (fun e => det [normal [entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1; entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2; entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 3; A3 a3 a3' a3'' a3''' e]; normal [entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 1; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 2; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 3; Derive_n (fun e => A3 a3 a3' a3'' a3''' e) 1 e]; normal [entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 1; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 2; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 3; Derive_n (fun e => A3 a3 a3' a3'' a3''' e) 2 e]] <> 0).
End sec_3_3_regression.

Module sec_3_3_regression_velocity.
(* gbt-developable/sec-3.3.regression.velocity, Sect. 3.3
   printed: The velocity of the spine curve.
   stated: spine'(0) == four/det(system)^2*phi *)
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a0'' : R) (a0''' : R) (a1 : R) (a1' : R) (a1'' : R) (a1''' : R) (a2 : R) (a2' : R) (a2'' : R) (a2''' : R) (a3 : R) (a3' : R) (a3'' : R) (a3''' : R),
  locally 0 (fun e => det [normal [entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1; entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2; entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 3; A3 a3 a3' a3'' a3''' e]; normal [entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 1; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 2; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 3; Derive_n (fun e => A3 a3 a3' a3'' a3''' e) 1 e]; normal [entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 1; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 2; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 3; Derive_n (fun e => A3 a3 a3' a3'' a3''' e) 2 e]] <> 0) ->
  det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') ^ 2 <> 0 ->
  a0 * a1' * a2'' - a0 * a1'' * a2' - a0' * a1 * a2'' + a0' * a1'' * a2 + a0'' * a1 * a2' - a0'' * a1' * a2 <> 0 ->
  vDerive 3 (fun e => spine a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''' e) 1 0 = vscale (four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''' / det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') ^ 2) (phi a0 a0' a1 a1' a2 a2').
Definition instance : Prop :=
exists (a0 : R) (a0' : R) (a0'' : R) (a0''' : R) (a1 : R) (a1' : R) (a1'' : R) (a1''' : R) (a2 : R) (a2' : R) (a2'' : R) (a2''' : R) (a3 : R) (a3' : R) (a3'' : R) (a3''' : R),
  locally 0 (fun e => det [normal [entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1; entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2; entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 3; A3 a3 a3' a3'' a3''' e]; normal [entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 1; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 2; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 3; Derive_n (fun e => A3 a3 a3' a3'' a3''' e) 1 e]; normal [entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 1; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 2; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 3; Derive_n (fun e => A3 a3 a3' a3'' a3''' e) 2 e]] <> 0) /\
  det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') ^ 2 <> 0 /\
  a0 * a1' * a2'' - a0 * a1'' * a2' - a0' * a1 * a2'' + a0' * a1'' * a2 + a0'' * a1 * a2' - a0'' * a1' * a2 <> 0.
End sec_3_3_regression_velocity.

Module sec_3_3_regression_quadratic.
(* gbt-developable/sec-3.3.regression.quadratic, Sect. 3.3
   printed: A quadratic family has no spine curve: its surface is a cone.
   stated: meet(quadratic(x), quadratic'(x), quadratic''(x)) == meet(U[0], U[1], U[2]) *)
Definition quadratic (U : Z -> list R) (mu : R) (nu : R) (x : R) : list R :=
  vadd (vadd (vscale (g x mu nu 0%Z 2%Z) (U 0%Z)) (vscale (g x mu nu 1%Z 2%Z) (U 1%Z))) (vscale (g x mu nu 2%Z 2%Z) (U 2%Z)).
Definition meet (A : list R) (B : list R) (C_ : list R) : list R :=
  vdiv [det [[entry A 4; entry A 2; entry A 3]; [entry B 4; entry B 2; entry B 3]; [entry C_ 4; entry C_ 2; entry C_ 3]]; det [[entry A 1; entry A 4; entry A 3]; [entry B 1; entry B 4; entry B 3]; [entry C_ 1; entry C_ 4; entry C_ 3]]; det [[entry A 1; entry A 2; entry A 4]; [entry B 1; entry B 2; entry B 4]; [entry C_ 1; entry C_ 2; entry C_ 4]]] (det [normal A; normal B; normal C_]).
Definition statement : Prop :=
forall (U'1 U'2 U'3 U'4 : Z -> R) (mu : R) (nu : R) (x : R),
  let U := fun i0 => [U'1 i0; U'2 i0; U'3 i0; U'4 i0] in
  (-1) <= mu <= 1 ->
  (-1) <= nu <= 1 ->
  0 <= x <= 1 ->
  det [normal (quadratic U mu nu x); normal (vDerive 4 (fun x => quadratic U mu nu x) 1 x); normal (vDerive 4 (fun x => quadratic U mu nu x) 2 x)] <> 0 ->
  det [normal (U 0%Z); normal (U 1%Z); normal (U 2%Z)] <> 0 ->
  entry (U 0%Z) 1 * entry (U 1%Z) 2 * entry (U 2%Z) 3 - entry (U 0%Z) 1 * entry (U 1%Z) 3 * entry (U 2%Z) 2 - entry (U 0%Z) 2 * entry (U 1%Z) 1 * entry (U 2%Z) 3 + entry (U 0%Z) 2 * entry (U 1%Z) 3 * entry (U 2%Z) 1 + entry (U 0%Z) 3 * entry (U 1%Z) 1 * entry (U 2%Z) 2 - entry (U 0%Z) 3 * entry (U 1%Z) 2 * entry (U 2%Z) 1 <> 0 ->
  2 * mu * nu * sin (PI / 2 * x) * cos (PI / 2 * x) ^ 2 - 2 * mu * nu * sin (PI / 2 * x) - 2 * mu * nu * cos (PI / 2 * x) ^ 3 + mu * nu + 2 * mu * sin (PI / 2 * x) * cos (PI / 2 * x) ^ 2 - 2 * mu * sin (PI / 2 * x) + mu - 2 * nu * cos (PI / 2 * x) ^ 3 + nu + 1 <> 0 ->
  meet (quadratic U mu nu x) (vDerive 4 (fun x => quadratic U mu nu x) 1 x) (vDerive 4 (fun x => quadratic U mu nu x) 2 x) = meet (U 0%Z) (U 1%Z) (U 2%Z).
Definition instance : Prop :=
exists (U'1 U'2 U'3 U'4 : Z -> R) (mu : R) (nu : R) (x : R),
  let U := fun i0 => [U'1 i0; U'2 i0; U'3 i0; U'4 i0] in
  (-1) <= mu <= 1 /\
  (-1) <= nu <= 1 /\
  0 <= x <= 1 /\
  det [normal (quadratic U mu nu x); normal (vDerive 4 (fun x => quadratic U mu nu x) 1 x); normal (vDerive 4 (fun x => quadratic U mu nu x) 2 x)] <> 0 /\
  det [normal (U 0%Z); normal (U 1%Z); normal (U 2%Z)] <> 0 /\
  entry (U 0%Z) 1 * entry (U 1%Z) 2 * entry (U 2%Z) 3 - entry (U 0%Z) 1 * entry (U 1%Z) 3 * entry (U 2%Z) 2 - entry (U 0%Z) 2 * entry (U 1%Z) 1 * entry (U 2%Z) 3 + entry (U 0%Z) 2 * entry (U 1%Z) 3 * entry (U 2%Z) 1 + entry (U 0%Z) 3 * entry (U 1%Z) 1 * entry (U 2%Z) 2 - entry (U 0%Z) 3 * entry (U 1%Z) 2 * entry (U 2%Z) 1 <> 0 /\
  2 * mu * nu * sin (PI / 2 * x) * cos (PI / 2 * x) ^ 2 - 2 * mu * nu * sin (PI / 2 * x) - 2 * mu * nu * cos (PI / 2 * x) ^ 3 + mu * nu + 2 * mu * sin (PI / 2 * x) * cos (PI / 2 * x) ^ 2 - 2 * mu * sin (PI / 2 * x) + mu - 2 * nu * cos (PI / 2 * x) ^ 3 + nu + 1 <> 0.
End sec_3_3_regression_quadratic.

Module eq_3_10.
(* gbt-developable/eq-3.10, Sect. 3.3, eq. (3.10)
   printed: V(x2, x; μ, ν) = S(x) + x2 S'(x), x2 ∈ (−∞, ∞), x ∈ [0, 1]
   read as: Every point of (3.10) is on both planes (3.5) and (3.6), so on the generator of (3.7), and the direction of this is a multiple of S': x2 runs through all of it. Both surfaces are the same.
   stated: dot(a, V) == a3 and dot(a', V) == a3' and det(system)^2/four*spine'(0) == phi *)
Definition V (a0 : R) (a0' : R) (a0'' : R) (a0''' : R) (a1 : R) (a1' : R) (a1'' : R) (a1''' : R) (a2 : R) (a2' : R) (a2'' : R) (a2''' : R) (a3 : R) (a3' : R) (a3'' : R) (a3''' : R) (x2 : R) : list R :=
  vadd (S_ a0 a0' a0'' a1 a1' a1'' a2 a2' a2'' a3 a3' a3'') (vscale x2 (vDerive 3 (fun e => spine a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''' e) 1 0)).
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a0'' : R) (a0''' : R) (a1 : R) (a1' : R) (a1'' : R) (a1''' : R) (a2 : R) (a2' : R) (a2'' : R) (a2''' : R) (a3 : R) (a3' : R) (a3'' : R) (a3''' : R) (x2 : R),
  det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') <> 0 ->
  four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''' <> 0 ->
  locally 0 (fun e => det [normal [entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1; entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2; entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 3; A3 a3 a3' a3'' a3''' e]; normal [entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 1; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 2; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 3; Derive_n (fun e => A3 a3 a3' a3'' a3''' e) 1 e]; normal [entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 1; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 2; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 3; Derive_n (fun e => A3 a3 a3' a3'' a3''' e) 2 e]] <> 0) ->
  dot (a a0 a1 a2) (V a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''' x2) = a3 /\ dot (a' a0' a1' a2') (V a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''' x2) = a3' /\ vscale (det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') ^ 2 / four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''') (vDerive 3 (fun e => spine a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''' e) 1 0) = phi a0 a0' a1 a1' a2 a2'.
Definition instance : Prop :=
exists (a0 : R) (a0' : R) (a0'' : R) (a0''' : R) (a1 : R) (a1' : R) (a1'' : R) (a1''' : R) (a2 : R) (a2' : R) (a2'' : R) (a2''' : R) (a3 : R) (a3' : R) (a3'' : R) (a3''' : R) (x2 : R),
  det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') <> 0 /\
  four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''' <> 0 /\
  locally 0 (fun e => det [normal [entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1; entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2; entry (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 3; A3 a3 a3' a3'' a3''' e]; normal [entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 1; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 2; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 1 e) 3; Derive_n (fun e => A3 a3 a3' a3'' a3''' e) 1 e]; normal [entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 1; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 2; entry (vDerive 3 (fun e => A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) 2 e) 3; Derive_n (fun e => A3 a3 a3' a3'' a3''' e) 2 e]] <> 0).
End eq_3_10.

Module sec_3_3_developable.
(* gbt-developable/sec-3.3.developable, Sect. 3.3, sentence before (3.10)
   printed: the surface made up of the tangent lines of the spine curve S(x) is a spine curve developable GBT-Bézier surface
   read as: The tangent vectors S' and S' + x2 S'' of (3.10) span the plane (3.5), the same for all x2: the tangent plane is constant along each ruling.
   stated: cross(curve'(0), curve'(0) + x2*curve''(0))*det(system)^3/(x2*four^2) == a *)
Definition B (a0 : R) (a0' : R) (a0'' : R) (a0''' : R) (a0'''' : R) (a1 : R) (a1' : R) (a1'' : R) (a1''' : R) (a1'''' : R) (a2 : R) (a2' : R) (a2'' : R) (a2''' : R) (a2'''' : R) (e : R) : list R :=
  vadd (A a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' e) (vscale (e ^ 4 / 24) [a0''''; a1''''; a2'''']).
Definition B3 (a3 : R) (a3' : R) (a3'' : R) (a3''' : R) (a3'''' : R) (e : R) : R :=
  A3 a3 a3' a3'' a3''' e + e ^ 4 / 24 * a3''''.
Definition meet (A : list R) (B : list R) (C_ : list R) : list R :=
  vdiv [det [[entry A 4; entry A 2; entry A 3]; [entry B 4; entry B 2; entry B 3]; [entry C_ 4; entry C_ 2; entry C_ 3]]; det [[entry A 1; entry A 4; entry A 3]; [entry B 1; entry B 4; entry B 3]; [entry C_ 1; entry C_ 4; entry C_ 3]]; det [[entry A 1; entry A 2; entry A 4]; [entry B 1; entry B 2; entry B 4]; [entry C_ 1; entry C_ 2; entry C_ 4]]] (det [normal A; normal B; normal C_]).
Definition curve (a0 : R) (a0' : R) (a0'' : R) (a0''' : R) (a0'''' : R) (a1 : R) (a1' : R) (a1'' : R) (a1''' : R) (a1'''' : R) (a2 : R) (a2' : R) (a2'' : R) (a2''' : R) (a2'''' : R) (a3 : R) (a3' : R) (a3'' : R) (a3''' : R) (a3'''' : R) (e : R) : list R :=
  meet [entry (B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 1; entry (B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 2; entry (B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 3; B3 a3 a3' a3'' a3''' a3'''' e] [entry (vDerive 3 (fun e => B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 1 e) 1; entry (vDerive 3 (fun e => B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 1 e) 2; entry (vDerive 3 (fun e => B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 1 e) 3; Derive_n (fun e => B3 a3 a3' a3'' a3''' a3'''' e) 1 e] [entry (vDerive 3 (fun e => B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 2 e) 1; entry (vDerive 3 (fun e => B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 2 e) 2; entry (vDerive 3 (fun e => B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 2 e) 3; Derive_n (fun e => B3 a3 a3' a3'' a3''' a3'''' e) 2 e].
Definition statement : Prop :=
forall (a0 : R) (a0' : R) (a0'' : R) (a0''' : R) (a0'''' : R) (a1 : R) (a1' : R) (a1'' : R) (a1''' : R) (a1'''' : R) (a2 : R) (a2' : R) (a2'' : R) (a2''' : R) (a2'''' : R) (a3 : R) (a3' : R) (a3'' : R) (a3''' : R) (a3'''' : R) (x2 : R),
  det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') <> 0 ->
  four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''' <> 0 ->
  x2 <> 0 ->
  locally 0 (fun e => det [normal [entry (B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 1; entry (B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 2; entry (B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 3; B3 a3 a3' a3'' a3''' a3'''' e]; normal [entry (vDerive 3 (fun e => B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 1 e) 1; entry (vDerive 3 (fun e => B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 1 e) 2; entry (vDerive 3 (fun e => B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 1 e) 3; Derive_n (fun e => B3 a3 a3' a3'' a3''' a3'''' e) 1 e]; normal [entry (vDerive 3 (fun e => B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 2 e) 1; entry (vDerive 3 (fun e => B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 2 e) 2; entry (vDerive 3 (fun e => B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 2 e) 3; Derive_n (fun e => B3 a3 a3' a3'' a3''' a3'''' e) 2 e]] <> 0) ->
  x2 * four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''' ^ 2 <> 0 ->
  vdiv (vscale (det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') ^ 3) (cross (vDerive 3 (fun e => curve a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' a3 a3' a3'' a3''' a3'''' e) 1 0) (vadd (vDerive 3 (fun e => curve a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' a3 a3' a3'' a3''' a3'''' e) 1 0) (vscale x2 (vDerive 3 (fun e => curve a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' a3 a3' a3'' a3''' a3'''' e) 2 0))))) (x2 * four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''' ^ 2) = a a0 a1 a2.
Definition instance : Prop :=
exists (a0 : R) (a0' : R) (a0'' : R) (a0''' : R) (a0'''' : R) (a1 : R) (a1' : R) (a1'' : R) (a1''' : R) (a1'''' : R) (a2 : R) (a2' : R) (a2'' : R) (a2''' : R) (a2'''' : R) (a3 : R) (a3' : R) (a3'' : R) (a3''' : R) (a3'''' : R) (x2 : R),
  det (system a0 a0' a0'' a1 a1' a1'' a2 a2' a2'') <> 0 /\
  four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''' <> 0 /\
  x2 <> 0 /\
  locally 0 (fun e => det [normal [entry (B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 1; entry (B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 2; entry (B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 3; B3 a3 a3' a3'' a3''' a3'''' e]; normal [entry (vDerive 3 (fun e => B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 1 e) 1; entry (vDerive 3 (fun e => B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 1 e) 2; entry (vDerive 3 (fun e => B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 1 e) 3; Derive_n (fun e => B3 a3 a3' a3'' a3''' a3'''' e) 1 e]; normal [entry (vDerive 3 (fun e => B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 2 e) 1; entry (vDerive 3 (fun e => B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 2 e) 2; entry (vDerive 3 (fun e => B a0 a0' a0'' a0''' a0'''' a1 a1' a1'' a1''' a1'''' a2 a2' a2'' a2''' a2'''' e) 2 e) 3; Derive_n (fun e => B3 a3 a3' a3'' a3''' a3'''' e) 2 e]] <> 0) /\
  x2 * four a0 a0' a0'' a0''' a1 a1' a1'' a1''' a2 a2' a2'' a2''' a3 a3' a3'' a3''' ^ 2 <> 0.
End sec_3_3_developable.
