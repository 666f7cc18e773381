// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/solution_file.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"

#include "support/sample_solution.h"

namespace luxel {
namespace {

namespace fs = std::filesystem;

fs::path in_temp(const std::string& name) { return fs::path(testing::TempDir()) / name; }

void expect_same(const Baked& a, const Baked& b) {
  EXPECT_EQ(sample::difference(a.patches, b.patches), "");
  EXPECT_EQ(sample::difference(a.solution, b.solution), "");
}

fs::path write(const std::string& name, const Baked& baked) {
  const auto path = in_temp(name);
  write_solution(path, baked.patches, baked.solution);
  return path;
}

// The message of what the call throws, which must be an Expected.
template <typename Expected, typename Call>
std::string complaint(Call call) {
  try {
    call();
  } catch (const Expected& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

std::string refusal_to_write(const Baked& baked) {
  const auto path = in_temp("refused.vtkhdf");
  fs::remove(path);
  auto message = complaint<MismatchError>([&] { write_solution(path, baked.patches, baked.solution); });
  EXPECT_FALSE(fs::exists(path));
  return message;
}

TEST(SolutionFile, what_was_written_is_read_to_the_bit) {
  for (const std::size_t bands : {1, 3, 7}) {
    SCOPED_TRACE(bands);
    const auto sample = sample::baked(4, bands);
    expect_same(read_solution(write("small.vtkhdf", sample)), sample);
  }
}

TEST(SolutionFile, arrays_of_several_compressed_chunks_are_read_to_the_bit) {
  for (const std::size_t bands : {1, 3}) {
    SCOPED_TRACE(bands);
    const auto sample = sample::baked(150'000, bands);
    expect_same(read_solution(write("large.vtkhdf", sample)), sample);
  }
}

Baked with_panes() {
  auto sample = sample::baked(4, 3);
  auto& patches = sample.patches;
  patches.materials.push_back({"glass", true, {0.1f, 0.1f, 0.1f}, {0.0f, 0.0f, 0.0f}});
  patches.materials.back().transmittance = {0.5f, 0.8f, 1.0f};
  patches.panes = {{{{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}}, {0, 1, 0}, MaterialId{2}, 1.0f},
                   {{{{0, 0, 0}, {1, 0, 1}, {0, 0, 1}}}, {0, -1, 0}, MaterialId{2}, 0.5f}};
  return sample;
}

TEST(SolutionFile, panes_of_glass_are_read_to_the_bit) {
  const auto sample = with_panes();
  expect_same(read_solution(write("panes.vtkhdf", sample)), sample);
}

TEST(SolutionFile, diffusers_are_read_to_the_bit) {
  auto sample = sample::baked(4, 3);
  sample.patches.materials.push_back({"blind", true, {0.1f, 0.2f, 0.3f}, {0.0f, 0.0f, 0.0f}});
  sample.patches.materials.back().diffuse_transmittance = {0.5f, 0.0f, 0.25f};
  expect_same(read_solution(write("diffusers.vtkhdf", sample)), sample);
  EXPECT_TRUE(sample.patches.has_diffusers());
}

TEST(SolutionFile, cameras_focus_and_seen_error_are_read_to_the_bit) {
  auto sample = sample::baked(6, 3);
  auto& patches = sample.patches;
  patches.cameras = {
      {.eye = {1, 2, 3}, .target = {0.5f, 0, 1}, .up = {0, 0, 1}, .vertical_fov = 35.0f, .aspect = 1.5f},
      {.eye = {-1, 2, 3}}};
  patches.focuses_on_cameras = true;
  patches.focus = {1, 0, 0, 1, 1, 0};
  sample.solution.seen_error = 0.0125;
  const auto read = read_solution(write("focus.vtkhdf", sample));
  ASSERT_EQ(read.patches.cameras.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.patches.cameras[i].eye, patches.cameras[i].eye);
    EXPECT_EQ(read.patches.cameras[i].target, patches.cameras[i].target);
    EXPECT_EQ(read.patches.cameras[i].up, patches.cameras[i].up);
    EXPECT_EQ(read.patches.cameras[i].vertical_fov, patches.cameras[i].vertical_fov);
    EXPECT_EQ(read.patches.cameras[i].aspect, patches.cameras[i].aspect);
  }
  EXPECT_TRUE(read.patches.focuses_on_cameras);
  EXPECT_EQ(read.patches.focus, patches.focus);
  EXPECT_EQ(read.solution.seen_error, 0.0125);
}

TEST(SolutionFile, standard_errors_are_read_to_the_bit) {
  for (const std::size_t bands : {1, 3, 7}) {
    SCOPED_TRACE(bands);
    const auto sample = sample::baked_with_errors(700, bands);
    expect_same(read_solution(write("errors.vtkhdf", sample)), sample);
  }
}

TEST(SolutionFile, the_sky_is_kept) {
  for (const std::size_t bands : {1, 3}) {
    auto sample = sample::baked(2, bands);
    sample.patches.sky = sample::numbers(bands, 0.5f);
    expect_same(read_solution(write("sky.vtkhdf", sample)), sample);
  }
}

TEST(SolutionFile, a_scene_far_from_zero_keeps_its_place) {
  for (const std::size_t count : {4, 20'000}) {
    const auto sample = sample::baked_far_away(count, 3);
    const auto path = write("far.vtkhdf", sample);
    expect_same(read_solution(path), sample);
  }
}

TEST(SolutionFile, contacts_are_kept) {
  auto sample = sample::baked(2, 3);
  sample.patches.contacts = {{{0, 1}, {0, 0, 1}}, {{0, 1}, {0, 0, -1}}, {{1, 3}, {0.6f, 0.8f, 0}}};
  expect_same(read_solution(write("contacts.vtkhdf", sample)), sample);
}

TEST(SolutionFile, every_stop_reason_is_kept) {
  auto sample = sample::baked(2, 3);
  for (const auto stop : {StopReason::converged, StopReason::error_reached, StopReason::ray_limit,
                          StopReason::time_limit, StopReason::stopped_by_user, StopReason::nothing_to_do}) {
    sample.solution.stop = stop;
    EXPECT_EQ(read_solution(write("stop.vtkhdf", sample)).solution.stop, stop);
  }
}

TEST(SolutionFile, no_patches_no_options_and_empty_words_are_a_solution_too) {
  auto sample = sample::baked(0, 3);
  sample.patches.vertices.clear();
  sample.patches.materials.clear();
  sample.solution.provenance = {};
  sample.solution.provenance.scene_fingerprint = sample.patches.scene_fingerprint;
  expect_same(read_solution(write("empty.vtkhdf", sample)), sample);
}

TEST(SolutionFile, a_command_line_of_a_megabyte_is_kept) {
  auto sample = sample::baked(2, 3);
  for (int i = 0; i < 100'000; ++i) sample.solution.provenance.command_line += " word" + std::to_string(i);
  expect_same(read_solution(write("long.vtkhdf", sample)), sample);
}

TEST(SolutionFile, thousands_of_materials_are_kept) {
  auto sample = sample::baked(2, 3);
  for (int i = 0; i < 5000; ++i) {
    sample.patches.materials.push_back(sample.patches.materials[0]);
    sample.patches.materials.back().name = std::string(static_cast<std::size_t>(i % 90), 'm');
  }
  expect_same(read_solution(write("materials.vtkhdf", sample)), sample);
}

TEST(SolutionFile, a_zero_byte_in_a_name_becomes_a_question_mark) {
  auto sample = sample::baked(2, 3);
  sample.patches.materials[0].name = std::string("a\0b", 3);
  EXPECT_EQ(read_solution(write("zero.vtkhdf", sample)).patches.materials[0].name, "a?b");
}

TEST(SolutionFile, the_same_solution_gives_the_same_bytes) {
  for (const std::size_t count : {4, 20'000}) {
    const auto sample = sample::baked(count, 3);
    const auto first = read_file(write("first.vtkhdf", sample));
    EXPECT_TRUE(first == read_file(write("second.vtkhdf", sample)));
    EXPECT_TRUE(first == read_file(write("third.vtkhdf", read_solution(in_temp("first.vtkhdf")))));
  }
}

TEST(SolutionFile, a_file_of_version_1_still_loads) {
  expect_same(read_solution(LUXEL_SOURCE_DIR "/tests/golden/solution-v1.vtkhdf"), sample::baked(4, 3));
}

TEST(SolutionFile, a_full_disk_is_said) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full here";
  const auto sample = sample::baked(4, 3);
  const auto message =
      complaint<DeviceError>([&] { write_solution("/dev/full", sample.patches, sample.solution); });
  EXPECT_NE(message.find("No space left on device"), std::string::npos) << message;
}

TEST(SolutionFile, a_folder_that_does_not_exist_is_named) {
  const auto sample = sample::baked(4, 3);
  const auto message = complaint<DeviceError>(
      [&] { write_solution(in_temp("no-such-folder/a.vtkhdf"), sample.patches, sample.solution); });
  EXPECT_NE(message.find("no-such-folder"), std::string::npos) << message;
}

TEST(SolutionFile, a_refused_write_leaves_the_old_file) {
  auto sample = sample::baked(4, 3);
  const auto path = write("old.vtkhdf", sample);
  const auto before = read_file(path);
  sample.solution.radiosity.front[0] = std::nanf("");
  EXPECT_THROW(write_solution(path, sample.patches, sample.solution), MismatchError);
  EXPECT_TRUE(read_file(path) == before);
}

TEST(SolutionFile, a_missing_file_is_an_input_error) {
  const auto message = complaint<InputError>([] { read_solution("no-such-file.vtkhdf"); });
  EXPECT_EQ(message, "no-such-file.vtkhdf: there is no such file");
  EXPECT_THROW(read_solution(testing::TempDir()), InputError);
}

TEST(SolutionFile, light_of_other_bands_or_another_scene_is_not_written) {
  auto sample = sample::baked(4, 3);
  sample.solution.bands[1] = "infrared";
  EXPECT_NE(refusal_to_write(sample).find("infrared"), std::string::npos);
  sample = sample::baked(4, 3);
  sample.solution.provenance.scene_fingerprint = 1;
  EXPECT_NE(refusal_to_write(sample).find("fedcba9876543210"), std::string::npos);
}

TEST(SolutionFile, what_could_not_be_read_back_is_not_written) {
  const auto with = [](auto change) {
    auto sample = sample::baked(4, 3);
    change(sample.patches, sample.solution);
    return refusal_to_write(sample);
  };
  const auto infinity = std::numeric_limits<float>::infinity();
  EXPECT_NE(with([](auto& p, auto&) { p.corners[2][1] = 6; }).find("patch 2 names vertex 6 of 6"),
            std::string::npos);
  EXPECT_NE(with([](auto& p, auto&) { p.material[3] = MaterialId{2}; }).find("patch 3 names material 2 of 2"),
            std::string::npos);
  EXPECT_NE(with([](auto& p, auto&) { p.area[1] = 0.0f; }).find("patch 1 has the area 0"), std::string::npos);
  EXPECT_NE(with([](auto& p, auto&) { p.normal[1] *= 2.0f; }).find("patch 1 has a normal"),
            std::string::npos);
  EXPECT_NE(with([](auto& p, auto&) { p.triangle[3] = 0; }).find("patch 3 is not in the order"),
            std::string::npos);
  EXPECT_NE(with([&](auto& p, auto&) { p.vertices[5].z = infinity; }).find("vertex 5 is not finite"),
            std::string::npos);
  EXPECT_NE(with([&](auto& p, auto&) { p.origin.y = infinity; }).find("the origin is not finite"),
            std::string::npos);
  EXPECT_NE(with([](auto& p, auto&) { p.area.pop_back(); }).find("arrays of 4 patches"), std::string::npos);
  EXPECT_NE(with([](auto& p, auto&) { p.materials[0].reflectance[0] = 1.0f; }).find("reflectance 1"),
            std::string::npos);
  EXPECT_NE(with([&](auto& p, auto&) {
              p.sky = {1.0f, infinity, 1.0f};
            }).find("the sky has the radiance inf"),
            std::string::npos);
  EXPECT_NE(with([](auto& p, auto&) { p.sky = {1.0f}; }).find("the sky does not have one number"),
            std::string::npos);
  const auto with_contacts = [&](std::vector<Contact> contacts) {
    return with([&](auto& p, auto&) { p.contacts = contacts; });
  };
  EXPECT_NE(with_contacts({{{1, 6}, {0, 0, 1}}}).find("contact 0 is at an edge from vertex 1 to 6 of 6"),
            std::string::npos);
  EXPECT_NE(with_contacts({{{1, 2}, {0, 0, 2}}}).find("contact 0 has a direction"), std::string::npos);
  EXPECT_NE(with_contacts({{{1, 2}, {0, 0, 1}}, {{0, 2}, {0, 0, 1}}}).find("contact 1 is not in the order"),
            std::string::npos);
  EXPECT_NE(with([](auto&, auto& s) { s.irradiance.back.pop_back(); }).find("holds 11 numbers, expected 12"),
            std::string::npos);
  EXPECT_NE(with([&](auto&, auto& s) { s.irradiance.front[3] = -infinity; }).find("not finite"),
            std::string::npos);
}

TEST(SolutionFile, standard_errors_that_cannot_be_are_not_written) {
  const auto with = [](auto change) {
    auto sample = sample::baked_with_errors(4, 3);
    change(sample.solution);
    return refusal_to_write(sample);
  };
  const auto infinity = std::numeric_limits<float>::infinity();
  EXPECT_NE(with([](auto& s) { s.standard_error.front[5] = -1.0f; }).find("standard_error_front"),
            std::string::npos);
  EXPECT_NE(with([&](auto& s) { s.standard_error.back[0] = infinity; }).find("standard_error_back"),
            std::string::npos);
  EXPECT_NE(with([](auto& s) { s.standard_error.back.clear(); }).find("holds 0 numbers, expected 12"),
            std::string::npos);
  EXPECT_NE(with([](auto& s) { s.standard_error.front.pop_back(); }).find("holds 11 numbers, expected 12"),
            std::string::npos);
  EXPECT_NE(with([](auto& s) { s.error_95th = -0.1; }).find("error_95th is -0.1"), std::string::npos);
}

}  // namespace
}  // namespace luxel
