#include "breccia/discretisation/boundary.hpp"

namespace breccia {

std::string bound_of(Boundary boundary) {
  switch (boundary) {
    case Boundary::displacement:
      return "upper bound";
    case Boundary::traction:
      return "lower bound";
    case Boundary::periodic:
      return "periodic";
  }
  return {};
}

}  // namespace breccia
