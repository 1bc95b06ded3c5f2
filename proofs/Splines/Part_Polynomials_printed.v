(* Statements of splines, Part Polynomials. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition U (s : R) (i : Z) (k : Z) : R :=
  counted (fun i k => (IZR i + 1 - s) / IZR k) (fun i k => (s + IZR k - IZR i) / IZR k) [1] i k.
Definition N_ (t : Z -> R) (x : R) (j : Z) (i : Z) (k : Z) : R :=
  counted (fun i k => (t (j + i + 1)%Z - x) / (t (j + i + 1)%Z - t (j + i + 1 - k)%Z)) (fun i k => (x - t (j + i - k)%Z) / (t (j + i)%Z - t (j + i - k)%Z)) [1] i k.
End Definitions.
Import Definitions.

Module uniform_greville.
(* splines/uniform.greville, Polynomials
   printed: The abscissae of Greville for degree 3: U_{1,3} + 2 U_{2,3} + 3 U_{3,3} = s + 1
   stated: sum(i, 0, 3, i*U[i,3](s)) == s + 1 *)
Definition statement : Prop :=
forall (s : R),
  0 <= s <= 1 ->
  sum 0%Z 3%Z (fun i => IZR i * U s i 3%Z) = s + 1.
Definition instance : Prop :=
exists (s : R),
  0 <= s <= 1.
End uniform_greville.

Module uniform_marsden.
(* splines/uniform.marsden, Polynomials
   printed: s² = sum ((i - 1)² - 1/3) U_{i,3}
   stated: sum(i, 0, 3, ((i - 1)^2 - 1/3)*U[i,3](s)) == s^2 *)
Definition statement : Prop :=
forall (s : R),
  0 <= s <= 1 ->
  sum 0%Z 3%Z (fun i => ((IZR i - 1) ^ 2 - 1 / 3) * U s i 3%Z) = s ^ 2.
Definition instance : Prop :=
exists (s : R),
  0 <= s <= 1.
End uniform_marsden.

Module uniform_marsden_slip.
(* splines/uniform.marsden.slip, Polynomials
   printed: A common slip: s² = sum (i - 1)² U_{i,3}
   stated: sum(i, 0, 3, (i - 1)^2*U[i,3](s)) == s^2 *)
Definition statement : Prop :=
forall (s : R),
  0 <= s <= 1 ->
  sum 0%Z 3%Z (fun i => (IZR i - 1) ^ 2 * U s i 3%Z) = s ^ 2.
End uniform_marsden_slip.

Module knots_greville.
(* splines/knots.greville, Polynomials
   printed: x = sum (t_{i+1} + t_{i+2})/2 N_{i,2} for degree 2 on the span of t_2 and t_3
   stated: sum(i, 0, 2, (t[i+1] + t[i+2])/2*N[i,2](x, 2)) == x *)
Definition statement : Prop :=
forall (t : Z -> R) (x : R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i + 1 <= 7)%Z) ->
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i + 2 <= 7)%Z) ->
  (forall i : Z, (0 <= i <= 2)%Z -> t 3%Z - t 2%Z <> 0) ->
  (forall i : Z, (0 <= i <= 2)%Z -> t 3%Z - t 1%Z <> 0) ->
  (forall i : Z, (0 <= i <= 2)%Z -> t 4%Z - t 2%Z <> 0) ->
  sum 0%Z 2%Z (fun i => (t (i + 1)%Z + t (i + 2)%Z) / 2 * N_ t x 2%Z i 2%Z) = x.
Definition instance : Prop :=
exists (t : Z -> R) (x : R),
  t 1%Z < t 2%Z /\
  t 2%Z < t 3%Z /\
  t 3%Z < t 4%Z /\
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i + 1 <= 7)%Z) /\
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i + 2 <= 7)%Z) /\
  (forall i : Z, (0 <= i <= 2)%Z -> t 3%Z - t 2%Z <> 0) /\
  (forall i : Z, (0 <= i <= 2)%Z -> t 3%Z - t 1%Z <> 0) /\
  (forall i : Z, (0 <= i <= 2)%Z -> t 4%Z - t 2%Z <> 0).
End knots_greville.

Module knots_marsden.
(* splines/knots.marsden, Polynomials
   printed: Marsden, degree 2 on the span of t_2 and t_3: (y - x)² = sum (y - t_{i+1})(y - t_{i+2}) N_{i,2}
   stated: sum(i, 0, 2, (y - t[i+1])*(y - t[i+2])*N[i,2](x, 2)) == (y - x)^2 *)
