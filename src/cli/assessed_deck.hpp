#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "breccia/assessment/assess.hpp"
#include "breccia/deck/deck_assessment.hpp"
#include "breccia/study/study.hpp"

#include "cli/command.hpp"
#include "cli/narration.hpp"

namespace breccia::cli {

/// The arguments of commands that solve the samples of a deck with uncertain inputs.
struct AssessedDeck {
  RunArguments run;
  AssessmentOptions options;
  std::string stage;  ///< empty: the last one
};

/// Adds DECK, --set, --samples, --boxes, --seed, --stage, --out, --threads, --overwrite and --quiet.
void add_assessed_deck(CLI::App& command, AssessedDeck& arguments);

/// The assessment of the deck. Throws InputError for all its mistakes.
DeckAssessment read_assessed_deck(const AssessedDeck& arguments);

/// Solves a study in a directory, unless its complete results are there. Those of another one are replaced only with
/// `options.overwrite`.
void solve_unless_complete(const Study& study, const std::filesystem::path& directory, const RunOptions& options,
                           ProgressLine& progress);

/// Prints the inputs, and solves the studies that are not complete yet.
void solve_studies(const DeckAssessment& deck, const AssessedDeck& arguments, ProgressLine& progress);

/// The curves of all samples, from the solved studies.
std::vector<SampledCurve> curves_of(const DeckAssessment& deck, const AssessedDeck& arguments, ProgressLine& progress);

/// The samples in words, by which they can be told from others.
std::string source_of(const DeckAssessment& deck, const AssessedDeck& arguments);

/// The hashes of the studies of an assessment.
std::vector<std::string> hashes_of(const DeckAssessment& deck);

}  // namespace breccia::cli
