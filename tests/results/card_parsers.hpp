#pragma once

#include <optional>
#include <string>

#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

namespace breccia::test {

/// The material that a finite element program reads from a card, in the units of the card.
struct ParsedCard {
  std::string name = {};
  double density = 0.0;
  PronySeries shear = {};
  PronySeries bulk = {};
  std::optional<WilliamsLandelFerry> shift = {};
};

// Readers of the formats of docs/exports.md, each by the rules of its program and independent of the writers in
// Breccia. They throw std::runtime_error where a text does not follow the format.

ParsedCard parse_abaqus(const std::string& text);
ParsedCard parse_ansys(const std::string& text);
ParsedCard parse_ls_dyna(const std::string& text);
ParsedCard parse_openradioss(const std::string& text);
ParsedCard parse_comsol(const std::string& text);
ParsedCard parse_moose(const std::string& text);
ParsedCard parse_csv_card(const std::string& text);

/// The reader for a format by its name on the command line.
ParsedCard parse_card(const std::string& format, const std::string& text);

}  // namespace breccia::test
