#include "deck/condition.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/display.hpp"
#include "io/nearest_name.hpp"
#include "io/range.hpp"
#include "io/trimmed.hpp"
#include "io/units.hpp"

namespace breccia {
namespace {

/// A quantity of a condition.
struct NamedQuantity {
  std::string name;
  ObservedModulus modulus;
  ObservedCurve curve;
  ConditionForm form;
};

std::vector<NamedQuantity> quantities() {
  std::vector<NamedQuantity> all;
  constexpr auto moduli = std::to_array<std::pair<std::string_view, ObservedModulus>>({{"G", ObservedModulus::shear},
                                                                                       {"K", ObservedModulus::bulk},
                                                                                       {"E", ObservedModulus::young},
                                                                                       {"M", ObservedModulus::p_wave}});
  for (const auto& [symbol, modulus] : moduli) {
    all.push_back({std::string(symbol), modulus, ObservedCurve::relaxation, ConditionForm::modulus});
    all.push_back({fmt::format("{}'", symbol), modulus, ObservedCurve::storage, ConditionForm::modulus});
    all.push_back({fmt::format("{}''", symbol), modulus, ObservedCurve::loss, ConditionForm::modulus});
    all.push_back({fmt::format("|{}*|", symbol), modulus, ObservedCurve::absolute, ConditionForm::modulus});
  }
  all.push_back({"tan_delta", ObservedModulus::shear, ObservedCurve::phase, ConditionForm::tangent});
  all.push_back({"phase", ObservedModulus::shear, ObservedCurve::phase, ConditionForm::angle});
  return all;
}

NamedQuantity quantity_named(std::string_view name) {
  std::vector<std::string> names;
  for (auto& one : quantities()) {
    if (one.name == name) return std::move(one);
    names.push_back(one.name);
  }
  throw InputError(fmt::format("unknown quantity \"{}\"{}", name, suggestion(name, names)));
}

/// The positive value of a text. Throws InputError.
double positive(std::string_view text, Dimension dimension) {
  const double value = parse_quantity(text, dimension);
  if (accepts(Range::positive(), value)) return value;
  throw InputError(fmt::format("expected {}, got \"{}\"", described(Range::positive(), dimension), text));
}

/// The text with ' in place of the primes that pages and papers have.
std::string with_plain_primes(std::string text) {
  for (const auto& [prime, plain] : {std::pair("″", "''"), std::pair("′", "'")}) {
    for (auto at = text.find(prime); at != std::string::npos; at = text.find(prime)) {
      text.replace(at, std::string_view(prime).size(), plain);
    }
  }
  return text;
}

double place_of(const NamedQuantity& quantity, std::string_view text) {
  if (!is_over_frequency(quantity.curve)) return positive(text, Dimension::time);
  return 2.0 * std::numbers::pi * positive(text, Dimension::frequency);
}

double value_of(const NamedQuantity& quantity, const std::string& text) {
  if (quantity.form == ConditionForm::modulus) return positive(text, Dimension::pressure);
  if (quantity.form == ConditionForm::tangent) {
    const auto tangent = split_quantity(text);
    if (tangent && tangent->unit.empty() && tangent->number > 0.0) return std::atan(tangent->number);
    throw InputError(fmt::format("expected a positive number, got \"{}\"", text));
  }
  const double angle = positive(text, Dimension::angle);
  if (angle < 0.5 * std::numbers::pi) return angle;
  throw InputError(fmt::format("expected an angle between 0 and 90 deg, got \"{}\"", text));
}

}  // namespace

Condition read_condition(const std::string& written) {
  const auto text = with_plain_primes(written);
  const auto opening = text.find('('), closing = text.find(')'), sign = text.find('=');
  const bool is_whole = opening < closing && closing < sign && sign != std::string::npos &&
                        detail::trimmed(text.substr(closing + 1, sign - closing - 1)).empty();
  if (!is_whole) {
    throw InputError(
        fmt::format(R"(expected a condition such as "G(1 ms) = 3 GPa" or "tan_delta(10 Hz) = 0.3", got "{}")", text));
  }
  const std::string whole(detail::trimmed(text.substr(0, closing + 1)));
  const std::string name(detail::trimmed(text.substr(0, opening)));
  const std::string place(detail::trimmed(text.substr(opening + 1, closing - opening - 1)));
  const std::string value(detail::trimmed(text.substr(sign + 1)));
  const auto quantity = quantity_named(name);
  try {
    return {.quantity = whole,
            .form = quantity.form,
            .wanted = {.modulus = quantity.modulus,
                       .curve = quantity.curve,
                       .at = place_of(quantity, place),
                       .value = value_of(quantity, value)}};
  } catch (const InputError& error) {
    throw InputError(fmt::format("\"{}\": {}", text, error.what()));
  }
}

double as_written(const Condition& condition, double observed) {
  return condition.form == ConditionForm::tangent ? std::tan(observed) : observed;
}

std::string_view unit_of(const Condition& condition) {
  if (condition.form == ConditionForm::modulus) return "Pa";
  return condition.form == ConditionForm::angle ? "rad" : "";
}

std::string value_in_words(const Condition& condition, double value) {
  if (condition.form == ConditionForm::modulus) return display(value, "Pa");
  if (condition.form == ConditionForm::tangent) return three_digits(value);
  return fmt::format("{} deg", three_digits(value * 180.0 / std::numbers::pi));
}

}  // namespace breccia
