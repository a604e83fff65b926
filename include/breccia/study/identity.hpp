#pragma once

#include <string>

#include "breccia/study/provenance.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// A hash of all that a study asks for, to the last bit of each number. Left aside are its provenance, the warnings of
/// the deck reader, the names of its data files, and the number of threads, on which no result depends.
std::string content_of(const Study& study);

/// The provenance of a study as it stands. That of its deck holds as long as nothing was changed after the deck was
/// read. A study that was changed, or put together in memory, has its content as its hash, and no deck, overrides or
/// hashes of stages; the files that it was read from remain its inputs.
Provenance provenance_of(const Study& study);

}  // namespace breccia
