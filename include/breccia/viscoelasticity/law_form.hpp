#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "breccia/words.hpp"

namespace breccia {

/// The formulas of few parameters for a modulus or a compliance (RelaxationLaw, CreepLaw).
enum class LawForm { two_springs_two_parabolas_dashpot, fractional_zener, power_law_creep, logarithmic_creep };

template <>
inline constexpr auto words<LawForm> =
    std::to_array<Word<LawForm>>({{"2s2p1d", LawForm::two_springs_two_parabolas_dashpot},
                                  {"fractional-zener", LawForm::fractional_zener},
                                  {"power-law-creep", LawForm::power_law_creep},
                                  {"logarithmic-creep", LawForm::logarithmic_creep}});

/// What a parameter of a law is. An exponent lies between 0 and 1; everything else is positive.
enum class ParameterKind { modulus, compliance, time, number, exponent };

/// A parameter of a law.
struct LawParameter {
  std::string_view key;  ///< as in decks
  ParameterKind kind;
  /// The value at which the law does without the parameter: no modulus at infinite time, no dashpot, the natural
  /// logarithm.
  std::optional<double> limit = {};
};

/// The parameters of a law in the order of its formula.
std::span<const LawParameter> parameters_of(LawForm form);

}  // namespace breccia
