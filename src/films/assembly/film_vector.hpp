#pragma once

#include <string>
#include <utility>

#include <Eigen/Core>

#include "checkpoint/state.hpp"

namespace breccia::films {

/// A displacement of grains and films: the amplitude of the macroscopic part, the unit strain of a load, and the
/// fluctuations of the grains with the flows in the films, in the order of Unknowns. Lengths are in sides
/// of the box. Forces are stored like the displacements on which they do work.
class FilmVector {
 public:
  FilmVector(double macroscopic, Eigen::VectorXd unknowns)
      : macroscopic_(macroscopic), unknowns_(std::move(unknowns)) {}

  [[nodiscard]] double macroscopic() const noexcept { return macroscopic_; }
  void set_macroscopic(double amplitude) noexcept { macroscopic_ = amplitude; }
  [[nodiscard]] const Eigen::VectorXd& unknowns() const noexcept { return unknowns_; }
  void set_unknowns(Eigen::VectorXd unknowns) { unknowns_ = std::move(unknowns); }

  /// this += factor * other
  void add(double factor, const FilmVector& other) {
    macroscopic_ += factor * other.macroscopic_;
    unknowns_ += factor * other.unknowns_;
  }
  /// this *= factor
  void scale(double factor) {
    macroscopic_ *= factor;
    unknowns_ *= factor;
  }

 private:
  double macroscopic_;
  Eigen::VectorXd unknowns_;
};

/// Scalar product of forces on the unknowns.
[[nodiscard]] double product(const FilmVector& a, const FilmVector& b);
/// Work of forces on a displacement.
[[nodiscard]] double work(const FilmVector& forces, const FilmVector& displacement);

/// Writes a displacement to a group of a state.
void save(StateWriter& state, const std::string& group, const FilmVector& displacement);
/// Reads a displacement from a group of a state. Throws FileError when the number of unknowns differs.
void restore(const StateReader& state, const std::string& group, FilmVector& displacement);

}  // namespace breccia::films
