#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "breccia/microstructure/microstructure.hpp"

namespace breccia {

/// The appearance of the particles of one filler. Colours are numbers of phases: a single filler has 1.
struct DrawnFiller {
  std::size_t colour = 1;
  std::size_t coating_colour = 0;  ///< unused without a coating
  double coating_thickness = 0.0;  ///< thickness, outside the diameter [m]; 0: no coating
};

/// The colour of particles or coatings with this number, such as "#5b7f95".
std::string_view colour_of_phase(std::size_t number);

/// SVG picture of a microstructure: the box seen from above, y upwards, with a scale bar. Discs of a periodic box are
/// drawn with their periodic images; all discs are clipped at the sides of the box. `fillers` has the appearance of the
/// particles of each filler; without it all particles have one colour and no coating. Throws InputError if the side of
/// the box is not positive and finite, or a particle belongs to none of the fillers.
std::string microstructure_picture(const Microstructure<2>& microstructure,
                                   const std::vector<DrawnFiller>& fillers = {{}});

enum class Axis { x, y, z };

/// SVG picture of a cut through the middle of a box of three dimensions, along the plane with this normal; the axis
/// that follows the normal (x, y, z, x ...) goes to the right, the next one upwards. Throws as microstructure_picture()
/// does.
std::string cut_picture(const Microstructure<3>& microstructure, Axis normal,
                        const std::vector<DrawnFiller>& fillers = {{}});

}  // namespace breccia
