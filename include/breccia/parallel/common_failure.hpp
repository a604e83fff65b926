#pragma once

#include <optional>
#include <string>
#include <utility>

#include "breccia/error.hpp"

namespace breccia::parallel {

/// Throws InputError with the message of the first process of the group that has one, on all of them; returns where
/// none has. Each process must call the function.
void throw_if_any(const std::optional<std::string>& mistake);

/// What make() returns on each process of the group. Where it throws InputError on some of them, all throw that of the
/// first of these, so that none waits for a process that has stopped. Each process must call the function.
template <class Make>
[[nodiscard]] auto made_by_all(const Make& make) {
  std::optional<decltype(make())> made;
  std::optional<std::string> mistake;
  try {
    made.emplace(make());
  } catch (const InputError& error) {
    mistake = error.what();
  }
  throw_if_any(mistake);
  return *std::move(made);
}

}  // namespace breccia::parallel
