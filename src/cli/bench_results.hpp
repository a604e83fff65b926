#pragma once

#include <string>

#include "breccia/benchmark/kernel_benchmark.hpp"

namespace breccia::cli {

/// Medians, for people.
std::string table_of(const BenchmarkResult& result);

/// Medians and every measurement, for programs. Units end the names.
std::string json_of(const BenchmarkResult& result);

}  // namespace breccia::cli
