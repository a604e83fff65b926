#include "materials.hpp"

#include <complex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pybind11/complex.h>
#include <pybind11/numpy.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/creep_compliance.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

#include "arguments.hpp"
#include "deck/material_file.hpp"
#include "io/display.hpp"
#include "views.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

constexpr Expected any_time = {"time", "s", Range::not_negative()};
constexpr Expected any_frequency = {"angular_frequency", "rad/s", Range::not_negative()};
constexpr Expected factors = {"factor", "", Range::positive()};

std::vector<MaxwellTerm> maxwell_terms_of(const py::object& terms) {
  std::vector<MaxwellTerm> read;
  for (const auto& [time, modulus] :
       pairs_of("terms", "pairs of a relaxation time and a modulus", terms, &modulus_of)) {
    read.push_back({time, modulus});
  }
  return read;
}

std::vector<RetardationTerm> retardation_terms_of(const py::object& terms) {
  std::vector<RetardationTerm> read;
  for (const auto& [time, compliance] :
       pairs_of("terms", "pairs of a retardation time and a compliance", terms, &plain_number_of)) {
    read.push_back({time, compliance});
  }
  return read;
}

std::string in_words(const PronySeries& series) {
  if (series.is_elastic()) return fmt::format("<breccia.PronySeries: {}>", display(series.equilibrium(), "Pa"));
  return fmt::format("<breccia.PronySeries: {} from {} to {}, relaxing from {} to {}>",
                     display_count(series.terms().size(), "term"), display_time(series.terms().back().relaxation_time),
                     display_time(series.terms().front().relaxation_time), display(series.unrelaxed(), "Pa"),
                     display(series.equilibrium(), "Pa"));
}

void bind_series(py::module_& module) {
  py::class_<PronySeries>(module, "PronySeries",
                          "Relaxation modulus M(t) = M_inf + sum_k M_k exp(-t / tau_k) [Pa].\n\n"
                          "terms: a pair for each term, or an n x 2 array: its relaxation time [s] and its modulus "
                          "[Pa], numbers or text with a unit, as in [(\"1 ms\", \"2 MPa\"), (1.0, 5e5)]; two lists "
                          "become pairs by zip(times, moduli); equilibrium: M_inf [Pa].")
      .def(py::init([](const py::object& terms, const py::object& equilibrium) {
             return PronySeries(modulus_of("equilibrium", equilibrium), maxwell_terms_of(terms));
           }),
           py::arg("terms") = py::tuple(), py::arg("equilibrium") = 0.0)
      .def_property_readonly("equilibrium", &PronySeries::equilibrium, "Modulus at infinite time [Pa].")
      .def_property_readonly("unrelaxed", &PronySeries::unrelaxed, "Modulus at t = 0 [Pa].")
      .def_property_readonly("is_elastic", &PronySeries::is_elastic, "Whether nothing relaxes.")
      .def_property_readonly(
          "terms",
          [](const py::object& self) {
            const auto& terms = self.cast<const PronySeries&>().terms();
            static_assert(sizeof(MaxwellTerm) == 2 * sizeof(double));
            const double* first = terms.empty() ? nullptr : &terms.front().relaxation_time;
            return view_of(first, {static_cast<py::ssize_t>(terms.size()), 2}, self);
          },
          "n x 2 array: relaxation times [s], falling, and moduli [Pa].")
      .def_property_readonly(
          "relaxation_times",
          [](const py::object& self) {
            return view_of(self.cast<const PronySeries&>().terms(), &MaxwellTerm::relaxation_time, self);
          },
          "Relaxation times [s], falling.")
      .def_property_readonly(
          "moduli",
          [](const py::object& self) {
            return view_of(self.cast<const PronySeries&>().terms(), &MaxwellTerm::modulus, self);
          },
          "Moduli of the terms [Pa].")
      .def(
          "at",
          [](const PronySeries& series, const py::object& time) {
            return py::vectorize([&series](double t) { return series.at(t); })(numbers_of(any_time, time, &time_of));
          },
          py::arg("time"), "Relaxation modulus [Pa] at times [s], a number, an array or text such as \"1 ms\".")
      .def(
          "complex_modulus",
          [](const PronySeries& series, const py::object& frequency) {
            return py::vectorize([&series](double omega) { return series.complex_modulus(omega); })(
                numbers_of(any_frequency, frequency, &angular_frequency_of));
          },
          py::arg("angular_frequency"),
          "Complex modulus M' + i M'' [Pa] at angular frequencies [rad/s], a number, an array or text such as \"10 "
          "rad/s\" or \"1 Hz\".")
      .def(
          "shifted",
          [](const PronySeries& series, double factor) {
            require(factors, factor);
            return series.shifted(factor);
          },
          py::arg("factor"), "The series with every relaxation time multiplied by a shift factor a_T.")
      .def(
          "scaled",
          [](const PronySeries& series, double factor) {
            require(factors, factor);
            return series.scaled(factor);
          },
          py::arg("factor"), "The series with every modulus multiplied by a factor.")
      .def(
          "creep_compliance", [](const PronySeries& series) { return creep_compliance(series); },
          "The creep compliance of a solid with this modulus, by exact interconversion.")
      .def(py::self == py::self)  // NOLINT(misc-redundant-expression): this is how pybind11 takes an operator
      .def("__repr__", &in_words)
      .def(py::pickle([](const PronySeries& series) { return state_of(series); }, &series_from));
}

