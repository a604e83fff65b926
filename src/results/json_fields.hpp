#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// A member of a struct and its key in a file.
template <class Struct, class Value>
struct Field {
  const char* key;
  Value Struct::*member;
  bool is_left_out_if_empty;  ///< whether a file leaves out an optional member that is empty; otherwise it has a null
};

template <class Struct, class Value>
constexpr Field<Struct, Value> field(const char* key, Value Struct::*member) {
  return {key, member, false};
}

/// A field that a file leaves out where it is empty.
template <class Struct, class Value>
constexpr Field<Struct, std::optional<Value>> field_if_any(const char* key, std::optional<Value> Struct::*member) {
  return {key, member, true};
}

/// The description of a struct: its fields, in the order in which a file has them. Each struct that is written defines
/// its own, `template <> inline constexpr auto fields<Overlap> = std::tuple(field("window_s", &Overlap::window), ...)`.
template <class Struct>
inline constexpr std::nullptr_t fields = nullptr;

template <class Struct>
concept HasFields = !std::is_same_v<decltype(fields<Struct>), const std::nullptr_t>;

/// Writes and reads a type that is not a struct of fields: a specialisation for the type defines `write(value)` and
/// `read(json)`.
template <class Value>
struct JsonForm {};

template <class Value>
concept HasJsonForm = requires(const Value& value) {
  JsonForm<Value>::write(value);
};

/// A value into which fields are read; a type without a default value specialises it.
template <class Value>
[[nodiscard]] Value blank_value() {
  return {};
}

template <class Value>
[[nodiscard]] nlohmann::ordered_json json_from(const Value& value);
template <class Value>
[[nodiscard]] Value value_from(const nlohmann::ordered_json& json);

/// Adds the fields of a struct to an object.
template <HasFields Struct>
void add_fields(nlohmann::ordered_json& object, const Struct& value) {
  const auto add = [&](const auto& field) {
    auto json = json_from(value.*field.member);
    if (!field.is_left_out_if_empty || !json.is_null()) object[field.key] = std::move(json);
  };
  std::apply([&](const auto&... field) { (add(field), ...); }, fields<Struct>);
}

/// Reads the fields of a struct from an object. Throws an exception of nlohmann::json, or InputError, where a field is
/// missing or has another type.
template <HasFields Struct>
void read_fields(const nlohmann::ordered_json& object, Struct& value) {
  const auto read = [&](const auto& field) {
    using Value = std::remove_reference_t<decltype(value.*field.member)>;
    if (field.is_left_out_if_empty && !object.contains(field.key)) return;
    value.*field.member = value_from<Value>(object.at(field.key));
  };
  std::apply([&](const auto&... field) { (read(field), ...); }, fields<Struct>);
}

template <class Value>
struct JsonForm<std::optional<Value>> {
  static nlohmann::ordered_json write(const std::optional<Value>& value) {
    return value ? json_from(*value) : nlohmann::ordered_json();
  }
  static std::optional<Value> read(const nlohmann::ordered_json& json) {
    if (json.is_null()) return std::nullopt;
    return value_from<Value>(json);
  }
};

template <class Value>
struct JsonForm<std::vector<Value>> {
  static nlohmann::ordered_json write(const std::vector<Value>& values) {
    auto array = nlohmann::ordered_json::array();
    for (const auto& value : values) array.push_back(json_from(value));
    return array;
  }
  static std::vector<Value> read(const nlohmann::ordered_json& json) {
    if (!json.is_array()) throw InputError("expected a list");
    std::vector<Value> values;
    for (const auto& one : json) values.push_back(value_from<Value>(one));
    return values;
  }
};

template <>
struct JsonForm<double> {
  static nlohmann::ordered_json write(double value) { return value; }
  static double read(const nlohmann::ordered_json& json) { return json.get<double>(); }
};

template <std::integral Integer>
requires(!std::is_same_v<Integer, bool>) struct JsonForm<Integer> {
  static nlohmann::ordered_json write(Integer value) { return value; }
  static Integer read(const nlohmann::ordered_json& json) {
    if (json.is_number_unsigned() ? std::in_range<Integer>(json.get<std::uint64_t>())
                                  : json.is_number_integer() && std::in_range<Integer>(json.get<std::int64_t>())) {
      return json.get<Integer>();
    }
    throw InputError(fmt::format("expected an integer in place of {}", json.dump()));
  }
};

template <HasWords Enum>
struct JsonForm<Enum> {
  static nlohmann::ordered_json write(Enum value) { return name_of(value); }
  static Enum read(const nlohmann::ordered_json& json) {
    const auto name = json.get<std::string>();
    if (const auto value = value_named<Enum>(name)) return *value;
    throw InputError(fmt::format("unknown word \"{}\"", name));
  }
};

template <class Value>
nlohmann::ordered_json json_from(const Value& value) {
  if constexpr (HasJsonForm<Value>) {
    return JsonForm<Value>::write(value);
  } else if constexpr (HasFields<Value>) {
    auto object = nlohmann::ordered_json::object();
    add_fields(object, value);
    return object;
  } else {
    return value;
  }
}

template <class Value>
Value value_from(const nlohmann::ordered_json& json) {
  if constexpr (HasJsonForm<Value>) {
    return JsonForm<Value>::read(json);
  } else if constexpr (HasFields<Value>) {
    auto value = blank_value<Value>();
    read_fields(json, value);
    return value;
  } else {
    return json.get<Value>();
  }
}

}  // namespace breccia
