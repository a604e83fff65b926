#include "breccia/microstructure/pixel_labels.hpp"

#include <algorithm>
#include <functional>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

namespace breccia {

namespace {

struct ValueCount {
  std::int32_t value;
  std::size_t pixels;
};

/// How many pixels have each value, the smallest value first.
std::vector<ValueCount> count_values(std::span<const std::int32_t> values) {
  std::unordered_map<std::int32_t, std::size_t> counts;
  for (const auto value : values) ++counts[value];
  std::vector<ValueCount> sorted;
  sorted.reserve(counts.size());
  for (const auto& [value, pixels] : counts) sorted.push_back({value, pixels});
  std::ranges::sort(sorted, {}, &ValueCount::value);
  return sorted;
}

/// "7 (120 pixels, 1.2 %), 0 (3 pixels, 0.03 %)": the most frequent ones first.
std::string list_of_values(std::vector<ValueCount> counts, std::size_t pixels) {
  constexpr std::size_t most_listed = 10;
  std::ranges::stable_sort(counts, std::ranges::greater(), &ValueCount::pixels);
  std::vector<std::string> listed;
  for (const auto& count : std::span(counts).first(std::min(most_listed, counts.size()))) {
    const double share = 100.0 * static_cast<double>(count.pixels) / static_cast<double>(pixels);
    listed.push_back(
        fmt::format("{} ({} pixel{}, {:.3g} %)", count.value, count.pixels, count.pixels == 1 ? "" : "s", share));
  }
  if (counts.size() > most_listed) listed.push_back(fmt::format("and {} more", counts.size() - most_listed));
  return fmt::format("{}", fmt::join(listed, ", "));
}

bool has_value(std::span<const ValueCount> sorted, std::int32_t value) {
  return std::ranges::binary_search(sorted, value, {}, &ValueCount::value);
}

}  // namespace

std::vector<std::string> label_mistakes(std::span<const std::int32_t> values, std::span<const ValueLabel> table) {
  const auto found = count_values(values);
  auto unlabelled = found;
  std::erase_if(unlabelled, [&](const ValueCount& count) {
    return std::ranges::find(table, count.value, &ValueLabel::value) != table.end();
  });
  std::vector<std::string> mistakes;
  if (!unlabelled.empty()) {
    mistakes.push_back(fmt::format("values without a label: {}", list_of_values(unlabelled, values.size())));
  }
  for (auto entry = table.begin(); entry != table.end(); ++entry) {
    const auto is_same = [&](const ValueLabel& other) { return other.value == entry->value; };
    if (std::any_of(table.begin(), entry, is_same)) {
      mistakes.push_back(fmt::format("the value {} has two labels", entry->value));
    } else if (!has_value(found, entry->value)) {
      mistakes.push_back(fmt::format("no pixel has the value {}", entry->value));
    }
  }
  return mistakes;
}

std::vector<Label> pixel_labels(std::span<const std::int32_t> values, std::span<const ValueLabel> table) {
  if (const auto mistakes = label_mistakes(values, table); !mistakes.empty()) {
    throw InputError(fmt::format("image: {}", fmt::join(mistakes, "\nimage: ")));
  }
  std::unordered_map<std::int32_t, Label> label_of;
  for (const auto& [value, label] : table) label_of.emplace(value, label);
  std::vector<Label> labels(values.size());
  std::ranges::transform(values, labels.begin(), [&](std::int32_t value) { return label_of.at(value); });
  return labels;
}

}  // namespace breccia
