#include "assessments.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "breccia/deck/deck_assessment.hpp"
#include "breccia/error.hpp"

#include "calibrations.hpp"
#include "deck/calibrated_inputs.hpp"
#include "deck/sought_input.hpp"
#include "following.hpp"
#include "solution.hpp"
#include "views.hpp"
#include "words.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

py::tuple ends_of(const std::vector<std::optional<Interval>>& intervals) {
  std::vector<double> lower, upper;
  for (const auto& interval : intervals) {
    lower.push_back(interval ? interval->lower : not_known);
    upper.push_back(interval ? interval->upper : not_known);
  }
  return py::make_tuple(array_of(lower), array_of(upper));
}

/// The shares of each input, by its name.
py::dict shares_of(const Eigen::MatrixXd& shares, const std::vector<UncertainInput>& inputs) {
  py::dict by_name;
  for (std::size_t input = 0; input < inputs.size(); ++input) {
    const Eigen::VectorXd own = shares.row(static_cast<Eigen::Index>(input));
    by_name[py::str(inputs[input].name)] = own;
  }
  return by_name;
}

py::dict dict_of(const AssessedCurve& curve, const std::vector<UncertainInput>& inputs) {
  std::vector<double> errors;
  for (const auto& error : curve.errors) errors.push_back(error.value_or(not_known));
  py::dict entries;
  entries["name"] = curve.name;
  entries["unit"] = curve.unit;
  entries["at"] = array_of(curve.at);
  entries["reference"] = array_of(curve.reference);
  entries["median"] = array_of(curve.median);
  entries["inputs"] = ends_of({curve.of_inputs.begin(), curve.of_inputs.end()});
  entries["error"] = array_of(errors);
  entries["whole"] = ends_of(curve.whole);
  entries["alone"] = shares_of(curve.alone, inputs);
  entries["total"] = shares_of(curve.total, inputs);
  entries["interactions"] = array_of(interactions_of(curve));
  entries["unexplained"] = array_of(curve.unexplained);
  return entries;
}

py::dict dict_of(const Assessment& assessment) {
  py::list curves;
  for (const auto& curve : assessment.curves) curves.append(dict_of(curve, assessment.inputs));
  std::vector<std::string> names;
  for (const auto& input : assessment.inputs) names.push_back(input.name);
  py::dict entries;
  entries["curves"] = curves;
  entries["inputs"] = names;
  entries["samples"] = assessment.samples;
  entries["boxes"] = assessment.boxes;
  entries["warnings"] = assessment.warnings;
  return entries;
}

/// The assessment of a deck in a file or, without its path, of its text.
DeckAssessment assessment_of(const std::optional<std::filesystem::path>& deck, const std::string& text,
                             const std::filesystem::path& directory, const std::vector<std::string>& overrides,
                             int samples, int boxes, std::uint64_t seed) {
  const AssessmentOptions options = {samples, boxes, seed};
  const ValueOrigins origins = {.overrides = "overrides", .sweep_keys = "sweep"};
  if (deck) return {*deck, overrides, options, origins};
  return DeckAssessment::from_text(text, directory, overrides, options, origins);
}

/// What was measured of the composite of a deck; nothing where no file is named.
MeasuredComposite measured_by(const DeckAssessment& deck, const std::vector<std::filesystem::path>& files,
                              const std::optional<std::string>& modulus, std::optional<double> noise,
                              std::optional<double> model_error) {
  AskedObservations asked = {.data = {}, .modulus = modulus_named(modulus), .noise = noise};
  for (const auto& file : files) asked.data.push_back({0, file});
  return files.empty() ? MeasuredComposite{} : read_measured_composite(deck, asked, model_error);
}

std::vector<StageFindings> findings_of(const Solution& solution) {
  std::vector<StageFindings> findings;
  for (const auto& one : solution.stages) findings.push_back(one.result);
  return findings;
}

/// The curves of a stage in all samples of a deck, from the solutions of its studies.
std::vector<SampledCurve> curves_of(const DeckAssessment& deck, const std::vector<std::shared_ptr<Solution>>& solved,
                                    const std::string& stage, int threads) {
  std::vector<Responder> responders;
  for (const auto& solution : solved) responders.emplace_back(solution->responses, solution->content.materials);
  return deck.curves(responders, findings_of(*solved.front()), stage, threads);
}

