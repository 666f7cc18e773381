// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/outputs.h"

#include <algorithm>
#include <exception>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "luxel/core/ending_of.h"
#include "luxel/core/output_file.h"
#include "luxel/export/export_mesh.h"
#include "luxel/export/export_page.h"
#include "luxel/image/false_colours.h"
#include "luxel/image/image_file.h"
#include "luxel/render/final_gather.h"
#include "luxel/render/photometric_picture.h"
#include "luxel/runs/mesh_output.h"
#include "luxel/runs/page_output.h"
#include "luxel/surface/hidden_sides.h"

namespace luxel {

namespace {

bool is_among(const std::string& word, const std::string& words) {
  std::istringstream stream(words);
  for (std::string each; stream >> each;)
    if (each == word) return true;
  return false;
}

// The files that a run will write, each at a different place.
class Places {
 public:
  // Throws UsageError if the place is taken; DeviceError, beginning with the option, if no file can be
  // created there. Tests it by creating and removing one.
  void add(const std::string& option, const std::string& path) {
    if (!taken_.insert(std::filesystem::absolute(path).lexically_normal()).second)
      throw UsageError(fmt::format("{} {} is given twice: each file needs its own name", option, path));
    try {
      const OutputFile trial(path);
    } catch (const DeviceError& error) {
      throw DeviceError(fmt::format("{}: {}", option, error.what()), path);
    }
  }

 private:
  std::set<std::filesystem::path> taken_;
};

}  // namespace

std::string default_output(const std::string& scene) {
  const std::filesystem::path path(scene);
  const auto name = path.stem().string() + "-lit.glb";
  auto beside = (path.parent_path() / name).string();
  try {
    const OutputFile trial(beside);
    return beside;
  } catch (const DeviceError&) {
    return name;
  }
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

// A picture of luminance or illuminance: values in all channels, or false colours.
void write_values(const std::string& output, const Image& radiance, const PictureSettings& settings) {
  const bool is_luminance = settings.quantity == "luminance";
  const auto values = is_luminance ? luminance_values(radiance) : illuminance_values(radiance);
  if (ending_of(output) != ".png") {
    Image image(radiance.width, radiance.height);
    for (std::size_t i = 0; i < values.size(); ++i) image.pixels[i] = Vec3(static_cast<float>(values[i]));
    return ending_of(output) == ".exr" ? write_exr(output, image) : write_hdr(output, image);
  }
  auto scale = automatic_scale(values, is_luminance ? "cd/m2" : "lx");
  if (settings.max_value > 0.0) scale.high = settings.max_value;
  write_png(output, false_colours(values, radiance.width, radiance.height, scale));
}

}  // namespace

void write_picture(const std::string& output, const Picture& picture, const ToneOptions& tone) {
  if (ending_of(output) == ".exr") return write_exr(output, picture.radiance);
  if (ending_of(output) == ".hdr") return write_hdr(output, picture.radiance);
  write_png(output, tone_map(picture.radiance, tone, picture.edges, picture.sky));
}

void check_before_work(const RunSettings& run, const PictureSettings& picture, const std::string& kinds,
                       const std::vector<NamedOutput>& others) {
  if (run.outputs.empty() && others.empty())
    throw UsageError("nothing to write: give at least one -o FILE with one of the extensions " + kinds);
  Places places;
  for (const auto& output : run.outputs) {
    expect_ending("-o", output, kinds);
    if (const auto why = page_is_missing(); is_page(output) && !why.empty())
      throw DeviceError(fmt::format("-o {}: {}", output, why), output);
    places.add("-o", output);
  }
  if (!run.report.empty()) places.add("--json-file", run.report);
  for (const auto& [option, file] : others) places.add(option, file);
  picture.check();
}

namespace {

class OutputWriter {
 public:
  OutputWriter(const Baked& baked, const Tracer* tracer, const OutputSettings& settings,
               const RunPlace& place, const StoredSamples& samples)
      : baked_(baked), tracer_(tracer), settings_(settings), place_(place), samples_(samples) {}

  Written write_all() {
    std::exception_ptr failure;
    for (const auto& output : in_order()) {
      if (!is_solution(output)) place_.reporter.light_is_safe();
      if (is_interrupted_here()) {
        skip(output, "another file was being written");
        continue;
      }
      if (is_second_over()) {
        skip(output, "the light is kept, from which the rest can be made");
        continue;
      }
      try {
        write(output);
      } catch (const DeviceError& error) {
        if (failure)
          place_.reporter.log()({Severity::error, error.what()});
        else
          failure = std::current_exception();
      }
    }
    if (failure) std::rethrow_exception(failure);
    return std::move(written_);
  }

