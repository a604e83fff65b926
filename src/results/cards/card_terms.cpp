#include "results/cards/card_terms.hpp"

#include <map>

#include <fmt/format.h>

namespace breccia::cards {

std::vector<CardTerm> terms_of(const MaterialCard& card) {
  std::map<double, CardTerm> by_time;
  for (const auto& [time, modulus] : card.shear.terms())
    by_time.insert({time, {time, 0.0, 0.0}}).first->second.shear = modulus;
  for (const auto& [time, modulus] : card.bulk.terms())
    by_time.insert({time, {time, 0.0, 0.0}}).first->second.bulk = modulus;
  std::vector<CardTerm> terms;
  terms.reserve(by_time.size());
  for (const auto& [time, term] : by_time) terms.push_back(term);
  return terms;
}

std::string comments_of(const MaterialCard& card, std::string_view sign) {
  std::string text;
  for (const auto& line : card.origin) text += fmt::format("{} {}\n", sign, line);
  return text;
}

std::string number(double value) {
  auto text = fmt::format("{:.12g}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string exact_number(double value) {
  return fmt::format("{}", value);
}

}  // namespace breccia::cards
