#pragma once

#include <string_view>

namespace breccia::test {

/// The model composite of the paper (its Fig. 2 and Table 1), coarse. It needs no other file.
inline constexpr std::string_view model_deck = R"(title = "Model composite"

[materials.binder]
density = "1 g/cm^3"
bulk    = "1 MPa"
shear   = { terms = [{ time = "10 ms", modulus = "0.5 MPa" }] }

[materials.particle]
density = "1.5 g/cm^3"
bulk    = "50 MPa"
shear   = "18.8 MPa"

[[stages]]
name    = "A"
matrix  = "binder"
box     = "6 mm"
cells   = 24
filler  = { material = "particle", sizes = { diameter = "2 mm" } }
packing = { method = "regular", columns = 2, rows = 2 }

[tests]
loads = ["shear"]
times      = ["1 ms", "50 ms"]
boundaries     = ["displacement"]
method     = "dynamic"
volumetric = "standard"
)";

/// A box of nothing but a matrix that relaxes as 0.5 MPa exp(-t / 10 ms) in shear and not at all in bulk, K = 1 MPa.
inline constexpr std::string_view homogeneous_deck = R"(title = "Homogeneous box"

[materials.binder]
density = "1 g/cm^3"
bulk    = "1 MPa"
shear   = { terms = [{ time = "10 ms", modulus = "0.5 MPa" }] }

[[stages]]
name    = "A"
matrix  = "binder"
box     = "6 mm"
cells   = 24

[tests]
loads = ["shear"]
times  = ["1 ms", "50 ms"]
boundaries = ["displacement"]
method = "dynamic"
)";

}  // namespace breccia::test
