#pragma once

#include <string>

namespace breccia {

/// The data of a page.
struct PageData {
  std::string title;
  std::string json;
};

}  // namespace breccia
