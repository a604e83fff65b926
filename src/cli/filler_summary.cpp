#include "cli/filler_summary.hpp"

#include <fmt/format.h>

#include "homogenisation/whole_filler.hpp"
#include "study/chain.hpp"

namespace breccia::cli {

std::string filler_summary(const Study& study, const std::vector<std::vector<FillerStatistics>>& packed) {
  std::string text;
  for (const auto& stage : study.stages) {
    if (serves_as_matrix(study.stages, stage.name)) continue;
    const auto whole = filler_of_the_whole(study, stage, packed);
    const bool has_any = whole.fraction > 0.0 || whole.porosity > 0.0;
    if (has_any) text += fmt::format("{}: {}\n", stage.name, in_words(whole));
  }
  return text;
}

}  // namespace breccia::cli
