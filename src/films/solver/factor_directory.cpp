#include "films/solver/factor_directory.hpp"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia::films {
namespace {

constexpr auto purpose = "films: the factors of the matrix are kept in files";

std::filesystem::path directory_of_files() {
  std::error_code error;
  auto directory = std::filesystem::temp_directory_path(error);
  if (!error) return directory;
  throw InputError(fmt::format(
      "{}, and there is no directory for temporary files: the environment variable TMPDIR names none", purpose));
}

}  // namespace

FactorDirectory::FactorDirectory() {
  auto name = (directory_of_files() / "breccia-factors-XXXXXX").string();
  if (name.size() > longest_name) {
    throw InputError(
        fmt::format("{}, and the name of their directory, {}, has {} characters: expected at most {}; the environment "
                    "variable TMPDIR names another one",
                    purpose, name, name.size(), longest_name));
  }
  if (::mkdtemp(name.data()) == nullptr) {
    throw InputError(
        fmt::format("{}, and the directory {} cannot be made: {}; the environment variable TMPDIR names "
                    "another place",
                    purpose, name, std::generic_category().message(errno)));
  }
  path_ = name;
}

FactorDirectory::~FactorDirectory() {
  std::error_code is_gone;
  std::filesystem::remove_all(path_, is_gone);
}

}  // namespace breccia::films
