// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/picture_maker.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"

namespace luxel {
namespace {

constexpr int small_tile = 512, large_tile = 1024;  // pixels per side, multiples of four: see LocalTone
constexpr float point_size = 4.0f;                  // pixels

std::size_t tiles_along(int pixels, int side) { return static_cast<std::size_t>((pixels + side - 1) / side); }

}  // namespace

PictureMaker::PictureMaker(std::filesystem::path file, ScreenSize size, const Look& look,
                           const Viewpoint& from, bool is_software)
    : file_(std::move(file)),
      size_(size),
      look_(look),
      from_(from),
      is_software_(is_software),
      side_(is_software ? small_tile : large_tile),
      count_(tiles_along(size.width, side_) * tiles_along(size.height, side_)) {
  if (size.empty() || std::max(size.width, size.height) > max_side)
    throw InputError(fmt::format("a picture has from 1 to {} pixels a side, not {} x {}", max_side,
                                 size.width, size.height));
  from_.aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
}

void PictureMaker::begin(const ToneCurve& tone) {
  from_.tone = tone;
  has_begun_ = true;
}

PicturePart PictureMaker::next_part() const {
  const auto columns = tiles_along(size_.width, side_);
  const PixelOffset begin{static_cast<int>(next_ % columns) * side_,
                          static_cast<int>(next_ / columns) * side_};
  return {size_,
          begin,
          {std::min(side_, size_.width - begin.left), std::min(side_, size_.height - begin.bottom)}};
}

// Draws one of the shifted pictures of a tile. With a software renderer they are rough: the programs for
// these are already compiled for the window, and the others would take a tenth of a second.
void PictureMaker::draw_some(Painter& painter) {
  const auto part = next_part();
  auto& frame = canvas_.frame;
  const auto edges = is_software_ ? EdgeSmoothing::rough : EdgeSmoothing::sampled;
  painter.draw(canvas_, look_, from_, {part, edges, point_size, shifted_tile(joined_, size_)});
  frame.resolve();
  frame.join(joined_++);
  frame.wait();
  if (joined_ < shifts) return;
  frame.show_joined();
  joined_ = 0;
  tiles_.push_back(
      {part.begin.left, size_.height - part.begin.bottom - part.size.height, frame.read_codes()});
  ++next_;
}

void PictureMaker::write(const std::filesystem::path& file, ScreenSize size,
                         const std::vector<Piece>& tiles) {
  ScreenImage whole{size.width, size.height, {}};
  whole.codes.resize(3 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  for (const auto& tile : tiles)
    for (int row = 0; row < tile.image.height; ++row)
      std::copy_n(tile.image.codes.data() + tile.image.index(0, row), 3 * tile.image.width,
                  whole.codes.data() + whole.index(tile.left, tile.top + row));
  write_png(file, whole);
}

bool PictureMaker::go_on(Painter& painter, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  while (!is_drawn()) {
    draw_some(painter);
    if (is_drawn()) {
      writing_.start([file = file_, size = size_, tiles = std::move(tiles_)] {
        write(file, size, tiles);
        return true;
      });
      return false;
    }
    if (std::chrono::duration<double>(Clock::now() - begin).count() >= seconds) return false;
  }
  return writing_.take().has_value();
}

void PictureMaker::finish(Painter& painter) {
  while (!is_drawn()) go_on(painter, 1.0);
  writing_.wait();
  writing_.take();
}

}  // namespace luxel
