"""Grey pictures of 8 bits as PNG, with nothing but Python's own library: rows of bytes, the top row first."""

import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def _chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def write(path, rows):
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    lines = b"".join(b"\0" + bytes(row) for row in rows)
    with open(path, "wb") as file:
        file.write(SIGNATURE + _chunk(b"IHDR", header) + _chunk(b"IDAT", zlib.compress(lines, 9)) + _chunk(b"IEND", b""))


def _predicted(kind, left, above, corner):
    """The value of a byte that a filter of PNG predicts from the bytes before it."""
    if kind == 4:
        estimate = left + above - corner
        return min((left, above, corner), key=lambda value: abs(estimate - value))
    return (0, left, above, (left + above) // 2)[kind]


def read(path):
    with open(path, "rb") as file:
        content = file.read()
    if content[:8] != SIGNATURE:
        raise SystemExit(f"{path}: no PNG")
    place, packed = 8, b""
    while place < len(content):
        (length,) = struct.unpack(">I", content[place : place + 4])
        kind, data = content[place + 4 : place + 8], content[place + 8 : place + 8 + length]
        if kind == b"IHDR":
            columns, count, bits, colours, _, _, interlace = struct.unpack(">IIBBBBB", data)
        elif kind == b"IDAT":
            packed += data
        place += length + 12
    if (bits, colours, interlace) != (8, 0, 0):
        raise SystemExit(f"{path}: expected a grey picture of 8 bits that is not interlaced")
    lines, rows, above = zlib.decompress(packed), [], bytes(columns)
    for line in range(count):
        kind, *filtered = lines[line * (columns + 1) : (line + 1) * (columns + 1)]
        row, left, corner = bytearray(), 0, 0
        for byte, over in zip(filtered, above):
            left = (byte + _predicted(kind, left, over, corner)) & 255
            corner = over
            row.append(left)
        rows.append(row)
        above = row
    return rows
