#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace breccia::cli {

/// A script for zsh that completes the commands of the program, their options, the words and the files that these take,
/// with descriptions. The file of the script must be named _breccia.
std::string zsh_completion(const CLI::App& application);

}  // namespace breccia::cli
