#include "results/response_curves.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/results/curves.hpp"

#include "io/text_file.hpp"
#include "io/whole_results.hpp"
#include "results/comparison_file.hpp"
#include "study/abscissa_words.hpp"
#include "study/result_names.hpp"

namespace breccia {

namespace {

/// The origin of the curves in words: "aged: A, B from 1 ms to 1 s, study 0123456789abcdef".
std::string source_of(const ResponseDestination& destination, const std::vector<StageResult>& stages) {
  std::vector<std::string> names;
  names.reserve(stages.size());
  for (const auto& stage : stages) names.push_back(stage.name);
  const auto& curve = stages.front().tests.front().modulus;
  const auto abscissa = destination.rows.hertz_per_decade ? Abscissa::frequency : Abscissa::time;
  return fmt::format("{}: {} {}, study {}", destination.matrix, fmt::join(names, ", "),
                     window_in(abscissa, {curve.front().time, curve.back().time}), destination.study);
}

/// A text with everything that the curves depend on.
std::string identity_of(const ResponseDestination& destination, const std::vector<StageResult>& stages) {
  auto identity = fmt::format("{}\n{}", destination.matrix, destination.study);
  for (const auto& stage : stages) {
    const auto& curve = stage.tests.front().modulus;
    identity += fmt::format("\n{} {} {}", stage.name, curve.front().time, curve.back().time);
  }
  if (destination.rows.hertz_per_decade)
    identity += fmt::format("\n{} a decade in Hz", *destination.rows.hertz_per_decade);
  for (const auto& input : destination.inputs) identity += fmt::format("\n{}", content_hash(read_text(input)));
  return content_hash(identity);
}

}  // namespace

void write_response_curves(const ResponseDestination& destination, const std::vector<StageResult>& stages) {
  auto files = curve_files();
  std::ranges::copy(comparison_files(), std::back_inserter(files));
  refuse_to_replace(destination.directory, files, destination.inputs);
  WholeResults results(destination.directory, {.command = "respond",
                                               .source = source_of(destination, stages),
                                               .identity = identity_of(destination, stages),
                                               .files = files,
                                               .overwrite = destination.overwrite});
  write_curves(results.place(), {stages}, destination.rows);
  write_comparisons(results.place(), {stages});
  results.commit();
}

}  // namespace breccia
