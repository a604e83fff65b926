#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/assessment/stage_curves.hpp"
#include "breccia/error.hpp"

#include "cli/command.hpp"
#include "cli/compared_tables.hpp"
#include "cli/modulus_kinds.hpp"
#include "deck/asked_observations.hpp"
#include "io/collected_mistakes.hpp"
#include "io/nearest_name.hpp"
#include "results/compared_files.hpp"
#include "results/curve_places.hpp"
#include "results/stored_study.hpp"
#include "results/study_record.hpp"

namespace breccia::cli {
namespace {

struct CompareArguments {
  std::vector<std::filesystem::path> results;
  std::string stage;  ///< empty: the last one of each
  std::vector<std::filesystem::path> measured;
  std::string modulus;  ///< kind of the measured moduli; empty: from the names of the columns
  std::filesystem::path out;
  bool overwrite = false;
};

/// A result that was read: its record, its deck and the stage that is compared.
struct ReadResult {
  std::string name;
  StudyRecord record;
  StageFindings stage;
};

/// The tested stage of this name; without a name the last stage of the study.
const StageFindings& stage_of(const StoredStudy& study, const StudyRecord& record, const std::string& name) {
  const auto& wanted = name.empty() ? record.stages.back() : name;
  const auto found = std::ranges::find(study.stages, wanted, &StageFindings::name);
  if (found != study.stages.end() && !found->tests.empty()) return *found;
  if (std::ranges::find(record.stages, wanted) == record.stages.end()) {
    throw InputError(fmt::format("no stage \"{}\"{}", wanted, suggestion(wanted, record.stages)));
  }
  throw InputError(fmt::format("stage {} is not tested yet: go on with `breccia run --resume`", wanted));
}

ReadResult read_result(const std::filesystem::path& directory, const std::string& stage) {
  const auto study = read_stored_study(directory);
  const auto record = read_study_record(directory);
  try {
    return {directory.string(), record, stage_of(study, record, stage)};
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", directory.string(), error.what()));
  }
}

/// The values in which the decks differ, and the data files. A sweep, of which a result is one task, is left out.
std::vector<DeckDifference> differences_of(const std::vector<ReadResult>& results) {
  std::vector<Deck> decks;
  decks.reserve(results.size());
  for (const auto& result : results) {
    decks.push_back(Deck::from_text(result.record.deck_text, "study", ".", result.record.overrides));
  }
  auto differences = deck_differences(decks);
  std::erase_if(differences, [](const DeckDifference& one) { return one.path.starts_with("sweep."); });
  std::vector<FilesOfDeck> files;
  for (const auto& result : results) {
    auto& own = files.emplace_back();
    for (const auto& [name, hash] : result.record.file_hashes) own.emplace_back(name, hash);
  }
  for (auto& difference : file_differences(files)) differences.push_back(std::move(difference));
  return differences;
}

/// The kind of tests that all results have. Throws InputError where there is none.
TestKind kind_of_all(const std::vector<ReadResult>& results) {
  std::vector<StageFindings> stages;
  stages.reserve(results.size());
  for (const auto& result : results) stages.push_back(result.stage);
  if (const auto kind = shared_kind(stages)) return *kind;
  std::vector<std::string> own;
  own.reserve(results.size());
  for (const auto& result : results) {
    const auto kind = kinds_of(result.stage).front();
    own.push_back(fmt::format("{} has {}, {}", result.name, name_of(kind.boundary), name_of(kind.method)));
  }
  throw InputError(fmt::format("the results share no boundary and method: {}", fmt::join(own, "; ")));
}

/// A ratio as a deviation in per cent: "+12 %".
std::string percent_from_one(double ratio) {
  return fmt::format("{:+.0f} %", 100.0 * (ratio - 1.0));
}

/// How far a result is from what was measured.
std::string deviation_in_words(const MeasuredDeviation& deviation, Abscissa abscissa) {
  return fmt::format("{:.0f} % rms, from {} at {} to {} at {}", 100.0 * (std::exp(deviation.rms) - 1.0),
                     percent_from_one(deviation.least), place_in_words(deviation.at_least, abscissa),
                     percent_from_one(deviation.most), place_in_words(deviation.at_most, abscissa));
}

/// What was measured, and notes on how it was understood.
std::vector<Observation> measured_by(const CompareArguments& arguments, std::vector<std::string>& notes) {
  AskedObservations asked;
  for (const auto& file : arguments.measured) asked.data.push_back({0, file});
  if (!arguments.modulus.empty()) asked.modulus = modulus_kinds.at(arguments.modulus);
  CollectedMistakes mistakes;
  auto observations = read_observations(asked, notes, mistakes);
  mistakes.refuse();
  return observations;
}

/// Everything that is read for a comparison. Throws InputError with all mistakes at once.
struct Asked {
  explicit Asked(const CompareArguments& arguments) {
    CollectedMistakes mistakes;
    std::vector<std::filesystem::path> places;
    for (const auto& directory : arguments.results) {
      mistakes.collect([&] {
        results.push_back(read_result(directory, arguments.stage));
        const auto place = std::filesystem::canonical(directory);
        if (std::ranges::find(places, place) != places.end()) {
          throw InputError(fmt::format("{} is given twice", directory.string()));
        }
        places.push_back(place);
      });
    }
    mistakes.collect([&] { measured = measured_by(arguments, notes); });
    mistakes.refuse();
  }

