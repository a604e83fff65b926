#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace breccia::test {

/// What a run of the `breccia` command left.
struct Outcome {
  int exit_code;
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
};

/// Runs `breccia` with these arguments in a directory.
Outcome run_breccia(const std::filesystem::path& directory, const std::vector<std::string>& arguments);

}  // namespace breccia::test
