// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "luxel/image/image.h"
#include "luxel/image/screen_image.h"
#include "luxel/viewer/pose.h"
#include "luxel/viewer/screen.h"

namespace luxel {

// Antialiasing of edges.
enum class EdgeSmoothing {
  sampled,  // four samples per pixel, where the driver has them
  rough,    // one: a fifth of the time where a processor draws
  coarse,   // one for four pixels: where that still takes too long while something moves
  coarsest  // one for nine
};

// Width and height, in pixels, of the area of one drawn pixel: 1, 2 or 3.
int pixel_step(EdgeSmoothing edges);
// Number of pixels that are drawn for a picture of this size.
ScreenSize drawn_size(ScreenSize size, EdgeSmoothing edges);

// A framebuffer of our own, sRGB, with depth: the same off screen and in a window, so that pictures of both
// are the same. Needs the context it was made in.
class DrawnFrame {
 public:
  DrawnFrame();
  ~DrawnFrame();
  DrawnFrame(const DrawnFrame&) = delete;
  DrawnFrame& operator=(const DrawnFrame&) = delete;

  // Makes it ready to be drawn into, at this size (pixels), filled with a colour (linear, [0, 1]). Memory is
  // kept while the size stays. Throws DeviceError where the driver has none of this size.
  void begin(ScreenSize size, const Vec3& background, EdgeSmoothing edges);
  // Converts samples to pixels. Later drawing (panels) writes sRGB codes unchanged, one sample per pixel.
  // Leaves the pixels as the current read framebuffer, for Screen::present().
  void resolve();
  // After resolve(): keeps the mean of these pixels and of `count` pictures before, each drawn with the tile
  // that shifted_tile() gives: edges become smoother with each picture while nothing moves, and cracks and
  // thin things, which the samples of one picture hit here and there, become lines.
  void join(int count);
  // Sets the pixels to that mean, in place of begin(), drawing and resolve().
  void show_joined();
  // Waits until drawing has finished, so that its time can be measured.
  void wait() const;
  // After resolve(): displayed codes, and the same as linear display values. Both wait for the driver.
  ScreenImage read_codes() const;
  Image read() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// A part of a picture.
struct PicturePart {
  ScreenSize whole;        // pixels of the picture
  PixelOffset begin = {};  // in it
  ScreenSize size;         // of the part
};
Tile tile_of(const PicturePart& part, const Tile& whole = {});
// Extends the part by `margin` pixels on every side, but not beyond the picture.
PicturePart with_margin(const PicturePart& part, int margin);

// The whole picture, shifted within a pixel: shifts 0 to 15, which fill it evenly.
inline constexpr int shifts = 16;
Tile shifted_tile(int shift, ScreenSize size);

}  // namespace luxel
