#pragma once

#include <string_view>

namespace breccia::test {

/// A binder that relaxes, and discs with an interphase whose shear modulus is not known.
inline constexpr std::string_view coated_discs = R"(title = "Coated discs"

[materials.binder]
density = "1 g/cm^3"
bulk    = "3 GPa"
shear   = { equilibrium = "1 MPa", terms = [
  { time = "100 us", modulus = "500 MPa" }, { time = "1 ms", modulus = "300 MPa" }, { time = "10 ms", modulus = "90 MPa" }] }

[materials.glass]
density = "2.5 g/cm^3"
bulk    = "40 GPa"
shear   = "30 GPa"

[materials.interphase]
density = "1.2 g/cm^3"
bulk    = "2 GPa"
shear   = "100 MPa"

[[stages]]
name    = "discs"
matrix  = "binder"
box     = "6 mm"
cells   = 16
filler  = { material = "glass", sizes = { diameter = "1.8 mm" }, coating = { material = "interphase", thickness = "0.4 mm" } }
packing = { method = "regular", columns = 2, rows = 2 }

[tests]
loads = ["shear"]
times      = ["1 ms", "1 s"]
fields     = "none"
boundaries = ["displacement"]

[tests.quasistatic]
vary = { interphase = { shear = ["10 MPa", "1 GPa"] } }
)";

}  // namespace breccia::test
