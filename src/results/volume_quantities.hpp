#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "breccia/study/test_id.hpp"

#include "report/field_picture.hpp"

namespace breccia {

/// The quantity of a field of cells in a cube that is drawn.
struct VolumeQuantity {
  std::string words;       ///< name of the quantity, with the unit of the labels
  double unit_size = 1.0;  ///< unit of the labels in the unit of the values
  ColourScale scale = ColourScale::linear;
  std::vector<double> values;  ///< values by cell
};

/// Components of a symmetric tensor: xx, yy, zz, yz, zx, xy.
using CellTensor = std::array<double, 6>;

/// The components in the order of VTK: xx, yy, zz, xy, yz, xz.
[[nodiscard]] CellTensor in_order_of_vtk(const CellTensor& tensor);

/// The stress component of a load [Pa].
[[nodiscard]] double stress_under(Load load, const CellTensor& stress);
/// The strain component of a load.
[[nodiscard]] double strain_under(Load load, const CellTensor& strain);
/// The equivalent shear strain, sqrt(2 e : e) of the deviator e.
[[nodiscard]] double equivalent_shear(const CellTensor& strain);

/// The stress component of a load [Pa] in cells of these volumes, relative to the applied strain or stress.
VolumeQuantity stress_in_cells(std::span<const CellTensor> stress, std::span<const double> volumes, Load load,
                               Boundary boundary);

/// The equivalent shear strain in cells of these volumes over the mean shear strain or dilatation of the load.
VolumeQuantity strain_in_cells(std::span<const CellTensor> strain, std::span<const double> volumes, Load load);

}  // namespace breccia
