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

/// The number of times that each value occurs in a list, the smallest value first.
std::vector<ValueCount> count_values(std::vector<std::int32_t> values) {
  std::ranges::sort(values);
  std::vector<ValueCount> counts;
  for (auto first = values.begin(); first != values.end();) {
    const auto last = std::upper_bound(first, values.end(), *first);
    counts.push_back({*first, static_cast<std::size_t>(last - first)});
    first = last;
  }
  return counts;
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

}  // namespace

std::vector<std::string> label_mistakes(std::span<const std::int32_t> values, std::span<const ValueLabel> table) {
  std::unordered_map<std::int32_t, bool> occurs;
  std::vector<std::string> mistakes;
  for (const auto& entry : table) {
    if (!occurs.emplace(entry.value, false).second) {
      mistakes.push_back(fmt::format("the value {} has two labels", entry.value));
    }
  }
  std::vector<std::int32_t> unlabelled;
  for (const auto value : values) {
    const auto labelled = occurs.find(value);
    if (labelled != occurs.end()) {
      labelled->second = true;
    } else {
      unlabelled.push_back(value);
    }
  }
  if (!unlabelled.empty()) {
    mistakes.push_back(
        fmt::format("values without a label: {}", list_of_values(count_values(std::move(unlabelled)), values.size())));
  }
  for (const auto& entry : table) {
    // A value that is in the table twice is reported once.
    if (!std::exchange(occurs[entry.value], true)) {
      mistakes.push_back(fmt::format("no pixel has the value {}", entry.value));
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
