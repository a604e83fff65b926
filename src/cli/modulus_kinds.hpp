#pragma once

#include <map>
#include <string>

#include "breccia/tables/modulus_kind.hpp"

namespace breccia::cli {

/// The kinds of a measured modulus that the option --modulus names.
inline const std::map<std::string, ModulusKind> modulus_kinds = {
    {"shear", ModulusKind::shear}, {"young", ModulusKind::young}, {"bulk", ModulusKind::bulk}};

}  // namespace breccia::cli
