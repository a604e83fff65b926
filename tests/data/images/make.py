#!/usr/bin/python3
"""Writes the images of this folder with other programs than Breccia: NumPy, Pillow, tifffile, h5py, VTK, and for some
forms of PNG by the bytes of its specification.

    apt-get install python3-numpy python3-pil python3-tifffile python3-h5py python3-vtk9
    /usr/bin/python3 tests/data/images/make.py

The files were made with NumPy 1.24, Pillow 9.4, tifffile 2023.2, h5py 3.7 and VTK 9.1. Those whose names begin with
`plane` have 4 rows of 5 pixels, those with `stack` 3 layers of them. In row r from the top, column c and layer l the
value is (5 l + 7 r + 3 c) modulo 11, or modulo what the name says. Files whose names begin with `bad` are refused.
"""

import pathlib
import struct
import zlib

import h5py
import numpy as np
import tifffile
import vtk
from PIL import Image
from vtk.util.numpy_support import numpy_to_vtk

here = pathlib.Path(__file__).resolve().parent
layer, row, column = np.indices((3, 4, 5))
stack = (5 * layer + 7 * row + 3 * column) % 11
plane = stack[0]


def path(name):
    return str(here / name)


def colours():
    """A colour for each number of a palette, none of them grey."""
    return [(40 * (i % 6), 255 - i, (37 * i + 5) % 256) for i in range(256)]


def pillow():
    grey = Image.fromarray(plane.astype(np.uint8))
    grey.save(path("plane-grey.png"))
    Image.fromarray(plane.astype(np.uint16)).save(path("plane-16bit.png"))
    bilevel = Image.fromarray((plane % 2).astype(bool))
    bilevel.save(path("plane-bilevel-mod2.png"))
    bilevel.save(path("plane-group4-mod2.tif"), compression="group4")
    palette = Image.fromarray(plane.astype(np.uint8), mode="P")
    palette.putpalette([channel for colour in colours() for channel in colour])
    palette.save(path("plane-palette.png"))
    palette.save(path("plane-palette4.png"), bits=4)
    palette.save(path("plane-palette.tif"))
    palette.convert("RGB").save(path("bad-colours.png"))
    grey.convert("RGB").save(path("plane-rgb.png"))
    grey.convert("RGBA").save(path("plane-rgba.png"))
    grey.convert("LA").save(path("plane-grey-alpha.png"))
    transparent = grey.convert("LA")
    transparent.putpixel((2, 1), (9, 128))
    transparent.save(path("bad-transparent.png"))
    grey.save(path("plane-lzw.tif"), compression="tiff_lzw")
    grey.save(path("plane-packbits.tif"), compression="packbits")
    grey.save(path("bad-jpeg.jpg"))
    grey.save(path("bad-gif.gif"))


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def packed(values, bits):
    """A row of PNG: its filter (none), and the values from the highest bit on."""
    text = "".join(format(value, f"0{bits}b") for value in values)
    text += "0" * (-len(text) % 8)
    return bytes([0]) + int(text, 2).to_bytes(len(text) // 8, "big")


def write_png(name, bits, interlaced, rows):
    header = struct.pack(">IIBBBBB", plane.shape[1], plane.shape[0], bits, 0, 0, 0, interlaced)
    data = zlib.compress(b"".join(packed(values, bits) for values in rows))
    pathlib.Path(path(name)).write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b""))


def specification_of_png():
    write_png("plane-2bit-mod4.png", 2, 0, plane % 4)
    write_png("plane-4bit.png", 4, 0, plane)
    adam7 = [(0, 0, 8, 8), (0, 4, 8, 8), (4, 0, 8, 4), (0, 2, 4, 4), (2, 0, 4, 2), (0, 1, 2, 2), (1, 0, 2, 1)]
    passes = [plane[top::down, left::right] for top, left, down, right in adam7]
    write_png("plane-interlaced.png", 8, 1, [values for part in passes if part.size for values in part])


