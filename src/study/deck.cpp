#include "breccia/study/deck.hpp"

#include <utility>

#include "breccia/io/deck.hpp"
#include "breccia/io/text_file.hpp"

#include "deck_sections.hpp"

namespace breccia {

Study resolve(const Deck& document) {
  const auto root = document.root();
  Study study;
  study.title = root.optional_text("title").value_or(document.path().stem().string());
  study.deck = document.path();
  study.deck_text = document.text();
  auto [materials, temperature_shifts] = read_materials(root);
  study.materials = std::move(materials);
  study.temperature_shifts = std::move(temperature_shifts);
  study.stages = read_stages(root, study.materials);
  study.tests = read_tests(root, study.stages);
  study.measurements = read_measurements(root, study.stages, study.tests);
  refuse_contradictions(root, study);
  study.inputs = document.files();
  study.inputs.push_back(study.deck);
  // A study is one task of a sweep: read_sweep makes the others.
  static_cast<void>(root.has("sweep"));
  return study;
}

std::string hash_of(const Deck& document) {
  auto content = document.content_without("sweep");
  for (const auto& file : document.files()) content += read_text(file);
  return content_hash(content);
}

Study read_study(const std::filesystem::path& deck, const std::vector<std::string>& overrides) {
  const Deck document(deck, overrides);
  auto study = resolve(document);
  document.finish();
  study.overrides = overrides;
  study.hash = hash_of(document);
  return study;
}

}  // namespace breccia
