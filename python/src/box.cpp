#include "box.hpp"

#include <array>
#include <memory>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/point_labels.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"

#include "io/units.hpp"
#include "results/stage_picture.hpp"
#include "views.hpp"

namespace breccia::python {
namespace {

namespace py = pybind11;

/// Lists the content of the box of a stage.
struct ListContent {
  Box& box;

  template <int dim>
  void operator()(const Microstructure<dim>& balls) const {
    box.kind = dim == 3 ? "spheres" : "discs";
    for (std::size_t particle = 0; particle < balls.particles.size(); ++particle) {
      const auto& [centre, diameter] = balls.particles[particle];
      append(box.centres, centre);
      box.diameters.push_back(diameter);
      box.fillers.push_back(static_cast<std::ptrdiff_t>(balls.filler_of(particle)));
    }
  }
  void operator()(const ParticleBox& shaped) const {
    box.kind = "particles";
    for (std::size_t particle = 0; particle < shaped.particles.size(); ++particle) {
      const auto& [shape, pose] = shaped.particles[particle];
      append(box.centres, pose.centre());
      box.diameters.push_back(equivalent_diameter(shape));
      box.angles.push_back(pose.angle());
      box.fillers.push_back(static_cast<std::ptrdiff_t>(shaped.filler_of(particle)));
      // A polygon has no axes; its bounding circle stands for them.
      const double across = 2.0 * circumradius(shape);
      const auto* const ellipse = std::get_if<Ellipse>(&shape);
      append(box.axes, ellipse == nullptr ? Vector<2>{across, across} : ellipse->axes);
    }
  }
  void operator()(const EllipsoidBox& ellipsoids) const {
    box.kind = "ellipsoids";
    for (std::size_t particle = 0; particle < ellipsoids.particles.size(); ++particle) {
      const auto& one = ellipsoids.particles[particle];
      append(box.centres, one.centre);
      append(box.axes, one.axes);
      box.diameters.push_back(equivalent_diameter(one));
      box.fillers.push_back(static_cast<std::ptrdiff_t>(ellipsoids.filler_of(particle)));
    }
  }
  template <int dim>
  void operator()(const Grains<dim>& grains) const {
    box.kind = "grains";
    for (const auto& [position, weight] : grains.sites.sites) {
      append(box.centres, position);
      box.weights.push_back(weight);
      box.fillers.push_back(0);
    }
  }
  template <int dim>
  void operator()(const SharedImage<dim>&) const {
    box.kind = "image";
  }

 private:
  template <std::size_t dim>
  static void append(std::vector<double>& list, const std::array<double, dim>& vector) {
    list.insert(list.end(), vector.begin(), vector.end());
  }
};

/// A list of a box as an array of n or n x columns numbers.
template <class Number>
py::array view(const py::object& self, std::vector<Number> Box::*list, bool has_columns) {
  const auto& box = self.cast<const Box&>();
  const auto& numbers = box.*list;
  const auto columns = static_cast<std::size_t>(has_columns ? box.dimensions : 1);
  std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(numbers.size() / columns)};
  if (has_columns) shape.push_back(static_cast<py::ssize_t>(columns));
  return view_of(numbers.data(), std::move(shape), self);
}

/// A list that moves into the memory of a NumPy array.
template <class Number>
py::array moved(std::vector<Number> list, const std::vector<py::ssize_t>& shape) {
  auto kept = std::make_unique<std::vector<Number>>(std::move(list));
  const auto* const data = kept->data();
  const py::capsule owner(kept.release(), [](void* memory) { delete static_cast<std::vector<Number>*>(memory); });
  return py::array_t<Number>(shape, data, owner);
}

py::tuple labels_of(const Box& box, int cells) {
  if (box.stage.name.empty()) throw InputError("labels: not in a result that was pickled");
  if (cells == 0) cells = box.stage.cells;
  if (cells < 1) throw InputError(fmt::format("cells: expected a positive number, got {}", cells));
  auto labels = point_labels(box.stage, box.packed, cells);
  const std::vector<py::ssize_t> shape(static_cast<std::size_t>(box.dimensions), 2 * static_cast<py::ssize_t>(cells));
  py::object particles = py::none();
  if (!labels.particles.empty()) particles = moved(std::move(labels.particles), shape);
  const auto phases = phases_of(box.stage);
  return py::make_tuple(moved(std::move(labels.phases), shape), particles, phases.names());
}

}  // namespace

std::string picture_of(const Box& box) {
  return box.stage.name.empty() ? box.svg : stage_picture(box.stage, box.packed);
}

Box box_of(const Stage& stage, const StageMicrostructure& packed) {
  Box box;
  box.dimensions = stage.dimensions();
  box.side = stage.side;
  box.is_periodic = stage.is_periodic();
  visit_nested(ListContent{box}, packed.box);
  box.particles = packed.particles();
  box.fraction = packed.fraction;
  box.interface_density = packed.interface_per_area;
  box.gap = packed.gap;
  box.wall_gap = packed.wall_gap;
  box.seconds = packed.seconds;
  box.stage = stage;
  box.packed = packed;
  return box;
}

