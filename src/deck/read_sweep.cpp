#include "breccia/deck/read_sweep.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "deck/packing.hpp"
#include "deck/resolved_study.hpp"
#include "deck/sweep_keys.hpp"
#include "deck/sweep_names.hpp"
#include "deckfile/deck.hpp"
#include "io/safe_name.hpp"

namespace breccia {

namespace {

std::vector<SweptKey> swept_keys(const std::vector<KeyValues>& keys, std::vector<Mistake>& mistakes) {
  std::vector<std::string> paths;
  paths.reserve(keys.size());
  for (const auto& key : keys) paths.push_back(key.path);
  const auto labels = labels_of_keys(paths);
  std::vector<SweptKey> swept;
  for (const auto& [path, location, values] : keys) {
    const auto steps = split_path(path);
    if (steps && steps->front() == "sweep") mistakes.push_back({location, "a sweep cannot sweep itself"});
    swept.push_back({path, labels[swept.size()], steps && steps->back() == "seed"});
  }
  return swept;
}

/// For each task the index of the value of each key; the last key runs fastest.
std::vector<std::vector<std::size_t>> combinations(const std::vector<KeyValues>& keys) {
  std::vector<std::vector<std::size_t>> all(1);
  for (const auto& key : keys) {
    std::vector<std::vector<std::size_t>> longer;
    for (const auto& choice : all) {
      for (std::size_t i = 0; i < key.values.size(); ++i) {
        longer.push_back(choice);
        longer.back().push_back(i);
      }
    }
    all = std::move(longer);
  }
  return all;
}

/// Whether the key stands for the seeds of all packings.
bool is_every_seed(const std::string& path) {
  return split_path(path) == std::vector<std::string>{"stages", "*", "packing", "seed"};
}

/// The paths that a key stands for in a deck. The key for the seeds of all packings stands for the random packings
/// only, since regular and explicit packings have no seed.
std::vector<std::string> paths_of(const KeyValues& key, const Deck& deck, std::vector<Mistake>& mistakes) {
  if (!is_every_seed(key.path)) return {key.path};
  const auto unread = deck.unread_copy();
  std::vector<std::string> paths;
  std::size_t stages = 0;
  for (const auto& stage : unread.root().sections("stages")) {
    const bool has_seed = stage.kind("packing") == Kind::table && takes_seed(stage.section("packing"));
    if (has_seed) paths.push_back(fmt::format("stages.{}.packing.seed", stages));
    ++stages;
  }
  if (paths.empty()) mistakes.push_back({key.location, "no stage has a random packing, which alone takes a seed"});
  return paths.size() == stages ? std::vector{key.path} : paths;
}

/// Sets the values of a task in a deck, and reports keys that would replace the value of another key. Returns the
/// values as overrides, `key.path=value`.
std::vector<std::string> set_values(Deck& deck, const std::vector<KeyValues>& keys,
                                    const std::vector<std::size_t>& choice, std::vector<Mistake>& mistakes) {
  std::set<std::string> taken;
  std::vector<std::string> overrides;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto& [path, location, values] = keys[i];
    for (const auto& meant : paths_of(keys[i], deck, mistakes)) {
      for (const auto& replaced : deck.set({meant, location, values[choice[i]]})) {
        if (!taken.insert(replaced).second) mistakes.push_back({location, fmt::format("{} is swept twice", replaced)});
      }
      overrides.push_back(fmt::format("{}={}", meant, toml_text(values[choice[i]].value)));
    }
  }
  return overrides;
}

/// The cell sizes and gaps that the tasks have in a stage whose gap depends on the grid.
struct FollowingGap {
  std::set<double> cell_sizes, gaps;  // [m]
};

/// Adds warnings to stages whose gap depends on the grid if the grid differs between tasks.
void warn_of_gaps_on_grids(Sweep& sweep) {
  const auto follows = [](const Stage& stage) {
    return std::ranges::find(stage.fillers, GapSource::points, &Filler::gap_source) != stage.fillers.end();
  };
  std::map<std::string, FollowingGap> found;
  for (const auto& task : sweep.tasks) {
    for (const auto& stage : task.study.stages) {
      if (!follows(stage)) continue;
      found[stage.name].cell_sizes.insert(stage.cell_size());
      for (const auto& filler : stage.fillers) {
        if (filler.gap_source == GapSource::points) found[stage.name].gaps.insert(filler.gap);
      }
    }
  }
  for (auto& task : sweep.tasks) {
    for (const auto& stage : task.study.stages) {
      if (!follows(stage) || found[stage.name].cell_sizes.size() < 2) continue;
      const auto& gaps = found[stage.name].gaps;
      task.study.provenance.warnings[stage.name].push_back(fmt::format(
          "the gap between particles is given in points and follows the grids of this sweep, from {} to {}: its tasks "
          "differ in their material, too; give it as a length",
          readable(*gaps.begin(), Dimension::length), readable(*gaps.rbegin(), Dimension::length)));
    }
  }
}

}  // namespace

Sweep read_sweep(const std::filesystem::path& deck, const std::vector<std::string>& overrides,
                 const std::vector<std::string>& further_keys, const ValueOrigins& origins) {
  Deck document(deck, overrides, origins);
  for (const auto& key : further_keys) document.add("sweep", origins.sweep_keys, key);
  const auto keys = read_keys(document.root());
  document.root().accept_all_keys();  // unknown keys are reported by the tasks
  auto mistakes = document.mistakes();

  Sweep sweep;
  sweep.keys = swept_keys(keys, mistakes);
  sweep.overrides = overrides;
  std::vector<std::vector<std::string>> labels;
  for (const auto& key : keys) {
    std::vector<Scalar> values;
    for (const auto& value : key.values) values.push_back(value.value);
    labels.push_back(labels_of_values(values));
  }
  for (const auto& choice : combinations(keys)) {
    auto task_deck = document.unread_copy();
    const auto values = set_values(task_deck, keys, choice, mistakes);
    SweepTask task;
    task.study = resolve(task_deck);
    auto all_overrides = overrides;
    all_overrides.insert(all_overrides.end(), values.begin(), values.end());
    for (std::size_t i = 0; i < keys.size(); ++i) {
      task.values.push_back(keys[i].values[choice[i]].value);
      task.labels.push_back(fmt::format("{}-{}", sweep.keys[i].label, labels[i][choice[i]]));
    }
    task.name = fmt::format("{}", fmt::join(task.labels, "_"));
    if (task.name.size() > longest_name) {
      mistakes.push_back({keys.front().location, fmt::format("the name of a task, {}, has {} letters; at most {} are "
                                                             "possible, so sweep fewer keys or shorter values",
                                                             task.name, task.name.size(), longest_name)});
    }
    const auto mistakes_of_task = task_deck.mistakes();
    mistakes.insert(mistakes.end(), mistakes_of_task.begin(), mistakes_of_task.end());
    if (mistakes.empty()) add_hashes(task_deck, all_overrides, task.study);
    sweep.tasks.push_back(std::move(task));
  }
  refuse_mistakes(deck, mistakes);
  warn_of_gaps_on_grids(sweep);
  return sweep;
}

}  // namespace breccia
