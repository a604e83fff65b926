#include "test_fields.hpp"

#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <variant>
#include <vector>

#include <pybind11/numpy.h>

#include "breccia/homogenisation/study_result.hpp"

#include "views.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

/// Fields of a lattice as a dictionary of views, [y, x, component] or [z, y, x, component].
template <int dim>
py::dict fields_of(const TimedFields<dim>& timed, const py::object& owner) {
  using Fields = LatticeFields<dim>;
  const Fields& fields = timed.fields;
  const auto shape = [&fields](std::size_t components) {
    std::vector<py::ssize_t> extents;
    // A square has two points along each axis, a cube one mean value.
    for (const auto cells : fields.cells.size()) extents.insert(extents.begin(), dim == 2 ? 2 * cells : cells);
    if (components > 0) extents.push_back(static_cast<py::ssize_t>(components));
    return extents;
  };
  py::dict result;
  result["time"] = timed.time;
  result["phase"] = view_of(fields.phase.data(), shape(0), owner);
  result["displacement"] = view_of(fields.displacement.front().data(), shape(static_cast<std::size_t>(dim)), owner);
  result["strain"] = view_of(fields.strain.front().data(), shape(dim + Fields::shears), owner);
  result["stress"] = view_of(fields.stress.front().data(), shape(3 + Fields::shears), owner);
  return result;
}

/// Number of the components of a value: one of a number.
template <class Value>
constexpr py::ssize_t components = 1;
template <std::size_t count>
constexpr py::ssize_t components<std::array<double, count>> = static_cast<py::ssize_t>(count);

/// A number, or several, of each cell of grains and films as an array.
template <int dim, class Value>
py::array each_of(const std::vector<FilmCell<dim>>& cells, Value FilmCell<dim>::*member) {
  std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(cells.size())};
  if (!std::is_same_v<Value, double>) shape.push_back(components<Value>);
  py::array_t<double> array(shape);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::memcpy(array.mutable_data() + static_cast<py::ssize_t>(i) * components<Value>, &(cells[i].*member),
                sizeof(Value));
  }
  return array;
}

/// Fields of grains and films as a dictionary of arrays.
template <int dim>
py::dict fields_of(const TimedFilmFields<dim>& timed, const py::object& /*owner*/) {
  const auto& [points, displacement, cells, corners] = timed.fields;
  const auto places = [](const std::vector<Vector<dim>>& list) {
    const double* const first = list.empty() ? nullptr : list.front().data();
    return py::array_t<double>({static_cast<py::ssize_t>(list.size()), py::ssize_t{dim}}, first);
  };
  py::array_t<int> parts(static_cast<py::ssize_t>(cells.size()));
  py::array_t<std::size_t> firsts(static_cast<py::ssize_t>(cells.size() + 1));
  firsts.mutable_data()[0] = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    parts.mutable_data()[i] = static_cast<int>(cells[i].part);
    firsts.mutable_data()[i + 1] = firsts.data()[i] + cells[i].corners;
  }
  py::dict result;
  result["time"] = timed.time;
  result["points"] = places(points);
  result["displacement"] = places(displacement);
  result["part"] = parts;
  result["corners"] = py::array_t<std::size_t>(static_cast<py::ssize_t>(corners.size()), corners.data());
  result["first_corner"] = firsts;
  result[dim == 2 ? "area" : "volume"] = each_of(cells, &FilmCell<dim>::content);
  result["strain"] = each_of(cells, &FilmCell<dim>::strain);
  result["stress"] = each_of(cells, &FilmCell<dim>::stress);
  result["work"] = each_of(cells, &FilmCell<dim>::work);
  result["slip"] = each_of(cells, &FilmCell<dim>::slip);
  result["opening"] = each_of(cells, &FilmCell<dim>::opening);
  result["flow"] = each_of(cells, &FilmCell<dim>::flow);
  return result;
}

}  // namespace

py::list fields_of_test(const py::object& self) {
  const auto& test = self.cast<const TestResult&>();
  py::list fields;
  const auto append = [&](const auto& of_model) {
    for (const auto& one : of_model.at_times) fields.append(fields_of(one, self));
  };
  std::visit(append, test.fields);
  return fields;
}

}  // namespace breccia::python
