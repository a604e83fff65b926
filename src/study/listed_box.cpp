#include "study/listed_box.hpp"

#include <vector>

#include "breccia/microstructure/validity.hpp"

#include "microstructure/shapes/particle_validity.hpp"
#include "study/coatings.hpp"
#include "study/filler_shapes.hpp"

namespace breccia {
namespace {

template <int dim>
struct InBox {
  const Stage& stage;
  const ExplicitPacking<dim>& listed;

  ListedBox<dim> operator()(const std::vector<Ball<dim>>& balls) const {
    return Microstructure<dim>{stage.side, listed.walls, balls, listed.fillers};
  }
  ListedBox<dim> operator()(const std::vector<ShapedParticle<dim>>& particles) const {
    return ShapedParticles<dim>{stage.side, listed.walls, particles, listed.fillers,
                                coatings_of(stage, listed.fillers, particles.size())};
  }
};

struct RequireRoom {
  const Stage& stage;

  template <int dim>
  void operator()(const Microstructure<dim>& balls) const {
    require_valid(with_coatings(stage, balls));
  }
  void operator()(const ParticleBox& particles) const { require_valid(particles); }
  void operator()(const EllipsoidBox& ellipsoids) const { require_valid(ellipsoids); }
};

}  // namespace

template <int dim>
ListedBox<dim> listed_box(const Stage& stage, const ExplicitPacking<dim>& listed) {
  return std::visit(InBox<dim>{stage, listed}, listed.particles);
}

template <int dim>
void require_room(const Stage& stage, const ListedBox<dim>& box) {
  std::visit(RequireRoom{stage}, box);
}

template ListedBox<2> listed_box(const Stage&, const ExplicitPacking<2>&);
template ListedBox<3> listed_box(const Stage&, const ExplicitPacking<3>&);
template void require_room<2>(const Stage&, const ListedBox<2>&);
template void require_room<3>(const Stage&, const ListedBox<3>&);

}  // namespace breccia
