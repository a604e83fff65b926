#include "cli/filler_summary.hpp"

#include <fmt/format.h>

#include "homogenisation/whole_filler.hpp"
#include "study/chain.hpp"

namespace breccia::cli {

std::string filler_summary(const Study& study, const std::vector<std::vector<FillerStatistics>>& packed) {
  std::string text;
  for (const auto& stage : study.stages) {
    if (serves_as_matrix(study.stages, stage.name)) continue;
    const auto words = in_words(filler_of_the_whole(study, stage, packed));
    if (!words.empty()) text += fmt::format("{}: {}\n", stage.name, words);
  }
  return text;
}

}  // namespace breccia::cli
