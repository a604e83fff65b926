#include "homogenisation/box/fillers_of_particles.hpp"

#include "breccia/nested_variant.hpp"

namespace breccia {
namespace {

struct FillersIn {
  template <int dim>
  std::vector<std::size_t> operator()(const SharedImage<dim>&) const {
    return {};
  }
  template <int dim>
  std::vector<std::size_t> operator()(const Grains<dim>& grains) const {
    return std::vector<std::size_t>(grains.sites.sites.size(), 0);
  }
  template <class Particles>
  std::vector<std::size_t> operator()(const Particles& box) const {
    std::vector<std::size_t> fillers;
    for (std::size_t particle = 0; particle < box.particles.size(); ++particle) {
      fillers.push_back(box.filler_of(particle));
    }
    return fillers;
  }
};

}  // namespace

std::vector<std::size_t> fillers_of_particles(const StageMicrostructure& microstructure) {
  return visit_nested(FillersIn{}, microstructure.box);
}

}  // namespace breccia
