#include "parallel/blas_threads.hpp"

#include <dlfcn.h>

namespace breccia::parallel {
namespace {

/// A function of a library by its name, or nullptr, since other implementations of the BLAS have no such function. In a
/// module of an interpreter it is not among the symbols of the program but among those of the libraries that this code
/// is linked with.
template <class Function>
Function function_named(const char* name) noexcept {
  void* address = dlsym(RTLD_DEFAULT, name);
  Dl_info here = {};
  if (address == nullptr && dladdr(reinterpret_cast<const void*>(&set_blas_threads), &here) != 0) {
    void* const library = dlopen(here.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
    if (library != nullptr) {
      address = dlsym(library, name);
      dlclose(library);  // the library stays loaded
    }
  }
  // The address of a function comes as an object pointer, which must be converted.
  return reinterpret_cast<Function>(address);
}

}  // namespace

std::optional<int> set_blas_threads(int threads) noexcept {
  const auto get = function_named<int (*)()>("openblas_get_num_threads");
  const auto set = function_named<void (*)(int)>("openblas_set_num_threads");
  if (get == nullptr || set == nullptr) return std::nullopt;
  const int before = get();
  set(threads);
  return before;
}

}  // namespace breccia::parallel
