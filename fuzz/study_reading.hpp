#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia::fuzz {

/// Checks all parts of a study that was accepted. Throws std::logic_error where it has numbers that no deck may have.
void look_through(const Study& study);

/// Reads a deck as the commands do, with the arguments of `--set` and `--sweep`, and checks the studies that it
/// describes.
void read_deck(const std::filesystem::path& deck, const std::vector<std::string>& overrides = {},
               const std::vector<std::string>& swept = {});

}  // namespace breccia::fuzz
