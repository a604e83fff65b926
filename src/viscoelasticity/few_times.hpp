#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "breccia/viscoelasticity/few_terms.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/reduction.hpp"

#include "common_times_fit.hpp"

namespace breccia {

/// Times of a window at which deviations are looked at: forty a decade, both ends included [s].
std::vector<double> checked_times(const TimeWindow& window);

/// Searches common relaxation times of several moduli in a window of time, a given number of them, with which the
/// largest relative deviation is least (theory, section 15).
class FewTimes {
 public:
  /// The moduli are above zero in the window.
  FewTimes(std::vector<PronySeries> moduli, const TimeWindow& window);

  /// More relaxation times than this are of no use: a fit with all that are offered, densely, takes so many.
  [[nodiscard]] std::size_t most() const { return merged_.size() - 1; }
  /// Series with all the relaxation times that are offered, densely: by least squares, or, if these deviate by more
  /// than a tolerance, with the least largest deviation found. Hardly any others are nearer.
  [[nodiscard]] FewTerms nearest(double tolerance) const;
  /// The best series found with so many relaxation times, or fewer where some get no strength. The same for every
  /// tolerance.
  [[nodiscard]] FewTerms with(std::size_t count) const;

 private:
  [[nodiscard]] std::vector<Eigen::VectorXd> starts(Eigen::Index count) const;
  [[nodiscard]] FewTerms measured(const CommonTimesFit& fit, const Eigen::VectorXd& relaxation_times) const;
  using Mover = std::function<void(const CommonTimesFit& fit, Eigen::VectorXd& relaxation_times, int round)>;
  [[nodiscard]] FewTerms evened(Eigen::VectorXd relaxation_times, const Mover& move) const;
  [[nodiscard]] FewTerms moved(const Eigen::VectorXd& start) const;

  std::vector<PronySeries> moduli_;
  TimeWindow window_;
  std::vector<double> checked_;                      ///< times of the check [s]
  std::vector<std::vector<double>> checked_moduli_;  ///< the moduli there [Pa]
  CommonTimesFit fit_;
  Eigen::VectorXd offered_;  ///< relaxation times [s]
  FewTerms dense_;
  std::vector<Eigen::VectorXd> merged_;  ///< lists of relaxation times of a dense fit, by their number
};

}  // namespace breccia
