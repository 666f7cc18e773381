// SPDX-License-Identifier: Apache-2.0
// Stand-ins for luxel-import that fail in each way, and damaged files for the program itself.
#include "luxel/import/converter.h"

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "luxel/core/error.h"

#include "support/converted_files.h"
#include "support/scene_files.h"

namespace luxel {
namespace {

const std::string advice = "convert it to glTF (.glb), for example with Blender";

class Converter : public testing::Test {
 protected:
  Converter() { files_.write("room.fbx", "anything"); }

  std::string convert(const std::string& script, const ProcessLimits& limits = {.wall_seconds = 60.0}) {
    files_.write("luxel-import", "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(files_.path("luxel-import"), std::filesystem::perms::owner_all);
    const auto log = [this](const Message& message) { messages_ += message.text + "\n"; };
    const auto path = files_.path("room.fbx");
    return *converted_file(path, files_.path("luxel-import"), limits, Context().with_log(log));
  }
  std::string refusal(const std::string& script, const ProcessLimits& limits = {.wall_seconds = 60.0}) {
    try {
      convert(script, limits);
    } catch (const InputError& error) {
      const std::string text = error.what(), folder = files_.path("").string();
      EXPECT_TRUE(text.starts_with(folder + "room.fbx: ")) << text;
      return text.substr(folder.size() + std::string("room.fbx: ").size());
    }
    return "converted without complaint";
  }

  SceneFiles files_;
  std::string messages_;
};

TEST_F(Converter, messages_are_logged_with_the_name_of_the_file_and_the_rest_is_the_glb) {
  EXPECT_EQ(convert("echo 'note it is small'; echo 'warning it is grey'; echo; printf 'glTF and more'"),
            "glTF and more");
  const auto file = files_.path("room.fbx").string();
  EXPECT_EQ(messages_, file + ": it is small\n" + file + ": it is grey\n");
}

TEST_F(Converter, receives_the_file_as_its_only_argument) {
  EXPECT_EQ(convert("printf '\\nglTF %s %s' $# \"$1\""), "glTF 1 " + files_.path("room.fbx").string());
}

TEST_F(Converter, each_failure_is_one_sentence) {
  EXPECT_EQ(refusal("echo 'error the header is cut off.'; exit 1"),
            "Assimp cannot read this file: the header is cut off; export it again, or " + advice);
  EXPECT_EQ(refusal("exit 1"),
            "Assimp cannot read this file: it gives no reason; export it again, or " + advice);
  EXPECT_EQ(
      refusal("kill -ABRT $$"),
      "the converter luxel-import crashed on this file (signal 6, Aborted), which is probably damaged; " +
          advice);
  EXPECT_EQ(refusal("exit 42"),
            "the converter luxel-import failed on this file (exit status 42), which is probably damaged; " +
                advice);
  EXPECT_EQ(
      refusal("exit 3", {.memory = std::uint64_t{3'000'000'000}}),
      "reading this file takes more than the 3.0 GB of memory that the converter luxel-import may use; it is "
      "damaged or too large; " +
          advice);
  EXPECT_EQ(refusal("sleep 100", {.cpu_seconds = 5, .wall_seconds = 0.5}),
            "the converter luxel-import did not finish this file within 5 s of processor time or 0.5 s in "
            "all; it is "
            "probably damaged; " +
                advice);
  EXPECT_EQ(
      refusal("exit 127"),
      "the converter luxel-import does not start; install its library (Debian: libassimp5), or " + advice);
  EXPECT_EQ(refusal("head -c 2000000 /dev/zero"),
            "a converted scene has at most 4 GiB, and this one is larger; divide it, or " + advice);
  for (const std::string script :
       {"exit 0", "echo nonsense", "echo; echo nonsense", "printf glTF", "printf 'note a'"})
    EXPECT_EQ(refusal(script),
              "expected a GLB from the converter luxel-import, found something else; " + advice);
}

TEST_F(Converter, a_missing_one_is_named_with_what_to_install) {
  try {
    converted_file(files_.path("room.fbx"), std::nullopt, {}, {});
    ADD_FAILURE() << "converted without complaint";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(),
              files_.path("room.fbx").string() +
                  ": this format is read by the program luxel-import, which is not installed; build Luxel "
                  "with Assimp (Debian: libassimp-dev), or " +
                  advice);
  }
}

TEST_F(Converter, a_stop_ends_it) {
  files_.write("luxel-import", "#!/bin/sh\nsleep 100\n");
  std::filesystem::permissions(files_.path("luxel-import"), std::filesystem::perms::owner_all);
  const auto context = Context().with_monitor([](const Progress&) { return Next::stop; });
  EXPECT_FALSE(converted_file(files_.path("room.fbx"), files_.path("luxel-import"), {}, context).has_value());
}

TEST_F(Converter, limits_grow_with_the_file) {
  const auto small = converter_limits(1000), large = converter_limits(100'000'000);
  EXPECT_EQ(small.cpu_seconds, 60u);
  EXPECT_EQ(large.cpu_seconds, 160u);
  EXPECT_GT(large.memory, small.memory + 3'000'000'000u);
}

// The reader's own processes: cut off, overwritten and foreign files become a scene or one sentence.
class DamagedConverted : public testing::Test {
 protected:
  void SetUp() override {
    if (!find_converter()) GTEST_SKIP() << "luxel-import was not built";
  }
  void expect_answer(const std::string& name, const std::string& bytes, const std::string& what) {
    files_.write(name, bytes);
    try {
      files_.load(name);
    } catch (const InputError& error) {
      const std::string text = error.what();
      EXPECT_TRUE(text.starts_with(files_.path(name).string() + ": ")) << what << ": " << text;
      EXPECT_EQ(text.find('\n'), text.npos) << what << ": " << text;
      ++refused_;
    }
  }
  void damage(const std::string& name, const std::string& good) {
    constexpr std::size_t cuts = 24;
    for (std::size_t i = 0; i < cuts; ++i) {
      const auto at = i * good.size() / cuts;
      expect_answer(name, good.substr(0, at), fmt::format("{} cut at {}", name, at));
      auto changed = good;
      for (std::size_t k = 0; k < 4; ++k)
        changed[(at + 7 * k) % good.size()] = static_cast<char>(37 * i + 101 * k);
      expect_answer(name, changed, fmt::format("{} changed at {}", name, at));
    }
    EXPECT_GE(refused_, cuts / 2);
  }

  SceneFiles files_;
  std::size_t refused_ = 0;
};

TEST_F(DamagedConverted, collada_is_answered) { damage("room.dae", SmallDae().text()); }
TEST_F(DamagedConverted, fbx_is_answered) { damage("room.fbx", SmallFbx().text()); }
TEST_F(DamagedConverted, max_3ds_is_answered) { damage("room.3ds", Small3ds().file()); }

TEST_F(DamagedConverted, other_contents_are_refused) {
  const std::string ply = SmallCube().ply_text(), obj = SmallCube().obj();
  for (const std::string name : {"room.fbx", "room.dae", "room.3ds"})
    for (const auto& bytes : {std::string(), std::string("\0\1\2", 3), ply, obj, std::string(100000, 'x')})
      expect_answer(name, bytes, name);
  EXPECT_EQ(refused_, 15u);
  EXPECT_NE(files_.refusal("room.fbx").find("Assimp cannot read this file: "), std::string::npos);
}

TEST_F(DamagedConverted, a_file_without_triangles_is_refused) {
  SmallDae dae;
  dae.instances = 0;
  files_.write("room.dae", dae.text());
  EXPECT_EQ(files_.refusal("room.dae"), "room.dae: no triangles found in the 1 node of its scene");
}

}  // namespace
}  // namespace luxel
