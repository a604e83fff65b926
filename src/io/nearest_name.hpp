#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace breccia {

/// The known name that a mistyped one was probably meant to be: the nearest one, if at most a third of its letters must
/// be inserted, deleted, replaced or swapped with a neighbour, ignoring case.
std::optional<std::string> nearest_name(std::string_view mistyped, std::span<const std::string> known);

/// The end of a message about an unknown name: `, did you mean "filler"?`, or, if no known name is near,
/// `; known: "box", "cells"`.
std::string suggestion(std::string_view mistyped, std::span<const std::string> known);

}  // namespace breccia
