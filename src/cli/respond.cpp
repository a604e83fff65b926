#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/responder.hpp"
#include "breccia/results/stored_responder.hpp"

#include "cli/advice.hpp"
#include "cli/asked_temperature.hpp"
#include "cli/command.hpp"
#include "cli/comparison_tables.hpp"
#include "cli/tables.hpp"
#include "deck/material_file.hpp"
#include "results/response_curves.hpp"
#include "study/abscissa_words.hpp"

namespace breccia::cli {
namespace {

namespace fs = std::filesystem;

struct RespondArguments {
  fs::path results;
  std::vector<std::string> materials;     ///< new materials, FILE (of the matrix) or NAME=FILE
  std::vector<std::string> temperatures;  ///< new temperatures of the matrix of the study
  std::string stage;                      ///< name of the stage; empty: all stages with responses
  std::vector<std::string> times, frequencies;
  fs::path out;
  bool overwrite = false;
  bool quiet = false;
};

/// The stages of a study with other materials.
struct RespondedStudy {
  std::string name;       ///< name of the materials in the results: "aged", "binder at 40 degC"
  std::string materials;  ///< materials in a sentence: "aged as matrix, soft as interphase"
  fs::path out;
  std::string study;  ///< hash of the study with the reduced responses
  std::vector<StageResult> stages = {};
};

/// Two rising values of an option.
std::array<double, 2> rising(const std::string& option, const std::vector<std::string>& texts, Dimension dimension) {
  const auto value = [&](const std::string& text) {
    return option_quantity(option, text, dimension, Range::positive());
  };
  const std::array ends = {value(texts[0]), value(texts[1])};
  if (ends[0] < ends[1]) return ends;
  throw InputError(fmt::format("{}: expected two rising {}, got {} and {}", option,
                               dimension == Dimension::time ? "times" : "frequencies", texts[0], texts[1]));
}

/// The responder with the abscissa and the ends that are asked for; by default those of the study.
Responder within_asked(Responder responder, const RespondArguments& arguments) {
  if (!arguments.times.empty()) {
    const auto [begin, end] = rising("--times", arguments.times, Dimension::time);
    return responder.within({begin, end}).over(Abscissa::time);
  }
  if (arguments.frequencies.empty()) return responder;
  const auto [begin, end] = rising("--frequencies", arguments.frequencies, Dimension::frequency);
  return responder.within({hertz_of(end), hertz_of(begin)}).over(Abscissa::frequency);
}

/// Runs an action. If it throws InputError, keeps the message, with the options of the command that help.
template <class Action>
void collect(std::vector<std::string>& mistakes, const std::string& prefix, const CLI::App& command,
             const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    mistakes.push_back(prefix + with_advice(error, command));
  }
}

void refuse(const std::vector<std::string>& mistakes) {
  if (!mistakes.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes, "\n")));
}

std::vector<AskedTemperature> read_temperatures(const std::vector<std::string>& texts, const CLI::App& command) {
  std::vector<AskedTemperature> temperatures;
  std::vector<std::string> mistakes;
  for (const auto& text : texts) {
    collect(mistakes, "--temperature: ", command, [&] {
      auto temperature = read_temperature(text);
      if (std::ranges::find(temperatures, temperature.directory, &AskedTemperature::directory) != temperatures.end()) {
        throw InputError(fmt::format("{} is given twice", temperature.name));
      }
      temperatures.push_back(std::move(temperature));
    });
  }
  refuse(mistakes);
  return temperatures;
}

RespondedStudy responded(const Responder& responder, std::string name, std::string materials, fs::path out) {
  return {std::move(name), std::move(materials), std::move(out), responder.stages().front().deck_hash,
          responder.respond()};
}

/// The responder of one stage and the stages that it builds on; of all stages for an empty name.
Responder with_chosen_stages(Responder responder, const std::string& stage) {
  return stage.empty() ? std::move(responder) : responder.chain_of(stage);
}

