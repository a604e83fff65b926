#include "breccia/results/response_curves.hpp"

#include <fmt/format.h>

#include "breccia/io/text_file.hpp"
#include "breccia/io/whole_results.hpp"
#include "breccia/results/curves.hpp"
#include "breccia/study/result_names.hpp"

namespace breccia {

void write_response_curves(const ResponseDestination& destination, const std::vector<StageResult>& stages) {
  refuse_to_replace(destination.directory, curve_files(), destination.inputs);
  auto identity = destination.matrix + destination.study;
  for (const auto& stage : stages) {
    const auto& curve = stage.tests.front().modulus;
    identity += fmt::format("\n{} {} {}", stage.name, curve.front().time, curve.back().time);
  }
  for (const auto& input : destination.inputs)
    identity += fmt::format("\n{}", std::filesystem::weakly_canonical(input).string());
  WholeResults results(destination.directory, {.command = "respond",
                                               .source = destination.matrix,
                                               .identity = content_hash(identity),
                                               .files = curve_files(),
                                               .overwrite = destination.overwrite});
  write_curves(results.place(), {stages});
  results.commit();
}

}  // namespace breccia
