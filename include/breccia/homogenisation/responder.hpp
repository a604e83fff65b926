#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "breccia/homogenisation/new_materials.hpp"
#include "breccia/homogenisation/stage_responses.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"

namespace breccia {

/// A modulus of a stage at one Laplace variable [Pa], and its derivatives [-] by the Carson moduli of those materials
/// of the study that vary, by their names.
struct ModulusAndGradient {
  double modulus = 0.0;
  std::map<std::string, Moduli> gradient = {};
};

/// Computes the stages of a solved study with other materials, at another temperature or at other times, in
/// milliseconds, from their reduced responses. A responder does not change: at(), with() and the like return another
/// one.
class Responder {
 public:
  /// The stages with the materials of their study. `materials` are all of the study, as far as they are known, with
  /// the laws of their temperature shifts. Throws InputError where stages are of several studies, given twice,
  /// or build on each other in a circle.
  explicit Responder(std::vector<StageResponses> stages, const std::vector<ShiftedMaterial>& materials = {});

  /// The materials that vary at another temperature [K]. An elastic matrix stays what it is, with a warning in the
  /// results. Throws InputError where a material that relaxes has no law, or not at that temperature.
  [[nodiscard]] Responder at(double temperature) const;
  /// Other materials in place of those that they name. Throws InputError, with one line for each mistake: a name that
  /// is none of a material or a phase that varies, a phase that is of several materials, a material that is replaced
  /// twice, a stage without the one that it builds on; NotVaried where a material is elastic and was not sampled.
  [[nodiscard]] Responder with(const std::vector<NewMaterial>& materials) const;
  /// Other first and last times of the curves than those of the study [s].
  [[nodiscard]] Responder within(const TimeWindow& times) const;
  /// One stage and those that it builds on. Throws InputError if there is no such stage.
  [[nodiscard]] Responder chain_of(const std::string& stage) const;
  /// One stage without those that it builds on; its matrix has to be given by with(). Throws InputError if there is no
  /// such stage.
  [[nodiscard]] Responder alone(const std::string& stage) const;

  /// The results of the stages, in the order in which they build on each other: the matrix of a later stage is the new
  /// result of the one before it. Each has the warnings of its run but those on the materials that vary, and anew those
  /// on the materials and bounds that it has now. Throws NotCovered if a material leaves the sampled range, with the
  /// times that are covered; InputError if a stage lacks its matrix.
  [[nodiscard]] std::vector<StageResult> respond() const;

  /// The modulus of a stage at a real Laplace variable s [1/s], by its correspondence with an elastic composite, on the
  /// finest grid: the test under bulk has K, in plane strain K + G/3. Throws InputError if there is no such test.
  [[nodiscard]] ModulusAndGradient modulus_and_gradient(const std::string& stage, Load load, Boundary boundary,
                                                        double laplace_variable) const;
  /// The modulus at these moduli [Pa] of the materials that vary, by the names of the materials.
  [[nodiscard]] ModulusAndGradient modulus_and_gradient(const std::string& stage, Load load, Boundary boundary,
                                                        const std::map<std::string, Moduli>& moduli) const;

  /// The stages with the materials and times that they have now, under the names of the materials in the study.
  [[nodiscard]] const std::vector<StageResponses>& stages() const noexcept { return stages_; }
  /// The materials of the study, with those that are replaced, under the names in the study.
  [[nodiscard]] const std::vector<ShiftedMaterial>& materials() const noexcept { return materials_; }
  /// The names of the materials that vary as results show them, such as "binder at 40 degC", each once, by their names
  /// in the study.
  [[nodiscard]] std::vector<std::string> shown_names() const;

 private:
  /// The name under which results show a material: its own, and the temperature to which it was moved.
  struct ShownName {
    std::string material, temperature = {};

    [[nodiscard]] std::string text() const { return material + temperature; }
  };

  void replace(const std::string& name, ShiftedMaterial material, ShownName shown);
  [[nodiscard]] const StageResponses& stage_named(const std::string& stage) const;
  [[nodiscard]] std::vector<StageResponses> stages_with_shown_names() const;
  void add_warnings(std::vector<StageResult>& results) const;

  std::vector<StageResponses> stages_;
  std::vector<ShiftedMaterial> materials_;
  std::map<std::string, ShownName> shown_ = {};  ///< names of replaced materials by those in the study
  std::set<std::string> unshifted_ = {};         ///< elastic materials that were asked for at another temperature
};

/// The responder of a study from its result. Throws InputError where the result is that of another study.
Responder responder_of(const Study& study, const StudyResult& result);

}  // namespace breccia
