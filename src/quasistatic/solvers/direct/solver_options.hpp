#pragma once

#include <string_view>

namespace breccia::quasistatic {

/// Gives an option of PETSc a value unless the user has set it on the command line: -PREFIX_NAME.
void set_default_option(std::string_view prefix, std::string_view name, const char* value);

}  // namespace breccia::quasistatic
