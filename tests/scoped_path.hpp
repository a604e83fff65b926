#pragma once

#include <string>

#include "scoped_variable.hpp"

namespace breccia::test {

/// Sets the PATH of this process, and of processes that it starts, during the lifetime of this object.
class ScopedPath {
 public:
  explicit ScopedPath(const std::string& path) : path_("PATH", path) {}

 private:
  ScopedVariable path_;
};

}  // namespace breccia::test
