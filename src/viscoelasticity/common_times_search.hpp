#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/reduction.hpp"

#include "viscoelasticity/common_times_fit.hpp"
#include "viscoelasticity/prony_reduction.hpp"

namespace breccia {

/// Times of a window at which deviations are measured: forty a decade, both ends included [s].
std::vector<double> checked_times(const TimeWindow& window);

/// Searches a given number of common relaxation times of several moduli in a window of time, such that the largest
/// relative deviation is least (theory, section 15).
class CommonTimesSearch {
 public:
  /// The moduli must be above zero in the window.
  CommonTimesSearch(std::vector<PronySeries> moduli, const TimeWindow& window);

  /// The number of relaxation times with a positive strength in a fit with all candidates; more times are of no use.
  [[nodiscard]] std::size_t most() const { return merged_.size() - 1; }
  /// Series with all candidate relaxation times: by least squares, or, if these deviate by more than a tolerance, with
  /// the least largest deviation found. Series with other relaxation times are hardly ever closer to the moduli.
  [[nodiscard]] PronyReduction nearest(double tolerance) const;
  /// The best series found with at most `count` relaxation times (fewer where some have a strength of zero). They do
  /// not depend on a tolerance.
  [[nodiscard]] PronyReduction with(std::size_t count) const;

 private:
  [[nodiscard]] std::vector<Eigen::VectorXd> starts(Eigen::Index count) const;
  [[nodiscard]] PronyReduction measured(const CommonTimesFit& fit, const Eigen::VectorXd& relaxation_times) const;
  using Mover = std::function<void(const CommonTimesFit& fit, Eigen::VectorXd& relaxation_times, int round)>;
  [[nodiscard]] PronyReduction evened(Eigen::VectorXd relaxation_times, const Mover& move) const;
  [[nodiscard]] PronyReduction moved(const Eigen::VectorXd& start) const;

  std::vector<PronySeries> moduli_;
  TimeWindow window_;
  std::vector<double> checked_;                      ///< times of the check [s]
  std::vector<std::vector<double>> checked_moduli_;  ///< moduli at these times [Pa]
  CommonTimesFit fit_;
  Eigen::VectorXd candidates_;  ///< relaxation times [s]
  PronyReduction dense_;
  std::vector<Eigen::VectorXd> merged_;  ///< lists of relaxation times of a dense fit, by their number
};

}  // namespace breccia