  std::vector<ReadResult> results;
  std::vector<Observation> measured;
  std::vector<std::string> notes;
};

/// How far each result is from the measured values within the times or frequencies of a compared curve, a line each.
std::string table_of_measured(const std::vector<Observation>& measured,
                              const std::vector<std::vector<SampledCurve>>& curves, const ComparedCurve& compared) {
  if (measured.empty()) return "";
  const auto abscissa = is_over_frequency(compared.curve) ? Abscissa::frequency : Abscissa::time;
  const auto within = values_within(measured, compared);
  auto text = fmt::format("\nComputed over measured, {} of {} values, from {} to {}\n", within.size(), measured.size(),
                          place_in_words(compared.at.front(), abscissa), place_in_words(compared.at.back(), abscissa));
  for (std::size_t i = 0; !within.empty() && i < curves.size(); ++i) {
    text += fmt::format("  {}: {}\n", letter_of(i), deviation_in_words(deviation_from(within, curves[i]), abscissa));
  }
  return text;
}

/// The tables of all curves, and what their signs mean.
std::string tables_of(const ComparedCurves& compared) {
  std::string text;
  for (const auto& curve : compared.curves) text += "\n" + table_of_compared(curve);
  if (text.find(within_errors) != std::string::npos) {
    text += fmt::format("{}: the errors that the results state explain the difference\n", within_errors);
  }
  if (lacks_errors(compared.curves.front())) {
    text += "a ratio without +-: the results do not state all of their errors\n";
  }
  return text;
}

std::string legend_of(const std::vector<ReadResult>& results, const TestKind& kind) {
  std::string text;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const auto& [name, record, stage] = results[i];
    text += fmt::format("{} = {}, {}, {}{}{}\n", letter_of(i), name, stage.name, name_of(kind.boundary),
                        kind.method == Method::dynamic ? ", dynamic" : "",
                        record.is_complete ? "" : " (not complete: `breccia run --resume` goes on)");
  }
  return text;
}

/// What the decks differ in.
std::string decks_in_words(const std::vector<ReadResult>& results, const std::vector<DeckDifference>& differences) {
  const auto has_none = [](const ReadResult& result) { return result.record.deck_text.empty(); };
  if (std::ranges::any_of(results, has_none)) return "Not all of the results have a deck.\n";
  if (differences.empty()) return "The decks are the same.\n";
  return "The decks differ in\n" + table_of_decks(differences);
}

/// What a comparison is of, so that it can be told from others.
std::string identity_of(const CompareArguments& arguments, const std::vector<ReadResult>& results) {
  auto identity = fmt::format("stage {}, modulus {}\n", arguments.stage, arguments.modulus);
  for (const auto& result : results) identity += fmt::format("{} {}\n", result.name, result.record.hash);
  for (const auto& file : arguments.measured) identity += fmt::format("measured {}\n", file.string());
  return identity;
}

void run_compare(const CompareArguments& arguments) {
  const Asked asked(arguments);
  const auto kind = kind_of_all(asked.results);
  ComparedResults compared = {.decks = differences_of(asked.results)};
  std::vector<std::vector<SampledCurve>> curves;
  for (const auto& result : asked.results) {
    compared.names.push_back(result.name);
    curves.push_back(curves_of(result.stage, kind));
  }
  compared.curves = compare_curves(curves);
  compared.measured = comparable_values(asked.measured, curves.front());
  const auto of_measured = table_of_measured(compared.measured, curves, compared.curves.curves.front());
  std::vector<std::string> files;
  if (!arguments.out.empty()) {
    files = write_compared({arguments.out, identity_of(arguments, asked.results), arguments.overwrite}, compared);
  }
  fmt::print("{}\n{}{}{}", legend_of(asked.results, kind), decks_in_words(asked.results, compared.decks),
             tables_of(compared.curves), of_measured);
  for (const auto& note : asked.notes) fmt::print("note: {}\n", note);
  if (!compared.curves.left_out.empty()) {
    fmt::print("note: not all results have {}\n", fmt::join(compared.curves.left_out, ", "));
  }
  if (!files.empty()) fmt::print("Results are in {}: {}\n", arguments.out.string(), fmt::join(files, ", "));
}

}  // namespace

void add_compare(CLI::App& application) {
  auto* command = application.add_subcommand(
      "compare", "compare the results of several runs: what differs in their decks, and what that does to the curves");
  auto arguments = std::make_shared<CompareArguments>();
  command->add_option("DIR", arguments->results, "the results of `breccia run`, two or more; ratios are to the first")
      ->required()
      ->expected(2, 26)
      ->type_name("");
  command->add_option("--stage", arguments->stage, "the stage of all results (default: the last one of each)")
      ->type_name("NAME");
  command
      ->add_option("--measured", arguments->measured,
                   "measured values of the composite, beside which all results are shown; may be repeated")
      ->expected(1)
      ->take_all()
      ->type_name("FILE");
  command
      ->add_option("--modulus", arguments->modulus,
                   "kind of modulus that was measured, if the names of the columns do not say it")
      ->check(CLI::IsMember(modulus_kinds).description(""))
      ->type_name("shear|young|bulk");
  auto* out = command->add_option("--out", arguments->out, "directory for tables and pictures (default: none)");
  out->type_name("DIR");
  command->add_flag("--overwrite", arguments->overwrite, "replace an earlier comparison in the directory")->needs(out);
  command->callback([arguments] { run_compare(*arguments); });
}

}  // namespace breccia::cli
