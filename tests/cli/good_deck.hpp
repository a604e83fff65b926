#pragma once

#include <string_view>

namespace breccia::test {

/// A deck without a mistake. It needs no other file.
inline constexpr std::string_view good_deck = R"(title = "Model composite"

[materials.binder]
density = "1.48 g/cm^3"
bulk    = "3.6 GPa"
shear   = { terms = [ { time = "10 ms", modulus = "1 MPa" } ] }

[materials.hmx]
density = "1.85 g/cm^3"
bulk    = "13.4 GPa"
shear   = "5.84 GPa"

[[stages]]
name    = "A"
matrix  = "binder"
box     = "6 mm"
cells   = 60
filler  = { material = "hmx", fraction = 0.5, sizes = { diameter = "1 mm" }, gap = "0.1 mm" }
packing = { method = "lubachevsky-stillinger", walls = true, seed = 1 }

[tests]
loads  = ["shear"]
times  = ["10 us", "100 ms"]
)";

}  // namespace breccia::test
