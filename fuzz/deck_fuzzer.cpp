// A deck, with its sweep, and the data files that it names among those of fuzz/data.

#include "input_folder.hpp"
#include "refusal.hpp"
#include "study_reading.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {  // NOLINT(*-naming)
  using namespace breccia::fuzz;
  static const InputFolder folder;
  const auto deck = folder.written("deck.toml", text_of(data, size));
  allow_refusal([&] { read_deck(deck); });
  return 0;
}
