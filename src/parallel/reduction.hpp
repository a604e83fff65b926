#pragma once

#include <functional>
#include <span>

namespace breccia::parallel {

/// The sum of a value over the processes of the group, each of which must call the function. A single process receives
/// its own value, without starting MPI.
[[nodiscard]] double sum(double value);
/// The largest value over the processes of the group, each of which must call the function. A single process receives
/// its own value, without starting MPI.
[[nodiscard]] double largest(double value);
/// Whether the value of this process is the largest, and this is the first of the processes that have it.
[[nodiscard]] bool is_first_largest(double value);

/// Sums whose rounding does not depend on the number of processes: one process after the other adds its terms to the
/// sums of those before it by add(sums). At the end each process has the sums of all processes. Each must call the
/// function, with the same number of sums, which are zero. Processes wait for one another, so that it is too slow for
/// every step; add() must not throw.
void sum_in_order(std::span<double> sums, const std::function<void(std::span<double>)>& add);

/// Sets values to those of the first process of the group. Each process must call the function, with the same number of
/// values.
void copy_from_first(std::span<double> values);

}  // namespace breccia::parallel
