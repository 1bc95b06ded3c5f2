(* Statements of hyperbolic, Part Catenoid. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module Definitions.
Definition X (u : R) (v : R) : list R :=
  [(exp v + exp (- v)) / 2 * cos u; (exp v + exp (- v)) / 2 * sin u; v].
End Definitions.
Import Definitions.

Module catenoid_conformal.
(* hyperbolic/catenoid.conformal, Catenoid
   printed: X_u·X_u = X_v·X_v and X_u·X_v = 0
   stated: dot(D(X, u)(u, v), D(X, u)(u, v)) == dot(D(X, v)(u, v), D(X, v)(u, v)) and dot(D(X, u)(u, v), D(X, v)(u, v)) == 0 *)
Definition statement : Prop :=
forall (u : R) (v : R),
  dot (vDerive 3 (fun u => X u v) 1 u) (vDerive 3 (fun u => X u v) 1 u) = dot (vDerive 3 (fun v => X u v) 1 v) (vDerive 3 (fun v => X u v) 1 v) /\ dot (vDerive 3 (fun u => X u v) 1 u) (vDerive 3 (fun v => X u v) 1 v) = 0.
End catenoid_conformal.

Module catenoid_minimal.
(* hyperbolic/catenoid.minimal, Catenoid
   printed: X_uu(u, v) + X_vv(u, v) = 0
   stated: D(X, u, 2)(u, v) + D(X, v, 2)(u, v) == 0 *)
Definition statement : Prop :=
forall (u : R) (v : R),
  vadd (vDerive 3 (fun u => X u v) 2 u) (vDerive 3 (fun v => X u v) 2 v) = zeros 3.
End catenoid_minimal.

Module catenoid_gauss.
(* hyperbolic/catenoid.gauss, Catenoid
   printed: det(X_u, X_v, X_uu) det(X_u, X_v, X_vv) - det(X_u, X_v, X_uv)² = -cosh^4 v
   stated: det([D(X, u)(u, v), D(X, v)(u, v), D(X, u, 2)(u, v)])*det([D(X, u)(u, v), D(X, v)(u, v), D(X, v, 2)(u, v)]) - det([D(X, u)(u, v), D(X, v)(u, v), D(D(X, u), v)(u, v)])^2 == -cosh(v)^4 *)
Definition statement : Prop :=
forall (u : R) (v : R),
  det [vDerive 3 (fun u => X u v) 1 u; vDerive 3 (fun v => X u v) 1 v; vDerive 3 (fun u => X u v) 2 u] * det [vDerive 3 (fun u => X u v) 1 u; vDerive 3 (fun v => X u v) 1 v; vDerive 3 (fun v => X u v) 2 v] - det [vDerive 3 (fun u => X u v) 1 u; vDerive 3 (fun v => X u v) 1 v; vDerive 3 (fun v => vDerive 3 (fun u => X u v) 1 u) 1 v] ^ 2 = - ((exp v + exp (- v)) / 2) ^ 4.
End catenoid_gauss.

Module catenoid_regular.
(* hyperbolic/catenoid.regular, Catenoid
   printed: The normal X_u x X_v vanishes nowhere: |X_u x X_v|² > 0
   stated: dot(cross(D(X, u)(u, v), D(X, v)(u, v)), cross(D(X, u)(u, v), D(X, v)(u, v))) > 0 *)
Definition statement : Prop :=
forall (u : R) (v : R),
  dot (cross (vDerive 3 (fun u => X u v) 1 u) (vDerive 3 (fun v => X u v) 1 v)) (cross (vDerive 3 (fun u => X u v) 1 u) (vDerive 3 (fun v => X u v) 1 v)) > 0.
End catenoid_regular.
