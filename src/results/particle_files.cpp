#include "results/particle_files.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "breccia/microstructure/ellipsoid.hpp"

#include "tables/csv.hpp"

namespace breccia {
namespace {

void write_ellipses(const std::filesystem::path& directory, const Stage& stage, const ParticleBox& box) {
  std::vector<double> x, y, first, second, angles, fillers;
  for (std::size_t particle = 0; particle < box.particles.size(); ++particle) {
    const auto& [shape, pose] = box.particles[particle];
    const auto* ellipse = std::get_if<Ellipse>(&shape);
    if (ellipse == nullptr) continue;
    x.push_back(pose.centre()[0]);
    y.push_back(pose.centre()[1]);
    first.push_back(ellipse->axes[0]);
    second.push_back(ellipse->axes[1]);
    angles.push_back(pose.angle() * 180.0 / std::numbers::pi);
    fillers.push_back(static_cast<double>(box.filler_of(particle)));
  }
  std::vector<CsvColumn> columns = {
      {"x_m", x}, {"y_m", y}, {"axis_1_m", first}, {"axis_2_m", second}, {"angle_deg", angles}};
  if (!box.fillers.empty()) columns.push_back({"filler", fillers});
  write_csv(directory / "microstructure.csv", columns,
            fmt::format("Ellipses of stage {} in a box of {} m", stage.name, stage.side));
}

void write_polygons(const std::filesystem::path& directory, const Stage& stage, const ParticleBox& box) {
  std::vector<double> numbers, x, y, fillers;
  for (std::size_t particle = 0; particle < box.particles.size(); ++particle) {
    const auto& [shape, pose] = box.particles[particle];
    const auto* polygon = std::get_if<ConvexPolygon>(&shape);
    if (polygon == nullptr) continue;
    for (const auto& corner : polygon->corners()) {
      const auto seen = pose.from_shape(corner);
      numbers.push_back(static_cast<double>(particle));
      x.push_back(pose.centre()[0] + seen[0]);
      y.push_back(pose.centre()[1] + seen[1]);
      fillers.push_back(static_cast<double>(box.filler_of(particle)));
    }
  }
  if (numbers.empty()) return;
  std::vector<CsvColumn> columns = {{"particle", numbers}, {"x_m", x}, {"y_m", y}};
  if (!box.fillers.empty()) columns.push_back({"filler", fillers});
  write_csv(directory / "polygons.csv", columns,
            fmt::format("Corners of the polygons of stage {} in a box of {} m", stage.name, stage.side));
}

}  // namespace

void write_particles(const std::filesystem::path& directory, const Stage& stage, const ParticleBox& box) {
  write_polygons(directory, stage, box);
  const auto is_ellipse = [](const Particle& particle) { return std::holds_alternative<Ellipse>(particle.shape); };
  if (std::ranges::any_of(box.particles, is_ellipse)) write_ellipses(directory, stage, box);
}

void write_ellipsoids(const std::filesystem::path& directory, const Stage& stage, const EllipsoidBox& box) {
  constexpr double degree = std::numbers::pi / 180.0;
  constexpr std::array names = {"x_m",      "y_m",         "z_m",           "axis_1_m", "axis_2_m",
                                "axis_3_m", "azimuth_deg", "elevation_deg", "roll_deg"};
  std::array<std::vector<double>, names.size()> numbers;
  for (const auto& [centre, axes, directions] : box.particles) {
    const auto [azimuth, elevation, roll] = turn_of(directions);
    const std::array row = {centre[0], centre[1],        centre[2],          axes[0],      axes[1],
                            axes[2],   azimuth / degree, elevation / degree, roll / degree};
    for (std::size_t column = 0; column < row.size(); ++column) numbers[column].push_back(row[column]);
  }
  std::vector<CsvColumn> columns;
  for (std::size_t column = 0; column < names.size(); ++column) columns.push_back({names[column], numbers[column]});
  const std::vector<double> fillers(box.fillers.begin(), box.fillers.end());
  if (!fillers.empty()) columns.push_back({"filler", fillers});
  write_csv(directory / "microstructure.csv", columns,
            fmt::format("Ellipsoids of stage {} in a box of {} m", stage.name, stage.side));
}

}  // namespace breccia
