#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "breccia/io/quantity.hpp"
#include "breccia/tables/measured_table.hpp"
#include "breccia/tables/modulus_kind.hpp"

namespace breccia {

/// Two columns that determine a complex modulus M* = M' + i M'' = |M*| exp(i delta).
struct ComplexModulusColumns {
  Quantity modulus;  ///< M', M'' or |M*|
  Quantity other;    ///< M'', delta or tan(delta)
};

/// The columns of a table from which its complex modulus is read; nothing if they do not suffice.
std::optional<ComplexModulusColumns> complex_modulus_columns(const MeasuredTable& table);

/// A complex modulus in the order of the rows of a table.
struct ComplexModulus {
  std::vector<double> storage;  ///< M' [Pa]
  std::vector<double> loss;     ///< M'' [Pa]
};

/// The complex modulus of the wanted kind from two columns of a table. Throws InputError if the table has another kind.
ComplexModulus complex_modulus(const MeasuredTable& table, const ComplexModulusColumns& columns, ModulusKind wanted);

namespace detail {

using IsOfQuantity = std::function<bool(Quantity)>;

/// The columns to read of a file that has columns of some quantities: M' and M'' if it has both, or else one of M', M''
/// and |M*|, in this order, with delta or tan(delta). A pair with two columns that a user has chosen is preferred to
/// one with a single chosen column, and that to a pair without any.
std::optional<ComplexModulusColumns> preferred_columns(const IsOfQuantity& has, const IsOfQuantity& is_chosen);

/// Whether a quantity is a part of a complex modulus: M', M'', |M*|, delta or tan(delta).
bool is_part_of_complex_modulus(Quantity quantity);

}  // namespace detail

}  // namespace breccia
