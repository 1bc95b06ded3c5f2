(* What all theorems assume. *)
From Bezier Require Theorems.
From GbtDevelopable Require Theorems.
From GbtSurfaces Require Theorems.
From HermiteDevelopable Require Theorems.
From Hyperbolic Require Theorems.
From Splines Require Theorems.
From Torses Require Theorems.
From Trigonometric Require Theorems.
Definition all_theorems : True :=
let _ := Bezier.Theorems.all_theorems in
let _ := GbtDevelopable.Theorems.all_theorems in
let _ := GbtSurfaces.Theorems.all_theorems in
let _ := HermiteDevelopable.Theorems.all_theorems in
let _ := Hyperbolic.Theorems.all_theorems in
let _ := Splines.Theorems.all_theorems in
let _ := Torses.Theorems.all_theorems in
let _ := Trigonometric.Theorems.all_theorems in
I.
Print Assumptions all_theorems.
