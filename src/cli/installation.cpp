#include "cli/installation.hpp"

#include <system_error>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia::cli {
namespace {

namespace fs = std::filesystem;

/// A directory of the installation, found by its path relative to the program.
fs::path installed(const char* from_program) {
  auto directory = (program_path().parent_path() / from_program).lexically_normal();
  if (fs::is_directory(directory)) return directory;
  throw FileError(
      fmt::format("{}: no such directory; the installation of breccia is not complete", directory.string()));
}

}  // namespace

fs::path program_path() {
  std::error_code failure;
  auto program = fs::read_symlink("/proc/self/exe", failure);
  if (failure) throw FileError("/proc/self/exe: the system does not say where the program is");
  return program;
}

fs::path installed_examples() {
  return installed(BRECCIA_EXAMPLES_FROM_PROGRAM);
}

fs::path installed_documentation() {
  return installed(BRECCIA_DOCUMENTATION_FROM_PROGRAM);
}

}  // namespace breccia::cli
