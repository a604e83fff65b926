#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace breccia::python {

/// Makes an array read-only: it is a view of a result.
inline pybind11::array read_only(pybind11::array array) {
  pybind11::detail::array_proxy(array.ptr())->flags &= ~pybind11::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// One member of each element of a list as a read-only NumPy array without a copy. The array keeps its owner, the
/// Python object that holds the list, alive.
template <class Element>
pybind11::array view_of(const std::vector<Element>& list, double Element::*member, pybind11::handle owner) {
  const auto count = static_cast<pybind11::ssize_t>(list.size());
  const double* first = list.empty() ? nullptr : &(list.front().*member);
  return read_only(pybind11::array_t<double>({count}, {static_cast<pybind11::ssize_t>(sizeof(Element))}, first, owner));
}

/// Memory that belongs to a Python object as a read-only NumPy array of this shape without a copy, the last axis
/// fastest.
template <class Number>
pybind11::array view_of(const Number* first, std::vector<pybind11::ssize_t> shape, pybind11::handle owner) {
  return read_only(pybind11::array_t<Number>(std::move(shape), first, owner));
}

/// A number, or NaN where it is not known.
inline double number_or_nan(const std::optional<double>& number) {
  return number.value_or(std::numeric_limits<double>::quiet_NaN());
}

/// The numbers of a list as a NumPy array of their own.
inline pybind11::array_t<double> array_of(const std::vector<double>& numbers) {
  return pybind11::array_t<double>(static_cast<pybind11::ssize_t>(numbers.size()), numbers.data());
}

}  // namespace breccia::python
