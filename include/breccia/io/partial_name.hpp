#pragma once

#include <string>
#include <string_view>

namespace breccia {

/// The name under which a process writes a file until it is whole: `curves.csv.4711.partial`, with the number of the
/// process (AtomicFile).
std::string partial_name(std::string_view name, int process);

/// Is this such a name, with or without directories before it?
bool is_partial_name(std::string_view name);

}  // namespace breccia
