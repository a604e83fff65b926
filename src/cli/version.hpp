#pragma once

#include <string>

namespace breccia::cli {

/// The text that `breccia --version` prints: the version, the build, the instruction sets of the kernels that this
/// processor has and the one that a run uses, the libraries. Throws InputError if the environment names an instruction
/// set that the processor does not have.
std::string version_text();

}  // namespace breccia::cli
