#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "deckfile/deck_tree.hpp"

namespace breccia {

/// One step of a path: a key of a table, or the index of an element of an array.
using DeckStep = std::variant<std::string, std::size_t>;
using DeckPath = std::vector<DeckStep>;

namespace detail {

using DeckSteps = std::span<const DeckStep>;

/// The path for a message: `stages.0.filler.fraction`.
std::string path_text(DeckSteps path);

/// The keys of the path as a key or a header of TOML, without its indices: `stages.filler`, `materials."type 2.1"`.
std::string key_text(DeckSteps path);

/// The path with further steps.
DeckPath extended(DeckSteps path, DeckSteps further);
DeckPath extended(DeckSteps path, const DeckStep& further);

/// Whether a path is `top` or leads through it.
bool is_within(DeckSteps path, DeckSteps top);

/// The value at a path of at least one step, or nullptr.
const DeckValue* value_at(const DeckTable& root, DeckSteps path);

/// The number of steps from the front of the path that are there. Throws InputError when the path leads through
/// something that is no table or array, or beyond the place after the last element of an array.
std::size_t present_steps(const DeckTable& root, DeckSteps path);

}  // namespace detail
}  // namespace breccia
