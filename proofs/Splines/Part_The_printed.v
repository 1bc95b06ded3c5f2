(* Statements of splines, Part The. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition N_ (t : Z -> R) (x : R) (j : Z) (i : Z) (k : Z) : R :=
  counted (fun i k => (t (j + i + 1)%Z - x) / (t (j + i + 1)%Z - t (j + i + 1 - k)%Z)) (fun i k => (x - t (j + i - k)%Z) / (t (j + i)%Z - t (j + i - k)%Z)) [1] i k.
End Definitions.
Import Definitions.

Module knots_linear.
(* splines/knots.linear, The functions
   printed: Degree 1 on the span of t_2 and t_3: (t_3 - x)/(t_3 - t_2), (x - t_2)/(t_3 - t_2)
   stated: [N[0,1](x, 2), N[1,1](x, 2)] == [(t[3] - x)/(t[3] - t[2]), (x - t[2])/(t[3] - t[2])] *)
Definition statement : Prop :=
forall (t : Z -> R) (x : R),
  t 2%Z < t 3%Z ->
  t 3%Z - t 2%Z <> 0 ->
  [N_ t x 2%Z 0%Z 1%Z; N_ t x 2%Z 1%Z 1%Z] = [(t 3%Z - x) / (t 3%Z - t 2%Z); (x - t 2%Z) / (t 3%Z - t 2%Z)].
Definition instance : Prop :=
exists (t : Z -> R) (x : R),
  t 2%Z < t 3%Z /\
  t 3%Z - t 2%Z <> 0.
End knots_linear.

Module knots_quadratic.
(* splines/knots.quadratic, The functions
   printed: N_{0,2} = (t_3 - x)²/((t_3 - t_1)(t_3 - t_2)) on the span of t_2 and t_3
   stated: N[0,2](x, 2) == (t[3] - x)^2/((t[3] - t[1])*(t[3] - t[2])) *)
Definition statement : Prop :=
forall (t : Z -> R) (x : R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  t 3%Z - t 2%Z <> 0 ->
  t 3%Z - t 1%Z <> 0 ->
  t 4%Z - t 2%Z <> 0 ->
  (t 3%Z - t 1%Z) * (t 3%Z - t 2%Z) <> 0 ->
  N_ t x 2%Z 0%Z 2%Z = (t 3%Z - x) ^ 2 / ((t 3%Z - t 1%Z) * (t 3%Z - t 2%Z)).
Definition instance : Prop :=
exists (t : Z -> R) (x : R),
  t 1%Z < t 2%Z /\
  t 2%Z < t 3%Z /\
  t 3%Z < t 4%Z /\
  t 3%Z - t 2%Z <> 0 /\
  t 3%Z - t 1%Z <> 0 /\
  t 4%Z - t 2%Z <> 0 /\
  (t 3%Z - t 1%Z) * (t 3%Z - t 2%Z) <> 0.
End knots_quadratic.

Module knots_quadratic_slip.
(* splines/knots.quadratic.slip, The functions
   printed: A common slip: N_{0,2} = (t_3 - x)²/((t_3 - t_1)(t_2 - t_1))
   stated: N[0,2](x, 2) == (t[3] - x)^2/((t[3] - t[1])*(t[2] - t[1])) *)
Definition statement : Prop :=
forall (t : Z -> R) (x : R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  t 3%Z - t 2%Z <> 0 ->
  t 3%Z - t 1%Z <> 0 ->
  t 4%Z - t 2%Z <> 0 ->
  (t 3%Z - t 1%Z) * (t 2%Z - t 1%Z) <> 0 ->
  N_ t x 2%Z 0%Z 2%Z = (t 3%Z - x) ^ 2 / ((t 3%Z - t 1%Z) * (t 2%Z - t 1%Z)).
End knots_quadratic_slip.

Module knots_quadratic_slip_corrected.
(* splines/knots.quadratic.slip (corrected), The functions
   printed: A common slip: N_{0,2} = (t_3 - x)²/((t_3 - t_1)(t_2 - t_1))
   stated: N[0,2](x, 2) == -((t[3] - x)^2/((t[3] - t[1])*(t[2] - t[3]))) *)
Definition statement : Prop :=
forall (t : Z -> R) (x : R),
  t 1%Z < t 2%Z ->
  t 2%Z < t 3%Z ->
  t 3%Z < t 4%Z ->
  t 3%Z - t 2%Z <> 0 ->
  t 3%Z - t 1%Z <> 0 ->
  t 4%Z - t 2%Z <> 0 ->
  (t 3%Z - t 1%Z) * (t 2%Z - t 3%Z) <> 0 ->
  N_ t x 2%Z 0%Z 2%Z = - ((t 3%Z - x) ^ 2 / ((t 3%Z - t 1%Z) * (t 2%Z - t 3%Z))).
Definition instance : Prop :=
exists (t : Z -> R) (x : R),
  t 1%Z < t 2%Z /\
  t 2%Z < t 3%Z /\
  t 3%Z < t 4%Z /\
  t 3%Z - t 2%Z <> 0 /\
  t 3%Z - t 1%Z <> 0 /\
  t 4%Z - t 2%Z <> 0 /\
  (t 3%Z - t 1%Z) * (t 2%Z - t 3%Z) <> 0.
End knots_quadratic_slip_corrected.

Module knots_span.
(* splines/knots.span, The functions
   printed: On every span t_j, t_{j+1} the functions of degree 2 add up to 1, for j = 2 and j = 3.
   stated: sum(i, 0, 2, N[i,2](x, j)) == 1 *)
Definition statement : Prop :=
forall (j : Z) (t : Z -> R) (x : R),
  (2 <= j <= 3)%Z ->
  (0 <= j - 1 <= 7)%Z ->
  (0 <= j <= 7)%Z ->
  t (j - 1)%Z < t j ->
  (0 <= j + 1 <= 7)%Z ->
  t j < t (j + 1)%Z ->
  (0 <= j + 2 <= 7)%Z ->
  t (j + 1)%Z < t (j + 2)%Z ->
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= j + 0 + 1 <= 7)%Z) ->
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= j + 0 + 1 - 1 <= 7)%Z) ->
  (forall i : Z, (0 <= i <= 2)%Z -> t (j + 0 + 1)%Z - t (j + 0 + 1 - 1)%Z <> 0) ->
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= j + 1 - 1 <= 7)%Z) ->
  (forall i : Z, (0 <= i <= 2)%Z -> t (j + 1)%Z - t (j + 1 - 1)%Z <> 0) ->
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= j + 0 + 1 - 2 <= 7)%Z) ->
  (forall i : Z, (0 <= i <= 2)%Z -> t (j + 0 + 1)%Z - t (j + 0 + 1 - 2)%Z <> 0) ->
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= j + 1 + 1 <= 7)%Z) ->
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= j + 1 + 1 - 2 <= 7)%Z) ->
  (forall i : Z, (0 <= i <= 2)%Z -> t (j + 1 + 1)%Z - t (j + 1 + 1 - 2)%Z <> 0) ->
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= j + 1 - 2 <= 7)%Z) ->
  (forall i : Z, (0 <= i <= 2)%Z -> t (j + 1)%Z - t (j + 1 - 2)%Z <> 0) ->
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= j + 2 - 2 <= 7)%Z) ->
  (forall i : Z, (0 <= i <= 2)%Z -> t (j + 2)%Z - t (j + 2 - 2)%Z <> 0) ->
  sum 0%Z 2%Z (fun i => N_ t x j i 2%Z) = 1.
