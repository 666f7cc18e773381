// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/export/export_mesh.h"
#include "luxel/session/live_run.h"

// What a live scene writes while its light is solved.

namespace luxel {

void LiveRun::write_files() {
  while (true) {
    std::optional<FileOrder> order;
    {
      const std::lock_guard lock(board_.mutex);
      if (board_.files.empty()) return;
      order = std::move(board_.files.front());
      board_.files.pop_front();
    }
    attempt([&] { write(*order); });
  }
}

void LiveRun::write(const FileOrder& order) {
  const auto light = [&] {
    const std::lock_guard lock(board_.mutex);
    return board_.light;
  }();
  const auto* glb = std::get_if<GlbOrder>(&order);
  const auto& file = glb != nullptr ? glb->file : std::get<std::filesystem::path>(order);
  if (!light) throw InputError(file.string(), "there is no light yet to write into it");
  begin_stage("write");
  auto done = fmt::format("{} is written", file.string());
  if (glb != nullptr) {
    if (!light->smooth)
      throw InputError(file.string(), "it was closed before there was light to write into it");
    export_glb(file, *light->mesh.patches, light->solution, *light->smooth, glb->up, {.tone = glb->tone});
  } else if (light->is_relit) {
    auto patches = *light->mesh.patches;
    join_light_groups(patches);  // what was kept for each apart is not in the new file
    write_solution(file, patches, light->solution);
  } else if (light->bounces || !settings_.stores_transport) {
    write_solution(file, *light->mesh.patches, light->solution);
  } else {
    if (light->is_last && !is_closing()) know_group_light();
    const auto& samples = light->is_last ? samples_ : light->samples;
    write_solution(file, *light->mesh.patches, light->solution, samples.get());
    if (samples && samples->gathered.empty())
      done += ", without the light of each lamp apart, which is not known yet: its first relighting finds it";
  }
  const std::lock_guard lock(board_.mutex);
  board_.status.messages.push_back({Severity::note, std::move(done)});
}

}  // namespace luxel
