// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/unshot_light.h"

#include <algorithm>
#include <vector>

namespace luxel {
namespace {

void subtract(const std::vector<float>& now, std::vector<float>& before, std::vector<float>& unshot) {
  unshot.resize(now.size());
  for (std::size_t i = 0; i < now.size(); ++i) unshot[i] = std::max(0.0f, now[i] - before[i]);
  before = now;
}

}  // namespace

void UnshotLight::begin(const PatchSet& patches) {
  clear();
  is_active_ = true;
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (std::size_t b = 0; b < patches.band_count(); ++b)
      radiosity_.front.push_back(patches.emittance(p, b));
  radiosity_.back.assign(radiosity_.front.size(), 0.0f);
}

void UnshotLight::clear() { *this = {}; }

void UnshotLight::add_bounce(const Solution& light) {
  if (!is_active_) return;
  subtract(light.radiosity.front, radiosity_.front, unshot_.front);
  subtract(light.radiosity.back, radiosity_.back, unshot_.back);
}

}  // namespace luxel
