#include "stage_dictionaries.hpp"

#include <complex>
#include <limits>
#include <vector>

#include <pybind11/complex.h>
#include <pybind11/numpy.h>

#include "views.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

/// The complex moduli of a comparison: computed and measured ones at angular frequencies.
void add_in_frequency(const Comparison& comparison, py::dict& one) {
  std::vector<double> frequencies, errors;
  std::vector<std::complex<double>> moduli, measured;
  for (const auto& sample : comparison.in_frequency) {
    frequencies.push_back(sample.angular_frequency);
    moduli.emplace_back(sample.storage, sample.loss);
    measured.emplace_back(sample.measured_storage, sample.measured_loss);
    errors.push_back(number_or_nan(sample.error));
  }
  const auto complex_array = [](const std::vector<std::complex<double>>& values) {
    return py::array_t<std::complex<double>>(static_cast<py::ssize_t>(values.size()), values.data());
  };
  one["angular_frequency"] = array_of(frequencies);
  one["complex_modulus"] = complex_array(moduli);
  one["complex_measured"] = complex_array(measured);
  one["complex_error"] = array_of(errors);
}

}  // namespace

py::list comparisons_of(const SolvedStage& stage) {
  py::list comparisons;
  for (const auto& comparison : stage.result.comparisons) {
    std::vector<double> times, moduli, measured, errors;
    for (const auto& [time, modulus, value, error] : comparison.samples) {
      times.push_back(time);
      moduli.push_back(modulus);
      measured.push_back(value);
      errors.push_back(number_or_nan(error));
    }
    py::dict one;
    one["measurement"] = comparison.measurement;
    one["kind"] = name_of(comparison.kind);
    one["boundary"] = name_of(comparison.test.boundary);
    one["method"] = name_of(comparison.test.method);
    one["time"] = array_of(times);
    one["modulus"] = array_of(moduli);
    one["measured"] = array_of(measured);
    one["error"] = array_of(errors);
    add_in_frequency(comparison, one);
    comparisons.append(one);
  }
  return comparisons;
}

py::list expansions_of(const SolvedStage& stage) {
  py::list expansions;
  for (const auto& [test, samples] : stage.result.expansions) {
    std::vector<double> times, values, errors;
    for (const auto& [time, expansion, error] : samples) {
      times.push_back(time);
      values.push_back(expansion);
      errors.push_back(number_or_nan(error));
    }
    py::dict one;
    one["boundary"] = name_of(test.boundary);
    one["method"] = name_of(test.method);
    one["time"] = array_of(times);
    one["expansion"] = array_of(values);
    one["error"] = array_of(errors);
    expansions.append(one);
  }
  return expansions;
}

py::list stiffness_of(const SolvedStage& stage) {
  py::list all;
  for (const auto& [test, samples] : stage.result.stiffness) {
    const py::ssize_t side = stage.result.dimensions == 3 ? 6 : 3;
    py::array_t<double> stiffness({static_cast<py::ssize_t>(samples.size()), side, side});
    auto values = stiffness.mutable_unchecked<3>();
    std::vector<double> times, bulk, shear, anisotropy, errors;
    for (py::ssize_t row = 0; row < values.shape(0); ++row) {
      const auto& [time, constants, error] = samples[static_cast<std::size_t>(row)];
      const auto part = isotropic_part(constants);
      times.push_back(time);
      bulk.push_back(part.bulk);
      shear.push_back(part.shear);
      anisotropy.push_back(number_or_nan(part.anisotropy));
      errors.push_back(number_or_nan(error));
      auto constant = constants.begin();
      for (py::ssize_t i = 0; i < side; ++i) {
        for (py::ssize_t j = i; j < side; ++j) values(row, i, j) = values(row, j, i) = *constant++;
      }
    }
    py::dict one;
    one["boundary"] = name_of(test.boundary);
    one["time"] = array_of(times);
    one["stiffness"] = stiffness;
    one["bulk"] = array_of(bulk);
    one["shear"] = array_of(shear);
    one["anisotropy"] = array_of(anisotropy);
    one["error"] = array_of(errors);
    all.append(one);
  }
  return all;
}

}  // namespace breccia::python
