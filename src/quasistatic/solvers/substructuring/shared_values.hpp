#pragma once

#include <span>
#include <vector>

#include <petscsf.h>

#include "quasistatic/operator/petsc_handle.hpp"

namespace breccia::quasistatic {

/// Values of which several processes hold copies. One of the processes owns a value; the others have an entry for their
/// copy in a list of their own, which also has the values that they own. On one process there are no copies, and the
/// exchanges do nothing. All processes of the group call them together.
class SharedValues {
 public:
  /// The index of a copy on this process, and where the value is.
  struct Copy {
    int index;
    int owner;           ///< rank of the process
    int index_at_owner;  ///< in the list of that process
  };

  /// No copies on any process.
  SharedValues() = default;
  /// `size` is the length of the list of this process.
  SharedValues(int size, const std::vector<Copy>& copies);

  /// Adds the entries of the copies to the values of the owners.
  void add_to_owners(std::span<double> values) const;
  /// Sets the copies to the values of the owners.
  void copy_from_owners(std::span<double> values) const;
  void copy_from_owners(std::span<int> values) const;
  /// Sets the copies to the values of the owners, of `each` numbers a value.
  void copy_from_owners(std::span<double> values, int each) const;
  /// Sets the values of the owners to the copies, `each` numbers a value. A value has one copy, or none and is left.
  void copy_to_owners(std::span<double> values, int each) const;

  /// Adds up the contributions of all processes, which then all have the sums.
  void sum(std::span<double> contributions) const {
    add_to_owners(contributions);
    copy_from_owners(contributions);
  }

 private:
  PetscHandle<PetscSF, PetscSFDestroy> exchange_;  ///< null where there are no copies
};

}  // namespace breccia::quasistatic
