#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "temporary_directory.hpp"

namespace breccia::fuzz {

/// The bytes of an input as text.
inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// A directory for inputs, with the files of fuzz/data that inputs may name.
class InputFolder : public test::TemporaryDirectory {
 public:
  InputFolder() { std::filesystem::copy(BRECCIA_FUZZ_DATA, path(), std::filesystem::copy_options::recursive); }
};

}  // namespace breccia::fuzz
