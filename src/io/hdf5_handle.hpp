#pragma once

#include <hdf5.h>

#include "io/hdf5.hpp"

namespace breccia {

static_assert(sizeof(hid_t) == sizeof(std::int64_t), "Hdf5Handle keeps a hid_t");

/// Switches off the error output of the HDF5 library during its lifetime, since failures are reported as FileError. It
/// also switches off the library's clean-up at the end of the program, which would crash if a file could not be closed
/// before because the disk was full.
class Hdf5Silence {
 public:
  Hdf5Silence() noexcept {
    static const bool once = H5dont_atexit() >= 0;
    static_cast<void>(once);
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  Hdf5Silence(const Hdf5Silence&) = delete;
  Hdf5Silence& operator=(const Hdf5Silence&) = delete;
  Hdf5Silence(Hdf5Silence&&) = delete;
  Hdf5Silence& operator=(Hdf5Silence&&) = delete;
  ~Hdf5Silence() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

template <herr_t (*close)(hid_t)>
Hdf5Handle make_handle(hid_t id) {
  return {id, [](std::int64_t handle) -> int { return close(handle); }};
}

inline Hdf5Handle file_handle(hid_t id) {
  return make_handle<H5Fclose>(id);
}
inline Hdf5Handle group_handle(hid_t id) {
  return make_handle<H5Gclose>(id);
}
inline Hdf5Handle object_handle(hid_t id) {
  return make_handle<H5Oclose>(id);
}
inline Hdf5Handle dataset_handle(hid_t id) {
  return make_handle<H5Dclose>(id);
}
inline Hdf5Handle attribute_handle(hid_t id) {
  return make_handle<H5Aclose>(id);
}
inline Hdf5Handle space_handle(hid_t id) {
  return make_handle<H5Sclose>(id);
}
inline Hdf5Handle type_handle(hid_t id) {
  return make_handle<H5Tclose>(id);
}
inline Hdf5Handle property_handle(hid_t id) {
  return make_handle<H5Pclose>(id);
}

/// The type of a fixed-length ASCII string, padded with zeros, as VTKHDF requires.
inline Hdf5Handle ascii_type(std::size_t length) {
  auto type = type_handle(H5Tcopy(H5T_C_S1));
  H5Tset_size(type.id(), length);
  H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
  H5Tset_cset(type.id(), H5T_CSET_ASCII);
  return type;
}

}  // namespace breccia
