#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "breccia/films/debonding.hpp"
#include "breccia/microstructure/cell_faces.hpp"
#include "breccia/words.hpp"

namespace breccia {

template <>
inline constexpr auto words<Debonding> = std::to_array<Word<Debonding>>({{"open", Debonding::open},
                                                                         {"sealed", Debonding::sealed},
                                                                         {"slip", Debonding::slip},
                                                                         {"spring", Debonding::spring}});

/// The films of a stage of grains from which the binder has come off, or to which springs hold it, and how
/// (`[stages.bonds]` of a deck): a share of the films, or those between listed grains.
struct FilmBonds {
  double debonded = 0.0;  ///< share of the area of all films, in the plane of their length [-]
  Debonding kind = Debonding::open;
  /// Seed by which the films are chosen; if absent, it is that of the packing, or 1 for listed sites.
  std::optional<std::uint64_t> seed = {};
  /// If not empty, the films whose normals are closest to this direction are debonded, instead of films at random: as
  /// many components as the stage has dimensions.
  std::vector<double> normal = {};
  /// If not empty, the films between these pairs of grains are debonded, instead of a share of all.
  std::vector<SitePair> films = {};
  InterfaceStiffness springs = {};  ///< of films on springs [Pa/m]
};

}  // namespace breccia
