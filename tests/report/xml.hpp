#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace breccia::test {

/// The mistakes in an XML text that a small check finds: tags that do not nest, attributes without quotes,
/// stray '<' and '&'. Empty if it is well-formed.
std::string xml_mistake(std::string_view text);

/// Number of occurrences of a part in a text.
std::size_t count(std::string_view text, std::string_view part);

}  // namespace breccia::test