 private:
  // The solution first, since it may have taken hours; pictures last, since they take a while.
  std::vector<std::string> in_order() const {
    auto outputs = settings_.run.outputs;
    const auto turn = [](const std::string& o) { return is_picture(o) ? 2 : is_solution(o) ? 0 : 1; };
    std::stable_sort(outputs.begin(), outputs.end(), [&](auto& a, auto& b) { return turn(a) < turn(b); });
    return outputs;
  }

  void write(const std::string& output) {
    prepare(output);
    place_.reporter.clear_bar();
    if (is_picture(output) && written_.stopped) return skip(output, "the picture was not finished");
    if (is_interrupted_here()) return skip(output, "it was being prepared");
    const auto stage = "write " + ending_of(output).substr(1);
    place_.reporter.announce(stage);
    const bool is_written = place_.record.stage(stage, [&](auto&) { return write_by_kind(output); });
    place_.reporter.clear_bar();
    if (!is_written) return skip(output, "pages of light were not finished");
    written_.files.push_back(output);
    place_.reporter.wrote(output);
  }

  // After an interrupt of the solve, outputs are written all the same.
  bool is_interrupted_here() const { return !was_interrupted_ && place_.reporter.is_interrupted(); }

  // After an interrupt of the solve, the other outputs have a second, where one file has the light.
  bool is_second_over() {
    const bool is_kept = settings_.light_is_kept || has_solution_;
    return was_interrupted_ && is_kept && place_.reporter.is_second_over();
  }

  void skip(const std::string& output, const std::string& why) {
    written_.stopped = true;
    warn(place_.reporter.log(), fmt::format("stopped: {}, and {} is not written", why, output));
  }

  // Returns false where Ctrl-C came too early.
  bool write_by_kind(const std::string& output) {
    struct Kind {
      bool (*is_of)(const std::string& output);
      bool (OutputWriter::*write)(const std::string& output);
    };
    static constexpr Kind kinds[] = {
        {is_picture, &OutputWriter::write_as_picture}, {is_page, &OutputWriter::write_as_page},
        {is_glb, &OutputWriter::write_as_glb},         {is_solution_file, &OutputWriter::write_as_solution},
        {is_any, &OutputWriter::write_as_ply},
    };
    const auto kind =
        std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& k) { return k.is_of(output); });
    return (this->*kind->write)(output);
  }
  static bool is_glb(const std::string& output) { return ending_of(output) == ".glb"; }
  static bool is_solution_file(const std::string& output) { return is_solution(output); }
  static bool is_any(const std::string&) { return true; }

  bool write_as_picture(const std::string& output) {
    if (settings_.picture.quantity != "radiance") {
      write_values(output, picture_->radiance, settings_.picture);
      return true;
    }
    write_picture(output, *picture_, settings_.look.tone);
    return true;
  }
  bool write_as_page(const std::string& output) {
    write_page(output, {baked_, *light_, samples_.for_pages, hidden(), *written_.camera}, settings_.look,
               *tracer_, place_.context);
    return true;
  }
  bool write_as_glb(const std::string& output) {
    const OutputSettings settings{settings_.run, exposed_look(), settings_.picture, settings_.mesh};
    const bool simplified =
        is_simplified(settings_.mesh.settings ? *settings_.mesh.settings : MeshSettings{});
    const auto done =
        write_lit_glb(output, {baked_, light_, simplified ? &hidden() : nullptr, tracer_}, settings, place_);
    if (done.pages) written_.pages = done.pages;
    written_.stopped |= !done.is_written || (done.pages && done.pages->made.texels.stopped);
    return done.is_written;
  }
  bool write_as_solution(const std::string& output) {
    write_solution(output, baked_.patches, baked_.solution, samples_.for_solutions);
    has_solution_ = true;
    return true;
  }
  bool write_as_ply(const std::string& output) {
    export_ply(output, baked_.patches, baked_.solution, *light_, {.tone = exposed_look().tone});
    return true;
  }

