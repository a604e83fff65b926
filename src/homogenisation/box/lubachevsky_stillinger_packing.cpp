#include "homogenisation/box/lubachevsky_stillinger_packing.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "breccia/error.hpp"

#include "homogenisation/box/drawn_particles.hpp"
#include "homogenisation/box/packing_advice.hpp"

namespace breccia {
namespace {

/// The shells around particles (PackingRequest): their coatings, and half of the difference between the gap of their
/// filler and the smallest gap. Empty where no particle has a shell.
std::vector<double> shells_of(const Stage& stage, const DrawnParticles& drawn, double smallest_gap) {
  std::vector<double> shells;
  for (const auto number : drawn.fillers) {
    const auto& filler = stage.fillers[number];
    shells.push_back(filler.coating_thickness() + 0.5 * (filler.gap - smallest_gap));
  }
  const bool has_any = std::ranges::any_of(shells, [](double shell) { return shell > 0.0; });
  return has_any ? shells : std::vector<double>();
}

template <int dim>
Packing<dim> packing_of(const Stage& stage, const PackingRequest& request, PackingRunner& runner) {
  try {
    return runner.run<dim>(request);
  } catch (const PackingError& error) {
    throw NumericalError(message_on<dim>(stage, request, error));
  }
}

}  // namespace

template <int dim>
PlacedBox<dim> placed(const Stage& stage, const LubachevskyStillingerPacking<dim>& method, PackingRunner& runner) {
  auto drawn = draw_particles<dim>(stage);
  const double gap = std::ranges::min(stage.fillers, {}, &Filler::gap).gap;
  PackingRequest request;
  // Particles keep the whole gap to a wall, too: the boundary there is as rigid as a particle.
  const double inset = method.walls == Walls::hard ? 0.5 * gap : 0.0;
  request.side = stage.side - 2.0 * inset;
  request.walls = method.walls;
  request.minimum_gap = gap;
  request.seed = method.seed;
  request.diameters = drawn.diameters;
  request.shells = shells_of(stage, drawn, gap);
  auto packing = packing_of<dim>(stage, request, runner);
  for (auto& ball : packing.balls) {
    for (auto& coordinate : ball.centre) coordinate += inset;
  }
  if (stage.fillers.size() == 1) drawn.fillers.clear();
  return {.box = Microstructure<dim>{stage.side, method.walls, std::move(packing.balls), std::move(drawn.fillers)},
          .size_deviations = std::move(drawn.size_deviations),
          .events = packing.events};
}

template PlacedBox<2> placed(const Stage&, const LubachevskyStillingerPacking<2>&, PackingRunner&);
template PlacedBox<3> placed(const Stage&, const LubachevskyStillingerPacking<3>&, PackingRunner&);

}  // namespace breccia
