#include "breccia/viscoelasticity/law_form.hpp"

#include <limits>

namespace breccia {

namespace {

constexpr double no_dashpot = std::numeric_limits<double>::infinity();

constexpr std::array two_springs_two_parabolas_dashpot = {LawParameter{"static", ParameterKind::modulus, 0.0},
                                                          LawParameter{"glassy", ParameterKind::modulus},
                                                          LawParameter{"delta", ParameterKind::number},
                                                          LawParameter{"time", ParameterKind::time},
                                                          LawParameter{"k", ParameterKind::exponent},
                                                          LawParameter{"h", ParameterKind::exponent},
                                                          LawParameter{"beta", ParameterKind::number, no_dashpot}};
constexpr std::array fractional_zener = {
    LawParameter{"equilibrium", ParameterKind::modulus, 0.0}, LawParameter{"unrelaxed", ParameterKind::modulus},
    LawParameter{"time", ParameterKind::time}, LawParameter{"exponent", ParameterKind::exponent}};
constexpr std::array power_law_creep = {
    LawParameter{"instantaneous", ParameterKind::compliance}, LawParameter{"creep", ParameterKind::compliance},
    LawParameter{"time", ParameterKind::time}, LawParameter{"exponent", ParameterKind::exponent}};
constexpr std::array logarithmic_creep = {
    LawParameter{"instantaneous", ParameterKind::compliance}, LawParameter{"creep", ParameterKind::compliance},
    LawParameter{"time", ParameterKind::time}, LawParameter{"exponent", ParameterKind::exponent, 1.0}};

}  // namespace

std::span<const LawParameter> parameters_of(LawForm form) {
  switch (form) {
    case LawForm::two_springs_two_parabolas_dashpot:
      return two_springs_two_parabolas_dashpot;
    case LawForm::fractional_zener:
      return fractional_zener;
    case LawForm::power_law_creep:
      return power_law_creep;
    case LawForm::logarithmic_creep:
      break;
  }
  return logarithmic_creep;
}

}  // namespace breccia
