#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>

#include <zip.h>

namespace breccia::test {

/// Writes a ZIP archive of parts with these paths, as they are or compressed.
inline void write_archive(const std::filesystem::path& path, const std::map<std::string, std::string>& parts,
                          zip_int32_t compression = ZIP_CM_DEFAULT) {
  auto* archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
  if (archive == nullptr) throw std::runtime_error("no archive");
  for (const auto& [name, content] : parts) {
    auto* source = zip_source_buffer(archive, content.data(), content.size(), 0);
    const auto index = zip_file_add(archive, name.c_str(), source, ZIP_FL_OVERWRITE);
    if (index < 0 || zip_set_file_compression(archive, static_cast<zip_uint64_t>(index), compression, 0) != 0) {
      throw std::runtime_error("no part of an archive");
    }
  }
  if (zip_close(archive) != 0) throw std::runtime_error("no archive");
}

}  // namespace breccia::test
