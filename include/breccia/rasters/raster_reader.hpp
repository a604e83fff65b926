#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "breccia/rasters/raster.hpp"

namespace breccia {

/// Reads an image of labels. The format is recognised by the content of the file:
/// - PNG: grey levels of 1 to 16 bits as they are stored (0 and 1 for 1 bit), or numbers of the colours of a palette;
/// - TIFF and BigTIFF: the same values as PNG, and numbers of 32 and 64 bits, in strips or tiles, with any compression
///   of libtiff;
/// several pages are layers;
/// - NumPy .npy of versions 1 to 3: booleans and integers, little- or big-endian, in the order of C or Fortran;
/// - VTK ImageData .vti: an array of the cells or the points, in one piece, as text, base64 or raw, compressed by zlib
///   or not;
/// - HDF5: a data set of booleans or integers; arrays of MATLAB (version 7.3) have their rows and columns as in MATLAB.
///
/// Floating-point numbers are read if all are whole, and colours if all are grey (red = green = blue). The side of a
/// pixel is known for TIFF alone: from its resolution per inch or centimetre, or from ImageJ's description. Many
/// programs write the resolution of a printer there (72, 96, 300 per inch), so it is a hint.
///
/// `array` names a data set of an HDF5 file or an array of a `.vti`; without it the active scalars of the `.vti`, or
/// the only data set or array, are taken. Both may be written with a slash before them, as paths of HDF5 are.
///
/// Throws InputError, with the file, what was found and what was expected, if the file is damaged, has another format,
/// another number of dimensions than two or three, no pixels or 2^31 and more, or values that are not whole numbers of
/// 32 bits with a sign. Throws FileError if it cannot be read.
Raster read_raster(const std::filesystem::path& file, std::string_view array = {});

/// The names of a file and of the array in it.
struct RasterName {
  std::filesystem::path file;
  std::string array;  ///< empty if none was named
};

/// Splits `grains.h5:/labels/phase` into file and array at the last `:/`. Other names have no array.
RasterName raster_name(std::string_view text);

}  // namespace breccia
