(* Statements of gbt-developable, Section 1. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module intro_continuity_free_a.
(* gbt-developable/intro-continuity-free.a, Sect. 1, list of contributions, last item, for the smooth connection (5.5)
   printed: The local and overall shape of a composite developable GBT-Bézier surface with a smooth connection can be accommodated by modifying its shape parameters without re-establishing the control planes.
   read as: 'smooth connection' is checked for each of the paper's three conditions: (5.5), (5.12), (5.16). Here (5.5): the shape parameters of the second family are changed from mu2, nu2 to mu3, nu3, and (5.5) is met again, with another gamma.
   stated: N2(0) == H1(1) and N2'(0) == ratio*H1'(1) *)
Definition g (x : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)); 1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k.
Definition N2 (P2 : Z -> R) (l : Z) (mu3 : R) (nu3 : R) (x : Z) : R :=
  sum 0%Z l (fun i => g (IZR x) mu3 nu3 i l * P2 i).
Definition H1 (P1 : Z -> R) (k : Z) (mu1 : R) (nu1 : R) (x : Z) : R :=
  sum 0%Z k (fun i => g (IZR x) mu1 nu1 i k * P1 i).
Definition N2_ (P2 : Z -> R) (l : Z) (mu3 : R) (nu3 : R) (x : R) : R :=
  sum 0%Z l (fun i => g x mu3 nu3 i l * P2 i).
Definition ratio (gamma : R) (l : Z) (mu2 : R) (mu3 : R) : R :=
  gamma * (2 * (IZR l - 2) + PI * (1 + mu3)) / (2 * (IZR l - 2) + PI * (1 + mu2)).
Definition H1_ (P1 : Z -> R) (k : Z) (mu1 : R) (nu1 : R) (x : R) : R :=
  sum 0%Z k (fun i => g x mu1 nu1 i k * P1 i).
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (mu3 : R) (nu1 : R) (nu3 : R),
  0 < gamma ->
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= mu3 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu3 <= 1 ->
  (0 <= 0 <= l)%Z ->
  (0 <= k <= k)%Z ->
  P2 0%Z = P1 k ->
  (0 <= 1 <= l)%Z ->
  IZR l - 2 + PI / 2 * (1 + mu2) <> 0 ->
  (0 <= k - 1 <= k)%Z ->
  P2 1%Z = P1 k + gamma * (IZR k - 2 + PI / 2 * (1 + nu1)) / (IZR l - 2 + PI / 2 * (1 + mu2)) * (P1 k - P1 (k - 1)%Z) ->
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0 ->
  N2 P2 l mu3 nu3 0%Z = H1 P1 k mu1 nu1 1%Z /\ (let x := 0%Z in Derive_n (fun x_ => N2_ P2 l mu3 nu3 x_) 1 (IZR x)) = ratio gamma l mu2 mu3 * (let x_ := 1%Z in Derive_n (fun x__ => H1_ P1 k mu1 nu1 x__) 1 (IZR x_)).
Definition instance : Prop :=
exists (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (gamma : R) (mu1 : R) (mu2 : R) (mu3 : R) (nu1 : R) (nu3 : R),
  0 < gamma /\
  (2 <= k)%Z /\
  (2 <= l)%Z /\
  (-1) <= mu1 <= 1 /\
  (-1) <= mu2 <= 1 /\
  (-1) <= mu3 <= 1 /\
  (-1) <= nu1 <= 1 /\
  (-1) <= nu3 <= 1 /\
  (0 <= 0 <= l)%Z /\
  (0 <= k <= k)%Z /\
  P2 0%Z = P1 k /\
  (0 <= 1 <= l)%Z /\
  IZR l - 2 + PI / 2 * (1 + mu2) <> 0 /\
  (0 <= k - 1 <= k)%Z /\
  P2 1%Z = P1 k + gamma * (IZR k - 2 + PI / 2 * (1 + nu1)) / (IZR l - 2 + PI / 2 * (1 + mu2)) * (P1 k - P1 (k - 1)%Z) /\
  2 * (IZR l - 2) + PI * (1 + mu2) <> 0.
End intro_continuity_free_a.

Module intro_continuity_free_b.
(* gbt-developable/intro-continuity-free.b, Sect. 1, list of contributions, last item, for the smooth connection (5.12)
   printed: The local and overall shape of a composite developable GBT-Bézier surface with a smooth connection can be accommodated by modifying its shape parameters without re-establishing the control planes.
   read as: 'smooth connection' is checked for each of the paper's three conditions: (5.5), (5.12), (5.16). Here (5.12), by (5.11): the shape parameters of the second family are changed from mu2, nu2 to mu3, nu3, and the derivatives still agree.
   stated: N2'(0) == H1'(1) and N2''(0) == H1''(1) *)
Definition g (x : R) (mu : R) (nu : R) (i : Z) (k : Z) : R :=
  basis (1 - x) x [(1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)); 1 - (1 - sin (PI / 2 * x)) * (1 - mu * sin (PI / 2 * x)) - (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x)); (1 - cos (PI / 2 * x)) * (1 - nu * cos (PI / 2 * x))] i k.
