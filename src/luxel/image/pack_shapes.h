// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace luxel {

// A set of pixels in a box.
class PixelShape {
 public:
  PixelShape(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t count() const;
  bool has(int x, int y) const { return (row(y)[word(x)] >> (x % 64)) & 1u; }
  void add(int x, int y) { words_[at(y) + word(x)] |= std::uint64_t{1} << (x % 64); }
  std::span<const std::uint64_t> row(int y) const { return std::span(words_).subspan(at(y), words_per_row_); }
  std::span<std::uint64_t> row(int y) { return std::span(words_).subspan(at(y), words_per_row_); }

  // Turned counter-clockwise by quarters of a full turn, y downwards: pixel (x, y) of the original goes to
  // quarter_turn(x, y).
  PixelShape turned(int quarters) const;

 private:
  static std::size_t word(int x) { return static_cast<std::size_t>(x) / 64; }
  std::size_t at(int y) const { return static_cast<std::size_t>(y) * words_per_row_; }

  int width_, height_;
  std::size_t words_per_row_;
  std::vector<std::uint64_t> words_;
};

// Maps a place in a box from (0, 0) to (right, bottom) when the box is turned by 0 to 3 quarters.
template <typename Number>
std::pair<Number, Number> turned_place(int quarters, Number x, Number y, Number right, Number bottom) {
  switch (quarters) {
    case 1:
      return {y, right - x};
    case 2:
      return {right - x, bottom - y};
    case 3:
      return {bottom - y, x};
    default:
      return {x, y};
  }
}

struct PackedShape {
  int page = 0, x = 0, y = 0;  // of the turned box, from the top left
  int quarters = 0;            // of a full turn, 0 to 3
};

struct PackedShapes {
  std::vector<PackedShape> shapes;  // as given
  int pages = 0;                    // 0: one is larger than a page
};

// Packs shapes on square pages, turned where they fit better. Between pixels of two shapes, and to the edge
// of the page, are at least `margin` pixels across, down and along diagonals. Large shapes come first; each
// goes to the first page that has room, as far up as possible, then as far left (bottom-left placement of
// bitmaps). With max_pages, stops and returns no pages where more would be needed. The same input gives the
// same layout. Cost: about 1 us per shape and row of the page.
PackedShapes pack_shapes(std::span<const PixelShape> shapes, int page_size, int margin, int max_pages);

}  // namespace luxel
