#include "results/best_tests.hpp"

#include <algorithm>

namespace breccia {

std::vector<const TestResult*> best_tests(const StageFindings& stage) {
  std::vector<const TestResult*> best;
  for (const auto& test : stage.tests) {
    const bool is_best = std::ranges::none_of(stage.tests, [&](const TestResult& other) {
      return other.id.load == test.id.load && other.id.boundary == test.id.boundary && is_preferred(other.id, test.id);
    });
    if (is_best) best.push_back(&test);
  }
  return best;
}

}  // namespace breccia
