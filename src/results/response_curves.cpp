#include "results/response_curves.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/results/curves.hpp"

#include "io/text_file.hpp"
#include "io/units.hpp"
#include "io/whole_results.hpp"
#include "study/result_names.hpp"

namespace breccia {

namespace {

/// The origin of the curves in words: "aged: A, B from 1 ms to 1 s, study 0123456789abcdef".
std::string source_of(const ResponseDestination& destination, const std::vector<StageResult>& stages) {
  std::vector<std::string> names;
  names.reserve(stages.size());
  for (const auto& stage : stages) names.push_back(stage.name);
  const auto& curve = stages.front().tests.front().modulus;
  return fmt::format("{}: {} from {} to {}, study {}", destination.matrix, fmt::join(names, ", "),
                     readable(curve.front().time, Dimension::time), readable(curve.back().time, Dimension::time),
                     destination.study);
}

/// A text with everything that the curves depend on.
std::string identity_of(const ResponseDestination& destination, const std::vector<StageResult>& stages) {
  auto identity = fmt::format("{}\n{}", destination.matrix, destination.study);
  for (const auto& stage : stages) {
    const auto& curve = stage.tests.front().modulus;
    identity += fmt::format("\n{} {} {}", stage.name, curve.front().time, curve.back().time);
  }
  for (const auto& input : destination.inputs) identity += fmt::format("\n{}", content_hash(read_text(input)));
  return content_hash(identity);
}

}  // namespace

void write_response_curves(const ResponseDestination& destination, const std::vector<StageResult>& stages) {
  refuse_to_replace(destination.directory, curve_files(), destination.inputs);
  WholeResults results(destination.directory, {.command = "respond",
                                               .source = source_of(destination, stages),
                                               .identity = identity_of(destination, stages),
                                               .files = curve_files(),
                                               .overwrite = destination.overwrite});
  write_curves(results.place(), {stages});
  results.commit();
}

}  // namespace breccia
