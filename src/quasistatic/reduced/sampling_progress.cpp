#include "quasistatic/reduced/sampling_progress.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace breccia::quasistatic {
namespace {

std::string words_on(double error) {
  return error < 1.0 ? fmt::format(", error {:.0e}", error) : "";
}

}  // namespace

/// The number of snapshots in the end.
double SamplingProgress::expected(int snapshots) const {
  constexpr double usual = 8.0;
  const double orders = std::log(options_.tolerance) / std::log(error_);
  const double expected = error_ < 1.0 && error_ > 0.0 ? snapshots * orders : usual;
  const double least = snapshots + 1.0;
  return std::clamp(expected, least, std::max(least, static_cast<double>(options_.most_snapshots)));
}

void SamplingProgress::raise_share(double solved, int snapshots) {
  share_ = std::max(share_, solved / expected(snapshots));
}

Progress SamplingProgress::after(int snapshots, double error) {
  error_ = error;
  iterations_ = 0;
  raise_share(snapshots, snapshots);
  return {.share = share_, .details = fmt::format("snapshot {}{}", snapshots, words_on(error_))};
}

Progress SamplingProgress::within_solution(int snapshots, std::size_t loads_done) {
  if (std::exchange(load_, loads_done) != loads_done) iterations_ = 0;
  ++iterations_;
  raise_share(snapshots + static_cast<double>(loads_done) / static_cast<double>(loads_), snapshots);
  const auto load = loads_ > 1 ? fmt::format(", load {} of {}", loads_done + 1, loads_) : "";
  return {.share = share_,
          .details = fmt::format("snapshot {}{}, iteration {}{}", snapshots + 1, load, iterations_, words_on(error_))};
}

}  // namespace breccia::quasistatic
