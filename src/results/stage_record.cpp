#include "results/stage_record.hpp"

#include <algorithm>

namespace breccia {

std::vector<std::string> FieldRecord::names() const {
  std::vector<std::string> names = {file, stress_picture, strain_picture};
  if (!work_picture.empty()) names.push_back(work_picture);
  return names;
}

std::vector<FieldRecord> StageRecord::fields_of(const TestId& test) const {
  const auto found = std::ranges::find(fields, test, &TestFieldFiles::test);
  return found == fields.end() ? std::vector<FieldRecord>() : found->files;
}

}  // namespace breccia