Definition statement : Prop :=
forall (t : Z -> R) (x : R) (y : R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i + 1 <= 7)%Z) ->
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i + 2 <= 7)%Z) ->
  (forall i : Z, (0 <= i <= 2)%Z -> t 3%Z - t 2%Z <> 0) ->
  (forall i : Z, (0 <= i <= 2)%Z -> t 3%Z - t 1%Z <> 0) ->
  (forall i : Z, (0 <= i <= 2)%Z -> t 4%Z - t 2%Z <> 0) ->
  sum 0%Z 2%Z (fun i => (y - t (i + 1)%Z) * (y - t (i + 2)%Z) * N_ t x 2%Z i 2%Z) = (y - x) ^ 2.
Definition instance : Prop :=
exists (t : Z -> R) (x : R) (y : R),
  t 1%Z < t 2%Z /\
  t 2%Z < t 3%Z /\
  t 3%Z < t 4%Z /\
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i + 1 <= 7)%Z) /\
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= i + 2 <= 7)%Z) /\
  (forall i : Z, (0 <= i <= 2)%Z -> t 3%Z - t 2%Z <> 0) /\
  (forall i : Z, (0 <= i <= 2)%Z -> t 3%Z - t 1%Z <> 0) /\
  (forall i : Z, (0 <= i <= 2)%Z -> t 4%Z - t 2%Z <> 0).
End knots_marsden.

Module knots_marsden_cubic.
(* splines/knots.marsden.cubic, Polynomials
   printed: Marsden, degree 3 on the span of t_3 and t_4: (y - x)³ = sum (y - t_{i+1})(y - t_{i+2})(y - t_{i+3}) N_{i,3}
   stated: sum(i, 0, 3, (y - t[i+1])*(y - t[i+2])*(y - t[i+3])*N[i,3](x, 3)) == (y - x)^3 *)
Definition statement : Prop :=
forall (t : Z -> R) (x : R) (y : R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  t 4%Z < t 5%Z ->
  t 5%Z < t 6%Z ->
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i + 1 <= 7)%Z) ->
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i + 2 <= 7)%Z) ->
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i + 3 <= 7)%Z) ->
  (forall i : Z, (0 <= i <= 3)%Z -> t 4%Z - t 3%Z <> 0) ->
  (forall i : Z, (0 <= i <= 3)%Z -> t 4%Z - t 2%Z <> 0) ->
  (forall i : Z, (0 <= i <= 3)%Z -> t 5%Z - t 3%Z <> 0) ->
  (forall i : Z, (0 <= i <= 3)%Z -> t 4%Z - t 1%Z <> 0) ->
  (forall i : Z, (0 <= i <= 3)%Z -> t 5%Z - t 2%Z <> 0) ->
  (forall i : Z, (0 <= i <= 3)%Z -> t 6%Z - t 3%Z <> 0) ->
  sum 0%Z 3%Z (fun i => (y - t (i + 1)%Z) * (y - t (i + 2)%Z) * (y - t (i + 3)%Z) * N_ t x 3%Z i 3%Z) = (y - x) ^ 3.
Definition instance : Prop :=
exists (t : Z -> R) (x : R) (y : R),
  t 1%Z < t 2%Z /\
  t 2%Z < t 3%Z /\
  t 3%Z < t 4%Z /\
  t 4%Z < t 5%Z /\
  t 5%Z < t 6%Z /\
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i + 1 <= 7)%Z) /\
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i + 2 <= 7)%Z) /\
  (forall i : Z, (0 <= i <= 3)%Z -> (0 <= i + 3 <= 7)%Z) /\
  (forall i : Z, (0 <= i <= 3)%Z -> t 4%Z - t 3%Z <> 0) /\
  (forall i : Z, (0 <= i <= 3)%Z -> t 4%Z - t 2%Z <> 0) /\
  (forall i : Z, (0 <= i <= 3)%Z -> t 5%Z - t 3%Z <> 0) /\
  (forall i : Z, (0 <= i <= 3)%Z -> t 4%Z - t 1%Z <> 0) /\
  (forall i : Z, (0 <= i <= 3)%Z -> t 5%Z - t 2%Z <> 0) /\
  (forall i : Z, (0 <= i <= 3)%Z -> t 6%Z - t 3%Z <> 0).
End knots_marsden_cubic.
