#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace breccia {

/// Bytes as a text in base64 (RFC 4648).
std::string encode_base64(std::string_view bytes);

/// The bytes of a text in base64 (RFC 4648), also of several concatenated texts, each with its padding. White space is
/// skipped. Returns nothing if the text is not base64 or ends within a group of four.
std::optional<std::string> decode_base64(std::string_view text);

}  // namespace breccia
