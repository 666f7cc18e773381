// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/provenance_file.h"

#include <array>
#include <cstdint>
#include <vector>

namespace luxel {

void add_provenance(Hdf5Writer& file, const std::string& group, const Provenance& provenance) {
  const auto add_string = [&](const std::string& name, const std::string& value) {
    file.add_strings(group + "/" + name, std::array{value});
  };
  file.add_group(group);
  file.add_number(group, "seed", provenance.seed);
  file.add_number(group, "rays", provenance.rays);
  file.add_number(group, "scene_fingerprint", provenance.scene_fingerprint);
  add_string("program_version", provenance.program_version);
  add_string("command_line", provenance.command_line);
  add_string("method", provenance.method);
  std::vector<std::string> names, values;
  for (const auto& [name, value] : provenance.options) {
    names.push_back(name);
    values.push_back(value);
  }
  file.add_strings(group + "/option_name", names);
  file.add_strings(group + "/option_value", values);
  if (provenance.merged.empty()) return;
  std::vector<std::uint64_t> streams;
  for (const auto& [seed, rays] : provenance.merged) streams.insert(streams.end(), {seed, rays});
  file.add_array(group + "/merged", table(std::span<const std::uint64_t>(streams), streams.size() / 2, 2));
}

Provenance read_provenance(const Hdf5Reader& file, const std::string& group) {
  const auto string = [&](const std::string& name) { return file.strings(group + "/" + name, 1)[0]; };
  Provenance provenance;
  provenance.program_version = string("program_version");
  provenance.command_line = string("command_line");
  provenance.method = string("method");
  const auto n = file.rows(group + "/option_name");
  const auto names = file.strings(group + "/option_name", n);
  const auto values = file.strings(group + "/option_value", n);
  for (std::size_t i = 0; i < n; ++i) provenance.options.emplace_back(names[i], values[i]);
  provenance.seed = file.number<std::uint64_t>(group, "seed");
  provenance.rays = file.number<std::uint64_t>(group, "rays");
  provenance.scene_fingerprint = file.number<std::uint64_t>(group, "scene_fingerprint");
  if (file.has(group + "/merged")) {
    const auto runs = file.rows(group + "/merged");
    const auto streams = file.array<std::uint64_t>(group + "/merged", runs, 2);
    for (std::size_t i = 0; i < runs; ++i) provenance.merged.push_back({streams[2 * i], streams[2 * i + 1]});
  }
  return provenance;
}

}  // namespace luxel
