#pragma once

#include "breccia/study/study.hpp"

namespace breccia::fuzz {

/// Throws std::logic_error where a study that was accepted has numbers that no deck may have.
void require_sound(const Study& study);

}  // namespace breccia::fuzz
