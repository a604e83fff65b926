#include "cli/advice.hpp"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/homogenisation/plan.hpp"

#include "homogenisation/respond/not_covered.hpp"
#include "io/conflicting_results.hpp"
#include "io/directory_lock.hpp"
#include "io/display.hpp"
#include "results/stored_composite.hpp"
#include "results/study_document.hpp"
#include "study/abscissa_words.hpp"
#include "tables/unknown_columns.hpp"

namespace breccia::cli {
namespace {

bool has(const CLI::App& command, const char* option) {
  return command.get_option_no_throw(option) != nullptr;
}

/// The text that is added to the message of an error; empty if no option of the command helps.
std::string advice_on(const Error& error, const CLI::App& command) {
  if (dynamic_cast<const DirectoryInUse*>(&error) != nullptr && has(command, "--out")) {
    return ", or take another directory (--out)";
  }
  if (dynamic_cast<const LackingMemory*>(&error) != nullptr && has(command, "--no-memory-check")) {
    return " (--no-memory-check runs them nevertheless)";
  }
  if (dynamic_cast<const Interrupted*>(&error) != nullptr && has(command, "--resume")) {
    return ", and --resume continues from it";
  }
  if (dynamic_cast<const UnknownColumns*>(&error) != nullptr && has(command, "--columns")) {
    return "\n--columns tells which column is which, as in --columns storage=NAME --columns loss=NAME";
  }
  if (dynamic_cast<const AnsweredResults*>(&error) != nullptr && has(command, "--temperature")) {
    return ", with --temperature";
  }
  if (const auto* const other = dynamic_cast<const OtherFormat*>(&error)) {
    return fmt::format(" (breccia run DECK --out {} --overwrite)", other->directory().string());
  }
  const auto* const not_covered = dynamic_cast<const NotCovered*>(&error);
  if (not_covered != nullptr && not_covered->times() && has(command, "--times")) {
    const auto& times = *not_covered->times();
    if (not_covered->abscissa() == Abscissa::frequency) {
      const auto [begin, end] = hertz_within(times);
      return fmt::format(R"(: --frequencies "{}" "{}")", display(begin, "Hz"), display(end, "Hz"));
    }
    return fmt::format(R"(: --times "{}" "{}")", display(times.begin, "s", 3), display(times.end, "s", 3));
  }
  return {};
}

/// The options of the command that help against a conflict.
std::string advice_on(const ResultConflict& conflict, const CLI::App& command) {
  using Remedy = ResultConflict::Remedy;
  const auto remedy = conflict.remedy;
  if (remedy == Remedy::none) return {};
  const bool can_replace = has(command, "--overwrite");
  std::vector<std::string> ways;
  if (can_replace && remedy == Remedy::replacing_it) ways.emplace_back("replace it (--overwrite)");
  if (can_replace && (remedy == Remedy::replacing || remedy == Remedy::adding)) {
    ways.emplace_back("replace them (--overwrite)");
  }
  if (remedy == Remedy::adding && has(command, "--resume")) ways.emplace_back("add to them (--resume)");
  ways.push_back(conflict.free_directory.empty()
                     ? "take another directory (--out)"
                     : fmt::format("take another directory (--out {})", conflict.free_directory));
  if (can_replace && remedy == Remedy::not_resuming) {
    ways.emplace_back(
        "run with --overwrite instead of --resume, which starts anew and replaces them when the new ones are complete");
  }
  const auto last = ways.back();
  ways.pop_back();
  return ways.empty() ? "; " + last : fmt::format("; {} or {}", fmt::join(ways, ", "), last);
}

}  // namespace

std::string with_advice(const Error& error, const CLI::App& command) {
  const auto* const foreign = dynamic_cast<const ConflictingResults*>(&error);
  if (foreign == nullptr || !has(command, "--out")) return error.what() + advice_on(error, command);
  std::vector<std::string> lines;
  for (const auto& conflict : foreign->conflicts()) lines.push_back(conflict.problem + advice_on(conflict, command));
  return fmt::format("{}", fmt::join(lines, "\n"));
}

}  // namespace breccia::cli
