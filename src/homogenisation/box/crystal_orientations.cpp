#include "homogenisation/box/crystal_orientations.hpp"

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
  std::size_t count;

  std::vector<EulerAngles> operator()(const RandomOrientations& random) const {
    // The packing draws from the same seed: other numbers follow for the orientations.
    constexpr std::uint64_t of_orientations = 0x9e3779b97f4a7c15;
    std::mt19937_64 engine(random.seed.value_or(stage.seed().value_or(1)) ^ of_orientations);
    std::vector<EulerAngles> angles;
    for (std::size_t crystal = 0; crystal < count; ++crystal) angles.push_back(random_angles(engine));
    return angles;
  }
  std::vector<EulerAngles> operator()(const AlignedOrientations&) const {
    return std::vector<EulerAngles>(count, {0.0, 0.0, 0.0});
  }
  std::vector<EulerAngles> operator()(const ListedOrientations& listed) const {
    if (listed.angles.size() == count) return listed.angles;
    throw InputError(fmt::format("stage {}: {}: expected the orientations of {} grains, got {}", stage.name,
                                 listed.file.string(), count, listed.angles.size()));
  }
};

}  // namespace

std::vector<EulerAngles> crystal_orientations(const Stage& stage, std::size_t count) {
  const auto& crystal = stage.fillers.front().crystal;
  if (!crystal) return {};
  return std::visit(DrawOrientations{stage, count}, crystal->orientations);
}

std::vector<StiffnessTensor<3>> crystal_stiffnesses(const Stage& stage, std::size_t count) {
  std::vector<StiffnessTensor<3>> stiffnesses;
  for (const auto& [phi1, phi, phi2] : crystal_orientations(stage, count)) {
    stiffnesses.push_back(
        rotated(stiffness_tensor(stage.fillers.front().crystal->constants), crystal_axes(phi1, phi, phi2)));
  }
  return stiffnesses;
}

}  // namespace breccia
