#include "campaign/shared_stages.hpp"

#include <utility>

#include "campaign/sweep.hpp"

namespace breccia {

SharedStages::SharedStages(const Sweep& sweep) {
  for (const auto& task : sweep.tasks) {
    for (const auto& hash : task.study.provenance.stage_hashes) ++tasks_[hash];
  }
}

SharedStages::SharedStages(const Study& study, const std::vector<StageResult>& results, const std::string& task) {
  for (std::size_t i = 0; i < results.size(); ++i) {
    entries_[study.provenance.stage_hashes.at(i)] = {.result = results[i], .record = {.answered_from = task}};
  }
}

const SharedStages::Entry* SharedStages::find(const std::string& hash) const {
  const auto entry = entries_.find(hash);
  return entry == entries_.end() ? nullptr : &entry->second;
}

void SharedStages::keep(const std::string& hash, Entry entry) {
  const auto tasks = tasks_.find(hash);
  if (tasks != tasks_.end() && tasks->second > 1) entries_.insert_or_assign(hash, std::move(entry));
}

void SharedStages::move_files(const std::filesystem::path& from, const std::filesystem::path& to) {
  for (auto& [hash, entry] : entries_) {
    if (entry.directory.parent_path() == from) entry.directory = to / entry.directory.filename();
  }
}

}  // namespace breccia
