#include "deck/film_bonds.hpp"

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "study/limits.hpp"
#include "study/stage_rules.hpp"

namespace breccia {
namespace {

/// Reads an integer and moves the text behind it, and behind the character that follows if it is this one.
template <class Integer>
bool take(std::string_view& text, Integer& number, char behind) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  if (!text.empty() && text.front() == behind) text.remove_prefix(1);
  return true;
}

/// Two grains in a text such as "3-17", or "3-17:0,-1" with an image of the second one.
std::optional<SitePair> parse_pair(std::string_view text, int dimensions) {
  SitePair pair;
  const auto dash = text.find('-');
  if (dash == std::string_view::npos || dash == 0) return std::nullopt;
  if (!take(text, pair.sites[0], '-')) return std::nullopt;
  const bool has_image = text.find(':') != std::string_view::npos;
  if (!take(text, pair.sites[1], ':')) return std::nullopt;
  while (!text.empty()) {
    if (!take(text, pair.image.emplace_back(), ',')) return std::nullopt;
  }
  const bool is_whole = has_image ? std::ssize(pair.image) == dimensions : pair.image.empty();
  return is_whole ? std::optional(pair) : std::nullopt;
}

std::vector<SitePair> read_pairs(const Section& section, int dimensions) {
  std::vector<SitePair> pairs;
  for (const auto& [value, location] : section.scalars("films")) {
    const auto* text = std::get_if<std::string>(&value);
    const auto pair = text != nullptr ? parse_pair(*text, dimensions) : std::nullopt;
    if (pair) {
      pairs.push_back(*pair);
    } else {
      section.report("films",
                     fmt::format(R"(expected two grains by their numbers from 0, such as "3-17", or "3-17:{}" for one )"
                                 "image of the second one alone, got {}",
                                 dimensions == 3 ? "0,-1,0" : "0,-1", toml_text(value)));
    }
  }
  return pairs;
}

std::vector<double> read_normal(const Section& section, int dimensions) {
  if (!section.has("normal")) return {};
  section.refuse({"seed"}, "the films follow from the normal");
  auto normal = section.numbers("normal");
  for (const auto& mistake : mistakes_of_normal(normal, dimensions)) section.report("normal", mistake);
  return normal;
}

}  // namespace

void read_bonds(const Section& section, Stage& stage) {
  const auto table = section.optional_section("bonds");
  if (!table) return;
  FilmBonds bonds;
  const auto kind = table->choice<Debonding>("kind");
  bonds.kind = kind.value_or(bonds.kind);
  if (bonds.kind == Debonding::spring) {
    bonds.springs = {
        .normal = table->quantity("normal_stiffness", Dimension::interface_stiffness, allowed::interface_stiffness),
        .tangential =
            table->quantity("tangential_stiffness", Dimension::interface_stiffness, allowed::interface_stiffness)};
  } else if (kind) {
    table->refuse({"normal_stiffness", "tangential_stiffness"}, R"(kind = "spring" alone has springs)");
  }
  const auto key = table->exactly_one({"debonded", "films"});
  if (key == "films") {
    table->refuse({"seed", "normal"}, "the films are listed");
    bonds.films = read_pairs(*table, stage.dimensions());
  } else {
    if (key == "debonded") bonds.debonded = table->fraction(key, allowed::debonded);
    bonds.normal = read_normal(*table, stage.dimensions());
    if (const auto seed = table->optional_integer("seed", Range::not_negative())) {
      bonds.seed = static_cast<std::uint64_t>(*seed);
    }
  }
  // Where nothing is debonded the stage is one without bonds.
  if (bonds.films.empty() && bonds.debonded == 0.0) return;
  stage.bonds = std::move(bonds);
}

}  // namespace breccia