Definition H2 (P2 : Z -> R) (l : Z) (mu2 : R) (nu2 : R) (x : Z) : R :=
  sum 0%Z l (fun i => g (IZR x) mu2 nu2 i l * P2 i).
Definition H1 (P1 : Z -> R) (k : Z) (mu1 : R) (nu1 : R) (x : Z) : R :=
  sum 0%Z k (fun i => g (IZR x) mu1 nu1 i k * P1 i).
Definition H2_ (P2 : Z -> R) (l : Z) (mu2 : R) (nu2 : R) (x : R) : R :=
  sum 0%Z l (fun i => g x mu2 nu2 i l * P2 i).
Definition H1_ (P1 : Z -> R) (k : Z) (mu1 : R) (nu1 : R) (x : R) : R :=
  sum 0%Z k (fun i => g x mu1 nu1 i k * P1 i).
Definition N2 (P2 : Z -> R) (l : Z) (mu3 : R) (nu3 : R) (x : R) : R :=
  sum 0%Z l (fun i => g x mu3 nu3 i l * P2 i).
Definition statement : Prop :=
forall (k : Z) (l : Z) (P1 : Z -> R) (P2 : Z -> R) (mu1 : R) (mu2 : R) (mu3 : R) (nu1 : R) (nu2 : R) (nu3 : R),
  (2 <= k)%Z ->
  (2 <= l)%Z ->
  (-1) <= mu1 <= 1 ->
  (-1) <= mu2 <= 1 ->
  (-1) <= mu3 <= 1 ->
  (-1) <= nu1 <= 1 ->
  (-1) <= nu2 <= 1 ->
  (-1) <= nu3 <= 1 ->
  IZR k = 3 ->
  IZR l = 3 ->
  H2 P2 l mu2 nu2 0%Z = H1 P1 k mu1 nu1 1%Z ->
  (let x := 0%Z in Derive_n (fun x_ => H2_ P2 l mu2 nu2 x_) 1 (IZR x)) = (let x_ := 1%Z in Derive_n (fun x__ => H1_ P1 k mu1 nu1 x__) 1 (IZR x_)) ->
  (let x__ := 0%Z in Derive_n (fun x___ => H2_ P2 l mu2 nu2 x___) 2 (IZR x__)) = (let x___ := 1%Z in Derive_n (fun x____ => H1_ P1 k mu1 nu1 x____) 2 (IZR x___)) ->
  (let x____ := 0%Z in Derive_n (fun x_____ => N2 P2 l mu3 nu3 x_____) 1 (IZR x____)) = (let x_____ := 1%Z in Derive_n (fun x______ => H1_ P1 k mu1 nu1 x______) 1 (IZR x_____)) /\ (let x______ := 0%Z in Derive_n (fun x_______ => N2 P2 l mu3 nu3 x_______) 2 (IZR x______)) = (let x_______ := 1%Z in Derive_n (fun x________ => H1_ P1 k mu1 nu1 x________) 2 (IZR x_______)).
End intro_continuity_free_b.
