#include "homogenisation/box/packing_advice.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/display.hpp"
#include "study/filler_sizes.hpp"
#include "study/gap.hpp"

namespace breccia {
namespace {

/// The packing request of the stage with another gap. Between hard walls the box of the packing is smaller by the gap.
PackingRequest with_gap(const Stage& stage, PackingRequest request, double gap) {
  request.side = request.walls == Walls::hard ? stage.side - gap : stage.side;
  request.minimum_gap = gap;
  return request;
}

/// Mean of (diameter + gap) over the side of the box [-]; the mean is that of areas or volumes.
template <int dim>
double relative_size(const PackingRequest& request) {
  const auto count = static_cast<double>(request.diameters.size());
  return std::pow(inflated_fraction<dim>(request) / (ball_volume<dim>(1.0) * count), 1.0 / dim);
}

/// The fraction of particles, each with half the gap around it, that can be packed with near certainty: after a jam
/// slightly less than the jammed fraction; otherwise an empirical fraction for random discs (from jams of 4 to 128
/// discs) or spheres, which is smaller in a small box because of its walls.
template <int dim>
double safe_fraction(const PackingRequest& request, const PackingError& error) {
  if (request.diameters.size() == 1) return 1.0;  // a single particle packs if it fits into the box
  if (error.obstacle() == PackingObstacle::jam) return 0.96 * error.attainable_fraction();
  const double in_large_box = dim == 3 ? 0.62 : 0.82;
  return std::max(0.0, in_large_box - 0.4 * relative_size<dim>(request));
}

bool has_coatings(const Stage& stage) {
  return std::ranges::any_of(stage.fillers, [](const Filler& filler) { return filler.coating.has_value(); });
}

/// The widest gap with which the particles fill at most a fraction of the box and the largest particle fits into it.
template <int dim>
std::optional<double> widest_gap(const Stage& stage, const PackingRequest& request, double fraction) {
  constexpr double roundoff = 1e-6;
  const double largest = std::ranges::max(request.diameters) + 2.0 * stage.fillers.front().coating_thickness();
  const auto fits = [&](double gap) {
    const auto other = with_gap(stage, request, gap);
    return largest + gap <= (1.0 - roundoff) * other.side && inflated_fraction<dim>(other) <= fraction;
  };
  double low = 0.0, high = std::min(request.minimum_gap, stage.side);
  if (!fits(low)) return std::nullopt;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (fits(middle) ? low : high) = middle;
  }
  return low > 0.0 ? std::optional(rounded_down_to_two_digits(low)) : std::nullopt;
}

/// The packing request with all gaps, and the parts of shells that gaps have, multiplied by a share; the shells must be
/// those of gaps alone.
PackingRequest with_share_of_gaps(const Stage& stage, PackingRequest request, double share) {
  for (double& shell : request.shells) shell *= share;
  const double gap = share * request.minimum_gap;
  return with_gap(stage, std::move(request), gap);
}

/// The share of all gaps, 1 at most, with which the particles fill at most a fraction of the box; nothing where they
/// would fill more without gaps, or have coatings.
template <int dim>
std::optional<double> share_of_gaps(const Stage& stage, const PackingRequest& request, double fraction) {
  const auto fits = [&](double share) {
    return inflated_fraction<dim>(with_share_of_gaps(stage, request, share)) <= fraction;
  };
  if (has_coatings(stage) || !fits(0.0)) return std::nullopt;
  double low = 0.0, high = 1.0;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (fits(middle) ? low : high) = middle;
  }
  const double share = rounded_down_to_two_digits(low);
  return share > 0.0 ? std::optional(share) : std::nullopt;
}

/// The number of cells per side for which the gap, given in material points, is not wider than another gap.
std::optional<int> cells_for(const Stage& stage, double gap) {
  constexpr double most = 1 << 20;
  const double cells = std::ceil(stage.cells * stage.fillers.front().gap / gap);
  return cells <= most ? std::optional(static_cast<int>(cells)) : std::nullopt;
}

/// The fraction at which the particles with the requested gap fill no more than the safe fraction. The drawn sizes
/// meet a fraction to within half a particle.
template <int dim>
std::optional<double> largest_fraction(const Stage& stage, const PackingRequest& request, double safe) {
  const double largest = std::ranges::max(request.diameters) / stage.side;
  const double half_a_particle = 0.5 * ball_volume<dim>(1.0) * std::pow(largest, dim);
  const double fraction = *stage.fillers.front().fraction * safe / inflated_fraction<dim>(request) - half_a_particle;
  return fraction > 0.0 ? std::optional(rounded_down_to_two_digits(fraction)) : std::nullopt;
}

/// The particles in words: "31 particles of 120 um", "102 particles of 2.02 um to 13.4 um"; with the fraction, if the
/// deck has one.
std::string particles_of(const Stage& stage, const PackingRequest& request) {
  const auto [smallest, largest] = std::ranges::minmax(request.diameters);
  const auto sizes = smallest == largest ? display(largest, "m")
                                         : fmt::format("{} to {}", display(smallest, "m"), display(largest, "m"));
  const auto count = request.diameters.size();
  const auto asked = fraction_asked_of(stage);
  const auto fraction = asked ? fmt::format(" at a fraction of {:.6g}", *asked) : "";
  return fmt::format("{} {} of {}{}", count, count == 1 ? "particle" : "particles", sizes, fraction);
}

