#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/reduction.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"
#include "breccia/words.hpp"

#include "results/composite.hpp"

namespace breccia {

/// The program that a material card is for (docs/exports.md).
enum class CardFormat { abaqus, ansys, ls_dyna, openradioss, comsol, moose, csv };

template <>
inline constexpr auto words<CardFormat> = std::to_array<Word<CardFormat>>({{"abaqus", CardFormat::abaqus},
                                                                           {"ansys", CardFormat::ansys},
                                                                           {"ls-dyna", CardFormat::ls_dyna},
                                                                           {"openradioss", CardFormat::openradioss},
                                                                           {"comsol", CardFormat::comsol},
                                                                           {"moose", CardFormat::moose},
                                                                           {"csv", CardFormat::csv}});

/// The units of a card; temperatures are in kelvin.
enum class CardUnits {
  m_kg_s,  ///< Pa, kg/m^3
  mm_t_s   ///< MPa, t/mm^3
};

template <>
inline constexpr auto words<CardUnits> = std::to_array<Word<CardUnits>>({{"m-kg-s", CardUnits::m_kg_s},
                                                                         {"mm-t-s", CardUnits::mm_t_s}});

/// The settings of a card.
struct CardSettings {
  CardFormat format = CardFormat::csv;
  CardUnits units = CardUnits::m_kg_s;
  double tolerance = 0.01;               ///< largest relative deviation of G(t) and K(t) from the results [-]
  std::optional<TimeWindow> times = {};  ///< times in which the card holds [s]; by default the times of the study
  std::optional<double> bulk = {};       ///< an elastic bulk modulus [Pa], in place of that of the bulk test
  std::optional<double> poisson = {};    ///< a constant Poisson's ratio [-], in place of the bulk test
};

/// An isotropic viscoelastic solid for a finite element program.
struct MaterialCard {
  std::string name;                  ///< name of letters, digits and "_", beginning with a letter
  std::string pressure_unit = "Pa";  ///< unit of the moduli; other quantities are in the same system of units
  double density = 0.0;
  PronySeries shear;  ///< G(t), without negative terms
  PronySeries bulk;   ///< K(t), without negative terms, with relaxation times of the same list
  /// Shift law, whose reference is the temperature of the moduli; tables have no place in a card.
  std::optional<WilliamsLandelFerry> shift = {};
  TimeWindow times;                           ///< times in which the moduli hold [s]
  double shear_deviation = 0.0;               ///< largest relative deviation of G(t) from the results [-]
  std::optional<double> bulk_deviation = {};  ///< largest relative deviation of K(t) [-]; nothing where K was given
  std::vector<std::string> origin = {};       ///< lines about the origin of the card and its assumptions
  /// Warnings about implausible values, such as those with a wrong unit; in `origin`, too.
  std::vector<std::string> warnings = {};
};

/// The largest number of Maxwell terms of a card.
std::size_t most_terms(CardFormat format);

/// The card of a composite, in SI units: G(t) and K(t) with few common relaxation times (reduce_prony). Throws
/// InputError with all mistakes in the settings; where there is neither a bulk test nor a bulk modulus or a Poisson's
/// ratio; where the series cannot follow the moduli within the tolerance with as many terms as the format has; where a
/// series without negative terms cannot follow the K(t) of a composite in plane strain; and where Poisson's ratio is
/// none that the format takes.
MaterialCard material_card(const Composite& composite, const CardSettings& settings);

/// The text of the card in the format and units of the settings.
std::string text_of(const MaterialCard& card, const CardSettings& settings);

}  // namespace breccia
