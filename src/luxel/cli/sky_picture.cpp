// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/sky_picture.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "luxel/image/false_colours.h"

namespace luxel {
namespace {

// cd/m² of a model whose relative luminance is 1.
double scale_of(const OutsideLight& light) {
  return light.horizontal_illuminance / relative_illuminances(light.model).horizontal;
}

// The picture of the dome, pixels.
constexpr int width = 720, height = 640;
constexpr double radius = 270.0, middle_x = 320.0, middle_y = 320.0;

struct Letter {
  std::array<std::uint8_t, 7> rows;  // of five bits, the highest one on the left
  double azimuth;                    // degrees
};
constexpr std::array<Letter, 4> compass = {{{{17, 25, 25, 21, 19, 19, 17}, 0.0},      // N
                                            {{31, 16, 16, 30, 16, 16, 31}, 90.0},     // E
                                            {{15, 16, 16, 14, 1, 1, 30}, 180.0},      // S
                                            {{17, 17, 17, 21, 21, 27, 17}, 270.0}}};  // W

class Dome {
 public:
  explicit Dome(Image& image) : image_(image) {}

  void draw_letters() {
    constexpr int size = 3;  // pixels per pixel of a letter
    for (const auto& letter : compass) {
      const auto turn = direction_towards(0.0, letter.azimuth);
      const auto x = middle_x + (radius + 24.0) * turn.x - 2.5 * size;
      const auto y = middle_y - (radius + 24.0) * turn.y - 3.5 * size;
      for (int j = 0; j < 7 * size; ++j)
        for (int i = 0; i < 5 * size; ++i)
          if ((letter.rows[static_cast<std::size_t>(j / size)] >> (4 - i / size) & 1) != 0)
            mix(static_cast<int>(x) + i, static_cast<int>(y) + j, Vec3(0.9f), 1.0);
    }
  }

  // A circle of this width in pixels, smooth at its edges.
  void draw_circle(double x, double y, double r, double line, const Vec3& colour) {
    const auto reach = static_cast<int>(r + line) + 1;
    for (int j = static_cast<int>(y) - reach; j <= static_cast<int>(y) + reach; ++j)
      for (int i = static_cast<int>(x) - reach; i <= static_cast<int>(x) + reach; ++i) {
        const auto distance = std::abs(std::hypot(i + 0.5 - x, j + 0.5 - y) - r);
        mix(i, j, colour, std::clamp(0.5 * line + 0.5 - distance, 0.0, 1.0));
      }
  }

 private:
  void mix(int x, int y, const Vec3& colour, double alpha) {
    if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return;
    const auto a = static_cast<float>(alpha);
    image_.at(x, y) = (1.0f - a) * image_.at(x, y) + a * colour;
  }

  Image& image_;
};

}  // namespace

Image sky_panorama(const OutsideLight& light) {
  constexpr int columns = 1024, rows = 512;
  const auto scale = scale_of(light);
  const auto ground =
      ground_luminance(light.albedo, light.horizontal_illuminance + light.direct_horizontal_illuminance());
  Image image(columns, rows);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const auto direction = direction_towards(90.0 - 180.0 * (y + 0.5) / rows, 360.0 * (x + 0.5) / columns);
      const auto luminance = y < rows / 2 ? scale * light.model.relative_luminance(direction) : ground;
      image.at(x, y) = Vec3(static_cast<float>(luminance));
    }
  return image;
}

Image sky_dome(const OutsideLight& light) {
  const auto scale = scale_of(light);
  std::vector<double> values(static_cast<std::size_t>(width) * height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto east = (x + 0.5 - middle_x) / radius, north = (middle_y - y - 0.5) / radius;
      const auto r = std::hypot(east, north);
      auto& value = values[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
      value = std::numeric_limits<double>::quiet_NaN();
      if (r > 1.0) continue;
      const auto level = direction_towards(90.0 * (1.0 - r), azimuth_of({east, north, 0.0}));
      value = scale * light.model.relative_luminance(level);
    }
  auto image = false_colours(values, width, height, automatic_scale(values, "cd/m2"));
  Dome dome(image);
  dome.draw_letters();
  for (const double r : {1.0 / 3.0, 2.0 / 3.0, 1.0})
    dome.draw_circle(middle_x, middle_y, r * radius, 1.0, Vec3(0.35f));
  if (light.sun && light.sun->elevation >= 0.0) {
    const auto& d = light.sun->direction;
    const auto level = std::hypot(d.x, d.y);
    const auto r = level > 0.0 ? radius * (1.0 - light.sun->elevation / 90.0) / level : 0.0;
    dome.draw_circle(middle_x + r * d.x, middle_y - r * d.y, 8.0, 4.0, Vec3(0.0f));
    dome.draw_circle(middle_x + r * d.x, middle_y - r * d.y, 8.0, 2.0, Vec3(1.0f));
  }
  return image;
}

}  // namespace luxel
