#pragma once

#include <filesystem>
#include <vector>

#include "breccia/study/study.hpp"
#include "breccia/virtual_test/test_fields.hpp"

#include "results/stage_record.hpp"

namespace breccia {

/// Writes the fields of grains and films to the directory of their stage, like those of points: as VTKHDF, with a
/// polygon for each cell, and as pictures of stress, of strain, and of the work in films and junctions. Every process
/// may call it; the first one writes. Throws FileError there.
std::vector<FieldRecord> write_fields(const std::filesystem::path& directory, const Study& study, const Stage& stage,
                                      const TestId& test, const NetworkFields& fields);

}  // namespace breccia
