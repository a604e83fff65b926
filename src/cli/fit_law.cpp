#include "cli/fit_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "cli/command.hpp"
#include "io/units.hpp"

namespace breccia::cli {
namespace {

/// The dimension of a parameter; nothing for numbers.
std::optional<Dimension> dimension_of(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::modulus:
      return Dimension::pressure;
    case ParameterKind::compliance:
      return Dimension::compliance;
    case ParameterKind::time:
      return Dimension::time;
    case ParameterKind::number:
    case ParameterKind::exponent:
      break;
  }
  return std::nullopt;
}

const LawParameter& parameter_named(LawForm form, std::string_view key) {
  return *std::ranges::find(parameters_of(form), key, &LawParameter::key);
}

/// A value as in a deck, without the quotes of a quantity.
std::string value_text(const LawParameter& parameter, double value) {
  const auto dimension = dimension_of(parameter.kind);
  return dimension ? readable(value, *dimension) : fmt::format("{:.6g}", value);
}

/// A number; the word "inf" is left to the range of its parameter.
double number_of_option(const std::string& option, const std::string& text) {
  if (text == "inf") return std::numeric_limits<double>::infinity();
  if (const auto number = split_quantity(text); number && number->unit.empty()) return number->number;
  throw InputError(fmt::format("{}: expected a number, got \"{}\"", option, text));
}

std::string note_on(const FittedParameter& parameter) {
  switch (parameter.origin) {
    case ParameterOrigin::given:
      return "given";
    case ParameterOrigin::limit:
      return "the data are met as well without it";
    case ParameterOrigin::bound:
      return "the end of what is tried: the data ask for more, or do not show it";
    case ParameterOrigin::of_no_effect:
      return "at which `creep` holds; another time changes nothing but that";
    case ParameterOrigin::fitted:
      break;
  }
  if (!(parameter.standard_error < parameter.value))
    return "not determined by the data: --keep gives parameters values";
  return fmt::format("+- {:.2g} %", 100.0 * parameter.standard_error / parameter.value);
}

}  // namespace

GivenParameters kept_parameters(LawForm form, const std::vector<std::string>& options) {
  GivenParameters given;
  std::vector<std::string> mistakes, keys;
  for (const auto& parameter : parameters_of(form)) keys.emplace_back(parameter.key);
  for (const auto& text : options) {
    const auto sign = text.find('=');
    const auto key = text.substr(0, sign);
    try {
      if (sign == std::string::npos || std::ranges::find(keys, key) == keys.end()) {
        throw InputError(
            fmt::format("--keep: expected KEY=VALUE with one of {}, got \"{}\"", fmt::join(keys, ", "), text));
      }
      const auto option = fmt::format("--keep {}", key), value = text.substr(sign + 1);
      const auto dimension = dimension_of(parameter_named(form, key).kind);
      given.emplace_back(key, dimension ? option_quantity(option, value, *dimension) : number_of_option(option, value));
    } catch (const InputError& error) {
      mistakes.emplace_back(error.what());
    }
  }
  for (const auto& mistake : mistakes_in(form, given)) mistakes.push_back("--keep " + mistake);
  if (!mistakes.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes, "\n")));
  return given;
}

std::string law_for_deck(const LawFit& fit) {
  auto text = fmt::format("{{ law = \"{}\"", name_of(fit.form));
  for (const auto& [key, value, error, origin] : fit.parameters) {
    if (!std::isfinite(value)) continue;  // without a dashpot the key is left out
    const auto& parameter = parameter_named(fit.form, key);
    const auto quotes = dimension_of(parameter.kind) ? "\"" : "";
    text += fmt::format(", {} = {}{}{}", key, quotes, value_text(parameter, value), quotes);
  }
  return text + " }";
}

std::vector<ParameterInWords> parameters_in_words(const LawFit& fit) {
  std::vector<ParameterInWords> all;
  for (const auto& parameter : fit.parameters) {
    all.push_back({std::string(parameter.key), value_text(parameter_named(fit.form, parameter.key), parameter.value),
                   note_on(parameter)});
  }
  return all;
}

}  // namespace breccia::cli
