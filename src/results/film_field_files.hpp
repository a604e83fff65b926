#pragma once

#include <filesystem>
#include <vector>

#include "breccia/study/study.hpp"
#include "breccia/virtual_test/test_fields.hpp"

#include "results/stage_record.hpp"

namespace breccia {

/// Writes the fields of grains and films to the directory of their stage, like those of points: as VTKHDF, with a
/// polygon, a tetrahedron or a wedge for each cell, and as pictures of stress, of strain, and of the work in the
/// binder, in space halfway up the box. Every process may call it; the first one writes. Throws FileError there.
template <int dim>
std::vector<FieldRecord> write_fields(const std::filesystem::path& directory, const Study& study, const Stage& stage,
                                      const TestId& test, const NetworkFields<dim>& fields);

}  // namespace breccia
