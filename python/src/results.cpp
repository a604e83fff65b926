#include "results.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/complex.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "breccia/error.hpp"

#include "complex_moduli.hpp"
#include "engineering.hpp"
#include "io/display.hpp"
#include "io/nearest_name.hpp"
#include "materials.hpp"
#include "solution.hpp"
#include "solution_state.hpp"
#include "stage_dictionaries.hpp"
#include "test_fields.hpp"
#include "views.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

/// The number of cells, or "extrapolated" or "films", of an argument `grid`.
std::optional<std::string> grid_word(const py::object& grid) {
  if (grid.is_none()) return std::nullopt;
  return py::str(grid).cast<std::string>();
}

py::object grid_of(const TestId& test) {
  if (const auto cells = test.grid.cells()) return py::int_(*cells);
  return py::str(name_of(test.grid));
}

/// The series of a test; results that were read from a directory have those of the preferred tests alone.
const PronySeries& series_of_test(const TestResult& test) {
  if (test.series.unrelaxed() > 0.0 || test.modulus.empty()) return test.series;
  throw InputError(
      "this test has no series: a directory of results has those of the preferred method and grid alone; fit() makes "
      "one of its curve");
}

py::tuple curve_of(const py::object& owner, const TestResult& test) {
  return py::make_tuple(view_of(test.modulus, &Sample::time, owner), view_of(test.modulus, &Sample::modulus, owner));
}

/// A part of the error of a test at each of its times [-], NaN where it is not known.
template <class Part>
py::array_t<double> shares_of(const TestResult& test, const Part& part) {
  std::vector<double> shares;
  for (const auto& error : test.errors) {
    shares.push_back(number_or_nan(part(error)));
  }
  return py::array_t<double>(static_cast<py::ssize_t>(shares.size()), shares.data());
}

py::dict errors_of_test(const TestResult& test) {
  py::dict errors;
  const auto add = [&](const char* cause, std::optional<double> ModulusError::*part) {
    errors[cause] = shares_of(test, [part](const ModulusError& error) { return error.*part; });
  };
  add("grid", &ModulusError::grid);
  add("sample", &ModulusError::sample);
  add("solver", &ModulusError::solver);
  add("matrix", &ModulusError::matrix);
  return errors;
}

void bind_test(py::module_& module) {
  py::class_<TestResult>(module, "TestResult", "The result of one virtual test under one load. Arrays are views.")
      .def_property_readonly("load", [](const TestResult& test) { return name_of(test.id.load); })
      .def_property_readonly("boundary", [](const TestResult& test) { return name_of(test.id.boundary); })
      .def_property_readonly("method", [](const TestResult& test) { return name_of(test.id.method); })
      .def_property_readonly(
          "grid", [](const TestResult& test) { return grid_of(test.id); },
          R"(Cells per side, "extrapolated" or "films".)")
      .def_property_readonly(
          "time",
          [](const py::object& self) { return view_of(self.cast<const TestResult&>().modulus, &Sample::time, self); },
          "Times of the curve [s].")
      .def_property_readonly(
          "modulus",
          [](const py::object& self) {
            return view_of(self.cast<const TestResult&>().modulus, &Sample::modulus, self);
          },
          "Relaxation modulus at these times [Pa]; of a creep test by interconversion.")
      .def_property_readonly(
          "compliance",
          [](const py::object& self) {
            return view_of(self.cast<const TestResult&>().compliance, &CreepSample::compliance, self);
          },
          "Creep compliance at these times [1/Pa], of a traction boundary; else empty.")
      .def_property_readonly("series", &series_of_test, "Relaxation modulus, a PronySeries.")
      .def_property_readonly(
          "error_estimate", [](const TestResult& test) { return test.error_estimate; },
          "Estimated relative error of the reduced basis or of the time steps [-]; NaN where unknown.")
      .def_property_readonly(
          "half_bands",
          [](const py::object& self) {
            const auto& bands = self.cast<const TestResult&>().half_bands;
            return view_of(bands.data(), {static_cast<py::ssize_t>(bands.size())}, self);
          },
          "Half width of the error band of an extrapolated curve at these times [Pa]; else empty.")
      .def_property_readonly(
          "error",
          [](const TestResult& test) { return shares_of(test, [](const auto& error) { return error.whole(); }); },
          "Error of the modulus at these times over it [-], of all causes; NaN where one is not known. Empty for a "
          "grid "
          "beside others.")
      .def_property_readonly("errors", &errors_of_test,
                             "Parts of the error by their causes, an array each as `error`: grid, sample (a box that "
                             "holds few particles), "
                             "solver, and matrix (of an earlier stage).")
      .def_property_readonly("in_frequency", &complex_moduli_of,
                             "The complex modulus over frequency, with its error: ComplexModuli.")
      .def_property_readonly(
          "seconds", [](const TestResult& test) { return test.seconds; },
          "Wall time, of all loads together [s]; None of an extrapolation.")
      .def_property_readonly(
          "fields", &fields_of_test,
          "Fields at the field times, a dictionary each: time [s], phase, and per unit of the load displacement [m], "
          "strain [-] (xx, yy, xy), stress [Pa] (xx, yy, zz, xy), in the order [y, x] of the material points, or "
          "[z, y, x] of the cells of a cube.\n\n"
          "Of grains with thin films: points [m] and their displacement [m]; part (0: triangle of a grain, 1: piece of "
          "a film, 2: junction, 3: gap, 4: channel, 5: film that slips, 6: film on springs), area [m^2] or volume "
          "[m^3], strain, stress, work [Pa], slip, opening and flow [m] of each cell; and "
          "corners, the points of all cells one after the other, those of cell i from first_corner[i] up to "
          "first_corner[i + 1].")
      .def("__repr__",
           [](const TestResult& test) {
             return fmt::format("<breccia.TestResult: {}, {}, {}, {}; {} times>", name_of(test.id.load),
                                name_of(test.id.boundary), words_of(test.id.grid), name_of(test.id.method),
                                test.modulus.size());
           })
      .def(py::pickle(&state_of_test, &python::test_from));
}

