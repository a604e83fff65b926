#include "assembly/matrix_assembly.hpp"

#include <cstddef>
#include <utility>

namespace breccia::films {

Eigen::Matrix<double, 2, 3> traction_on(const Eigen::Vector2d& line) {
  const Eigen::Vector2d normal(line.y(), -line.x());
  Eigen::Matrix<double, 2, 3> force;
  force << normal.x(), 0.0, normal.y(), 0.0, normal.y(), normal.x();
  return force;
}

MatrixAssembly::MatrixAssembly(int unknowns, int pressures) : unknowns_(unknowns), pressures_(pressures) {
  result_.tractions.setZero(unknowns, 3);
  result_.by_gradient.setZero(unknowns, 4);
}

void MatrixAssembly::add_grain(const ElementUnknowns& unknowns, const Eigen::MatrixXd& stiffness) {
  add_symmetric(grains_, unknowns, stiffness);
}

void MatrixAssembly::add_shear(const ElementUnknowns& unknowns, const Eigen::MatrixXd& stiffness) {
  add_symmetric(shear_, unknowns, stiffness);
}

void MatrixAssembly::add_resistance(int unknown, double stiffness) {
  shear_.emplace_back(unknown, unknown, stiffness);
}

/// Adds the lower triangle of an element's matrix, and its rows of the macroscopic strains.
void MatrixAssembly::add_symmetric(Entries& entries, const ElementUnknowns& unknowns,
                                   const Eigen::MatrixXd& matrix) const {
  const auto& numbers = unknowns.numbers;
  const Eigen::Matrix<double, Eigen::Dynamic, 3> of_strains = matrix * unknowns.macroscopic;
  const Eigen::Matrix3d of_both = unknowns.macroscopic.transpose() * of_strains;
  for (std::size_t b = 0; b < numbers.size(); ++b) {
    const auto column = static_cast<Eigen::Index>(b);
    if (numbers[b] == held) continue;
    for (std::size_t a = 0; a < numbers.size(); ++a) {
      if (numbers[a] >= numbers[b]) {
        entries.emplace_back(numbers[a], numbers[b], matrix(static_cast<Eigen::Index>(a), column));
      }
    }
    for (int i = 0; i < FilmMatrices::macroscopic; ++i) {
      entries.emplace_back(unknowns_ + i, numbers[b], of_strains(column, i));
    }
  }
  for (int j = 0; j < FilmMatrices::macroscopic; ++j) {
    for (int i = j; i < FilmMatrices::macroscopic; ++i) {
      entries.emplace_back(unknowns_ + i, unknowns_ + j, of_both(i, j));
    }
  }
}

void MatrixAssembly::add_dilatation(std::span<const int> pressures, const ElementUnknowns& unknowns,
                                    const Eigen::MatrixXd& matrix) {
  const Eigen::Matrix<double, Eigen::Dynamic, 3> of_strains = matrix * unknowns.macroscopic;
  for (std::size_t p = 0; p < pressures.size(); ++p) {
    const auto row = static_cast<Eigen::Index>(p);
    for (std::size_t b = 0; b < unknowns.numbers.size(); ++b) {
      if (unknowns.numbers[b] == held) continue;
      dilatation_.emplace_back(pressures[p], unknowns.numbers[b], matrix(row, static_cast<Eigen::Index>(b)));
    }
    for (int i = 0; i < FilmMatrices::macroscopic; ++i) {
      dilatation_.emplace_back(pressures[p], unknowns_ + i, of_strains(row, i));
    }
  }
}

void MatrixAssembly::add_outflow(int pressure, int unknown, double volume) {
  dilatation_.emplace_back(pressure, unknown, volume);
}

void MatrixAssembly::add_volume(std::span<const int> pressures, const Eigen::MatrixXd& matrix) {
  for (std::size_t a = 0; a < pressures.size(); ++a) {
    for (std::size_t b = 0; b < pressures.size(); ++b) {
      if (pressures[a] < pressures[b]) continue;
      volume_.emplace_back(pressures[a], pressures[b],
                           matrix(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)));
    }
  }
}

void MatrixAssembly::add_traction(int unknown, const Eigen::RowVector3d& forces) {
  if (unknown != held) result_.tractions.row(unknown) += forces;
}

void MatrixAssembly::set_place(int unknown, int component, const Eigen::Vector2d& place) {
  if (unknown != held) result_.by_gradient.row(unknown).segment<2>(2 * component) = place.transpose();
}

FilmMatrices MatrixAssembly::finish() {
  const auto make = [](FilmMatrices::Sparse& matrix, int rows, int columns, Entries& entries) {
    matrix.resize(rows, columns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    entries = {};
  };
  const int all = unknowns_ + FilmMatrices::macroscopic;
  make(result_.grains, all, all, grains_);
  make(result_.shear, all, all, shear_);
  make(result_.dilatation, pressures_, all, dilatation_);
  make(result_.volume, pressures_, pressures_, volume_);
  return std::move(result_);
}

}  // namespace breccia::films
