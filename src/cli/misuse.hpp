#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace breccia::cli {

/// The message about an unknown command: `unknown command "chek", did you mean "check"?`
std::string unknown_command(const CLI::App& application, const std::string& name);

/// All mistakes in a command line that CLI11 has refused, one per line, and the command that shows the help.
std::string describe_misuse(const CLI::App& application, const CLI::ParseError& error);

}  // namespace breccia::cli
