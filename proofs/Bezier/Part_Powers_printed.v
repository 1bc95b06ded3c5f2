(* Statements of bezier, Part Powers. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module power_next.
(* bezier/power.next, Powers
   printed: (1 - x)^m (1 - x) = (1 - x)^{m+1}
   stated: (1 - x)^m*(1 - x) == (1 - x)^(m + 1) *)
Definition statement : Prop :=
forall (m : Z) (x : R),
  (3 <= m)%Z ->
  0 <= x <= 1 ->
  (0 <= m)%Z \/ 1 - x <> 0 ->
  (0 <= (m + 1)%Z)%Z \/ 1 - x <> 0 ->
  powerRZ (1 - x) m * (1 - x) = powerRZ (1 - x) (m + 1)%Z.
Definition instance : Prop :=
exists (m : Z) (x : R),
  (3 <= m)%Z /\
  0 <= x <= 1 /\
  ((0 <= m)%Z \/ 1 - x <> 0) /\
  ((0 <= (m + 1)%Z)%Z \/ 1 - x <> 0).
End power_next.

Module power_rate.
(* bezier/power.rate, Powers
   printed: The derivative of (1 - x)^m is -m (1 - x)^{m-1}.
   stated: D((1 - x)^m, x) == -m*(1 - x)^(m - 1) *)
Definition statement : Prop :=
forall (m : Z) (x : R),
  (3 <= m)%Z ->
  0 <= x <= 1 ->
  locally x (fun x => (0 <= m)%Z \/ 1 - x <> 0) ->
  ex_derive_n (fun x => powerRZ (1 - x) m) 1 x ->
  (0 <= (m - 1)%Z)%Z \/ 1 - x <> 0 ->
  Derive_n (fun x => powerRZ (1 - x) m) 1 x = - IZR m * powerRZ (1 - x) (m - 1)%Z.
Definition instance : Prop :=
exists (m : Z) (x : R),
  (3 <= m)%Z /\
  0 <= x <= 1 /\
  locally x (fun x => (0 <= m)%Z \/ 1 - x <> 0) /\
  ex_derive_n (fun x => powerRZ (1 - x) m) 1 x /\
  ((0 <= (m - 1)%Z)%Z \/ 1 - x <> 0).
End power_rate.

Module power_rate_slip.
(* bezier/power.rate.slip, Powers
   printed: A common slip: the derivative of (1 - x)^m is m (1 - x)^{m-1}.
   stated: D((1 - x)^m, x) == m*(1 - x)^(m - 1) *)
Definition statement : Prop :=
forall (m : Z) (x : R),
  (3 <= m)%Z ->
  0 <= x <= 1 ->
  locally x (fun x => (0 <= m)%Z \/ 1 - x <> 0) ->
  ex_derive_n (fun x => powerRZ (1 - x) m) 1 x ->
  (0 <= (m - 1)%Z)%Z \/ 1 - x <> 0 ->
  Derive_n (fun x => powerRZ (1 - x) m) 1 x = IZR m * powerRZ (1 - x) (m - 1)%Z.
End power_rate_slip.

Module power_rate_slip_corrected.
(* bezier/power.rate.slip (corrected), Powers
   printed: A common slip: the derivative of (1 - x)^m is m (1 - x)^{m-1}.
   stated: D((1 - x)^m, x) == -(m*(1 - x)^(m - 1)) *)
Definition statement : Prop :=
forall (m : Z) (x : R),
  (3 <= m)%Z ->
  0 <= x <= 1 ->
  locally x (fun x => (0 <= m)%Z \/ 1 - x <> 0) ->
  ex_derive_n (fun x => powerRZ (1 - x) m) 1 x ->
  (0 <= (m - 1)%Z)%Z \/ 1 - x <> 0 ->
  Derive_n (fun x => powerRZ (1 - x) m) 1 x = - (IZR m * powerRZ (1 - x) (m - 1)%Z).
Definition instance : Prop :=
exists (m : Z) (x : R),
  (3 <= m)%Z /\
  0 <= x <= 1 /\
  locally x (fun x => (0 <= m)%Z \/ 1 - x <> 0) /\
  ex_derive_n (fun x => powerRZ (1 - x) m) 1 x /\
  ((0 <= (m - 1)%Z)%Z \/ 1 - x <> 0).
End power_rate_slip_corrected.

Module power_product.
(* bezier/power.product, Powers
   printed: (a b)^m a^k = a^{m+k} b^m
   stated: (a*b)^m*a^k == a^(m + k)*b^m *)
Definition statement : Prop :=
forall (k : Z) (m : Z) (a : R) (b : R),
  (0 <= k)%Z ->
  (3 <= m)%Z ->
  (0 <= m)%Z \/ a * b <> 0 ->
  (0 <= k)%Z \/ a <> 0 ->
  (0 <= (m + k)%Z)%Z \/ a <> 0 ->
  (0 <= m)%Z \/ b <> 0 ->
  powerRZ (a * b) m * powerRZ a k = powerRZ a (m + k)%Z * powerRZ b m.
Definition instance : Prop :=
exists (k : Z) (m : Z) (a : R) (b : R),
  (0 <= k)%Z /\
  (3 <= m)%Z /\
  ((0 <= m)%Z \/ a * b <> 0) /\
  ((0 <= k)%Z \/ a <> 0) /\
  ((0 <= (m + k)%Z)%Z \/ a <> 0) /\
  ((0 <= m)%Z \/ b <> 0).
End power_product.

Module power_ends.
(* bezier/power.ends, Powers
   printed: B_{0,m}(x) = (1 - x)^m and B_{m,m}(x) = x^m
   stated: B[0,m](x) == (1 - x)^m and B[m,m](x) == x^m *)
Definition B (x : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [1] i k.
Definition statement : Prop :=
forall (m : Z) (x : R),
  (3 <= m)%Z ->
  0 <= x <= 1 ->
  (0 <= m)%Z ->
  (0 <= m)%Z \/ 1 - x <> 0 ->
  (0 <= m)%Z \/ x <> 0 ->
  B x 0%Z m = powerRZ (1 - x) m /\ B x m m = powerRZ x m.
Definition instance : Prop :=
exists (m : Z) (x : R),
  (3 <= m)%Z /\
  0 <= x <= 1 /\
  (0 <= m)%Z /\
  ((0 <= m)%Z \/ 1 - x <> 0) /\
  ((0 <= m)%Z \/ x <> 0).
End power_ends.

Module power_binomial.
(* bezier/power.binomial, Powers
   printed: Σ binom(m, j) u^{m-j} v^j = (u + v)^m
   stated: sum(j, 0, m, binom(m, j)*u^(m - j)*v^j) == (u + v)^m *)
Definition statement : Prop :=
forall (m : Z) (u : R) (v : R),
  (3 <= m)%Z ->
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= (m - j)%Z)%Z \/ u <> 0) ->
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= j)%Z \/ v <> 0) ->
  (0 <= m)%Z \/ u + v <> 0 ->
  sum 0%Z m (fun j => binom (IZR m) j * powerRZ u (m - j)%Z * powerRZ v j) = powerRZ (u + v) m.
Definition instance : Prop :=
exists (m : Z) (u : R) (v : R),
  (3 <= m)%Z /\
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= (m - j)%Z)%Z \/ u <> 0) /\
  (forall j : Z, (0 <= j <= m)%Z -> (0 <= j)%Z \/ v <> 0) /\
  ((0 <= m)%Z \/ u + v <> 0).
End power_binomial.
