#include "results/crystal_files.hpp"

#include <array>
#include <cstddef>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "homogenisation/box/crystal_orientations.hpp"
#include "homogenisation/box/fillers_of_particles.hpp"

namespace breccia {

std::vector<CsvColumn> columns_of_angles(std::span<const EulerAngles> angles) {
  std::array<std::vector<double>, 3> degrees;
  for (const auto& [phi1, phi, phi2] : angles) {
    constexpr double degree = std::numbers::pi / 180.0;
    degrees[0].push_back(phi1 / degree);
    degrees[1].push_back(phi / degree);
    degrees[2].push_back(phi2 / degree);
  }
  return {{"phi1_deg", degrees[0]}, {"phi_deg", degrees[1]}, {"phi2_deg", degrees[2]}};
}

void write_crystals(const std::filesystem::path& directory, const Stage& stage,
                    const StageMicrostructure& microstructure) {
  if (microstructure.grains() != nullptr) return;
  const auto fillers = fillers_of_particles(microstructure);
  const auto orientations = orientations_of_particles(stage, fillers);
  std::vector<double> particles, of_fillers;
  std::vector<EulerAngles> angles;
  for (std::size_t particle = 0; particle < orientations.size(); ++particle) {
    if (!orientations[particle]) continue;
    particles.push_back(static_cast<double>(particle));
    of_fillers.push_back(static_cast<double>(fillers[particle]));
    angles.push_back(*orientations[particle]);
  }
  if (angles.empty()) return;
  std::vector<CsvColumn> columns = {{"particle", particles}};
  if (stage.fillers.size() > 1) columns.push_back({"filler", of_fillers});
  for (auto& column : columns_of_angles(angles)) columns.push_back(std::move(column));
  write_csv(directory / "crystals.csv", columns,
            fmt::format("Orientations of the crystals of stage {} by Bunge's Euler angles, particles numbered from 0",
                        stage.name));
}

}  // namespace breccia
