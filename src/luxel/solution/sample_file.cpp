// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/sample_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace luxel {
namespace {

const std::string group = "Luxel/samples";

std::string round_name(std::size_t index) { return fmt::format("{}/round_{:02}", group, index); }

// Writes light[replicate][number] as one table.
void add_light(Hdf5Writer& file, const std::string& name, const std::vector<std::vector<float>>& light) {
  std::vector<float> all;
  all.reserve(light.size() * light[0].size());
  for (const auto& replicate : light) all.insert(all.end(), replicate.begin(), replicate.end());
  file.add_array(name, table(std::span<const float>(all), light.size(), light[0].size()), "W/m^2");
}

std::vector<std::vector<float>> read_light(const Hdf5Reader& file, const std::string& name,
                                           std::size_t replicates, std::size_t width) {
  const auto all = file.array<float>(name, replicates, width);
  if (!std::all_of(all.begin(), all.end(), [](float x) { return std::isfinite(x); }))
    file.refuse_as_damaged(fmt::format("'{}' holds a number that is not finite", name));
  std::vector<std::vector<float>> light;
  for (std::size_t r = 0; r < replicates; ++r)
    light.emplace_back(all.begin() + static_cast<std::ptrdiff_t>(r * width),
                       all.begin() + static_cast<std::ptrdiff_t>((r + 1) * width));
  return light;
}

HitRound read_round(const Hdf5Reader& file, const std::string& name, std::uint32_t replicates) {
  HitRound round;
  round.level = file.number<std::uint32_t>(name, "level");
  round.per_replicate = file.number<std::uint32_t>(name, "rays_per_replicate");
  round.receivers = file.array<std::uint32_t>(name + "/receiver", file.rows(name + "/receiver"));
  if (!std::has_single_bit(round.per_replicate) || round.per_replicate > 1u << 30)
    file.refuse_as_damaged(fmt::format("'{}' has {} rays per replicate", name, round.per_replicate));
  if (!file.has(name + "/hit")) return round;
  // The shape is checked against the size of the file before memory is allocated.
  const auto hits = std::make_shared<std::vector<std::uint32_t>>(
      file.array<std::uint32_t>(name + "/hit", replicates, round.hits_per_replicate()));
  round.hits = {hits, hits->data()};
  return round;
}

}  // namespace

void add_samples(Hdf5Writer& file, const SampleState& state) {
  file.set_deflate(0);
  file.add_group(group);
  file.add_number(group, "replicates", state.replicates);
  file.add_number(group, "rounds_done", state.rounds_done);
  file.add_number(group, "rays", state.rays);
  file.add_number(group, "first_rays", state.first_rays);
  file.add_number(group, "rounds", static_cast<std::uint32_t>(state.rounds.size()));
  const auto sides = indices_of(state.sides);
  file.add_array(group + "/side", flat(sides));
  file.add_array(group + "/direct_samples", flat(state.direct_samples));
  file.add_array(group + "/direct_doublings", flat(state.direct_doublings));
  add_light(file, group + "/direct", state.direct);
  if (!state.gathered.empty()) add_light(file, group + "/gathered", state.gathered);
  file.add_array(group + "/radiosity", flat(state.radiosity), "W/m^2");
  for (std::size_t i = 0; i < state.rounds.size(); ++i) {
    const auto& round = state.rounds[i];
    const auto name = round_name(i);
    file.add_group(name);
    file.add_number(name, "level", round.level);
    file.add_number(name, "rays_per_replicate", round.per_replicate);
    file.add_array(name + "/receiver", flat(round.receivers));
    if (round.hits)
      file.add_array(name + "/hit", Hdf5Array{Hdf5Element::uint32, round.hits.get(), state.replicates,
                                              round.hits_per_replicate()});
  }
}

SampleState read_samples(const Hdf5Reader& file, const PatchSet& patches) {
  SampleState state;
  state.replicates = file.number<std::uint32_t>(group, "replicates");
  if (state.replicates < 4 || state.replicates > 32)
    file.refuse_as_damaged(fmt::format("its samples have {} replicates", state.replicates));
  state.rounds_done = file.number<std::uint32_t>(group, "rounds_done");
  state.rays = file.number<std::uint64_t>(group, "rays");
  state.first_rays = file.number<std::uint64_t>(group, "first_rays");
  const auto receivers = file.rows(group + "/side");
  const auto width = receivers * patches.group_count() * patches.band_count();
  state.sides = sides_at(file.array<std::uint32_t>(group + "/side", receivers));
  state.direct_samples = file.array<std::uint32_t>(group + "/direct_samples", receivers);
  state.direct_doublings = file.array<std::uint32_t>(group + "/direct_doublings", receivers);
  state.direct = read_light(file, group + "/direct", state.replicates, width);
  if (file.has(group + "/gathered"))
    state.gathered = read_light(file, group + "/gathered", state.replicates, width);
  const auto radiosities = file.rows(group + "/radiosity");
  state.radiosity = file.array<float>(group + "/radiosity", radiosities);
  if (!std::all_of(state.radiosity.begin(), state.radiosity.end(), [](float x) { return std::isfinite(x); }))
    file.refuse_as_damaged("a stored radiosity is not finite");
  const auto rounds = file.number<std::uint32_t>(group, "rounds");
  for (std::uint32_t i = 0; i < rounds && file.has(round_name(i)); ++i)
    state.rounds.push_back(read_round(file, round_name(i), state.replicates));
  if (state.rounds.size() != rounds)
    file.refuse_as_damaged(
        fmt::format("it holds {} rounds of rays, but claims {}", state.rounds.size(), rounds));
  return state;
}

}  // namespace luxel