void bind_compliance(py::module_& module) {
  py::class_<CreepCompliance>(module, "CreepCompliance",
                              "Creep compliance J(t) = J_0 + sum_k J_k (1 - exp(-t / lambda_k)) + phi t [1/Pa].\n\n"
                              "terms: a pair for each term, or an n x 2 array: its retardation time [s] and its "
                              "compliance [1/Pa]; fluidity: phi [1/(Pa s)].")
      .def(py::init([](double instantaneous, const py::object& terms, double fluidity) {
             return CreepCompliance(instantaneous, retardation_terms_of(terms), fluidity);
           }),
           py::arg("instantaneous"), py::arg("terms") = py::tuple(), py::arg("fluidity") = 0.0)
      .def_property_readonly("instantaneous", &CreepCompliance::instantaneous, "Compliance at t = 0 [1/Pa].")
      .def_property_readonly("fluidity", &CreepCompliance::fluidity,
                             "Rate of steady flow under unit stress [1/(Pa s)].")
      .def_property_readonly(
          "terms",
          [](const py::object& self) {
            const auto& terms = self.cast<const CreepCompliance&>().terms();
            static_assert(sizeof(RetardationTerm) == 2 * sizeof(double));
            const double* first = terms.empty() ? nullptr : &terms.front().retardation_time;
            return view_of(first, {static_cast<py::ssize_t>(terms.size()), 2}, self);
          },
          "n x 2 array: retardation times [s], falling, and compliances [1/Pa].")
      .def(
          "at",
          [](const CreepCompliance& compliance, const py::object& time) {
            return py::vectorize([&compliance](double t) { return compliance.at(t); })(
                numbers_of(any_time, time, &time_of));
          },
          py::arg("time"), "Creep compliance [1/Pa] at times [s], a number, an array or text such as \"1 ms\".")
      .def(
          "complex_compliance",
          [](const CreepCompliance& compliance, const py::object& frequency) {
            return py::vectorize([&compliance](double omega) { return compliance.complex_compliance(omega); })(
                numbers_of({"angular_frequency", "rad/s", Range::positive()}, frequency, &angular_frequency_of));
          },
          py::arg("angular_frequency"),
          "Complex compliance J' - i J'' [1/Pa] at angular frequencies [rad/s], as above.")
      .def(
          "relaxation_modulus", [](const CreepCompliance& compliance) { return relaxation_modulus(compliance); },
          "The relaxation modulus of a solid with this compliance, by exact interconversion.")
      .def(py::self == py::self)  // NOLINT(misc-redundant-expression): as above
      .def("__repr__",
           [](const CreepCompliance& compliance) {
             return fmt::format("<breccia.CreepCompliance: {}, {:.4g} 1/Pa at t = 0>",
                                display_count(compliance.terms().size(), "term"), compliance.instantaneous());
           })
      .def(py::pickle([](const CreepCompliance& compliance) { return state_of(compliance); }, &compliance_from));
}

