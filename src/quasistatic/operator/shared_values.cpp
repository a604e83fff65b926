#include "quasistatic/operator/shared_values.hpp"

namespace breccia::quasistatic {
namespace {

constexpr const char* exchanging = "exchanging values between processes";

/// A type of MPI for several numbers.
class Numbers {
 public:
  explicit Numbers(int count) {
    MPI_Type_contiguous(count, MPI_DOUBLE, &type_);
    MPI_Type_commit(&type_);
  }
  Numbers(const Numbers&) = delete;
  Numbers& operator=(const Numbers&) = delete;
  Numbers(Numbers&&) = delete;
  Numbers& operator=(Numbers&&) = delete;
  ~Numbers() { MPI_Type_free(&type_); }

  [[nodiscard]] MPI_Datatype get() const noexcept { return type_; }

 private:
  MPI_Datatype type_ = MPI_DATATYPE_NULL;
};

void from_owners(PetscSF exchange, MPI_Datatype type, void* values) {
  check(PetscSFBcastBegin(exchange, type, values, values, MPI_REPLACE), exchanging);
  check(PetscSFBcastEnd(exchange, type, values, values, MPI_REPLACE), exchanging);
}

void to_owners(PetscSF exchange, MPI_Datatype type, void* values, MPI_Op operation) {
  check(PetscSFReduceBegin(exchange, type, values, values, operation), exchanging);
  check(PetscSFReduceEnd(exchange, type, values, values, operation), exchanging);
}

}  // namespace

SharedValues::SharedValues(int size, const std::vector<Copy>& copies) {
  if (parallel::ranks() == 1) return;
  std::vector<PetscInt> indices;
  std::vector<PetscSFNode> sources;
  for (const auto& [index, owner, index_at_owner] : copies) {
    indices.push_back(index);
    sources.push_back({.rank = owner, .index = index_at_owner});
  }
  const auto count = static_cast<PetscInt>(copies.size());
  check(PetscSFCreate(PETSC_COMM_WORLD, exchange_.put()), exchanging);
  check(PetscSFSetGraph(exchange_.get(), size, count, indices.data(), PETSC_COPY_VALUES, sources.data(),
                        PETSC_COPY_VALUES),
        exchanging);
  check(PetscSFSetUp(exchange_.get()), exchanging);
}

void SharedValues::add_to_owners(std::span<double> values) const {
  if (exchange_.get() != nullptr) to_owners(exchange_.get(), MPIU_REAL, values.data(), MPI_SUM);
}

void SharedValues::copy_from_owners(std::span<double> values) const {
  if (exchange_.get() != nullptr) from_owners(exchange_.get(), MPIU_REAL, values.data());
}

void SharedValues::copy_from_owners(std::span<int> values) const {
  if (exchange_.get() != nullptr) from_owners(exchange_.get(), MPI_INT, values.data());
}

void SharedValues::copy_from_owners(std::span<double> values, int each) const {
  if (exchange_.get() != nullptr) from_owners(exchange_.get(), Numbers(each).get(), values.data());
}

void SharedValues::copy_to_owners(std::span<double> values, int each) const {
  if (exchange_.get() != nullptr) to_owners(exchange_.get(), Numbers(each).get(), values.data(), MPI_REPLACE);
}

}  // namespace breccia::quasistatic
