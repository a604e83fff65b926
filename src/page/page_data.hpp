#pragma once

#include <string>

namespace breccia {

/// The data of a page.
struct PageData {
  std::string title;
  std::string json;
  bool has_views = false;  ///< whether the data contain `views` of three dimensions
};

}  // namespace breccia
