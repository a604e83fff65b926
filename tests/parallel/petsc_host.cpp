// A program that has started PETSc before it uses Breccia, and goes on with PETSc afterwards.

#include <cstdio>

#include <petscsys.h>

#include "breccia/error.hpp"

#include "parallel/session.hpp"

int main() {
  if (PetscInitializeNoArguments() != 0) return 1;
  bool is_refused = false;
  try {
    breccia::parallel::divide(1);
  } catch (const breccia::InputError&) {
    is_refused = true;
  }
  breccia::parallel::stop();
  PetscBool is_running = PETSC_FALSE;
  if (PetscInitialized(&is_running) != 0 || is_running != PETSC_TRUE) {
    std::puts("the library has ended PETSc, which it has not started");
    return 1;
  }
  if (!is_refused) std::puts("the processes of a host that runs PETSc were divided");
  return PetscFinalize() == 0 && is_refused ? 0 : 1;
}
