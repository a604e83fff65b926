#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/quasistatic/reduced_response.hpp"
#include "breccia/study/study.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// The reduced responses of a stage under all boundaries and loads that were tested, from which its moduli with another
/// matrix can be computed. They come from a result in memory (responses_of) or from a file `response.h5`
/// (results/response_file.hpp).
struct StoredResponses {
  struct Entry {
    TestGrid grid;
    ReducedResponse response;
  };

  std::string stage;
  StageMatrix matrix;  ///< an earlier stage or a material; a file keeps only the name
  /// Materials of the other phases whose moduli vary, by the names of the phases.
  std::map<std::string, Material> other_phases = {};
  double filler_density = 0.0;                ///< mean of fillers and coatings by volume [kg/m^3]; unused (0) without
  double filler_fraction = 0.0;               ///< of fillers and coatings [-]
  double side = 0.0;                          ///< side of the box [m]
  int dimensions = 2;                         ///< of the box
  std::string deck_hash;                      ///< of the study that left it (provenance_of)
  double fit_tolerance = 0.0;                 ///< of the study [-]
  TimeWindow times;                           ///< of the study [s]
  int points_per_decade = 20;                 ///< of its curves
  SampledRange range = SampledRange::matrix;  ///< over which the responses were sampled
  Mixing mixing = Mixing::series;             ///< of the study: what is made of several grids
  std::vector<Entry> entries;
};

/// The reduced responses of a stage from its result; without entries where none of its tests was computed by the
/// quasi-static method with the reduced solver. Throws InputError where the result has another name or grid.
StoredResponses responses_of(const Study& study, const Stage& stage, const StageResult& result);

/// The same of all stages of a study that have such tests, in their order. Throws InputError where the result is that
/// of another study, or of this one before it was changed.
std::vector<StoredResponses> responses_of(const Study& study, const StudyResult& result);

/// Throws InputError if a stage builds on one that is not among them.
void require_earlier_stages(const std::vector<StoredResponses>& stored);

/// The stage with another matrix, at the times given or else those of the study: milliseconds.
/// Throws NotCovered if the matrix leaves the sampled range; the message has both and the times that are covered.
StageResult respond(const StoredResponses& stored, const Material& matrix, std::optional<TimeWindow> times = {});

/// The same for several stages of a study that build on each other. The new matrix replaces that of the stages that do
/// not build on another one; the matrix of each other stage is the new result of the stage before it. Returns the
/// stages in the order in which they build on each other. Throws InputError as above, and if a stage that another one
/// builds on is missing, the responses are from several studies, or several materials would be replaced by the one.
std::vector<StageResult> respond(const std::vector<StoredResponses>& stored, const Material& matrix,
                                 std::optional<TimeWindow> times = {});

/// The same with several new materials; each is given under the name of the material of the study that it replaces:
/// that of a matrix, or that of another phase whose moduli vary (StoredResponses::other_phases). Every matrix that is a
/// material needs one; another phase without one keeps the material of the study.
std::vector<StageResult> respond(const std::vector<StoredResponses>& stored,
                                 const std::map<std::string, Material>& matrices, std::optional<TimeWindow> times = {});

}  // namespace breccia
