#include "homogenisation/staging.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/display.hpp"

namespace breccia {

std::vector<SizeStage> divide_into_stages(const SizeDistribution& sizes, const std::vector<double>& bounds,
                                          double fraction) {
  if (!(fraction > 0.0 && fraction < 1.0)) {
    throw InputError(fmt::format("stages: expected a fraction between 0 and 1, got {:.6g}", fraction));
  }
  if (bounds.size() < 2 || !std::ranges::is_sorted(bounds, std::ranges::less_equal())) {
    throw InputError("stages: expected two or more rising diameters at which stages begin and end");
  }
  const double all = sizes.cumulative(bounds.back()) - sizes.cumulative(bounds.front());
  double filled = 1.0 - fraction;  // volume of the binder and the stages so far
  std::vector<SizeStage> stages;
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
    const double volume = sizes.cumulative(bounds[i + 1]) - sizes.cumulative(bounds[i]);
    if (!(volume > 0.0)) {
      throw InputError(fmt::format("stages: there are no particles from {} to {}", display(bounds[i], "m"),
                                   display(bounds[i + 1], "m")));
    }
    const double share = volume / all;
    filled += fraction * share;
    stages.push_back({bounds[i], bounds[i + 1], share, fraction * share / filled});
  }
  return stages;
}

}  // namespace breccia
