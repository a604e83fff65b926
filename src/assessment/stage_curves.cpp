#include "breccia/assessment/stage_curves.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "assessment/curves_of_stage.hpp"

namespace breccia {
namespace {

/// Ends a modulus, of one sample, before the first time at which it is not positive.
void keep_positive(SampledCurve& curve) {
  if (curve.curve == ObservedCurve::phase) return;
  Eigen::Index count = 0;
  while (count < curve.values.rows() && curve.values(count, 0) > 0.0) ++count;
  const auto size = static_cast<std::size_t>(count);
  if (size == curve.at.size()) return;
  if (size == 0) throw InputError(fmt::format("{} is not positive", curve.name));
  curve.values.conservativeResize(count, Eigen::NoChange);
  curve.at.resize(size);
  curve.reference.resize(size);
  curve.errors.resize(size);
}

}  // namespace

TestKind kind_of(const TestResult& test) {
  return {test.id.boundary, test.id.method};
}

std::vector<TestKind> kinds_of(const StageFindings& stage) {
  std::vector<TestKind> kinds;
  for (const auto& test : stage.tests) {
    const auto kind = kind_of(test);
    if (!test.id.load.is_bulk() && std::ranges::find(kinds, kind) == kinds.end()) kinds.push_back(kind);
  }
  if (kinds.empty()) throw InputError(fmt::format("stage {} has no test in shear", stage.name));
  const auto is_periodic = [](const TestKind& kind) { return kind.boundary == Boundary::periodic; };
  const auto is_quasistatic = [](const TestKind& kind) { return kind.method == Method::quasistatic; };
  std::stable_partition(kinds.begin(), kinds.end(), is_periodic);
  std::stable_partition(kinds.begin(), kinds.end(), is_quasistatic);
  return kinds;
}

std::optional<TestKind> shared_kind(const std::vector<StageFindings>& stages) {
  for (const auto& kind : kinds_of(stages.front())) {
    const auto has_it = [&](const StageFindings& stage) {
      const auto kinds = kinds_of(stage);
      return std::ranges::find(kinds, kind) != kinds.end();
    };
    if (std::ranges::all_of(stages, has_it)) return kind;
  }
  return std::nullopt;
}

std::vector<SampledCurve> curves_of(const StageFindings& stage, const TestKind& kind) {
  CurvesOfStage taken(stage, kind, 1);
  taken.take(0, stage.tests);
  auto curves = std::move(taken).curves();
  std::ranges::for_each(curves, keep_positive);
  return curves;
}

}  // namespace breccia
