#include "studio/private_directory.hpp"

#include <cstdlib>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia::studio {

PrivateDirectory::PrivateDirectory() {
  auto pattern = (std::filesystem::temp_directory_path() / "breccia-studio-XXXXXX").string();
  // Its owner alone can read and write it.
  if (::mkdtemp(pattern.data()) == nullptr) throw FileError(fmt::format("{}: cannot make the directory", pattern));
  path_ = pattern;
}

PrivateDirectory::~PrivateDirectory() {
  std::error_code failure;
  std::filesystem::remove_all(path_, failure);
}

std::filesystem::path PrivateDirectory::next() {
  const std::lock_guard lock(mutex_);
  constexpr int kept = 8;
  std::error_code failure;
  std::filesystem::remove_all(path_ / std::to_string(++count_ - kept), failure);
  return path_ / std::to_string(count_);
}

}  // namespace breccia::studio
