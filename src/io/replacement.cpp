#include "io/replacement.hpp"

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

#include "io/empty_directory.hpp"
#include "io/file_status.hpp"
#include "io/partial_name.hpp"
#include "io/text_file.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

/// The names of lists in `unfinished`, which have one file name per line. The first list exists while old files are
/// removed, and has the record and the old files; the second exists while new files are moved, and has the record.
constexpr auto removing_list = "removing.list";
constexpr auto moving_list = "moving.list";

/// The lines of a list; nothing where it is no regular file, such as a link.
std::vector<std::string> names_in(const fs::path& list) {
  std::vector<std::string> names;
  std::error_code ignored;
  if (!fs::is_regular_file(fs::symlink_status(list, ignored))) return names;
  std::istringstream text(read_text(list));
  for (std::string line; std::getline(text, line);) names.push_back(line);
  return names;
}

/// The lists that an interrupted replacement has left in a directory, in the order in which they must be carried out.
std::vector<fs::path> lists_in(const fs::path& directory) {
  std::vector<fs::path> lists = {directory / unfinished_directory / removing_list,
                                 directory / unfinished_directory / moving_list};
  std::error_code ignored;
  std::erase_if(lists, [&](const fs::path& list) { return !fs::exists(fs::symlink_status(list, ignored)); });
  return lists;
}

/// The first symbolic link in the path of a relative name below a directory; empty if there is none.
fs::path first_link(const fs::path& directory, const fs::path& name) {
  auto path = directory;
  std::error_code ignored;
  for (const auto& step : name) {
    path /= step;
    if (fs::is_symlink(fs::symlink_status(path, ignored))) return path;
  }
  return {};
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

/// Calls visit(path, whether it is a directory) for everything below a directory. Links are not followed, since their
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

/// The files in `unfinished` that have names of the results.
std::vector<std::string> new_files(const fs::path& directory, const ResultNames& names) {
  auto files = unfinished_files(directory);
  std::erase_if(files, [&](const std::string& name) { return !names.has(name); });
  return files;
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
void move_new(const fs::path& directory, const ResultNames& results) {
  const auto unfinished = directory / unfinished_directory;
  remove_partial_files(unfinished, is_replacement_list);
  auto names = new_files(directory, results);
  std::stable_partition(names.begin(), names.end(), [&](const std::string& name) { return name != results.record; });
  for (const auto& name : names) {
    make_directory((directory / name).parent_path());
    move_file(unfinished / name, directory / name);
  }
  remove_if_empty(directories_below(unfinished));
  remove_files(unfinished, std::vector<std::string>{moving_list});
  remove_if_empty(unfinished);
}

/// The reasons, one line each, why old files of a directory must not be replaced by those in `unfinished`.
std::vector<std::string> mistakes_of_change(const fs::path& directory, std::span<const std::string> old_files,
                                            const ResultNames& names) {
  std::vector<std::string> paths(old_files.begin(), old_files.end());
  std::vector<std::string> foreign;
  for (const auto& name : new_files(directory, names)) {
    paths.push_back(name);
    paths.push_back((fs::path(unfinished_directory) / name).string());
    const bool is_ours =
        std::ranges::find(old_files, name) != old_files.end() && !fs::is_directory(status_of(directory / name));
    std::error_code ignored;
    if (!is_ours && fs::exists(fs::symlink_status(directory / name, ignored)))
      foreign.push_back((directory / name).string());
  }
  auto mistakes = mistakes_of_links(directory, paths);
  if (!foreign.empty()) {
    mistakes.push_back(fmt::format("{}: not written by Breccia, so it is not replaced", fmt::join(foreign, ", ")));
  }
  return mistakes;
}

}  // namespace

void replace_results(const fs::path& directory, std::span<const std::string> old_files, const ResultNames& names) {
  const auto unfinished = directory / unfinished_directory;
  if (!fs::is_regular_file(status_of(unfinished / names.record))) {
    throw FileError(fmt::format("{}: has disappeared, so nothing is replaced", (unfinished / names.record).string()));
  }
  if (const auto mistakes = mistakes_of_change(directory, old_files, names); !mistakes.empty()) {
    throw FileError(fmt::format("{}", fmt::join(mistakes, "\n")));
  }
  auto list = names.record + "\n";
  for (const auto& name : old_files) {
    if (name != names.record) list += name + "\n";
  }
  write_text(unfinished / removing_list, list);
  finish_replacement(directory, names);
}

std::vector<std::string> mistakes_of_links(const fs::path& directory, std::span<const std::string> names) {
  std::set<std::string> links;
  for (const auto& name : names) {
    if (const auto link = first_link(directory, name); !link.empty()) links.insert(link.string());
  }
  std::vector<std::string> mistakes;
  mistakes.reserve(links.size());
  for (const auto& link : links) {
    mistakes.push_back(
        fmt::format("{}: a symbolic link, through which files elsewhere would be written or removed; remove it", link));
  }
  return mistakes;
}

std::vector<std::string> mistakes_of_replacement(const fs::path& directory, const ResultNames& names) {
  const auto lists = lists_in(directory);
  std::vector<std::string> mistakes;
  for (const auto& list : lists) {
    const auto listed = names_in(list);
    if (listed.empty() || listed.front() != names.record || !std::ranges::all_of(listed, names.has)) {
      mistakes.push_back(fmt::format("{}: not as Breccia writes it here; remove it", list.string()));
    }
  }
  if (lists.empty() || !mistakes.empty()) return mistakes;
  return mistakes_of_change(directory, names_in(lists.front()), names);
}

std::vector<std::string> files_of_replacement(const fs::path& directory, const ResultNames& names) {
  const auto lists = lists_in(directory);
  if (lists.empty()) return {};
  auto files = new_files(directory, names);
  for (const auto& name : names_in(lists.front())) {
    if (names.has(name)) files.push_back(name);
  }
  return files;
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
  std::error_code ignored;
  return fs::is_directory(fs::symlink_status(unfinished, ignored)) ? files_below(unfinished)
                                                                   : std::vector<std::string>();
}

void finish_replacement(const fs::path& directory, const ResultNames& names) {
  if (const auto mistakes = mistakes_of_replacement(directory, names); !mistakes.empty()) {
    throw FileError(fmt::format("{}", fmt::join(mistakes, "\n")));
  }
  const auto unfinished = directory / unfinished_directory;
  if (fs::is_regular_file(status_of(unfinished / removing_list))) remove_old(directory);
  if (fs::is_regular_file(status_of(unfinished / moving_list))) move_new(directory, names);
}

}  // namespace breccia
