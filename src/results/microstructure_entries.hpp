#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "breccia/words.hpp"

#include "results/json_fields.hpp"

namespace breccia {

// The entries for microstructures in `study.json` (study_document.hpp).

struct CoatingEntry {
  std::string material;
  double thickness = 0.0;        ///< [m]
  double thickness_cells = 0.0;  ///< [-]
  double fraction = 0.0;         ///< [-]
};
template <>
inline constexpr auto fields<CoatingEntry> = std::tuple(field("material", &CoatingEntry::material),
                                                        field("thickness_m", &CoatingEntry::thickness),
                                                        field("thickness_cells", &CoatingEntry::thickness_cells),
                                                        field("fraction", &CoatingEntry::fraction));

struct FillerEntry {
  std::string material;
  std::optional<std::size_t> particles = {};
  double fraction = 0.0;  ///< [-]
  std::optional<double> fraction_asked = {};
  std::optional<double> smallest_diameter = {}, largest_diameter = {};  ///< [m]
  std::optional<double> size_deviation = {};
  std::optional<double> gap = {};  ///< [m]
  std::optional<CoatingEntry> coating = {};
  std::optional<std::string> shape = {};
};
template <>
inline constexpr auto fields<FillerEntry> =
    std::tuple(field("material", &FillerEntry::material), field("particles", &FillerEntry::particles),
               field("fraction", &FillerEntry::fraction), field("fraction_asked", &FillerEntry::fraction_asked),
               field("smallest_diameter_m", &FillerEntry::smallest_diameter),
               field("largest_diameter_m", &FillerEntry::largest_diameter),
               field("size_distribution_deviation", &FillerEntry::size_deviation), field("gap_m", &FillerEntry::gap),
               field("coating", &FillerEntry::coating), field_if_any("shape", &FillerEntry::shape));

/// One side of the threshold of a grey picture.
struct GreySideEntry {
  std::string material;
  int darkest = 0, brightest = 0;
  double mean = 0.0;
  double fraction = 0.0;  ///< [-]
};
template <>
inline constexpr auto fields<GreySideEntry> = std::tuple(field("material", &GreySideEntry::material),
                                                         field("darkest", &GreySideEntry::darkest),
                                                         field("brightest", &GreySideEntry::brightest),
                                                         field("mean", &GreySideEntry::mean),
                                                         field("fraction", &GreySideEntry::fraction));

/// What a threshold made of a grey picture.
struct ThresholdEntry {
  double value = 0.0;
  std::string method;   ///< "otsu" or "given"
  int median_side = 1;  ///< [pixels]
  double separability = 0.0;
  GreySideEntry dark = {}, bright = {};
  std::string words;
};
template <>
inline constexpr auto fields<ThresholdEntry> = std::tuple(field("value", &ThresholdEntry::value),
                                                          field("method", &ThresholdEntry::method),
                                                          field("median_of_pixels", &ThresholdEntry::median_side),
                                                          field("separability", &ThresholdEntry::separability),
                                                          field("dark", &ThresholdEntry::dark),
                                                          field("bright", &ThresholdEntry::bright),
                                                          field("words", &ThresholdEntry::words));

/// The films that are debonded.
struct DebondingEntry {
  std::string kind;       ///< "open", "sealed", "slip" or "spring"
  std::size_t films = 0;  ///< number of films
  double share = 0.0;     ///< share of the area of all films, in two dimensions of their length [-]
  std::optional<double> normal_stiffness = {}, tangential_stiffness = {};  ///< of springs [Pa/m]
  std::string words;                                                       ///< all this as a sentence
};
template <>
inline constexpr auto fields<DebondingEntry> =
    std::tuple(field("kind", &DebondingEntry::kind), field("films", &DebondingEntry::films),
               field("share", &DebondingEntry::share),
               field_if_any("normal_stiffness_Pa_per_m", &DebondingEntry::normal_stiffness),
               field_if_any("tangential_stiffness_Pa_per_m", &DebondingEntry::tangential_stiffness),
               field("words", &DebondingEntry::words));

/// What is at the sides of a box.
enum class BoxSides {
  periodic,  ///< what leaves the box on one side enters it on the other
  hard,      ///< walls, from which particles, or grains with half a film, keep off
  cut        ///< walls that cut grains and films
};
template <>
inline constexpr auto words<BoxSides> =
    std::to_array<Word<BoxSides>>({{"periodic", BoxSides::periodic}, {"hard", BoxSides::hard}, {"cut", BoxSides::cut}});

struct MicrostructureEntry {
  std::optional<std::size_t> particles = {};
  double fraction = 0.0;                             ///< [-]
  std::optional<BoxSides> sides = {};                ///< nothing for an image
  std::optional<double> interface_per_volume = {};   ///< interface per volume, in three dimensions [1/m]
  std::optional<double> interface_per_area = {};     ///< interface per area, in two dimensions [1/m]
  std::optional<double> gap = {}, gap_cells = {};    ///< [m], [-]
  std::optional<double> wall_gap = {};               ///< [m]
  double seconds = 0.0;                              ///< wall time [s]
  std::optional<double> film = {}, film_cells = {};  ///< thickness of the films between grains [m], [-]
  std::optional<DebondingEntry> debonding = {};
  std::optional<std::vector<std::string>> crystals =
      {};  ///< the orientations of the crystals and their isotropic means, in words
  std::optional<double> smallest_diameter = {}, largest_diameter = {};  ///< [m]
  std::optional<std::vector<int>> pixels = {};  ///< number of pixels of an image along its sides
  std::optional<double> pixel_side = {};        ///< [m]
  std::optional<double> cut_share = {};         ///< share of the filler that the sides of an image cut [-]
  std::optional<double> seam = {};              ///< share of the pixels at opposite sides that differ [-]
  std::optional<ThresholdEntry> threshold = {};
  std::optional<double> size_deviation = {};
  std::optional<std::uint64_t> seed = {};
  std::optional<std::uint64_t> events = {};
};
template <>
inline constexpr auto fields<MicrostructureEntry> = std::tuple(
    field("particles", &MicrostructureEntry::particles), field("fraction", &MicrostructureEntry::fraction),
    field_if_any("sides", &MicrostructureEntry::sides),
    field_if_any("interface_per_volume_1_per_m", &MicrostructureEntry::interface_per_volume),
    field_if_any("interface_per_area_1_per_m", &MicrostructureEntry::interface_per_area),
    field("smallest_gap_m", &MicrostructureEntry::gap), field("smallest_gap_cells", &MicrostructureEntry::gap_cells),
    field("smallest_wall_gap_m", &MicrostructureEntry::wall_gap), field("wall_time_s", &MicrostructureEntry::seconds),
    field_if_any("film_m", &MicrostructureEntry::film), field_if_any("film_cells", &MicrostructureEntry::film_cells),
    field_if_any("debonding", &MicrostructureEntry::debonding),
    field_if_any("crystals", &MicrostructureEntry::crystals),
    field_if_any("smallest_diameter_m", &MicrostructureEntry::smallest_diameter),
    field_if_any("largest_diameter_m", &MicrostructureEntry::largest_diameter),
    field_if_any("pixels", &MicrostructureEntry::pixels), field_if_any("pixel_m", &MicrostructureEntry::pixel_side),
    field_if_any("cut_share", &MicrostructureEntry::cut_share), field_if_any("seam_share", &MicrostructureEntry::seam),
    field_if_any("threshold", &MicrostructureEntry::threshold),
    field_if_any("size_distribution_deviation", &MicrostructureEntry::size_deviation),
    field_if_any("seed", &MicrostructureEntry::seed), field_if_any("events", &MicrostructureEntry::events));

}  // namespace breccia
