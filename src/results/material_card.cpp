#include "results/material_card.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "io/display.hpp"
#include "results/cards/abaqus_card.hpp"
#include "results/cards/ansys_card.hpp"
#include "results/cards/comsol_card.hpp"
#include "results/cards/csv_card.hpp"
#include "results/cards/ls_dyna_card.hpp"
#include "results/cards/moose_card.hpp"
#include "results/cards/openradioss_card.hpp"
#include "virtual_test/bulk_test.hpp"
#include "viscoelasticity/poisson_ratio.hpp"
#include "viscoelasticity/prony_reduction.hpp"
#include "viscoelasticity/reference_temperature.hpp"

namespace breccia {
namespace {

/// A name that all programs accept: letters, digits and "_", the first a letter.
std::string card_name(const std::string& stage) {
  auto name = stage;
  std::ranges::replace_if(
      name, [](unsigned char letter) { return std::isalnum(letter) == 0; }, '_');
  if (name.empty() || std::isalpha(static_cast<unsigned char>(name.front())) == 0) name = "M_" + name;
  return name;
}

std::string program_of(CardFormat format) {
  switch (format) {
    case CardFormat::abaqus:
      return "Abaqus";
    case CardFormat::ansys:
      return "Ansys";
    case CardFormat::ls_dyna:
      return "LS-DYNA";
    case CardFormat::openradioss:
      return "OpenRadioss";
    case CardFormat::comsol:
      return "COMSOL";
    case CardFormat::moose:
      return "MOOSE";
    case CardFormat::csv:
      break;
  }
  return "the table";
}

/// Whether the cards of a format have a place for the shift law of Williams, Landel and Ferry.
bool has_shift(CardFormat format) {
  switch (format) {
    case CardFormat::ls_dyna:
    case CardFormat::openradioss:
    case CardFormat::moose:
      return false;
    case CardFormat::abaqus:
    case CardFormat::ansys:
    case CardFormat::comsol:
    case CardFormat::csv:
      break;
  }
  return true;
}

/// The bulk modulus of a card, and its origin.
struct BulkOfCard {
  PronySeries series;
  bool is_computed = false;  ///< whether it comes from a bulk test
  std::string origin;
};

/// The factor K / G at a constant Poisson's ratio.
double bulk_over_shear(double poisson) {
  return 2.0 * (1.0 + poisson) / (3.0 * (1.0 - 2.0 * poisson));
}

BulkOfCard bulk_of_card(const Composite& composite, const CardSettings& settings) {
  if (settings.bulk) {
    return {PronySeries(*settings.bulk), false,
            fmt::format("K is elastic, {}, as it was given", display(*settings.bulk, "Pa"))};
  }
  if (settings.poisson) {
    return {composite.shear.scaled(bulk_over_shear(*settings.poisson)), false,
            fmt::format("K(t) = {:.4g} G(t): Poisson's ratio is constant, {}, as it was given",
                        bulk_over_shear(*settings.poisson), *settings.poisson)};
  }
  return {*composite.bulk(), true,
          is_plane_strain(composite.dimensions) ? "K(t) is that of the bulk test, K(t) + G(t)/3, less G(t)/3"
                                                : "K(t) is that of the bulk test"};
}

void refuse_settings(const Composite& composite, const CardSettings& settings) {
  std::vector<std::string> mistakes;
  if (!(settings.tolerance > 0.0 && settings.tolerance < 1.0)) {
    mistakes.push_back(fmt::format("tolerance: expected a share above 0 and below 1, got {}", settings.tolerance));
  }
  if (settings.times && !(settings.times->begin > 0.0 && settings.times->begin < settings.times->end)) {
    mistakes.push_back(
        fmt::format("times: expected two rising times, got {} s and {} s", settings.times->begin, settings.times->end));
  }
  constexpr double rounding = 1e-9;
  if (settings.times && !(settings.times->begin >= (1.0 - rounding) * composite.times.begin &&
                          settings.times->end <= (1.0 + rounding) * composite.times.end)) {
    mistakes.push_back(fmt::format("times: expected times of the results, from {} to {} s, got {} s and {} s",
                                   composite.times.begin, composite.times.end, settings.times->begin,
                                   settings.times->end));
  }
  if (settings.bulk && settings.poisson) {
    mistakes.emplace_back("bulk modulus and Poisson's ratio: expected one of them");
  }
  if (settings.bulk && !(*settings.bulk > 0.0 && std::isfinite(*settings.bulk))) {
    mistakes.push_back(fmt::format("bulk modulus: expected one above zero, got {} Pa", *settings.bulk));
  }
  if (settings.poisson && !(*settings.poisson > -1.0 && *settings.poisson < 0.5)) {
    mistakes.push_back(fmt::format("Poisson's ratio: expected one above -1 and below 0.5, got {}", *settings.poisson));
  }
  if (!composite.dilatational && !settings.bulk && !settings.poisson) {
    mistakes.push_back(
        fmt::format("stage {} was not tested in bulk, so its K(t) is not known: add the load \"bulk\" to the study, or "
                    "give a bulk modulus or a constant Poisson's ratio",
                    composite.stage));
  }
  if (!mistakes.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes, "\n")));
}