void bind_solid(py::module_& module) {
  py::class_<Material>(module, "Solid",
                       "An isotropic linear viscoelastic solid as the solvers see it: numbers alone, in SI units.")
      .def(py::init([](std::string name, double density, PronySeries bulk, PronySeries shear) {
             return Material{std::move(name), density, std::move(bulk), std::move(shear)};
           }),
           py::arg("name"), py::kw_only(), py::arg("density"), py::arg("bulk"), py::arg("shear"))
      .def_readonly("name", &Material::name)
      .def_readonly("density", &Material::density, "[kg/m^3]")
      .def_readonly("bulk", &Material::bulk, "Bulk modulus K(t) [Pa], a PronySeries.")
      .def_readonly("shear", &Material::shear, "Shear modulus G(t) [Pa], a PronySeries.")
      .def(py::self == py::self)  // NOLINT(misc-redundant-expression): as above
      .def("__repr__",
           [](const Material& material) {
             return fmt::format("<breccia.Solid {}: G {}, K {} at t = 0>", material.name,
                                display(material.shear.unrelaxed(), "Pa"), display(material.bulk.unrelaxed(), "Pa"));
           })
      .def(py::pickle([](const Material& material) { return state_of(material); }, &material_from));
  py::class_<ShiftedMaterial>(module, "ShiftedSolid", "A solid with the law of its temperature shift, if it has one.")
      .def(py::init([](Material solid) {
             return ShiftedMaterial{std::move(solid), std::nullopt};
           }),
           py::arg("solid"))
      .def_readonly("solid", &ShiftedMaterial::material);
  module.def("shifted_from_text", &shifted_material_from_text, py::arg("text"), py::arg("name"), py::arg("directory"));
  module.def("read_shifted", &read_shifted_material_file, py::arg("file"));
}

}  // namespace

py::tuple state_of(const PronySeries& series) {
  std::vector<double> times, moduli;
  for (const auto& [time, modulus] : series.terms()) {
    times.push_back(time);
    moduli.push_back(modulus);
  }
  return py::make_tuple(series.equilibrium(), array_of(times), array_of(moduli));
}

PronySeries series_from(const py::tuple& state) {
  const auto times = state[1].cast<std::vector<double>>(), moduli = state[2].cast<std::vector<double>>();
  // A bulk modulus of a composite in plane strain may have negative terms, which a difference alone can have.
  std::vector<MaxwellTerm> positive, negative;
  for (std::size_t i = 0; i < times.size(); ++i) {
    auto& terms = moduli.at(i) < 0.0 ? negative : positive;
    terms.push_back({times[i], std::abs(moduli[i])});
  }
  PronySeries whole(state[0].cast<double>(), std::move(positive));
  return negative.empty() ? whole : PronySeries::difference(whole, PronySeries(0.0, std::move(negative)));
}

py::tuple state_of(const CreepCompliance& compliance) {
  std::vector<double> times, compliances;
  for (const auto& [time, value] : compliance.terms()) {
    times.push_back(time);
    compliances.push_back(value);
  }
  return py::make_tuple(compliance.instantaneous(), times, compliances, compliance.fluidity());
}

CreepCompliance compliance_from(const py::tuple& state) {
  std::vector<RetardationTerm> terms;
  const auto times = state[1].cast<std::vector<double>>(), values = state[2].cast<std::vector<double>>();
  for (std::size_t i = 0; i < times.size(); ++i) terms.push_back({times[i], values.at(i)});
  return {state[0].cast<double>(), std::move(terms), state[3].cast<double>()};
}

py::tuple state_of(const Material& material) {
  return py::make_tuple(material.name, material.density, state_of(material.bulk), state_of(material.shear));
}

Material material_from(const py::tuple& state) {
  return {state[0].cast<std::string>(), state[1].cast<double>(), series_from(state[2].cast<py::tuple>()),
          series_from(state[3].cast<py::tuple>())};
}

std::vector<Material> without_shifts(const std::vector<ShiftedMaterial>& materials) {
  std::vector<Material> solids;
  solids.reserve(materials.size());
  for (const auto& one : materials) solids.push_back(one.material);
  return solids;
}

void bind_materials(py::module_& module) {
  bind_series(module);
  bind_compliance(module);
  bind_solid(module);
}

}  // namespace breccia::python
