#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/deckfile/deck_setting.hpp"
#include "breccia/study/sweep.hpp"

namespace breccia {

/// Reads a deck with overrides as read_study() does, with its `[sweep]` and with further swept keys in the form
/// `key.path=[value, ...]`. `origins` names the sources of overrides and further keys in messages. Throws InputError
/// with one line for every mistake in any task, and FileError.
Sweep read_sweep(const std::filesystem::path& deck, const std::vector<std::string>& overrides,
                 const std::vector<std::string>& further_keys, const ValueOrigins& origins = {});

}  // namespace breccia
