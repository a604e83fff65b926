#pragma once

namespace breccia::parallel {

/// Over the processes of the group, each of which must call it. A process alone gets its own value back, and MPI is not
/// started for it.
[[nodiscard]] double sum(double value);
[[nodiscard]] double largest(double value);

}  // namespace breccia::parallel
