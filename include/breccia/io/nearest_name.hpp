#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace breccia {

/// The known name that a mistyped one was probably meant to be, if one is near enough: at most a third of its letters
/// inserted, deleted, replaced or swapped with a neighbour, letter case aside.
std::optional<std::string> nearest_name(std::string_view mistyped, std::span<const std::string> known);

/// The end of a message about an unknown name: `, did you mean "filler"?`, or else `; known: "box", "cells"`.
std::string suggestion(std::string_view mistyped, std::span<const std::string> known);

}  // namespace breccia
