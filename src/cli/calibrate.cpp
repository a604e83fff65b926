#include "breccia/assessment/calibrate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/results/stored_responder.hpp"
#include "breccia/tables/measured_table_reader.hpp"

#include "cli/calibration_tables.hpp"
#include "cli/command.hpp"
#include "cli/modulus_kinds.hpp"
#include "deck/observations.hpp"
#include "deck/unknowns.hpp"
#include "io/percentage.hpp"
#include "results/calibration_files.hpp"

namespace breccia::cli {
namespace {

namespace fs = std::filesystem;

struct CalibrateArguments {
  std::vector<fs::path> results;
  std::vector<std::string> measured;  ///< [NAME=]FILE
  std::vector<std::string> unknowns;  ///< MATERIAL.NUMBER[=PRIOR]
  std::string modulus;                ///< kind of the measured moduli; empty: from the names of the columns
  std::string noise, model_error;     ///< in per cent
  std::string stage;
  int samples = 0;
  fs::path out;
  bool overwrite = false;
  bool quiet = false;
};

/// A positive share of an option, such as "2 %".
std::optional<double> share_of(const std::string& option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto share = parse_percentage(text);
  if (share && *share > 0.0 && *share < 1.0) return share;
  throw InputError(
      fmt::format("{}: expected a percentage between 0 and 100, such as \"2 %\", got \"{}\"", option, text));
}

/// Runs actions, and throws all their mistakes at once.
class Mistakes {
 public:
  template <class Action>
  void collect(const Action& action) {
    try {
      action();
    } catch (const InputError& error) {
      mistakes_.emplace_back(error.what());
    }
  }
  void refuse() const {
    if (!mistakes_.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes_, "\n")));
  }

 private:
  std::vector<std::string> mistakes_;
};

/// The name of a composite: that of the directory of its results.
std::string name_of_results(const fs::path& results) {
  const auto path = fs::absolute(results).lexically_normal();
  return path.filename().empty() ? path.parent_path().filename().string() : path.filename().string();
}

/// The boundary under which a stage was tested: periodic, or else the first.
Boundary boundary_of(const StageResponses& stage) {
  const auto is_periodic = [](const StageResponses::Entry& one) { return one.response.boundary == Boundary::periodic; };
  const auto periodic = std::ranges::find_if(stage.entries, is_periodic);
  return periodic == stage.entries.end() ? stage.entries.front().response.boundary : Boundary::periodic;
}

/// The largest known error of the shear modulus of a stage over the times of its curves [-]; nothing where none is
/// known.
std::optional<double> error_of(const Responder& responder, const ObservedComposite& composite) {
  const auto results = responder.respond();
  const auto result = std::ranges::find(results, composite.stage, &StageResult::name);
  const auto stage = std::ranges::find(responder.stages(), composite.stage, &StageResponses::stage);
  const auto* const test = find_preferred_test(result->tests, stage->shear, composite.boundary);
  return test == nullptr ? std::nullopt : largest_whole(test->errors);
}

ObservedComposite read_composite(const fs::path& results, const CalibrateArguments& arguments) {
  const auto responder = read_responder(results);
  const auto stage = arguments.stage.empty() ? responder.stages().back().stage : arguments.stage;
  const auto chain = responder.chain_of(stage);
  const auto found = std::ranges::find(chain.stages(), stage, &StageResponses::stage);
  ObservedComposite composite = {
      .name = name_of_results(results), .responder = chain, .stage = stage, .boundary = boundary_of(*found)};
  // The error that a result states is taken as twice the standard deviation.
  const auto given = share_of("--model-error", arguments.model_error);
  composite.model_deviation = 0.5 * (given ? *given : error_of(chain, composite).value_or(0.0));
  return composite;
}

