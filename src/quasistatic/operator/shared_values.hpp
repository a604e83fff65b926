#pragma once

#include <span>
#include <vector>

#include <petscsf.h>

#include "quasistatic/operator/petsc_handle.hpp"

namespace breccia::quasistatic {

/// The exchange of values of which several processes hold copies. One of the processes owns a value; the other
/// processes have an entry for their copy in their own list, which also has the values that they own. On one process
/// there are no copies, and the exchanges do nothing. All processes of the group call them together.
class SharedValues {
 public:
  /// The index of a copy on this process, and the location of the value.
  struct Copy {
    int index;
    int owner;           ///< rank of the process that owns the value
    int index_at_owner;  ///< index of the value in the list of that process
  };

  /// An exchange without copies on any process.
  SharedValues() = default;
  /// `size` is the length of the list of this process.
  SharedValues(int size, const std::vector<Copy>& copies);

  /// Adds the entries of the copies to the values of the owners.
  void add_to_owners(std::span<double> values) const;
  /// Sets the copies to the values of the owners.
  void copy_from_owners(std::span<double> values) const;
  void copy_from_owners(std::span<int> values) const;
  /// Sets the copies to the values of the owners; a value has `each` numbers.
  void copy_from_owners(std::span<double> values, int each) const;
  /// Sets the values of the owners to the copies; a value has `each` numbers. A value has at most one copy; without a
  /// copy it is unchanged.
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
