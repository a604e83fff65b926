#include "homogenisation/box/filler_on_sides.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/nested_variant.hpp"

#include "homogenisation/box/stage_labelling.hpp"

namespace breccia {
namespace {

/// The phases of the fillers, without their coatings.
std::vector<PhaseIndex> phases_without_coatings(const Stage& stage) {
  std::vector<PhaseIndex> phases;
  for (const auto& of_filler : phases_of_fillers(stage)) phases.push_back(of_filler.phase);
  return phases;
}

/// The shares of the sides that lie in filler, at the middles of equal parts of them.
template <int dim>
double sampled_share(const Stage& stage, const Labelling<dim>& labelling) {
  constexpr int parts = dim == 2 ? 2000 : 200;  // along each edge
  constexpr int places = dim == 2 ? parts : parts * parts;
  constexpr double inside = 1e-9;  // of the side, so that a place belongs to the pixel or the grain next to the side
  const auto fillers = phases_without_coatings(stage);
  // The opposite sides of a periodic box are the same cut, but for an image, whose sides need not fit together.
  const bool are_alike = stage.is_periodic() && !stage.has_image();
  const auto ends = are_alike ? std::vector{inside} : std::vector{inside, 1.0 - inside};
  std::size_t in_filler = 0;
  for (std::size_t normal = 0; normal < dim; ++normal) {
    for (const double end : ends) {
      for (int place = 0; place < places; ++place) {
        const int column = place % parts;
        [[maybe_unused]] const int row = place / parts;
        Vector<dim> position{};
        position[normal] = end * stage.side;
        position[(normal + 1) % dim] = (column + 0.5) / parts * stage.side;
        if constexpr (dim == 3) position[(normal + 2) % dim] = (row + 0.5) / parts * stage.side;
        if (std::ranges::count(fillers, labelling(position).phase) > 0) ++in_filler;
      }
    }
  }
  return static_cast<double>(in_filler) / (static_cast<double>(dim * ends.size()) * places);
}

/// The share for each kind of content.
struct ShareOnSides {
  const Stage& stage;

  /// Exact: the chords, or circles, in which the sides cut the balls of a periodic box. What of a circle lies beyond an
  /// edge of its side continues at the opposite edge.
  template <int dim>
  double operator()(const Microstructure<dim>& balls) const {
    double cut = 0.0;
    for (const auto& [centre, diameter] : balls.particles) {
      for (const double x : centre) {
        const double distance = std::min(x, stage.side - x);
        const double squared = 0.25 * diameter * diameter - distance * distance;
        if (squared > 0.0) cut += dim == 2 ? 2.0 * std::sqrt(squared) : std::numbers::pi * squared;
      }
    }
    return cut / (dim * std::pow(stage.side, dim - 1));
  }
  double operator()(const ParticleBox& box) const { return sampled_share<2>(stage, labelling_of(stage, box)); }
  double operator()(const EllipsoidBox& box) const { return sampled_share<3>(stage, labelling_of(stage, box)); }
  template <int dim>
  double operator()(const Grains<dim>& grains) const {
    return sampled_share<dim>(stage, labelling_of(stage, grains));
  }
  template <int dim>
  double operator()(const SharedImage<dim>& image) const {
    return sampled_share<dim>(stage, labelling_of(stage, image));
  }
};

}  // namespace

std::optional<double> filler_on_sides(const Stage& stage, const StageMicrostructure& packed) {
  const bool is_window = stage.is_periodic() || stage.has_image() || stage.has_cut_grains();
  if (stage.fillers.empty() || !is_window) return std::nullopt;
  return visit_nested(ShareOnSides{stage}, packed.box);
}

}  // namespace breccia
