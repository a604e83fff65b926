#pragma once

#include <string>

namespace breccia::cli {

/// What `breccia --version` prints: the version, the build, the instruction sets of the kernels that
/// this processor has and the one that a run uses, the libraries. Throws InputError if the environment names an
/// instruction set that is not there.
std::string version_text();

}  // namespace breccia::cli
