#include "stored_results.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include <pybind11/stl/filesystem.h>

#include "results/stored_study.hpp"
#include "solution.hpp"

namespace breccia::python {
namespace {

std::shared_ptr<Solution> solution_in(const std::filesystem::path& directory) {
  const pybind11::gil_scoped_release release;
  auto stored = read_stored_study(directory);
  auto solution = std::make_shared<Solution>();
  solution->content = std::move(stored.content);
  solution->seconds = stored.seconds;
  solution->responses = std::move(stored.responses);
  for (auto& stage : stored.stages) solution->stages.push_back({std::move(stage), std::nullopt});
  return solution;
}

}  // namespace

void bind_stored_results(pybind11::module_& module) {
  module.def("read_results", &solution_in, pybind11::arg("directory"));
}

}  // namespace breccia::python
