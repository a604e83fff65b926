#pragma once

#include <string>

#include "breccia/study/provenance.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// A hash of everything in a study that its results depend on, to the last bit of each number. The hash ignores the
/// provenance, the warnings of the deck reader, the names of the data files, and the number of threads.
std::string content_of(const Study& study);

/// The provenance of a study in its present state. As long as the study was not changed after its deck was read, this
/// is the provenance of the deck. A study that was changed, or put together in memory, has the hash of its content
/// (content_of), and no deck text, overrides or hashes of stages; the files that it was read from remain its inputs.
Provenance provenance_of(const Study& study);

}  // namespace breccia
