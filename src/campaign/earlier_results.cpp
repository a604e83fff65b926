#include "campaign/earlier_results.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "io/text_file.hpp"
#include "results/checksums.hpp"
#include "results/result_files.hpp"
#include "study/identity.hpp"
#include "study/result_names.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

bool is_among(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

void list_files(EarlierResults& earlier) {
  const auto& directory = earlier.directory;
  auto& names = earlier.own_files;
  // Without a record the files are known by their checksums.
  names = earlier.results.is_ours ? study_files_in(directory, earlier.results.stages) : unchanged_files(directory);
  earlier.has_lost_record = !earlier.results.is_ours && !names.empty();
  if (!earlier.holds_sweep) return;
  for (auto& name : sweep_files_in(directory)) {
    if (!is_among(names, name)) names.push_back(std::move(name));
  }
}

/// Takes a replacement that was interrupted as complete.
void anticipate_replacement(EarlierResults& earlier) {
  const auto replaced = files_of_replacement(earlier.directory, names_of_results());
  const bool is_complete = earlier.unfinished.is_complete_run_of(earlier.provenance);
  earlier.are_beside = replaced.empty() && is_complete;
  if (replaced.empty() && !is_complete) return;
  earlier.holds_sweep = earlier.holds_sweep && !is_complete && !is_among(replaced, "sweep.json");
  std::ranges::copy(replaced, std::back_inserter(earlier.own_files));
  if (!earlier.has_unfinished_record) return;
  earlier.results = std::exchange(earlier.unfinished, {});
  earlier.record = earlier.unfinished_place() / "study.json";
}

}  // namespace

EarlierResults::EarlierResults(const Study& one, fs::path place)
    : study(&one), provenance(provenance_of(one)), directory(std::move(place)) {}

void EarlierResults::read() {
  record = directory / "study.json";
  results = read_study_record(directory);
  unfinished = read_study_record(unfinished_place());
  has_unfinished_record = unfinished.is_ours;
  const auto sweep = directory / "sweep.json";
  holds_sweep = is_record_of_breccia(sweep);
  sweep_hash = holds_sweep ? content_hash(read_text(sweep)) : "";
  hashes = {results.text_hash, sweep_hash, unfinished.text_hash};
  std::erase(hashes, "");
  list_files(*this);
  anticipate_replacement(*this);
}

bool EarlierResults::has_left_unfinished(const std::string& name) const {
  if (!fs::is_regular_file(fs::symlink_status(unfinished_place() / name))) return false;
  return is_file_of_a_study(name) && (name != "study.json" || has_unfinished_record);
}

ResultNames names_of_results() {
  return {"study.json",
          [](std::string_view name) { return is_file_of_a_study(name) || is_among(files_of_a_sweep(), name); }};
}

}  // namespace breccia