/// A function of a stage that finds one of its tests by words and passes it on, with the Python object that owns it.
template <class Answer>
auto of_test(const Answer& answer) {
  return [answer](const py::object& self, const std::optional<std::string>& load,
                  const std::optional<std::string>& boundary, const std::optional<std::string>& method,
                  const py::object& grid) {
    const auto& stage = self.cast<const SolvedStage&>().result;
    return answer(self, test_of(stage, {load, boundary, method, grid_word(grid)}));
  };
}

std::vector<Material> solids_of(const SolvedStage& stage) {
  std::vector<Material> solids;
  for (const auto& each : stage.result.materials) {
    solids.push_back(each.result.material);
    solids.back().name = fmt::format("{}, {}, {}", stage.result.name, name_of(each.boundary), name_of(each.method));
  }
  return solids;
}

EngineeringCurves engineering_of_stage(const SolvedStage& stage, const std::optional<std::string>& boundary) {
  return engineering_of(stage.result, boundary);
}

void bind_stage(py::module_& module) {
  const auto load = py::arg("load") = py::none();
  const auto boundary = py::arg("boundary") = py::none(), method = py::arg("method") = py::none(),
             grid = py::arg("grid") = py::none();
  constexpr auto which =
      "\n\nload: \"isotropic\" (the mean of all shears), \"shear\", \"bulk\", ...; by default isotropic where it was "
      "tested, "
      "else shear, else the first shear; boundary: \"displacement\" (KUBC), \"traction\" (SUBC) or "
      "\"periodic\", needed where several were tested; method: \"quasistatic\" before \"dynamic\"; grid: cells per "
      "side, "
      "by default the finest or the extrapolation.";
  static const std::string of_curve =
      fmt::format("Times [s] and relaxation modulus [Pa], views without a copy.{}", which);
  static const std::string of_compliance = fmt::format(
      "Times [s] and creep compliance [1/Pa] of a traction boundary, views without a copy; else empty.{}", which);
  static const std::string of_series = fmt::format("Relaxation modulus as a PronySeries.{}", which);
  static const std::string of_tests = fmt::format("The TestResult.{}", which);
  py::class_<SolvedStage>(module, "StageResult", "The results of one stage.")
      .def_property_readonly("name", [](const SolvedStage& stage) { return stage.result.name; })
      .def_property_readonly(
          "cells", [](const SolvedStage& stage) { return stage.result.cells; }, "Cells per side of the finest grid.")
      .def_property_readonly(
          "dimensions", [](const SolvedStage& stage) { return stage.result.dimensions; }, "2 or 3.")
      .def_property_readonly(
          "points", [](const SolvedStage& stage) { return stage.result.points; },
          "Number of material points of the finest grid.")
      .def_property_readonly(
          "point_fraction", [](const SolvedStage& stage) { return stage.result.point_fraction; },
          "Share of the material points that is filler [-].")
      .def_property_readonly(
          "microstructure", [](const SolvedStage& stage) { return stage.box ? &*stage.box : nullptr; },
          py::return_value_policy::reference_internal, "What is in the box; None of a response.")
      .def_property_readonly(
          "tests",
          [](const py::object& self) {
            py::list tests;
            for (const auto& test : self.cast<const SolvedStage&>().result.tests) {
              tests.append(py::cast(&test, py::return_value_policy::reference_internal, self));
            }
            return tests;
          },
          "All tests.")
      .def_property_readonly(
          "comparisons", &comparisons_of,
          "Comparisons with the measurements of the study, a dictionary each: measurement, kind of modulus (shear, "
          "young or bulk), boundary, method; time [s], modulus and measured [Pa]; angular_frequency [rad/s], "
          "complex_modulus "
          "and complex_measured [Pa].")
      .def_property_readonly("expansions", &expansions_of,
                             "The linear thermal expansion after a step of the temperature, a dictionary for each "
                             "boundary and method: time [s], expansion [1/K] and its error [1/K], NaN where it is not "
                             "known; empty where the study gives no expansion of the materials, or the bulk moduli do "
                             "not determine that of the stage.")
      .def_property_readonly("stiffness", &stiffness_of,
                             "The whole stiffness where tests.loads is \"stiffness\", a dictionary for each boundary: "
                             "time [s], stiffness [Pa] (times x 6 x 6 in Voigt's order xx, yy, zz, yz, zx, xy with "
                             "engineering shears; times x 3 x 3 in plane strain, xx, yy, xy), bulk and shear of the "
                             "nearest isotropic stiffness [Pa], anisotropy (universal index) and error [-], NaN where "
                             "it is not known.")
      .def_property_readonly("solids", &solids_of,
                             "The stage as a solid, for each boundary condition, where it serves as a matrix.")
      .def_property_readonly(
          "accuracy", [](const SolvedStage& stage) { return stage.result.accuracy.summary; },
          "What the run knows of the errors of the stage, in words; empty without particles.")
      .def_property_readonly(
          "grid_error", [](const SolvedStage& stage) { return stage.result.accuracy.grid_error; },
          "Error of the grid over the modulus, largest over the times [-], as several grids show it; None for one.")
      .def_property_readonly(
          "expected_grid_error", [](const SolvedStage& stage) { return stage.result.accuracy.rules.one_grid; },
          "Error of a single grid over the modulus that is to be expected by a rule [-]; None where no rule holds.")
      .def_property_readonly(
          "warnings", [](const SolvedStage& stage) { return stage.result.warnings; }, "Reasons to doubt the results.")
      .def("test", of_test([](const py::object& self, const TestResult& test) {
             return py::cast(&test, py::return_value_policy::reference_internal, self);
           }),
           load, boundary, method, grid, of_tests.c_str())
      .def("curve", of_test(&curve_of), load, boundary, method, grid, of_curve.c_str())
      .def("prony", of_test([](const py::object&, const TestResult& test) { return series_of_test(test); }), load,
           boundary, method, grid, of_series.c_str())
      .def("compliance", of_test([](const py::object& self, const TestResult& test) {
             return py::make_tuple(view_of(test.compliance, &CreepSample::time, self),
                                   view_of(test.compliance, &CreepSample::compliance, self));
           }),
           load, boundary, method, grid, of_compliance.c_str())
      .def(
          "fields",
          [](const py::object& self, const std::optional<std::string>& of_load,
             const std::optional<std::string>& of_boundary, const std::optional<std::string>& of_method,
             const py::object& of_grid) {
            const auto& stage = self.cast<const SolvedStage&>().result;
            const auto& test = test_with_fields(stage, {of_load, of_boundary, of_method, grid_word(of_grid)});
            return fields_of_test(py::cast(&test, py::return_value_policy::reference_internal, self));
          },
          load, boundary, method, grid,
          "Fields at the field times, as `fields` of a test, of the test that has them: by default of the first load "
          "and on the finest grid. Components are in the order xx, yy, zz, yz, zx, xy of a cube, of a square stress "
          "has xx, yy, zz, xy and strain xx, yy, xy. Means of loads, and all grids together, have none of their own.")
      .def("engineering", &engineering_of_stage, boundary,
           "Young's modulus and Poisson's ratio, EngineeringModuli, of a stage that was tested in shear and in bulk "
           "under "
           "this boundary condition, which is needed where there are several. Raises InputError with what is missing.")
      .def("__repr__",
           [](const SolvedStage& stage) {
             return fmt::format("<breccia.StageResult {}: {}>", stage.result.name,
                                display_count(stage.result.tests.size(), "test"));
           })
      .def(py::pickle(&state_of_stage, &python::stage_from));
}

