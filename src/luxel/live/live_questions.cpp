// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <fmt/format.h>

#include "luxel/check/diagnose.h"
#include "luxel/export/export_mesh.h"
#include "luxel/live/live_answers.h"
#include "luxel/live/live_run.h"
#include "luxel/report/error.h"

// What a live scene answers while its light is solved: files, faults, the difference to a second solution.

namespace luxel {

void LiveRun::answer_questions() {
  bool asks_faults = false;
  std::optional<std::optional<std::filesystem::path>> second;
  {
    const std::lock_guard lock(board_.mutex);
    if (!board_.has_questions()) return;
    asks_faults = std::exchange(board_.asks_faults, false);
    second = std::exchange(board_.second, {});
  }
  if (asks_faults) attempt([&] { find_faults(); });
  if (second) attempt([&] { read_second(*second); });
  write_files();
}

void LiveRun::find_faults() {
  if (!mesh_.scene)
    throw InputError(file_.string(), "faults are looked for in a scene's file; this one has no scene");
  auto report = std::make_shared<const CheckReport>(diagnose(*mesh_.scene, {}, workers_, closing_monitor()));
  const std::lock_guard lock(board_.mutex);
  board_.faults = std::move(report);
}

void LiveRun::read_second(const std::optional<std::filesystem::path>& file) {
  second_.reset();
  {
    const std::lock_guard lock(board_.mutex);
    board_.difference.reset();
  }
  if (!file) return;
  begin_stage("read");
  second_ = Second{*file, read_solution(*file)};
  const auto light = [&] {
    const std::lock_guard lock(board_.mutex);
    return board_.light;
  }();
  if (light) compare(*light);
}

void LiveRun::compare(const LiveLight& light) {
  const Baked shown{*light.mesh.patches, light.solution};
  auto difference = std::make_shared<LiveDifference>();
  try {
    difference->comparison = compare_solutions(second_->baked, shown);
    difference->relative = relative_differences(second_->baked, shown);
  } catch (...) {
    second_.reset();  // else each light to come would say the same
    throw;
  }
  difference->file = second_->file;
  difference->light = light.number;
  const std::lock_guard lock(board_.mutex);
  board_.difference = std::move(difference);
}

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
  if (glb != nullptr) {
    if (!light->smooth)
      throw InputError(file.string(), "it was closed before there was light to write into it");
    export_glb(file, *light->mesh.patches, light->solution, *light->smooth, glb->up, {.tone = glb->tone});
  } else if (light->is_relit) {
    auto patches = *light->mesh.patches;
    join_light_groups(patches);  // what was kept for each apart is not in the new file
    write_solution(file, patches, light->solution);
  } else if (light->bounces || !settings_.keeps_transport) {
    write_solution(file, *light->mesh.patches, light->solution);
  } else {
    if (light->is_last && !is_closing()) know_group_light();
    write_solution(file, *light->mesh.patches, light->solution,
                   light->is_last ? samples_.get() : light->samples.get());
  }
  const std::lock_guard lock(board_.mutex);
  board_.status.messages.push_back({Severity::info, fmt::format("{} is written", file.string())});
}

}  // namespace luxel
