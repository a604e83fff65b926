#pragma once

#include <vector>

#include "breccia/microstructure/cell_faces.hpp"

namespace breccia {

/// What is left of a film whose binder has come off a grain (theory, section 17). All of it is linear: a gap may close
/// without resistance.
enum class Debonding {
  open,    ///< the film carries nothing, and the binder around it can flow into the gap: it has no pressure
  sealed,  ///< the film carries nothing; the binder around it keeps its pressure
  slip,    ///< the binder stays in touch with both grains and slides along one of them without friction
  spring   ///< springs hold the binder to one of the grains
};

/// Stiffness of the springs of an interface: tractions per jump of the displacement across it [Pa/m].
struct InterfaceStiffness {
  double normal = 0.0, tangential = 0.0;
};

/// The films that are debonded. A face without a film counts for nothing.
template <int dim>
struct DebondedFilms {
  Debonding kind = Debonding::open;
  std::vector<CellFace<dim>> faces = {};
  InterfaceStiffness springs = {};  ///< of films on springs
};

}  // namespace breccia