def tiff():
    def write(name, data, **options):
        tifffile.imwrite(path(name), data, metadata=options.pop("metadata", None), **options)

    write("plane-uint8.tif", plane.astype(np.uint8))
    write("plane-int16-big-endian.tif", plane.astype(np.int16), byteorder=">", photometric="minisblack")
    write("plane-uint32-deflate.tif", plane.astype(np.uint32), compression="zlib", photometric="minisblack")
    write("plane-int64.tif", plane.astype(np.int64), photometric="minisblack")
    write("plane-float32.tif", plane.astype(np.float32), photometric="minisblack")
    write("plane-float64-tiled.tif", plane.astype(np.float64), tile=(16, 16), photometric="minisblack")
    write("plane-tiled.tif", plane.astype(np.uint8), tile=(16, 32), photometric="minisblack")
    write("plane-bigtiff.tif", plane.astype(np.uint16), bigtiff=True, photometric="minisblack")
    write("plane-white-is-zero.tif", plane.astype(np.uint8), photometric="miniswhite")
    write("plane-rgb.tif", np.repeat(plane[:, :, None], 3, axis=2).astype(np.uint8), photometric="rgb")
    write("plane-from-bottom.tif", plane[::-1].astype(np.uint8), extratags=[(274, "H", 1, 4, True)])
    write("plane-2um.tif", plane.astype(np.uint8), resolution=(5000, 5000), resolutionunit="CENTIMETER")
    write("stack.tif", stack.astype(np.uint8), photometric="minisblack")
    write("stack-tiled-deflate.tif", stack.astype(np.int32), photometric="minisblack", tile=(16, 16),
          compression="zlib")
    write("stack-imagej-500nm.tif", stack.astype(np.uint16), imagej=True, resolution=(2, 2),
          metadata={"axes": "ZYX", "unit": "um", "spacing": 0.5})
    write("bad-anisotropic.tif", stack.astype(np.uint16), imagej=True, resolution=(2, 2),
          metadata={"axes": "ZYX", "unit": "um", "spacing": 3.0})
    write("bad-channels.tif", stack.astype(np.uint16), imagej=True, metadata={"axes": "CYX"})
    write("bad-oblong.tif", plane.astype(np.uint8), resolution=(5000, 2500), resolutionunit="CENTIMETER")
    write("bad-rotated.tif", plane.astype(np.uint8), extratags=[(274, "H", 1, 6, True)])
    write("bad-fraction.tif", plane.astype(np.float32) + 0.5, photometric="minisblack")
    rgb = np.array([colours()[value] for value in plane.ravel()], dtype=np.uint8).reshape(4, 5, 3)
    write("bad-colours.tif", rgb, photometric="rgb")
    with tifffile.TiffWriter(path("bad-pages.tif")) as file:
        file.write(plane.astype(np.uint8), metadata=None)
        file.write(plane[:3].astype(np.uint8), metadata=None)


def numpy():
    for kind in ("u1", "i1", "<u2", ">i2", "<i4", ">u4", "<i8", ">u8", "<f4", ">f8"):
        name = kind.replace("<", "little-").replace(">", "big-")
        np.save(path(f"plane-{name}.npy"), plane.astype(kind))
    np.save(path("plane-bool-mod2.npy"), (plane % 2).astype(bool))
    np.save(path("plane-fortran.npy"), np.asfortranarray(plane.astype(np.uint8)))
    np.save(path("stack.npy"), stack.astype(np.uint8))
    np.save(path("stack-fortran.npy"), np.asfortranarray(stack.astype(np.uint16)))
    np.save(path("plane-one-layer.npy"), plane[None].astype(np.uint8))
    for version in ((2, 0), (3, 0)):
        with open(path(f"plane-version{version[0]}.npy"), "wb") as file:
            np.lib.format.write_array(file, plane.astype(np.uint8), version=version)
    np.save(path("bad-complex.npy"), plane.astype(np.complex64))
    np.save(path("bad-fraction.npy"), plane + 0.5)
    np.save(path("bad-structured.npy"), np.zeros((4, 5), dtype=[("phase", "u1"), ("grain", "i4")]))
    np.save(path("bad-colours.npy"), np.zeros((16, 17, 3), dtype=np.uint8))
    np.save(path("bad-line.npy"), np.arange(5, dtype=np.uint8))
    np.save(path("bad-empty.npy"), np.zeros((0, 5), dtype=np.uint8))
    np.save(path("bad-large.npy"), np.full((4, 5), 2**31, dtype=np.uint32))
    np.savez(path("bad-archive.npz"), plane.astype(np.uint8))


