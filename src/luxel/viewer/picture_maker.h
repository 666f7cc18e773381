// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "luxel/image/screen_image.h"
#include "luxel/viewer/background_task.h"
#include "luxel/viewer/painter.h"

namespace luxel {

// A picture of any size, also one larger than any framebuffer: drawn tile by tile, as smooth as the window at
// rest, between frames, then assembled and written in a thread of its own. Needs the painter's context.
class PictureMaker {
 public:
  static constexpr int max_side = 16'384;  // pixels

  // The aspect of `from` becomes that of the size. is_software: a processor draws, see Driver. Throws
  // InputError where the size is not from 1 to max_side.
  PictureMaker(std::filesystem::path file, ScreenSize size, const Look& look, const Viewpoint& from,
               bool is_software);

  const std::filesystem::path& file() const { return file_; }
  ScreenSize size() const { return size_; }
  const Look& look() const { return look_; }
  // Begins with this curve; afterwards the painter must not change.
  void begin(const ToneCurve& tone);
  bool has_begun() const { return has_begun_; }
  bool is_drawn() const { return next_ == count_; }
  double done() const { return static_cast<double>(next_) / static_cast<double>(count_); }  // of drawing

  // Once begun: draws for about this many seconds, at least a part of a tile. True once the file is written.
  // Throws DeviceError where it cannot be drawn or written.
  bool go_on(Painter& painter, double seconds);
  // Draws the rest; returns once the file is written.
  void finish(Painter& painter);

 private:
  struct Piece {
    int left, top;
    ScreenImage image;
  };
  PicturePart next_part() const;
  void draw_some(Painter& painter);
  static void write(const std::filesystem::path& file, ScreenSize size, const std::vector<Piece>& tiles);

  std::filesystem::path file_;
  ScreenSize size_;
  Look look_;
  Viewpoint from_;
  bool is_software_;
  int side_;  // of a tile, pixels
  bool has_begun_ = false;
  std::size_t next_ = 0, count_;  // tiles
  int joined_ = 0;                // shifted pictures of the next
  Canvas canvas_;
  std::vector<Piece> tiles_;
  BackgroundTask<bool> writing_;
};

}  // namespace luxel
