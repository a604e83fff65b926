#pragma once

#include <string>
#include <string_view>

namespace breccia {

/// The report of a study as an HTML document that needs neither other files nor a network. `data` is a JSON object
/// (docs/results.md).
std::string study_page(std::string_view title, std::string_view data);

/// The page of a study with rotatable views of the stages of three dimensions, which `data` has as `views`.
std::string study_page_with_views(std::string_view title, std::string_view data);

/// The report of a sweep as an HTML document, like study_page().
std::string sweep_page(std::string_view title, std::string_view data);

/// The page of an assessment (docs/uncertainty.md) as an HTML document, like study_page().
std::string assess_page(std::string_view title, std::string_view data);

/// The report of a fit (docs/fitting.md) as an HTML document, like study_page().
std::string fit_page(std::string_view title, std::string_view data);

}  // namespace breccia
