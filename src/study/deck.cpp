#include "breccia/study/deck.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/io/deck.hpp"
#include "breccia/io/text_file.hpp"

#include "deck_sections.hpp"

namespace breccia {

Study read_study(const std::filesystem::path& deck, const std::vector<std::string>& overrides) {
  const Deck document(deck, overrides);
  const auto root = document.root();
  Study study;
  study.title = root.optional_text("title").value_or(deck.stem().string());
  study.deck = deck;
  study.deck_text = document.text();
  study.overrides = overrides;
  study.materials = read_materials(root);
  study.stages = read_stages(root, study.materials);
  study.tests = read_tests(root);
  study.measurements = read_measurements(root, study.stages, study.tests);
  document.finish();
  auto content = fmt::format("{}\n{}", document.text(), fmt::join(overrides, "\n"));
  for (const auto& file : document.files()) content += read_text(file);
  study.hash = content_hash(content);
  return study;
}

}  // namespace breccia
