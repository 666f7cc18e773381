// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "luxel/cli/console.h"
#include "luxel/cli/light_pages.h"
#include "luxel/cli/mesh_settings.h"
#include "luxel/cli/run_record.h"
#include "luxel/cli/settings.h"
#include "luxel/core/workers.h"
#include "luxel/solution/solution_file.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// The files a solution can become.
inline constexpr const char* picture_kinds = ".png .exr .hdr";
inline constexpr const char* mesh_kinds = ".glb .ply .html .vtkhdf";
inline constexpr const char* all_kinds = ".glb .ply .html .png .exr .hdr .vtkhdf";

// What can be refused before hours are spent. Throws UsageError where there is no output, one's ending is not
// among `kinds`, one is named twice, or the camera cannot be; DeviceError where a file cannot be made. A
// checkpoint is an output as well.
void check_before_work(const RunSettings& run, const PictureSettings& picture, const std::string& kinds,
                       const std::string& checkpoint = {});

// The direction that is up, as the settings say or as the surfaces do.
Vec3 up_of(const LookSettings& look, const PatchSet& patches);

// Throws UsageError where the file that an option names ends in none of `kinds`.
void expect_ending(const std::string& option, const std::string& file, const std::string& kinds);
// Whether it is one of picture_kinds, by its ending.
bool is_picture(const std::string& output);
bool is_page(const std::string& output);

// The camera that the settings name, counted from the patches' origin; what they leave open is found.
Camera camera_of(const PictureSettings& picture, const LookSettings& look, const Baked& baked,
                 const Tracer& tracer, const Workers& workers);

// radiance: W/(m² sr), tone-mapped where the ending asks for it. Throws DeviceError.
void write_picture(const std::string& output, const Image& radiance, const ToneOptions& tone);

// What is known of the samples behind the light, where it is.
struct StoredSamples {
  const SampleState* for_solutions = nullptr;         // kept in solutions
  std::shared_ptr<const SampleState> for_pages = {};  // the light of each group of lamps comes from it
};

struct Written {
  std::vector<std::string> files;
  std::optional<Camera> camera;      // of the pictures, if any was taken; from the patches' origin
  std::optional<PagesRecord> pages;  // of the last mesh that has its light on pages
  bool stopped = false;  // Ctrl-C came while a picture or pages were made: they are not there or not whole
};

// Writes each output. Builds what it needs once: the smooth light, and a tracer when there is a picture and
// none is given. After an interrupt that came before, what there is still gets written.
Written write_outputs(const Baked& baked, const Tracer* tracer, const RunSettings& run,
                      const LookSettings& look, const PictureSettings& picture, const Workers& workers,
                      Console& console, RunRecord& record, const StoredSamples& samples = {},
                      const MeshWish& mesh = {});

}  // namespace luxel
