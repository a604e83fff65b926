#pragma once

#include <string>

#include "breccia/checkpoint/state.hpp"

#include "petsc_handle.hpp"

namespace breccia::quasistatic {

/// A displacement u = a E x + w in units of the cell side: a share a of the affine motion of the load, and the rest on
/// the nodes (theory, Eq. 16). Or what does work on it: a force conjugate to a, and nodal forces conjugate to w.
class Field {
 public:
  Field(double affine, NodalVector rest) : affine_(affine), rest_(std::move(rest)) {}

  /// Another one of this size, zero.
  [[nodiscard]] Field zero() const;
  [[nodiscard]] Field copy() const;

  [[nodiscard]] double affine() const noexcept { return affine_; }
  void set_affine(double affine) noexcept { affine_ = affine; }
  [[nodiscard]] Vec rest() const noexcept { return rest_.get(); }

  /// this += factor * other
  void add(double factor, const Field& other);
  /// this *= factor
  void scale(double factor);
  void set_zero();

 private:
  double affine_;
  NodalVector rest_;
};

/// Leaves a field in a group of a state. Every process must call it.
void save(StateWriter& state, const std::string& group, const Field& field);
/// Takes it up, into a field of its size. Throws FileError when the sizes differ.
void restore(const StateReader& state, const std::string& group, Field& field);

/// What several processes find depends, in the last digits, on how many there are: throws InputError when the state
/// was left by another number of them.
void require_as_many_processes(const StateReader& state);

/// Work of forces on a displacement; the same on all ranks.
[[nodiscard]] double work(const Field& forces, const Field& displacement);

}  // namespace breccia::quasistatic
