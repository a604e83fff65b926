#pragma once

namespace breccia::parallel {

/// The sum of a value over the processes of the group, each of which must call the function. A single process gets its
/// own value back, without starting MPI.
[[nodiscard]] double sum(double value);
/// The largest value over the processes of the group, in the same way.
[[nodiscard]] double largest(double value);

}  // namespace breccia::parallel
