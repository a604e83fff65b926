#include "io/file_status.hpp"

#include <system_error>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

std::filesystem::file_status status_of(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  // A missing file is a valid status, though the system reports it as an error.
  if (status.type() != std::filesystem::file_type::none) return status;
  throw FileError(fmt::format("{}: cannot be looked at: {}", path.string(), error.message()));
}

}  // namespace breccia
