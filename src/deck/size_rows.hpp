#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "breccia/study/filler.hpp"

namespace breccia {

/// The rows of a sieve analysis in any order, as a laboratory gives them.
struct SizeRows {
  std::vector<double> sizes;    ///< [m]
  std::vector<double> passing;  ///< share of the volume in particles of each size and less [-]
};

/// What takes the number of a row, from 0, and what was expected of it.
using RowReporter = std::function<void(std::size_t row, const std::string& expected)>;

/// The rows by rising size, without those of 0 but the coarsest of them and those of 1 but the finest of them. Reports
/// sizes that are not positive or stand there twice, shares that are not between 0 and 1, and those that fall with the
/// size. Its first and last share may be any (with_known_ends).
TabulatedSizes table_of(const SizeRows& rows, const RowReporter& report_size, const RowReporter& report_passing);

/// The part of a table that has sizes, with shares from 0 to 1. What passes the smallest size and what stays on the
/// largest one have no sizes: throws InputError where there is such a volume, unless `from` [m] is that smallest size
/// or more, or `to` [m] that largest one or less, so that the cut leaves it out.
TabulatedSizes with_known_ends(TabulatedSizes table, std::optional<double> from, std::optional<double> to);

}  // namespace breccia
