#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "breccia/words.hpp"

#include "results/meshes/length_unit.hpp"
#include "results/study_document.hpp"

namespace breccia {

/// A format of files of meshes.
enum class MeshFormat {
  msh,    ///< MSH 2.2 of Gmsh, as text
  vtkhdf  ///< VTKHDF, for ParaView
};
template <>
inline constexpr auto words<MeshFormat> = std::to_array<Word<MeshFormat>>({{"msh", MeshFormat::msh},
                                                                           {"vtkhdf", MeshFormat::vtkhdf}});

struct MeshSettings {
  MeshFormat format = MeshFormat::msh;
  LengthUnit unit = LengthUnit::metre;
  // Sizes of the elements, as in FilmProblem; if absent, they are those of the tests of the stage, or the defaults.
  std::optional<int> layers = {};
  std::optional<int> divisions = {};      ///< in space
  std::optional<double> face_share = {};  ///< in the plane [-]
};

/// What a file of a mesh holds.
struct MeshCounts {
  std::size_t nodes = 0, elements = 0;
  double grains = 0.0, binder = 0.0;  ///< shares of the box that their elements fill [-]
  std::size_t inverted = 0;           ///< number of elements whose content is not positive
  std::size_t opposite_surfaces = 0;  ///< number of pairs of surfaces that are periodic
  std::size_t facets_of_gaps = 0;     ///< number of facets along films that are debonded
};

/// The number of layers of elements across the films: that of the settings, or else of the tests of the stage; nothing
/// where the films of the tests are thin, or there are no tests.
[[nodiscard]] std::optional<int> layers_of(const StageEntry& stage, const MeshSettings& settings);

/// Throws InputError, with the reason and with what is there instead, unless a stage has grains in a box that can be
/// meshed.
void require_mesh(const StageEntry& stage, const MeshSettings& settings);

/// Writes the conforming mesh of the grains and the binder of a stage (films::conforming_mesh). `directory` is that of
/// the stage in its results. Throws FileError, and InputError as require_mesh(), the readers of stored geometry and
/// films::conforming_mesh() do, the last also where there is no number of layers.
MeshCounts write_mesh(const std::filesystem::path& file, const std::filesystem::path& directory,
                      const StageEntry& stage, const MeshSettings& settings);

}  // namespace breccia
