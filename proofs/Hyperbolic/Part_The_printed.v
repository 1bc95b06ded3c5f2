(* Statements of hyperbolic, Part The. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition f (t : R) (a : R) : R :=
  ((exp ((a - t) / 2) - exp (- ((a - t) / 2))) / 2) ^ 2 / ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2.
Definition g (t : R) (a : R) : R :=
  2 * ((exp (a / 2) + exp (- (a / 2))) / 2) * ((exp ((a - t) / 2) - exp (- ((a - t) / 2))) / 2) * ((exp (t / 2) - exp (- (t / 2))) / 2) / ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2.
Definition h (t : R) (a : R) : R :=
  ((exp (t / 2) - exp (- (t / 2))) / 2) ^ 2 / ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2.
End Definitions.
Import Definitions.

Module quadratic_unity.
(* hyperbolic/quadratic.unity, The functions
   printed: f + g + h = 1
   stated: f(t, a) + g(t, a) + h(t, a) == 1 *)
Definition statement : Prop :=
forall (a : R) (t : R),
  0 < a ->
  0 <= t ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  f t a + g t a + h t a = 1.
Definition instance : Prop :=
exists (a : R) (t : R),
  0 < a /\
  0 <= t /\
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0.
End quadratic_unity.

Module quadratic_symmetry.
(* hyperbolic/quadratic.symmetry, The functions
   printed: f(a - t) = h(t), g(a - t) = g(t)
   stated: f(a - t, a) == h(t, a) and g(a - t, a) == g(t, a) *)
Definition statement : Prop :=
forall (a : R) (t : R),
  0 < a ->
  0 <= t ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  f (a - t) a = h t a /\ g (a - t) a = g t a.
Definition instance : Prop :=
exists (a : R) (t : R),
  0 < a /\
  0 <= t /\
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0.
End quadratic_symmetry.

Module quadratic_ends.
(* hyperbolic/quadratic.ends, The functions
   printed: f(0) = 1, g(0) = h(0) = 0
   stated: f(0, a) == 1 and g(0, a) == 0 and h(0, a) == 0 *)
Definition statement : Prop :=
forall (a : R),
  0 < a ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  f 0 a = 1 /\ g 0 a = 0 /\ h 0 a = 0.
Definition instance : Prop :=
exists (a : R),
  0 < a /\
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0.
End quadratic_ends.

Module quadratic_nonnegative.
(* hyperbolic/quadratic.nonnegative, The functions
   printed: f, g, h >= 0 for 0 <= t <= a
   stated: f(t, a) >= 0 and g(t, a) >= 0 and h(t, a) >= 0 *)
Definition statement : Prop :=
forall (a : R) (t : R),
  0 < a ->
  0 <= t ->
  t <= a ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  f t a >= 0 /\ g t a >= 0 /\ h t a >= 0.
Definition instance : Prop :=
exists (a : R) (t : R),
  0 < a /\
  0 <= t /\
  t <= a /\
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0.
End quadratic_nonnegative.

Module quadratic_nonnegative_slip.
(* hyperbolic/quadratic.nonnegative.slip, The functions
   printed: A common slip: g >= 0 for all t >= 0
   stated: g(t, a) >= 0 *)
Definition statement : Prop :=
forall (a : R) (t : R),
  0 < a ->
  0 <= t ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  g t a >= 0.
End quadratic_nonnegative_slip.

Module quadratic_decreasing.
(* hyperbolic/quadratic.decreasing, The functions
   printed: f decreases: f' <= 0 for 0 <= t <= a
   stated: f'(t, a) <= 0 *)
Definition statement : Prop :=
forall (a : R) (t : R),
  0 < a ->
  0 <= t ->
  t <= a ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  Derive_n (fun t => f t a) 1 t <= 0.
Definition instance : Prop :=
exists (a : R) (t : R),
  0 < a /\
  0 <= t /\
  t <= a /\
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0.
End quadratic_decreasing.

Module quadratic_largest.
(* hyperbolic/quadratic.largest, The functions
   printed: h <= 1 for 0 <= t <= a
   stated: h(t, a) <= 1 *)
Definition statement : Prop :=
forall (a : R) (t : R),
  0 < a ->
  0 <= t ->
  t <= a ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  h t a <= 1.
Definition instance : Prop :=
exists (a : R) (t : R),
  0 < a /\
  0 <= t /\
  t <= a /\
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0.
End quadratic_largest.

Module quadratic_space.
(* hyperbolic/quadratic.space, The functions
   printed: f''' = f', g''' = g', h''' = h'
   stated: f'''(t, a) == f'(t, a) and g'''(t, a) == g'(t, a) and h'''(t, a) == h'(t, a) *)
Definition statement : Prop :=
forall (a : R) (t : R),
  0 < a ->
  0 <= t ->
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0 ->
  Derive_n (fun t => f t a) 3 t = Derive_n (fun t => f t a) 1 t /\ Derive_n (fun t => g t a) 3 t = Derive_n (fun t => g t a) 1 t /\ Derive_n (fun t => h t a) 3 t = Derive_n (fun t => h t a) 1 t.
Definition instance : Prop :=
exists (a : R) (t : R),
  0 < a /\
  0 <= t /\
  ((exp (a / 2) - exp (- (a / 2))) / 2) ^ 2 <> 0.
End quadratic_space.

Module shape_unity.
(* hyperbolic/shape.unity, The functions
   printed: The functions of every degree k add up to 1.
   stated: sum(i, 0, k, h[i,k](u)) == 1 *)
Definition h (u : R) (omega : R) (i : Z) (k : Z) : R :=
  basis (1 - u) u [((exp (omega * (1 - u) / 2) - exp (- (omega * (1 - u) / 2))) / 2) ^ 2 / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2; 2 * ((exp (omega / 2) + exp (- (omega / 2))) / 2) * ((exp (omega * (1 - u) / 2) - exp (- (omega * (1 - u) / 2))) / 2) * ((exp (omega * u / 2) - exp (- (omega * u / 2))) / 2) / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2; ((exp (omega * u / 2) - exp (- (omega * u / 2))) / 2) ^ 2 / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2] i k.
Definition statement : Prop :=
forall (k : Z) (omega : R) (u : R),
  (2 <= k)%Z ->
  0 < omega ->
  0 <= u <= 1 ->
  (forall i : Z, (0 <= i <= k)%Z -> ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2 <> 0) ->
  sum 0%Z k (fun i => h u omega i k) = 1.
Definition instance : Prop :=
exists (k : Z) (omega : R) (u : R),
  (2 <= k)%Z /\
  0 < omega /\
  0 <= u <= 1 /\
  (forall i : Z, (0 <= i <= k)%Z -> ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2 <> 0).
End shape_unity.

Module shape_symmetry.
(* hyperbolic/shape.symmetry, The functions
   printed: h_{i,4}(1 - u) = h_{4-i,4}(u)
   stated: h[i,4](1 - u) == h[4-i,4](u) *)
Definition h (u : R) (omega : R) (i : Z) (k : Z) : R :=
  basis (1 - u) u [((exp (omega * (1 - u) / 2) - exp (- (omega * (1 - u) / 2))) / 2) ^ 2 / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2; 2 * ((exp (omega / 2) + exp (- (omega / 2))) / 2) * ((exp (omega * (1 - u) / 2) - exp (- (omega * (1 - u) / 2))) / 2) * ((exp (omega * u / 2) - exp (- (omega * u / 2))) / 2) / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2; ((exp (omega * u / 2) - exp (- (omega * u / 2))) / 2) ^ 2 / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2] i k.
Definition statement : Prop :=
forall (i : Z) (omega : R) (u : R),
  (0 <= i <= 4)%Z ->
  0 < omega ->
  0 <= u <= 1 ->
  ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2 <> 0 ->
  h (1 - u) omega i 4%Z = h u omega (4 - i)%Z 4%Z.
Definition instance : Prop :=
exists (i : Z) (omega : R) (u : R),
  (0 <= i <= 4)%Z /\
  0 < omega /\
  0 <= u <= 1 /\
  ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2 <> 0.
End shape_symmetry.

Module shape_nonnegative.
(* hyperbolic/shape.nonnegative, The functions
   printed: h_{i,k}(u) >= 0 for 0 <= u <= 1
   stated: nonnegative(h) *)
Definition h (u : R) (omega : R) (i : Z) (k : Z) : R :=
  basis (1 - u) u [((exp (omega * (1 - u) / 2) - exp (- (omega * (1 - u) / 2))) / 2) ^ 2 / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2; 2 * ((exp (omega / 2) + exp (- (omega / 2))) / 2) * ((exp (omega * (1 - u) / 2) - exp (- (omega * (1 - u) / 2))) / 2) * ((exp (omega * u / 2) - exp (- (omega * u / 2))) / 2) / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2; ((exp (omega * u / 2) - exp (- (omega * u / 2))) / 2) ^ 2 / ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2] i k.
Definition statement : Prop :=
forall (omega : R),
  0 < omega ->
  ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2 <> 0 ->
  forall u : R, 0 <= u <= 1 -> forall i k : Z, (2 <= k)%Z -> 0 <= h u omega i k.
Definition instance : Prop :=
exists (omega : R),
  0 < omega /\
  ((exp (omega / 2) - exp (- (omega / 2))) / 2) ^ 2 <> 0.
End shape_nonnegative.
