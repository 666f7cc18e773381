// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/outputs.h"

#include <algorithm>
#include <exception>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/cli/mesh_output.h"
#include "luxel/cli/page_output.h"
#include "luxel/core/ending_of.h"
#include "luxel/core/output_file.h"
#include "luxel/export/export_mesh.h"
#include "luxel/export/export_page.h"
#include "luxel/image/image_file.h"
#include "luxel/render/automatic_camera.h"
#include "luxel/render/final_gather.h"
#include "luxel/render/render.h"

namespace luxel {

namespace {

bool is_among(const std::string& word, const std::string& words) {
  std::istringstream stream(words);
  for (std::string each; stream >> each;)
    if (each == word) return true;
  return false;
}

void write_mesh(const std::string& output, const Baked& baked, const std::optional<SmoothLight>& light,
                const LookSettings& look, const SampleState* samples) {
  if (is_solution(output)) return write_solution(output, baked.patches, baked.solution, samples);
  export_ply(output, baked.patches, baked.solution, *light, {.tone = look.tone});
}

// The files a run will write, each at a place of its own.
class Places {
 public:
  // Throws UsageError where the place is taken, DeviceError, beginning with the option, where no file can be
  // made there: one is made and taken away again.
  void add(const std::string& option, const std::string& path) {
    if (!taken_.insert(std::filesystem::absolute(path).lexically_normal()).second)
      throw UsageError(fmt::format("{} {} is given twice: each file needs its own name", option, path));
    try {
      const OutputFile trial(path);
    } catch (const DeviceError& error) {
      throw DeviceError(fmt::format("{}: {}", option, error.what()));
    }
  }

