#pragma once

#include <string>

#include "breccia/study/study.hpp"

namespace breccia::cli {

/// A study for people: materials, stages and tests as they were understood, one fact a line.
std::string summary(const Study& study);

}  // namespace breccia::cli
