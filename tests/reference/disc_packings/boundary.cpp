#include "boundary.hpp"

#include <stdexcept>

namespace disc_packings {

Boundary boundary_named(const std::string& name) {
  if (name == "periodic") return Boundary::periodic;
  if (name == "displacement") return Boundary::displacement;
  if (name == "traction") return Boundary::traction;
  throw std::runtime_error("no boundary: " + name);
}

Box box_of(Boundary boundary) {
  return boundary == Boundary::periodic ? Box::periodic : Box::walled;
}

}  // namespace disc_packings
