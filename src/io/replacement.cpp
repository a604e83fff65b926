#include "breccia/io/replacement.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/io/empty_directory.hpp"
#include "breccia/io/file_status.hpp"
#include "breccia/io/partial_name.hpp"
#include "breccia/io/text_file.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

/// Lists in `unfinished`, with one name per line: the first exists while old files are removed, and has the record and
/// the old files; the second exists while new files are moved, and has the record.
constexpr auto removing_list = "removing.list";
constexpr auto moving_list = "moving.list";

/// Whether a relative name refers to something within its directory.
bool stays_within(const fs::path& name) {
  return !name.empty() && name.is_relative() && std::ranges::find(name, "..") == name.end();
}

/// The names in a list. Throws FileError if the list was not written by replace_results().
std::vector<std::string> names_in(const fs::path& list) {
  std::istringstream text(read_text(list));
  std::vector<std::string> names;
  for (std::string line; std::getline(text, line);) names.push_back(line);
  if (names.empty() || !std::ranges::all_of(names, stays_within)) {
    throw FileError(fmt::format("{}: not as Breccia writes it; remove it", list.string()));
  }
  return names;
}

/// Moves a file, also to another disk: a directory of results may be a symbolic link.
void move_file(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error == std::errc::cross_device_link) {
    copy_result(from, to);
    return remove_files(from.parent_path(), std::vector{from.filename().string()});
  }
  if (error) throw FileError(fmt::format("{}: cannot move it to {}: {}", from.string(), to.string(), error.message()));
}

/// Calls visit(path, whether it is a directory) for all that is below a directory. Links are not followed, since their
/// targets may be anywhere.
template <class Visit>
void visit_below(const fs::path& directory, const Visit& visit) {
  std::error_code error;
  fs::recursive_directory_iterator entry(directory, error);
  while (!error && entry != fs::recursive_directory_iterator()) {
    const auto status = fs::symlink_status(entry->path(), error);
    if (error) break;
    visit(entry->path(), fs::is_directory(status));
    entry.increment(error);
  }
  if (error) throw FileError(fmt::format("{}: cannot be listed: {}", directory.string(), error.message()));
}

/// All files and symbolic links below a directory, relative to it, without the lists and half-written files.
std::vector<std::string> files_below(const fs::path& directory) {
  std::vector<std::string> names;
  visit_below(directory, [&](const fs::path& path, bool is_directory) {
    auto name = path.lexically_relative(directory).string();
    if (is_directory || is_replacement_list(name) || is_partial_name(name)) return;
    names.push_back(std::move(name));
  });
  std::ranges::sort(names);
  return names;
}

/// All directories below a directory, each after its subdirectories.
std::vector<fs::path> directories_below(const fs::path& directory) {
  std::set<fs::path, std::greater<>> found;
  visit_below(directory, [&](const fs::path& path, bool is_directory) {
    if (is_directory) found.insert(path);
  });
  return {found.begin(), found.end()};
}

/// The directories of the files, each after its subdirectories.
std::vector<fs::path> parents_of(const fs::path& directory, std::span<const std::string> files) {
  std::set<fs::path, std::greater<>> parents;
  for (const auto& name : files) {
    for (auto parent = fs::path(name).parent_path(); !parent.empty(); parent = parent.parent_path()) {
      parents.insert(directory / parent);
    }
  }
  return {parents.begin(), parents.end()};
}

/// The first step: removes the old files, the record first.
void remove_old(const fs::path& directory) {
  const auto unfinished = directory / unfinished_directory;
  const auto names = names_in(unfinished / removing_list);
  remove_files(directory, names);
  remove_if_empty(parents_of(directory, names));
  move_file(unfinished / removing_list, unfinished / moving_list);
}

/// The second step: moves the new files, the record last.
void move_new(const fs::path& directory) {
  const auto unfinished = directory / unfinished_directory;
  const auto record = names_in(unfinished / moving_list).front();
  remove_partial_files(unfinished, is_replacement_list);
  auto names = files_below(unfinished);
  std::ranges::stable_partition(names, [&](const std::string& name) { return name != record; });
  for (const auto& name : names) {
    if (!stays_within(name)) throw FileError(fmt::format("{}: cannot move it", (unfinished / name).string()));
    make_directory((directory / name).parent_path());
    move_file(unfinished / name, directory / name);
  }
  remove_if_empty(directories_below(unfinished));
  remove_files(unfinished, std::vector<std::string>{moving_list});
  remove_if_empty(unfinished);
}

}  // namespace

void replace_results(const fs::path& directory, std::span<const std::string> old_files, const std::string& record) {
  const auto unfinished = directory / unfinished_directory;
  if (!fs::is_regular_file(status_of(unfinished / record))) {
    throw FileError(fmt::format("{}: has disappeared, so nothing is replaced", (unfinished / record).string()));
  }
  std::vector<std::string> foreign;
  for (const auto& name : files_below(unfinished)) {
    const bool is_ours =
        std::ranges::find(old_files, name) != old_files.end() && !fs::is_directory(status_of(directory / name));
    std::error_code ignored;
    if (!is_ours && fs::exists(fs::symlink_status(directory / name, ignored)))
      foreign.push_back((directory / name).string());
  }
  if (!foreign.empty()) {
    throw FileError(fmt::format("{}: not written by Breccia, so it is not replaced", fmt::join(foreign, ", ")));
  }
  auto list = record + "\n";
  for (const auto& name : old_files) {
    if (name != record) list += name + "\n";
  }
  write_text(unfinished / removing_list, list);
  finish_replacement(directory);
}

std::optional<fs::path> results_with_unfinished(const fs::path& directory) {
  auto within = fs::absolute(directory).lexically_normal();
  for (; within.has_relative_path(); within = within.parent_path()) {
    if (within.filename() != unfinished_directory) continue;
    auto results = within.parent_path();
    if (!fs::exists(status_of(results / "study.json")) && !fs::exists(status_of(results / "sweep.json"))) continue;
    return directory.is_absolute() ? results : results.lexically_proximate(fs::current_path());
  }
  return std::nullopt;
}

bool is_replacement_list(std::string_view name) {
  return name == removing_list || name == moving_list;
}

bool is_being_replaced(const fs::path& directory) {
  const auto unfinished = directory / unfinished_directory;
  return fs::exists(status_of(unfinished / removing_list)) || fs::exists(status_of(unfinished / moving_list));
}

std::vector<std::string> unfinished_files(const fs::path& directory) {
  const auto unfinished = directory / unfinished_directory;
  return fs::is_directory(status_of(unfinished)) ? files_below(unfinished) : std::vector<std::string>();
}

void finish_replacement(const fs::path& directory) {
  const auto unfinished = directory / unfinished_directory;
  if (fs::is_regular_file(status_of(unfinished / removing_list))) remove_old(directory);
  if (fs::is_regular_file(status_of(unfinished / moving_list))) move_new(directory);
}

}  // namespace breccia
