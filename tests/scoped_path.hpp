#pragma once

#include <cstdlib>
#include <string>

namespace breccia::test {

/// Sets the PATH of this process, and of those it starts, as long as it lives.
class ScopedPath {
 public:
  explicit ScopedPath(const std::string& path) {
    if (const char* before = std::getenv("PATH")) before_ = before;
    setenv("PATH", path.c_str(), 1);
  }
  ~ScopedPath() { setenv("PATH", before_.c_str(), 1); }
  ScopedPath(const ScopedPath&) = delete;
  ScopedPath& operator=(const ScopedPath&) = delete;
  ScopedPath(ScopedPath&&) = delete;
  ScopedPath& operator=(ScopedPath&&) = delete;

 private:
  std::string before_;
};

}  // namespace breccia::test
