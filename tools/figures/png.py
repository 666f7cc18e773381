# SPDX-License-Identifier: Apache-2.0
"""8-bit RGB pictures as PNG, read and written with nothing but zlib, to take each band from another picture."""
import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def paeth(left, up, corner):
    guess = left + up - corner
    distances = (abs(guess - left), abs(guess - up), abs(guess - corner))
    return (left, up, corner)[distances.index(min(distances))]


def read(path):
    """Width, height and the bytes red, green, blue of each pixel. Only what Luxel writes: 8-bit RGB, not interlaced."""
    with open(path, "rb") as file:
        data = file.read()
    if data[:8] != SIGNATURE:
        raise ValueError(f"{path} is no PNG")
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, *form = struct.unpack(">IIBBBBB", body)
            if form != [8, 2, 0, 0, 0]:
                raise ValueError(f"{path} is no plain 8-bit RGB picture")
        elif kind == b"IDAT":
            packed += body
        at += 12 + length
    raw, row_bytes = zlib.decompress(packed), 3 * width
    above, pixels = bytes(row_bytes), bytearray()
    for y in range(height):
        begin = y * (row_bytes + 1)
        above = unfilter(raw[begin], raw[begin + 1:begin + 1 + row_bytes], above)
        pixels += above
    return width, height, bytes(pixels)


def unfilter(kind, line, above):
    out = bytearray(line)
    for i, value in enumerate(line):
        left, corner = (out[i - 3], above[i - 3]) if i >= 3 else (0, 0)
        up = above[i]
        out[i] = (value + (0, left, up, (left + up) // 2, paeth(left, up, corner))[kind]) & 255
    return bytes(out)


def write(path, width, height, pixels):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    lines = b"".join(b"\0" + pixels[y * 3 * width:(y + 1) * 3 * width] for y in range(height))
    with open(path, "wb") as file:
        file.write(SIGNATURE + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b""))


def band_of_each(path, pictures):
    """Red of the first picture, green of the second, blue of the third."""
    read_ones = [read(p) for p in pictures]
    width, height, _ = read_ones[0]
    pixels = bytearray(3 * width * height)
    for band, (_, _, source) in enumerate(read_ones):
        pixels[band::3] = source[band::3]
    write(path, width, height, bytes(pixels))
