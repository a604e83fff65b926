#include "breccia/microstructure/size_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

namespace {

void require_positive(double value, const char* what, const char* unit) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw InputError(fmt::format("size distribution: {} must be positive and finite, got {}{}", what, value, unit));
}

double lognormal_mixture_at(const std::vector<LognormalComponent>& components, double diameter) {
  if (diameter <= 0.0) return 0.0;
  double share = 0.0;
  for (const auto& [weight, median, sigma] : components) {
    share += weight * 0.5 * std::erfc(-std::log(diameter / median) / (sigma * std::numbers::sqrt2));
  }
  return share;
}

double table_at(const std::vector<double>& diameters, const std::vector<double>& cumulative, double diameter) {
  if (diameter < diameters.front()) return 0.0;
  if (diameter >= diameters.back()) return 1.0;
  const auto above = static_cast<std::size_t>(std::ranges::upper_bound(diameters, diameter) - diameters.begin());
  const std::size_t below = above - 1;
  return std::lerp(cumulative[below], cumulative[above],
                   std::log(diameter / diameters[below]) / std::log(diameters[above] / diameters[below]));
}

}  // namespace

SizeDistribution::SizeDistribution(Law law, double smallest, double largest)
    : law_(std::move(law)), smallest_(smallest), largest_(largest) {}

SizeDistribution SizeDistribution::monodisperse(double diameter) {
  require_positive(diameter, "the diameter", " m");
  return {Single{diameter}, diameter, diameter};
}

SizeDistribution SizeDistribution::lognormal_mixture(std::vector<LognormalComponent> components) {
  if (components.empty()) throw InputError("size distribution: a lognormal mixture needs at least one component");
  double total = 0.0;
  for (const auto& [weight, median, sigma] : components) {
    if (!(weight >= 0.0) || !std::isfinite(weight)) {
      throw InputError(fmt::format("size distribution: a weight must be finite and not negative, got {}", weight));
    }
    require_positive(median, "a median", " m");
    require_positive(sigma, "a sigma", "");
    total += weight;
  }
  require_positive(total, "the sum of the weights", "");
  for (auto& component : components) component.weight /= total;
  return {std::move(components), 0.0, std::numeric_limits<double>::infinity()};
}

SizeDistribution SizeDistribution::tabulated(std::vector<double> diameters, std::vector<double> cumulative) {
  if (diameters.size() != cumulative.size() || diameters.size() < 2) {
    throw InputError(
        fmt::format("size distribution: a table needs as many diameters as cumulative shares, and at least two, "
                    "got {} and {}",
                    diameters.size(), cumulative.size()));
  }
  for (std::size_t k = 0; k < diameters.size(); ++k) {
    require_positive(diameters[k], "a diameter", " m");
    if (k > 0 && !(diameters[k] > diameters[k - 1])) {
      throw InputError(fmt::format("size distribution: diameters must rise strictly, got {} m after {} m", diameters[k],
                                   diameters[k - 1]));
    }
    if (k > 0 && !(cumulative[k] >= cumulative[k - 1])) {
      throw InputError(fmt::format("size distribution: cumulative shares must not fall, got {} at {} m after {}",
                                   cumulative[k], diameters[k], cumulative[k - 1]));
    }
  }
  if (cumulative.front() != 0.0 || cumulative.back() != 1.0) {
    throw InputError(
        fmt::format("size distribution: cumulative shares must begin at 0 and end at 1, got {} at {} m and {} at {} m",
                    cumulative.front(), diameters.front(), cumulative.back(), diameters.back()));
  }
  const double smallest = diameters.front();
  const double largest = diameters.back();
  return {Table{std::move(diameters), std::move(cumulative)}, smallest, largest};
}

SizeDistribution SizeDistribution::fuller(const FullerSizes& law) {
  require_positive(law.largest, "the largest diameter of Fuller's curve", " m");
  require_positive(law.exponent, "the exponent of Fuller's curve", "");
  return {law, 0.0, law.largest};
}

SizeDistribution SizeDistribution::rosin_rammler(const RosinRammlerSizes& law) {
  require_positive(law.size, "the size of Rosin and Rammler", " m");
  require_positive(law.exponent, "the exponent of Rosin and Rammler", "");
  return {law, 0.0, std::numeric_limits<double>::infinity()};
}

SizeDistribution SizeDistribution::quantiles(const QuantileSizes& law) {
  for (const double diameter : {law.d10, law.d50, law.d90}) require_positive(diameter, "a quantile", " m");
  if (!(law.d10 < law.d50 && law.d50 < law.d90)) {
    throw InputError(fmt::format("size distribution: d10, d50 and d90 must rise strictly, got {} m, {} m and {} m",
                                 law.d10, law.d50, law.d90));
  }
  return {law, 0.0, std::numeric_limits<double>::infinity()};
}

SizeDistribution SizeDistribution::truncated(double from, double to) const {
  if (!(from >= 0.0) || !(to >= from) || to == 0.0) {
    throw InputError(
        fmt::format("size distribution: cannot be truncated to diameters from {} m to {} m: the bounds must not be "
                    "negative, and the second must not be below the first",
                    from, to));
  }
  SizeDistribution result = *this;
  result.smallest_ = std::max(smallest_, from);
  result.largest_ = std::min(largest_, to);
  if (result.largest_ >= result.smallest_) {
    // Particles of exactly the diameter `smallest_` belong to the truncated distribution.
    result.below_ = untruncated(std::nextafter(result.smallest_, 0.0));
    result.within_ = untruncated(result.largest_) - result.below_;
  }
  // a difference F(to) - F(from) below 1e-9 has lost half of its digits
  if (result.largest_ < result.smallest_ || !(result.within_ > 1e-9)) {
    throw InputError(
        fmt::format("size distribution: nothing of it (less than 1e-9) has diameters from {} m to {} m", from, to));
  }
  return result;
}

double SizeDistribution::untruncated(double diameter) const {
  return std::visit(
      [diameter](const auto& law) {
        using Kind = std::decay_t<decltype(law)>;
        if constexpr (std::is_same_v<Kind, Single>) {
          return diameter < law.diameter ? 0.0 : 1.0;
        } else if constexpr (std::is_same_v<Kind, Mixture>) {
          return lognormal_mixture_at(law, diameter);
        } else if constexpr (std::is_same_v<Kind, Table>) {
          return table_at(law.diameters, law.cumulative, diameter);
        } else {
          return share_up_to(diameter, law);
        }
      },
      law_);
}

double SizeDistribution::cumulative(double diameter) const {
  if (diameter < smallest_) return 0.0;
  if (diameter >= largest_) return 1.0;
  return std::clamp((untruncated(diameter) - below_) / within_, 0.0, 1.0);
}

double SizeDistribution::quantile(double p) const {
  if (!(p >= 0.0 && p <= 1.0)) {
    throw InputError(fmt::format("size distribution: a quantile needs a share from 0 to 1, got {}", p));
  }
  if (p == 0.0) return smallest_;
  // F(low) < p <= F(high), halved in log d down to neighbouring numbers
  double low = std::max(smallest_, std::numeric_limits<double>::min());
  double high = std::min(largest_, std::numeric_limits<double>::max());
  if (cumulative(low) >= p) return low;
  if (p == 1.0) return largest_;
  for (double middle = std::sqrt(low) * std::sqrt(high); low < middle && middle < high;
       middle = high < 2.0 * low ? 0.5 * (low + high) : std::sqrt(low) * std::sqrt(high)) {
    (cumulative(middle) >= p ? high : low) = middle;
  }
  return high;
}

}  // namespace breccia