std::string terms_in_words(const PronySeries& series) {
  return series.is_elastic() ? "an elastic modulus" : display_count(series.terms().size(), "term");
}

std::string percent(double share) {
  return fmt::format("{:.2g} %", 100.0 * share);
}

/// The equilibrium modulus of a card is at least this share of the tolerance times the modulus at the last time. The
/// shares of a modulus that relaxes to zero would add up to one and, when they are read, to a little more: to a solid
/// of negative stiffness.
constexpr double share_that_stays = 1e-2;

PronySeries with_equilibrium(const PronySeries& series, double last_time, double share) {
  const double least = share * series.at(last_time);
  return series.equilibrium() >= least ? series : PronySeries(least, series.terms());
}

/// Throws InputError where the terms are too many, or do not follow the moduli.
void refuse_terms(const PronyReduction& terms, const BulkOfCard& bulk, const CardSettings& settings) {
  const auto worst = terms.worst_deviation();
  if (worst <= settings.tolerance && terms.relaxation_times() <= most_terms(settings.format)) return;
  const bool is_bulk = bulk.is_computed && terms.deviations[1] > settings.tolerance;
  if (is_bulk && terms.deviations[0] <= settings.tolerance) {
    throw InputError(fmt::format(
        "K(t): no series of at most {} terms that only relaxes follows it within {}, the least deviation is {}; where "
        "the K(t) of plane strain, a difference of two tests, rises with time there is none: allow that tolerance, or "
        "give the bulk modulus or Poisson's ratio",
        terms.relaxation_times(), percent(settings.tolerance), percent(terms.deviations[1])));
  }
  if (most_terms(settings.format) == std::numeric_limits<std::size_t>::max()) {
    throw InputError(
        fmt::format("G(t) and K(t): the best series found without negative terms follow them within {}, not {}: allow "
                    "that",
                    percent(worst), percent(settings.tolerance)));
  }
  throw InputError(
      fmt::format("{} takes at most {}, with which the moduli deviate by {}, not {}: a wider tolerance, or fewer "
                  "decades of time, take fewer",
                  program_of(settings.format), display_count(most_terms(settings.format), "term"), percent(worst),
                  percent(settings.tolerance)));
}

/// Appends the rows of a table of shift factors as text, since no format has a place for them.
void append_shift_table(const ShiftTable& shift, double temperature, std::vector<std::string>& lines) {
  const auto table = with_reference(shift, temperature);
  lines.push_back(
      fmt::format("At {} K; the shift is not part of the card, because it is a table: T [K], log10 a_T", temperature));
  for (std::size_t i = 0; i < table.temperatures().size(); ++i) {
    lines.push_back(fmt::format("  {:.10g}, {:.6g}", table.temperatures()[i], table.log10_factors()[i]));
  }
}

std::vector<std::string> origin_of(const Composite& composite, const CardSettings& settings, const MaterialCard& card,
                                   const BulkOfCard& bulk) {
  const auto units = settings.units == CardUnits::m_kg_s ? "m, kg, s, Pa, K" : "mm, t, s, MPa, K";
  std::vector<std::string> lines = {
      fmt::format("{}, stage {}: {}, load {}; by breccia {}", composite.title, composite.stage,
                  boundary_in_words(composite.boundary), name_of(composite.shear_load), BRECCIA_VERSION),
      fmt::format("Units: {}", units),
      fmt::format("From {} to {} s: G(t) within {} of the results, by {}", card.times.begin, card.times.end,
                  percent(card.shear_deviation), terms_in_words(card.shear))};
  lines.push_back(bulk.origin);
  if (card.bulk_deviation) {
    lines.back() += fmt::format(", within {}, by {}", percent(*card.bulk_deviation), terms_in_words(card.bulk));
  }
  lines.push_back(composite.shear_error
                      ? fmt::format("The error of G(t) in the results is up to {}", percent(*composite.shear_error))
                      : "The error of G(t) in the results is not known");
  if (is_plane_strain(composite.dimensions)) {
    lines.emplace_back("The results are of plane strain; the card takes their G and K for those of a solid");
  }
  if (composite.shift && !card.shift) {
    append_shift_table(std::get<ShiftTable>(composite.shift->law), composite.shift->temperature, lines);
    return lines;
  }
  if (!card.shift) {
    lines.emplace_back("Without a shift with the temperature: the moduli hold at this temperature alone");
    return lines;
  }
  lines.push_back(fmt::format("At {} K; log10 a_T = -{} (T - {}) / ({} + T - {})", card.shift->reference_temperature,
                              card.shift->c1, card.shift->reference_temperature, card.shift->c2,
                              card.shift->reference_temperature));
  if (!has_shift(settings.format)) {
    lines.push_back(fmt::format("The shift is not part of the card for {}", program_of(settings.format)));
  }
  return lines;
}

