// SPDX-License-Identifier: Apache-2.0
#include "luxel/image/pack_shapes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <tuple>

namespace luxel {
namespace {

constexpr int bits = 64;

// A rectangle of a shape: pixels [left, left + width) of the rows [top, top + height).
struct Block {
  int left, width, top, height;
};

// A shape as rectangles, each with the rows that have the same run of pixels; the widest first.
std::vector<Block> blocks_of(const PixelShape& shape) {
  std::vector<Block> blocks, open;
  for (int y = 0; y < shape.height(); ++y) {
    std::vector<Block> next;
    for (int x = 0; x < shape.width(); ++x) {
      if (!shape.has(x, y)) continue;
      const auto left = x;
      while (x < shape.width() && shape.has(x, y)) ++x;
      next.push_back({left, x - left, y, 1});
    }
    for (auto& block : next)
      for (const auto& above : open)
        if (above.left == block.left && above.width == block.width)
          block = {block.left, block.width, above.top, above.height + 1};
    for (const auto& above : open)
      if (std::none_of(next.begin(), next.end(), [&](const auto& b) {
            return b.left == above.left && b.width == above.width && b.top == above.top;
          }))
        blocks.push_back(above);
    open = std::move(next);
  }
  blocks.insert(blocks.end(), open.begin(), open.end());
  std::stable_sort(blocks.begin(), blocks.end(),
                   [](const auto& a, const auto& b) { return a.width > b.width; });
  return blocks;
}

using Row = std::vector<std::uint64_t>;

// a |= b moved `by` pixels to the left.
void add_moved_left(Row& a, std::span<const std::uint64_t> b, int by) {
  const auto words = static_cast<std::size_t>(by / bits);
  const auto rest = by % bits;
  for (std::size_t i = 0; i + words < b.size(); ++i) {
    auto moved = b[i + words] >> rest;
    if (rest > 0 && i + words + 1 < b.size()) moved |= b[i + words + 1] << (bits - rest);
    a[i] |= moved;
  }
}

// a |= b moved `by` pixels to the right.
void add_moved_right(std::span<std::uint64_t> a, std::span<const std::uint64_t> b, int by) {
  const auto words = static_cast<std::size_t>(by / bits);
  const auto rest = by % bits;
  for (std::size_t i = 0; i < b.size() && i + words < a.size(); ++i) {
    a[i + words] |= b[i] << rest;
    if (rest > 0 && i + words + 1 < a.size()) a[i + words + 1] |= b[i] >> (bits - rest);
  }
}

// Pixel x of the result is taken where any of x to x + width - 1 is.
void widen_left(Row& row, int width, Row& scratch) {
  for (int reached = 1; reached < width;) {
    const auto step = std::min(reached, width - reached);
    scratch = row;
    add_moved_left(row, scratch, step);
    reached += step;
  }
}

class Page {
 public:
  Page(int size, int margin) : size_(size), margin_(margin), taken_(size, size) {}

  struct Spot {
    int x = 0, y = -1;  // y < 0: none
  };

  // The highest place of a shape's box at or below a row, and there the leftmost.
  Spot find(const PixelShape& shape, std::span<const Block> blocks, int from) {
    const auto last_x = size_ - margin_ - shape.width();
    if (last_x < margin_) return {};
    for (int y = std::max(from, margin_); y + shape.height() <= size_ - margin_; ++y) {
      barred_.assign(taken_.row(0).size(), 0);
      bool open = true;
      for (const auto& block : blocks) {
        block_.assign(barred_.size(), 0);
        for (int r = 0; r < block.height; ++r) {
          const auto row = taken_.row(y + block.top + r);
          for (std::size_t i = 0; i < block_.size(); ++i) block_[i] |= row[i];
        }
        widen_left(block_, block.width, scratch_);
        add_moved_left(barred_, block_, block.left);
        if (open = first_free(last_x) >= 0; !open) break;
      }
      if (open) return {first_free(last_x), y};
    }
    return {};
  }

  // Takes the pixels of the shape and those around it.
  void put(const PixelShape& shape, const Spot& spot) {
    Row wide, scratch;
    for (int y = 0; y < shape.height(); ++y) {
      wide.assign(shape.row(y).size() + static_cast<std::size_t>(2 * margin_ / bits + 1), 0);
      std::copy(shape.row(y).begin(), shape.row(y).end(), wide.begin());
      for (int i = 0; i < 2 * margin_; ++i) {
        scratch = wide;
        add_moved_right(wide, scratch, 1);
      }
      for (auto at = std::max(0, spot.y + y - margin_); at <= std::min(size_ - 1, spot.y + y + margin_); ++at)
        add_moved_right(taken_.row(at), wide, spot.x - margin_);
    }
  }

