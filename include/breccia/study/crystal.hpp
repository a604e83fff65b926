#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <variant>
#include <vector>

#include "breccia/viscoelasticity/elastic_constants.hpp"

namespace breccia {

/// Bunge's Euler angles [rad]: the axes of the box are turned about z by phi1, about the new x by phi, and about the
/// new z by phi2, into those of the crystal.
struct EulerAngles {
  double phi1, phi, phi2;

  friend bool operator==(const EulerAngles&, const EulerAngles&) = default;
};

/// Each crystal has an orientation of its own, all of them equally likely.
struct RandomOrientations {
  std::optional<std::uint64_t> seed = {};  ///< nothing: that of the packing, or 1 where it has none
};

/// The axes of all crystals are those of the box.
struct AlignedOrientations {};

/// The orientation of each crystal of the filler, in the order of the box.
struct ListedOrientations {
  std::filesystem::path file;
  std::vector<EulerAngles> angles;
};

using Orientations = std::variant<RandomOrientations, AlignedOrientations, ListedOrientations>;

/// Particles that are crystals, one each.
struct Crystal {
  ElasticConstants constants;  ///< in the axes of the crystal [Pa]
  Orientations orientations = {};
};

}  // namespace breccia
