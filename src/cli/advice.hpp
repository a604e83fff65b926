#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "breccia/error.hpp"

namespace breccia::cli {

/// The message of an error, with the options of the command that help against it. The library does not name options,
/// because other programs use it, too.
std::string with_advice(const Error& error, const CLI::App& command);

}  // namespace breccia::cli
