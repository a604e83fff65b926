#pragma once

#include <optional>
#include <string>

#include "breccia/study/study.hpp"

namespace breccia {

/// Whether a study gives the thermal expansion of a material, and so asks for that of its stages.
bool asks_for_expansion(const Study& study);

/// Why Levin's equation (theory, Eq. 23g) does not give the thermal expansion of a stage, as the rest of a sentence;
/// nothing where it does, as far as that is known before its matrix is computed.
std::optional<std::string> obstacle_to_expansion(const Study& study, const Stage& stage);

/// Why the bulk modulus of a composite does not determine its thermal expansion (determines_expansion), as the rest of
/// a sentence; nothing where it does.
std::optional<std::string> obstacle_in_moduli(const Material& filler, const Material& matrix);

}  // namespace breccia