/// Data from the command line: FILE, which belong to the first composite, or NAME=FILE.
std::pair<std::size_t, fs::path> read_asked(const std::string& text, const std::vector<ObservedComposite>& composites) {
  const auto sign = text.find('=');
  if (sign == std::string::npos || fs::exists(text)) {
    if (composites.size() == 1) return {0, text};
    throw InputError(fmt::format("--measured: expected NAME=FILE, where NAME is {} or {}, got \"{}\"",
                                 composites[0].name, composites[1].name, text));
  }
  const auto name = text.substr(0, sign);
  const auto found = std::ranges::find(composites, name, &ObservedComposite::name);
  if (found != composites.end()) {
    return {static_cast<std::size_t>(found - composites.begin()), text.substr(sign + 1)};
  }
  std::vector<std::string> names;
  for (const auto& composite : composites) names.push_back(composite.name);
  throw InputError(fmt::format("--measured: no results are called \"{}\"; there are {}", name, fmt::join(names, ", ")));
}

/// What is calibrated, as it was read.
struct Asked {
  std::vector<ObservedComposite> composites = {};
  std::vector<Observation> observations = {};
  std::vector<Unknown> unknowns = {};
  std::vector<fs::path> inputs = {};
};

/// Times of observations, 1/omega of those over frequency, from the first to the last.
TimeWindow times_of(const std::vector<Observation>& observations) {
  TimeWindow window = {};
  for (const auto& one : observations) {
    const double time = is_over_frequency(one.curve) ? 1.0 / one.at : one.at;
    window.begin = window.begin > 0.0 ? std::min(window.begin, time) : time;
    window.end = std::max(window.end, time);
  }
  return window;
}

Asked read(const CalibrateArguments& arguments, double deviation) {
  Asked asked;
  Mistakes mistakes;
  for (const auto& results : arguments.results) {
    mistakes.collect([&] { asked.composites.push_back(read_composite(results, arguments)); });
  }
  mistakes.refuse();
  const auto kind = arguments.modulus.empty() ? ModulusKind::unspecified : modulus_kinds.at(arguments.modulus);
  for (const auto& text : arguments.measured) {
    mistakes.collect([&] {
      const auto [composite, file] = read_asked(text, asked.composites);
      for (auto& observation : observations_in(read_measured_table(file), kind)) {
        observation.composite = composite;
        observation.deviation = deviation;
        asked.observations.push_back(observation);
      }
      asked.inputs.push_back(file);
    });
  }
  mistakes.refuse();
  std::vector<ShiftedMaterial> materials;
  for (const auto& composite : asked.composites) {
    for (const auto& one : composite.responder.materials()) {
      if (find_material(materials, one.material.name) == nullptr) materials.push_back(one);
    }
  }
  const auto window = times_of(asked.observations);
  for (const auto& text : arguments.unknowns) {
    mistakes.collect([&] { asked.unknowns.push_back(read_unknown(text, materials, window, "--unknown")); });
  }
  mistakes.refuse();
  return asked;
}

/// The warnings of a calibration, and about composites whose error is not known.
std::vector<std::string> warnings_on(const Asked& asked, const Calibration& calibration) {
  auto warnings = calibration.warnings;
  for (const auto& composite : asked.composites) {
    if (composite.model_deviation > 0.0) continue;
    warnings.push_back(
        fmt::format("{}: the error of its model is not known and not in the intervals; --model-error \"5 %\" gives one",
                    composite.name));
  }
  return warnings;
}

/// The calibration in words, from which the same one can be told from another.
std::string source_of(const CalibrateArguments& arguments) {
  std::vector<std::string> results;
  for (const auto& one : arguments.results) results.push_back(one.string());
  auto source = fmt::format("{} with {}, unknown: {}", fmt::join(results, ", "), fmt::join(arguments.measured, ", "),
                            fmt::join(arguments.unknowns, ", "));
  for (const auto& [option, text] :
       {std::pair("noise", arguments.noise), std::pair("error of the model", arguments.model_error),
        std::pair("modulus", arguments.modulus), std::pair("stage", arguments.stage)}) {
    if (!text.empty()) source += fmt::format(", {}: {}", option, text);
  }
  return source;
}

