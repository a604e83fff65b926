#pragma once

#include <cstddef>
#include <string>

#include "breccia/campaign/sweep.hpp"

namespace breccia::cli {

/// `task 3 of 10: seed-3`, the first being number 0.
std::string heading_of(const Sweep& sweep, std::size_t task);

/// The tasks of a sweep with their values, one a line.
std::string table_of_tasks(const Sweep& sweep);

/// The result of a sweep in a few lines: the last stage at whole decades, over the seeds or task by task.
std::string closing_table(const Sweep& sweep, const SweepResult& result);

}  // namespace breccia::cli
