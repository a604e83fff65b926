#include "rasters/zlib_stream.hpp"

#include <zlib.h>

namespace breccia {

std::string zlib_stream(std::string_view bytes) {
  constexpr int effort = 4;
  auto size = compressBound(static_cast<uLong>(bytes.size()));
  std::string compressed(size, '\0');
  compress2(reinterpret_cast<Bytef*>(compressed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
            static_cast<uLong>(bytes.size()), effort);
  compressed.resize(size);
  return compressed;
}

}  // namespace breccia