FoundDesign find_with(const DeckAssessment& deck, const std::vector<std::shared_ptr<Solution>>& solved,
                      const SoughtInput& sought, const std::string& stage, int threads) {
  return calculate([&] { return find_input(deck, curves_of(deck, solved, stage, threads), sought); });
}

/// What the composite has over the range that was searched.
py::dict points_of(const FoundDesign& design) {
  std::vector<double> inputs, values, lower, upper;
  for (const auto& [input, value, interval] : design.points) {
    inputs.push_back(input);
    values.push_back(value);
    lower.push_back(interval.lower);
    upper.push_back(interval.upper);
  }
  py::dict entries;
  entries["inputs"] = array_of(inputs);
  entries["values"] = array_of(values);
  entries["band"] = py::make_tuple(array_of(lower), array_of(upper));
  return entries;
}

py::dict assess_with(const DeckAssessment& deck, const std::vector<std::shared_ptr<Solution>>& solved,
                     const MeasuredComposite& measured, const std::string& stage, int threads) {
  std::optional<Calibration> calibration;
  auto entries = dict_of(calculate([&] {
    const auto curves = curves_of(deck, solved, stage, threads);
    if (!measured.observations.empty()) calibration = calibrate_inputs(deck, curves, measured);
    return assess(deck.inputs(), deck.design(), curves);
  }));
  entries["calibration"] = py::none();
  if (calibration) {
    entries["calibration"] =
        calibration_entries({deck.stage_named(stage)}, measured.observations, *calibration, measured.notes);
  }
  return entries;
}

}  // namespace

void bind_assessments(py::module_& module) {
  py::class_<MeasuredComposite>(module, "MeasuredComposite");
  py::class_<SoughtInput>(module, "SoughtInput");
  py::class_<FoundDesign>(module, "FoundDesign")
      .def_readonly("value", &FoundDesign::value)
      .def_property_readonly("interval",
                             [](const FoundDesign& design) { return py::make_tuple(design.lower, design.upper); })
      .def_property_readonly("points", &points_of)
      .def_readonly("warnings", &FoundDesign::warnings);
  py::class_<DeckAssessment>(module, "DeckAssessment")
      .def(py::init(&assessment_of), py::arg("deck"), py::arg("text"), py::arg("directory"), py::arg("overrides"),
           py::arg("samples"), py::arg("boxes"), py::arg("seed"))
      .def_property_readonly("studies",
                             [](const DeckAssessment& deck) {
                               std::vector<std::shared_ptr<Study>> studies;
                               for (const auto& task : deck.sweep().tasks) {
                                 studies.push_back(std::make_shared<Study>(task.study));
                               }
                               return studies;
                             })
      .def("stage_named", &DeckAssessment::stage_named, py::arg("name"))
      .def("measured", &measured_by, py::arg("files"), py::arg("modulus"), py::arg("noise"), py::arg("model_error"))
      .def("assess", &assess_with, py::arg("solved"), py::arg("measured"), py::arg("stage"), py::arg("threads"))
      .def("sought", &read_sought_input, py::arg("key"), py::arg("condition"), py::arg("model_error"))
      .def("find", &find_with, py::arg("solved"), py::arg("sought"), py::arg("stage"), py::arg("threads"))
      .def(
          "study_with",
          [](const DeckAssessment& deck, const SoughtInput& sought, const FoundDesign& design) {
            return std::make_shared<Study>(
                deck.study_with(sought.index, rounded_value(deck.inputs()[sought.index], design.value)));
          },
          py::arg("sought"), py::arg("found"))
      .def(
          "text_of",
          [](const DeckAssessment& deck, const SoughtInput& sought, const FoundDesign& design) {
            return plain_text(rounded_value(deck.inputs()[sought.index], design.value));
          },
          py::arg("sought"), py::arg("found"))
      .def(
          "doubt_on",
          [](const DeckAssessment& /*deck*/, const SoughtInput& sought, const FoundDesign& design, double reached) {
            return doubt_on(design, sought.condition, reached);
          },
          py::arg("sought"), py::arg("found"), py::arg("reached"))
      .def(
          "value_of",
          [](const DeckAssessment& deck, const std::shared_ptr<Solution>& solved, const std::string& stage,
             const SoughtInput& sought) {
            return value_of_study(findings_of(*solved), deck.stage_named(stage), sought.condition);
          },
          py::arg("solved"), py::arg("stage"), py::arg("sought"));
}

}  // namespace breccia::python
