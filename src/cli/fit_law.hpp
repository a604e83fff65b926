#pragma once

#include <string>
#include <vector>

#include "breccia/viscoelasticity/law_fit.hpp"

namespace breccia::cli {

/// The parameters that the option --keep gives, each as KEY=VALUE with a unit where the parameter has one. Throws
/// InputError with all mistakes.
GivenParameters kept_parameters(LawForm form, const std::vector<std::string>& options);

/// The law as the value of a key of a deck: `{ law = "2s2p1d", static = "0 Pa", ... }`.
std::string law_for_deck(const LawFit& fit);

/// A parameter in words: its key, its value, and its standard error or where its value comes from.
struct ParameterInWords {
  std::string key;
  std::string value;
  std::string note;
};
std::vector<ParameterInWords> parameters_in_words(const LawFit& fit);

}  // namespace breccia::cli
