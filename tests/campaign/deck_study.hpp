#pragma once

#include <filesystem>
#include <string>

#include "breccia/results/curves.hpp"

#include "io/text_file.hpp"
#include "results/hand_made_results.hpp"
#include "results/provenance.hpp"
#include "study/identity.hpp"
#include "study/two_stages.hpp"

namespace breccia::test {

/// Gives a study the provenance that it would have if it came from a deck of one line.
inline void give_provenance(Study& study, const std::string& title) {
  study.title = title;
  auto& provenance = study.provenance;
  provenance.deck = "deck.toml";
  provenance.deck_text = "title = \"" + title + "\"\n";
  provenance.hash = content_hash(provenance.deck_text);
  provenance.stage_hashes.clear();
  for (const auto& stage : study.stages) provenance.stage_hashes.push_back(stage.name + " in " + title);
  provenance.content = content_of(study);
}

/// A study of the stage "fine" with the provenance of a deck. Its title identifies it.
inline Study study_of_deck(const std::string& title) {
  auto study = two_stages();
  study.stages.pop_back();
  study.tests.boundaries = {Boundary::displacement};
  give_provenance(study, title);
  return study;
}

inline StudyResult packed_result() {
  return {{stage_with("fine", {})}, {}};
}

inline StudyResult tested_result() {
  return {{stage_with("fine", {test_with({.grid = TestGrid(12)}, {{1e-3, 2.0}, {1.0, 1.0}})})}, {}};
}

inline StudyResult complete_result() {
  auto result = tested_result();
  result.seconds = 2.5;
  return result;
}

/// Writes results like a run: the record, the curves, and a file in the directory of the stage.
inline void leave(const std::filesystem::path& place, const Study& study, const StudyResult& result) {
  std::filesystem::create_directories(place / "fine");
  write_provenance(place, study, result);
  write_curves(place, result);
  write_text(place / "fine" / "modulus.svg", "of " + study.title);
}

}  // namespace breccia::test
