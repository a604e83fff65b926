#include "tables/column_meaning.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include <fmt/ranges.h>

#include "io/lower_case.hpp"
#include "io/trimmed.hpp"
#include "tables/csv_records.hpp"

namespace breccia::detail {

namespace {

using enum Quantity;

struct Stem {
  std::string_view text;
  Quantity quantity;
  ModulusKind kind = ModulusKind::unspecified;
  bool counts_cycles = false;
};

/// Names of quantities, in lower case.
constexpr std::array<Stem, 62> stems{{
    {"time", time},
    {"relaxation time", relaxation_time},
    {"tau", relaxation_time},
    {"storage", storage_modulus},
    {"loss", loss_modulus},
    {"angular frequency", angular_frequency},
    {"angular freq", angular_frequency},
    {"ang. frequency", angular_frequency},
    {"ang. freq", angular_frequency},
    {"omega", angular_frequency},
    {"frequency", angular_frequency, ModulusKind::unspecified, true},
    {"freq", angular_frequency, ModulusKind::unspecified, true},
    {"freq.", angular_frequency, ModulusKind::unspecified, true},
    {"temperature", temperature},
    {"temp", temperature},
    {"temp.", temperature},
    {"diameter", diameter},
    {"size", diameter},
    {"particle size", diameter},
    {"sieve", diameter},
    {"sieve size", diameter},
    {"sieve opening", diameter},
    {"cumulative volume fraction", cumulative_volume_fraction},
    {"passing", cumulative_volume_fraction},
    {"cumulative passing", cumulative_volume_fraction},
    {"weight", weight},
    {"film share", film_share},
    {"filler", filler},
    {"axis 1", axis_1},
    {"axis 2", axis_2},
    {"axis 3", axis_3},
    {"azimuth", azimuth},
    {"elevation", elevation},
    {"roll", roll},
    {"angle", angle},
    {"particle", particle},
    {"oscillation frequency", angular_frequency, ModulusKind::unspecified, true},
    {"shift factor", shift_factor},
    {"log10 shift factor", log10_shift_factor},
    {"log shift factor", log10_shift_factor},
    {"at", shift_factor},
    {"a t", shift_factor},
    {"log at", log10_shift_factor},
    {"log a t", log10_shift_factor},
    {"log10 at", log10_shift_factor},
    {"log10 a t", log10_shift_factor},
    {"phase", phase_angle},
    {"phase angle", phase_angle},
    {"phase shift", phase_angle},
    {"phase shift angle", phase_angle},
    {"phase lag", phase_angle},
    {"loss angle", phase_angle},
    {"delta", phase_angle},
    {"tan delta", loss_tangent},
    {"tan δ", loss_tangent},
    {"tan d", loss_tangent},
    {"tandelta", loss_tangent},
    {"tanδ", loss_tangent},
    {"loss factor", loss_tangent},
    {"loss factor tan delta", loss_tangent},
    {"loss factor tan δ", loss_tangent},
    {"damping factor", loss_tangent},
}};

/// Symbols of quantities, which are case-sensitive.
constexpr std::array<Stem, 31> symbols{{
    {"t", time},
    {"T", temperature},
    {"f", angular_frequency, ModulusKind::unspecified, true},
    {"ω", angular_frequency},
    {"x", x},
    {"y", y},
    {"z", z},
    {"G", modulus, ModulusKind::shear},
    {"E", modulus, ModulusKind::young},
    {"K", modulus, ModulusKind::bulk},
    {"J", compliance, ModulusKind::shear},
    {"D", compliance, ModulusKind::young},
    {"G'", storage_modulus, ModulusKind::shear},
    {"E'", storage_modulus, ModulusKind::young},
    {"K'", storage_modulus, ModulusKind::bulk},
    {"G''", loss_modulus, ModulusKind::shear},
    {"E''", loss_modulus, ModulusKind::young},
    {"K''", loss_modulus, ModulusKind::bulk},
    {"τ", relaxation_time},
    {"Ts", temperature},
    {"M'", storage_modulus},
    {"M''", loss_modulus},
    {"δ", phase_angle},
    {"M*", absolute_modulus},
    {"|M*|", absolute_modulus},
    {"G*", absolute_modulus, ModulusKind::shear},
    {"E*", absolute_modulus, ModulusKind::young},
    {"K*", absolute_modulus, ModulusKind::bulk},
    {"|G*|", absolute_modulus, ModulusKind::shear},
    {"|E*|", absolute_modulus, ModulusKind::young},
    {"|K*|", absolute_modulus, ModulusKind::bulk},
}};

/// Names that other words may precede, as in "shear storage modulus"; a longer name comes before its own ending.
constexpr std::array<Stem, 5> moduli{{
    {"storage modulus", storage_modulus},
    {"loss modulus", loss_modulus},
    {"modulus", modulus},
    {"compliance", compliance},
    {"loss tangent", loss_tangent},
}};

std::string with_replaced(std::string_view text, std::string_view from, std::string_view to) {
  std::string result;
  for (auto at = text.find(from); at != std::string_view::npos; at = text.find(from)) {
    result += text.substr(0, at);
    result += to;
    text.remove_prefix(at + from.size());
  }
  result += text;
  return result;
}

/// The words of a name, with primes of any kind replaced by apostrophes.
std::vector<std::string> words_of(std::string_view stem) {
  std::string text(stem);
  for (const auto* prime : {"′", "’", "´"}) text = with_replaced(text, prime, "'");
  for (const auto* double_prime : {"″", "”", "\""}) text = with_replaced(text, double_prime, "''");
  std::vector<std::string> words(1);
  for (const char letter : text) {
    const bool is_space = letter == ' ' || letter == '_' || letter == '-' || letter == '\t';
    if (!is_space) {
      words.back() += letter;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

const Stem* symbol_of(const std::string& word) {
  const auto* found = std::ranges::find(symbols, word, &Stem::text);
  return found == symbols.end() ? nullptr : found;
}

bool has_one_of(const std::vector<std::string>& words, std::span<const std::string_view> wanted) {
  return std::ranges::any_of(words, [&](const auto& word) { return std::ranges::find(wanted, word) != wanted.end(); });
}

/// Whether the words before "modulus" denote another quantity than a modulus, as in "log modulus".
bool say_something_else(const std::vector<std::string>& words) {
  constexpr std::array<std::string_view, 8> others{"log",        "log10",      "lg",       "ln",
                                                   "normalised", "normalized", "relative", "error"};
  return has_one_of(words, others);
}

/// Whether the words before "modulus" mean the absolute value of a complex modulus: instruments write "complex
/// modulus", the standards of asphalt and rubber "dynamic modulus".
bool say_absolute_value(const std::vector<std::string>& words) {
  constexpr std::array<std::string_view, 3> signs{"complex", "dynamic", "absolute"};
  return has_one_of(words, signs);
}

ModulusKind kind_of_words(const std::vector<std::string>& words) {
  for (const auto& word : words) {
    if (const auto kind = kind_of_word(word)) return *kind;
  }
  return ModulusKind::unspecified;
}

std::optional<Stem> modulus_in_words(const std::vector<std::string>& words) {
  const auto text = fmt::format(" {}", fmt::join(words, " "));
  for (const auto& known : moduli) {
    if (!text.ends_with(fmt::format(" {}", known.text))) continue;
    if (say_something_else(words)) return std::nullopt;
    const bool is_absolute = known.quantity == modulus && say_absolute_value(words);
    if (known.quantity == compliance && say_absolute_value(words)) return std::nullopt;
    return Stem{known.text, is_absolute ? absolute_modulus : known.quantity, kind_of_words(words)};
  }
  return std::nullopt;
}

/// The known name that consists of these words in upper or lower case; a null pointer if there is none.
const Stem* known_stem(const std::vector<std::string>& words) {
  const auto* found = std::ranges::find(stems, lower_case(fmt::format("{}", fmt::join(words, " "))), &Stem::text);
  return found == stems.end() ? nullptr : found;
}

/// The meaning of a name without its unit.
std::optional<Stem> stem_of(std::string_view text) {
  if (text.find_first_of(",;[](){}=/") != std::string_view::npos) return std::nullopt;
  auto words = words_of(text);
  if (words.empty()) return std::nullopt;
  const auto* symbol = symbol_of(words.back());
  if (symbol != nullptr && words.size() == 1) return *symbol;
  if (const auto* known = known_stem(words)) return *known;
  if (symbol != nullptr) words.pop_back();  // as in "Storage modulus G'"
  const auto* known = known_stem(words);
  for (auto& word : words) word = lower_case(std::move(word));
  auto stem = known != nullptr ? std::optional(*known) : modulus_in_words(words);
  if (symbol == nullptr || !stem) return stem;
  if (stem->quantity != symbol->quantity) return std::nullopt;
  if (stem->kind == ModulusKind::unspecified) stem->kind = symbol->kind;
  return stem;
}

/// Removes the argument of a symbol: "G(t) [MPa]" becomes "G [MPa]", "log(aT)" becomes "log aT", "Tan(delta)" "Tan
/// delta", and "Storage modulus (E')/MPa" "Storage modulus  E'/MPa".
std::string without_argument(std::string_view name) {
  std::string text(name);
  for (const auto* logarithm : {"log", "log10", "Log", "Log10"}) {
    for (const auto* factor : {"aT", "a_T"}) {
      if (text == fmt::format("{}({})", logarithm, factor)) return fmt::format("{} {}", logarithm, factor);
    }
  }
  for (const auto* argument : {"(t)", "(ω)", "(omega)", "(f)"}) text = with_replaced(text, argument, "");
  for (const auto* angle : {"delta", "Delta", "δ", "d"}) {
    for (const auto* tangent : {"tan", "Tan", "TAN"}) {
      text = with_replaced(text, fmt::format("{}({})", tangent, angle), fmt::format("{} {}", tangent, angle));
    }
  }
  for (const auto& symbol : symbols) {
    if (symbol.text.find_first_of("'*") == std::string_view::npos) continue;
    text = with_replaced(text, fmt::format("({})", symbol.text), fmt::format(" {}", symbol.text));
  }
  return text;
}

struct StemAndUnit {
  std::string_view stem, unit;
};

/// Name and unit in brackets: "Temp [°C]", "time (s)".
std::optional<StemAndUnit> split_at_bracket(std::string_view name) {
  if (!name.ends_with(']') && !name.ends_with(')')) return std::nullopt;
  const auto opening = name.find(name.ends_with(']') ? '[' : '(');
  if (opening == std::string_view::npos) return std::nullopt;
  return StemAndUnit{trimmed(name.substr(0, opening)), trimmed(name.substr(opening + 1, name.size() - opening - 2))};
}

std::optional<ColumnMeaning> meaning_of(const StemAndUnit& parts) {
  const auto stem = stem_of(parts.stem);
  if (!stem) return std::nullopt;
  return ColumnMeaning{stem->quantity, stem->kind, stem->counts_cycles, std::string(parts.unit)};
}

/// Name and unit after a slash or a comma: "time / s", "Frequency, Hz", "omega/(rad/s)".
std::optional<ColumnMeaning> meaning_by_sign(std::string_view name) {
  const auto sign = name.find_first_of("/,");
  if (sign == std::string_view::npos) return std::nullopt;
  auto unit = trimmed(name.substr(sign + 1));
  if (unit.starts_with('(') && unit.ends_with(')')) unit = unit.substr(1, unit.size() - 2);
  return meaning_of({trimmed(name.substr(0, sign)), unit});
}

/// Name and unit after an underscore or a space, with the longest possible name: "relaxation_time_s", "Temp °C".
std::optional<ColumnMeaning> meaning_by_words(std::string_view name) {
  auto end = name.find_last_of("_ ");
  while (end != std::string_view::npos && end > 0) {
    if (auto meaning = meaning_of({name.substr(0, end), name.substr(end + 1)})) return meaning;
    end = name.find_last_of("_ ", end - 1);
  }
  return std::nullopt;
}

}  // namespace

std::optional<ColumnMeaning> meaning_of(std::string_view name) {
  constexpr std::size_t longest = 200;
  if (name.size() > longest) return std::nullopt;
  const auto text = without_argument(name);
  // Sieve analyses have "% passing" and "percent passing [%]".
  for (const std::string_view percent : {"%", "percent "}) {
    if (!lower_case(text).starts_with(percent)) continue;
    const auto rest = trimmed(std::string_view(text).substr(percent.size()));
    const auto parts = split_at_bracket(rest);
    return meaning_of(StemAndUnit{parts && parts->unit == "%" ? parts->stem : rest, "%"});
  }
  if (auto meaning = meaning_of(StemAndUnit{trimmed(text), {}})) return meaning;
  const auto parts = split_at_bracket(text);
  auto in_brackets = parts ? meaning_of(*parts) : std::nullopt;
  if (in_brackets) return in_brackets;
  if (auto meaning = meaning_by_sign(text)) return meaning;
  return meaning_by_words(text);
}

namespace {

/// The kind of modulus by the symbol in a name, which may be in another language: "Speichermodul E' [MPa]".
ModulusKind kind_in(std::string_view name) {
  const auto parts = split_at_bracket(name);
  for (const auto& word : words_of(parts ? parts->stem : name.substr(0, name.find('/')))) {
    if (const auto* symbol = symbol_of(word); symbol != nullptr && symbol->kind != ModulusKind::unspecified) {
      return symbol->kind;
    }
  }
  return ModulusKind::unspecified;
}

}  // namespace

bool is_choice_of(const ColumnChoice& choice, std::string_view name) {
  if (name.empty()) return false;
  if (choice.name == name) return true;
  const auto of_choice = split_at_bracket(choice.name), of_column = split_at_bracket(name);
  return (of_choice && of_choice->stem == name) || (of_column && of_column->stem == choice.name);
}

std::optional<ColumnMeaning> meaning_of(std::string_view name, std::span<const ColumnChoice> choices) {
  auto meaning = meaning_of(name);
  const auto chosen = std::ranges::find_if(choices, [&](const auto& choice) { return is_choice_of(choice, name); });
  if (chosen == choices.end()) {
    const bool is_taken =
        meaning && std::ranges::find(choices, meaning->quantity, &ColumnChoice::quantity) != choices.end();
    return is_taken ? std::nullopt : meaning;
  }
  const auto of_choice_itself = split_at_bracket(chosen->name);
  if (meaning && meaning->quantity == chosen->quantity && !of_choice_itself) return meaning;
  ColumnMeaning of_choice{
      chosen->quantity, meaning ? meaning->kind : kind_in(name), chosen->quantity == angular_frequency, {}};
  if (of_choice_itself) {
    of_choice.unit = std::string(of_choice_itself->unit);
  } else if (const auto parts = split_at_bracket(name)) {
    of_choice.unit = std::string(parts->unit);
  } else if (const auto sign = name.find('/'); sign != std::string_view::npos) {
    of_choice.unit = std::string(trimmed(name.substr(sign + 1)));
  } else if (meaning) {
    of_choice.unit = meaning->unit;
  }
  return of_choice;
}

}  // namespace breccia::detail
