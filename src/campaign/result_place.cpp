#include "result_place.hpp"

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "breccia/error.hpp"
#include "breccia/io/foreign_results.hpp"
#include "breccia/results/provenance.hpp"

#include "first_process.hpp"
#include "result_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

/// The first letter of the text that the first process sends to the others: a directory, or the kind of an error.
constexpr char is_chosen = '+', is_in_use = '!', is_foreign = 'o', is_bad_input = 'i', is_numerical = 'n',
               is_of_files = 'f';

std::string as_text(const std::vector<Objection>& objections) {
  auto json = nlohmann::json::array();
  for (const auto& [problem, remedy, free_directory] : objections) {
    json.push_back({problem, static_cast<int>(remedy), free_directory});
  }
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::vector<Objection> objections_in(const std::string& text) {
  std::vector<Objection> objections;
  for (const auto& json : nlohmann::json::parse(text)) {
    objections.push_back(
        {json[0].get<std::string>(), static_cast<Objection::Remedy>(json[1].get<int>()), json[2].get<std::string>()});
  }
  return objections;
}

/// The kind of an error and its message.
std::string as_text(const Error& error) {
  if (dynamic_cast<const DirectoryInUse*>(&error) != nullptr) return is_in_use + std::string(error.what());
  if (const auto* const foreign = dynamic_cast<const ForeignResults*>(&error)) {
    return is_foreign + as_text(foreign->objections());
  }
  const char kind = error.exit_code() == ExitCode::bad_input           ? is_bad_input
                    : error.exit_code() == ExitCode::numerical_failure ? is_numerical
                                                                       : is_of_files;
  return kind + std::string(error.what());
}

/// Throws the error whose text this is, if it is one.
void refuse_if_error(const std::string& answer) {
  const auto message = answer.substr(1);
  switch (answer.front()) {
    case is_in_use:
      throw DirectoryInUse(message);
    case is_foreign:
      throw ForeignResults(objections_in(message));
    case is_bad_input:
      throw InputError(message);
    case is_numerical:
      throw NumericalError(message);
    case is_of_files:
      throw FileError(message);
    default:
      return;
  }
}

/// The directory that the first process of a group chooses, on all processes of the group, or its error: a process that
/// did not get the error would wait for the first one for ever.
template <class Choose>
fs::path chosen_by_first(const Choose& choose) {
  std::string answer;
  if (parallel::rank() == 0) {
    try {
      answer = is_chosen + choose().string();
    } catch (const Error& error) {
      answer = as_text(error);
    } catch (const fs::filesystem_error& error) {
      answer = is_of_files + std::string(error.what());
    }
  }
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
  write_once([&] {
    if (!fs::exists(place_ / "study.json")) write_provenance(place_, study, {});
  });
}

void ResultPlace::commit() const {
  write_once([&] { put_in_place(study_, place_, directory_); });
}

}  // namespace breccia
