#include "breccia/viscoelasticity/thermal_expansion.hpp"

#include <cmath>
#include <utility>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/carson_moduli.hpp"

#include "viscoelasticity/talbot_contour.hpp"

namespace breccia {
namespace {

using Complex = std::complex<double>;

/// The share of the filler in the expansion (theory, Eq. 23h).
Complex weight_of_filler(const ExpandingFiller& one, Complex s) {
  const Complex filler = one.filler.equilibrium(), matrix = carson_modulus(one.matrix, s),
                composite = carson_modulus(one.composite, s);
  return filler * (matrix - composite) / (composite * (matrix - filler));
}

}  // namespace

bool determines_expansion(const PronySeries& filler, const PronySeries& matrix) {
  constexpr double tenth = 0.1;
  const double of_filler = filler.equilibrium();
  return filler.is_elastic() &&
         (of_filler >= (1.0 + tenth) * matrix.unrelaxed() || of_filler <= (1.0 - tenth) * matrix.equilibrium());
}

void ThermalExpansion::add(ExpandingFiller filler) {
  if (!determines_expansion(filler.filler, filler.matrix)) {
    throw InputError("thermal expansion: the bulk moduli of filler and matrix do not determine that of the composite");
  }
  fillers_.push_back(std::move(filler));
}

Complex ThermalExpansion::carson(Complex s) const {
  Complex expansion = of_binder_;
  for (const auto& one : fillers_) expansion += (one.expansion - expansion) * weight_of_filler(one, s);
  return expansion;
}

double ThermalExpansion::at(double time) const {
  constexpr int nodes = 20;
  const TalbotContour contour(time, nodes);
  std::vector<Complex> values;
  for (const auto s : contour.variables()) values.push_back(carson(s));
  return contour.function(values);
}

double ThermalExpansion::sensitivity(double time) const {
  if (fillers_.empty()) return 0.0;
  const auto& last = fillers_.back();
  const double filler = last.filler.equilibrium(), matrix = last.matrix.at(time), composite = last.composite.at(time);
  auto of_matrix = *this;
  of_matrix.fillers_.pop_back();
  return std::abs((last.expansion - of_matrix.at(time)) * filler * matrix / (composite * (matrix - filler)));
}

}  // namespace breccia
