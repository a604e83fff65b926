#include "discretisation/gaps/phase_shares.hpp"

#include <algorithm>
#include <utility>

namespace breccia::gaps {
namespace {

/// Shares of a cell, phase by phase.
class PhaseShares {
 public:
  void add(PhaseIndex phase, double volume, const VolumeAndShear& share) {
    const auto known = std::ranges::find(cell_.mixture, phase, &MixedPart::phase);
    if (known == cell_.mixture.end()) {
      cell_.mixture.push_back({phase, volume});
      cell_.shares.push_back(share);
    } else {
      known->fraction += volume;
      cell_.shares[static_cast<std::size_t>(known - cell_.mixture.begin())] += share;
    }
  }
  /// The shares. The first phase is that whose shares are largest, for both volume and deviators: its strain is that of
  /// the cell less those of the others, over its share.
  [[nodiscard]] CellShares take() {
    VolumeAndShear largest = VolumeAndShear::Zero();
    for (const auto& share : cell_.shares) largest = largest.max(share);
    const auto size = [&](const VolumeAndShear& share) { return (share / largest).minCoeff(); };
    const auto first = std::ranges::max_element(cell_.shares, {}, size) - cell_.shares.begin();
    std::swap(cell_.mixture.front(), cell_.mixture[static_cast<std::size_t>(first)]);
    std::swap(cell_.shares.front(), cell_.shares[static_cast<std::size_t>(first)]);
    return std::move(cell_);
  }

 private:
  CellShares cell_;
};

}  // namespace

CellShares in_series(PhaseIndex matrix, std::span<const ParticleShare> particles, const VolumeAndShear& binder) {
  constexpr double least = 1e-6, rounding = 1e-9;
  double all = 0.0;
  for (const auto& one : particles) all += one.share;
  PhaseShares cell;
  const double of_binder = std::max(1.0 - all, 0.0);
  if (binder.maxCoeff() > rounding) cell.add(matrix, of_binder, binder.max(least));
  const VolumeAndShear rest = (1.0 - binder).max(least);
  for (const auto& [phases, share, core] : particles) {
    const double part = share / all;
    if (core > 0.0) cell.add(phases.phase, core * part * (1.0 - of_binder), core * part * rest);
    if (core < 1.0) cell.add(phases.coating, (1.0 - core) * part * (1.0 - of_binder), (1.0 - core) * part * rest);
  }
  return cell.take();
}

}  // namespace breccia::gaps
