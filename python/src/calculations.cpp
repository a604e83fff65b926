#include "calculations.hpp"

#include <chrono>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "breccia/campaign/run.hpp"
#include "breccia/error.hpp"
#include "breccia/homogenisation/responder.hpp"
#include "breccia/homogenisation/solve.hpp"
#include "breccia/study/soundness.hpp"

#include "campaign/pack.hpp"
#include "following.hpp"
#include "homogenisation/run/packed_stage.hpp"
#include "parallel/session.hpp"
#include "solution.hpp"
#include "study/identity.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

SolveOptions options_of(int threads, bool ignore_memory) {
  if (threads < 0) throw InputError(fmt::format("threads: expected a number from 0, got {}", threads));
  return {.threads = threads, .ignore_memory = ignore_memory};
}

std::shared_ptr<Solution> solve_study(const std::shared_ptr<const Study>& study, int threads, bool ignore_memory,
                                      py::object show, py::object stop) {
  const auto options = options_of(threads, ignore_memory);
  Following following(std::move(show), std::move(stop));
  FollowingSink sink(following);
  return calculate([&] { return solution_of(*study, solve(*study, options, sink)); }, &following);
}

std::shared_ptr<Solution> pack_in_memory(const std::shared_ptr<const Study>& study, py::object show) {
  Following following(std::move(show));
  return calculate([&] {
    require_sound(*study);
    const auto follow = [&](const Progress& now) { following.follow(now); };
    const auto begin = std::chrono::steady_clock::now();
    StudyResult result;
    result.study_hash = provenance_of(*study).hash;
    for (const auto& stage : study->stages) {
      result.stages.push_back(packed_stage(*study, stage, make_microstructure(stage, follow)));
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return solution_of(*study, std::move(result));
  });
}

/// The options of a caller for the run of a study in a directory.
struct Directory {
  std::filesystem::path path;
  bool resume = false;
  bool overwrite = false;
};

/// Runs a study in a directory by a function of the library. A signal, or the caller's function `stop`, ends the
/// run after a checkpoint.
template <class Work>
std::shared_ptr<Solution> in_directory(const Study& study, const Directory& directory, const SolveOptions& solving,
                                       Following following, const Work& work) {
  if (directory.resume && directory.overwrite) {
    throw InputError("overwrite starts a new run, resume continues the earlier one: expected only one of them");
  }
  RunOptions options = {.solve = solving, .resume = directory.resume, .overwrite = directory.overwrite};
  options.checkpoints.stop = [&] { return following.stop(); };
  const auto observer = following.run_observer();
  try {
    return calculate([&] { return solution_of(study, work(study, directory.path, options, observer)); }, &following);
  } catch (const Interrupted&) {
    following.throw_interruption();
    throw;
  }
}

std::shared_ptr<Solution> run_in_directory(const std::shared_ptr<const Study>& study, const std::filesystem::path& path,
                                           bool resume, bool overwrite, int threads, bool ignore_memory,
                                           py::object show, py::object stop) {
  return in_directory(*study, {path, resume, overwrite}, options_of(threads, ignore_memory),
                      Following(std::move(show), std::move(stop)),
                      [](const auto&... arguments) { return run_study(arguments...); });
}

std::shared_ptr<Solution> pack_in_directory(const std::shared_ptr<const Study>& study,
                                            const std::filesystem::path& path, bool overwrite, py::object show) {
  return in_directory(*study, {.path = path, .overwrite = overwrite}, {}, Following(std::move(show)),
                      [](const auto&... arguments) { return pack_study(arguments...); });
}

std::optional<TimeWindow> window_of(const std::optional<std::pair<double, double>>& times) {
  if (!times) return std::nullopt;
  const auto [begin, end] = *times;
  if (0.0 < begin && begin < end) return TimeWindow{begin, end};
  throw InputError(fmt::format("times: expected two rising times, got {} s and {} s", begin, end));
}

std::optional<TimeWindow> window_of_frequencies(const std::pair<double, double>& frequencies) {
  const auto [begin, end] = frequencies;
  if (0.0 < begin && begin < end)
    return TimeWindow{1.0 / (2.0 * std::numbers::pi * end), 1.0 / (2.0 * std::numbers::pi * begin)};
  throw InputError(fmt::format("frequencies: expected two rising frequencies, got {} Hz and {} Hz", begin, end));
}

/// The new materials of a caller, by the names of those that they replace.
std::vector<NewMaterial> new_materials(const std::vector<std::pair<std::string, ShiftedMaterial>>& replaced) {
  std::vector<NewMaterial> materials;
  materials.reserve(replaced.size());
  for (const auto& [name, one] : replaced) materials.push_back(new_material(name, one));
  return materials;
}

std::shared_ptr<Solution> respond_with(const Solution& solution,
                                       const std::vector<std::pair<std::string, ShiftedMaterial>>& replaced,
                                       std::optional<double> temperature,
                                       const std::optional<std::pair<double, double>>& times,
                                       const std::optional<std::pair<double, double>>& frequencies) {
  if (solution.responses.empty()) {
    throw InputError(
        "this result has no reduced responses, which the quasi-static method with the reduced solver leaves");
  }
  if (replaced.empty() == !temperature) throw InputError("expected other materials, or a temperature");
  if (times && frequencies) throw InputError("respond: expected times or frequencies, got both");
  const auto window =
      (frequencies ? window_of_frequencies(*frequencies) : window_of(times)).value_or(solution.content.times);
  const bool by_frequency = frequencies || (!times && solution.content.by_frequency);
  return calculate([&] {
    const auto base = Responder(solution.responses, solution.content.materials)
                          .within(window)
                          .over(by_frequency ? Abscissa::frequency : Abscissa::time);
    const auto responder = temperature ? base.at(*temperature) : base.with(new_materials(replaced));
    auto found = std::make_shared<Solution>();
    for (auto& stage : responder.respond()) {
      found->stages.push_back({std::move(stage), std::nullopt});
    }
    found->content = solution.content;
    found->content.times = window;
    found->content.by_frequency = by_frequency;
    found->content.materials = responder.materials();
    found->responses = responder.stages();
    return found;
  });
}

}  // namespace

void bind_calculations(py::module_& module) {
  module.def("solve", &solve_study, py::arg("study"), py::arg("threads"), py::arg("ignore_memory"), py::arg("show"),
             py::arg("stop"));
  module.def("pack", &pack_in_memory, py::arg("study"), py::arg("show"));
  module.def("pack_in_directory", &pack_in_directory, py::arg("study"), py::arg("directory"), py::arg("overwrite"),
             py::arg("show"));
  module.def("run", &run_in_directory, py::arg("study"), py::arg("directory"), py::arg("resume"), py::arg("overwrite"),
             py::arg("threads"), py::arg("ignore_memory"), py::arg("show"), py::arg("stop"));
  module.def("respond", &respond_with, py::arg("result"), py::arg("materials"), py::arg("temperature"),
             py::arg("times"), py::arg("frequencies"));
  module.def("stop_parallel", [] {
    end_calculations();
    parallel::stop();
  });
}

}  // namespace breccia::python
