#include "deck/column_words.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "io/nearest_name.hpp"

namespace breccia {
namespace {

const std::map<std::string, Quantity>& quantities_of_words() {
  static const std::map<std::string, Quantity> quantities = {{"time", Quantity::time},
                                                             {"frequency", Quantity::angular_frequency},
                                                             {"temperature", Quantity::temperature},
                                                             {"storage", Quantity::storage_modulus},
                                                             {"loss", Quantity::loss_modulus},
                                                             {"absolute", Quantity::absolute_modulus},
                                                             {"phase", Quantity::phase_angle},
                                                             {"tangent", Quantity::loss_tangent},
                                                             {"modulus", Quantity::modulus},
                                                             {"compliance", Quantity::compliance}};
  return quantities;
}

}  // namespace

std::vector<ColumnChoice> column_choices(const std::vector<NamedColumn>& columns, const std::string& argument) {
  std::vector<std::string> words;
  for (const auto& [word, quantity] : quantities_of_words()) words.push_back(word);
  std::vector<ColumnChoice> choices;
  std::vector<std::string> mistakes;
  for (const auto& [word, name] : columns) {
    const auto known = quantities_of_words().find(word);
    if (known == quantities_of_words().end()) {
      mistakes.push_back(fmt::format("{}: unknown quantity \"{}\"{}", argument, word, suggestion(word, words)));
    } else if (std::ranges::find(choices, known->second, &ColumnChoice::quantity) != choices.end()) {
      mistakes.push_back(fmt::format("{}: {} is given twice", argument, word));
    } else {
      choices.push_back({known->second, name});
    }
  }
  if (!mistakes.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes, "\n")));
  return choices;
}

}  // namespace breccia
