#include "breccia/io/foreign_results.hpp"

#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace breccia {
namespace {

using Remedy = Objection::Remedy;

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

std::string in_words(const Objection& objection) {
  if (objection.remedy == Remedy::none) return objection.problem;
  return fmt::format("{}; {}take another directory{}{}", objection.problem, before_another_directory(objection.remedy),
                     objection.free_directory.empty() ? "" : " such as " + objection.free_directory,
                     objection.remedy == Remedy::not_resuming ? ", or begin anew, which replaces them at the end" : "");
}

std::string in_words(const std::vector<Objection>& objections) {
  std::vector<std::string> lines;
  lines.reserve(objections.size());
  for (const auto& objection : objections) lines.push_back(in_words(objection));
  return fmt::format("{}", fmt::join(lines, "\n"));
}

}  // namespace

ForeignResults::ForeignResults(std::vector<Objection> objections)
    : InputError(in_words(objections)), objections_(std::move(objections)) {}

}  // namespace breccia
