#include "tables/complex_modulus.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace breccia {
namespace {

using enum Quantity;

constexpr std::array<ComplexModulusColumns, 7> pairs{{{storage_modulus, loss_modulus},
                                                      {storage_modulus, phase_angle},
                                                      {storage_modulus, loss_tangent},
                                                      {loss_modulus, phase_angle},
                                                      {loss_modulus, loss_tangent},
                                                      {absolute_modulus, phase_angle},
                                                      {absolute_modulus, loss_tangent}}};

/// One row of two columns. Moduli are in [Pa], angles in [rad].
struct Row {
  ComplexModulusColumns columns;
  double modulus, other;

  [[nodiscard]] double tangent() const { return columns.other == phase_angle ? std::tan(other) : other; }
  [[nodiscard]] double cosine() const {
    return columns.other == phase_angle ? std::cos(other) : 1.0 / std::hypot(1.0, other);
  }
  [[nodiscard]] double storage() const {
    if (columns.modulus == storage_modulus) return modulus;
    return columns.modulus == loss_modulus ? modulus / tangent() : modulus * cosine();
  }
  [[nodiscard]] double loss() const {
    if (columns.other == loss_modulus) return other;
    return columns.modulus == loss_modulus ? modulus : storage() * tangent();
  }
};

}  // namespace

std::optional<ComplexModulusColumns> detail::preferred_columns(const IsOfQuantity& has, const IsOfQuantity& is_chosen) {
  std::optional<ComplexModulusColumns> preferred;
  int most_chosen = -1;
  for (const auto& pair : pairs) {
    const int chosen = (is_chosen(pair.modulus) ? 1 : 0) + (is_chosen(pair.other) ? 1 : 0);
    if (!has(pair.modulus) || !has(pair.other) || chosen <= most_chosen) continue;
    preferred = pair;
    most_chosen = chosen;
  }
  return preferred;
}

bool detail::is_part_of_complex_modulus(Quantity quantity) {
  return std::ranges::any_of(pairs,
                             [&](const auto& pair) { return pair.modulus == quantity || pair.other == quantity; });
}

std::optional<ComplexModulusColumns> complex_modulus_columns(const MeasuredTable& table) {
  return detail::preferred_columns([&](Quantity quantity) { return table.has({quantity}); },
                                   [](Quantity) { return false; });
}

ComplexModulus complex_modulus(const MeasuredTable& table, const ComplexModulusColumns& columns, ModulusKind wanted) {
  const auto& moduli = table.column(columns.modulus, wanted).values;
  const auto& others =
      columns.other == loss_modulus ? table.column(loss_modulus, wanted).values : table.column(columns.other).values;
  ComplexModulus result;
  result.storage.reserve(moduli.size());
  result.loss.reserve(moduli.size());
  for (std::size_t i = 0; i < moduli.size(); ++i) {
    const Row row{columns, moduli[i], others[i]};
    result.storage.push_back(row.storage());
    result.loss.push_back(row.loss());
  }
  return result;
}

}  // namespace breccia
