#include "breccia/discretisation/cell.hpp"

namespace breccia {

std::array<double, 4> node_weights(int point) {
  const auto& [x, y] = point_offsets[static_cast<std::size_t>(point)];
  return {(0.5 - x) * (0.5 - y), (0.5 + x) * (0.5 - y), (0.5 - x) * (0.5 + y), (0.5 + x) * (0.5 + y)};
}

Eigen::Matrix<double, 3, cell_dofs> strain_matrix(int point) {
  const auto& [x, y] = point_offsets[static_cast<std::size_t>(point)];
  const std::array<double, 4> dx = {-(0.5 - y), 0.5 - y, -(0.5 + y), 0.5 + y};
  const std::array<double, 4> dy = {-(0.5 - x), -(0.5 + x), 0.5 - x, 0.5 + x};
  Eigen::Matrix<double, 3, cell_dofs> strain;
  for (std::size_t node = 0; node < 4; ++node) {
    const auto column = static_cast<Eigen::Index>(2 * node);
    strain.col(column) << dx[node], 0.0, dy[node];
    strain.col(column + 1) << 0.0, dy[node], dx[node];
  }
  return strain;
}

Eigen::Matrix<double, 1, cell_dofs> volumetric_strain_matrix(int point, Volumetric volumetric) {
  const auto own = [](int p) -> Eigen::Matrix<double, 1, cell_dofs> {
    const auto strain = strain_matrix(p);
    return strain.row(0) + strain.row(1);
  };
  if (volumetric == Volumetric::standard) return own(point);
  return 0.25 * (own(0) + own(1) + own(2) + own(3));
}

Eigen::Matrix<double, 3, cell_dofs> strain_matrix(int point, Volumetric volumetric) {
  auto strain = strain_matrix(point);
  const Eigen::Matrix<double, 1, cell_dofs> own = strain.row(0) + strain.row(1);
  const Eigen::Matrix<double, 1, cell_dofs> missing = volumetric_strain_matrix(point, volumetric) - own;
  strain.row(0) += 0.5 * missing;
  strain.row(1) += 0.5 * missing;
  return strain;
}

CellMatrix cell_stiffness(const std::array<Moduli, points_per_cell>& moduli, Volumetric volumetric) {
  // Twice the deviatoric strain energy per unit shear modulus, with the out-of-plane strain zero.
  Eigen::Matrix3d deviatoric;
  deviatoric << 4.0 / 3.0, -2.0 / 3.0, 0.0, -2.0 / 3.0, 4.0 / 3.0, 0.0, 0.0, 0.0, 1.0;
  CellMatrix stiffness = CellMatrix::Zero();
  for (int p = 0; p < points_per_cell; ++p) {
    const auto& [bulk, shear] = moduli[static_cast<std::size_t>(p)];
    const auto strain = strain_matrix(p, volumetric);
    const auto volume = volumetric_strain_matrix(p, volumetric);
    stiffness += 0.25 * (shear * strain.transpose() * deviatoric * strain + bulk * volume.transpose() * volume);
  }
  return stiffness;
}

}  // namespace breccia
