#pragma once

#include <string>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

/// Runs an action and returns its result. Prefixes the message of an InputError or NumericalError with a name.
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
