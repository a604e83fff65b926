#include "homogenisation/box/regular_packing.hpp"

#include <variant>

#include "breccia/microstructure/cubic_array.hpp"

#include "microstructure/regular_array.hpp"

namespace breccia {
namespace {

double diameter_in(const Stage& stage) {
  return std::get<SingleSize>(stage.fillers.front().sizes.value()).diameter;
}

}  // namespace

PlacedBox<2> placed(const Stage& stage, const RegularPacking& array, PackingRunner&) {
  return {regular_array<2>(stage.side, {array.columns, array.rows}, diameter_in(stage))};
}

PlacedBox<3> placed(const Stage& stage, const LatticePacking& cubic, PackingRunner&) {
  return {cubic_array(cubic.lattice, stage.side, cubic.repeats, diameter_in(stage))};
}

}  // namespace breccia
