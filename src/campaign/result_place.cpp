#include "campaign/result_place.hpp"

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "breccia/error.hpp"

#include "campaign/result_directory.hpp"
#include "io/conflicting_results.hpp"
#include "parallel/common_failure.hpp"
#include "parallel/session.hpp"
#include "results/provenance.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

/// The first letter of the text that the first process sends to the other processes. It says whether the text is a
/// directory or an error with more than a message.
constexpr char is_chosen = '+', is_in_use = '!', is_conflict = 'o';

std::string as_text(const std::vector<ResultConflict>& conflicts) {
  auto json = nlohmann::json::array();
  for (const auto& [problem, remedy, free_directory] : conflicts) {
    json.push_back({problem, static_cast<int>(remedy), free_directory});
  }
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::vector<ResultConflict> conflicts_in(const std::string& text) {
  std::vector<ResultConflict> conflicts;
  for (const auto& json : nlohmann::json::parse(text)) {
    conflicts.push_back({json[0].get<std::string>(), static_cast<ResultConflict::Remedy>(json[1].get<int>()),
                         json[2].get<std::string>()});
  }
  return conflicts;
}

/// Throws the error whose text this is, if it is one.
void refuse_if_error(const std::string& answer) {
  const auto message = answer.substr(1);
  if (answer.front() == is_in_use) throw DirectoryInUse(message);
  if (answer.front() == is_conflict) throw ConflictingResults(conflicts_in(message));
}

/// The directory that the first process of a group chooses, on all processes of the group, or its error.
template <class Choose>
fs::path chosen_by_first(const Choose& choose) {
  std::string answer;
  parallel::done_by_first([&] {
    try {
      answer = is_chosen + choose().string();
    } catch (const DirectoryInUse& error) {
      answer = is_in_use + std::string(error.what());
    } catch (const ConflictingResults& error) {
      answer = is_conflict + as_text(error.conflicts());
    }
  });
  answer = parallel::text_of_first(answer);
  refuse_if_error(answer);
  return answer.substr(1);
}

}  // namespace

ResultPlace::ResultPlace(const Study& study, fs::path directory, const std::function<fs::path()>& choose)
    : study_(study),
      directory_(std::move(directory)),
      place_(chosen_by_first([&] {
        lock_.emplace(directory_);
        return choose();
      })),
      directory_without_result_(directory_),
      place_without_result_(place_) {
  // A later run needs the record to report differences, even if this one ends in its first packing.
  parallel::done_by_first([&] {
    if (!fs::exists(place_ / "study.json")) write_provenance(place_, study, {});
  });
}

void ResultPlace::commit() const {
  parallel::done_by_first([&] { put_in_place(study_, place_, directory_); });
}

}  // namespace breccia
