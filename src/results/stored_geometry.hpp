#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "breccia/films/debonding.hpp"
#include "breccia/microstructure/ellipsoid.hpp"
#include "breccia/microstructure/laguerre_sites.hpp"

#include "results/study_document.hpp"

namespace breccia {

/// The stage of this name in a directory of results, or the last one that is packed for an empty name. Throws
/// InputError, with the names of the stages, where there is none.
const StageEntry& stage_named(const StudyDocument& document, const std::string& name);

/// The spheres or ellipsoids of a stage, and the number of the filler of each, from 0.
struct StoredEllipsoids {
  std::vector<Ellipsoid> particles;
  std::vector<std::size_t> fillers;
};

/// Reads the particles of a stage in space from the `microstructure.csv` in its directory. Throws FileError, and
/// InputError where a column is missing.
StoredEllipsoids read_stored_ellipsoids(const std::filesystem::path& directory, const StageEntry& stage);

/// Reads the sites of the grains of a stage from the `grains.csv` in its directory. Throws FileError, and InputError
/// where a column is missing or study.json does not say what is at the sides of the box.
template <int dim>
LaguerreSites<dim> read_stored_sites(const std::filesystem::path& directory, const StageEntry& stage);

/// Reads the films of a stage that are debonded from the `films.csv` in its directory; none where it
/// has no bonds. Throws FileError, and InputError where a column is missing or the kind is not known.
template <int dim>
DebondedFilms<dim> read_debonded_films(const std::filesystem::path& directory, const StageEntry& stage);

}  // namespace breccia
