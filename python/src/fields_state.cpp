#include "fields_state.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

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
py::tuple state_of(const GridFields<dim>& all) {
  py::list states;
  for (const auto& [time, fields] : all.at_times) {
    const py::array_t<PhaseIndex> phases(static_cast<py::ssize_t>(fields.phase.size()), fields.phase.data());
    states.append(py::make_tuple(time, phases, flat(fields.displacement), flat(fields.strain), flat(fields.stress),
                                 fields.cells.begin, fields.cells.end));
  }
  return py::make_tuple(all.grid.cells, all.grid.cell_side, states);
}

template <int dim>
py::tuple state_of(const NetworkFields<dim>& all) {
  py::list states;
  for (const auto& [time, fields] : all.at_times) {
    // A cell holds only plain numbers, so that its bytes are its state.
    static_assert(std::is_trivially_copyable_v<FilmCell<dim>>);
    const auto* const cells = reinterpret_cast<const char*>(fields.cells.data());
    states.append(py::make_tuple(time, flat(fields.points), flat(fields.displacement),
                                 py::bytes(cells, fields.cells.size() * sizeof(FilmCell<dim>)), fields.corners));
  }
  return py::make_tuple(states);
}

template <int dim>
GridFields<dim> grid_fields_from(const py::tuple& whole) {
  constexpr std::size_t size = dim, shears = LatticeFields<dim>::shears;
  GridFields<dim> all{{whole[0].cast<Index<dim>>(), whole[1].cast<double>()}, {}};
  for (const auto& one : whole[2]) {
    const auto state = one.cast<py::tuple>();
    auto& [time, fields] = all.at_times.emplace_back();
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

template <int dim>
NetworkFields<dim> network_fields_from(const py::tuple& whole) {
  NetworkFields<dim> all;
  for (const auto& one : whole[0]) {
    const auto state = one.cast<py::tuple>();
    auto& [time, fields] = all.at_times.emplace_back();
    time = state[0].cast<double>();
    fields.points = rows_from<dim>(state[1]);
    fields.displacement = rows_from<dim>(state[2]);
    const auto cells = state[3].cast<std::string>();
    fields.cells.resize(cells.size() / sizeof(FilmCell<dim>));
    std::memcpy(fields.cells.data(), cells.data(), fields.cells.size() * sizeof(FilmCell<dim>));
    fields.corners = state[4].cast<std::vector<std::size_t>>();
  }
  return all;
}

}  // namespace

py::tuple state_of_fields(const TestFields& fields) {
  return py::make_tuple(fields.index(), std::visit([](const auto& all) { return state_of(all); }, fields));
}

TestFields fields_from(const py::tuple& state) {
  const auto all = state[1].cast<py::tuple>();
  switch (state[0].cast<std::size_t>()) {
    case 0:
      return grid_fields_from<2>(all);
    case 1:
      return grid_fields_from<3>(all);
    case 2:
      return network_fields_from<2>(all);
    default:
      return network_fields_from<3>(all);
  }
}

}  // namespace breccia::python
