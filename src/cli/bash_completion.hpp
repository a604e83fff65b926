#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace breccia::cli {

/// A script for bash that completes the commands of the program, their options, the words and the files that these
/// take.
std::string bash_completion(const CLI::App& application);

}  // namespace breccia::cli
