#include "engineering.hpp"

#include <algorithm>
#include <complex>
#include <cstddef>
#include <numbers>
#include <optional>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/complex.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"

#include "arguments.hpp"
#include "io/display.hpp"
#include "materials.hpp"
#include "views.hpp"
#include "words.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

/// A member of each sample as a read-only array, a view of the curves.
template <class Number, class Sample>
auto column(std::vector<Sample> EngineeringCurves::*samples, Number Sample::*member) {
  return [samples, member](const py::object& self) {
    const auto& list = self.cast<const EngineeringCurves&>().*samples;
    const Number* const first = list.empty() ? nullptr : &(list.front().*member);
    return read_only(py::array_t<Number>({static_cast<py::ssize_t>(list.size())},
                                         {static_cast<py::ssize_t>(sizeof(Sample))}, first, self));
  };
}

/// An error of each sample as an array; NaN where it is not known.
template <class Sample>
auto errors_of(std::vector<Sample> EngineeringCurves::*samples, std::optional<double> EngineeringErrors::*member) {
  return [samples, member](const EngineeringCurves& self) {
    std::vector<double> errors;
    for (const auto& sample : self.*samples) errors.push_back(number_or_nan(sample.errors.*member));
    return array_of(errors);
  };
}

/// The tests that are missing under a boundary condition for Young's modulus.
std::string lacking(const StageFindings& stage, const std::optional<std::string>& boundary) {
  bool has_shear = false, has_bulk = false;
  for (const auto& test : stage.tests) {
    if (boundary && *boundary != name_of(test.id.boundary)) continue;
    (test.id.load.is_bulk() ? has_bulk : has_shear) = true;
  }
  const auto where = boundary ? fmt::format(" under the boundary condition {}", *boundary) : std::string();
  if (has_shear && has_bulk) {
    return fmt::format("the tests in shear and in bulk{} are not by one method on one grid", where);
  }
  const auto* const what = has_shear ? "bulk" : has_bulk ? "shear" : "shear and in bulk";
  return fmt::format(R"(it was not tested in {}{}; a study takes loads=["shear", "bulk"])", what, where);
}

/// What the curves follow from: the test, where they are sampled, and the series.
py::tuple state_of(const EngineeringCurves& curves) {
  std::vector<double> times, frequencies;
  std::vector<std::vector<std::optional<double>>> errors;
  for (const auto& sample : curves.in_time) {
    times.push_back(sample.time);
    errors.push_back({sample.errors.bulk, sample.errors.young, sample.errors.poisson});
  }
  for (const auto& sample : curves.in_frequency) frequencies.push_back(sample.angular_frequency);
  const auto& test = curves.test;
  return py::make_tuple(name_of(test.load), name_of(test.boundary), name_of(test.method), name_of(test.grid), times,
                        frequencies, python::state_of(curves.shear), python::state_of(curves.bulk), errors);
}

EngineeringCurves curves_from(const py::tuple& state) {
  const auto grid = grid_named(state[3].cast<std::string>());
  if (!grid) throw InputError("pickle: not a result of Breccia");
  EngineeringCurves curves = {{value_of<TestLoad>("load", state[0].cast<std::string>()),
                               value_of<Boundary>("boundary", state[1].cast<std::string>()),
                               value_of<Method>("method", state[2].cast<std::string>()), *grid},
                              {},
                              {},
                              series_from(state[6].cast<py::tuple>()),
                              series_from(state[7].cast<py::tuple>())};
  const auto times = state[4].cast<std::vector<double>>();
  const auto errors = state[8].cast<std::vector<std::vector<std::optional<double>>>>();
  for (std::size_t i = 0; i < times.size(); ++i) {
    curves.in_time.push_back(curves.at_time(times[i]));
    curves.in_time.back().errors = {.bulk = errors.at(i).at(0), .young = errors[i].at(1), .poisson = errors[i].at(2)};
  }
  for (const double frequency : state[5].cast<std::vector<double>>()) curves.add_frequency(frequency);
  return curves;
}

}  // namespace

EngineeringCurves engineering_of(const StageFindings& stage, const std::optional<std::string>& boundary) {
  if (boundary) static_cast<void>(value_of<Boundary>("boundary", *boundary));
  auto all = engineering_curves(stage, FrequencyRows{});
  if (boundary) std::erase_if(all, [&](const auto& one) { return name_of(one.test.boundary) != *boundary; });
  if (all.empty()) throw InputError(fmt::format("stage {}: {}", stage.name, lacking(stage, boundary)));
  if (all.size() > 1) {
    std::vector<std::string> choices;
    choices.reserve(all.size());
    for (const auto& one : all) choices.push_back(fmt::format("boundary=\"{}\"", name_of(one.test.boundary)));
    throw InputError(fmt::format("stage {}: expected {}", stage.name, fmt::join(choices, " or ")));
  }
  auto curves = std::move(all.front());
  // A study whose deck gives frequencies is answered at these.
  const auto test = std::ranges::find(stage.tests, curves.test, &TestResult::id);
  if (!test->in_frequency.empty()) curves.in_frequency.clear();
  for (const auto& sample : test->in_frequency) curves.add_frequency(sample.angular_frequency);
  return curves;
}

