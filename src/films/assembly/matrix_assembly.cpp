#include "films/assembly/matrix_assembly.hpp"

#include <cstddef>
#include <utility>

namespace breccia::films {

Eigen::Matrix<double, 2, 3> traction_on(const Eigen::Vector2d& line) {
  const Eigen::Vector2d normal(line.y(), -line.x());
  Eigen::Matrix<double, 2, 3> force;
  force << normal.x(), 0.0, normal.y(), 0.0, normal.y(), normal.x();
  return force;
}

MatrixAssembly::MatrixAssembly(int unknowns, int pressures)
    : unknowns_(unknowns), pressures_(pressures), grains_(unknowns), shear_(unknowns) {
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
  shear_.entries.emplace_back(unknown, unknown, stiffness);
}

/// Adds the lower triangle of an element's matrix, and its rows of the macroscopic strains.
void MatrixAssembly::add_symmetric(Part& part, const ElementUnknowns& unknowns, const Eigen::MatrixXd& matrix) {
  const auto& numbers = unknowns.numbers;
  const Eigen::Matrix<double, Eigen::Dynamic, 3> of_strains = matrix * unknowns.macroscopic;
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

void MatrixAssembly::set_position(int unknown, int component, const Eigen::Vector2d& position) {
  if (unknown != held) result_.by_gradient.row(unknown).segment<2>(2 * component) = position.transpose();
}

MatrixAssembly::Part::Part(int unknowns)
    : sum(unknowns + FilmMatrices::macroscopic, unknowns + FilmMatrices::macroscopic) {
  of_strains.setZero(unknowns, FilmMatrices::macroscopic);
}

void MatrixAssembly::Part::add_up() {
  FilmMatrices::Sparse further(sum.rows(), sum.cols());
  further.setFromTriplets(entries.begin(), entries.end());
  entries.clear();
  if (sum.nonZeros() == 0) {
    sum.swap(further);
  } else {
    sum = FilmMatrices::Sparse(sum + further);
  }
}

FilmMatrices::Sparse MatrixAssembly::Part::finish() {
  const auto unknowns = static_cast<int>(of_strains.rows());
  for (int j = 0; j < FilmMatrices::macroscopic; ++j) {
    for (int unknown = 0; unknown < unknowns; ++unknown) {
      if (of_strains(unknown, j) != 0.0) entries.emplace_back(unknowns + j, unknown, of_strains(unknown, j));
    }
    for (int i = j; i < FilmMatrices::macroscopic; ++i) entries.emplace_back(unknowns + i, unknowns + j, of_both(i, j));
  }
  add_up();
  entries = {};
  FilmMatrices::Sparse whole;
  whole.swap(sum);
  return whole;
}

FilmMatrices MatrixAssembly::finish() {
  const auto make = [](FilmMatrices::Sparse& matrix, int rows, int columns, Entries& entries) {
    matrix.resize(rows, columns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    entries = {};
  };
  result_.grains = grains_.finish();
  result_.shear = shear_.finish();
  make(result_.dilatation, pressures_, unknowns_ + FilmMatrices::macroscopic, dilatation_);
  make(result_.volume, pressures_, pressures_, volume_);
  return std::move(result_);
}

}  // namespace breccia::films
