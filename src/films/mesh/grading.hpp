#pragma once

#include <vector>

namespace breccia::films {

/// Where along a line the share x of its elements ends: they are shorter near its ends.
[[nodiscard]] double graded(double x);

/// Shares of the length of a line at which its elements begin and end, from 0 to 1, the same from both ends: the
/// elements at the ends are about `first` long, each is longer than the one nearer to the end, and none is longer than
/// `longest`. Lengths are in one unit.
[[nodiscard]] std::vector<double> graded_divisions(double length, double first, double longest);

}  // namespace breccia::films
