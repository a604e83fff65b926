#pragma once

#include <string>

namespace breccia {

/// What a page shows.
struct PageData {
  std::string title;
  std::string json;
};

}  // namespace breccia
