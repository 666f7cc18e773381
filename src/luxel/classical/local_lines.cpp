// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/local_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "luxel/core/address.h"
#include "luxel/patch/side.h"
#include "luxel/trace/patch_emitter.h"

namespace luxel {
namespace {

constexpr std::size_t batch = 256;  // lines traced together

// Sorts the hits and counts equal ones.
void count_alike(std::vector<SideId>& met, std::vector<LineCounts::Entry>& entries) {
  std::sort(met.begin(), met.end());
  entries.clear();
  for (const auto side : met) {
    if (entries.empty() || entries.back().side != side) entries.push_back({side, 0});
    ++entries.back().lines;
  }
}

}  // namespace

double line_factor(std::uint32_t lines_met, std::uint32_t lines_shot) {
  return lines_shot == 0 ? 0.0 : static_cast<double>(lines_met) / lines_shot;
}

double line_standard_error(std::uint32_t lines_met, std::uint32_t lines_shot) {
  const auto n = static_cast<double>(lines_shot);
  const auto p = (lines_met + 0.5) / (n + 1.0);
  return std::sqrt(p * (1.0 - p) / std::max(1.0, n));
}

void count_local_lines(const PatchSet& patches, const Tracer& tracer, SideId side, const LineRays& line_rays,
                       LineCounts& counts) {
  const auto lines = line_rays.lines;

  const PatchEmitter emitter(patches, side);
  const auto key = stream_key(line_rays.seed, line_rays.step, side.index());
  std::vector<SideId> met;
  met.reserve(lines);
  std::array<Ray, batch> rays;
  std::array<Hit, batch> hits;
  for (std::size_t from = 0; from < lines; from += batch) {
    const auto n = std::min<std::size_t>(batch, lines - from);
    for (std::size_t i = 0; i < n; ++i) rays[i] = emitter.ray(uniform4(key, from + i));
    tracer.nearest(std::span(rays.data(), n), std::span(hits.data(), n));
    for (std::size_t i = 0; i < n; ++i)
      if (hits[i]) met.emplace_back(hits[i].patch, hits[i].back);
  }
  counts.lines = lines;
  counts.escaped = lines - static_cast<std::uint32_t>(met.size());
  count_alike(met, counts.entries);
}

FormFactorRow row_of(const LineCounts& counts) {
  FormFactorRow row;
  row.entries.reserve(counts.entries.size());
  for (const auto& entry : counts.entries)
    row.entries.push_back({entry.side, static_cast<float>(line_factor(entry.lines, counts.lines))});
  row.escaped = line_factor(counts.escaped, counts.lines);
  return row;
}

}  // namespace luxel
