#pragma once

#include <string>

namespace breccia {

/// The data of a page.
struct PageData {
  std::string title;
  std::string json;
  bool has_views = false;  ///< whether there are `views` of three dimensions in it
};

}  // namespace breccia
