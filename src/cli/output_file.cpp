#include "cli/output_file.hpp"

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia::cli {

namespace fs = std::filesystem;

void refuse_existing(const fs::path& output, bool overwrite) {
  if (output.empty()) return;
  if (fs::is_directory(output)) {
    throw InputError(fmt::format("--output: expected a file, got the directory {}", output.string()));
  }
  if (overwrite || !fs::exists(fs::symlink_status(output))) return;
  throw InputError(
      fmt::format("{}: the file exists; replace it (--overwrite) or choose another name", output.string()));
}

}  // namespace breccia::cli