def vtk_image(values, kind, attribute="CellData", name="phase"):
    """Values indexed [z][y][x] with y from the bottom, as cells or points of an image."""
    image = vtk.vtkImageData()
    layers, height, width = values.shape
    of_cells = attribute == "CellData"
    image.SetDimensions(width + of_cells, height + of_cells, layers + (of_cells and layers > 1))
    image.SetSpacing(2e-6, 2e-6, 2e-6)
    array = numpy_to_vtk(np.ascontiguousarray(values.astype(kind)).ravel(), deep=True)
    array.SetName(name)
    getattr(image, f"Get{attribute}")().AddArray(array)
    return image


def write_vtk(name, image, mode, compressed, is_base64=False, header=32, big_endian=False):
    writer = vtk.vtkXMLImageDataWriter()
    writer.SetFileName(path(name))
    writer.SetInputData(image)
    getattr(writer, f"SetDataModeTo{mode}")()
    if compressed:
        writer.SetCompressorTypeToZLib()
        writer.SetBlockSize(32)
    else:
        writer.SetCompressorTypeToNone()
    writer.SetEncodeAppendedData(is_base64)
    writer.SetHeaderType(header)
    if big_endian:
        writer.SetByteOrderToBigEndian()
    writer.Write()


def vtk_files():
    flat = plane[None, ::-1]
    upright = stack[:, ::-1]
    write_vtk("plane-ascii.vti", vtk_image(flat, np.uint8), "Ascii", False)
    write_vtk("plane-inline.vti", vtk_image(flat, np.int32), "Binary", False)
    write_vtk("plane-inline-zlib.vti", vtk_image(flat, np.int64), "Binary", True)
    write_vtk("plane-raw.vti", vtk_image(flat, np.uint16), "Appended", False)
    write_vtk("plane-raw-zlib.vti", vtk_image(flat, np.int16), "Appended", True)
    write_vtk("plane-base64.vti", vtk_image(flat, np.uint16), "Appended", False, is_base64=True)
    write_vtk("plane-points.vti", vtk_image(flat, np.uint8, "PointData"), "Appended", False)
    write_vtk("plane-uint64-header.vti", vtk_image(flat, np.float32), "Appended", True, header=64)
    write_vtk("plane-big-endian.vti", vtk_image(flat, np.int32), "Appended", True, big_endian=True)
    write_vtk("stack-raw-zlib.vti", vtk_image(upright, np.uint8), "Appended", True)
    write_vtk("stack-points.vti", vtk_image(upright, np.float64, "PointData"), "Binary", True)
    two = vtk_image(upright, np.uint8)
    grain = numpy_to_vtk(np.arange(60, dtype=np.int32), deep=True)
    grain.SetName("grain")
    two.GetCellData().AddArray(grain)
    write_vtk("bad-two.vti", two, "Appended", True, is_base64=True)
    two.GetCellData().SetActiveScalars("phase")
    write_vtk("stack-two-base64.vti", two, "Appended", True, is_base64=True)
    oblong = vtk_image(flat, np.uint8)
    oblong.SetSpacing(1, 2, 1)
    write_vtk("bad-oblong.vti", oblong, "Ascii", False)


def hdf5():
    def open_new(name, **options):
        return h5py.File(path(name), "w", libver="latest", track_order=False, **options)

    with open_new("plane.h5") as file:
        file.create_dataset("/image/labels", data=plane.astype(np.uint8))
    with open_new("plane-float.h5") as file:
        file["labels"] = plane.astype(np.float32)
    with open_new("plane-bool-mod2.h5") as file:
        file["labels"] = (plane % 2).astype(bool)
    for name, data in (("plane", plane), ("stack", stack)):
        # As MATLAB 7.3 does: behind a block of 512 bytes, column by column.
        with open_new(f"{name}-matlab.mat", userblock_size=512) as file:
            file["labels"] = np.swapaxes(data, -1, -2).astype(np.float64)
            file["labels"].attrs["MATLAB_class"] = np.bytes_("double")
        with open(path(f"{name}-matlab.mat"), "r+b") as file:
            file.write(b"MATLAB 7.3 MAT-file")
    with h5py.File(path("stack-two.h5"), "w") as file:
        file.create_dataset("phase", data=stack.astype(">i4"), chunks=(2, 2, 2), compression="gzip", shuffle=True)
        file["grain"] = np.arange(60, dtype=np.int64).reshape(3, 4, 5)
    with open_new("bad-text.h5") as file:
        file["name"] = "no image"


for make in (pillow, specification_of_png, tiff, numpy, vtk_files, hdf5):
    make()