std::string in_words(const PackingAdvice& advice) {
  const auto cells = advice.cells ? fmt::format(" (cells = {} or more)", *advice.cells) : "";
  auto gap = advice.gap ? fmt::format("a gap of {} or less{} should pack", display(*advice.gap, "m", 2), cells) : "";
  const auto fraction = advice.fraction ? fmt::format("a fraction of {:.3g} or less", *advice.fraction) : "";
  if (advice.gap && advice.fraction) return fmt::format("{}, and so should {} with this gap", gap, fraction);
  if (advice.gap) return gap;
  if (advice.fraction) return fmt::format("{} with this gap should pack", fraction);
  if (!advice.gaps.empty()) {
    std::vector<std::string> gaps;
    gaps.reserve(advice.gaps.size());
    for (const double of_filler : advice.gaps) gaps.push_back(display(of_filler, "m", 2));
    const bool are_equal = std::ranges::adjacent_find(gaps, std::not_equal_to<>()) == gaps.end();
    return are_equal
               ? fmt::format("the gaps take the room: a gap of {} or less of each filler should pack", gaps.front())
               : fmt::format("the gaps take the room: gaps of {} or less of the fillers, in their order, should pack",
                             fmt::join(gaps, " and "));
  }
  return "expected fewer or smaller particles";
}

/// The layers that take room around each particle, in words: "with coatings and half of the gap around each ".
std::string shells_in_words(const Stage& stage, bool has_gap) {
  if (!has_coatings(stage)) return has_gap ? "with half of the gap around each " : "";
  return has_gap ? "with coatings and half of the gap around each " : "with their coatings ";
}

/// The filler whose particles are the widest with their coatings.
const Filler& widest_filler(const Stage& stage) {
  const auto width = [](const Filler& filler) {
    const auto diameters = diameters_of(filler);
    return (diameters ? diameters->largest : 0.0) + 2.0 * filler.coating_thickness();
  };
  return *std::ranges::max_element(stage.fillers, {}, width);
}

}  // namespace

template <int dim>
PackingAdvice packing_advice(const Stage& stage, const PackingRequest& request, const PackingError& error) {
  PackingAdvice advice;
  const double safe = safe_fraction<dim>(request, error);
  if (stage.fillers.size() > 1) {
    const bool is_too_wide = error.obstacle() == PackingObstacle::size;
    const auto share = is_too_wide ? std::nullopt : share_of_gaps<dim>(stage, request, safe);
    if (!share) return advice;
    for (const auto& filler : stage.fillers) {
      advice.gaps.emplace_back(rounded_down_to_two_digits(*share * filler.gap));
    }
    return advice;
  }
  const auto& filler = stage.fillers.front();
  advice.gap = widest_gap<dim>(stage, request, safe);
  if (advice.gap && filler.gap_source == GapSource::points) advice.cells = cells_for(stage, *advice.gap);
  const bool has_fraction = filler.fraction && error.obstacle() != PackingObstacle::size;
  if (has_fraction) advice.fraction = largest_fraction<dim>(stage, request, safe);
  return advice;
}

template <int dim>
std::string message_on(const Stage& stage, const PackingRequest& request, const PackingError& error) {
  const auto advice = in_words(packing_advice<dim>(stage, request, error));
  if (error.obstacle() == PackingObstacle::size) {
    const auto& widest = widest_filler(stage);
    const auto coating =
        widest.coating ? fmt::format(" with a coating of {}", display(widest.coating->thickness, "m")) : "";
    const auto diameters = diameters_of(widest);
    return fmt::format("a particle of {}{} that keeps a gap of {} does not fit into a box of {}; {}",
                       display(diameters ? diameters->largest : std::ranges::max(request.diameters), "m"), coating,
                       gaps_in_words(stage), display(stage.side, "m"), advice);
  }
  const bool has_gap = std::ranges::any_of(stage.fillers, [](const Filler& filler) { return filler.gap > 0.0; });
  const auto gap = has_gap ? fmt::format("a gap of {}", gaps_in_words(stage)) : "no gap between them";
  const auto alone = has_gap && stage.fillers.size() > 1
                         ? fmt::format(", {:.1f} % without the gaps",
                                       100.0 * inflated_fraction<dim>(with_share_of_gaps(stage, request, 0.0)))
                         : "";
  const auto how = fmt::format(
      "{}they would fill {:.1f} % of {}{}", shells_in_words(stage, has_gap), 100.0 * inflated_fraction<dim>(request),
      request.walls == Walls::hard ? "the room between the walls" : "the box", has_coatings(stage) ? "" : alone);
  const double attainable = 100.0 * error.attainable_fraction();
  const bool jams = error.obstacle() == PackingObstacle::jam;
  return fmt::format("{} with {} {}: {}, and {} {:.1f} %; {}", particles_of(stage, request), gap,
                     jams ? "jam" : "cannot be packed", how,
                     jams       ? "are stuck at"
                     : dim == 3 ? "such spheres fill at most"
                                : "such discs fill at most",
                     attainable, advice);
}

template PackingAdvice packing_advice<2>(const Stage&, const PackingRequest&, const PackingError&);
template PackingAdvice packing_advice<3>(const Stage&, const PackingRequest&, const PackingError&);
template std::string message_on<2>(const Stage&, const PackingRequest&, const PackingError&);
template std::string message_on<3>(const Stage&, const PackingRequest&, const PackingError&);

}  // namespace breccia
