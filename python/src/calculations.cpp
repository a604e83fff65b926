#include "calculations.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "breccia/campaign/pack.hpp"
#include "breccia/campaign/run.hpp"
#include "breccia/deck/material_file.hpp"
#include "breccia/error.hpp"
#include "breccia/homogenisation/new_materials.hpp"
#include "breccia/homogenisation/packed_stage.hpp"
#include "breccia/homogenisation/respond.hpp"
#include "breccia/homogenisation/solve.hpp"
#include "breccia/parallel/session.hpp"
#include "breccia/results/stored_materials.hpp"
#include "breccia/study/identity.hpp"
#include "breccia/study/soundness.hpp"

#include "following.hpp"
#include "solution.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

SolveOptions options_of(int threads, bool ignore_memory) {
  if (threads < 0) throw InputError(fmt::format("threads: expected a number from 0, got {}", threads));
  return {.threads = threads, .ignore_memory = ignore_memory};
}

std::shared_ptr<Solution> solve_study(const std::shared_ptr<const Study>& study, int threads, bool ignore_memory,
                                      py::object show) {
  const auto options = options_of(threads, ignore_memory);
  Following following(std::move(show));
  FollowingSink sink(following);
  return calculate([&] { return solution_of(*study, solve(*study, options, sink)); });
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

/// How a study is run in a directory, as a caller asks for it.
struct Directory {
  std::filesystem::path path;
  bool resume = false;
  bool overwrite = false;
  std::optional<double> time_limit = {};  ///< [s]
};

/// A study in a directory, by a function of the library. A signal or the limit of time ends it after a checkpoint.
template <class Work>
std::shared_ptr<Solution> in_directory(const Study& study, const Directory& directory, const SolveOptions& solving,
                                       py::object show, const Work& work) {
  if (directory.resume && directory.overwrite) {
    throw InputError("overwrite starts a new run, resume continues the earlier one: expected only one of them");
  }
  Following following(std::move(show));
  RunOptions options = {.solve = solving, .resume = directory.resume, .overwrite = directory.overwrite};
  const auto begin = std::chrono::steady_clock::now();
  options.checkpoints.stop = [&] {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    return following.stop() || (directory.time_limit && passed.count() >= *directory.time_limit);
  };
  const auto observer = following.run_observer();
  try {
    return calculate([&] { return solution_of(study, work(study, directory.path, options, observer)); });
  } catch (const Interrupted&) {
    following.throw_interruption();
    throw;
  }
}

std::shared_ptr<Solution> run_in_directory(const std::shared_ptr<const Study>& study, const std::filesystem::path& path,
                                           bool resume, bool overwrite, std::optional<double> time_limit, int threads,
                                           bool ignore_memory, py::object show) {
  return in_directory(*study, {path, resume, overwrite, time_limit}, options_of(threads, ignore_memory),
                      std::move(show), [](const auto&... arguments) { return run_study(arguments...); });
}

std::shared_ptr<Solution> pack_in_directory(const std::shared_ptr<const Study>& study,
                                            const std::filesystem::path& path, bool overwrite, py::object show) {
  return in_directory(*study, {.path = path, .overwrite = overwrite}, {}, std::move(show),
                      [](const auto&... arguments) { return pack_study(arguments...); });
}

std::optional<TimeWindow> window_of(const std::optional<std::pair<double, double>>& times) {
  if (!times) return std::nullopt;
  const auto [begin, end] = *times;
  if (0.0 < begin && begin < end) return TimeWindow{begin, end};
  throw InputError(fmt::format("times: expected two rising times, got {} s and {} s", begin, end));
}

/// Adds the materials of the study that respond() needs and that are not replaced: matrices.
void add_matrices_of_study(const Solution& solution, std::map<std::string, Material>& materials) {
  for (const auto& one : solution.responses) {
    if (!std::holds_alternative<Material>(one.matrix)) continue;
    for (const auto& [material, shift] : solution.content.materials) {
      if (material.name == name_of(one.matrix)) materials.emplace(material.name, material);
    }
  }
}

/// The varying materials of the study at a temperature [K].
std::map<std::string, Material> materials_at(const Solution& solution, double temperature) {
  std::map<std::string, Material> materials;
  for (const auto& name : varying_materials(solution.responses)) {
    for (const auto& stored : solution.content.materials) {
      if (stored.material.name == name) materials.insert_or_assign(name, at_temperature(stored, temperature));
    }
  }
  return materials;
}

/// New materials for those that a study names.
struct Replacement {
  std::map<std::string, Material> materials;                      ///< by the names of those that they replace
  std::map<std::string, std::optional<TemperatureShift>> shifts;  ///< likewise
};

/// The materials of the study at another temperature [K], with the laws of their shifts.
Replacement at_other_temperature(const Solution& solution, double temperature) {
  Replacement replacement{materials_at(solution, temperature), {}};
  for (const auto& [material, shift] : solution.content.materials) {
    auto& moved = replacement.shifts[material.name] = shift;
    if (moved) moved->temperature = temperature;
  }
  return replacement;
}

/// Other materials, with the laws of their shifts, by the names that a caller has given.
Replacement by_names(const Solution& solution, const std::vector<std::pair<std::string, ShiftedMaterial>>& replaced) {
  std::vector<Material> of_study;
  of_study.reserve(solution.content.materials.size());
  for (const auto& [material, shift] : solution.content.materials) of_study.push_back(material);
  std::vector<NewMaterial> given;
  given.reserve(replaced.size());
  for (const auto& [name, one] : replaced) given.push_back({name, one.material});
  Replacement replacement{by_replaced_material(given, solution.responses, of_study), {}};
  for (const auto& one : given) {
    const auto found = by_replaced_material({one}, solution.responses, of_study).begin()->first;
    const auto place = static_cast<std::size_t>(&one - given.data());
    replacement.shifts[found] = replaced[place].second.shift;
  }
  return replacement;
}

/// Puts new materials in the place of those of a study.
void replace_materials(StudyContent& content, const Replacement& replacement) {
  for (auto& stored : content.materials) {
    const auto found = replacement.materials.find(stored.material.name);
    if (found == replacement.materials.end()) continue;
    stored.material = found->second;
    stored.material.name = found->first;
    stored.shift = replacement.shifts.at(found->first);
  }
}

/// The reduced responses of a study with new materials, at the times of a response: what another one starts from.
std::vector<StoredResponses> with_materials(std::vector<StoredResponses> responses, const StudyContent& content) {
  const auto replace = [&content](Material& material) {
    for (const auto& stored : content.materials) {
      if (stored.material.name == material.name) material = stored.material;
    }
  };
  for (auto& stored : responses) {
    stored.times = content.times;
    for (auto& [phase, material] : stored.other_phases) replace(material);
    if (auto* const matrix = std::get_if<Material>(&stored.matrix)) replace(*matrix);
  }
  return responses;
}

std::shared_ptr<Solution> respond_with(const Solution& solution,
                                       const std::vector<std::pair<std::string, ShiftedMaterial>>& replaced,
                                       std::optional<double> temperature,
                                       const std::optional<std::pair<double, double>>& times) {
  if (solution.responses.empty()) {
    throw InputError(
        "this result has no reduced responses, which the quasi-static method with the reduced solver leaves");
  }
  if (replaced.empty() == !temperature) throw InputError("expected other materials, or a temperature");
  const auto window = window_of(times);
  auto answer = std::make_shared<Solution>();
  answer->content = solution.content;
  answer->content.times = window.value_or(solution.content.times);
  return calculate([&] {
    auto replacement = temperature ? at_other_temperature(solution, *temperature) : by_names(solution, replaced);
    replace_materials(answer->content, replacement);
    auto& materials = replacement.materials;
    add_matrices_of_study(solution, materials);
    for (auto& stage : respond(solution.responses, materials, window)) {
      answer->stages.push_back({std::move(stage), std::nullopt});
    }
    answer->responses = with_materials(solution.responses, answer->content);
    return answer;
  });
}

}  // namespace

void bind_calculations(py::module_& module) {
  module.def("solve", &solve_study, py::arg("study"), py::arg("threads"), py::arg("ignore_memory"), py::arg("show"));
  module.def("pack", &pack_in_memory, py::arg("study"), py::arg("show"));
  module.def("pack_in_directory", &pack_in_directory, py::arg("study"), py::arg("directory"), py::arg("overwrite"),
             py::arg("show"));
  module.def("run", &run_in_directory, py::arg("study"), py::arg("directory"), py::arg("resume"), py::arg("overwrite"),
             py::arg("time_limit"), py::arg("threads"), py::arg("ignore_memory"), py::arg("show"));
  module.def("respond", &respond_with, py::arg("result"), py::arg("materials"), py::arg("temperature"),
             py::arg("times"));
  module.def("stop_parallel", &parallel::stop);
}

}  // namespace breccia::python
