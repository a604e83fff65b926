#pragma once

#include <string>
#include <string_view>

namespace breccia {

/// Reports as HTML documents, which need no other file and no network: a page of src/report/page with a title and its
/// data, a JSON object (docs/results.md).

/// Of a study.
std::string study_page(std::string_view title, std::string_view data);

/// Of a sweep.
std::string sweep_page(std::string_view title, std::string_view data);

}  // namespace breccia
