(* Statements of hermite-developable, Section 1. Nothing is proved here. *)
From Torse Require Import Defs.
Open Scope R_scope.

Module sec_1_parallel_tangents.
(* hermite-developable/sec-1.parallel-tangents, Sect. 1, second paragraph (on Aumann [1])
   printed: the patch was placed in parallel planes, and the curves' tangent vectors must be parallel
   read as: p' and q' at one u, in planes x = const at the distance h; developable by Definition 3.2
   stated: cross(dp, dq) == det([dp, dq, ruling])/h*[1, 0, 0] *)
Definition dp (y1 : R) (z1 : R) : list R :=
  [0; y1; z1].
Definition dq (y2 : R) (z2 : R) : list R :=
  [0; y2; z2].
Definition ruling (gy : R) (gz : R) (h : R) : list R :=
  [h; gy; gz].
Definition statement : Prop :=
forall (gy : R) (gz : R) (h : R) (y1 : R) (y2 : R) (z1 : R) (z2 : R),
  h <> 0 ->
  cross (dp y1 z1) (dq y2 z2) = vscale (det [dp y1 z1; dq y2 z2; ruling gy gz h] / h) [1; 0; 0].
Definition instance : Prop :=
exists (gy : R) (gz : R) (h : R) (y1 : R) (y2 : R) (z1 : R) (z2 : R),
  h <> 0.
End sec_1_parallel_tangents.
