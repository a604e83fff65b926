#include "studies.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "breccia/deck/read_study.hpp"
#include "breccia/deck/read_sweep.hpp"
#include "breccia/study/study.hpp"

#include "io/display.hpp"
#include "materials.hpp"
#include "study/identity.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

/// The names of the arguments in messages.
const ValueOrigins& origins_in_python() {
  static const ValueOrigins origins = {.overrides = "overrides", .sweep_keys = "sweep"};
  return origins;
}

/// The studies of a sweep by the names of its tasks, in their order.
py::list tasks_of(const std::filesystem::path& deck, const std::vector<std::string>& overrides,
                  const std::vector<std::string>& keys) {
  py::list tasks;
  for (auto& task : read_sweep(deck, overrides, keys, origins_in_python()).tasks) {
    tasks.append(py::make_tuple(task.name, std::make_shared<Study>(std::move(task.study))));
  }
  return tasks;
}

std::vector<std::string> stage_names(const Study& study) {
  std::vector<std::string> names;
  for (const auto& stage : study.stages) names.push_back(stage.name);
  return names;
}

}  // namespace

void bind_studies(py::module_& module) {
  py::class_<Study, std::shared_ptr<Study>>(module, "CheckedStudy", "A study without mistakes, in SI units.")
      .def_readonly("title", &Study::title)
      .def_property_readonly("stages", &stage_names, "Names of the stages, from the smallest scale up.")
      .def_property_readonly(
          "materials", [](const Study& study) { return without_shifts(study.materials); }, "A Solid each.")
      .def_property_readonly(
          "times", [](const Study& study) { return py::make_tuple(study.tests.first_time, study.tests.last_time); },
          "First and last time of the curves [s].")
      .def_property_readonly("hash", [](const Study& study) { return provenance_of(study).hash; })
      .def_property_readonly(
          "deck", [](const Study& study) { return study.provenance.deck_text; }, "Text of the deck.")
      .def_property_readonly("overrides", [](const Study& study) { return study.provenance.overrides; })
      .def("__repr__", [](const Study& study) {
        return fmt::format("<breccia.Study {}: stage {}, {} to {}>", study.title,
                           fmt::join(stage_names(study), ", stage "), display_time(study.tests.first_time),
                           display_time(study.tests.last_time));
      });
  module.def(
      "read_study",
      [](const std::filesystem::path& deck, const std::vector<std::string>& overrides) {
        return std::make_shared<Study>(read_study(deck, overrides, origins_in_python()));
      },
      py::arg("deck"), py::arg("overrides"));
  module.def("read_sweep", &tasks_of, py::arg("deck"), py::arg("overrides"), py::arg("keys"));
  module.def(
      "study_from_text",
      [](const std::string& deck, const std::filesystem::path& directory, const std::vector<std::string>& overrides) {
        return std::make_shared<Study>(study_from_text(deck, directory, overrides, origins_in_python()));
      },
      py::arg("deck"), py::arg("directory"), py::arg("overrides"));
}

}  // namespace breccia::python
