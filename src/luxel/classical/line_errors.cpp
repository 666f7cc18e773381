// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/line_errors.h"

#include <algorithm>
#include <cmath>

#include "luxel/classical/gauss_seidel.h"
#include "luxel/core/address.h"

namespace luxel {
namespace {

constexpr std::uint32_t probes = 8;
constexpr double probe_tolerance = 0.02;
constexpr std::size_t grain = 64;  // receivers per chunk

std::vector<double> own_variance(const LinesOperator& transport, const RowLight& light,
                                 const Context& context) {
  const auto bands = transport.bands();
  const double lines = transport.lines();
  std::vector<double> sky;
  for (std::size_t b = 0; b < bands; ++b) sky.push_back(transport.patches().sky_radiosity(0, b));
  auto brightest = sky;
  for (std::size_t i = 0; i < light.before.size(); ++i)
    brightest[i % bands] = std::max(brightest[i % bands], double{light.before[i]});
  std::vector<double> variance(light.before.size());
  context.for_chunks(transport.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    std::vector<double> square(bands), mean(bands);
    transport.for_rows(begin, end, [&](std::size_t receiver, std::span<const RowOperator::Factor> row) {
      for (std::size_t b = 0; b < bands; ++b) {
        mean[b] = transport.losses().escaped[receiver] * sky[b];
        square[b] = mean[b] * sky[b];
      }
      for (const auto& factor : row)
        for (std::size_t b = 0; b < bands; ++b) {
          const double B = light.before[factor.receiver * bands + b];
          square[b] += double{factor.fraction} * B * B;
          mean[b] += double{factor.fraction} * B;
        }
      for (std::size_t b = 0; b < bands; ++b) {
        const auto missed = brightest[b] / lines;
        variance[receiver * bands + b] =
            std::max(0.0, square[b] - mean[b] * mean[b]) / lines + 0.5 * missed * missed;
      }
    });
  });
  return variance;
}

}  // namespace

std::vector<float> line_errors(const LinesOperator& transport, const RowLight& light, std::uint64_t seed,
                               const Context& context) {
  const auto bands = transport.bands();
  const auto own = own_variance(transport, light, context);
  std::vector<double> passed_on(own.size(), 0.0);
  std::vector<float> drawn(own.size()), reflected(own.size()), whole(own.size());
  for (std::uint32_t probe = 0; probe < probes; ++probe) {
    const auto key = stream_key(seed, RandomPurpose::line_probes, probe);
    for (std::size_t i = 0; i < own.size(); ++i) {
      const auto sign = uniform4(key, i / bands)[0] < 0.5f ? -1.0 : 1.0;
      drawn[i] = static_cast<float>(sign * std::sqrt(own[i]));
    }
    std::fill(reflected.begin(), reflected.end(), 0.0f);
    gauss_seidel(transport, {drawn, light.scattering, reflected, whole}, {.tolerance = probe_tolerance},
                 context.quiet());
    for (std::size_t i = 0; i < own.size(); ++i) {
      const auto more = double{whole[i]} - double{drawn[i]};
      passed_on[i] += (more + 2.0 * double{drawn[i]}) * more / probes;
    }
  }
  std::vector<float> error(own.size());
  for (std::size_t i = 0; i < own.size(); ++i)
    error[i] = static_cast<float>(std::sqrt(own[i] + std::max(0.0, passed_on[i])));
  return error;
}

}  // namespace luxel
