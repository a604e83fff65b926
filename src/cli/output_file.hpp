#pragma once

#include <filesystem>

namespace breccia::cli {

/// Throws InputError where the file of the option `--output` is a directory, or exists and is not to be replaced; an
/// empty name is standard output.
void refuse_existing(const std::filesystem::path& output, bool overwrite);

}  // namespace breccia::cli
