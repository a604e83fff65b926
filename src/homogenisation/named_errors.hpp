#pragma once

#include <string>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

/// Runs an action. What it throws for its input or its numbers gets the name of what it was about.
template <class Action>
auto name_errors(const std::string& name, const Action& action) {
  try {
    return action();
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", name, error.what()));
  } catch (const NumericalError& error) {
    throw NumericalError(fmt::format("{}: {}", name, error.what()));
  }
}

}  // namespace breccia
