#include "deck/film_bonds.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "study/limits.hpp"

namespace breccia {
namespace {

/// The numbers of two grains in a text such as "3-17".
std::optional<std::array<std::size_t, 2>> parse_pair(const std::string& text) {
  std::array<std::size_t, 2> pair{};
  const auto* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, pair[0]);
  if (first.ec != std::errc{} || first.ptr == end || *first.ptr != '-') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, pair[1]);
  return second.ec == std::errc{} && second.ptr == end ? std::optional(pair) : std::nullopt;
}

std::vector<std::array<std::size_t, 2>> read_pairs(const Section& section) {
  std::vector<std::array<std::size_t, 2>> pairs;
  for (const auto& [value, location] : section.scalars("films")) {
    const auto* text = std::get_if<std::string>(&value);
    const auto pair = text != nullptr ? parse_pair(*text) : std::nullopt;
    if (pair) {
      pairs.push_back(*pair);
    } else {
      section.report("films", fmt::format(R"(expected the numbers of two grains, from 0, such as "3-17", got {})",
                                          toml_text(value)));
    }
  }
  return pairs;
}

std::vector<double> read_normal(const Section& section, int dimensions) {
  if (!section.has("normal")) return {};
  section.refuse({"seed"}, "the films follow from the normal");
  const auto normal = section.numbers("normal");
  const bool has_length = std::ranges::any_of(normal, [](double component) { return component != 0.0; });
  if (normal.size() != static_cast<std::size_t>(dimensions) || !has_length) {
    section.report("normal", fmt::format("expected {} components, not all of them zero", dimensions));
  }
  return normal;
}

}  // namespace

void read_bonds(const Section& section, Stage& stage) {
  const auto table = section.optional_section("bonds");
  if (!table) return;
  FilmBonds bonds;
  bonds.kind = table->choice<Debonding>("kind").value_or(bonds.kind);
  const auto key = table->exactly_one({"debonded", "films"});
  if (key == "films") {
    table->refuse({"seed", "normal"}, "the films are listed");
    bonds.films = read_pairs(*table);
  } else {
    if (key == "debonded") bonds.debonded = table->fraction(key, allowed::debonded);
    bonds.normal = read_normal(*table, stage.dimensions());
    if (const auto seed = table->optional_integer("seed", Range::not_negative())) {
      bonds.seed = static_cast<std::uint64_t>(*seed);
    }
  }
  stage.bonds = std::move(bonds);
}

}  // namespace breccia
