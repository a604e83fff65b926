#include "homogenisation/box/explicit_packing.hpp"

#include <utility>

#include "homogenisation/box/simplest_box.hpp"
#include "study/listed_box.hpp"

namespace breccia {
namespace {

struct InSimplestBox {
  template <int dim>
  Box<dim> operator()(Microstructure<dim>& balls) const {
    return std::move(balls);
  }
  template <class Shaped>
  auto operator()(Shaped& shaped) const {
    return simplest_box(std::move(shaped));
  }
};

}  // namespace

template <int dim>
PlacedBox<dim> placed(const Stage& stage, const ExplicitPacking<dim>& listed, PackingRunner&) {
  auto box = listed_box(stage, listed);
  require_room<dim>(stage, box);
  return {std::visit(InSimplestBox(), box)};
}

template PlacedBox<2> placed(const Stage&, const ExplicitPacking<2>&, PackingRunner&);
template PlacedBox<3> placed(const Stage&, const ExplicitPacking<3>&, PackingRunner&);

}  // namespace breccia
