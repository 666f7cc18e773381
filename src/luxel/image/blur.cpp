// SPDX-License-Identifier: Apache-2.0
#include "luxel/image/blur.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace luxel {
namespace {

// weights[j] belongs to the offset j - radius.
struct Kernel {
  int radius;
  std::vector<float> weights;

  // 1 / the sum of the weights that fall inside a line of n pixels, at each of its pixels.
  std::vector<float> inverse_sums(int n) const {
    std::vector<float> inverse(static_cast<std::size_t>(n));
    for (int x = 0; x < n; ++x) {
      float sum = 0.0f;
      for (int j = std::max(-radius, -x); j <= std::min(radius, n - 1 - x); ++j) sum += weights[j + radius];
      inverse[x] = 1.0f / sum;
    }
    return inverse;
  }
};

Kernel make_kernel(float sigma) {
  const int radius = std::max(1, static_cast<int>(std::ceil(3.0f * sigma)));
  Kernel kernel{radius, {}};
  for (int j = -radius; j <= radius; ++j) {
    const double u = j / static_cast<double>(sigma);
    kernel.weights.push_back(static_cast<float>(std::exp(-0.5 * u * u)));
  }
  return kernel;
}

void add_scaled(float* to, const float* from, float weight, std::size_t n) {
  for (std::size_t x = 0; x < n; ++x) to[x] += weight * from[x];
}

GreyPicture blur_rows(const GreyPicture& in, const Kernel& kernel) {
  const auto n = static_cast<std::size_t>(in.width);
  const auto radius = static_cast<std::size_t>(kernel.radius);
  const auto inverse = kernel.inverse_sums(in.width);
  GreyPicture out{in.width, in.height, std::vector<float>(in.values.size(), 0.0f)};
  std::vector<float> padded(n + 2 * radius, 0.0f);  // zeros on both sides: they add nothing
  for (std::size_t y = 0; y < static_cast<std::size_t>(in.height); ++y) {
    std::copy_n(in.values.data() + y * n, n, padded.data() + radius);
    float* const row = out.values.data() + y * n;
    for (std::size_t j = 0; j < kernel.weights.size(); ++j)
      add_scaled(row, padded.data() + j, kernel.weights[j], n);
    for (std::size_t x = 0; x < n; ++x) row[x] *= inverse[x];
  }
  return out;
}

GreyPicture blur_columns(const GreyPicture& in, const Kernel& kernel) {
  const auto n = static_cast<std::size_t>(in.width);
  const auto inverse = kernel.inverse_sums(in.height);
  GreyPicture out{in.width, in.height, std::vector<float>(in.values.size(), 0.0f)};
  for (int y = 0; y < in.height; ++y) {
    float* const row = out.values.data() + static_cast<std::size_t>(y) * n;
    for (int j = std::max(-kernel.radius, -y); j <= std::min(kernel.radius, in.height - 1 - y); ++j)
      add_scaled(row, in.values.data() + static_cast<std::size_t>(y + j) * n,
                 kernel.weights[j + kernel.radius] * inverse[y], n);
  }
  return out;
}

}  // namespace

GreyPicture gaussian_blur(const GreyPicture& plane, float sigma) {
  const auto kernel = make_kernel(sigma);
  return blur_columns(blur_rows(plane, kernel), kernel);
}

}  // namespace luxel
