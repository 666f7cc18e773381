// SPDX-License-Identifier: Apache-2.0
#include "luxel/apps/outputs.h"

#include <algorithm>
#include <exception>
#include <sstream>

#include <fmt/format.h>

#include "luxel/export/export_mesh.h"
#include "luxel/image/image_file.h"
#include "luxel/render/automatic_camera.h"
#include "luxel/render/render.h"

namespace luxel {
namespace {

std::string ending(const std::filesystem::path& path) {
  auto text = path.extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_among(const std::string& word, const std::string& words) {
  std::istringstream stream(words);
  for (std::string each; stream >> each;)
    if (each == word) return true;
  return false;
}

bool is_picture(const std::string& output) { return is_among(ending(output), picture_kinds); }

Vec3 up_of(const LookSettings& look, const PatchSet& patches) {
  if (look.up == "y") return {0.0f, 1.0f, 0.0f};
  if (look.up == "z") return {0.0f, 0.0f, 1.0f};
  return automatic_up(patches);
}

// What the flags leave open is found: the whole view, or the other end of it.
Camera camera_of(const PictureSettings& picture, const Baked& baked, const Tracer& tracer,
                 const Workers& workers, const Vec3& up) {
  const auto aspect = static_cast<float>(picture.render.width) / static_cast<float>(picture.render.height);
  Camera camera;
  camera.up = up;
  if (picture.eye && picture.target) {
    camera.eye = *picture.eye;
    camera.target = *picture.target;
  } else {
    camera = automatic_camera(baked.patches, baked.solution, tracer, workers, up, aspect);
    if (picture.eye) camera.eye = *picture.eye;
    if (picture.target) camera.target = *picture.target;
  }
  if (picture.fov_given || (picture.eye && picture.target)) camera.vertical_fov = picture.vertical_fov;
  return camera;
}

void write_picture(const std::string& output, const Image& radiance, const ToneOptions& tone) {
  if (ending(output) == ".exr") return write_exr(output, radiance);
  if (ending(output) == ".hdr") return write_hdr(output, radiance);
  write_png(output, tone_map(radiance, tone));
}

void write_mesh(const std::string& output, const Baked& baked, const std::optional<SmoothLight>& light,
                const LookSettings& look) {
  if (ending(output) == ".vtkhdf") return write_solution(output, baked.patches, baked.solution);
  if (ending(output) == ".ply")
    return export_ply(output, baked.patches, baked.solution, *light, {.tone = look.tone});
  export_glb(output, baked.patches, baked.solution, *light, up_of(look, baked.patches), {.tone = look.tone});
}

}  // namespace

void check_outputs(const std::vector<std::string>& outputs, const std::string& kinds) {
  if (outputs.empty())
    throw UsageError("nothing to write: give at least one -o FILE, ending in one of " + kinds);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const std::filesystem::path path(outputs[i]);
    if (!is_among(ending(path), kinds))
      throw UsageError(fmt::format("-o {}: expected an ending among {}", outputs[i], kinds));
    if (std::find(outputs.begin(), outputs.begin() + static_cast<std::ptrdiff_t>(i), outputs[i]) !=
        outputs.begin() + static_cast<std::ptrdiff_t>(i))
      throw UsageError(fmt::format("-o {} is given twice", outputs[i]));
    const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored))
      throw DeviceError(fmt::format("-o {}: the folder '{}' does not exist", outputs[i], folder.string()));
  }
}

std::optional<Camera> write_outputs(const Baked& baked, const Tracer* tracer, const RunSettings& run,
                                    const LookSettings& look, const PictureSettings& picture,
                                    const Workers& workers, Console& console, RunRecord& record) {
  // The solution first: it is what hours went into.
  auto outputs = run.outputs;
  std::stable_partition(outputs.begin(), outputs.end(), [](const auto& o) { return ending(o) == ".vtkhdf"; });

  std::optional<SmoothLight> light;
  std::optional<Tracer> own_tracer;
  std::optional<Camera> camera;
  std::optional<Image> radiance;
  std::exception_ptr failure;  // one file that cannot be written does not cost the others
  for (const auto& output : outputs) {
    if (ending(output) != ".vtkhdf" && !light)
      light = record.stage(
          "surface", [&](auto&) { return make_smooth_light(baked.patches, baked.solution, look.smooth); });
    if (is_picture(output) && !radiance) {
      if (!tracer) {
        own_tracer = record.stage("hierarchy", [&](auto&) { return Tracer(baked.patches, workers); });
        tracer = &*own_tracer;
      }
      camera = record.stage("camera", [&](auto&) {
        return camera_of(picture, baked, *tracer, workers, up_of(look, baked.patches));
      });
      radiance = record.stage("picture", [&](auto& stage) {
        const auto side = static_cast<std::uint64_t>(picture.render.samples_per_side);
        stage.rays = side * side * static_cast<std::uint64_t>(picture.render.width) *
                     static_cast<std::uint64_t>(picture.render.height);
        return render(baked.patches, *light, *tracer, *camera, picture.render, workers,
                      console.monitor(false));
      });
    }
    console.clear_bar();
    try {
      record.stage("write " + ending(output).substr(1), [&](auto&) {
        if (is_picture(output)) return write_picture(output, *radiance, look.tone);
        write_mesh(output, baked, light, look);
      });
    } catch (const DeviceError&) {
      if (!failure) failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
  return camera;
}

}  // namespace luxel
