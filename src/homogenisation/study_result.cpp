#include "breccia/homogenisation/study_result.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {
namespace {

double distance_from_one(const ComparedSample& sample) {
  return std::abs(std::log(sample.ratio()));
}

}  // namespace

const ComparedSample& Comparison::best() const {
  return *std::ranges::min_element(samples, {}, distance_from_one);
}

const ComparedSample& Comparison::worst() const {
  return *std::ranges::max_element(samples, {}, distance_from_one);
}

}  // namespace breccia
