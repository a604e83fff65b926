#pragma once

#include <string>

#include "breccia/study/study.hpp"

namespace breccia::cli {

/// A study in words: materials, stages and tests as they were read from the deck, one fact per line.
std::string summary(const Study& study);

}  // namespace breccia::cli