std::vector<RespondedStudy> respond_at_temperatures(const RespondArguments& arguments, const Responder& all_stages,
                                                    const CLI::App& command) {
  const auto temperatures = read_temperatures(arguments.temperatures, command);
  const auto responder = with_chosen_stages(all_stages, arguments.stage);
  const auto parent = arguments.out.empty() ? arguments.results : arguments.out;
  const bool is_out_for_one = temperatures.size() == 1 && !arguments.out.empty();
  std::vector<RespondedStudy> studies;
  std::vector<std::string> mistakes;
  for (const auto& temperature : temperatures) {
    collect(mistakes, fmt::format("at {}: ", temperature.name), command, [&] {
      const auto moved = responder.at(temperature.kelvin);
      const auto names = moved.shown_names();
      const auto name = fmt::format("{}", fmt::join(names, ", "));
      studies.push_back(responded(moved, name, names.size() == 1 ? name + " as matrix" : name,
                                  is_out_for_one ? arguments.out : parent / temperature.directory));
    });
  }
  refuse(mistakes);
  return studies;
}

/// A new material from the command line: FILE, which is the matrix, or NAME=FILE.
struct AskedMaterial {
  std::string name;  ///< name of the material or the phase that it replaces
  fs::path file;
};

/// A file with an equals sign in its name is the matrix, unless what follows the sign is a file, too.
AskedMaterial read_asked_material(const std::string& text) {
  const auto sign = text.find('=');
  if (sign == std::string::npos) return {std::string(name_of_matrix_phase), text};
  const auto name = text.substr(0, sign), file = text.substr(sign + 1);
  if (fs::exists(text) && (file.empty() || !fs::exists(file))) return {std::string(name_of_matrix_phase), text};
  if (name.empty() || file.empty()) {
    throw InputError(fmt::format("--material: expected FILE.toml or NAME=FILE.toml, got \"{}\"", text));
  }
  return {name, file};
}

/// The files of the new materials. Files that cannot be read leave a material without moduli, and a mistake.
std::vector<NewMaterial> read_materials(const std::vector<AskedMaterial>& asked, const CLI::App& command,
                                        std::vector<std::string>& mistakes) {
  std::vector<NewMaterial> materials;
  for (const auto& [name, file] : asked) {
    auto& material = materials.emplace_back(NewMaterial{name, {}});
    collect(mistakes, "", command,
            [&, &path = file] { material = new_material(material.name, read_shifted_material_file(path)); });
  }
  return materials;
}

RespondedStudy respond_with_materials(const RespondArguments& arguments, const Responder& all_stages,
                                      const std::vector<AskedMaterial>& asked, const CLI::App& command) {
  std::vector<std::string> mistakes;
  const auto is_matrix = [](const AskedMaterial& one) { return one.name == name_of_matrix_phase; };
  const auto given = read_materials(asked, command, mistakes);
  // A stage that gets a matrix of its own needs none of the stages that it builds on.
  const bool is_alone = !arguments.stage.empty() && std::ranges::any_of(asked, is_matrix);
  auto responder = is_alone ? all_stages.alone(arguments.stage) : with_chosen_stages(all_stages, arguments.stage);
  collect(mistakes, "", command, [&] { responder = responder.with(given); });
  refuse(mistakes);
  std::vector<std::string> names, described;
  for (const auto& [name, material, shift] : given) {
    names.push_back(material.name);
    described.push_back(fmt::format("{} as {}", material.name, name));
  }
  const auto description = fmt::format("{}", fmt::join(described, ", "));
  const bool is_matrix_alone = asked.size() == 1 && is_matrix(asked.front());
  const auto own = arguments.results / fmt::format("respond-{}", fmt::join(names, "-"));
  return responded(responder, is_matrix_alone ? names.front() : description, description,
                   arguments.out.empty() ? own : arguments.out);
}

/// Prints the warnings that were not printed for earlier studies.
void print_warnings(const RespondedStudy& study, std::FILE* stream, std::set<std::string>& printed) {
  for (const auto& stage : study.stages) {
    for (const auto& warning : stage.warnings) {
      if (printed.insert(warning).second) fmt::print(stream, "warning: {}\n", warning);
    }
  }
}

