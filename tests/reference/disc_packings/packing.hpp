#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace disc_packings {

struct Disc {
  Eigen::Vector2d centre;
  double radius;
};

/// The box of side 1 with the discs: periodic or [0, 1] x [0, 1] with walls, between which all discs are.
enum class Box { periodic, walled };

using Packing = std::vector<Disc>;

/// Reads a table of columns x, y, diameter.
[[nodiscard]] Packing read_packing(const std::string& path);

/// The distance of the surfaces of two discs.
[[nodiscard]] double gap(const Disc& one, const Disc& other);

/// The radius of two equal discs whose neck is as curved as that of these: 2 R1 R2 / (R1 + R2).
[[nodiscard]] double neck_radius(const Disc& one, const Disc& other);

}  // namespace disc_packings
