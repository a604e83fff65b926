#pragma once

#include <span>

namespace breccia::parallel {

/// The sum of a value over the processes of the group, each of which must call the function. A single process gets its
/// own value back, without starting MPI.
[[nodiscard]] double sum(double value);
/// The largest value over the processes of the group, in the same way.
[[nodiscard]] double largest(double value);

/// Sets values to those of the first process of the group. Each process must call the function, with as many of them.
void copy_from_first(std::span<double> values);

}  // namespace breccia::parallel