  // Makes the data that this output needs and no earlier output has made.
  void prepare(const std::string& output) {
    const auto& mesh = settings_.mesh.settings;
    const bool on_pages = is_glb(output) && mesh && mesh->on_pages();
    const bool is_gathered = is_picture(output) && settings_.picture.gather > 0;
    const bool has_tone = !is_solution(output) && !(on_pages && mesh->as == "lightmap");
    if (has_tone && !is_gathered) make_light();
    if (has_tone || (on_pages && needs_rays(*mesh))) make_tracer();
    if (has_tone) find_camera();
    if (is_picture(output)) draw();
    if (has_tone && !is_picture(output) && !is_page(output)) expose();
  }
  // Fits the tone curve of meshes to the view of the picture, so that both show the same.
  void expose() {
    if (exposed_look_) return;
    constexpr RenderOptions small{.width = 320, .height = 240, .samples_per_side = 1};
    const auto seen =
        render_picture(baked_.patches, *light_, *tracer_, *written_.camera, small, place_.context);
    exposed_look_ = settings_.look;
    auto& tone = exposed_look_->tone;
    auto plain = tone;
    plain.exposure = 0.0f;
    tone.scale = fit_curve(seen.radiance, seen.sky, plain).scale;
  }
  const LookSettings& exposed_look() const { return exposed_look_ ? *exposed_look_ : settings_.look; }
  void make_light() {
    if (light_) return;
    place_.reporter.announce("surface");
    light_ = place_.record.stage("surface", [&](auto&) {
      return make_smooth_light(baked_.patches, baked_.solution, settings_.look.smooth, place_.context);
    });
  }
  void make_tracer() {
    if (tracer_) return;
    place_.reporter.announce("hierarchy");
    own_tracer_ =
        place_.record.stage("hierarchy", [&](auto&) { return Tracer(baked_.patches, place_.context); });
    tracer_ = &*own_tracer_;
  }
  const FrontAndBack<std::uint8_t>& hidden() {
    if (!hidden_) hidden_ = hidden_sides(baked_.patches, baked_.solution, *tracer_, place_.context);
    return *hidden_;
  }
  void find_camera() {
    if (written_.camera) return;
    written_.camera = settings_.camera;
    if (!written_.camera)
      written_.camera = place_.record.stage("camera", [&](auto&) {
        return camera_of(settings_.picture, settings_.look, baked_, *tracer_, place_.context);
      });
    if (settings_.picture.is_given()) return;
    const auto& outputs = settings_.run.outputs;
    const bool is_seen = std::any_of(outputs.begin(), outputs.end(),
                                     [](const auto& o) { return is_picture(o) || is_page(o); });
    // A mesh only takes its exposure from it.
    is_seen ? place_.reporter.say("camera", flags_of(*written_.camera))
            : place_.reporter.detail("camera", flags_of(*written_.camera));
  }
  // As the command line takes it, in the coordinates of the file.
  std::string flags_of(const Camera& camera) const {
    const auto point = [&](const Vec3& p) {
      const auto at = Vec3d(p) + baked_.patches.origin;
      return fmt::format("{:.5g},{:.5g},{:.5g}", at.x, at.y, at.z);
    };
    return fmt::format("--eye {} --target {} --fov {:.4g}", point(camera.eye), point(camera.target),
                       camera.vertical_fov);
  }
  void draw() {
    if (picture_) return;
    picture_ = place_.record.stage("picture", [&](auto& stage) { return drawn(stage); });
    written_.stopped |= is_interrupted_here();
  }
  Picture drawn(RunRecord::Stage& stage) {
    const auto& picture = settings_.picture;
    const auto pixels =
        static_cast<std::uint64_t>(picture.render.width) * static_cast<std::uint64_t>(picture.render.height);
    const auto context = place_.reporter.reporting(place_.context, !was_interrupted_);
    if (picture.gather > 0) {
      const auto grid = std::uint64_t{gather_grid(picture.gather)};
      stage.rays = 3 * grid * grid * pixels;
      auto gathered = gather_picture(baked_.patches, baked_.solution, *tracer_, *written_.camera,
                                     {.width = picture.render.width,
                                      .height = picture.render.height,
                                      .rays = picture.gather,
                                      .seed = picture.render.seed},
                                     context);
      return with_sky(std::move(gathered), baked_.patches, *tracer_, *written_.camera, picture.render,
                      context);
    }
    const auto render_of = [&](const PatchSet& patches) {
      auto made = render_picture(patches, *light_, *tracer_, *written_.camera, picture.render, context);
      stage.rays = made.rays;
      return made;
    };
    if (picture.quantity == "illuminance") return render_of(white_patches(baked_.patches));
    return render_of(baked_.patches);
  }

  const Baked& baked_;
  const Tracer* tracer_;
  const OutputSettings& settings_;
  RunPlace place_;
  const StoredSamples& samples_;
  const bool was_interrupted_ = place_.reporter.is_interrupted();
  bool has_solution_ = false;  // among the files written
  std::optional<SmoothLight> light_;
  std::optional<Tracer> own_tracer_;
  std::optional<FrontAndBack<std::uint8_t>> hidden_;
  std::optional<Picture> picture_;
  std::optional<LookSettings> exposed_look_;  // tone curve fitted to the view
  Written written_;
};

}  // namespace

Written write_outputs(const Baked& baked, const Tracer* tracer, const OutputSettings& settings,
                      const RunPlace& place, const StoredSamples& samples) {
  return OutputWriter(baked, tracer, settings, place, samples).write_all();
}

}  // namespace luxel
