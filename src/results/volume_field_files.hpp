#pragma once

#include <filesystem>
#include <vector>

#include "breccia/study/study.hpp"
#include "breccia/virtual_test/test_fields.hpp"

#include "results/stage_record.hpp"

namespace breccia {

/// Writes the fields of the cells of a cube (CellFields) to the directory of their stage, like those of points: as
/// VTKHDF, with a hexahedron for each cell, and as pictures of the stress and the strain in the three middle planes.
/// Every process must call it.
std::vector<FieldRecord> write_fields(const std::filesystem::path& directory, const Study& study, const Stage& stage,
                                      const TestId& test, const GridFields<3>& fields);

}  // namespace breccia
