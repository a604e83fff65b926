#pragma once

#include "breccia/io/deck.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// The study that a deck asks for, without its sweep; its provenance lacks overrides and hashes. Mistakes are left to
/// the deck.
Study resolve(const Deck& document);

/// Adds the overrides and the hashes of a deck without mistakes to the provenance of its study. The hashes are of what
/// the deck says and of its data files, but not of its sweep, so that a task remains the same when its sweep grows.
void add_hashes(const Deck& document, const std::vector<std::string>& overrides, Study& study);

}  // namespace breccia
