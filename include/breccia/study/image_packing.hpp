#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "breccia/microstructure/label_image.hpp"

namespace breccia {

/// The pixels of an image, or the voxels of a stack of images, in place of particles. The label 0 is that of the
/// matrix, the label k that of the filler k - 1 of the stage.
struct ImagePacking {
  std::filesystem::path file;
  std::string array = {};                           ///< data set of the file; empty if none was named
  std::shared_ptr<const LabelImage<2>> image = {};  ///< fills the box; shared by copies of a stage, since it is large
  std::shared_ptr<const LabelImage<3>> stack = {};  ///< the same in a box of three dimensions
};

}  // namespace breccia
