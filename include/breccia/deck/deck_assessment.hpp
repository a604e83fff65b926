#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "breccia/assessment/assess.hpp"
#include "breccia/deckfile/deck_setting.hpp"
#include "breccia/homogenisation/responder.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/sweep.hpp"

namespace breccia {

/// The assessment of a deck whose inputs are not all certain: the studies that have to be solved for it, and what their
/// responses say.
class DeckAssessment {
 public:
  /// Reads a deck with overrides as read_study() does. Throws InputError with one line for every mistake in any study,
  /// and where no input is uncertain, the deck has a sweep, or its tests leave no reduced responses; FileError.
  DeckAssessment(const std::filesystem::path& deck, const std::vector<std::string>& overrides,
                 const AssessmentOptions& options = {}, const ValueOrigins& origins = {});
  /// The assessment of a deck that a program has written (study_from_text).
  static DeckAssessment from_text(const std::string& deck, const std::filesystem::path& directory,
                                  const std::vector<std::string>& overrides, const AssessmentOptions& options = {},
                                  const ValueOrigins& origins = {});
  DeckAssessment(const DeckAssessment&) = delete;
  DeckAssessment& operator=(const DeckAssessment&) = delete;
  DeckAssessment(DeckAssessment&&) noexcept;
  DeckAssessment& operator=(DeckAssessment&&) noexcept;
  ~DeckAssessment();

  /// The uncertain inputs.
  [[nodiscard]] const std::vector<UncertainInput>& inputs() const noexcept;
  [[nodiscard]] const AssessmentDesign& design() const noexcept;
  /// The studies to solve: the deck with the median of each input and, where some inputs change the box, those of the
  /// boxes after it.
  [[nodiscard]] const Sweep& sweep() const noexcept;

  /// The study of the deck with a value for one of the inputs, by its index, and the median of each other. Throws
  /// InputError where the value makes a mistake.
  [[nodiscard]] Study study_with(std::size_t input, const Scalar& value) const;

  /// The name of the stage that is assessed: that of the last one for an empty name. Throws InputError for a name that
  /// no stage has.
  [[nodiscard]] std::string stage_named(const std::string& name) const;
  /// The curves of a stage, for an empty name the last one, in all samples: from the responders of all studies, in
  /// their order, and the results of the stages of the first study. Throws InputError for a name that no stage has, and
  /// where a sample is no sound material; NotCovered where it is outside of what the studies have sampled.
  [[nodiscard]] std::vector<SampledCurve> curves(const std::vector<Responder>& solved,
                                                 const std::vector<StageFindings>& reference,
                                                 const std::string& stage = {}, int threads = 0) const;

 private:
  struct State;
  explicit DeckAssessment(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace breccia
