#include "complex_moduli.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <pybind11/complex.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "breccia/error.hpp"
#include "breccia/results/frequency_rows.hpp"

#include "arguments.hpp"
#include "homogenisation/complex_moduli.hpp"
#include "io/display.hpp"
#include "materials.hpp"
#include "views.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

constexpr double per_cycle = 2.0 * std::numbers::pi;

/// A property that is computed from each sample, as an array.
template <class Value>
auto each(const Value& value) {
  return [value](const ComplexModuli& self) {
    std::vector<double> values;
    values.reserve(self.samples.size());
    for (const auto& sample : self.samples) values.push_back(value(sample));
    return array_of(values);
  };
}

auto view(double ComplexSample::*member) {
  return [member](const py::object& self) { return view_of(self.cast<const ComplexModuli&>().samples, member, self); };
}

std::string in_words(const ComplexModuli& self) {
  if (self.samples.empty()) return "<breccia.ComplexModuli: no frequencies>";
  const auto hertz = [](const ComplexSample& sample) { return display(sample.angular_frequency / per_cycle, "Hz"); };
  return fmt::format("<breccia.ComplexModuli: {} frequencies from {} to {}>", self.samples.size(),
                     hertz(self.samples.front()), hertz(self.samples.back()));
}

py::tuple state_of_moduli(const ComplexModuli& self) {
  py::list rows;
  for (const auto& [omega, storage, loss, error] : self.samples)
    rows.append(py::make_tuple(omega, storage, loss, error));
  return py::make_tuple(state_of(self.series), rows, self.is_of_deck);
}

ComplexModuli moduli_from(const py::tuple& state) {
  ComplexModuli moduli{series_from(state[0].cast<py::tuple>()), {}, state[2].cast<bool>()};
  for (const auto& one : state[1]) {
    const auto row = one.cast<py::tuple>();
    moduli.samples.push_back(
        {row[0].cast<double>(), row[1].cast<double>(), row[2].cast<double>(), row[3].cast<std::optional<double>>()});
  }
  return moduli;
}

}  // namespace

ComplexModuli complex_moduli_of(const TestResult& test) {
  if (!test.in_frequency.empty()) return {test.series, test.in_frequency, true};
  return {test.series,
          test.modulus.empty() ? std::vector<ComplexSample>() : complex_moduli(test, FrequencyRows{}.of(test.modulus))};
}

void bind_complex_moduli(py::module_& module) {
  py::class_<ComplexModuli>(module, "ComplexModuli",
                            "The complex modulus M' + i M'' of a test over frequency, with its error: at the "
                            "frequencies of the deck or, where the deck gives times t, at the angular frequencies 1/t.")
      .def_property_readonly("frequency",
                             each([](const ComplexSample& one) { return one.angular_frequency / per_cycle; }),
                             "Frequencies [Hz], rising.")
      .def_property_readonly("angular_frequency", view(&ComplexSample::angular_frequency),
                             "The same as angular frequencies [rad/s].")
      .def_property_readonly("storage", view(&ComplexSample::storage), "Storage modulus M' [Pa].")
      .def_property_readonly("loss", view(&ComplexSample::loss), "Loss modulus M'' [Pa].")
      .def_property_readonly(
          "absolute", each([](const ComplexSample& one) { return std::hypot(one.storage, one.loss); }), "|M*| [Pa].")
      .def_property_readonly("phase", each([](const ComplexSample& one) {
                               return 180.0 / std::numbers::pi * std::atan2(one.loss, one.storage);
                             }),
                             "Phase of M* [degrees].")
      .def_property_readonly("loss_tangent", each([](const ComplexSample& one) { return one.loss / one.storage; }),
                             "tan delta = M'' / M' [-].")
      .def_property_readonly("error", each([](const ComplexSample& one) { return number_or_nan(one.error); }),
                             "Error of the modulus over it [-], that of the relaxation modulus at the time 1/omega "
                             "(TestResult.error); NaN where it is not known.")
      .def_readonly("is_of_deck", &ComplexModuli::is_of_deck, "Whether the deck gives these frequencies.")
      .def(
          "at",
          [](const ComplexModuli& self, const py::object& frequency) {
            if (!(self.series.unrelaxed() > 0.0)) {
              throw InputError("at: this test has no series here; stage.test() is one that has");
            }
            return py::vectorize([&self](double omega) { return self.series.complex_modulus(omega); })(
                numbers_of({"angular_frequency", "rad/s", Range::positive()}, frequency, &angular_frequency_of));
          },
          py::arg("angular_frequency"),
          "M' + i M'' [Pa] at any frequency: text such as \"1 Hz\" or \"10 rad/s\", or angular frequencies [rad/s], a "
          "number or an array.")
      .def("__len__", [](const ComplexModuli& self) { return self.samples.size(); })
      .def("__repr__", &in_words)
      .def(py::pickle(&state_of_moduli, &moduli_from));
}

}  // namespace breccia::python
