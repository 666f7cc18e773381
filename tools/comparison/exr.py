# SPDX-License-Identifier: Apache-2.0
"""Reads the OpenEXR pictures that the compared programs write: scan lines, uncompressed or by zlib."""
import struct
import zlib

import numpy

ROWS_PER_BLOCK = {0: 1, 2: 1, 3: 16}  # by the code of the compression: none, ZIPS, ZIP
TYPES = {1: "<f2", 2: "<f4"}


def _attributes(data):
    """({name: bytes}, offset behind them) of the header that begins at byte 8."""
    found, at = {}, 8
    while data[at]:
        name_end = data.index(0, at)
        type_end = data.index(0, name_end + 1)
        size = struct.unpack_from("<i", data, type_end + 1)[0]
        found[data[at:name_end].decode()] = data[type_end + 5:type_end + 5 + size]
        at = type_end + 5 + size
    return found, at + 1


def _channels(value):
    """[(name, type)] in the order of the file."""
    found, at = [], 0
    while value[at]:
        end = value.index(0, at)
        kind = struct.unpack_from("<i", value, end + 1)[0]
        if kind not in TYPES:
            raise ValueError("expected channels of half or single precision")
        found.append((value[at:end].decode(), TYPES[kind]))
        at = end + 17
    return found


def _inflate(packed, size):
    """Undoes zlib, the differences of neighbouring bytes, and the split into even and odd bytes."""
    if len(packed) == size:
        return packed
    bytes_ = numpy.frombuffer(zlib.decompress(packed), numpy.uint8).astype(numpy.int64)
    bytes_[1:] -= 128
    bytes_ = numpy.cumsum(bytes_).astype(numpy.uint8)
    whole = numpy.empty(size, numpy.uint8)
    half = (size + 1) // 2
    whole[0::2], whole[1::2] = bytes_[:half], bytes_[half:]
    return whole.tobytes()


def read(path):
    """The picture as float64, shape (height, width, 3), in the units of the file; the first row is the top."""
    with open(path, "rb") as file:
        data = file.read()
    if data[:4] != b"\x76\x2f\x31\x01":
        raise ValueError(f"{path} is not an OpenEXR picture")
    header, at = _attributes(data)
    compression = header["compression"][0]
    if compression not in ROWS_PER_BLOCK:
        raise ValueError(f"{path} has compression {compression}: expected none, ZIPS or ZIP")
    left, top, right, bottom = struct.unpack("<4i", header["dataWindow"])
    width, height = right - left + 1, bottom - top + 1
    channels = _channels(header["channels"])
    row_bytes = sum(width * numpy.dtype(kind).itemsize for _, kind in channels)
    planes = {name: numpy.zeros((height, width)) for name, _ in channels}
    rows = ROWS_PER_BLOCK[compression]
    for offset in struct.unpack_from(f"<{-(-height // rows)}Q", data, at):
        first, size = struct.unpack_from("<2i", data, offset)
        count = min(rows, bottom - first + 1)
        block = _inflate(data[offset + 8:offset + 8 + size], count * row_bytes)
        begin = 0
        for row in range(first - top, first - top + count):
            for name, kind in channels:
                planes[name][row] = numpy.frombuffer(block, kind, width, begin)
                begin += width * numpy.dtype(kind).itemsize
    names = {name.split(".")[-1]: name for name in planes}
    return numpy.stack([planes[names[band]] for band in "RGB"], axis=-1)
