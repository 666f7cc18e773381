// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/render/render.h"
#include "luxel/runs/light_pages.h"
#include "luxel/runs/mesh_settings.h"
#include "luxel/runs/picture_camera.h"
#include "luxel/runs/run_place.h"
#include "luxel/runs/settings.h"
#include "luxel/solution/solution_file.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Returns the file that `luxel bake` writes where none is named: room-lit.glb for room.obj, beside it or,
// where its folder cannot be written, in the working folder.
std::string default_output(const std::string& scene);

// A file that a run writes, and the option that names it.
struct NamedOutput {
  std::string option;
  std::string file;
};

// Checks outputs before the solve: those of -o, and `others`, of any extension. Throws UsageError where there
// is no output, the extension of one is not among `kinds`, two are the same file, or the camera is invalid;
// DeviceError where a file cannot be made.
void check_before_work(const RunSettings& run, const PictureSettings& picture, const std::string& kinds,
                       const std::vector<NamedOutput>& others = {});

// Throws UsageError where the file that an option names ends in none of `kinds`.
void expect_ending(const std::string& option, const std::string& file, const std::string& kinds);
// Returns whether it is one of picture_kinds, by its ending.
bool is_picture(const std::string& output);
bool is_page(const std::string& output);

// picture: W/(m² sr), tone-mapped where the extension requires it. Throws DeviceError.
void write_picture(const std::string& output, const Picture& picture, const ToneOptions& tone);

// State of the samples of the light, where available.
struct StoredSamples {
  const SampleState* for_solutions = nullptr;         // kept in solutions
  std::shared_ptr<const SampleState> for_pages = {};  // the light of each group of lamps comes from it
};

struct Written {
  std::vector<std::string> files;
  std::optional<Camera> camera;      // of the pictures, if any was taken; from the patches' origin
  std::optional<PagesRecord> pages;  // of the last mesh that has its light on pages
  bool stopped = false;  // Ctrl-C while a picture or pages were made: they are missing or incomplete
};

// The files that a command writes, and their settings.
struct OutputSettings {
  const RunSettings& run;
  const LookSettings& look;
  const PictureSettings& picture;
  MeshWish mesh = {};
  std::optional<Camera> camera = {};  // if already found; counted from the patches' origin
  bool light_is_kept = false;         // in a checkpoint
};

// Writes each output: the solution first, pictures last. Makes the smooth light, the tracer and the camera
// once, when they are needed. tracer: null where there is none yet. After an earlier interrupt everything
// is written nevertheless, or, where a solution or a checkpoint has the light, what can be in the second
// after the interrupt. Where one file cannot be written, the others are; then its DeviceError is thrown.
Written write_outputs(const Baked& baked, const Tracer* tracer, const OutputSettings& settings,
                      const RunPlace& place, const StoredSamples& samples = {});

}  // namespace luxel
