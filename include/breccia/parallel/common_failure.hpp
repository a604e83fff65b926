#pragma once

#include <optional>
#include <string>
#include <utility>

#include "breccia/error.hpp"

namespace breccia::parallel {

/// Throws InputError on all processes of the group with the message of the first process that has one; returns if none
/// has. Each process must call the function.
void throw_if_any(const std::optional<std::string>& mistake);

/// Returns make() on each process of the group. If it throws InputError on some of them, all throw the error of the
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
