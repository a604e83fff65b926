#include "checkpoint/checkpoint.hpp"

#include <cstdint>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/file_status.hpp"
#include "io/seal.hpp"
#include "parallel/common_failure.hpp"
#include "parallel/reduction.hpp"
#include "parallel/session.hpp"

namespace breccia {
namespace {

constexpr auto finished_name = "/is_finished";

void require_owner(const std::filesystem::path& path, const StateOwner& found, const StateOwner& expected) {
  const auto refuse = [&](const std::string& difference) {
    throw InputError(
        fmt::format("{}: {}; take another directory, or start anew instead of resuming, which removes this file",
                    path.string(), difference));
  };
  if (found.version != expected.version) {
    refuse(fmt::format("saved by version {} of Breccia, this is version {}", found.version, expected.version));
  }
  if (found.deck_hash != expected.deck_hash) {
    refuse("saved by a run of another deck: a value, a seed, an override or a data file differs");
  }
}

/// Renames a damaged file, so that it is not kept as the older state.
void set_aside(const std::filesystem::path& path) {
  std::error_code is_gone;
  if (parallel::rank() == 0) std::filesystem::rename(path, path.string() + ".damaged", is_gone);
}

}  // namespace

Checkpoint::Checkpoint(std::filesystem::path path, StateOwner owner, CheckpointSchedule schedule)
    : path_(std::move(path)), owner_(std::move(owner)), schedule_(std::move(schedule)) {}

std::vector<std::string> Checkpoint::look_for_earlier() {
  std::vector<std::string> problems;
  std::vector<std::filesystem::path> damaged;
  double which = 0.0;
  parallel::do_together([&] {
    for (const auto& path : {path_, older_state(path_)}) {
      if (!std::filesystem::exists(status_of(path))) continue;
      try {
        earlier_.emplace(path);
      } catch (const DamagedFile& error) {
        problems.emplace_back(error.what());
        damaged.push_back(path);
        continue;
      }
      require_owner(path, earlier_->owner(), owner_);
      which = path == path_ ? 1.0 : 2.0;
      break;
    }
  });
  if (parallel::largest(which) != -parallel::largest(-which)) {
    throw FileError(fmt::format(
        "{}: not all processes see the same checkpoints; results must be on a disk that all share", path_.string()));
  }
  // Each process has looked at all files by now, so that they can be renamed.
  for (const auto& path : damaged) set_aside(path);
  const auto* instead = earlier_ ? "the previous checkpoint is used" : "this packing or test starts anew";
  for (auto& problem : problems) problem += fmt::format("; {}", instead);
  return problems;
}

bool Checkpoint::is_finished() const {
  return earlier_ && earlier_->integer(finished_name) != 0;
}

bool Checkpoint::is_due() {
  constexpr double save = 1.0, save_and_end = 2.0;
  double wish = 0.0;
  if (std::chrono::duration<double>(Clock::now() - last_).count() >= schedule_.interval) wish = save;
  if (schedule_.stop && schedule_.stop()) wish = save_and_end;
  wish = parallel::largest(wish);
  ends_ = wish == save_and_end;
  return wish > 0.0;
}

bool Checkpoint::is_to_end() {
  ends_ = parallel::largest(schedule_.stop && schedule_.stop() ? 1.0 : 0.0) > 0.0;
  return ends_;
}

void Checkpoint::put(const WriteState& write, bool is_finished) {
  StateWriter writer(path_, owner_);
  writer.write(finished_name, std::int64_t{is_finished});
  write(writer);
  // All processes wait: if one ended now, MPI would end the first one while it writes.
  parallel::do_together([&] { writer.commit(); });
  last_ = Clock::now();
}

void Checkpoint::save(const WriteState& write) {
  put(write, false);
  if (ends_) throw Interrupted("interrupted; the state is saved");
}

void Checkpoint::finish(const WriteState& write) {
  put(write, true);
  std::error_code ignored;
  if (parallel::rank() == 0) std::filesystem::remove(older_state(path_), ignored);
}

bool is_checkpoint_file(std::string_view name) {
  constexpr std::string_view damaged = ".damaged";
  if (name.ends_with(damaged)) name.remove_suffix(damaged.size());
  return name.ends_with(".checkpoint.h5") || name.ends_with(".checkpoint.older.h5");
}

}  // namespace breccia
