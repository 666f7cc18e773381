// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <new>
#include <utility>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <fmt/format.h>

#include "luxel/image/codec.h"
#include "luxel/image/exr_header.h"

namespace luxel {
namespace {

constexpr float largest_half = 65504.0f;

float finite(float v) { return std::isnan(v) ? 0.0f : std::clamp(v, -largest_half, largest_half); }

class MemoryOut : public Imf::OStream {
 public:
  MemoryOut() : Imf::OStream("memory") {}
  void write(const char from[], int n) override {
    const auto end = position_ + static_cast<std::size_t>(n);
    if (end > bytes.size()) bytes.resize(end);
    std::memcpy(bytes.data() + position_, from, static_cast<std::size_t>(n));
    position_ = end;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  std::string bytes;

 private:
  std::size_t position_ = 0;
};

class MemoryIn : public Imf::IStream {
 public:
  explicit MemoryIn(std::string_view bytes) : Imf::IStream("memory"), bytes_(bytes) {}
  bool read(char to[], int n) override {
    if (n < 0 || position_ > bytes_.size() || static_cast<std::size_t>(n) > bytes_.size() - position_)
      throw CodecError("it ends too early");
    std::memcpy(to, bytes_.data() + position_, static_cast<std::size_t>(n));
    position_ += static_cast<std::size_t>(n);
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::string_view bytes_;
  std::size_t position_ = 0;
};

// OpenEXR makes a buffer for a whole tile, and has no limit of its own.
void limit_tiles() {
  constexpr int max_side_of_tile = 4096;  // pixels
  static const bool is_limited = (Imf::Header::setMaxTileSize(max_side_of_tile, max_side_of_tile), true);
  static_cast<void>(is_limited);
}

// bytes: of the file.
Image read_channels(Imf::InputFile& file, std::size_t bytes) {
  const auto& window = file.header().dataWindow();
  const auto width = std::int64_t{window.max.x} - window.min.x + 1;
  const auto height = std::int64_t{window.max.y} - window.min.y + 1;
  check_size(width, height, bytes);
  const auto& channels = file.header().channels();
  const bool grey = !channels.findChannel("R") && channels.findChannel("Y");
  if (!grey && !channels.findChannel("R")) throw CodecError("there is neither a channel R nor Y");

  Image image(static_cast<int>(width), static_cast<int>(height));
  Imf::FrameBuffer frame;
  const char* const names[] = {"R", "G", "B"};
  for (int c = 0; c < (grey ? 1 : 3); ++c) {
    auto* const first = reinterpret_cast<char*>(&image.pixels.front()[c]);
    frame.insert(grey ? "Y" : names[c],
                 Imf::Slice::Make(Imf::FLOAT, first, window, sizeof(Vec3), sizeof(Vec3) * image.width));
  }
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  for (auto& pixel : image.pixels)
    pixel = grey ? Vec3(finite(pixel.r)) : Vec3(finite(pixel.r), finite(pixel.g), finite(pixel.b));
  return image;
}

}  // namespace

std::string encode_exr(const Image& linear, const Context& context) {
  std::vector<Imath::half> values;
  values.reserve(3 * linear.pixels.size());
  for (const auto& pixel : linear.pixels)
    for (int c = 0; c < 3; ++c) values.push_back(finite(pixel[c]));

  Imf::Header header(linear.width, linear.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::FrameBuffer frame;
  const auto step = 3 * sizeof(Imath::half);
  const char* const names[] = {"R", "G", "B"};
  for (int c = 0; c < 3; ++c) {
    header.channels().insert(names[c], Imf::Channel(Imf::HALF));
    frame.insert(names[c],
                 Imf::Slice(Imf::HALF, reinterpret_cast<char*>(&values[c]), step, step * linear.width));
  }
  MemoryOut memory;
  try {
    Imf::OutputFile file(memory, header, 0);
    file.setFrameBuffer(frame);
    constexpr int pixels_between_calls = 1 << 19;
    const auto rows = std::max(1, pixels_between_calls / linear.width);
    for (int y = 0; y < linear.height; y += rows) {
      if (context.report({"pictures", static_cast<double>(y) / linear.height}) == Next::stop) return {};
      file.writePixels(std::min(rows, linear.height - y));
    }
  } catch (const std::exception& e) {
    throw CodecError(e.what());
  }
  return std::move(memory.bytes);
}

Raster decode_exr(std::string_view bytes) {
  limit_tiles();
  check_exr_header(bytes);
  try {
    MemoryIn memory(bytes);
    Imf::InputFile file(memory, 0);
    return of_numbers(read_channels(file, bytes.size()));
  } catch (const CodecError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    throw CodecError(fmt::format("the EXR picture is damaged: {}", e.what()));
  }
}

}  // namespace luxel
