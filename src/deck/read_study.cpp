#include "breccia/deck/read_study.hpp"

#include "breccia/io/deck.hpp"

#include "resolved_study.hpp"

namespace breccia {

Study read_study(const std::filesystem::path& deck, const std::vector<std::string>& overrides) {
  const Deck document(deck, overrides);
  auto study = resolve(document);
  document.finish();
  add_hashes(document, overrides, study);
  return study;
}

}  // namespace breccia
