#include "fits.hpp"

#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/fit.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"
#include "breccia/viscoelasticity/law_fit.hpp"

#include "arguments.hpp"
#include "io/display.hpp"
#include "materials.hpp"
#include "views.hpp"
#include "words.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

/// Numbers of a caller; a copy only where they are not contiguous doubles already.
using ContiguousNumbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The numbers of an argument, a list in this unit. Throws InputError for anything else.
ContiguousNumbers checked_list(const char* name, const char* unit, const py::object& values) {
  const auto expected = fmt::format("a list of numbers in {}", unit);
  refuse_what_numpy_drops(name, expected, values);
  auto array = ContiguousNumbers::ensure(values);
  if (!array) {
    PyErr_Clear();
    throw InputError(fmt::format("{}: expected {}, got {}", name, expected, py::repr(values).cast<std::string>()));
  }
  if (array.ndim() != 1) {
    throw InputError(fmt::format("{}: expected a list, got an array of {} axes", name, array.ndim()));
  }
  return array;
}

std::span<const double> numbers_of(const ContiguousNumbers& list) {
  return {list.data(), static_cast<std::size_t>(list.size())};
}

/// Throws InputError unless several lists of data have one length.
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

const std::vector<double> nothing;

std::string terms_in_words(const RelaxationFit& fit) {
  return display_count(fit.series.terms().size(), "term");
}
std::string terms_in_words(const CreepFit& fit) {
  return display_count(fit.compliance.terms().size(), "term");
}

std::string quality_in_words(const FitQuality& quality, const char* unit) {
  return fmt::format("deviation from the data: median {:.2g} %, worst {:.2g} % at {:.4g} {}",
                     100.0 * quality.median_error, 100.0 * quality.worst_error, quality.worst_at, unit);
}

/// Numbers of a fit as a view.
template <class Fit, class Numbers>
auto list_of(const Numbers& numbers_in) {
  return [numbers_in](const py::object& self) {
    const std::vector<double>& numbers = numbers_in(self.cast<const MeasuredFit<Fit>&>());
    return view_of(numbers.data(), {static_cast<py::ssize_t>(numbers.size())}, self);
  };
}

/// Binds the members that all kinds of fits have.
template <class Fit>
void bind_quality(py::class_<MeasuredFit<Fit>>& fit) {
  using Measured = MeasuredFit<Fit>;
  using List = const std::vector<double>&;
  fit.def_property_readonly(
         "median_error", [](const Measured& self) { return self.fit.quality.median_error; },
         "Median of the absolute deviations from the data, relative [-].")
      .def_property_readonly(
          "worst_error", [](const Measured& self) { return self.fit.quality.worst_error; },
          "Largest absolute deviation from the data, relative [-].")
      .def_property_readonly(
          "worst_at", [](const Measured& self) { return self.fit.quality.worst_at; },
          "Time [s] or angular frequency [rad/s] of the largest deviation.")
      .def_property_readonly(
          "fitted", list_of<Fit>([](const Measured& self) -> List { return self.fit.quality.fitted; }),
          "Values of the fit at the data, in their unit; of dynamic moduli first all storage, then all loss moduli.")
      .def_property_readonly("measured", list_of<Fit>([](const Measured& self) -> List { return self.measured; }),
                             "The data, in the order of `fitted`.")
      .def_property_readonly("standard_errors", list_of<Fit>([](const Measured& self) -> List {
                               return self.fit.quality.standard_errors;
                             }),
                             "Standard error of the fit at each value, from the scatter of the data, relative [-].")
      .def_property_readonly(
          "law", [](const Measured& self) { return table_of(self.law); },
          "The fitted law as a table of a deck, in SI units; None where a spectrum was fitted.")
      .def_property_readonly(
          "law_errors", [](const Measured& self) { return errors_of(self.law); },
          "Standard errors of the parameters of the law: 0 of one that was not fitted, infinity where the data do not "
          "determine it, None where the data are met as well without it.")
      .def("__repr__", [](const Measured& self) {
        return fmt::format("<breccia.{}: {}; {}>",
                           py::type::of<Measured>().attr("__name__").template cast<std::string>(),
                           self.law ? name_of(self.law->form) : terms_in_words(self.fit),
                           quality_in_words(self.fit.quality, self.is_dynamic ? "rad/s" : "s"));
      });
}

py::tuple state_of_quality(const FitQuality& quality) {
  return py::make_tuple(quality.median_error, quality.worst_error, quality.worst_at, array_of(quality.fitted),
                        array_of(quality.standard_errors));
}

