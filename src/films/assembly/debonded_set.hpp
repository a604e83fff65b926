#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>

#include <Eigen/Core>

#include "breccia/films/debonding.hpp"

namespace breccia::films {

/// Whether a film that is debonded in this way, or bonded, carries nothing.
[[nodiscard]] constexpr bool is_gap(const std::optional<Debonding>& debonding) noexcept {
  return debonding == Debonding::open || debonding == Debonding::sealed;
}

/// Finds out by its grains whether a film is debonded.
template <int dim>
class DebondedSet {
 public:
  using Image = Eigen::Matrix<int, dim, 1>;

  explicit DebondedSet(const DebondedFilms<dim>& films) : kind_(films.kind) {
    for (const auto& [first, second, image] : films.faces) {
      const Image displacement = Image::Map(image.data());
      faces_.insert(key_of({first, second}, displacement));
      faces_.insert(key_of({second, first}, -displacement));
    }
  }

  /// How the film between a grain and the image of a second one, displaced by whole sides of the box, is debonded;
  /// nothing where it is bonded.
  [[nodiscard]] std::optional<Debonding> operator()(const std::array<std::size_t, 2>& grains,
                                                    const Image& image) const {
    return faces_.contains(key_of(grains, image)) ? std::optional(kind_) : std::nullopt;
  }

 private:
  using Key = std::pair<std::array<std::size_t, 2>, Index<dim>>;

  static Key key_of(const std::array<std::size_t, 2>& grains, const Image& image) {
    Index<dim> displacement{};
    Image::Map(displacement.data()) = image;
    return {grains, displacement};
  }

  Debonding kind_;
  std::set<Key> faces_;
};

}  // namespace breccia::films