/// Warnings about a given bulk modulus or Poisson's ratio that is implausible, and about a modulus before the first
/// time that nothing was computed for.
std::vector<std::string> warnings_on(const MaterialCard& card) {
  std::vector<std::string> warnings;
  const auto check = [&](double bulk, double shear, const char* when) {
    if (poisson_ratio(bulk, shear) >= 0.0) return;
    warnings.push_back(
        fmt::format("{}: Poisson's ratio of the card is {:.3g} {} (K = {}, G = {}); expected one from 0 to below 0.5, "
                    "are the units right?",
                    card.name, poisson_ratio(bulk, shear), when, display(bulk, "Pa"), display(shear, "Pa")));
  };
  const double first = card.shear.at(card.times.begin), before = card.shear.unrelaxed();
  constexpr double much = 2.0;
  if (before > much * first) {
    warnings.push_back(fmt::format(
        "{}: at t = 0 the card has G = {}, {:.2g} times that at its first time, {}; steps shorter than this see a "
        "modulus that was not computed: let the times of the study begin earlier, with a binder that is known there",
        card.name, display(before, "Pa"), before / first, display_time(card.times.begin)));
  }
  check(card.bulk.unrelaxed(), card.shear.unrelaxed(), "at t = 0");
  check(card.bulk.equilibrium(), card.shear.equilibrium(), "at infinite time");
  return warnings;
}

/// OpenRadioss takes a Poisson's ratio of 0 for 0.495, and none below.
void refuse_ratio(const MaterialCard& card, CardFormat format) {
  const double ratio = poisson_ratio(card.bulk.equilibrium(), card.shear.equilibrium());
  constexpr double of_rounding = 1e-12;
  if (format != CardFormat::openradioss || ratio > of_rounding) return;
  throw InputError(
      fmt::format("{}: OpenRadioss takes Poisson's ratios between 0 and 0.5; that at infinite time is {:.3g} (K = {}, "
                  "G = {})",
                  card.name, ratio, display(card.bulk.equilibrium(), "Pa"), display(card.shear.equilibrium(), "Pa")));
}

/// The card in other units.
MaterialCard in_units(MaterialCard card, CardUnits units) {
  if (units == CardUnits::m_kg_s) return card;
  constexpr double pascals = 1e6, kilograms_per_cubic_metre = 1e12;
  const auto converted = [](const PronySeries& series) {
    std::vector<MaxwellTerm> terms;
    for (const auto& [time, modulus] : series.terms()) terms.push_back({time, modulus / pascals});
    return PronySeries(series.equilibrium() / pascals, std::move(terms));
  };
  card.pressure_unit = "MPa";
  card.density /= kilograms_per_cubic_metre;
  card.shear = converted(card.shear);
  card.bulk = converted(card.bulk);
  return card;
}

}  // namespace

std::size_t most_terms(CardFormat format) {
  constexpr std::size_t of_ansys = 100, of_openradioss = 100;
  constexpr std::size_t of_ls_dyna = 18 - 1;  // one of the terms is the modulus at infinite time
  if (format == CardFormat::ansys) return of_ansys;
  if (format == CardFormat::openradioss) return of_openradioss;
  return format == CardFormat::ls_dyna ? of_ls_dyna : std::numeric_limits<std::size_t>::max();
}

MaterialCard material_card(const Composite& composite, const CardSettings& settings) {
  refuse_settings(composite, settings);
  const auto bulk = bulk_of_card(composite, settings);
  const auto times = settings.times.value_or(composite.times);
  const std::vector<PronySeries> moduli = {composite.shear, bulk.series};
  const auto few =
      reduce_prony(moduli, times, {.tolerance = settings.tolerance, .most_terms = most_terms(settings.format)});
  refuse_terms(few, bulk, settings);
  MaterialCard card;
  card.name = card_name(composite.stage);
  card.density = composite.density;
  const double share = share_that_stays * settings.tolerance;
  card.shear = with_equilibrium(few.series[0], times.end, share);
  card.bulk = with_equilibrium(few.series[1], times.end, share);
  refuse_ratio(card, settings.format);
  if (composite.shift) {
    const auto* law = std::get_if<WilliamsLandelFerry>(&composite.shift->law);
    if (law != nullptr) card.shift = with_reference(*law, composite.shift->temperature);
  }
  card.times = times;
  card.shear_deviation = few.deviations[0];
  if (bulk.is_computed) card.bulk_deviation = few.deviations[1];
  card.origin = origin_of(composite, settings, card, bulk);
  card.warnings = warnings_on(card);
  for (const auto& warning : card.warnings) card.origin.push_back("Warning: " + warning);
  return card;
}

std::string text_of(const MaterialCard& card, const CardSettings& settings) {
  const auto converted = in_units(card, settings.units);
  switch (settings.format) {
    case CardFormat::abaqus:
      return cards::abaqus_card(converted);
    case CardFormat::ansys:
      return cards::ansys_card(converted);
    case CardFormat::ls_dyna:
      return cards::ls_dyna_card(converted);
    case CardFormat::openradioss:
      return cards::openradioss_card(converted);
    case CardFormat::comsol:
      return cards::comsol_card(converted);
    case CardFormat::moose:
      return cards::moose_card(converted);
    case CardFormat::csv:
      break;
  }
  return cards::csv_card(converted);
}

}  // namespace breccia
