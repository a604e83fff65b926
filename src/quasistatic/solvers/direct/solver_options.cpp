#include "quasistatic/solvers/direct/solver_options.hpp"

#include <fmt/format.h>
#include <petscsys.h>

#include "parallel/session.hpp"

namespace breccia::quasistatic {

void set_default_option(std::string_view prefix, std::string_view name, const char* value) {
  const auto option = fmt::format("-{}{}", prefix, name);
  PetscBool is_set = PETSC_FALSE;
  parallel::check(PetscOptionsHasName(nullptr, nullptr, option.c_str(), &is_set), "reading PETSc's options");
  if (is_set == PETSC_TRUE) return;
  parallel::check(PetscOptionsSetValue(nullptr, option.c_str(), value), "setting PETSc's options");
}

}  // namespace breccia::quasistatic