FitQuality quality_from(const py::tuple& state) {
  return {state[0].cast<double>(), state[1].cast<double>(), state[2].cast<double>(),
          state[3].cast<std::vector<double>>(), state[4].cast<std::vector<double>>()};
}

MeasuredFit<CreepFit> creep_fit_from(const py::tuple& state) {
  return {{compliance_from(state[0].cast<py::tuple>()), quality_from(state[1].cast<py::tuple>())},
          false,
          state[2].cast<std::vector<double>>(),
          state[3].cast<std::vector<double>>(),
          fitted_law_from(state[4])};
}

void bind_results(py::module_& module) {
  using Relaxation = MeasuredFit<RelaxationFit>;
  using Creep = MeasuredFit<CreepFit>;
  py::class_<Relaxation> relaxation(module, "RelaxationFit", "A Prony series fitted to data.");
  relaxation
      .def_property_readonly(
          "series", [](const Relaxation& self) { return self.fit.series; }, "The fit, a PronySeries.")
      .def_property_readonly("time", list_of<RelaxationFit>([](const Relaxation& self) -> const std::vector<double>& {
                               return self.is_dynamic ? nothing : self.at;
                             }),
                             "Times of the data [s]; none of dynamic moduli.")
      .def_property_readonly("angular_frequency",
                             list_of<RelaxationFit>([](const Relaxation& self) -> const std::vector<double>& {
                               return self.is_dynamic ? self.at : nothing;
                             }),
                             "Angular frequencies of dynamic moduli [rad/s]; else none.")
      .def(py::pickle([](const Relaxation& fit) { return python::state_of(fit); }, &relaxation_fit_from));
  bind_quality(relaxation);
  py::class_<Creep> creep(module, "CreepFit", "A creep compliance fitted to data.");
  creep
      .def_property_readonly(
          "compliance", [](const Creep& self) { return self.fit.compliance; }, "The fit, a CreepCompliance.")
      .def_property_readonly("time",
                             list_of<CreepFit>([](const Creep& self) -> const std::vector<double>& { return self.at; }),
                             "Times of the data [s].")
      .def(py::pickle(
          [](const Creep& self) {
            return py::make_tuple(python::state_of(self.fit.compliance), state_of_quality(self.fit.quality),
                                  array_of(self.at), array_of(self.measured), python::state_of(self.law));
          },
          &creep_fit_from));
  bind_quality(creep);
}

/// The numbers of a caller as a list.
std::vector<double> list_from(std::span<const double> numbers) {
  return {numbers.begin(), numbers.end()};
}

/// The law that a caller names; nothing: a spectrum.
std::optional<LawForm> form_named(const std::optional<std::string>& law) {
  return law ? std::optional(value_of<LawForm>("law", *law)) : std::nullopt;
}

MeasuredFit<RelaxationFit> relaxation_of(LawFit fit, bool is_dynamic, std::vector<double> at,
                                         std::vector<double> measured) {
  return {{std::move(fit.series), std::move(fit.quality)},
          is_dynamic,
          std::move(at),
          std::move(measured),
          FittedLaw{fit.form, std::move(fit.parameters)}};
}