Definition instance : Prop :=
exists (j : Z) (t : Z -> R) (x : R),
  (2 <= j <= 3)%Z /\
  (0 <= j - 1 <= 7)%Z /\
  (0 <= j <= 7)%Z /\
  t (j - 1)%Z < t j /\
  (0 <= j + 1 <= 7)%Z /\
  t j < t (j + 1)%Z /\
  (0 <= j + 2 <= 7)%Z /\
  t (j + 1)%Z < t (j + 2)%Z /\
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= j + 0 + 1 <= 7)%Z) /\
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= j + 0 + 1 - 1 <= 7)%Z) /\
  (forall i : Z, (0 <= i <= 2)%Z -> t (j + 0 + 1)%Z - t (j + 0 + 1 - 1)%Z <> 0) /\
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= j + 1 - 1 <= 7)%Z) /\
  (forall i : Z, (0 <= i <= 2)%Z -> t (j + 1)%Z - t (j + 1 - 1)%Z <> 0) /\
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= j + 0 + 1 - 2 <= 7)%Z) /\
  (forall i : Z, (0 <= i <= 2)%Z -> t (j + 0 + 1)%Z - t (j + 0 + 1 - 2)%Z <> 0) /\
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= j + 1 + 1 <= 7)%Z) /\
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= j + 1 + 1 - 2 <= 7)%Z) /\
  (forall i : Z, (0 <= i <= 2)%Z -> t (j + 1 + 1)%Z - t (j + 1 + 1 - 2)%Z <> 0) /\
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= j + 1 - 2 <= 7)%Z) /\
  (forall i : Z, (0 <= i <= 2)%Z -> t (j + 1)%Z - t (j + 1 - 2)%Z <> 0) /\
  (forall i : Z, (0 <= i <= 2)%Z -> (0 <= j + 2 - 2 <= 7)%Z) /\
  (forall i : Z, (0 <= i <= 2)%Z -> t (j + 2)%Z - t (j + 2 - 2)%Z <> 0).
End knots_span.
