// SPDX-License-Identifier: Apache-2.0
#include "luxel/window/picture_maker.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "luxel/report/error.h"

namespace luxel {
namespace {

std::size_t tiles_along(int pixels, int side) { return static_cast<std::size_t>((pixels + side - 1) / side); }

}  // namespace

PictureMaker::PictureMaker(std::filesystem::path file, ScreenSize size, const Look& look,
                           const Viewpoint& from, int side)
    : file_(std::move(file)),
      size_(size),
      look_(look),
      from_(from),
      side_(side),
      count_(tiles_along(size.width, side) * tiles_along(size.height, side)) {
  if (size.empty() || std::max(size.width, size.height) > largest_side)
    throw InputError(fmt::format("a picture has from 1 to {} pixels a side, not {} x {}", largest_side,
                                 size.width, size.height));
  from_.aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
}

void PictureMaker::draw_tile(Painter& painter) {
  const auto columns = tiles_along(size_.width, side_);
  const PixelOffset begin{static_cast<int>(next_ % columns) * side_,
                          static_cast<int>(next_ / columns) * side_};
  const ScreenSize its_size{std::min(side_, size_.width - begin.left),
                            std::min(side_, size_.height - begin.bottom)};
  painter.draw(canvas_, look_, from_, {size_, begin, its_size}, EdgeSmoothing::sampled, 4.0f);
  canvas_.frame.resolve();
  tiles_.push_back({begin.left, size_.height - begin.bottom - its_size.height, canvas_.frame.read_codes()});
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
    draw_tile(painter);
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
