#pragma once

#include <optional>

#include "breccia/io/deck.hpp"
#include "breccia/study/filler.hpp"

namespace breccia {

/// What is said of a key that asks for anything but discs.
inline constexpr auto discs_alone =
    "all particles are discs so far: other shapes and images are not available (docs/limitations.md)";

/// Reads `packing` of a stage with a box of the given side [m].
std::optional<PackingMethod> read_packing(const Section& stage, double side);

/// Does a packing draw its particles at random, so that it has a `seed`?
bool takes_seed(const Section& packing);

}  // namespace breccia
