#include "fits.hpp"

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "breccia/error.hpp"
#include "breccia/io/display.hpp"
#include "breccia/viscoelasticity/fit.hpp"
#include "breccia/viscoelasticity/master_curve.hpp"
#include "breccia/viscoelasticity/temperature_shift_fit.hpp"

#include "arguments.hpp"
#include "materials.hpp"
#include "views.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

/// Numbers of a caller; a copy only where they are not contiguous doubles already.
using ContiguousNumbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::span<const double> numbers_of(const char* name, const ContiguousNumbers& array) {
  if (array.ndim() != 1)
    throw InputError(fmt::format("{}: expected a list, got an array of {} axes", name, array.ndim()));
  return {array.data(), static_cast<std::size_t>(array.size())};
}

/// Several lists of data of one length.
void require_equal_lengths(const char* name, const ContiguousNumbers& one, const char* other_name,
                           const ContiguousNumbers& other) {
  if (one.size() == other.size()) return;
  throw InputError(
      fmt::format("expected as many values of {} as of {}, got {} and {}", name, other_name, one.size(), other.size()));
}

template <class Work>
auto without_lock(const Work& work) {
  const py::gil_scoped_release release;
  return work();
}

std::string quality_in_words(const FitQuality& quality, const char* unit) {
  return fmt::format("deviation from the data: median {:.2g} %, worst {:.2g} % at {:.4g} {}",
                     100.0 * quality.median_error, 100.0 * quality.worst_error, quality.worst_at, unit);
}

/// What the three kinds of fits have in common.
template <class Fit>
void bind_quality(py::class_<Fit>& fit) {
  fit.def_property_readonly(
         "median_error", [](const Fit& self) { return self.quality.median_error; },
         "Median of the absolute deviations from the data, relative [-].")
      .def_property_readonly(
          "worst_error", [](const Fit& self) { return self.quality.worst_error; },
          "Largest absolute deviation from the data, relative [-].")
      .def_property_readonly(
          "worst_at", [](const Fit& self) { return self.quality.worst_at; },
          "Time [s] or angular frequency [rad/s] of the largest deviation.")
      .def_property_readonly(
          "fitted",
          [](const py::object& self) {
            const auto& fitted = self.cast<const Fit&>().quality.fitted;
            return view_of(fitted.data(), {static_cast<py::ssize_t>(fitted.size())}, self);
          },
          "Values of the fit at the data, in their unit; of dynamic moduli first all storage, then all loss moduli.")
      .def_property_readonly(
          "standard_errors",
          [](const py::object& self) {
            const auto& errors = self.cast<const Fit&>().quality.standard_errors;
            return view_of(errors.data(), {static_cast<py::ssize_t>(errors.size())}, self);
          },
          "Standard error of the fit at each value, from the scatter of the data, relative [-].");
}

py::tuple state_of_quality(const FitQuality& quality) {
  return py::make_tuple(quality.median_error, quality.worst_error, quality.worst_at, array_of(quality.fitted),
                        array_of(quality.standard_errors));
}

FitQuality quality_from(const py::tuple& state) {
  return {state[0].cast<double>(), state[1].cast<double>(), state[2].cast<double>(),
          state[3].cast<std::vector<double>>(), state[4].cast<std::vector<double>>()};
}

FitOptions options_of(double ramp, double times_per_decade) {
  if (!(times_per_decade > 0.0)) throw InputError("times_per_decade: expected a positive number");
  if (!(ramp >= 0.0)) throw InputError("ramp: expected a duration [s] that is not negative");
  return {.times_per_decade = times_per_decade, .ramp = ramp};
}

void bind_results(py::module_& module) {
  py::class_<RelaxationFit> relaxation(module, "RelaxationFit", "A Prony series fitted to data.");
  relaxation.def_readonly("series", &RelaxationFit::series, "The fit, a PronySeries.");
  bind_quality(relaxation);
  relaxation.def("__repr__", [](const RelaxationFit& fit) {
    return fmt::format("<breccia.RelaxationFit: {}; {}>", display_count(fit.series.terms().size(), "term"),
                       quality_in_words(fit.quality, "s or rad/s"));
  });
  relaxation.def(py::pickle(
      [](const RelaxationFit& fit) {
        return py::make_tuple(python::state_of(fit.series), state_of_quality(fit.quality));
      },
      [](const py::tuple& state) {
        return RelaxationFit{series_from(state[0].cast<py::tuple>()), quality_from(state[1].cast<py::tuple>())};
      }));
  py::class_<CreepFit> creep(module, "CreepFit", "A creep compliance fitted to data.");
  creep.def_readonly("compliance", &CreepFit::compliance, "The fit, a CreepCompliance.");
  bind_quality(creep);
  creep.def("__repr__", [](const CreepFit& fit) {
    return fmt::format("<breccia.CreepFit: {}; {}>", display_count(fit.compliance.terms().size(), "term"),
                       quality_in_words(fit.quality, "s"));
  });
}