 private:
  // The first x from the margin to `last` that is not barred; -1: none.
  int first_free(int last) const {
    for (auto w = static_cast<std::size_t>(margin_ / bits); w < barred_.size(); ++w) {
      auto free = ~barred_[w];
      if (static_cast<int>(w) == margin_ / bits) free &= ~std::uint64_t{0} << (margin_ % bits);
      if (!free) continue;
      const auto x = static_cast<int>(w) * bits + std::countr_zero(free);
      return x <= last ? x : -1;
    }
    return -1;
  }

  int size_, margin_;
  PixelShape taken_;
  Row barred_, block_, scratch_;
};

// Shapes of about one size are looked for from where the last of them was put: those before found no room.
class Starts {
 public:
  int& of(const PixelShape& shape) {
    return row_[class_of(shape.width()) * classes + class_of(shape.height())];
  }

 private:
  static constexpr std::size_t classes = 64;
  // Two per power of two.
  static std::size_t class_of(int length) {
    const auto digits = std::bit_width(static_cast<unsigned>(length));
    const auto second = digits > 1 ? length >> (digits - 2) & 1 : 0;
    return static_cast<std::size_t>(2 * digits + second);
  }
  std::vector<int> row_ = std::vector<int>(classes * classes, 0);
};

}  // namespace

PixelShape::PixelShape(int width, int height)
    : width_(width),
      height_(height),
      words_per_row_(static_cast<std::size_t>((width + bits - 1) / bits)),
      words_(words_per_row_ * static_cast<std::size_t>(height), 0) {}

std::size_t PixelShape::count() const {
  return std::accumulate(words_.begin(), words_.end(), std::size_t{0}, [](auto sum, auto word) {
    return sum + static_cast<std::size_t>(std::popcount(word));
  });
}

PixelShape PixelShape::turned(int quarters) const {
  PixelShape result(quarters % 2 == 0 ? width_ : height_, quarters % 2 == 0 ? height_ : width_);
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      if (!has(x, y)) continue;
      const auto [to_x, to_y] = turned_place(quarters, x, y, width_ - 1, height_ - 1);
      result.add(to_x, to_y);
    }
  return result;
}

PackedShapes pack_shapes(std::span<const PixelShape> shapes, int page_size, int margin, int max_pages) {
  std::vector<std::size_t> order(shapes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto rank = [&](std::size_t i) {
    const auto& s = shapes[i];
    return std::tuple(-std::max(s.width(), s.height()), -std::min(s.width(), s.height()), i);
  };
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return rank(a) < rank(b); });

  PackedShapes packed;
  packed.shapes.resize(shapes.size());
  std::vector<Page> pages;
  std::vector<Starts> starts;
  for (const auto i : order) {
    std::vector<PixelShape> turned;
    std::vector<std::vector<Block>> blocks;
    for (int quarters = 0; quarters < 4; ++quarters) {
      turned.push_back(shapes[i].turned(quarters));
      blocks.push_back(blocks_of(turned.back()));
      if (quarters == 1 && blocks[0].size() == 1) break;  // a rectangle
    }
    for (std::size_t p = 0;; ++p) {
      const bool is_new = p == pages.size();
      if (is_new) {
        if (static_cast<int>(p) == max_pages) return {};
        pages.emplace_back(page_size, margin);
        starts.emplace_back();
      }
      auto best = std::tuple(page_size + 1, page_size + 1, page_size + 1, 0);  // bottom, top, left, quarters
      for (int quarters = 0; quarters < static_cast<int>(turned.size()); ++quarters) {
        const auto& shape = turned[static_cast<std::size_t>(quarters)];
        const auto spot =
            pages[p].find(shape, blocks[static_cast<std::size_t>(quarters)], starts[p].of(shape));
        starts[p].of(shape) = spot.y < 0 ? page_size : spot.y;
        if (spot.y >= 0) best = std::min(best, std::tuple(spot.y + shape.height(), spot.y, spot.x, quarters));
      }
      const auto [bottom, y, x, quarters] = best;
      if (bottom <= page_size) {
        pages[p].put(turned[static_cast<std::size_t>(quarters)], {x, y});
        packed.shapes[i] = {static_cast<int>(p), x, y, quarters};
        break;
      }
      if (is_new) return {};
    }
  }
  packed.pages = static_cast<int>(pages.size());
  return packed;
}

}  // namespace luxel
