#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How near Luxel's pictures are to path tracing: against_paths.py PATHS.exr PICTURE.exr...

PATHS.exr is a picture of `luxel reference`, each other one is of `luxel bake` or `luxel render`, from the same camera
and of the same size. Prints, for each picture, the fraction of pixels whose largest channel is within 4 codes of 8-bit
sRGB (0 to 255, not rounded), all shown with the exposure of the path-traced one. Its noise counts as if it were the
other's: the second share is that of means over 3 x 3 pixels, in which a third of it is left. Beside each picture a
PNG is written, PICTURE-difference.png, grey where there is none, eightfold.

  luxel reference room.obj --eye ... --samples 1k --width 640 --height 480 -o paths.exr
  luxel bake room.obj --eye ... --width 640 --height 480 -o room.exr
  against_paths.py paths.exr room.exr

Needs numpy (Debian: python3-numpy).
"""
import os
import sys

try:
    import numpy as np

    import pictures
except ImportError as error:
    sys.exit(f"{error}: install Debian's python3-numpy and run this with /usr/bin/python3")

LIMIT = 4.0  # codes
ENLARGED = 8.0  # differences in the PNG


def means_of_nine(values):
    """Means over 3 x 3 pixels; beyond the border the picture repeats its last row and column."""
    padded = np.pad(values, ((1, 1), (1, 1), (0, 0)), "edge")
    height, width, _ = values.shape
    return sum(padded[y:y + height, x:x + width] for y in range(3) for x in range(3)) / 9


def share_within(difference):
    return 100 * np.mean(np.abs(difference).max(axis=2) <= LIMIT)


def main(paths, names):
    truth = pictures.read_exr(paths)
    exposure = pictures.exposure_of(truth)
    shown = pictures.codes(truth, exposure)
    print(f"| picture | within {LIMIT:.0f} codes | means of 3 x 3 within {LIMIT:.0f} codes | mean difference, codes |")
    print("|---|---|---|---|")
    for name in names:
        picture = pictures.read_exr(name)
        if picture.shape != truth.shape:
            sys.exit(f"{name} has {picture.shape[1]} x {picture.shape[0]} pixels, {paths} another number")
        difference = pictures.codes(picture, exposure) - shown
        smooth = means_of_nine(difference)
        print(f"| {os.path.basename(name)} | {share_within(difference):.1f} % | {share_within(smooth):.1f} % | "
              f"{difference.mean():+.2f} |")
        pictures.write_png(os.path.splitext(name)[0] + "-difference.png", np.clip(127.5 + ENLARGED * smooth, 0, 255))


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2:])
