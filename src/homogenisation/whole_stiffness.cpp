#include "homogenisation/whole_stiffness.hpp"

#include <algorithm>
#include <cstddef>

#include "breccia/discretisation/crystals.hpp"

namespace breccia {
namespace {

template <int dim>
using Matrix = StiffnessTensor<dim>;

/// The single loads, whose unit strains span all strains of a body.
std::vector<Load> single_loads(int dimensions) {
  const auto shears = isotropic_shears(dimensions);
  std::vector<Load> loads(shears.begin(), shears.end());
  loads.push_back(Load::bulk);
  return loads;
}

/// The unit strains of the single loads, row by row, in Voigt's order with engineering shears.
template <int dim>
Matrix<dim> strains_of_loads() {
  Matrix<dim> strains;
  int row = 0;
  for (const auto load : single_loads(dim)) {
    strains.row(row++) = engineering_strain<dim>(unit_strain<dim>(load)).transpose();
  }
  return strains;
}

/// The curves of one boundary that the stiffness follows from: those under the single loads, and those under pairs.
struct StiffnessCurves {
  std::vector<const TestResult*> singles;
  std::vector<const TestResult*> pairs;  ///< in the order of pairs_of_loads, as far as the box has them
};

StiffnessCurves curves_of(int dimensions, Boundary boundary, const std::vector<TestResult>& tests,
                          const std::vector<TestResult>& pairs) {
  StiffnessCurves curves;
  for (const auto load : single_loads(dimensions)) curves.singles.push_back(&preferred_test(tests, load, boundary));
  for (const auto& pair : pairs_of_loads) {
    if (has_test_load(pair.both, dimensions)) curves.pairs.push_back(&preferred_test(pairs, pair.both, boundary));
  }
  return curves;
}

/// E_k : C : E_l for all single loads k and l (theory, Eq. 13c), from the moduli at a time, by its index.
template <int dim>
Matrix<dim> products_of_loads(const StiffnessCurves& curves, std::size_t time) {
  const auto modulus = [time](const TestResult* test) { return test->modulus.at(time).modulus; };
  Matrix<dim> products = Matrix<dim>::Zero();
  for (int k = 0; k < tensor_components<dim>; ++k) {
    products(k, k) = modulus(curves.singles[static_cast<std::size_t>(k)]);
  }
  const auto loads = single_loads(dim);
  const auto index_of = [&loads](Load load) { return std::ranges::find(loads, load) - loads.begin(); };
  for (const auto* test : curves.pairs) {
    const auto pair = *pair_of(*test->id.load.of_test());
    const auto k = index_of(pair.one), l = index_of(pair.other);
    products(k, l) = products(l, k) = 0.5 * (modulus(test) - products(k, k) - products(l, l));
  }
  return products;
}

template <int dim>
std::vector<double> upper_triangle(const Matrix<dim>& stiffness) {
  std::vector<double> constants;
  for (int i = 0; i < tensor_components<dim>; ++i) {
    for (int j = i; j < tensor_components<dim>; ++j) constants.push_back(0.5 * (stiffness(i, j) + stiffness(j, i)));
  }
  return constants;
}

std::optional<double> error_at(const StiffnessCurves& curves, std::size_t time) {
  std::vector<ModulusError> errors;
  for (const auto* test : curves.singles) {
    if (time >= test->errors.size()) return std::nullopt;
    errors.push_back(test->errors[time]);
  }
  return largest_whole(errors);
}

template <int dim>
std::vector<StiffnessSample> samples_of(const StiffnessCurves& curves) {
  const Matrix<dim> to_axes = strains_of_loads<dim>().inverse();
  std::vector<StiffnessSample> samples;
  const auto& times = curves.singles.front()->modulus;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Matrix<dim> stiffness = to_axes * products_of_loads<dim>(curves, i) * to_axes.transpose();
    samples.push_back({times[i].time, upper_triangle<dim>(stiffness), error_at(curves, i)});
  }
  return samples;
}

}  // namespace

std::vector<StageStiffness> whole_stiffness(int dimensions, const std::vector<TestResult>& tests,
                                            const std::vector<TestResult>& pairs) {
  std::vector<StageStiffness> found;
  for (const auto& [name, boundary] : words<Boundary>) {
    const auto is_of_boundary = [boundary = boundary](const TestResult& test) { return test.id.boundary == boundary; };
    if (std::ranges::none_of(pairs, is_of_boundary)) continue;
    const auto curves = curves_of(dimensions, boundary, tests, pairs);
    found.push_back({preferred_test(tests, TestLoad::isotropic(), boundary).id,
                     dimensions == 3 ? samples_of<3>(curves) : samples_of<2>(curves)});
  }
  return found;
}

}  // namespace breccia
