#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "breccia/microstructure/microstructure.hpp"
#include "breccia/viscoelasticity/material.hpp"

#include "virtual_test/dynamic_test.hpp"
#include "virtual_test/quasistatic_test.hpp"

namespace breccia::test {

/// The phases of a composite.
inline constexpr PhaseIndex matrix = 0, filler = 1;

/// A random composite: a few discs in a matrix that relaxes.
struct Composite {
  Microstructure<2> box;
  std::vector<Material> materials;  ///< materials by PhaseIndex
  Volumetric volumetric = Volumetric::averaged;
};

/// Kinds of filler of a random composite.
enum class FillerKind { elastic, relaxing };

/// A random composite, which depends on the seed alone, not on the machine. The moduli, their ratios between the phases
/// and of K to G vary over decades; a spectrum has one to six terms between 0.1 ms and 1 s.
Composite random_composite(std::uint64_t seed, FillerKind kind = FillerKind::elastic);

/// Times in which the composites are tested [s].
inline constexpr TimeWindow window = {1e-3, 0.1};
inline constexpr int cells = 12;

/// A quasi-static test of the composite in shear and in bulk.
QuasistaticTest quasistatic_test(const Composite& composite, Boundary boundary);
DynamicTest<2> dynamic_test(const Composite& composite, Boundary boundary);

inline constexpr std::array boundaries = {Boundary::displacement, Boundary::traction, Boundary::periodic};

}  // namespace breccia::test
