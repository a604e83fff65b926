#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/reduction.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

#include "homogenisation/whole_filler.hpp"

namespace breccia {

/// A choice among the results of a study. The defaults are the last stage that was tested, the only boundary condition,
/// and the shear modulus under the load `shear` or else the only one.
struct CompositeChoice {
  std::string stage = {};  ///< name of the stage; empty: the last one
  std::optional<Boundary> boundary = {};
  std::optional<TestLoad> shear_load = {};
};

/// The moduli of a composite.
struct Composite {
  std::string title;  ///< title of the study
  std::string stage;
  Boundary boundary = Boundary::displacement;
  TestLoad shear_load = Load::shear;
  int dimensions = 2;
  double density = 0.0;                     ///< density of the stage with everything in its matrix [kg/m^3]
  PronySeries shear;                        ///< G(t) [Pa]
  std::optional<PronySeries> dilatational;  ///< modulus of the bulk test: K(t), in plane strain K(t) + G(t)/3 [Pa]
  std::optional<TemperatureShift> shift;    ///< shift of the binder, if no other material of the composite relaxes
  TimeWindow times;                         ///< first and last time of the study [s]
  std::optional<double> shear_error = {};   ///< largest whole error of G(t) [-]; nothing where it is not known

  /// K(t) [Pa], where there was a bulk test. In plane strain it is a difference, whose terms may be negative.
  [[nodiscard]] std::optional<PronySeries> bulk() const;
};

/// A boundary condition in words: "displacement boundary (KUBC)", "periodic boundary".
std::string boundary_in_words(Boundary boundary);

/// The content of a stage.
struct StageContent {
  std::string name;
  std::string matrix;  ///< name of an earlier stage or a material
  int dimensions = 2;
  /// Shares of the fillers and coatings, including those of the stages in its matrix.
  std::vector<FillerShare> shares = {};
};

/// The content of a study, apart from its moduli.
struct StudyContent {
  std::string title;
  TimeWindow times = {};      ///< [s]
  bool by_frequency = false;  ///< whether the deck gives frequencies
  std::vector<StageContent> stages = {};
  std::vector<ShiftedMaterial> materials = {};
};

/// The content of a study, from its result with the microstructures.
StudyContent study_content(const Study& study, const StudyResult& result);

/// The relaxation modulus of a stage under one load and boundary condition.
struct StageSeries {
  std::string stage;
  TestLoad load = Load::shear;
  Boundary boundary = Boundary::displacement;
  PronySeries series = {};
  std::optional<double> error = {};  ///< largest whole error of the modulus [-]; nothing where it is not known
};

/// The series of the preferred test (is_preferred) for each load and boundary condition of a stage.
std::vector<StageSeries> series_of(const StageFindings& stage);

/// The composite that is chosen among the series of a study. Throws InputError with every mistake in the choice and
/// with the possible choices; each line begins with `place`, the name of the results. Throws FileError where the
/// content lacks a stage or a material.
Composite composite_of(const StudyContent& content, const std::vector<StageSeries>& series,
                       const CompositeChoice& choice, const std::string& place);

}  // namespace breccia
