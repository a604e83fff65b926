#pragma once

#include <vector>

namespace breccia::films {

/// Share of the length of a line that the share x of its elements takes, which are shorter near both ends of it.
[[nodiscard]] double graded(double x);

/// Shares of the length of a line at which its elements start and end, from 0 to 1 and symmetric: the elements at the
/// ends are about `first` long, each is longer than the one nearer to the end, and none is longer than `longest`. All
/// lengths are in the same unit.
[[nodiscard]] std::vector<double> graded_divisions(double length, double first, double longest);

}  // namespace breccia::films
