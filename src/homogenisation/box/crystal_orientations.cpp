#include "homogenisation/box/crystal_orientations.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "microstructure/uniform.hpp"

namespace breccia {
namespace {

/// Rotations that are equally likely: phi1 and phi2 are uniform, and so is the cosine of phi.
EulerAngles random_angles(std::mt19937_64& engine) {
  const double phi1 = 2.0 * std::numbers::pi * uniform(engine);
  const double phi = std::acos(1.0 - 2.0 * uniform(engine));
  return {phi1, phi, 2.0 * std::numbers::pi * uniform(engine)};
}

struct DrawOrientations {
  const Stage& stage;
  std::size_t filler;
  std::size_t count;

  std::vector<EulerAngles> operator()(const RandomOrientations& random) const {
    // The packing draws from the same seed: other numbers follow for the orientations of each filler. Odd multiples of
    // a number of many digits keep the fillers of one seed apart from those of others.
    constexpr std::uint64_t of_orientations = 0x9e3779b97f4a7c15;
    std::mt19937_64 engine(random.seed.value_or(stage.seed().value_or(1)) ^ (of_orientations * (2 * filler + 1)));
    std::vector<EulerAngles> angles;
    for (std::size_t crystal = 0; crystal < count; ++crystal) angles.push_back(random_angles(engine));
    return angles;
  }
  std::vector<EulerAngles> operator()(const AlignedOrientations&) const {
    return std::vector<EulerAngles>(count, {0.0, 0.0, 0.0});
  }
  std::vector<EulerAngles> operator()(const ListedOrientations& listed) const {
    if (listed.angles.size() == count) return listed.angles;
    throw InputError(fmt::format("stage {}: filler of {}: orientations: {}: expected those of {} {}, got {}",
                                 stage.name, stage.fillers[filler].material.name, listed.file.string(), count,
                                 stage.has_grains() ? "grains" : "particles", listed.angles.size()));
  }
};

}  // namespace

std::vector<EulerAngles> crystal_orientations(const Stage& stage, std::size_t filler, std::size_t count) {
  const auto& crystal = stage.fillers[filler].crystal;
  if (!crystal) return {};
  return std::visit(DrawOrientations{stage, filler, count}, crystal->orientations);
}

std::vector<std::optional<EulerAngles>> orientations_of_particles(const Stage& stage,
                                                                  std::span<const std::size_t> fillers) {
  std::vector<std::optional<EulerAngles>> orientations(fillers.size());
  for (std::size_t filler = 0; filler < stage.fillers.size(); ++filler) {
    if (!stage.fillers[filler].crystal) continue;
    const auto count = static_cast<std::size_t>(std::ranges::count(fillers, filler));
    auto next = crystal_orientations(stage, filler, count);
    std::size_t taken = 0;
    for (std::size_t particle = 0; particle < fillers.size(); ++particle) {
      if (fillers[particle] == filler) orientations[particle] = next[taken++];
    }
  }
  return orientations;
}

StiffnessTensor<3> crystal_stiffness(const Crystal& crystal, const EulerAngles& angles) {
  return rotated(stiffness_tensor(crystal.constants), crystal_axes(angles.phi1, angles.phi, angles.phi2));
}

}  // namespace breccia
