#pragma once

#include <string>

#include "benchmark/kernel_benchmark.hpp"

namespace breccia::cli {

/// A table of the medians.
std::string table_of(const BenchmarkResult& result);

/// The medians and every measurement as JSON, with the units at the ends of the names.
std::string json_of(const BenchmarkResult& result);

}  // namespace breccia::cli