void bind_box(py::module_& module) {
  py::class_<Box>(module, "Microstructure",
                  "The particles, grains or pixels in the box of a stage. Arrays are views without a copy.")
      .def_readonly("kind", &Box::kind, R"("discs", "particles", "spheres", "ellipsoids", "grains" or "image".)")
      .def_readonly("dimensions", &Box::dimensions, "2 or 3.")
      .def_readonly("side", &Box::side, "Side of the box [m].")
      .def_readonly("is_periodic", &Box::is_periodic, "Whether the box goes on beyond its sides.")
      .def_readonly("particles", &Box::particles, "Number of particles, or of grains that the films leave.")
      .def_readonly("fraction", &Box::fraction, "Area of the particles per area, or volume per volume, of the box [-].")
      .def_readonly("interface_density", &Box::interface_density,
                    "Length of the interface per area, or area per volume, of the box [1/m].")
      .def_readonly("gap", &Box::gap, "Smallest gap between two particles, or thickness of the films [m].")
      .def_readonly("wall_gap", &Box::wall_gap, "Smallest gap between a particle and a hard wall [m].")
      .def_readonly("seconds", &Box::seconds, "Wall time of the packing [s].")
      .def_property_readonly(
          "centres", [](const py::object& self) { return view(self, &Box::centres, true); },
          "n x dimensions array of the centres, or of the sites of grains [m].")
      .def_property_readonly(
          "diameters", [](const py::object& self) { return view(self, &Box::diameters, false); },
          "Diameters of discs or balls of the same area or volume [m]; none of grains.")
      .def_property_readonly(
          "axes", [](const py::object& self) { return view(self, &Box::axes, true); },
          "n x dimensions array of the whole axes of ellipses and ellipsoids [m]; none of others.")
      .def_property_readonly(
          "angles", [](const py::object& self) { return view(self, &Box::angles, false); },
          "Angles of the first axis from the x axis [rad], of particles other than discs in a plane.")
      .def_property_readonly(
          "weights", [](const py::object& self) { return view(self, &Box::weights, false); },
          "Weights of the sites of grains [m^2]; none of others.")
      .def_property_readonly(
          "fillers", [](const py::object& self) { return view(self, &Box::fillers, false); },
          "The number of the filler of each particle, from 0.")
      .def("svg", &picture_of, "Picture, an SVG; of a cube the plane through its middle.")
      .def(
          "labels", &labels_of, py::arg("cells") = 0,
          "What is at the material points, two to a cell along each axis, [y, x] or [z, y, x] with y and z rising: the "
          "phases, the particle or grain at each place (-1 in the matrix; None of an image), and the names of the "
          "phases. A picture has its top row first: Image(), and a plot with its origin at the top, take "
          "labels()[0][..., ::-1, :].\n\n"
          "cells: along each side; by default those of the finest grid of the stage.")
      .def("__repr__",
           [](const Box& box) {
             const auto content = box.kind == "image" ? box.kind : fmt::format("{} {}", box.particles, box.kind);
             return fmt::format("<breccia.Microstructure: {}, {:.2f} % of a box of {}>", content, 100.0 * box.fraction,
                                readable(box.side, Dimension::length));
           })
      .def(py::pickle([](const Box& box) { return state_of(box); }, &box_from));
}

py::dict state_of(const Box& box) {
  py::dict state;
  state["kind"] = box.kind;
  state["dimensions"] = box.dimensions;
  state["side"] = box.side;
  state["is_periodic"] = box.is_periodic;
  state["lists"] = py::make_tuple(array_of(box.centres), array_of(box.diameters), array_of(box.axes),
                                  array_of(box.angles), array_of(box.weights));
  state["fillers"] = box.fillers;
  state["particles"] = box.particles;
  state["numbers"] = py::make_tuple(box.fraction, box.interface_density, box.gap, box.wall_gap, box.seconds);
  state["svg"] = picture_of(box);
  return state;
}

Box box_from(const py::dict& state) {
  Box box;
  box.kind = state["kind"].cast<std::string>();
  box.dimensions = state["dimensions"].cast<int>();
  box.side = state["side"].cast<double>();
  box.is_periodic = state["is_periodic"].cast<bool>();
  const auto lists = state["lists"].cast<py::tuple>();
  std::size_t number = 0;
  for (auto* list : {&box.centres, &box.diameters, &box.axes, &box.angles, &box.weights}) {
    *list = lists[number++].cast<std::vector<double>>();
  }
  box.fillers = state["fillers"].cast<std::vector<std::ptrdiff_t>>();
  box.particles = state["particles"].cast<std::size_t>();
  const auto numbers = state["numbers"].cast<py::tuple>();
  number = 0;
  for (auto* one : {&box.fraction, &box.interface_density, &box.gap, &box.wall_gap, &box.seconds}) {
    *one = numbers[number++].cast<double>();
  }
  box.svg = state["svg"].cast<std::string>();
  return box;
}

}  // namespace breccia::python
