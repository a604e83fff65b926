#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "breccia/rasters/raster.hpp"
#include "breccia/study/packing_method.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// The keys of a deck for a picture, apart from the meaning of its values.
struct AskedPicture {
  std::filesystem::path file;
  std::string array = {};  ///< data set of the file; empty if none was named
  std::optional<std::int64_t> page = {};
  std::optional<PictureCrop> crop = {};  ///< without extents after a mistake
};

/// The picture that a stage asks for; nothing where it is not known because of a mistake.
std::optional<AskedPicture> asked_picture(const Section& packing, int dimensions);

/// The name of a picture in the cache of files.
std::string name_in_cache(const AskedPicture& asked, int dimensions);

/// Reads a picture, or a stack of three dimensions, and crops it. Reports one that cannot be read, and one that is no
/// square or cube then.
std::optional<Raster> read_picture(const Section& packing, const AskedPicture& asked, int dimensions);

}  // namespace breccia