std::vector<std::string> names_of(const Solution& solution) {
  std::vector<std::string> names;
  for (const auto& stage : solution.stages) names.push_back(stage.result.name);
  return names;
}

const SolvedStage& stage_of(const Solution& solution, const py::object& named) {
  if (!py::isinstance<py::str>(named)) {
    throw InputError(
        fmt::format("result[...]: expected the name of a stage, got {}; the stages in their order are result.stages",
                    py::repr(named).cast<std::string>()));
  }
  const auto name = named.cast<std::string>();
  const auto found =
      std::ranges::find(solution.stages, name, [](const SolvedStage& stage) { return stage.result.name; });
  if (found != solution.stages.end()) return *found;
  const auto names = names_of(solution);
  throw py::key_error(fmt::format("no stage \"{}\"{}", name, suggestion(name, names)));
}

void bind_solution(py::module_& module) {
  py::class_<Solution, std::shared_ptr<Solution>>(module, "Result",
                                                  "The results of a study: result[name] is that of a stage.")
      .def_property_readonly("title", [](const Solution& solution) { return solution.content.title; })
      .def_readonly("seconds", &Solution::seconds, "Wall time of the calculation [s]; None of a response.")
      .def_property_readonly(
          "stages",
          [](const py::object& self) {
            py::list stages;
            for (const auto& stage : self.cast<const Solution&>().stages) {
              stages.append(py::cast(&stage, py::return_value_policy::reference_internal, self));
            }
            return stages;
          },
          "The StageResult of all stages, from the smallest scale up.")
      .def_property_readonly(
          "materials", [](const Solution& solution) { return without_shifts(solution.content.materials); },
          "The materials of the study, a Solid each.")
      .def_property_readonly(
          "binder",
          [](const Solution& solution) -> std::optional<std::string> {
            for (const auto& one : solution.responses) {
              if (std::holds_alternative<Material>(one.matrix)) return breccia::name_of(one.matrix);
            }
            return std::nullopt;
          },
          "The name of the material that respond() replaces as the binder; None without reduced responses.")
      .def_property_readonly(
          "warnings",
          [](const Solution& solution) {
            std::vector<std::string> warnings;
            for (const auto& stage : solution.stages) {
              for (const auto& warning : stage.result.warnings) warnings.push_back(warning);
            }
            return warnings;
          },
          "Reasons to doubt the results, of all stages.")
      .def("__getitem__", &stage_of, py::arg("stage"), py::return_value_policy::reference_internal)
      .def("__iter__", [](const Solution& solution) { return py::iter(py::cast(names_of(solution))); })
      .def("__len__", [](const Solution& solution) { return solution.stages.size(); })
      .def("__contains__",
           [](const Solution& solution, const std::string& name) {
             const auto names = names_of(solution);
             return std::ranges::find(names, name) != names.end();
           })
      .def("__repr__",
           [](const Solution& solution) {
             const auto time = solution.seconds ? fmt::format(", in {}", display_duration(*solution.seconds)) : "";
             return fmt::format("<breccia.Result {}: stage {}{}>", solution.content.title,
                                fmt::join(names_of(solution), ", stage "), time);
           })
      .def(py::pickle(&state_of_solution, &solution_from));
}

}  // namespace

void bind_results(py::module_& module) {
  bind_box(module);
  bind_test(module);
  bind_stage(module);
  bind_solution(module);
}

}  // namespace breccia::python
