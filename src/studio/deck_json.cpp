#include "studio/deck_json.hpp"

#include <cmath>
#include <cstdint>
#include <variant>

#include <fmt/format.h>

#include "deckfile/deck_tree.hpp"

namespace breccia::studio {

namespace {

using Json = nlohmann::json;

/// A number in JSON, or its text if JSON has no such number.
Json finite_or_text(double number) {
  return std::isfinite(number) ? Json(number) : Json(fmt::format("{}", number));
}

Json node(const detail::DeckTable& table);
Json node(const detail::DeckValue& value);

/// What a node of each type has beyond its line.
struct NodeOfContent {
  Json operator()(bool value) const { return {{"type", "boolean"}, {"value", value}}; }
  Json operator()(std::int64_t value) const { return {{"type", "integer"}, {"value", value}}; }
  Json operator()(double value) const { return {{"type", "number"}, {"value", finite_or_text(value)}}; }
  Json operator()(const std::string& value) const { return {{"type", "text"}, {"value", value}}; }
  Json operator()(const detail::Date&) const { return {{"type", "date"}}; }
  Json operator()(const detail::DeckTable& table) const { return node(table); }
  Json operator()(const detail::DeckArray& array) const {
    auto items = Json::array();
    for (const auto& value : array.values) items.push_back(node(value));
    return {{"type", "array"}, {"items", std::move(items)}};
  }
};

Json node(const detail::DeckTable& table) {
  auto entries = Json::array();
  for (const auto& entry : table.entries) entries.push_back({{"key", entry.key}, {"value", node(entry.value)}});
  return {
      {"type", "table"}, {"line", table.location.line}, {"inline", table.is_inline}, {"entries", std::move(entries)}};
}

Json node(const detail::DeckValue& value) {
  auto json = std::visit(NodeOfContent(), value.content);
  json["line"] = value.location.line;
  return json;
}

}  // namespace

nlohmann::json deck_tree_json(const std::string& text) {
  return node(detail::parse_deck("deck", text));
}

}  // namespace breccia::studio
