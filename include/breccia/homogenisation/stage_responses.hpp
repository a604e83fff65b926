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
  /// The reduced response of one test, and the grid of the test.
  struct Entry {
    TestGrid grid;
    ReducedResponse response;
  };

  std::string stage;
  StageMatrix matrix;  ///< an earlier stage or a material; a file keeps only the name
  /// Materials of the other phases whose moduli vary, by the names of the phases.
  std::map<std::string, Material> other_phases = {};
  double filler_density = 0.0;   ///< mean density of fillers and coatings by volume [kg/m^3]; unused (0) without them
  double filler_fraction = 0.0;  ///< share of fillers and coatings in the box [-]
  double side = 0.0;             ///< side of the box [m]
  int dimensions = 2;            ///< dimensions of the box
  std::string deck_hash;         ///< hash of the study that computed the responses (provenance_of)
  double fit_tolerance = 0.0;    ///< tolerance of fits in the study [-]
  TimeWindow times;              ///< first and last time of the study's curves [s]
  int points_per_decade = 20;    ///< samples per decade of the study's curves
  SampledRange range = SampledRange::matrix;  ///< range of moduli over which the responses were sampled
  Mixing mixing = Mixing::series;  ///< mixing of the stage, which determines how results on several grids are combined
  TestLoad shear = Load::shear;    ///< load whose modulus is G of the stage as a material
  /// The abscissa of the study, and the measurements of the stage. A response file has neither; they are read from the
  /// other files of the results, the measurements as far as the study was compared with them.
  Abscissa abscissa = Abscissa::time;
  std::vector<Measurement> measurements = {};
  /// Names of the materials of the stage's fillers, the warnings about the stage in the study, and the rules for its
  /// errors. A response file holds none of them; they are read from `study.json`.
  std::vector<std::string> fillers = {}, warnings = {};
  ErrorRules rules = {};
  std::vector<Entry> entries;
};

/// The reduced responses of a stage from its result; without entries where none of its tests was computed by the
/// quasi-static method with the reduced solver. Throws InputError where the result has another name or grid.
StageResponses responses_of(const Study& study, const Stage& stage, const StageResult& result);

/// The reduced responses of all stages of a study that have such tests, in the order of the stages. Throws InputError
/// where the result is that of another study, or of this one before it was changed.
std::vector<StageResponses> responses_of(const Study& study, const StudyResult& result);

/// The names of the varying materials of the stages: of the matrices that are materials, and of the other phases whose
/// moduli vary.
std::vector<std::string> varying_materials(const std::vector<StageResponses>& stages);

}  // namespace breccia
