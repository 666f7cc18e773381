// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/run_record.h"

#include <fmt/format.h>

#include "luxel/core/process_usage.h"
#include "luxel/runs/quantity.h"

namespace luxel {

RunRecord::RunRecord() : RunRecord(process_age()) {}
RunRecord::RunRecord(double age) : made_(std::chrono::steady_clock::now()), age_when_made_(age) {}

double RunRecord::now() const {
  return age_when_made_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - made_).count();
}

void RunRecord::note_light() {
  if (!first_light_) first_light_ = now();
}

std::optional<double> RunRecord::first_light_after_load() const {
  for (const auto& s : stages_)
    if (first_light_ && s.name == "load") return *first_light_ - (s.begin + s.seconds);
  return std::nullopt;
}

std::string RunRecord::table() const {
  double total = 0.0;
  for (const auto& s : stages_) total += s.seconds;
  auto text =
      fmt::format("{:<12}{:>10}{:>10}{:>16}{:>12}\n", "stage", "seconds", "fraction", "rays", "ns per ray");
  const auto line = [&](const std::string& name, double seconds, std::uint64_t rays) {
    text +=
        fmt::format("{:<12}{:>10.2f}{:>8.0f} %", name, seconds, total > 0.0 ? 100.0 * seconds / total : 0.0);
    if (rays > 0) text += fmt::format("{:>16}{:>12.0f}", rays, 1e9 * seconds / static_cast<double>(rays));
    text += '\n';
  };
  for (const auto& s : stages_) line(s.name, s.seconds, s.rays);
  line("all", total, 0);
  if (first_light_)
    text += fmt::format("first light {:.2f} s after the start, {:.2f} s after loading\n", *first_light_,
                        first_light_after_load().value_or(*first_light_));
  return text;
}

std::uint64_t RunRecord::rays() const {
  std::uint64_t sum = 0;
  for (const auto& s : stages_) sum += s.rays;
  return sum;
}

std::string RunRecord::summary() const {
  auto text = taken_time(now());
  if (rays() > 0) text += fmt::format(", {} rays", rough_count(rays()));
  return text + fmt::format(", {} of memory", rough_bytes(peak_memory()));
}

}  // namespace luxel
