#include "result_place.hpp"

#include <string>
#include <utility>

#include "breccia/error.hpp"
#include "breccia/results/provenance.hpp"

#include "first_process.hpp"
#include "result_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

/// The directory that the first process of a group chooses, for all of them, or the InputError that it throws.
template <class Choose>
fs::path chosen_by_first(const Choose& choose) {
  constexpr char is_chosen = '+', is_refused = '-';
  std::string answer;
  if (parallel::rank() == 0) {
    try {
      answer = is_chosen + choose().string();
    } catch (const InputError& error) {
      answer = is_refused + std::string(error.what());
    }
  }
  answer = parallel::text_of_first(answer);
  if (answer.front() == is_refused) throw InputError(answer.substr(1));
  return answer.substr(1);
}

/// A study without a hash could not be told from others.
void require_hash(const Study& study) {
  if (!study.provenance.hash.empty()) return;
  throw InputError(
      "this study does not come from a deck, so that its results could not be told from those of others: read it by "
      "read_study, give it a provenance with a hash, or solve it in the memory");
}

}  // namespace

ResultPlace::ResultPlace(const Study& study, fs::path directory, const std::function<fs::path()>& choose)
    : study_(study),
      directory_(std::move(directory)),
      place_(chosen_by_first([&] {
        require_hash(study);
        lock_.emplace(directory_);
        return choose();
      })),
      directory_if_empty_(directory_),
      place_if_empty_(place_) {
  // Whoever goes on from the first packing can be told by it what differs.
  write_once([&] {
    if (!fs::exists(place_ / "study.json")) write_provenance(place_, study, {});
  });
}

void ResultPlace::commit() const {
  write_once([&] { put_in_place(study_, place_, directory_); });
}

}  // namespace breccia
