#include "fields_state.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace breccia::python {
namespace {

namespace py = pybind11;

/// A list of arrays of numbers as one array, and back.
template <std::size_t count>
py::array_t<double> flat(const std::vector<std::array<double, count>>& rows) {
  const double* const first = rows.empty() ? nullptr : rows.front().data();
  return py::array_t<double>({static_cast<py::ssize_t>(rows.size()), static_cast<py::ssize_t>(count)}, first);
}

template <std::size_t count>
std::vector<std::array<double, count>> rows_from(const py::handle& state) {
  const auto numbers = state.cast<py::array_t<double, py::array::c_style>>();
  std::vector<std::array<double, count>> rows(static_cast<std::size_t>(numbers.shape(0)));
  for (std::size_t i = 0; i < rows.size(); ++i) std::copy_n(numbers.data() + i * count, count, rows[i].begin());
  return rows;
}

template <int dim>
py::list state_of_all(const std::vector<TimedFields<dim>>& all) {
  py::list states;
  for (const auto& [time, fields] : all) {
    const py::array_t<PhaseIndex> phases(static_cast<py::ssize_t>(fields.phase.size()), fields.phase.data());
    states.append(py::make_tuple(time, phases, flat(fields.displacement), flat(fields.strain), flat(fields.stress),
                                 fields.cells.begin, fields.cells.end));
  }
  return states;
}

}  // namespace

py::list state_of_fields(const std::vector<TimedFields<2>>& all) {
  return state_of_all(all);
}

py::list state_of_fields(const std::vector<TimedFields<3>>& all) {
  return state_of_all(all);
}

py::list state_of_fields(const std::vector<TimedFilmFields>& all) {
  py::list states;
  for (const auto& [time, fields] : all) {
    // A cell has plain numbers alone, so that its bytes are its state.
    static_assert(std::is_trivially_copyable_v<FilmCell>);
    const auto* const cells = reinterpret_cast<const char*>(fields.cells.data());
    states.append(py::make_tuple(time, flat(fields.points), flat(fields.displacement),
                                 py::bytes(cells, fields.cells.size() * sizeof(FilmCell)), fields.corners));
  }
  return states;
}

template <int dim>
std::vector<TimedFields<dim>> fields_from(const py::list& states) {
  constexpr std::size_t size = dim, shears = LatticeFields<dim>::shears;
  std::vector<TimedFields<dim>> all;
  for (const auto& one : states) {
    const auto state = one.cast<py::tuple>();
    auto& [time, fields] = all.emplace_back();
    time = state[0].cast<double>();
    const auto phases = state[1].cast<py::array_t<PhaseIndex>>();
    fields.phase.assign(phases.data(), phases.data() + phases.size());
    fields.displacement = rows_from<size>(state[2]);
    fields.strain = rows_from<size + shears>(state[3]);
    fields.stress = rows_from<3 + shears>(state[4]);
    fields.cells = {state[5].cast<Index<dim>>(), state[6].cast<Index<dim>>()};
  }
  return all;
}

template std::vector<TimedFields<2>> fields_from<2>(const py::list& states);
template std::vector<TimedFields<3>> fields_from<3>(const py::list& states);

std::vector<TimedFilmFields> film_fields_from(const py::list& states) {
  std::vector<TimedFilmFields> all;
  for (const auto& one : states) {
    const auto state = one.cast<py::tuple>();
    auto& [time, fields] = all.emplace_back();
    time = state[0].cast<double>();
    fields.points = rows_from<2>(state[1]);
    fields.displacement = rows_from<2>(state[2]);
    const auto cells = state[3].cast<std::string>();
    fields.cells.resize(cells.size() / sizeof(FilmCell));
    std::memcpy(fields.cells.data(), cells.data(), fields.cells.size() * sizeof(FilmCell));
    fields.corners = state[4].cast<std::vector<std::size_t>>();
  }
  return all;
}

}  // namespace breccia::python
