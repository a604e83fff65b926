#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/stage.hpp"

namespace breccia::python {

/// What is in the box of a stage, as plain lists, which can be pickled.
struct Box {
  std::string kind;  ///< "discs", "particles", "spheres", "ellipsoids", "grains" or "image"
  int dimensions = 2;
  double side = 0.0;  ///< [m]
  bool is_periodic = false;
  std::vector<double> centres;          ///< n x dimensions [m]
  std::vector<double> diameters;        ///< n, of equal area or volume [m]; none of grains
  std::vector<double> axes;             ///< n x dimensions, whole axes of ellipses and ellipsoids [m]; else none
  std::vector<double> angles;           ///< n, of the first axis from the x axis [rad]; of particles in a plane alone
  std::vector<double> weights;          ///< n, of the sites of grains [m^2]; else none
  std::vector<std::ptrdiff_t> fillers;  ///< n, the number of the filler of each
  std::size_t particles = 0;            ///< particles, or grains that the films leave
  double fraction = 0.0;                ///< area per area of the box, or volume per volume [-]
  double interface_density = 0.0;       ///< length per area, or area per volume [1/m]
  double gap = 0.0;                     ///< smallest gap, or the thickness of the films [m]
  double wall_gap = 0.0;                ///< [m]
  double seconds = 0.0;                 ///< wall time of the packing [s]
  std::string svg;                      ///< picture, once it was pickled
  Stage stage = {};                     ///< for labels and picture; without a name after it was pickled
  StageMicrostructure packed = {};      ///< likewise
};

/// Picture of a box, an SVG.
std::string picture_of(const Box& box);

Box box_of(const Stage& stage, const StageMicrostructure& packed);

void bind_box(pybind11::module_& module);

// The content of a box for pickle, with its picture but without the labels of its points.
pybind11::dict state_of(const Box& box);
Box box_from(const pybind11::dict& state);

}  // namespace breccia::python
