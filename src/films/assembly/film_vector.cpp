#include "films/assembly/film_vector.hpp"

#include <cstddef>
#include <span>

namespace breccia::films {

double product(const FilmVector& a, const FilmVector& b) {
  return a.unknowns().dot(b.unknowns());
}

double work(const FilmVector& forces, const FilmVector& displacement) {
  return product(forces, displacement) + forces.macroscopic() * displacement.macroscopic();
}

void save(StateWriter& state, const std::string& group, const FilmVector& displacement) {
  const auto& unknowns = displacement.unknowns();
  state.write(group + "/affine", displacement.macroscopic());
  state.write(group + "/unknowns", std::span(unknowns.data(), static_cast<std::size_t>(unknowns.size())));
}

void restore(const StateReader& state, const std::string& group, FilmVector& displacement) {
  const auto count = static_cast<std::size_t>(displacement.unknowns().size());
  const auto unknowns = state.numbers(group + "/unknowns", count);
  displacement.set_unknowns(Eigen::Map<const Eigen::VectorXd>(unknowns.data(), displacement.unknowns().size()));
  displacement.set_macroscopic(state.number(group + "/affine"));
}

}  // namespace breccia::films
