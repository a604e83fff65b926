#include "breccia/deck/read_study.hpp"

#include <algorithm>

#include "deck/resolved_study.hpp"
#include "deckfile/deck.hpp"

namespace breccia {
namespace {

Study study_of(const Deck& document, const std::vector<std::string>& overrides) {
  auto study = resolve(document);
  document.finish();
  add_hashes(document, overrides, study);
  return study;
}

}  // namespace

Study read_study(const std::filesystem::path& deck, const std::vector<std::string>& overrides,
                 const ValueOrigins& origins) {
  return study_of(Deck(deck, overrides, origins), overrides);
}

Study study_from_text(const std::string& deck, const std::filesystem::path& directory,
                      const std::vector<std::string>& overrides, const ValueOrigins& origins) {
  constexpr auto name = "study";
  const auto document = Deck::from_text(deck, name, directory, overrides, origins);
  auto study = study_of(document, overrides);
  study.provenance.deck = name;
  std::erase(study.provenance.inputs, document.path());  // no file
  return study;
}

}  // namespace breccia
