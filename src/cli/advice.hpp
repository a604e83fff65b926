#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "breccia/error.hpp"

namespace breccia::cli {

/// The message of an error with the options of the command by which it can be helped: the library, which others use
/// too, knows of none.
std::string with_advice(const Error& error, const CLI::App& command);

}  // namespace breccia::cli
