#include "results/volume_quantities.hpp"

#include <cmath>
#include <numeric>
#include <utility>

#include "breccia/discretisation/load.hpp"

#include "results/field_quantities.hpp"

namespace breccia {
namespace {

template <class Tensor>
Tensor tensor_of(const CellTensor& components) {
  const auto& [xx, yy, zz, yz, zx, xy] = components;
  return {.xx = xx, .yy = yy, .zz = zz, .yz = yz, .zx = zx, .xy = xy};
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

double stress_under(Load load, const CellTensor& stress) {
  return modulus_of<3>(load, tensor_of<Stress<3>>(stress));
}

double strain_under(Load load, const CellTensor& strain) {
  return compliance_of<3>(load, tensor_of<Strain<3>>(strain));
}

double equivalent_shear(const CellTensor& of_cell) {
  auto strain = tensor_of<Strain<3>>(of_cell);
  const double mean = (strain.xx + strain.yy + strain.zz) / 3.0;
  for (int axis = 0; axis < 3; ++axis) component(strain, axis) -= mean;
  return std::sqrt(2.0 * contraction(strain, strain));
}

VolumeQuantity stress_in_cells(std::span<const CellTensor> stress, Load load, Boundary boundary) {
  std::vector<double> values;
  values.reserve(stress.size());
  for (const auto& one : stress) values.push_back(stress_under(load, one));
  auto [words, unit_size] = stress_in_space(boundary, load, mean_of(values));
  return {.words = std::move(words), .unit_size = unit_size, .values = std::move(values)};
}

VolumeQuantity strain_in_cells(std::span<const CellTensor> strain, Load load) {
  std::vector<double> values;
  values.reserve(strain.size());
  double of_load = 0.0;
  for (const auto& one : strain) {
    of_load += strain_under(load, one);
    values.push_back(equivalent_shear(one));
  }
  auto [words, unit_size] = strain_in_space(load, of_load / static_cast<double>(strain.size()));
  return {.words = std::move(words),
          .unit_size = unit_size,
          .scale = ColourScale::logarithmic,
          .values = std::move(values)};
}

}  // namespace breccia
