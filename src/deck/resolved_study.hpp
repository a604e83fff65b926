#pragma once

#include "breccia/study/study.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// Reads the study of a deck without its sweep. Its provenance lacks overrides and hashes. Mistakes are reported to the
/// deck.
Study resolve(const Deck& document);

/// Adds the overrides and the hashes of a deck without mistakes to the provenance of its study. The hashes are those of
/// the deck's content without its sweep, and of its data files, so that a task has the same hash when the sweep grows.
void add_hashes(const Deck& document, const std::vector<std::string>& overrides, Study& study);

}  // namespace breccia
