#pragma once

#include <string>
#include <string_view>

namespace breccia {

/// The report as one HTML document, which needs no other file and no network: the page of src/report/page with a title
/// and its data, a JSON object (docs/results.md).
std::string report_page(std::string_view title, std::string_view data);

}  // namespace breccia
