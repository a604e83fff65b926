#include "deck/resolved_study.hpp"

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "deck/amounts.hpp"
#include "deck/chosen_boxes.hpp"
#include "deck/materials.hpp"
#include "deck/measurements.hpp"
#include "deck/stage_defaults.hpp"
#include "deck/stages.hpp"
#include "deck/tests.hpp"
#include "deck/uncertain_materials.hpp"
#include "deckfile/deck.hpp"
#include "io/printable.hpp"
#include "io/seal.hpp"
#include "io/text_file.hpp"
#include "study/chain.hpp"
#include "study/identity.hpp"
#include "study/test_rules.hpp"

namespace breccia {

namespace {

/// A warning about inputs that are not certain, of which a study has one value each.
std::string warning_on_uncertain(const std::vector<UncertainInput>& inputs) {
  std::vector<std::string> names;
  names.reserve(inputs.size());
  for (const auto& input : inputs) names.push_back(input.name);
  return fmt::format("not certain: {}; these results are those with their medians, or with the first of their choices",
                     fmt::join(names, ", "));
}

}  // namespace

Study resolve(const Deck& document) {
  const auto root = document.root();
  Study study;
  study.title = root.optional_text("title").value_or(printable(document.path().stem().string()));
  study.provenance.deck = document.path();
  study.provenance.deck_text = document.text();
  study.materials = read_materials(root);
  const auto defaults = read_stage_defaults(root);
  study.stages = read_stages(root, study.materials, defaults);
  study.tests = read_tests(root, study.stages, defaults);
  const auto mixing = read_mixing(root);
  study.tests.mixing = mixing ? *mixing : default_mixing(study);
  study.measurements = read_measurements(root, study.materials, study.stages, study.tests);
  for (const auto& mistake : contradictions(study)) root.report("tests", mistake);
  const auto budget = read_budget(root, study);
  study.uncertain = document.uncertain_inputs();
  auto remarks = document.remarks();
  if (!study.uncertain.empty()) remarks.push_back(warning_on_uncertain(study.uncertain));
  if (!study.stages.empty() && !remarks.empty()) {
    auto& warnings = study.provenance.warnings[study.stages.front().name];
    warnings.insert(warnings.end(), remarks.begin(), remarks.end());
  }
  study.provenance.inputs = document.files();
  study.provenance.inputs.push_back(document.path());
  // A study is one task of a sweep: read_sweep makes the others.
  static_cast<void>(root.has("sweep"));
  if (document.mistakes().empty()) {
    vary_uncertain_materials(document, study);
    choose_missing_boxes(root, budget, study);
  }
  return study;
}

namespace {

/// The hash of a data file, which is read once for all tasks of a sweep.
std::string hash_of(const std::filesystem::path& file, FileCache& cache) {
  const auto key = fmt::format("hash of {}", file.string());
  const auto known = cache.find<std::string>(key);
  return known ? *known : *cache.keep(key, content_hash_of(file));
}

/// A hash for each data file. A single hash of all files would not change if a row moved from the end of one file to
/// the beginning of the next.
std::vector<FileHash> file_hashes_of(const Deck& document) {
  std::vector<FileHash> hashes;
  const auto directory = document.path().parent_path();
  for (const auto& file : document.files()) {
    hashes.push_back({file.lexically_proximate(directory).string(), hash_of(file, document.root().file_cache())});
  }
  return hashes;
}

std::string joined(const std::vector<FileHash>& files) {
  std::string hashes;
  for (const auto& [name, hash] : files) hashes += hash;
  return hashes;
}

std::vector<std::string> stage_hashes_of(const Deck& document, const Study& study) {
  constexpr std::array<std::string_view, 3> left_out = {"title", "measurements", "sweep"};
  const auto files = joined(study.provenance.file_hashes);
  std::vector<std::string> hashes;
  for (const auto& stage : study.stages) {
    auto content = document.content_with_first(hashes.size() + 1, "stages", left_out) + files;
    // A later stage that builds on this one adds loads to its tests.
    for (const auto load : loads_of(study, stage)) content += name_of(load);
    content += serves_as_matrix(study.stages, stage.name) ? "matrix" : "last";
    // The default boundaries and the default mixing depend on other stages, too.
    for (const auto boundary : study.tests.boundaries) content += name_of(boundary);
    if (study.tests.mixing == Mixing::flow) content += name_of(Mixing::flow);
    content += chosen_boxes(document.root(), study, hashes.size() + 1);
    content += fractions_by_amounts(document.root(), study, hashes.size() + 1);
    hashes.push_back(content_hash(content));
  }
  return hashes;
}

/// The loads, boundaries, boxes and grids that a deck does not name, which may differ from those of another version.
std::string default_tests_of(const Deck& document, const Study& study) {
  const auto tests = document.root().optional_section("tests");
  const auto is_named = [&](const char* key) { return tests && tests->has(key); };
  std::string names;
  for (const auto load : study.tests.loads) names += is_named("loads") ? "" : name_of(load);
  for (const auto boundary : study.tests.boundaries) names += is_named("boundaries") ? "" : name_of(boundary);
  return names + chosen_boxes(document.root(), study, study.stages.size());
}

}  // namespace

void add_hashes(const Deck& document, const std::vector<std::string>& overrides, Study& study) {
  const auto deck = document.content_without("sweep");
  study.provenance.overrides = overrides;
  study.provenance.deck_content_hash = content_hash(deck);
  study.provenance.file_hashes = file_hashes_of(document);
  study.provenance.hash = content_hash(deck + joined(study.provenance.file_hashes) + default_tests_of(document, study));
  study.provenance.stage_hashes = stage_hashes_of(document, study);
  study.provenance.content = content_of(study);
}

}  // namespace breccia
