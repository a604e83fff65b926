#pragma once

#include <string>
#include <vector>

#include "breccia/deckfile/deck_setting.hpp"

namespace breccia {

/// For each key the last steps of its path, as many as are needed to distinguish the keys: `seed`, or `HB-1-seed` and
/// `HB-2-seed`.
std::vector<std::string> labels_of_keys(const std::vector<std::string>& paths);

/// For each value of a key a short text that can be part of a file name: `0.65`, `averaged`, a file name without
/// directory and extension, or, if such texts are not unique, the number of the value.
std::vector<std::string> labels_of_values(const std::vector<Scalar>& values);

}  // namespace breccia