void bind_functions(py::module_& module) {
  module.def(
      "fit",
      [](const py::object& time, const py::object& modulus, double ramp, double times_per_decade,
         const std::optional<std::string>& law, const GivenParameters& keep) {
        const auto time_list = checked_list("time", "s", time), modulus_list = checked_list("modulus", "Pa", modulus);
        require_equal_lengths("time", time_list, "modulus", modulus_list);
        const auto times = numbers_of(time_list), moduli = numbers_of(modulus_list);
        if (const auto form = form_named(law)) {
          return relaxation_of(without_lock([&] { return fit_law_to_moduli(*form, times, moduli, keep); }), false,
                               list_from(times), list_from(moduli));
        }
        const auto options = fit_options(ramp, times_per_decade);
        return MeasuredFit<RelaxationFit>{without_lock([&] { return fit_relaxation(times, moduli, options); }), false,
                                          list_from(times), list_from(moduli)};
      },
      py::arg("time"), py::arg("modulus"), py::kw_only(), py::arg("ramp") = 0.0, py::arg("times_per_decade") = 10.0,
      py::arg("law") = py::none(), py::arg("keep") = GivenParameters(),
      "Fits a Prony series to relaxation moduli [Pa] at rising times [s].\n\n"
      "ramp: duration [s] of the ramp by which the strain was applied; 0: a step.");
  module.def(
      "fit_creep",
      [](const py::object& time, const py::object& compliance, double ramp, double times_per_decade,
         const std::optional<std::string>& law, const GivenParameters& keep) {
        const auto time_list = checked_list("time", "s", time),
                   compliance_list = checked_list("compliance", "1/Pa", compliance);
        require_equal_lengths("time", time_list, "compliance", compliance_list);
        const auto times = numbers_of(time_list), compliances = numbers_of(compliance_list);
        if (const auto form = form_named(law)) {
          auto fit = without_lock([&] { return fit_law_to_compliances(*form, times, compliances, keep); });
          return MeasuredFit<CreepFit>{{creep_compliance(fit.series), std::move(fit.quality)},
                                       false,
                                       list_from(times),
                                       list_from(compliances),
                                       FittedLaw{fit.form, std::move(fit.parameters)}};
        }
        const auto options = fit_options(ramp, times_per_decade);
        return MeasuredFit<CreepFit>{without_lock([&] { return fit_creep(times, compliances, options); }), false,
                                     list_from(times), list_from(compliances)};
      },
      py::arg("time"), py::arg("compliance"), py::kw_only(), py::arg("ramp") = 0.0, py::arg("times_per_decade") = 10.0,
      py::arg("law") = py::none(), py::arg("keep") = GivenParameters(),
      "Fits a creep compliance [1/Pa] at rising times [s]; see fit().");
  module.def(
      "fit_dynamic",
      [](const py::object& frequency, const py::object& storage, const py::object& loss, double times_per_decade,
         const std::optional<std::string>& law, const GivenParameters& keep) {
        const auto frequency_list = checked_list("angular_frequency", "rad/s", frequency);
        const auto storage_list = checked_list("storage", "Pa", storage), loss_list = checked_list("loss", "Pa", loss);
        require_equal_lengths("angular_frequency", frequency_list, "storage", storage_list);
        require_equal_lengths("angular_frequency", frequency_list, "loss", loss_list);
        const auto frequencies = numbers_of(frequency_list), stored = numbers_of(storage_list),
                   lost = numbers_of(loss_list);
        if (const auto form = form_named(law)) {
          auto measured = list_from(stored);
          measured.insert(measured.end(), lost.begin(), lost.end());
          auto fit = without_lock([&] { return fit_law_to_dynamic_moduli(*form, frequencies, stored, lost, keep); });
          return relaxation_of(std::move(fit), true, list_from(frequencies), std::move(measured));
        }
        const auto options = fit_options(0.0, times_per_decade);
        return dynamic_fit(without_lock([&] { return fit_dynamic(frequencies, stored, lost, options); }),
                           list_from(frequencies), list_from(stored), list_from(lost));
      },
      py::arg("angular_frequency"), py::arg("storage"), py::arg("loss"), py::kw_only(),
      py::arg("times_per_decade") = 10.0, py::arg("law") = py::none(), py::arg("keep") = GivenParameters(),
      "Fits a Prony series to storage and loss moduli [Pa] at rising angular frequencies [rad/s].");
}

}  // namespace

MeasuredFit<RelaxationFit> dynamic_fit(RelaxationFit fit, std::vector<double> frequencies, std::vector<double> storage,
                                       const std::vector<double>& loss) {
  auto measured = std::move(storage);
  measured.insert(measured.end(), loss.begin(), loss.end());
  return {std::move(fit), true, std::move(frequencies), std::move(measured)};
}

py::tuple state_of(const MeasuredFit<RelaxationFit>& fit) {
  return py::make_tuple(state_of(fit.fit.series), state_of_quality(fit.fit.quality), fit.is_dynamic, array_of(fit.at),
                        array_of(fit.measured), state_of(fit.law));
}

MeasuredFit<RelaxationFit> relaxation_fit_from(const py::tuple& state) {
  return {{series_from(state[0].cast<py::tuple>()), quality_from(state[1].cast<py::tuple>())},
          state[2].cast<bool>(),
          state[3].cast<std::vector<double>>(),
          state[4].cast<std::vector<double>>(),
          fitted_law_from(state[5])};
}

FitOptions fit_options(double ramp, double times_per_decade) {
  if (!(times_per_decade > 0.0)) throw InputError("times_per_decade: expected a positive number");
  if (!(ramp >= 0.0)) throw InputError("ramp: expected a duration [s] that is not negative");
  return {.times_per_decade = times_per_decade, .ramp = ramp};
}

void bind_fits(py::module_& module) {
  bind_results(module);
  bind_functions(module);
}

}  // namespace breccia::python
