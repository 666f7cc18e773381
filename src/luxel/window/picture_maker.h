// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "luxel/image/screen_image.h"
#include "luxel/window/background.h"
#include "luxel/window/painter.h"

namespace luxel {

// A picture of any size, also one larger than any framebuffer: drawn tile by tile, four samples a pixel,
// between frames, then put together and written in a thread of its own. Needs the painter's context. While it
// is being drawn the painter must show the same, else its tiles do not match.
class PictureMaker {
 public:
  static constexpr int largest_side = 16'384;  // pixels

  // side: pixels of a tile, a multiple of four. The aspect of `from` becomes that of the size. Throws
  // InputError where this is not from 1 to largest_side.
  PictureMaker(std::filesystem::path file, ScreenSize size, const Look& look, const Viewpoint& from,
               int side);

  const std::filesystem::path& file() const { return file_; }
  ScreenSize size() const { return size_; }
  const Look& look() const { return look_; }
  bool is_drawn() const { return next_ == count_; }
  double done() const { return static_cast<double>(next_) / static_cast<double>(count_); }  // of drawing

  // Draws for about so many seconds, a tile at least. True once the file is there. Throws DeviceError where
  // it cannot be drawn or written.
  bool go_on(Painter& painter, double seconds);
  // Likewise, but returns once the file is there.
  void finish(Painter& painter);

 private:
  struct Piece {
    int left, top;
    ScreenImage image;
  };
  void draw_tile(Painter& painter);
  static void write(const std::filesystem::path& file, ScreenSize size, const std::vector<Piece>& tiles);

  std::filesystem::path file_;
  ScreenSize size_;
  Look look_;
  Viewpoint from_;
  int side_;
  std::size_t next_ = 0, count_;
  Canvas canvas_;
  std::vector<Piece> tiles_;
  Background<bool> writing_;
};

}  // namespace luxel
