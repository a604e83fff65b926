#include "quasistatic/operator/plane_division.hpp"

#include <cstdint>

namespace breccia::quasistatic {

std::optional<PlaneDivision> PlaneDivision::among(int processes, int planes) {
  if (planes < processes) return std::nullopt;
  std::vector<int> first;
  for (int process = 0; process <= processes; ++process) {
    first.push_back(static_cast<int>(std::int64_t{planes} * process / processes));
  }
  return PlaneDivision(std::move(first));
}

}  // namespace breccia::quasistatic
