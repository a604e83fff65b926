#pragma once

#include <string>
#include <string_view>

namespace breccia {

/// The name of a file that a process has not written completely yet: `curves.csv.4711.partial`, with the id of the
/// process (AtomicFile).
std::string partial_name(std::string_view name, int process);

/// The name that a file with a partial_name() gets when it is complete: `curves.csv`; empty for any other name.
std::string_view whole_name(std::string_view partial);

/// Whether this is a partial_name(), with or without a directory.
bool is_partial_name(std::string_view name);

}  // namespace breccia
