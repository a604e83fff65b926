#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/stage.hpp"

namespace breccia::python {

/// The content of the box of a stage as plain lists, which can be pickled.
struct Box {
  std::string kind;  ///< "discs", "particles", "spheres", "ellipsoids", "grains" or "image"
  int dimensions = 2;
  double side = 0.0;  ///< side of the box [m]
  bool is_periodic = false;
  std::vector<double> centres;    ///< centres, n x dimensions [m]
  std::vector<double> diameters;  ///< n diameters of discs or balls of equal area or volume [m]; none for grains
  std::vector<double> axes;       ///< whole axes of ellipses and ellipsoids, n x dimensions [m]; else none
  std::vector<double> angles;     ///< n angles from the x axis to the first axis [rad]; only for particles in a plane
  std::vector<double> weights;    ///< n weights of the sites of grains [m^2]; else none
  std::vector<std::ptrdiff_t> fillers;  ///< n numbers of fillers
  std::size_t particles = 0;            ///< number of particles, or of grains that are larger than their films
  double fraction = 0.0;                ///< area of the particles per area of the box, or volume per volume [-]
  double interface_density = 0.0;       ///< length of the interface per area of the box, or area per volume [1/m]
  double gap = 0.0;                     ///< smallest gap, or the thickness of the films [m]
  double wall_gap = 0.0;                ///< smallest gap to a hard wall [m]
  double seconds = 0.0;                 ///< wall time of the packing [s]
  std::string svg;                      ///< picture, once it was pickled
  Stage stage = {};                     ///< stage, for labels and picture; without a name after pickling
  StageMicrostructure packed = {};      ///< packed box of the stage, likewise
};

/// Picture of a box, an SVG.
std::string picture_of(const Box& box);

Box box_of(const Stage& stage, const StageMicrostructure& packed);

void bind_box(pybind11::module_& module);

// The content of a box for pickle, with its picture but without the labels of its points.
pybind11::dict state_of(const Box& box);
Box box_from(const pybind11::dict& state);

}  // namespace breccia::python
