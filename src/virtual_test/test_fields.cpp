#include "breccia/virtual_test/test_fields.hpp"

namespace breccia {

std::vector<double> times_of(const TestFields& fields) {
  return std::visit(
      [](const auto& one) {
        std::vector<double> times;
        for (const auto& timed : one.at_times) times.push_back(timed.time);
        return times;
      },
      fields);
}

}  // namespace breccia