void bind_functions(py::module_& module) {
  module.def(
      "fit",
      [](const ContiguousNumbers& time, const ContiguousNumbers& modulus, double ramp, double times_per_decade) {
        require_equal_lengths("time", time, "modulus", modulus);
        const auto times = numbers_of("time", time), moduli = numbers_of("modulus", modulus);
        const auto options = options_of(ramp, times_per_decade);
        return without_lock([&] { return fit_relaxation(times, moduli, options); });
      },
      py::arg("time"), py::arg("modulus"), py::kw_only(), py::arg("ramp") = 0.0, py::arg("times_per_decade") = 10.0,
      "Fits a Prony series to relaxation moduli [Pa] at rising times [s].\n\n"
      "ramp: duration [s] of the ramp by which the strain was applied; 0: a step.");
  module.def(
      "fit_creep",
      [](const ContiguousNumbers& time, const ContiguousNumbers& compliance, double ramp, double times_per_decade) {
        require_equal_lengths("time", time, "compliance", compliance);
        const auto times = numbers_of("time", time), compliances = numbers_of("compliance", compliance);
        const auto options = options_of(ramp, times_per_decade);
        return without_lock([&] { return fit_creep(times, compliances, options); });
      },
      py::arg("time"), py::arg("compliance"), py::kw_only(), py::arg("ramp") = 0.0, py::arg("times_per_decade") = 10.0,
      "Fits a creep compliance [1/Pa] at rising times [s]; see fit().");
  module.def(
      "fit_dynamic",
      [](const ContiguousNumbers& frequency, const ContiguousNumbers& storage, const ContiguousNumbers& loss,
         double times_per_decade) {
        require_equal_lengths("angular_frequency", frequency, "storage", storage);
        require_equal_lengths("angular_frequency", frequency, "loss", loss);
        const auto frequencies = numbers_of("angular_frequency", frequency), stored = numbers_of("storage", storage),
                   lost = numbers_of("loss", loss);
        const auto options = options_of(0.0, times_per_decade);
        return without_lock([&] { return fit_dynamic(frequencies, stored, lost, options); });
      },
      py::arg("angular_frequency"), py::arg("storage"), py::arg("loss"), py::kw_only(),
      py::arg("times_per_decade") = 10.0,
      "Fits a Prony series to storage and loss moduli [Pa] at rising angular frequencies [rad/s].");
}

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

void bind_master_curve(py::module_& module) {
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
          [](const WilliamsLandelFerryFit& self, double temperature) {
            require({"temperature", "K", Range::not_negative()}, temperature);
            return self.law.shift_factor(temperature);
          },
          py::arg("temperature"), "a_T [-] at a temperature [K].")
      .def("__repr__", [](const WilliamsLandelFerryFit& self) {
        return fmt::format("<breccia.WilliamsLandelFerry: c1 = {:.4g}, c2 = {:.4g} K at {:.6g} K>", self.law.c1,
                           self.law.c2, self.law.reference_temperature);
      });
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
      .def_readonly("fit", &MasterCurve::fit, "The same with its deviations from the data.")
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
      .def("__repr__", [](const MasterCurve& self) {
        return fmt::format("<breccia.MasterCurve at {:.6g} K: {} frequencies from {:.3g} to {:.3g} rad/s>",
                           self.reference_temperature, self.frequencies.size(), self.frequencies.front(),
                           self.frequencies.back());
      });
  module.def(
      "master_curve",
      [](const std::vector<py::tuple>& sweeps, double reference_temperature, double times_per_decade) {
        std::vector<FrequencySweep> read;
        for (const auto& sweep : sweeps) read.push_back(sweep_of(sweep));
        const auto options = options_of(0.0, times_per_decade);
        return without_lock([&] { return master_curve(std::move(read), reference_temperature, options); });
      },
      py::arg("sweeps"), py::arg("reference_temperature"), py::kw_only(), py::arg("times_per_decade") = 10.0,
      "Shifts frequency sweeps, (temperature [K], angular frequencies [rad/s], storage, loss [Pa]) each, to one of "
      "their "
      "temperatures [K].");
}

}  // namespace

void bind_fits(py::module_& module) {
  bind_results(module);
  bind_functions(module);
  bind_master_curve(module);
}

}  // namespace breccia::python
