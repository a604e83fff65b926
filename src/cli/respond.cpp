#include "breccia/study/respond.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/nearest_name.hpp"
#include "breccia/io/units.hpp"

#include "command.hpp"
#include "tables.hpp"

namespace breccia::cli {
namespace {

namespace fs = std::filesystem;

struct RespondArguments {
  fs::path results;
  fs::path material;
  std::string stage;  ///< empty: all that can
  std::vector<std::string> times;
  fs::path out;
  bool quiet = false;
};

/// The names of the stages that have a response, in alphabetical order.
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
    try {
      return parse_quantity(text, Dimension::time);
    } catch (const InputError& error) {
      throw InputError(fmt::format("--times: {}", error.what()));
    }
  };
  const TimeWindow window = {time(times[0]), time(times[1])};
  if (window.begin > 0.0 && window.begin < window.end) return window;
  throw InputError(fmt::format("--times: expected two rising times, got {} and {}", times[0], times[1]));
}

void run_respond(const RespondArguments& arguments) {
  const auto window = window_of(arguments.times);
  const auto material = read_material_file(arguments.material);
  std::vector<StoredResponses> stored;
  for (const auto& stage : chosen_stages(arguments)) {
    stored.push_back(read_responses(arguments.results / stage / "response.h5"));
  }
  // A stage alone takes the material itself, whatever its matrix was in the study.
  const auto results = arguments.stage.empty() ? respond(stored, material, window)
                                               : std::vector{respond(stored.front(), material, window)};
  const auto out = arguments.out.empty() ? arguments.results / ("respond-" + material.name) : arguments.out;
  write_response_curves(out, results);
  if (arguments.quiet) return;
  double error = 0.0;
  for (const auto& stage : results) {
    for (const auto& test : stage.tests) {
      if (const auto* record = std::get_if<QuasistaticRecord>(&test.record)) {
        error = std::max(error, record->response.error_estimate);
      }
    }
  }
  fmt::print(
      "{}\nwith {} as matrix; error of the reduced responses (at Laplace variables) about {:.1g} %\nCurves are in {}\n",
      tables_of(results, window.value_or(stored.front().times)), material.name, 100.0 * error, out.string());
}

}  // namespace

void add_respond(CLI::App& application) {
  auto* command =
      application.add_subcommand("respond", "the same microstructures with another matrix, from the results of a run");
  auto arguments = std::make_shared<RespondArguments>();
  command->add_option("DIR", arguments->results, "the results of `breccia run`")->required()->type_name("");
  command->add_option("--material", arguments->material, "the new matrix: a TOML file with the keys of a material")
      ->required()
      ->type_name("FILE.toml");
  command
      ->add_option("--stage", arguments->stage,
                   "one stage alone, with the material as its own matrix (default: all, each on what it builds on)")
      ->type_name("NAME");
  command
      ->add_option("--times", arguments->times,
                   R"(first and last time, such as "1 us" "1 s" (default: those of the run))")
      ->expected(2)
      ->type_name("BEGIN END");
  command->add_option("--out", arguments->out, "where the curves go (default: DIR/respond-<name of the material>)")
      ->type_name("DIR");
  command->add_flag("--quiet", arguments->quiet, "print nothing but errors");
  command->callback([arguments] { run_respond(*arguments); });
}

}  // namespace breccia::cli
