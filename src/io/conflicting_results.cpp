#include "io/conflicting_results.hpp"

#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace breccia {
namespace {

using Remedy = ResultConflict::Remedy;

std::string_view before_another_directory(Remedy remedy) {
  switch (remedy) {
    case Remedy::replacing_it:
      return "replace it or ";
    case Remedy::replacing:
      return "replace them or ";
    case Remedy::adding:
      return "replace them, add to them or ";
    default:
      return "";
  }
}

std::string in_words(const ResultConflict& conflict) {
  if (conflict.remedy == Remedy::none) return conflict.problem;
  return fmt::format("{}; {}take another directory{}{}", conflict.problem, before_another_directory(conflict.remedy),
                     conflict.free_directory.empty() ? "" : " such as " + conflict.free_directory,
                     conflict.remedy == Remedy::not_resuming ? ", or begin anew, which replaces them at the end" : "");
}

std::string in_words(const std::vector<ResultConflict>& conflicts) {
  std::vector<std::string> lines;
  lines.reserve(conflicts.size());
  for (const auto& conflict : conflicts) lines.push_back(in_words(conflict));
  return fmt::format("{}", fmt::join(lines, "\n"));
}

}  // namespace

ConflictingResults::ConflictingResults(std::vector<ResultConflict> conflicts)
    : InputError(in_words(conflicts)), conflicts_(std::move(conflicts)) {}

}  // namespace breccia
