// What a run tells of its state: memory, momentum, energy and fields. The steps are in classical.cpp.
#include "classical.hpp"

namespace breccia::dynamics {

Vector<2> Classical::momentum() const {
  Vector<2> sum = {0.0, 0.0};
  for (const auto& point : points_) {
    sum[0] += point.mass * point.velocity[0] / problem().amplitude;
    sum[1] += point.mass * point.velocity[1] / problem().amplitude;
  }
  return sum;
}

Energy Classical::energy() const {
  require_elastic();
  const double area = initial_area_ / static_cast<double>(points_.size());
  Energy energy;
  for (const auto& point : points_) {
    const auto& v = point.velocity;
    const auto& e = point.strain;
    const auto& s = point.deviator;
    energy.kinetic += 0.5 * point.mass * (v[0] * v[0] + v[1] * v[1]);
    energy.strain += 0.5 * area * (point.pressure * (e[0] + e[1]) + s[0] * e[0] + s[1] * e[1] + s[2] * e[2]);
  }
  const double squared = problem().amplitude * problem().amplitude;
  return {energy.kinetic / squared, energy.strain / squared};
}

Footprint Classical::footprint() const {
  // A step reads the points nine times and writes them four times, the nodes seven and four times, the history twice.
  const auto points = points_.size() * sizeof(Point);
  const auto nodes = nodes_.size() * sizeof(Node);
  const auto history = history_.size() * sizeof(double);
  const auto cells = cell_begin_.size() * sizeof(std::size_t) + mean_stress_.size() * sizeof(double);
  return {.held = problem().discretisation.cells().size() * sizeof(CellMaterials) + points + nodes + history + cells,
          .moved_per_step = 13 * points + 11 * nodes + 4 * history};
}

PointFields Classical::fields() const {
  const double scale = 1.0 / problem().amplitude;
  auto fields = zero_fields(problem().discretisation);
  for (const auto& point : points_) {
    const auto i = point.lattice;
    const auto& [sxx, syy, sxy] = point.deviator;
    fields.displacement[i] = {scale * point.displacement[0], scale * point.displacement[1]};
    fields.strain[i] = {scale * point.strain[0], scale * point.strain[1], 0.5 * scale * point.strain[2]};
    fields.stress[i] = {scale * (point.pressure + sxx), scale * (point.pressure + syy),
                        scale * (point.pressure - sxx - syy), scale * sxy};
  }
  return fields;
}

}  // namespace breccia::dynamics
