#include "cli/version.hpp"

#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/build_information.hpp"
#include "dynamics/instruction_set.hpp"

namespace breccia::cli {
namespace {

std::string list_of(const std::vector<InstructionSet>& sets) {
  std::vector<std::string_view> names;
  names.reserve(sets.size());
  for (const auto set : sets) names.push_back(name_of(set));
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::string version_text() {
  const auto build = build_information();
  const auto commit = build.commit.empty() ? std::string() : fmt::format("commit {}, ", build.commit);
  return fmt::format(
      "breccia {}\n"
      "build      {}{}, {}, {}\n"
      "kernels    {} on this processor; in use: {}\n"
      "libraries  {}",
      BRECCIA_VERSION, commit, build.compiler, build.type, build.processor, list_of(supported_instruction_sets()),
      name_of(chosen_instruction_set()), build.libraries);
}

}  // namespace breccia::cli
