#include "films/assembly/matrix_assembly.hpp"

#include <cstddef>
#include <utility>

#include "films/assembly/macroscopic.hpp"

namespace breccia::films {

Eigen::Matrix<double, 2, 3> traction_on(const Eigen::Vector2d& line) {
  const Eigen::Vector2d normal(line.y(), -line.x());
  Eigen::Matrix<double, 2, 3> force;
  force << normal.x(), 0.0, normal.y(), 0.0, normal.y(), normal.x();
  return force;
}

template <int dim>
MatrixAssembly<dim>::MatrixAssembly(int unknowns, int pressures)
    : unknowns_(unknowns),
      pressures_(pressures),
      is_pressure_held_(static_cast<std::size_t>(pressures), false),
      grains_(unknowns),
      shear_(unknowns) {
  result_.tractions.setZero(unknowns, Matrices::macroscopic);
  result_.by_gradient.setZero(unknowns, dim * dim);
}

template <int dim>
void MatrixAssembly<dim>::add_grain(const ElementUnknowns<dim>& unknowns, const Eigen::MatrixXd& stiffness) {
  add_symmetric(grains_, unknowns, stiffness);
}

template <int dim>
void MatrixAssembly<dim>::add_shear(const ElementUnknowns<dim>& unknowns, const Eigen::MatrixXd& stiffness) {
  add_symmetric(shear_, unknowns, stiffness);
}

template <int dim>
void MatrixAssembly<dim>::add_resistance(int unknown, double stiffness) {
  shear_.entries.emplace_back(unknown, unknown, stiffness);
}

/// Adds the lower triangle of an element's matrix, and its rows of the macroscopic strains.
template <int dim>
void MatrixAssembly<dim>::add_symmetric(Part& part, const ElementUnknowns<dim>& unknowns,
                                        const Eigen::MatrixXd& matrix) {
  const auto& numbers = unknowns.numbers;
  const typename Matrices::ByStrain of_strains = matrix * unknowns.macroscopic;
  part.of_both += unknowns.macroscopic.transpose() * of_strains;
  for (std::size_t b = 0; b < numbers.size(); ++b) {
    const auto column = static_cast<Eigen::Index>(b);
    if (numbers[b] == held) continue;
    for (std::size_t a = 0; a < numbers.size(); ++a) {
      if (numbers[a] >= numbers[b]) {
        part.entries.emplace_back(numbers[a], numbers[b], matrix(static_cast<Eigen::Index>(a), column));
      }
    }
    part.of_strains.row(numbers[b]) += of_strains.row(column);
  }
  constexpr std::size_t many = 10'000'000;
  if (part.entries.size() > many) part.add_up();
}

template <int dim>
void MatrixAssembly<dim>::add_dilatation(std::span<const int> pressures, const ElementUnknowns<dim>& unknowns,
                                         const Eigen::MatrixXd& matrix) {
  const typename Matrices::ByStrain of_strains = matrix * unknowns.macroscopic;
  for (std::size_t p = 0; p < pressures.size(); ++p) {
    const auto row = static_cast<Eigen::Index>(p);
    for (std::size_t b = 0; b < unknowns.numbers.size(); ++b) {
      if (unknowns.numbers[b] == held) continue;
      dilatation_.emplace_back(pressures[p], unknowns.numbers[b], matrix(row, static_cast<Eigen::Index>(b)));
    }
    for (int i = 0; i < Matrices::macroscopic; ++i) {
      dilatation_.emplace_back(pressures[p], unknowns_ + i, of_strains(row, i));
    }
  }
}

template <int dim>
void MatrixAssembly<dim>::add_outflow(int pressure, int unknown, double volume) {
  dilatation_.emplace_back(pressure, unknown, volume);
}

template <int dim>
void MatrixAssembly<dim>::add_volume(std::span<const int> pressures, const Eigen::MatrixXd& matrix) {
  for (std::size_t a = 0; a < pressures.size(); ++a) {
    for (std::size_t b = 0; b < pressures.size(); ++b) {
      if (pressures[a] < pressures[b]) continue;
      volume_.emplace_back(pressures[a], pressures[b],
                           matrix(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)));
    }
  }
}

template <int dim>
void MatrixAssembly<dim>::add_traction(int unknown, const Eigen::Matrix<double, 1, Matrices::macroscopic>& forces) {
  if (unknown != held) result_.tractions.row(unknown) += forces;
}

template <int dim>
void MatrixAssembly<dim>::set_position(int unknown, int component, const Position& position) {
  if (unknown != held) result_.by_gradient.row(unknown).template segment<dim>(dim * component) = position.transpose();
}

template <int dim>
MatrixAssembly<dim>::Part::Part(int unknowns)
    : sum(unknowns + Matrices::macroscopic, unknowns + Matrices::macroscopic) {
  of_strains.setZero(unknowns, Matrices::macroscopic);
  of_both.setZero();
}

template <int dim>
void MatrixAssembly<dim>::Part::add_up() {
  Sparse further(sum.rows(), sum.cols());
  further.setFromTriplets(entries.begin(), entries.end());
  entries.clear();
  if (sum.nonZeros() == 0) {
    sum.swap(further);
  } else {
    sum = Sparse(sum + further);
  }
}

template <int dim>
typename MatrixAssembly<dim>::Sparse MatrixAssembly<dim>::Part::finish() {
  const auto unknowns = static_cast<int>(of_strains.rows());
  for (int j = 0; j < Matrices::macroscopic; ++j) {
    for (int unknown = 0; unknown < unknowns; ++unknown) {
      if (of_strains(unknown, j) != 0.0) entries.emplace_back(unknowns + j, unknown, of_strains(unknown, j));
    }
    for (int i = j; i < Matrices::macroscopic; ++i) entries.emplace_back(unknowns + i, unknowns + j, of_both(i, j));
  }
  add_up();
  entries = {};
  Sparse whole;
  whole.swap(sum);
  return whole;
}

template <int dim>
void MatrixAssembly<dim>::leave_out_held_pressures() {
  const auto is_held = [this](int pressure) { return is_pressure_held_[static_cast<std::size_t>(pressure)]; };
  std::erase_if(dilatation_, [&](const auto& entry) { return is_held(entry.row()); });
  std::erase_if(volume_, [&](const auto& entry) { return is_held(entry.row()) || is_held(entry.col()); });
  for (int pressure = 0; pressure < pressures_; ++pressure) {
    if (is_held(pressure)) volume_.emplace_back(pressure, pressure, 1.0);
  }
}

template <int dim>
FilmMatrices<dim> MatrixAssembly<dim>::finish() {
  leave_out_held_pressures();
  const auto make = [](Sparse& matrix, int rows, int columns, Entries& entries) {
    matrix.resize(rows, columns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    entries = {};
  };
  result_.grains = grains_.finish();
  result_.shear = shear_.finish();
  make(result_.dilatation, pressures_, unknowns_ + Matrices::macroscopic, dilatation_);
  make(result_.volume, pressures_, pressures_, volume_);
  return std::move(result_);
}

template <int dim>
double work_in_uniform_shear(const ElementUnknowns<dim>& unknowns, const Eigen::MatrixXd& shear) {
  const Eigen::VectorXd motion = unknowns.macroscopic * strain_of<dim>(Load::shear);
  return motion.dot(shear * motion);
}

template double work_in_uniform_shear(const ElementUnknowns<2>&, const Eigen::MatrixXd&);
template double work_in_uniform_shear(const ElementUnknowns<3>&, const Eigen::MatrixXd&);
template class MatrixAssembly<2>;
template class MatrixAssembly<3>;

}  // namespace breccia::films
