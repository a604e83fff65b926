#pragma once

#include <string>
#include <vector>

#include "breccia/io/deck_setting.hpp"

namespace breccia {

/// For each path of keys its last steps, as many as tell it from the others: `seed`, or `HB-1-seed` and `HB-2-seed`.
std::vector<std::string> labels_of_keys(const std::vector<std::string>& paths);

/// For each of the values of a key a short text that may be part of a file's name: `0.65`, `averaged`, for files their
/// names without directory and extension, or else the number of the value.
std::vector<std::string> labels_of_values(const std::vector<Scalar>& values);

}  // namespace breccia
