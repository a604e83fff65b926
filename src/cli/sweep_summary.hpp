#pragma once

#include <cstddef>
#include <string>

#include "campaign/sweep.hpp"

namespace breccia::cli {

/// The heading of a task: `task 3 of 10: seed-3`; `task` counts from 0.
std::string heading_of(const Sweep& sweep, std::size_t task);

/// The tasks of a sweep with their values, one per line.
std::string table_of_tasks(const Sweep& sweep);

/// The result of a sweep in a few lines: the moduli of the last stage at whole decades, over the seeds or for each
/// task.
std::string closing_table(const Sweep& sweep, const SweepResult& result);

/// Throws NumericalError with the names of the failed tasks, if there are any.
void refuse_failures(const Sweep& sweep, const SweepResult& result);

}  // namespace breccia::cli
