#include "plans.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/plan.hpp"
#include "breccia/study/soundness.hpp"

#include "following.hpp"
#include "io/display.hpp"
#include "words.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

StudyPlan plan_study(const std::shared_ptr<const Study>& study) {
  return calculate([&] {
    require_sound(*study);
    return plan_of(*study);
  });
}

std::optional<double> cells_for(const StagePlan& stage, double error) {
  if (!(error > 0.0 && error < 1.0)) {
    throw InputError(fmt::format("error: expected a number between 0 and 1, such as 0.02, got {}", error));
  }
  return stage.grid ? stage.grid->cells_for(error) : std::nullopt;
}

const StagePlan& stage_named(const StudyPlan& plan, const std::string& name) {
  const auto stage = std::ranges::find(plan.stages, name, &StagePlan::stage);
  if (stage == plan.stages.end()) throw py::key_error(name);
  return *stage;
}

std::string error_in_words(const std::optional<double>& error) {
  return error ? fmt::format("{:.2g} %", 100.0 * *error) : "not known";
}

/// "mastic: box of 37.1 um, 22 x 22 x 22 cells, error of the grid 4 %, of the packing 7.7 %".
std::string in_words(const StagePlan& stage) {
  auto text = stage.stage + ":";
  if (stage.grid) text += fmt::format(" box of {},", display(stage.grid->side, "m"));
  std::vector<std::string> sizes;
  for (const auto& test : stage.tests) {
    if (std::ranges::find(sizes, test.size) == sizes.end()) sizes.push_back(test.size);
  }
  return text + fmt::format(" {}, error of the grid {}, of the packing {}", fmt::join(sizes, " and "),
                            error_in_words(stage.grid ? stage.grid->error() : std::nullopt),
                            error_in_words(stage.sample_error));
}

std::string plan_in_words(const StudyPlan& plan) {
  std::vector<std::string> stages;
  for (const auto& stage : plan.stages) stages.push_back(in_words(stage));
  return fmt::format("<breccia.Plan: about {} on one core, {:.3g} MB; {}>", display_duration(plan.seconds()),
                     plan.bytes() / 1e6, fmt::join(stages, "; "));
}

}  // namespace

void bind_plans(py::module_& module) {
  py::class_<TestPlan>(module, "TestPlan", "What a virtual test is expected to take.")
      .def_property_readonly("method", [](const TestPlan& test) { return name_of(test.method); })
      .def_property_readonly("boundary", [](const TestPlan& test) { return name_of(test.boundary); })
      .def_property_readonly(
          "load",
          [](const TestPlan& test) {
            return test.load ? std::optional(std::string(name_of(*test.load))) : std::nullopt;
          },
          "Of a dynamic test; a quasi-static one takes all loads: None.")
      .def_readonly("size", &TestPlan::size, "What it is computed with: \"100 x 100 cells\".")
      .def_readonly("seconds", &TestPlan::seconds, "Time [s], of a quasi-static test on one core.")
      .def_readonly("memory", &TestPlan::bytes, "Memory of the program [B].");
  py::class_<StagePlan>(module, "StagePlan", "What the tests of a stage are expected to take.")
      .def_readonly("name", &StagePlan::stage)
      .def_readonly("tests", &StagePlan::tests)
      .def_property_readonly(
          "grid_error", [](const StagePlan& stage) { return stage.grid ? stage.grid->error() : std::nullopt; },
          "Largest relative error [-] to be expected of the finest grid; None where there is no rule for it.")
      .def("cells_for", &cells_for, py::arg("error"),
           "Cells per side for a relative error [-] of the moduli; None where no rule tells them.")
      .def_property_readonly(
          "box", [](const StagePlan& stage) { return stage.grid ? std::optional(stage.grid->side) : std::nullopt; },
          "Side of the box [m], also where `accuracy` has chosen it; None of films.")
      .def_readonly("sample_error", &StagePlan::sample_error,
                    "Relative error [-] of one packing to be expected; None where there is no rule for it.")
      .def("__repr__", [](const StagePlan& stage) { return fmt::format("<breccia.StagePlan: {}>", in_words(stage)); })
      .def_readonly("warnings", &StagePlan::warnings)
      .def_readonly("remarks", &StagePlan::remarks,
                    "What is known beforehand of the tests: a range of moduli that takes far less time, and that "
                    "rounding may keep the tolerance from being met.");
  py::class_<StudyPlan>(module, "Plan", "What a study is expected to take.")
      .def_readonly("stages", &StudyPlan::stages)
      .def_property_readonly("seconds", &StudyPlan::seconds, "Time of all tests, one after the other [s].")
      .def_property_readonly("memory", &StudyPlan::bytes, "Memory of the largest test [B].")
      .def("__repr__", &plan_in_words)
      .def("__getitem__", &stage_named, py::arg("stage"), py::return_value_policy::reference_internal);
  module.def("plan", &plan_study, py::arg("study"));
}

}  // namespace breccia::python
