#pragma once

#include <stdexcept>
#include <string>

namespace breccia {

/// The exit code of the `breccia` command.
enum class ExitCode { done = 0, bad_input = 2, numerical_failure = 3, file_failure = 4, interrupted = 130 };

/// Base of every error that Breccia reports to its user. The message is complete: it needs no prefix.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  [[nodiscard]] ExitCode exit_code() const noexcept { return code_; }

 private:
  ExitCode code_;
};

/// Error in the input: bad usage, a bad deck, a bad data file or a bad argument of a public function.
class InputError : public Error {
 public:
  explicit InputError(const std::string& message) : Error(ExitCode::bad_input, message) {}
};

/// Error that another process of Breccia writes to the directory of the results.
class DirectoryInUse : public InputError {
 public:
  using InputError::InputError;
};

/// Error in the computation, which cannot continue: instability, no convergence, an impossible packing.
class NumericalError : public Error {
 public:
  explicit NumericalError(const std::string& message) : Error(ExitCode::numerical_failure, message) {}
};

/// Error of a file that cannot be read or written.
class FileError : public Error {
 public:
  explicit FileError(const std::string& message) : Error(ExitCode::file_failure, message) {}
};

/// Reports that the computation was stopped by its user or by a time limit.
class Interrupted : public Error {
 public:
  explicit Interrupted(const std::string& message) : Error(ExitCode::interrupted, message) {}
};

}  // namespace breccia
