#pragma once

#include <string>

#include "cli/fit_results.hpp"
#include "deck/fit_data.hpp"

namespace breccia::cli {

/// The report of a fit as an HTML document that needs neither other files nor a network; docs/fitting.md describes its
/// content. `source` is the name of the file of the data.
std::string fit_report(const std::string& source, const FitData& data, const FitResult& result);

}  // namespace breccia::cli