void print(const RespondedStudy& study, const TimeWindow& times, Abscissa abscissa) {
  double error = 0.0;
  std::string tables, accuracies;
  for (const auto& stage : study.stages) {
    tables += tables_of(stage, times, abscissa);
    accuracies += fmt::format("{}: {}\n", stage.name, stage.accuracy.summary);
    for (const auto& test : stage.tests) {
      if (!std::isnan(test.error_estimate)) error = std::max(error, test.error_estimate);
    }
  }
  fmt::print(
      "{}{}\n{}with {}; error of the reduced responses (at the Laplace variables of these times) about {:.1g} %\n"
      "Curves are in {}\n",
      tables, comparison_tables_of(study.stages, abscissa), accuracies, study.materials, 100.0 * error,
      study.out.string());
}

/// First and last time of the curves of several stages.
TimeWindow times_of(const std::vector<StageResult>& stages) {
  const auto& curve = stages.front().tests.front().modulus;
  return {curve.front().time, curve.back().time};
}

void run_respond(const RespondArguments& arguments, const CLI::App& command) {
  const bool has_material = !arguments.materials.empty();
  if (has_material == !arguments.temperatures.empty()) {
    throw InputError(
        "respond: expected other materials, either --material FILE.toml or --temperature \"40 degC\" (each may be "
        "repeated; --material NAME=FILE.toml replaces another material than the matrix)");
  }
  std::vector<AskedMaterial> asked;
  for (const auto& text : arguments.materials) asked.push_back(read_asked_material(text));
  const auto responder = within_asked(read_responder(arguments.results), arguments);
  const auto& asked_of_all = responder.stages().front();
  FrequencyRows rows;
  if (asked_of_all.abscissa == Abscissa::frequency) rows.hertz_per_decade = asked_of_all.points_per_decade;
  const auto studies = has_material ? std::vector{respond_with_materials(arguments, responder, asked, command)}
                                    : respond_at_temperatures(arguments, responder, command);
  std::vector<fs::path> inputs;
  inputs.reserve(asked.size());
  for (const auto& [name, file] : asked) inputs.push_back(file);
  for (const auto& [name, materials, out, study, stages] : studies) {
    write_response_curves({out, name, study, inputs, rows, arguments.overwrite}, stages);
  }
  std::set<std::string> printed;
  for (const auto& study : studies) {
    print_warnings(study, arguments.quiet ? stderr : stdout, printed);
    if (!arguments.quiet) print(study, times_of(study.stages), asked_of_all.abscissa);
  }
}

}  // namespace

void add_respond(CLI::App& application) {
  auto* command = application.add_subcommand(
      "respond", "compute the curves of a run with other materials or at another temperature, from its results");
  auto arguments = std::make_shared<RespondArguments>();
  command->add_option("DIR", arguments->results, "the results of `breccia run`")->required()->type_name("");
  command
      ->add_option("--material", arguments->materials,
                   "a new material: a TOML file with the keys of a material, which becomes the matrix, or takes the "
                   "place of the material or phase NAME; may be repeated")
      ->expected(1)
      ->take_all()
      ->type_name("[NAME=]FILE.toml");
  command
      ->add_option("--temperature", arguments->temperatures,
                   R"(another temperature of the materials that relax, such as "40 degC"; may be repeated)")
      ->expected(1)
      ->take_all()
      ->type_name("TEMPERATURE");
  command
      ->add_option("--stage", arguments->stage,
                   "compute this stage alone, if its matrix is given by --material; otherwise also the stages that it "
                   "builds on (default: all stages)")
      ->type_name("NAME");
  auto* times = command
                    ->add_option("--times", arguments->times,
                                 R"(first and last time, such as "1 us" "1 s" (default: those of the run))")
                    ->expected(2)
                    ->type_name("BEGIN END");
  command
      ->add_option("--frequencies", arguments->frequencies,
                   R"(first and last frequency, such as "0.1 Hz" "100 Hz", of |G*|, phase, G', G'' and tan delta )"
                   "(default: those of the run, if its deck has frequencies)")
      ->expected(2)
      ->type_name("BEGIN END")
      ->excludes(times);
  command
      ->add_option("--out", arguments->out, "directory for the curves (default: DIR/respond-<material or temperature>)")
      ->type_name("DIR");
  command->add_flag("--overwrite", arguments->overwrite,
                    "replace the curves of other materials or of other times in that directory");
  command->add_flag("--quiet", arguments->quiet, "print nothing but warnings and errors");
  command->callback([arguments, command] { run_respond(*arguments, *command); });
}

}  // namespace breccia::cli
