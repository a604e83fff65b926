#pragma once

#include <map>
#include <string>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/quasistatic/reduced_response.hpp"
#include "breccia/study/study.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// The reduced responses of a stage under all boundaries and loads that were tested, from which a Responder computes
/// its moduli with other materials. They come from a result in memory (responses_of) or from a file `response.h5`
/// (results/response_file.hpp).
struct StageResponses {
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
  /// The materials of its fillers, by name, and its warnings in that study. A response file has neither; they are read
  /// from `study.json`.
  std::vector<std::string> fillers = {}, warnings = {};
  std::vector<Entry> entries;
};

/// The reduced responses of a stage from its result; without entries where none of its tests was computed by the
/// quasi-static method with the reduced solver. Throws InputError where the result has another name or grid.
StageResponses responses_of(const Study& study, const Stage& stage, const StageResult& result);

/// The reduced responses of all stages of a study that have such tests, in their order. Throws InputError where the
/// result is that of another study, or of this one before it was changed.
std::vector<StageResponses> responses_of(const Study& study, const StudyResult& result);

/// The names of the materials that the stages have as matrix, and of those of their other phases whose moduli vary.
std::vector<std::string> varying_materials(const std::vector<StageResponses>& stages);

}  // namespace breccia
