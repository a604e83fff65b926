#include "microstructure/tessellation/site_weights.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <fmt/format.h>

#include "breccia/error.hpp"

#include "microstructure/tessellation/cell_builder.hpp"
#include "microstructure/tessellation/site_mistakes.hpp"
#include "microstructure/vector_algebra.hpp"

namespace breccia {

namespace {

constexpr int most_newton_steps = 200;
constexpr double shortest_step = 1e-9;  // shortest share of a Newton step

/// The cells with the present weights: their volumes, and the derivatives of these with respect to the weights.
template <int dim>
class Cells {
 public:
  /// Throws InputError if a site is outside the box or has no finite weight.
  explicit Cells(LaguerreSites<dim> sites)
      : sites_(std::move(sites)),
        volumes_(static_cast<Eigen::Index>(sites_.sites.size())),
        neighbours_(sites_.sites.size()) {
    require_none(mistakes_of_numbers(sites_));
    update();
  }

  [[nodiscard]] Eigen::VectorXd weights() const {
    Eigen::VectorXd result(volumes_.size());
    std::ranges::transform(sites_.sites, result.begin(), &Site<dim>::weight);
    return result;
  }
  void set_weights(const Eigen::VectorXd& weights) {
    for (Eigen::Index site = 0; site < weights.size(); ++site) {
      sites_.sites[static_cast<std::size_t>(site)].weight = weights[site];
    }
    update();
  }

  /// Volumes of the cells [m^dim].
  [[nodiscard]] const Eigen::VectorXd& volumes() const noexcept { return volumes_; }

  [[nodiscard]] bool all_have_volume() const { return volumes_.minCoeff() > 0.0; }
  /// Throws InputError that lists the cells without a volume if there are any.
  void require_volumes() const {
    if (!all_have_volume()) require_none(mistakes(sites_));
  }

