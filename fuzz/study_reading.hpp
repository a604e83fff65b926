#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia::fuzz {

/// Throws std::logic_error where a study that was accepted has numbers that no deck may have.
void look_through(const Study& study);

/// Reads a deck as the commands do, with what follows `--set` and `--sweep`, and looks through what it means.
void read_deck(const std::filesystem::path& deck, const std::vector<std::string>& overrides = {},
               const std::vector<std::string>& swept = {});

}  // namespace breccia::fuzz
