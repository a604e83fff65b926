#pragma once

#include <string>
#include <string_view>

namespace breccia {

/// Bytes as a compressed stream of zlib (RFC 1950).
std::string zlib_stream(std::string_view bytes);

}  // namespace breccia
