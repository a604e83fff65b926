#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace breccia::cli {

/// What is wrong with a name that stands where a command should be: `unknown command "chek", did you mean "check"?`
std::string unknown_command(const CLI::App& application, const std::string& name);

/// Every mistake in a command line that CLI11 has refused, one a line, with the help to read.
std::string describe_misuse(const CLI::App& application, const CLI::ParseError& error);

}  // namespace breccia::cli
