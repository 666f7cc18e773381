// SPDX-License-Identifier: Apache-2.0
// A scene far from its file's zero: all input and output is in the file's coordinates, and the light is
// bitwise that of the same scene at zero.
#include <cstring>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "luxel/form_factors/view_factors_file.h"
#include "luxel/solution/solution_file.h"

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

using Json = nlohmann::json;

const Vec3d place(100'000.0, -1'000'000.0, 800.0);

// A room of 4 m by 4 m by 2.5 m with z up, its middle at `origin`, and a lamp.
void write_room(const std::filesystem::path& file, const Vec3d& origin) {
  std::string text = "mtllib room.mtl\nusemtl grey\n";
  const auto vertex = [&](double x, double y, double z) {
    text += fmt::format("v {:.6f} {:.6f} {:.6f}\n", origin.x + x, origin.y + y, origin.z + z);
  };
  for (const double z : {-1.25, 1.25})
    for (const double y : {-2.0, 2.0})
      for (const double x : {-2.0, 2.0}) vertex(x, y, z);
  for (const double y : {0.5, -0.5})
    for (const double x : {-0.5, 0.5}) vertex(x, y, 1.0);
  text += "f 1 2 4 3\nf 5 7 8 6\nf 1 3 7 5\nf 2 6 8 4\nf 1 5 6 2\nf 3 4 8 7\nusemtl lamp\nf 9 10 12 11\n";
  std::ofstream(file) << text;
}

// The same room as near.obj and as far.obj.
class Far : public testing::Test {
 protected:
  Far() : folder_(fresh_folder("far")) {
    std::ofstream(folder_ / "room.mtl") << "newmtl grey\nKd 0.5 0.5 0.5\nnewmtl lamp\nKd 0 0 0\nKe 10 9 8\n";
    write_room(folder_ / "near.obj", Vec3d(0.0));
    write_room(folder_ / "far.obj", place);
  }
  std::string run(const std::string& line) {
    const auto outcome = cli::run(folder_, line);
    EXPECT_EQ(outcome.code, 0) << line << "\n" << outcome.err;
    return outcome.out;
  }
  std::string bytes(const char* name) const { return read_file(folder_ / name); }

  std::filesystem::path folder_;
};

std::string at(const Vec3d& origin, const Vec3d& p) {
  return fmt::format("{:.6f},{:.6f},{:.6f}", origin.x + p.x, origin.y + p.y, origin.z + p.z);
}
std::string view(const Vec3d& origin) {
  return " --up z --width 48 --height 32 --eye " + at(origin, {1.5, -1.5, 0.25}) + " --target " +
         at(origin, {-1.0, 1.0, -0.5});
}
const std::string far_options = " --max-edge 0.5 --error 5% --quiet ";

// The k-th of the numbers that a PLY's body begins with.
template <typename T>
T number(const std::string& ply, std::size_t byte) {
  T value{};
  std::memcpy(&value, ply.data() + ply.find("end_header\n") + 11 + byte, sizeof(T));
  return value;
}

TEST_F(Far, pictures_are_the_same_and_cameras_stand_where_they_were_put) {
  run("$LUXEL bake near.obj -o near.png" + far_options + view(Vec3d(0.0)));
  const auto json = Json::parse(run("$LUXEL bake far.obj -o far.png --json" + far_options + view(place)));
  EXPECT_EQ(bytes("near.png"), bytes("far.png"));
  EXPECT_EQ(json["camera"]["eye"], (Json{100'001.5, -1'000'001.5, 800.25}));
  EXPECT_EQ(json["camera"]["target"], (Json{99'999.0, -999'999.0, 799.5}));
  const auto traced = Json::parse(
      run("$LUXEL reference far.obj -o traced.exr --samples 16 --json --quiet --max-edge 0.5" + view(place)));
  run("$LUXEL reference near.obj -o traced-near.exr --samples 16 --quiet --max-edge 0.5" + view(Vec3d(0.0)));
  EXPECT_EQ(traced["camera"], json["camera"]);
  EXPECT_EQ(bytes("traced.exr"), bytes("traced-near.exr"));
}

TEST_F(Far, meshes_lie_where_the_file_has_them) {
  run("$LUXEL bake near.obj -o near.ply -o near.glb --up z" + far_options);
  run("$LUXEL bake far.obj -o far.ply -o far.glb --up z" + far_options);
  const auto near = bytes("near.ply"), far = bytes("far.ply");
  EXPECT_NE(far.find("property double x\nproperty double y\nproperty double z\nproperty float nx\n"),
            std::string::npos);
  EXPECT_NE(near.find("property float x\n"), std::string::npos);
  constexpr std::size_t near_row = 6 * 4 + 3 + 3 * 4, far_row = near_row + 3 * 4;
  for (std::size_t row = 0; row < 50; ++row)
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      EXPECT_EQ(number<double>(far, row * far_row + 8 * axis),
                place[k] + static_cast<double>(number<float>(near, row * near_row + 4 * axis)));
    }
  const auto glb = bytes("far.glb");
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, sizeof(length));
  const auto json = Json::parse(glb.substr(20, length));
  const auto& translation = json["nodes"][0]["translation"];  // where z is up, turned with the scene
  EXPECT_NEAR(translation[0].get<double>(), place.x, 1e-9);
  EXPECT_NEAR(translation[1].get<double>(), place.z, 1e-9);
  EXPECT_NEAR(translation[2].get<double>(), -place.y, 1e-9);
  for (const auto& low : json["nodes"][1]["translation"]) {  // of the grid of positions
    EXPECT_GE(low.get<double>(), -2.001);
    EXPECT_LE(low.get<double>(), 2.0);
  }
}

TEST_F(Far, solutions_hold_the_coordinates_of_the_file) {
  run("$LUXEL bake near.obj -o near.vtkhdf" + far_options);
  run("$LUXEL bake far.obj -o far.vtkhdf" + far_options);
  run("$LUXEL bake far.obj -o other.vtkhdf --seed 2" + far_options);
  const auto near = read_solution(folder_ / "near.vtkhdf"), far = read_solution(folder_ / "far.vtkhdf");
  EXPECT_EQ(near.patches.origin, Vec3d(0.0));
  EXPECT_EQ(far.patches.origin, place);
  EXPECT_EQ(near.patches.vertices, far.patches.vertices);
  EXPECT_EQ(near.solution.irradiance.front, far.solution.irradiance.front);
  EXPECT_NE(near.patches.scene_fingerprint, far.patches.scene_fingerprint);
  run("$LUXEL export far.vtkhdf -o copy.vtkhdf --quiet");
  EXPECT_EQ(bytes("far.vtkhdf"), bytes("copy.vtkhdf"));

  const auto difference = Json::parse(run("$LUXEL compare far.vtkhdf other.vtkhdf --json --quiet"));
  for (const auto& one : difference["largest"])
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(one["side"]["position_m"][static_cast<std::size_t>(k)].get<double>(), place[k], 2.0);
  EXPECT_NE(cli::run(folder_, "$LUXEL compare near.vtkhdf far.vtkhdf").code, 0) << "they are not one mesh";
}

TEST_F(Far, scenes_and_view_factors_are_told_in_the_coordinates_of_the_file) {
  EXPECT_NE(run("$LUXEL info far.obj").find("from (99998, -1000002, 798.75) to (100002, -999998, 801.25) m"),
            std::string::npos);
  EXPECT_EQ(Json::parse(run("$LUXEL info far.obj --json"))["low_m"], (Json{99'998.0, -1'000'002.0, 798.75}));
  run("$LUXEL viewfactors far.obj --between patches --max-edge 0 --error 0.05 -o far.h5 --quiet");
  run("$LUXEL viewfactors near.obj --between patches --max-edge 0 --error 0.05 -o near.h5 --quiet");
  const auto near = read_view_factors_hdf5(folder_ / "near.h5");
  const auto far = read_view_factors_hdf5(folder_ / "far.h5");
  EXPECT_EQ(far.note.origin, place);
  EXPECT_EQ(far.note.centre, near.note.centre);
  EXPECT_EQ(far.factors.factor, near.factors.factor);
}

}  // namespace
}  // namespace luxel::cli
