#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia {

/// Reads a deck (docs/decks.md) with overrides `key.path=value`, and the data files that it names; ignores its sweep
/// (see read_sweep). Throws InputError with one line for every mistake, and FileError when a file cannot be read.
Study read_study(const std::filesystem::path& deck, const std::vector<std::string>& overrides = {});

}  // namespace breccia
