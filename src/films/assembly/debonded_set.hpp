#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>

#include <Eigen/Core>

#include "breccia/films/debonding.hpp"
#include "breccia/films/film_fields.hpp"

namespace breccia::films {

/// Whether a film that is debonded in this way, or bonded, carries nothing.
[[nodiscard]] constexpr bool is_gap(const std::optional<Debonding>& debonding) noexcept {
  return debonding == Debonding::open || debonding == Debonding::sealed;
}

/// The part of the fields to which a film belongs that is debonded in this way, or bonded.
[[nodiscard]] constexpr FilmPart part_of_film(const std::optional<Debonding>& debonding) noexcept {
  if (!debonding) return FilmPart::film;
  if (is_gap(debonding)) return FilmPart::gap;
  return *debonding == Debonding::slip ? FilmPart::slip : FilmPart::spring;
}

/// Finds out by its grains whether a film is debonded.
template <int dim>
class DebondedSet {
 public:
  using Image = Eigen::Matrix<int, dim, 1>;

  explicit DebondedSet(const DebondedFilms<dim>& films) : kind_(films.kind) {
    for (const auto& [first, second, image] : films.faces) {
      const Image displacement = Image::Map(image.data());
      faces_.insert(face_of({first, second}, displacement));
      faces_.insert(face_of({second, first}, -displacement));
    }
  }

  /// How the film between a grain and the image of a second one, displaced by whole sides of the box, is debonded;
  /// nothing where it is bonded.
  [[nodiscard]] std::optional<Debonding> operator()(const std::array<std::size_t, 2>& grains,
                                                    const Image& image) const {
    return faces_.contains(face_of(grains, image)) ? std::optional(kind_) : std::nullopt;
  }

 private:
  static CellFace<dim> face_of(const std::array<std::size_t, 2>& grains, const Image& image) {
    CellFace<dim> face{grains[0], grains[1], {}};
    Image::Map(face.image.data()) = image;
    return face;
  }

  Debonding kind_;
  std::set<CellFace<dim>> faces_;
};

}  // namespace breccia::films
