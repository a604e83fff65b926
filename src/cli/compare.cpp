#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "assessment/sampled_curves.hpp"
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

/// A result as it is compared.
struct ReadResult {
  std::string stage;
  std::vector<SampledCurve> curves;
  std::string hash;
};

/// The stage of this name; the last one for an empty name.
const StageFindings& stage_of(const std::vector<StageFindings>& stages, const std::string& name) {
  if (name.empty()) return stages.back();
  std::vector<std::string> names;
  for (const auto& stage : stages) {
    if (stage.name == name) return stage;
    names.push_back(stage.name);
  }
  throw InputError(fmt::format("no stage \"{}\"{}", name, suggestion(name, names)));
}

ReadResult read_result(const std::filesystem::path& directory, const std::string& stage) {
  const auto study = read_stored_study(directory);
  try {
    const auto& chosen = stage_of(study.stages, stage);
    return {chosen.name, curves_of(chosen), read_study_record(directory).hash};
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", directory.string(), error.what()));
  }
}

Deck deck_of(const std::filesystem::path& directory) {
  const auto record = read_study_record(directory);
  return Deck::from_text(record.deck_text, "study", directory, record.overrides);
}

/// A number with its sign, in per cent: "+12 %".
std::string percent_from_one(double ratio) {
  return fmt::format("{:+.0f} %", 100.0 * (ratio - 1.0));
}

/// How far a result is from what was measured.
std::string deviation_in_words(const MeasuredDeviation& deviation) {
  const auto abscissa = deviation.is_over_frequency ? Abscissa::frequency : Abscissa::time;
  return fmt::format("{} values, {:.0f} % rms, from {} at {} to {} at {}", deviation.count, 100.0 * deviation.rms,
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
    for (const auto& directory : arguments.results) {
      mistakes.collect([&] { results.push_back(read_result(directory, arguments.stage)); });
    }
    mistakes.collect([&] { measured = measured_by(arguments, notes); });
    mistakes.refuse();
  }

  std::vector<ReadResult> results;
  std::vector<Observation> measured;
  std::vector<std::string> notes;
};

/// How far each result is from what was measured, a line each.
std::string table_of_measured(const std::vector<Observation>& measured, const std::vector<ReadResult>& results) {
  if (measured.empty()) return "";
  std::string text = "\nComputed over measured\n";
  for (std::size_t i = 0; i < results.size(); ++i) {
    text += fmt::format("  {}: {}\n", letter_of(i), deviation_in_words(deviation_from(measured, results[i].curves)));
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
  return text;
}

void run_compare(const CompareArguments& arguments) {
  auto asked = Asked(arguments);
  ComparedResults compared = {.measured = std::move(asked.measured)};
  std::vector<Deck> decks;
  std::vector<std::vector<SampledCurve>> curves;
  std::string identity, legend;
  for (std::size_t i = 0; i < asked.results.size(); ++i) {
    compared.names.push_back(arguments.results[i].string());
    decks.push_back(deck_of(arguments.results[i]));
    curves.push_back(asked.results[i].curves);
    identity += asked.results[i].hash + "\n";
    legend += fmt::format("{} = {}, {}\n", letter_of(i), compared.names.back(), asked.results[i].stage);
  }
  compared.decks = deck_differences(decks);
  compared.curves = compare_curves(curves);
  const auto of_measured = table_of_measured(compared.measured, asked.results);
  std::vector<std::string> files;
  if (!arguments.out.empty()) files = write_compared({arguments.out, identity, arguments.overwrite}, compared);

  fmt::print("{}\n{}\n{}{}{}", legend, compared.decks.empty() ? "The decks are the same." : "The decks differ in",
             table_of_decks(compared.decks), tables_of(compared.curves), of_measured);
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
