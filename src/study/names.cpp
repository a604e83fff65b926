#include "breccia/study/run.hpp"

namespace breccia {

const std::string& name_of(const StageMatrix& matrix) {
  return std::visit([](const auto& named) -> const std::string& { return named.name; }, matrix);
}

std::string name_of(Load load) {
  switch (load) {
    case Load::shear:
      return "shear";
    case Load::diagonal_shear:
      return "shear-xx-yy";
    case Load::bulk:
      return "bulk";
  }
  return {};
}

std::string name_of(Boundary boundary) {
  switch (boundary) {
    case Boundary::displacement:
      return "displacement";
    case Boundary::traction:
      return "traction";
    case Boundary::periodic:
      return "periodic";
  }
  return {};
}

std::string name_of(Method method) {
  return method == Method::dynamic ? "dynamic" : "quasistatic";
}

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

std::string name_of(SampledRange range) {
  return range == SampledRange::matrix ? "matrix" : "times";
}

std::string name_of_grid(int cells) {
  return cells == 0 ? "extrapolated" : std::to_string(cells);
}

Bound bound_under(Boundary boundary) {
  switch (boundary) {
    case Boundary::displacement:
      return Bound::upper;
    case Boundary::traction:
      return Bound::lower;
    case Boundary::periodic:
      return Bound::periodic;
  }
  return {};
}

Boundary boundary_of(Bound bound) {
  switch (bound) {
    case Bound::upper:
      return Boundary::displacement;
    case Bound::lower:
      return Boundary::traction;
    case Bound::periodic:
      return Boundary::periodic;
  }
  return {};
}

}  // namespace breccia
