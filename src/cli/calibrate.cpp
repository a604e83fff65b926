
#include <algorithm>
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

#include "cli/calibration_tables.hpp"
#include "cli/command.hpp"
#include "cli/modulus_kinds.hpp"
#include "deck/asked_calibration.hpp"
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

/// The name of a composite: that of the directory of its results.
std::string name_of_results(const fs::path& results) {
  const auto path = fs::absolute(results).lexically_normal();
  return path.filename().empty() ? path.parent_path().filename().string() : path.filename().string();
}

/// Data from the command line: FILE, which belong to the only composite, or NAME=FILE.
AskedData read_asked_data(const std::string& text, const std::vector<std::string>& composites) {
  const auto sign = text.find('=');
  const auto names = fmt::format("{}", fmt::join(composites, ", "));
  if (sign == std::string::npos || fs::exists(text)) {
    if (composites.size() == 1) return {0, text};
    throw InputError(fmt::format("--measured: expected NAME=FILE, with one of the names {}, got \"{}\"", names, text));
  }
  const auto found = std::ranges::find(composites, text.substr(0, sign));
  if (found == composites.end()) {
    throw InputError(
        fmt::format("--measured: no results are called \"{}\"; there are {}", text.substr(0, sign), names));
  }
  return {static_cast<std::size_t>(found - composites.begin()), text.substr(sign + 1)};
}

/// The names of the directories of results. Throws InputError where two are the same.
std::vector<std::string> names_of(const std::vector<fs::path>& directories) {
  std::vector<std::string> names;
  for (const auto& directory : directories) {
    const auto name = name_of_results(directory);
    if (std::ranges::find(names, name) != names.end()) {
      throw InputError(fmt::format("two directories of results are called \"{}\": rename one", name));
    }
    names.push_back(name);
  }
  return names;
}

AskedCalibration asked_by(const CalibrateArguments& arguments) {
  AskedCalibration asked;
  asked.measured.noise = option_share("--noise", arguments.noise);
  asked.model_error = option_share("--model-error", arguments.model_error);
  const auto names = names_of(arguments.results);
  for (const auto& text : arguments.measured) asked.measured.data.push_back(read_asked_data(text, names));
  for (std::size_t i = 0; i < names.size(); ++i) {
    asked.composites.emplace_back(names[i], read_responder(arguments.results[i]));
  }
  asked.unknowns = arguments.unknowns;
  if (!arguments.modulus.empty()) asked.measured.modulus = modulus_kinds.at(arguments.modulus);
  asked.stage = arguments.stage;
  asked.samples = arguments.samples;
  return asked;
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
  const auto asked = asked_by(arguments);
  const auto found = calibrate(asked);
  CalibrationDestination destination = {
      .directory = arguments.out.empty() ? arguments.results.front() / "calibrate" : arguments.out,
      .source = source_of(arguments),
      .inputs = {},
      .studies = {},
      .overwrite = arguments.overwrite};
  for (const auto& [composite, file] : asked.measured.data) destination.inputs.push_back(file);
  std::vector<std::string> names;
  for (const auto& composite : found.composites) {
    names.push_back(composite.name);
    destination.studies.push_back(composite.responder.stages().front().deck_hash);
  }
  const auto files = write_calibration(destination, {found.observations, names}, found.result);
  if (!arguments.quiet) {
    for (const auto& note : found.notes) fmt::print("note: {}\n", note);
  }
  for (const auto& warning : found.result.warnings) {
    fmt::print(arguments.quiet ? stderr : stdout, "warning: {}\n", warning);
  }
  if (arguments.quiet) return;
  fmt::print("{} measured values of {}\n\n{}\n", found.observations.size(), fmt::join(names, ", "),
             table_of_estimates(found.result.estimates));
  for (const auto& remark : found.result.remarks) fmt::print("{}\n", remark);
  fmt::print("Results are in {}: {}\n", destination.directory.string(), fmt::join(files, ", "));
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
      ->add_option(
          "--measured", arguments->measured,
          "measured values, a table (CSV, .xlsx) with a relaxation modulus, a creep compliance or dynamic moduli; with "
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
