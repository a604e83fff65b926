#include "discretisation/gaps/change_of_owner.hpp"

namespace breccia::gaps {

template <int dim>
double change_of_owner(const ParticleImages<dim>& images, ImageIndex first, ImageIndex second,
                       const GridLine<dim>& line) {
  constexpr int halvings = 60;
  double begin = 0.0, end = 1.0;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (begin + end);
    const auto point = line.at(middle);
    (images.distance(first, point) < images.distance(second, point) ? begin : end) = middle;
  }
  return 0.5 * (begin + end);
}

template double change_of_owner(const ParticleImages<2>&, ImageIndex, ImageIndex, const GridLine<2>&);
template double change_of_owner(const ParticleImages<3>&, ImageIndex, ImageIndex, const GridLine<3>&);

}  // namespace breccia::gaps
