#include "study_reading.hpp"

#include "breccia/deck/read_study.hpp"
#include "breccia/deck/read_sweep.hpp"

#include "cli/summary.hpp"
#include "deck/sweep_keys.hpp"
#include "deckfile/deck.hpp"
#include "sound_study.hpp"

/// The parser of UDUNITS-2 leaks the letters of a unit that it does not understand; the leak is suppressed. Leaks of
/// Breccia are still found.
extern "C" const char* __lsan_default_suppressions() {  // NOLINT(bugprone-reserved-identifier,*-naming)
  return "leak:utlex";
}

namespace breccia::fuzz {

namespace {

std::size_t tasks_of(const std::filesystem::path& deck, const std::vector<std::string>& overrides,
                     const std::vector<std::string>& swept) {
  Deck document(deck, overrides);
  for (const auto& key : swept) document.add("sweep", "--sweep", key);
  std::size_t tasks = 1;
  for (const auto& key : read_keys(document.root())) tasks *= key.values.size();
  return tasks;
}

}  // namespace

void look_through(const Study& study) {
  require_sound(study);
  static_cast<void>(cli::summary(study));
}

void read_deck(const std::filesystem::path& deck, const std::vector<std::string>& overrides,
               const std::vector<std::string>& swept) {
  // The largest number of tasks: the hundredth task of a sweep shows nothing that the tenth does not, and takes as
  // long.
  constexpr std::size_t most_tasks = 12;
  if (tasks_of(deck, overrides, swept) > most_tasks) return look_through(read_study(deck, overrides));
  for (const auto& task : read_sweep(deck, overrides, swept).tasks) look_through(task.study);
}

}  // namespace breccia::fuzz
