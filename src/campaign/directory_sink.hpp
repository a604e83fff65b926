#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "breccia/homogenisation/study_sink.hpp"

#include "checkpoints.hpp"

namespace breccia {

/// Writes the results of a study to a directory as they are computed. Only the first of several processes writes.
class DirectorySink final : public StudySink {
 public:
  /// All arguments must outlive this object.
  DirectorySink(const Study& study, const std::filesystem::path& directory, const Checkpoints& checkpoints)
      : study_(study), directory_(directory), checkpoints_(checkpoints) {}

  std::optional<Checkpoint> packing_checkpoint(const Stage& stage) override;
  std::optional<Checkpoint> quasistatic_checkpoint(const Stage& stage, Boundary boundary, TestGrid grid) override;
  std::optional<Checkpoint> dynamic_checkpoint(const Stage& stage, const TestId& test) override;
  void packed(const Stage& stage, const StudyResult& result) override;
  void domain_finished(const Stage& stage, const TestId& test, std::size_t number, const TimeDomain& domain) override;
  std::optional<std::vector<FieldRecord>> fields(const Stage& stage, const TestId& test,
                                                 const Discretisation<2>& discretisation,
                                                 const std::vector<TimedFields<2>>& fields) override;
  void tested(const Stage& stage, const StudyResult& result) override;
  void all_loads_tested(const Stage& stage, const StudyResult& result) override;
  void stage_finished(const Stage& stage, const StudyResult& result) override;

  /// Writes the last stage of a result, which another task of a sweep has computed, and copies its fields from the
  /// directory of that task.
  void take_over(const Stage& stage, const std::filesystem::path& files, const StudyResult& result);

 private:
  const Study& study_;
  const std::filesystem::path& directory_;
  const Checkpoints& checkpoints_;
};

}  // namespace breccia
