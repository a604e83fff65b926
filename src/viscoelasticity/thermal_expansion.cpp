#include "breccia/viscoelasticity/thermal_expansion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/carson_moduli.hpp"

#include "viscoelasticity/talbot_contour.hpp"

namespace breccia {
namespace {

using Complex = std::complex<double>;

/// Differences of bulk moduli below this share of them are none: the expansion is then the mean by volume.
constexpr double least_difference = 1e-9;

bool are_equal(Complex some, Complex other) {
  return std::abs(some - other) <= least_difference * std::abs(other);
}

/// The share of the filler in the expansion (theory, Eq. 23h).
Complex weight_of_filler(const ExpandingFiller& one, Complex s) {
  const Complex filler = carson_modulus(one.filler, s), matrix = carson_modulus(one.matrix, s),
                composite = carson_modulus(one.composite, s);
  if (are_equal(filler, matrix)) return one.fraction;
  return filler * (matrix - composite) / (composite * (matrix - filler));
}

/// Whether filler and matrix differ with the same sign at all Laplace variables above zero.
bool keep_their_order(const PronySeries& filler, const PronySeries& matrix) {
  std::vector<double> differences = {matrix.unrelaxed() - filler.unrelaxed(),
                                     matrix.equilibrium() - filler.equilibrium()};
  for (const auto* series : {&filler, &matrix}) {
    for (const auto& term : series->terms()) {
      const Complex s = 1.0 / term.relaxation_time;
      differences.push_back(carson_modulus(matrix, s).real() - carson_modulus(filler, s).real());
    }
  }
  const double rounding = least_difference * std::max(matrix.unrelaxed(), filler.unrelaxed());
  const auto [least, most] = std::ranges::minmax(differences);
  return least >= -rounding || most <= rounding;
}

}  // namespace

void ThermalExpansion::add(ExpandingFiller filler) {
  if (!keep_their_order(filler.filler, filler.matrix)) {
    throw InputError(
        "the bulk moduli of filler and matrix cross as they relax, so that the bulk modulus does not determine the "
        "thermal expansion");
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
  const double filler = last.filler.at(time), matrix = last.matrix.at(time), composite = last.composite.at(time);
  if (are_equal(filler, matrix)) return 0.0;
  auto of_matrix = *this;
  of_matrix.fillers_.pop_back();
  return std::abs((last.expansion - of_matrix.at(time)) * filler * matrix / (composite * (matrix - filler)));
}

}  // namespace breccia
