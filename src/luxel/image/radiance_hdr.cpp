// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "luxel/image/codec.h"

// Radiance RGBE pictures: G. Ward, "Real Pixels", Graphics Gems II, 1991; the file format in Radiance's
// manual. Own reader, as stb_image.h of 2022 loops endlessly on a picture that ends inside a packed row.
namespace luxel {
namespace {

class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  std::uint8_t byte() {
    if (rest_.empty()) throw CodecError("the HDR picture ends too early");
    const auto b = static_cast<std::uint8_t>(rest_.front());
    rest_.remove_prefix(1);
    return b;
  }
  std::string_view line() {
    const auto end = rest_.find('\n');
    if (end == std::string_view::npos) throw CodecError("the HDR picture ends within its header");
    const auto found = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return found;
  }
  // Returns whether a row of this many pixels is packed: it begins with 2, 2 and its length. Consumes these
  // if so.
  bool take_packed_mark(int width) {
    const std::array<char, 4> mark = {2, 2, static_cast<char>(width >> 8), static_cast<char>(width)};
    const std::string_view expected(mark.data(), mark.size());
    if (width < 8 || width > 0x7fff || rest_.substr(0, mark.size()) != expected) return false;
    rest_.remove_prefix(mark.size());
    return true;
  }

 private:
  std::string_view rest_;
};

using Rgbe = std::array<std::uint8_t, 4>;

void read_size(std::string_view line, int& width, int& height) {
  const auto refuse = [] {
    throw CodecError("the HDR picture's size is not of the form '-Y height +X width'");
  };
  const auto number = [&](std::string_view before, int& value) {
    if (line.substr(0, before.size()) != before) refuse();
    line.remove_prefix(before.size());
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
    if (error != std::errc()) refuse();
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
  };
  number("-Y ", height);
  number(" +X ", width);
}

// Each of the four bytes of all pixels in turn, as runs (count + 128, value) and dumps (count, values).
void read_packed_row(Reader& in, std::vector<Rgbe>& row) {
  for (std::size_t channel = 0; channel < 4; ++channel)
    for (std::size_t x = 0; x < row.size();) {
      const std::size_t count = in.byte();
      const bool is_run = count > 128;
      const std::size_t n = is_run ? count - 128 : count;
      if (n == 0 || n > row.size() - x) throw CodecError("the HDR picture is damaged: a row is too long");
      const auto value = is_run ? in.byte() : std::uint8_t{0};
      for (std::size_t i = 0; i < n; ++i) row[x++][channel] = is_run ? value : in.byte();
    }
}

Vec3 color(const Rgbe& rgbe) {
  if (rgbe[3] == 0) return Vec3(0.0f);
  return std::ldexp(1.0f, rgbe[3] - (128 + 8)) * Vec3(rgbe[0], rgbe[1], rgbe[2]);
}

}  // namespace

Raster decode_hdr(std::string_view bytes) {
  Reader in(bytes);
  bool is_rgbe = false;
  for (auto line = in.line(); !line.empty(); line = in.line()) is_rgbe |= line == "FORMAT=32-bit_rle_rgbe";
  if (!is_rgbe) throw CodecError("the HDR picture is not of the format 32-bit_rle_rgbe");
  int width = 0, height = 0;
  read_size(in.line(), width, height);
  check_size(width, height, bytes.size());

  Image image(width, height);
  std::vector<Rgbe> row(static_cast<std::size_t>(width));
  for (int y = 0; y < height; ++y) {
    if (in.take_packed_mark(width)) {
      read_packed_row(in, row);
    } else {
      for (auto& pixel : row)
        for (auto& byte : pixel) byte = in.byte();
    }
    for (int x = 0; x < width; ++x) image.at(x, y) = color(row[x]);
  }
  return of_numbers(std::move(image));
}

}  // namespace luxel
