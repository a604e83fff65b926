#pragma once

#include <string_view>
#include <vector>

#include <pugixml.hpp>

namespace breccia::detail {

/// The name of an element without the prefix of its namespace, which depends on the program that wrote it.
std::string_view local_name(const pugi::xml_node& node);

/// The first child of a local name; an empty node if there is none.
pugi::xml_node child(const pugi::xml_node& node, std::string_view name);

/// The children of a local name.
std::vector<pugi::xml_node> children(const pugi::xml_node& node, std::string_view name);

}  // namespace breccia::detail