  /// Derivatives of the volumes with respect to the weights [m^(dim - 2)], -dV_i/dw_j = (face between i and j) / (2
  /// |c_j - c_i|), with rows that sum to zero; but the weight of the first site, which is fixed, acts on no other cell.
  [[nodiscard]] Eigen::SparseMatrix<double> derivatives() const {
    std::vector<Eigen::Triplet<double, int>> entries;
    for (const auto& [site, other, rate] : rates_) {
      entries.emplace_back(site, site, rate);
      if (site != 0 && other != 0) entries.emplace_back(site, other, -rate);
    }
    Eigen::SparseMatrix<double> matrix(volumes_.size(), volumes_.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

 private:
  struct Rate {  // rate at which the volume of a cell grows with its weight, and that of its neighbour shrinks
    int site;
    int other;
    double rate;  // [m^(dim - 2)]
  };

  void update() {
    const CellBuilder<dim> builder(sites_);
    const PeriodicImages<dim> images(sites_.side);
    rates_.clear();
    for (std::uint32_t site = 0; site < neighbours_.size(); ++site) {
      const auto cell = builder.cell(site, neighbours_[site]);
      volumes_[site] = volume(cell);
      const auto faces = face_measures(cell);
      auto& neighbours = neighbours_[site];
      neighbours.clear();
      for (std::size_t face = 0; face < faces.size(); ++face) {
        const std::uint32_t behind = cell.half_spaces()[face].behind;
        if (behind == Behind<dim>::wall) continue;
        const std::uint32_t other = Behind<dim>::site(behind);
        if (other == site) continue;
        neighbours.push_back(behind);
        const auto seen = sites_.sites[other].position + images.shift(Behind<dim>::image(behind));
        const double distance = norm(seen - sites_.sites[site].position);
        rates_.push_back({static_cast<int>(site), static_cast<int>(other), 0.5 * faces[face] / distance});
      }
    }
  }

  LaguerreSites<dim> sites_;
  Eigen::VectorXd volumes_;
  std::vector<std::vector<std::uint32_t>> neighbours_;  // numbers of Behind, which change little from step to step
  std::vector<Rate> rates_;
};

/// The wanted volumes, scaled such that they fill the box.
template <int dim>
Eigen::VectorXd filling_volumes(const LaguerreSites<dim>& sites, std::span<const double> volumes) {
  if (volumes.size() != sites.sites.size()) {
    throw InputError(
        fmt::format("tessellation: {} sites need as many volumes, got {}", sites.sites.size(), volumes.size()));
  }
  for (std::size_t site = 0; site < volumes.size(); ++site) {
    if (volumes[site] > 0.0 && std::isfinite(volumes[site])) continue;
    throw InputError(fmt::format("tessellation: the volume of site {} must be positive and finite, got {}", site + 1,
                                 volumes[site]));
  }
  const Eigen::Map<const Eigen::VectorXd> asked(volumes.data(), static_cast<Eigen::Index>(volumes.size()));
  return asked / asked.sum() * times_power<dim>(1.0, sites.side);
}

/// The wanted volume of each cell less its volume. Both sums are the volume of the box but for rounding, which grows
/// with the number of cells. It is taken off the first cell, whose weight is fixed, so that it is not counted as an
/// error of this cell.
Eigen::VectorXd missing_volumes(const Eigen::VectorXd& volumes, const Eigen::VectorXd& asked) {
  Eigen::VectorXd missing = asked - volumes;
  missing[0] -= missing.sum();
  return missing;
}

double largest_share(const Eigen::VectorXd& missing, const Eigen::VectorXd& asked) {
  return (missing.array() / asked.array()).abs().maxCoeff();
}

/// The Newton step with the weight of the first site fixed. In 3D complete factors would take a hundred times as long.
Eigen::VectorXd newton_step(const Eigen::SparseMatrix<double>& derivatives, Eigen::VectorXd missing) {
  using Matrix = Eigen::SparseMatrix<double>;
  missing[0] = 0.0;
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper, Eigen::IncompleteCholesky<double>> solver;
  solver.setTolerance(1e-6);
  return solver.compute(derivatives).solve(missing);
}

}  // namespace

// Damped Newton method of Kitagawa, Merigot and Thibert (2019), Algorithm 1. A step is halved until no cell is smaller
// than half of the smallest initial and the smallest wanted volume, and the volumes are closer to the wanted ones.
template <int dim>
SiteWeights weights_for_volumes(const LaguerreSites<dim>& sites, std::span<const double> volumes, double tolerance) {
  if (!(tolerance > 0.0)) {
    throw InputError(fmt::format("tessellation: the tolerance of the volumes must be positive, got {}", tolerance));
  }
  const Eigen::VectorXd asked = filling_volumes(sites, volumes);
  Cells<dim> cells(sites);
  if (!cells.all_have_volume()) cells.set_weights(Eigen::VectorXd::Zero(asked.size()));
  cells.require_volumes();
  const double smallest = 0.5 * std::min(asked.minCoeff(), cells.volumes().minCoeff());
  int steps = 0;
  const auto largest_error = [&] { return largest_share(missing_volumes(cells.volumes(), asked), asked); };
  for (; largest_error() > tolerance && steps < most_newton_steps; ++steps) {
    const Eigen::VectorXd before = cells.weights();
    const Eigen::VectorXd missing = missing_volumes(cells.volumes(), asked);
    const Eigen::VectorXd step = newton_step(cells.derivatives(), missing);
    double length = 1.0;
    const auto is_nearer = [&] {
      return cells.volumes().minCoeff() >= smallest &&
             missing_volumes(cells.volumes(), asked).norm() <= (1.0 - 0.5 * length) * missing.norm();
    };
    for (cells.set_weights(before + step); !is_nearer() && length > shortest_step;) {
      length *= 0.5;
      cells.set_weights(before + length * step);
    }
    if (length <= shortest_step) break;
  }
  SiteWeights result{{}, largest_error(), steps};
  if (!(result.largest_error <= tolerance)) {
    throw NumericalError(
        fmt::format("tessellation: after {} steps the volume of a cell is still off by a share of {:.3g}; {:.3g} was "
                    "asked for",
                    steps, result.largest_error, tolerance));
  }
  const Eigen::VectorXd weights = cells.weights();
  result.weights.assign(weights.begin(), weights.end());
  return result;
}

template SiteWeights weights_for_volumes<2>(const LaguerreSites<2>&, std::span<const double>, double);
template SiteWeights weights_for_volumes<3>(const LaguerreSites<3>&, std::span<const double>, double);

}  // namespace breccia