 private:
  std::set<std::filesystem::path> taken_;
};

}  // namespace

Vec3 up_of(const LookSettings& look, const PatchSet& patches) {
  if (look.up == "y") return {0.0f, 1.0f, 0.0f};
  if (look.up == "z") return {0.0f, 0.0f, 1.0f};
  return automatic_up(patches);
}

bool is_picture(const std::string& output) { return is_among(ending_of(output), picture_kinds); }

void expect_ending(const std::string& option, const std::string& file, const std::string& kinds) {
  if (is_among(ending_of(file), kinds)) return;
  const bool is_one = kinds.find(' ') == std::string::npos;
  throw UsageError(fmt::format("{} {}: expected {} {}", option, file,
                               is_one ? "the extension" : "one of the extensions", kinds));
}

bool is_page(const std::string& output) { return ending_of(output) == ".html"; }

namespace {

// The light a camera is found by: the same whatever method the picture's own light comes from, and however
// far it has got, so that pictures of one mesh can be laid beside each other.
Solution light_at_a_glance(const PatchSet& patches, const Tracer& tracer, const Workers& workers) {
  if (patches.has_sky()) return {};  // views are judged by what is shut in
  Solution light;
  try {
    solve_stochastic_jacobi(patches, tracer, light, glance(patches), workers);
  } catch (const InputError&) {
    return {};  // no light: all surfaces count alike
  }
  return light;
}

}  // namespace

// What the flags leave open is found: the whole view, or the other end of it.
Camera camera_of(const PictureSettings& picture, const LookSettings& look, const Baked& baked,
                 const Tracer& tracer, const Workers& workers) {
  const auto up = up_of(look, baked.patches);
  // A strip is looked at from where the widest or tallest picture that can be judged would be taken.
  const auto aspect =
      std::clamp(static_cast<float>(picture.render.width) / static_cast<float>(picture.render.height),
                 smallest_aspect, max_aspect);
  Camera camera;
  camera.up = up;
  if (picture.of_scene && !picture.eye && !picture.target)
    camera = *picture.of_scene;
  else if (!picture.eye || !picture.target)
    camera = automatic_camera(baked.patches, light_at_a_glance(baked.patches, tracer, workers), tracer,
                              workers, up, aspect);
  if (picture.eye) camera.eye = Vec3(*picture.eye - baked.patches.origin);
  if (picture.target) camera.target = Vec3(*picture.target - baked.patches.origin);
  if (picture.vertical_fov != PictureSettings::automatic_fov) camera.vertical_fov = picture.vertical_fov;
  // A plan is drawn with what lies to the north (-z where y is up) at its top.
  const Vec3d view = glm::normalize(Vec3d(camera.target) - Vec3d(camera.eye));
  const Vec3d tilt = glm::cross(view, glm::normalize(Vec3d(camera.up)));
  if (glm::length(tilt) < 1e-5) camera.up = std::abs(camera.up.y) > 0.5f ? Vec3(0, 0, -1) : Vec3(0, 1, 0);
  return camera;
}

void write_picture(const std::string& output, const Image& radiance, const ToneOptions& tone) {
  if (ending_of(output) == ".exr") return write_exr(output, radiance);
  if (ending_of(output) == ".hdr") return write_hdr(output, radiance);
  write_png(output, tone_map(radiance, tone));
}

void check_before_work(const RunSettings& run, const PictureSettings& picture, const std::string& kinds,
                       const std::string& checkpoint) {
  if (run.outputs.empty() && checkpoint.empty())
    throw UsageError("nothing to write: give at least one -o FILE with one of the extensions " + kinds);
  Places places;
  for (const auto& output : run.outputs) {
    expect_ending("-o", output, kinds);
    if (const auto why = page_is_missing(); is_page(output) && !why.empty())
      throw DeviceError(fmt::format("-o {}: {}", output, why));
    places.add("-o", output);
  }
  if (!run.report.empty()) places.add("--json-file", run.report);
  if (!checkpoint.empty()) places.add("--checkpoint", checkpoint);
  picture.check();
}

Written write_outputs(const Baked& baked, const Tracer* tracer, const RunSettings& run,
                      const LookSettings& look, const PictureSettings& picture, const Workers& workers,
                      Console& console, RunRecord& record, const StoredSamples& samples,
                      const MeshWish& mesh) {
  // The solution first, for hours went into it; pictures last, for they take a while.
  auto outputs = run.outputs;
  const auto turn = [](const std::string& o) { return is_picture(o) ? 2 : is_solution(o) ? 0 : 1; };
  std::stable_sort(outputs.begin(), outputs.end(), [&](auto& a, auto& b) { return turn(a) < turn(b); });

  std::optional<SmoothLight> light;
  std::optional<Tracer> own_tracer;
  Written written;
  const bool interrupted_before = interrupted();
  std::optional<Image> radiance;
  std::exception_ptr failure;  // one file that cannot be written does not cost the others
  for (const auto& output : outputs) {
    const bool on_pages = ending_of(output) == ".glb" && mesh.settings && mesh.settings->on_pages();
    const bool is_smooth = !is_solution(output) && !on_pages && !(is_picture(output) && picture.gather > 0);
    if (is_smooth && !light) {
      console.announce("surface");
      light = record.stage("surface", [&](auto&) {
        return make_smooth_light(baked.patches, baked.solution, look.smooth, workers);
      });
    }
    const bool is_seen = is_picture(output) || is_page(output);
    if (!tracer && (is_seen || (on_pages && needs_rays(*mesh.settings)))) {
      console.announce("hierarchy");
      own_tracer = record.stage("hierarchy", [&](auto&) { return Tracer(baked.patches, workers); });
      tracer = &*own_tracer;
    }
    if (is_seen && !written.camera) {
      written.camera =
          record.stage("camera", [&](auto&) { return camera_of(picture, look, baked, *tracer, workers); });
    }
    if (is_picture(output) && !radiance) {
      radiance = record.stage("picture", [&](auto& stage) {
        const auto pixels = static_cast<std::uint64_t>(picture.render.width) *
                            static_cast<std::uint64_t>(picture.render.height);
        const auto monitor = console.monitor(!interrupted_before);
        if (picture.gather > 0) {
          const auto grid = std::uint64_t{gather_grid(picture.gather)};
          stage.rays = 3 * grid * grid * pixels;
          return gather_picture(baked.patches, baked.solution, *tracer, *written.camera,
                                {.width = picture.render.width,
                                 .height = picture.render.height,
                                 .rays = picture.gather,
                                 .seed = picture.render.seed},
                                workers, monitor);
        }
        const auto side = static_cast<std::uint64_t>(picture.render.samples_per_side);
        stage.rays = side * side * pixels;
        return render(baked.patches, *light, *tracer, *written.camera, picture.render, workers, monitor);
      });
      written.stopped |= !interrupted_before && interrupted();
    }
    console.clear_bar();
    if (is_picture(output) && written.stopped) {
      warn(console.log(),
           fmt::format("stopped: the picture was not finished, and {} is not written", output));
      continue;
    }
    bool is_written = true;
    try {
      const auto stage = "write " + ending_of(output).substr(1);
      console.announce(stage);
      record.stage(stage, [&](auto&) {
        if (is_picture(output)) return write_picture(output, *radiance, look.tone);
        if (is_page(output))
          return write_page(output, baked, *light, samples.for_pages, *tracer, *written.camera, look,
                            workers);
        if (ending_of(output) == ".glb") {
          const auto done = write_lit_glb(output, baked, light, mesh, look, tracer, workers, console);
          is_written = done.is_written;
          if (done.pages) written.pages = done.pages;
          written.stopped |= !is_written || (done.pages && done.pages->made.texels.stopped);
          return;
        }
        write_mesh(output, baked, light, look, samples.for_solutions);
      });
      console.clear_bar();
      if (is_written)
        written.files.push_back(output);
      else
        warn(console.log(),
             fmt::format("stopped: pages of light were not finished, and {} is not written", output));
    } catch (const DeviceError& error) {
      if (failure)
        warn(console.log(), error.what());
      else
        failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
  return written;
}

}  // namespace luxel
