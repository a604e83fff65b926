#include "result_place.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/safe_name.hpp"
#include "breccia/results/provenance.hpp"
#include "breccia/study/result_names.hpp"

#include "first_process.hpp"
#include "result_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

/// The directory that the first process of a group chooses, for all of them, or the InputError that it throws.
template <class Choose>
fs::path chosen_by_first(const Choose& choose) {
  constexpr char is_chosen = '+', is_refused = '-', is_in_use = '!';
  std::string answer;
  if (parallel::rank() == 0) {
    try {
      answer = is_chosen + choose().string();
    } catch (const DirectoryInUse& error) {
      answer = is_in_use + std::string(error.what());
    } catch (const InputError& error) {
      answer = is_refused + std::string(error.what());
    }
  }
  answer = parallel::text_of_first(answer);
  if (answer.front() == is_in_use) throw DirectoryInUse(answer.substr(1));
  if (answer.front() == is_refused) throw InputError(answer.substr(1));
  return answer.substr(1);
}

/// Names of stages become names of directories.
void require_names_of_directories(const Study& study) {
  const auto reserved = reserved_names();
  for (const auto& stage : study.stages) {
    if (is_safe_name(stage.name) && std::ranges::find(reserved, stage.name) == reserved.end()) continue;
    throw InputError(fmt::format("\"{}\" cannot be the name of a stage: it names a directory", stage.name));
  }
}

}  // namespace

ResultPlace::ResultPlace(const Study& study, fs::path directory, const std::function<fs::path()>& choose)
    : study_(study),
      directory_(std::move(directory)),
      place_(chosen_by_first([&] {
        require_names_of_directories(study);
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