void bind_engineering(py::module_& module) {
  using Curves = EngineeringCurves;
  using Timed = EngineeringSample;
  using Complex = ComplexEngineeringSample;
  const auto in_time = &Curves::in_time;
  const auto in_frequency = &Curves::in_frequency;
  py::class_<Complex>(module, "ComplexEngineeringModuli", "The complex moduli of a stage at one frequency.")
      .def_readonly("angular_frequency", &Complex::angular_frequency, "[rad/s]")
      .def_readonly("shear", &Complex::shear, "G' + i G'' [Pa].")
      .def_readonly("bulk", &Complex::bulk, "K' + i K'' [Pa].")
      .def_readonly("young", &Complex::young, "E' + i E'' [Pa].")
      .def_readonly("poisson", &Complex::poisson, "nu' + i nu'' [-].")
      .def("__repr__", [](const Complex& self) {
        return fmt::format("<breccia.ComplexEngineeringModuli at {}: E' {}, E'' {}, G' {}, G'' {}>",
                           display(self.angular_frequency / (2.0 * std::numbers::pi), "Hz"),
                           display(self.young.real(), "Pa"), display(self.young.imag(), "Pa"),
                           display(self.shear.real(), "Pa"), display(self.shear.imag(), "Pa"));
      });
  py::class_<Curves>(module, "EngineeringModuli",
                     "Shear, bulk and Young's modulus and Poisson's ratio of a stage, over time and over angular "
                     "frequency: the numbers of engineering.csv and engineering_dynamic.csv. Arrays are views.")
      .def_property_readonly(
          "load", [](const Curves& self) { return name_of(self.test.load); }, "That of the shear modulus.")
      .def_property_readonly("boundary", [](const Curves& self) { return name_of(self.test.boundary); })
      .def_property_readonly("method", [](const Curves& self) { return name_of(self.test.method); })
      .def_property_readonly("time", column(in_time, &Timed::time), "Times of the curves [s].")
      .def_property_readonly("shear", column(in_time, &Timed::shear), "Shear modulus G(t) [Pa].")
      .def_property_readonly("bulk", column(in_time, &Timed::bulk), "Bulk modulus K(t) [Pa].")
      .def_property_readonly("young", column(in_time, &Timed::young), "Young's modulus E(t) [Pa].")
      .def_property_readonly("poisson", column(in_time, &Timed::poisson), "Poisson's ratio nu(t) [-].")
      .def_property_readonly("tensile_compliance", column(in_time, &Timed::tensile_compliance),
                             "Creep compliance in tension D(t) [1/Pa].")
      .def_property_readonly("bulk_error", errors_of(in_time, &EngineeringErrors::bulk),
                             "Error of K(t), a share of it; NaN where those of the tests are not known.")
      .def_property_readonly("young_error", errors_of(in_time, &EngineeringErrors::young),
                             "Error of E(t) and of D(t), a share of them; NaN as above.")
      .def_property_readonly("poisson_error", errors_of(in_time, &EngineeringErrors::poisson),
                             "Error of nu(t) itself; NaN as above.")
      .def_property_readonly(
          "angular_frequency", column(in_frequency, &Complex::angular_frequency),
          "Angular frequencies of the complex moduli [rad/s], rising: those of the deck, or one over the "
          "times.")
      .def_property_readonly(
          "frequency",
          [](const Curves& self) {
            std::vector<double> hertz;
            for (const auto& sample : self.in_frequency) {
              hertz.push_back(sample.angular_frequency / (2.0 * std::numbers::pi));
            }
            return array_of(hertz);
          },
          "The same in Hz.")
      .def(
          "at",
          [](const Curves& self, const py::object& frequency) {
            const double omega = angular_frequency_of("angular_frequency", frequency);
            require({"angular_frequency", "rad/s", Range::positive()}, omega);
            return self.at(omega);
          },
          py::arg("angular_frequency"),
          "The complex moduli at one frequency, ComplexEngineeringModuli: text such as \"1 Hz\" or \"10 rad/s\", or an "
          "angular frequency [rad/s].")
      .def_property_readonly("complex_shear", column(in_frequency, &Complex::shear), "G' + i G'' [Pa].")
      .def_property_readonly("complex_bulk", column(in_frequency, &Complex::bulk), "K' + i K'' [Pa].")
      .def_property_readonly("complex_young", column(in_frequency, &Complex::young), "E' + i E'' [Pa].")
      .def_property_readonly("complex_young_error", errors_of(in_frequency, &EngineeringErrors::young),
                             "Error of E(t) at the time 1/omega, a share of it; NaN as above.")
      .def_property_readonly("complex_poisson", column(in_frequency, &Complex::poisson),
                             "nu' + i nu'' [-]; the imaginary part is negative where the contraction lags behind.")
      .def("__repr__",
           [](const Curves& self) {
             return fmt::format("<breccia.EngineeringModuli: {}, {}, {}; {} times>", name_of(self.test.load),
                                name_of(self.test.boundary), name_of(self.test.method), self.in_time.size());
           })
      .def(py::pickle([](const Curves& self) { return state_of(self); }, &curves_from));
}

}  // namespace breccia::python
