#pragma once

#include <string>
#include <string_view>

#include "breccia/deck/read_study.hpp"
#include "breccia/error.hpp"

#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia::test {

inline constexpr std::string_view materials = R"(
[materials.binder]
density = "1.48 g/cm^3"
bulk = "3.6 GPa"
shear = "1 MPa"
[materials.hmx]
density = "1.85 g/cm^3"
bulk = "13.4 GPa"
shear = "5.84 GPa"
)";

inline constexpr std::string_view stage = R"(
[[stages]]
name = "HB-1"
matrix = "binder"
box = "48 um"
cells = 300
filler = { material = "hmx", fraction = 0.65, from = "2 um", to = "14 um", sizes = { lognormal = [{ median = "8 um", sigma = 1 }] } }
packing = { method = "lubachevsky-stillinger" }
)";

inline constexpr std::string_view tests = R"(
[tests]
times = ["10 ns", "10 ms"]
)";

/// A directory with decks in it.
class DeckDirectory : public TemporaryDirectory {
 public:
  [[nodiscard]] Study study(const std::string& text, const std::vector<std::string>& overrides = {}) const {
    return read_study(written("deck.toml", text), overrides);
  }
  /// The mistakes in a deck, without the directory.
  [[nodiscard]] std::string mistakes(const std::string& text) const {
    const auto message = message_of<InputError>([&] { static_cast<void>(study(text)); });
    return replaced(message, path().string() + "/", "");
  }
};

/// The texts, joined.
template <class... Text>
std::string join(const Text&... texts) {
  return (std::string() + ... + std::string(texts));
}

}  // namespace breccia::test
