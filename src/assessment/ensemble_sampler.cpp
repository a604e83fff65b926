#include "assessment/ensemble_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/Cholesky>

#include "breccia/probability/distribution.hpp"

#include "microstructure/uniform.hpp"

namespace breccia {
namespace {

/// A standard normal number, the same on every platform.
double standard_normal(std::mt19937_64& engine) {
  return normal_score(std::max(uniform(engine), 0x1p-54));
}

/// The walkers of an ensemble.
class Walkers {
 public:
  Walkers(const std::function<double(const Eigen::VectorXd&)>& log_density, const Eigen::VectorXd& mean,
          const Eigen::MatrixXd& covariance, const EnsembleOptions& options)
      : log_density_(log_density), engine_(options.seed), positions_(mean.size(), options.walkers) {
    const Eigen::MatrixXd root = covariance.llt().matrixL();
    for (auto position : positions_.colwise()) {
      Eigen::VectorXd normal(mean.size());
      for (auto& one : normal) one = standard_normal(engine_);
      position = mean + root * normal;
      logarithms_.push_back(log_density_(position));
    }
  }

  [[nodiscard]] const Eigen::MatrixXd& positions() const noexcept { return positions_; }

  /// Moves each walker once; returns how many of them have moved.
  int move() {
    const auto half = positions_.cols() / 2;
    return move_half(0, half, half) + move_half(half, 2 * half, half);
  }

 private:
  /// Moves the walkers from `first` to `last`, each along the line to a walker of the other half.
  int move_half(Eigen::Index first, Eigen::Index last, Eigen::Index half) {
    constexpr double stretch = 2.0;
    int moved = 0;
    for (auto k = first; k < last; ++k) {
      const auto partner =
          (first == 0 ? half : 0) + static_cast<Eigen::Index>(uniform(engine_) * static_cast<double>(half));
      // The density of z is proportional to 1 / sqrt(z) from 1 / a to a.
      const double root = 1.0 / std::sqrt(stretch) + uniform(engine_) * (std::sqrt(stretch) - 1.0 / std::sqrt(stretch));
      const double z = root * root;
      const Eigen::VectorXd proposed = positions_.col(partner) + z * (positions_.col(k) - positions_.col(partner));
      const double logarithm = log_density_(proposed);
      auto& present = logarithms_[static_cast<std::size_t>(k)];
      const auto power = static_cast<double>(positions_.rows() - 1);
      const double limit = std::log(std::max(uniform(engine_), 0x1p-54));
      if (!(power * std::log(z) + logarithm - present >= limit)) continue;
      positions_.col(k) = proposed;
      present = logarithm;
      ++moved;
    }
    return moved;
  }

  const std::function<double(const Eigen::VectorXd&)>& log_density_;
  std::mt19937_64 engine_;
  Eigen::MatrixXd positions_;  ///< unknowns x walkers
  std::vector<double> logarithms_;
};

/// The autocorrelation time of a series of means of the ensemble, in steps: 1 + 2 sum of the autocorrelation over the
/// shortest window that is five times as long as the time.
double autocorrelation_time(const Eigen::VectorXd& series) {
  constexpr double windows = 5.0;
  const Eigen::VectorXd centred = series.array() - series.mean();
  const auto count = centred.size();
  const double variance = centred.squaredNorm();
  if (variance == 0.0) return static_cast<double>(count);
  double time = 1.0;
  for (Eigen::Index lag = 1; lag < count; ++lag) {
    time += 2.0 * centred.head(count - lag).dot(centred.tail(count - lag)) / variance;
    if (static_cast<double>(lag) >= windows * time) break;
  }
  return std::max(time, 1.0);
}

}  // namespace

Ensemble sample_density(const std::function<double(const Eigen::VectorXd& x)>& log_density, const Eigen::VectorXd& mean,
                        const Eigen::MatrixXd& covariance, const EnsembleOptions& options) {
  Walkers walkers(log_density, mean, covariance, options);
  for (int i = 0; i < options.burn_in; ++i) walkers.move();
  Ensemble ensemble;
  ensemble.samples.resize(mean.size(), static_cast<Eigen::Index>(options.walkers) * options.steps);
  Eigen::MatrixXd means(mean.size(), options.steps);
  int moved = 0;
  for (int i = 0; i < options.steps; ++i) {
    moved += walkers.move();
    ensemble.samples.middleCols(static_cast<Eigen::Index>(i) * options.walkers, options.walkers) = walkers.positions();
    means.col(i) = walkers.positions().rowwise().mean();
  }
  ensemble.accepted = static_cast<double>(moved) / (static_cast<double>(options.walkers) * options.steps);
  double time = 1.0;
  for (const auto& row : means.rowwise()) time = std::max(time, autocorrelation_time(row));
  constexpr double steps_of_a_time = 50.0;
  ensemble.independent_samples = options.steps < steps_of_a_time * time
                                     ? std::numeric_limits<double>::quiet_NaN()
                                     : static_cast<double>(ensemble.samples.cols()) / time;
  return ensemble;
}

}  // namespace breccia
