# SPDX-License-Identifier: Apache-2.0
"""Pictures as arrays [height, width, 3] of 32-bit floats: EXR files of Luxel, and their display values."""
import struct
import zlib

import numpy as np

ROWS_PER_BLOCK = 16  # of an EXR file with ZIP compression
LUMINANCE = np.array([0.2126, 0.7152, 0.0722], np.float32)  # of linear sRGB, Rec. ITU-R BT.709
KEY = 0.18  # Luxel's --key: what the log-average luminance is shown as


def read_exr(path):
    """Radiance, linear sRGB. Reads what Luxel writes: scan lines, ZIP, channels B, G and R of 16-bit floats."""
    with open(path, "rb") as file:
        data = file.read()
    attributes, at = header(data, path)
    if attributes["compression"] != b"\x03" or attributes["channels"].split(b"\0")[0] != b"B":
        raise ValueError(f"{path}: expected ZIP compression and three channels, as Luxel writes them")
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"])
    width, height = right - left + 1, bottom - top + 1
    picture = np.empty((height, width, 3), np.float32)
    for offset in struct.unpack_from(f"<{-(-height // ROWS_PER_BLOCK)}Q", data, at):
        y, size = struct.unpack_from("<2i", data, offset)
        rows = min(ROWS_PER_BLOCK, bottom + 1 - y)
        block = unpacked(data[offset + 8:offset + 8 + size], rows * width * 6)
        picture[y - top:y - top + rows] = block.view("<f2").reshape(rows, 3, width)[:, ::-1].transpose(0, 2, 1)
    return picture


def header(data, path):
    """The attributes of an EXR file by name, and where they end."""
    if data[:8] != struct.pack("<2i", 20000630, 2):
        raise ValueError(f"{path} is no EXR picture of scan lines")
    attributes, at = {}, 8
    while data[at] != 0:
        name, _, rest = data[at:at + 512].split(b"\0", 2)
        kind_end = data.index(b"\0", at + len(name) + 1)
        size, = struct.unpack_from("<i", data, kind_end + 1)
        attributes[name.decode()] = data[kind_end + 5:kind_end + 5 + size]
        at = kind_end + 5 + size
    return attributes, at + 1


def unpacked(block, size):
    """The bytes of a ZIP block: differences are summed, then the two halves are interleaved."""
    if len(block) == size:
        return np.frombuffer(block, np.uint8)
    differences = np.frombuffer(zlib.decompress(block), np.uint8).astype(np.int64)
    summed = (np.cumsum(differences) - 128 * np.arange(size)).astype(np.uint8)
    out = np.empty(size, np.uint8)
    out[0::2], out[1::2] = summed[:(size + 1) // 2], summed[(size + 1) // 2:]
    return out


def exposure_of(radiance):
    """The factor of Luxel's default tone mapping, KEY over the log-average luminance of lit pixels."""
    luminance = np.maximum(radiance, 0) @ LUMINANCE
    lit = luminance[luminance > 0]
    return KEY / np.exp(np.mean(np.log(lit), dtype=np.float64)) if lit.size else 1.0


def codes(radiance, exposure):
    """What an 8-bit picture shows with Luxel's default tone mapping (Reinhard et al. 2002, equation 3): sRGB codes, 0 to
    255, not rounded."""
    keyed = np.maximum(radiance, 0) * np.float32(exposure)
    shown = np.minimum(keyed / (1 + keyed @ LUMINANCE)[..., None], 1)
    return 255 * np.where(shown <= 0.0031308, 12.92 * shown, 1.055 * np.maximum(shown, 1e-9) ** (1 / 2.4) - 0.055)


def write_png(path, shown):
    """Codes, rounded, as an 8-bit RGB PNG."""
    height, width, _ = shown.shape
    rows = np.zeros((height, 1 + 3 * width), np.uint8)
    rows[:, 1:] = np.clip(np.rint(shown), 0, 255).reshape(height, 3 * width)

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(rows.tobytes(), 6)) + chunk(b"IEND", b""))
