#pragma once

#include <map>
#include <string>
#include <vector>

#include "breccia/homogenisation/responder.hpp"
#include "breccia/viscoelasticity/carson_moduli.hpp"

namespace breccia {

/// The stages of a study under one boundary, with elastic materials. By the correspondence principle their moduli are
/// those of the viscoelastic stages at a Laplace variable, where the moduli of the materials may be complex. Each stage
/// is on its finest grid.
class ElasticChain {
 public:
  /// `moduli` are the moduli of the materials that vary [Pa], by the names of these.
  ElasticChain(const std::vector<StageResponses>& stages, const std::map<std::string, ComplexModuli>& moduli,
               Boundary boundary)
      : stages_(stages), moduli_(moduli), boundary_(boundary) {}

  /// The modulus of a stage under a load. Throws InputError if there is no such test, or a material has no moduli.
  [[nodiscard]] ModulusAndGradient modulus(const std::string& stage, TestLoad load) const;

 private:
  [[nodiscard]] ModulusAndGradient modulus_under(const StageResponses& stage, Load load) const;
  [[nodiscard]] const StageResponses& stage_named(const std::string& stage) const;
  [[nodiscard]] const ComplexModuli& moduli_of(const std::string& material) const;

  const std::vector<StageResponses>& stages_;
  const std::map<std::string, ComplexModuli>& moduli_;
  Boundary boundary_;
};

}  // namespace breccia
