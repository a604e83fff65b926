#include "breccia/homogenisation/respond.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/deck/material_file.hpp"
#include "breccia/error.hpp"
#include "breccia/io/nearest_name.hpp"
#include "breccia/io/units.hpp"
#include "breccia/results/response_curves.hpp"
#include "breccia/results/response_file.hpp"
#include "breccia/results/stored_materials.hpp"

#include "advice.hpp"
#include "command.hpp"
#include "tables.hpp"

namespace breccia::cli {
namespace {

namespace fs = std::filesystem;

struct RespondArguments {
  fs::path results;
  fs::path material;                      ///< file of the new matrix; empty: temperatures are given
  std::vector<std::string> temperatures;  ///< new temperatures of the matrix of the study
  std::string stage;                      ///< empty: all stages with responses
  std::vector<std::string> times;
  fs::path out;
  bool overwrite = false;
  bool quiet = false;
};

/// The results of the stages with one new matrix.
struct Answer {
  std::string matrix;  ///< description of the matrix
  fs::path out;
  std::string study;  ///< hash of the study with the reduced responses
  std::vector<StageResult> stages = {};
  std::vector<std::string> warnings = {};  ///< on the matrix
};

/// The names of the stages that have reduced responses, in alphabetical order.
std::vector<std::string> stages_with_response(const fs::path& results) {
  if (!fs::is_directory(results)) throw InputError(fmt::format("{}: no such directory", results.string()));
  std::vector<std::string> stages;
  for (const auto& entry : fs::directory_iterator(results)) {
    if (fs::exists(entry.path() / "response.h5")) stages.push_back(entry.path().filename().string());
  }
  std::ranges::sort(stages);
  if (!stages.empty()) return stages;
  throw InputError(fmt::format(
      "{}: no stage with a response.h5, which `breccia run` leaves for tests by the quasi-static method with "
      "the reduced solver",
      results.string()));
}

std::vector<std::string> chosen_stages(const RespondArguments& arguments) {
  auto stages = stages_with_response(arguments.results);
  if (arguments.stage.empty()) return stages;
  if (std::ranges::find(stages, arguments.stage) != stages.end()) return {arguments.stage};
  throw InputError(fmt::format("{}: no response of a stage \"{}\"{}", arguments.results.string(), arguments.stage,
                               suggestion(arguments.stage, stages)));
}

std::optional<TimeWindow> window_of(const std::vector<std::string>& times) {
  if (times.empty()) return {};
  const auto time = [](const std::string& text) {
    return option_quantity("--times", text, Dimension::time, Range::positive());
  };
  const TimeWindow window = {time(times[0]), time(times[1])};
  if (window.begin < window.end) return window;
  throw InputError(fmt::format("--times: expected two rising times, got {} and {}", times[0], times[1]));
}

std::vector<StoredResponses> responses_of(const RespondArguments& arguments) {
  std::vector<StoredResponses> stored;
  for (const auto& stage : chosen_stages(arguments)) {
    const auto file = arguments.results / stage / "response.h5";
    stored.push_back(read_responses(file));
    if (stored.back().stage == stage) continue;
    throw InputError(
        fmt::format("{}: the responses are of stage {}, not of one with the name of the directory, {}; move the copy "
                    "out of {}",
                    file.string(), stored.back().stage, stage, arguments.results.string()));
  }
  return stored;
}

Answer answer_for_material(const RespondArguments& arguments, const std::optional<TimeWindow>& window) {
  const auto material = read_material_file(arguments.material);
  const auto stored = responses_of(arguments);
  const auto own = arguments.results / ("respond-" + material.name);
  // A single stage gets the material as its matrix, even if its matrix was an earlier stage in the study.
  return {material.name, arguments.out.empty() ? own : arguments.out, stored.front().deck_hash,
          arguments.stage.empty() ? respond(stored, material, window)
                                  : std::vector{respond(stored.front(), material, window)}};
}

/// A requested temperature.
struct AskedTemperature {
  double kelvin;
  std::string name;       ///< "-40 degC"
  std::string directory;  ///< "respond-minus40degC"
};

AskedTemperature read_temperature(const std::string& text) {
  constexpr double zero_celsius = 273.15, smallest = 1e-6;
  const double kelvin = parse_quantity(text, Dimension::temperature);
  if (kelvin < 0.0) throw InputError(fmt::format("expected a temperature above absolute zero, got \"{}\"", text));
  const double celsius = std::round((kelvin - zero_celsius) / smallest) * smallest;
  return {kelvin, fmt::format("{:.6g} degC", celsius),
          fmt::format("respond-{}{:.6g}degC", celsius < 0.0 ? "minus" : "", std::abs(celsius))};
}

/// Does what may throw InputError, and keeps the message, with the options of the command that help.
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

/// Names of the materials that the stages have as matrix, and of those of their other phases whose moduli vary.
std::vector<std::string> varying_materials(const std::vector<StoredResponses>& stored) {
  std::vector<std::string> names;
  for (const auto& one : stored) {
    if (std::holds_alternative<Material>(one.matrix)) names.push_back(name_of(one.matrix));
    for (const auto& [phase, material] : one.other_phases) names.push_back(material.name);
  }
  return names;
}

/// The varying materials of the stages at one temperature, by their names.
std::map<std::string, Material> materials_at(const std::vector<StoredMaterial>& materials,
                                             const std::vector<StoredResponses>& stored,
                                             const AskedTemperature& temperature) {
  std::map<std::string, Material> shifted;
  for (const auto& name : varying_materials(stored)) {
    const auto found = std::ranges::find(materials, name, [](const auto& each) { return each.material.name; });
    if (found == materials.end()) throw InputError(fmt::format("study.json has no material \"{}\"", name));
    auto material = at_temperature(*found, temperature.kelvin);
    material.name = fmt::format("{} at {}", name, temperature.name);
    shifted.insert_or_assign(name, std::move(material));
  }
  return shifted;
}

/// A warning on each matrix that is the same at all temperatures.
std::vector<std::string> warnings_on_matrices(const std::map<std::string, Material>& matrices) {
  std::vector<std::string> warnings;
  for (const auto& [original, material] : matrices) {
    if (!material.bulk.is_elastic() || !material.shear.is_elastic()) continue;
    warnings.push_back(fmt::format(
        "{} is elastic: its moduli do not depend on the temperature here, so they are those of the run", original));
  }
  return warnings;
}

/// The new matrix in words: "binder at 40 degC", or several if stages have different matrices.
std::string names_of(const std::map<std::string, Material>& matrices) {
  std::vector<std::string> names;
  names.reserve(matrices.size());
  for (const auto& [original, material] : matrices) names.push_back(material.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// The responses of the requested stage and of the stages that it builds on.
std::vector<StoredResponses> with_earlier_stages(std::vector<StoredResponses> stored, const std::string& stage) {
  std::vector<StoredResponses> chain;
  for (auto wanted = stage; chain.size() < stored.size();) {
    const auto found = std::ranges::find(stored, wanted, &StoredResponses::stage);
    if (found == stored.end()) break;
    chain.push_back(*found);
    if (std::holds_alternative<Material>(found->matrix)) break;
    wanted = name_of(found->matrix);
  }
  return chain;
}

std::vector<Answer> answers_at_temperatures(const RespondArguments& arguments, const std::optional<TimeWindow>& window,
                                            const CLI::App& command) {
  const auto temperatures = read_temperatures(arguments.temperatures, command);
  auto of_all_stages = arguments;
  of_all_stages.stage.clear();
  static_cast<void>(chosen_stages(arguments));
  auto stored = responses_of(of_all_stages);
  if (!arguments.stage.empty()) stored = with_earlier_stages(std::move(stored), arguments.stage);
  const auto study = read_stored_materials(arguments.results);
  for (const auto& one : stored) {
    if (one.deck_hash == study.deck_hash) continue;
    throw InputError(
        fmt::format("{}: the responses of stage {} are of another study (deck hash {}) than study.json ({})",
                    arguments.results.string(), one.stage, one.deck_hash, study.deck_hash));
  }
  const auto parent = arguments.out.empty() ? arguments.results : arguments.out;
  const bool is_out_for_one = temperatures.size() == 1 && !arguments.out.empty();
  std::vector<Answer> answers;
  std::vector<std::string> mistakes;
  for (const auto& temperature : temperatures) {
    collect(mistakes, fmt::format("at {}: ", temperature.name), command, [&] {
      const auto matrices = materials_at(study.materials, stored, temperature);
      answers.push_back({names_of(matrices), is_out_for_one ? arguments.out : parent / temperature.directory,
                         study.deck_hash, respond(stored, matrices, window), warnings_on_matrices(matrices)});
    });
  }
  refuse(mistakes);
  return answers;
}

void print(const Answer& answer, const TimeWindow& times) {
  for (const auto& warning : answer.warnings) fmt::print("warning: {}\n", warning);
  for (const auto& stage : answer.stages) {
    for (const auto& warning : stage.warnings) fmt::print("warning: {}\n", warning);
  }
  double error = 0.0;
  for (const auto& stage : answer.stages) {
    for (const auto& test : stage.tests) {
      if (const auto* record = std::get_if<QuasistaticRecord>(&test.record)) {
        error = std::max(error, record->response.error_estimate);
      }
    }
  }
  fmt::print(
      "{}\nwith {} as matrix; error of the reduced responses (at the Laplace variables of these times) about {:.1g} %\n"
      "Curves are in {}\n",
      tables_of(answer.stages, times), answer.matrix, 100.0 * error, answer.out.string());
}

/// First and last time of the curves of several stages.
TimeWindow times_of(const std::vector<StageResult>& stages) {
  const auto& curve = stages.front().tests.front().modulus;
  return {curve.front().time, curve.back().time};
}

void run_respond(const RespondArguments& arguments, const CLI::App& command) {
  const bool has_material = !arguments.material.empty();
  if (has_material == !arguments.temperatures.empty()) {
    throw InputError(
        "respond: expected a new matrix, either --material FILE.toml or --temperature \"40 degC\" (several times for "
        "several temperatures)");
  }
  const auto window = window_of(arguments.times);
  const auto answers = has_material ? std::vector{answer_for_material(arguments, window)}
                                    : answers_at_temperatures(arguments, window, command);
  std::vector<fs::path> inputs;
  if (has_material) inputs.push_back(arguments.material);
  for (const auto& [matrix, out, study, stages, warnings] : answers) {
    write_response_curves({out, matrix, study, inputs, arguments.overwrite}, stages);
  }
  if (arguments.quiet) return;
  for (const auto& answer : answers) print(answer, times_of(answer.stages));
}

}  // namespace

void add_respond(CLI::App& application) {
  auto* command = application.add_subcommand(
      "respond", "compute the curves of a run with another matrix or at another temperature, from its results");
  auto arguments = std::make_shared<RespondArguments>();
  command->add_option("DIR", arguments->results, "the results of `breccia run`")->required()->type_name("");
  command->add_option("--material", arguments->material, "the new matrix: a TOML file with the keys of a material")
      ->type_name("FILE.toml");
  command
      ->add_option("--temperature", arguments->temperatures,
                   R"(another temperature of the matrix, such as "40 degC"; may be repeated)")
      ->expected(1)
      ->take_all()
      ->type_name("TEMPERATURE");
  command
      ->add_option("--stage", arguments->stage,
                   "compute this stage alone, with the material as its matrix; with --temperature also the stages "
                   "that it builds on (default: all stages)")
      ->type_name("NAME");
  command
      ->add_option("--times", arguments->times,
                   R"(first and last time, such as "1 us" "1 s" (default: those of the run))")
      ->expected(2)
      ->type_name("BEGIN END");
  command
      ->add_option("--out", arguments->out, "directory for the curves (default: DIR/respond-<material or temperature>)")
      ->type_name("DIR");
  command->add_flag("--overwrite", arguments->overwrite,
                    "replace the curves of another matrix or of other times in that directory");
  command->add_flag("--quiet", arguments->quiet, "print nothing but errors");
  command->callback([arguments, command] { run_respond(*arguments, *command); });
}

}  // namespace breccia::cli
