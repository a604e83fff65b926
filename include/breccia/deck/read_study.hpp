#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/deckfile/deck_setting.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Reads a deck (docs/decks.md) with overrides `key.path=value`, and the data files that it names; ignores its sweep
/// (see read_sweep). `origins` names the source of the overrides in messages. Throws InputError with one line for every
/// mistake, and FileError when a file cannot be read.
Study read_study(const std::filesystem::path& deck, const std::vector<std::string>& overrides = {},
                 const ValueOrigins& origins = {});

/// The study of a deck that a program has put together as text. Files that it names are relative to `directory`; a line
/// about a mistake begins with "study" in place of the deck's name, line and column. Throws as read_study().
Study study_from_text(const std::string& deck, const std::filesystem::path& directory,
                      const std::vector<std::string>& overrides = {}, const ValueOrigins& origins = {});

}  // namespace breccia
