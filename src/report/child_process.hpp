#pragma once

#include <string>
#include <vector>

namespace breccia {

/// The exit status and the output of a program.
struct ProcessResult {
  int exit_status;     ///< 128 + the signal's number if a signal ended it
  std::string output;  ///< text on standard output
  std::string errors;  ///< text on standard error
};

/// Runs a program of the PATH to its end, with a text as its standard input. No shell is involved.
/// Throws FileError if it cannot be started.
ProcessResult run_program(const std::vector<std::string>& command, const std::string& input);

}  // namespace breccia
