#include "breccia/results/stage_record.hpp"

#include <algorithm>

namespace breccia {

std::vector<FieldRecord> StageRecord::fields_of(const TestId& test) const {
  const auto found = std::ranges::find(fields, test, &TestFields::test);
  return found == fields.end() ? std::vector<FieldRecord>() : found->files;
}

}  // namespace breccia