void run_calibrate(const CalibrateArguments& arguments) {
  const auto noise = share_of("--noise", arguments.noise);
  constexpr double any = 0.01;  // only ratios matter
  const auto asked = read(arguments, noise.value_or(any));
  const auto kind = noise ? Noise::known : Noise::relative;
  const auto calibration = calibrate(asked.composites, asked.unknowns, asked.observations, {kind, arguments.samples});

  std::vector<std::string> names, studies;
  for (const auto& composite : asked.composites) {
    names.push_back(composite.name);
    studies.push_back(composite.responder.stages().front().deck_hash);
  }
  const auto out = arguments.out.empty() ? arguments.results.front() / "calibrate" : arguments.out;
  const auto files = write_calibration({.directory = out,
                                        .source = source_of(arguments),
                                        .inputs = asked.inputs,
                                        .studies = studies,
                                        .overwrite = arguments.overwrite},
                                       {asked.observations, names}, calibration);
  for (const auto& warning : warnings_on(asked, calibration)) {
    fmt::print(arguments.quiet ? stderr : stdout, "warning: {}\n", warning);
  }
  if (arguments.quiet) return;
  fmt::print("{} measured values of {}\n\n{}\n", asked.observations.size(), fmt::join(names, ", "),
             table_of_estimates(calibration.estimates));
  for (const auto& remark : remarks_on(calibration, asked.observations, kind)) fmt::print("{}\n", remark);
  fmt::print("Results are in {}: {}\n", out.string(), fmt::join(files, ", "));
}

}  // namespace

void add_calibrate(CLI::App& application) {
  auto* command = application.add_subcommand(
      "calibrate", "find unknown numbers of materials from measurements of composites, with their uncertainty");
  auto arguments = std::make_shared<CalibrateArguments>();
  command->add_option("DIR", arguments->results, "the results of `breccia run` of each composite")
      ->required()
      ->type_name("");
  command
      ->add_option("--measured", arguments->measured,
                   "measured values, a CSV file with a relaxation modulus, a creep compliance or dynamic moduli; with "
                   "several DIR the name of one of them and the file; may be repeated")
      ->required()
      ->expected(1)
      ->take_all()
      ->type_name("[NAME=]FILE");
  command
      ->add_option(
          "--unknown", arguments->unknowns,
          "an unknown, such as hmx.shear, binder.times, binder.modulus, binder.equilibrium or binder.spectrum, "
          "and what is known of it, as in hmx.shear='{ value = \"5.8 GPa\", sd = \"0.6 GPa\" }'; may be "
          "repeated")
      ->required()
      ->expected(1)
      ->take_all()
      ->type_name("NAME[=PRIOR]");
  command
      ->add_option("--noise", arguments->noise,
                   "standard deviation of the measured values, as in \"2 %\" (default: as their deviations show)")
      ->type_name("PERCENT");
  command
      ->add_option("--model-error", arguments->model_error,
                   "error of the moduli of the run, as in \"5 %\" (default: the largest that its results state)")
      ->type_name("PERCENT");
  command
      ->add_option("--samples", arguments->samples,
                   "draw so many samples from the posterior, where it is far from a normal distribution (default: the "
                   "normal distribution about the most likely values)")
      ->check(CLI::Range(100, 10'000'000).description(""))
      ->type_name("N");
  command
      ->add_option("--modulus", arguments->modulus,
                   "kind of modulus that was measured, if the names of the columns do not say it")
      ->check(CLI::IsMember(modulus_kinds).description(""))
      ->type_name("shear|young|bulk");
  command->add_option("--stage", arguments->stage, "the stage that was measured (default: the last one)")
      ->type_name("NAME");
  command->add_option("--out", arguments->out, "directory for the results (default: DIR/calibrate)")->type_name("DIR");
  command->add_flag("--overwrite", arguments->overwrite, "replace another calibration in that directory");
  command->add_flag("--quiet", arguments->quiet, "print nothing but warnings and errors");
  command->callback([arguments] { run_calibrate(*arguments); });
}

}  // namespace breccia::cli
