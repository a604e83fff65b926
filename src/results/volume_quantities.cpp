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

/// The mean of values in cells of these volumes.
double mean_of(std::span<const double> values, std::span<const double> volumes) {
  const double sum = std::inner_product(values.begin(), values.end(), volumes.begin(), 0.0);
  return sum / std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

}  // namespace

CellTensor in_order_of_vtk(const CellTensor& tensor) {
  const auto& [xx, yy, zz, yz, zx, xy] = tensor;
  return {xx, yy, zz, xy, yz, zx};
}

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

VolumeQuantity stress_in_cells(std::span<const CellTensor> stress, std::span<const double> volumes, Load load,
                               Boundary boundary) {
  std::vector<double> values;
  values.reserve(stress.size());
  for (const auto& one : stress) values.push_back(stress_under(load, one));
  auto [words, unit_size] = stress_in_space(boundary, load, mean_of(values, volumes));
  return {.words = std::move(words), .unit_size = unit_size, .values = std::move(values)};
}

VolumeQuantity strain_in_cells(std::span<const CellTensor> strain, std::span<const double> volumes, Load load) {
  std::vector<double> values, of_load;
  values.reserve(strain.size());
  of_load.reserve(strain.size());
  for (const auto& one : strain) {
    of_load.push_back(strain_under(load, one));
    values.push_back(equivalent_shear(one));
  }
  auto [words, unit_size] = strain_in_space(load, mean_of(of_load, volumes));
  return {.words = std::move(words),
          .unit_size = unit_size,
          .scale = ColourScale::logarithmic,
          .values = std::move(values)};
}

}  // namespace breccia
