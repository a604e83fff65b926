#pragma once

#include <filesystem>
#include <vector>

#include "breccia/films/film_fields.hpp"
#include "breccia/results/stage_record.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Writes the fields of grains and films to the directory of their stage, as write_fields() does those of points: as
/// VTKHDF, with a polygon for each cell, and as pictures of stress, of strain, and of the work in films and junctions.
/// Throws FileError.
std::vector<FieldRecord> write_film_fields(const std::filesystem::path& directory, const Study& study,
                                           const Stage& stage, const TestId& test,
                                           const std::vector<TimedFilmFields>& fields);

}  // namespace breccia
