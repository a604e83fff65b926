#include "master_curves.hpp"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/master_curve.hpp"
#include "breccia/viscoelasticity/temperature_shift_fit.hpp"

#include "arguments.hpp"
#include "fits.hpp"
#include "views.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

/// A sweep of a caller: (temperature [K], angular frequencies, storage moduli, loss moduli).
FrequencySweep sweep_of(const py::tuple& sweep) {
  if (sweep.size() != 4) {
    throw InputError("sweeps: expected (temperature [K], angular frequencies [rad/s], storage, loss [Pa]) for each");
  }
  return {.temperature = sweep[0].cast<double>(),
          .frequencies = sweep[1].cast<std::vector<double>>(),
          .storage = sweep[2].cast<std::vector<double>>(),
          .loss = sweep[3].cast<std::vector<double>>()};
}

WilliamsLandelFerryFit law_from(const py::tuple& state) {
  const auto number = [&state](std::size_t i) { return state[i].cast<double>(); };
  return {{number(0), number(1), number(2)}, number(3), number(4), number(5), number(6)};
}

py::tuple state_of_curve(const MasterCurve& curve) {
  py::list factors;
  for (const auto& [temperature, log10_factor, error] : curve.shift_factors) {
    factors.append(py::make_tuple(temperature, log10_factor, error));
  }
  return py::make_tuple(curve.reference_temperature, factors,
                        state_of(dynamic_fit(curve.fit, curve.frequencies, curve.storage, curve.loss)));
}

MasterCurve curve_from(const py::tuple& state) {
  auto fit = relaxation_fit_from(state[2].cast<py::tuple>());
  const auto middle = fit.measured.begin() + static_cast<std::ptrdiff_t>(fit.at.size());
  MasterCurve curve;
  curve.reference_temperature = state[0].cast<double>();
  for (const auto& one : state[1]) {
    const auto factor = one.cast<py::tuple>();
    curve.shift_factors.push_back({factor[0].cast<double>(), factor[1].cast<double>(), factor[2].cast<double>()});
  }
  curve.storage.assign(fit.measured.begin(), middle);
  curve.loss.assign(middle, fit.measured.end());
  curve.frequencies = std::move(fit.at);
  curve.fit = std::move(fit.fit);
  return curve;
}

void bind_law(py::module_& module) {
  py::class_<WilliamsLandelFerryFit>(module, "WilliamsLandelFerry",
                                     "log10 a_T = -c1 (T - T_ref) / (c2 + T - T_ref), fitted to shift factors.")
      .def_property_readonly(
          "c1", [](const WilliamsLandelFerryFit& self) { return self.law.c1; }, "[-]")
      .def_property_readonly(
          "c2", [](const WilliamsLandelFerryFit& self) { return self.law.c2; }, "[K]")
      .def_property_readonly(
          "reference_temperature", [](const WilliamsLandelFerryFit& self) { return self.law.reference_temperature; },
          "[K]")
      .def_readonly("c1_error", &WilliamsLandelFerryFit::c1_error, "Standard error of c1 [-].")
      .def_readonly("c2_error", &WilliamsLandelFerryFit::c2_error, "Standard error of c2 [K].")
      .def(
          "shift_factor",
          [](const WilliamsLandelFerryFit& self, const py::object& temperature) {
            const double kelvin = quantity_of("temperature", temperature, Dimension::temperature);
            require({"temperature", "K", Range::not_negative()}, kelvin);
            return self.law.shift_factor(kelvin);
          },
          py::arg("temperature"), "a_T [-] at a temperature [K], or text such as \"30 degC\".")
      .def("__repr__",
           [](const WilliamsLandelFerryFit& self) {
             return fmt::format("<breccia.WilliamsLandelFerry: c1 = {:.4g}, c2 = {:.4g} K at {:.6g} K>", self.law.c1,
                                self.law.c2, self.law.reference_temperature);
           })
      .def(py::pickle(
          [](const WilliamsLandelFerryFit& self) {
            return py::make_tuple(self.law.c1, self.law.c2, self.law.reference_temperature, self.c1_error,
                                  self.c2_error, self.worst_deviation, self.worst_at);
          },
          &law_from));
}

void bind_curve(py::module_& module) {
  const auto list = [](const std::vector<double> MasterCurve::*member) {
    return [member](const py::object& self) {
      const auto& numbers = self.cast<const MasterCurve&>().*member;
      return view_of(numbers.data(), {static_cast<py::ssize_t>(numbers.size())}, self);
    };
  };
  py::class_<MasterCurve>(module, "MasterCurve", "Frequency sweeps shifted to one temperature.")
      .def_readonly("reference_temperature", &MasterCurve::reference_temperature, "[K]")
      .def_property_readonly("angular_frequency", list(&MasterCurve::frequencies),
                             "Reduced angular frequencies [rad/s], rising.")
      .def_property_readonly("storage", list(&MasterCurve::storage), "Storage moduli there [Pa].")
      .def_property_readonly("loss", list(&MasterCurve::loss), "Loss moduli there [Pa].")
      .def_property_readonly(
          "series", [](const MasterCurve& self) { return self.fit.series; },
          "Relaxation modulus at the reference temperature, a PronySeries.")
      .def_property_readonly(
          "fit",
          [](const MasterCurve& self) { return dynamic_fit(self.fit, self.frequencies, self.storage, self.loss); },
          "The same with its deviations from the data.")
      .def_property_readonly(
          "shift_factors",
          [](const MasterCurve& self) {
            const auto count = static_cast<py::ssize_t>(self.shift_factors.size());
            static_assert(sizeof(ShiftFactor) == 3 * sizeof(double));
            return py::array_t<double>({count, py::ssize_t{3}}, &self.shift_factors.front().temperature);
          },
          "n x 3 array: temperature [K], log10 a_T [-] and its standard error.")
      .def(
          "williams_landel_ferry",
          [](const MasterCurve& self) {
            return fit_williams_landel_ferry(self.shift_factors, self.reference_temperature);
          },
          "The law of Williams, Landel and Ferry through the shift factors; None where they follow none.")
      .def("__repr__",
           [](const MasterCurve& self) {
             return fmt::format("<breccia.MasterCurve at {:.6g} K: {} frequencies from {:.3g} to {:.3g} rad/s>",
                                self.reference_temperature, self.frequencies.size(), self.frequencies.front(),
                                self.frequencies.back());
           })
      .def(py::pickle(&state_of_curve, &curve_from));
  module.def(
      "master_curve",
      [](const std::vector<py::tuple>& sweeps, double reference_temperature, double times_per_decade) {
        std::vector<FrequencySweep> read;
        read.reserve(sweeps.size());
        for (const auto& sweep : sweeps) read.push_back(sweep_of(sweep));
        const auto options = fit_options(0.0, times_per_decade);
        return [&] {
          const py::gil_scoped_release release;
          return master_curve(std::move(read), reference_temperature, options);
        }();
      },
      py::arg("sweeps"), py::arg("reference_temperature"), py::kw_only(), py::arg("times_per_decade") = 10.0,
      "Shifts frequency sweeps, (temperature [K], angular frequencies [rad/s], storage, loss [Pa]) each, to one of "
      "their "
      "temperatures [K].");
}

}  // namespace

void bind_master_curves(py::module_& module) {
  bind_law(module);
  bind_curve(module);
}

}  // namespace breccia::python
