// SPDX-License-Identifier: Apache-2.0
// End-to-end tests of the program.
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

using Json = nlohmann::json;
const std::string quick =
    "$LUXEL bake cornell-box.obj --method shooting --rays 100k --max-edge 0.1 --width 64 --height 48 "
    "--samples 1 ";

TEST(Program, bakes_every_kind_of_output_at_once_and_names_them_on_stdout) {
  const auto folder = fresh_folder("kinds");
  const auto run = cli::run(folder, quick + "-o a.glb -o a.ply -o a.png -o a.exr -o a.hdr -o a.vtkhdf");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "a.vtkhdf\na.glb\na.ply\na.png\na.exr\na.hdr\n");
  EXPECT_NE(run.err.find(" of memory"), std::string::npos) << run.err;
  for (const char* name : {"a.glb", "a.ply", "a.png", "a.exr", "a.hdr", "a.vtkhdf"})
    EXPECT_GT(std::filesystem::file_size(folder / name), 500u) << name;
}

TEST(Program, gives_the_same_bytes_from_the_solve_and_from_its_file) {
  const auto folder = fresh_folder("same");
  const auto run =
      cli::run(folder, quick +
                           "-o a.glb -o a.ply -o a.png -o a.vtkhdf --quiet &&"
                           " $LUXEL export a.vtkhdf -o b.glb -o b.ply -o b.vtkhdf --quiet &&"
                           " $LUXEL render a.vtkhdf -o b.png --width 64 --height 48 --samples 1 --quiet &&"
                           " cmp a.glb b.glb && cmp a.ply b.ply && cmp a.vtkhdf b.vtkhdf && cmp a.png b.png");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
}

TEST(Program, writes_the_same_bytes_on_one_two_and_seven_threads) {
  const auto folder = fresh_folder("threads");
  for (const char* n : {"1", "2", "7"}) {
    const std::string t(n);
    const auto run = cli::run(
        folder, quick + "--quiet --threads " + t + " -o " + t + ".glb -o " + t + ".png -o " + t + ".vtkhdf");
    ASSERT_EQ(run.code, 0) << run.err;
    for (const char* ending : {".glb", ".png", ".vtkhdf"})
      EXPECT_EQ(read_file(folder / (t + ending)), read_file(folder / (std::string("1") + ending)))
          << t << ending;
  }
}

TEST(Program, reports_stages_power_and_options_as_json) {
  const auto folder = fresh_folder("json");
  const auto run = cli::run(folder, quick + "-o a.png --json --json-file r.json --seed 7");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = Json::parse(run.out);
  EXPECT_EQ(json["command"], "bake");
  EXPECT_EQ(json["solution"]["seed"], 7);
  EXPECT_EQ(json["solution"]["stop_reason"], "converged");
  EXPECT_LE(json["solution"]["unshot_fraction"].get<double>(), 1e-4);
  EXPECT_EQ(json["options"]["max-edge"], "0.1");
  EXPECT_GT(json["solve"]["error"]["reached"], 0.0);
  EXPECT_EQ(json["solve"]["error"]["stop_reason"], "converged");
  EXPECT_FALSE(json["solve"]["error"].contains("target")) << "shooting has none";
  EXPECT_EQ(json["outputs"], Json::array({"a.png"}));
  const auto& power = json["solve"]["power_W"];
  const auto sum = [&](const char* part) {
    return power[part][0].get<double>() + power[part][1].get<double>() + power[part][2].get<double>();
  };
  EXPECT_NEAR(sum("absorbed") + sum("escaped") + sum("lost_at_backs") + sum("unshot"), sum("emitted"), 1e-9);
  bool light_is_a_stage = false;
  for (const auto& stage : json["stages"])
    light_is_a_stage |= stage["name"] == "light" && stage["rays"] > 100'000;
  EXPECT_TRUE(light_is_a_stage);
  EXPECT_EQ(Json::parse(read_file(folder / "r.json"))["solution"], json["solution"]);
}

TEST(Program, reads_a_text_file_of_options_and_says_where_each_value_came_from) {
  const auto folder = fresh_folder("config");
  write_file(folder / "luxel.toml",
             "seed = 5\nmax-edge = \"0.25\"\noutput = [\"a.glb\", \"a.ply\"]\n[render]\nwidth = 99\n");
  const auto run =
      cli::run(folder, "$LUXEL bake cornell-box.obj --config luxel.toml --seed 6 --print-config");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("seed = \"6\"  # count; command line"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("max-edge = \"0.25\"  # m; file"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("width = \"1280\"  # pixels; default"), std::string::npos) << run.out;
  // Its output is such a file.
  write_file(folder / "printed.toml", run.out);
  const auto again = cli::run(folder, "$LUXEL bake cornell-box.obj --config printed.toml --print-config");
  EXPECT_NE(again.out.find("seed = \"6\"  # count; file"), std::string::npos) << again.out;
  EXPECT_NE(again.out.find("output = [\"a.glb\", \"a.ply\"]"), std::string::npos) << again.out;
}

// The values of --print-config, as they stand after the '='.
std::string value_of(const std::string& option, const std::string& printed) {
  const auto begin = printed.find("\n" + option + " = \"");
  if (begin == std::string::npos) return "nothing";
  const auto value = begin + option.size() + 5;
  return printed.substr(value, printed.find('"', value) - value);
}

TEST(Program, prints_quantities_in_a_form_that_it_reads_back_to_the_same_number) {
  const auto folder = fresh_folder("quantities");
  struct Case {
    const char *option, *given, *printed;
  };
  for (const auto& each :
       {Case{"error", "0.013", "1.3%"}, Case{"error", "7%", "7%"}, Case{"error", "0", "0"},
        Case{"time", "1.5min", "90s"}, Case{"time", "2h", "7200s"}, Case{"time", "30", "30s"},
        Case{"time", "none", "none"}, Case{"memory", "0.5GiB", "512MiB"}, Case{"memory", "1536MiB", "1.5GiB"},
        Case{"memory", "auto", "auto"}, Case{"rays", "2M", "2000000"}, Case{"rays", "auto", "auto"},
        Case{"mis", "on", "on"}}) {
    const auto print = [&](const std::string& value) {
      const auto line = fmt::format("$LUXEL bake cornell-box.obj --print-config --{} {}", each.option, value);
      return value_of(each.option, cli::run(folder, line).out);
    };
    EXPECT_EQ(print(each.given), each.printed) << each.option;
    EXPECT_EQ(print(each.printed), each.printed) << each.option;
  }
}

TEST(Program, a_file_may_hold_the_options_of_both_methods) {
  const auto folder = fresh_folder("both");
  const auto printed = cli::run(folder, "$LUXEL bake cornell-box.obj --print-config");
  write_file(folder / "all.toml", printed.out);
  write_file(folder / "more.toml", "error = \"2%\"\ntolerance = 0.01\n");
  for (const char* file : {"all.toml", "more.toml"}) {
    const auto run = cli::run(folder, quick + "--config " + file + " -o a.vtkhdf --quiet");
    EXPECT_EQ(run.code, 0) << run.err;
  }
  // Only options used by the method are recorded.
  const auto info = Json::parse(cli::run(folder, "$LUXEL info a.vtkhdf --json").out);
  const auto command = info["solution"]["command_line"].get<std::string>();
  EXPECT_NE(command.find("--tolerance 0.01"), std::string::npos) << command;
  EXPECT_EQ(command.find("--error"), std::string::npos) << command;
}

TEST(Program, knows_its_version_and_explains_itself) {
  const auto folder = fresh_folder("help");
  EXPECT_EQ(cli::run(folder, "$LUXEL --version").out.rfind("luxel ", 0), 0u);
  EXPECT_EQ(cli::run(folder, "$LUXEL -V").out, cli::run(folder, "$LUXEL --version").out);
  const auto commands = cli::run(folder, "$LUXEL");
  EXPECT_EQ(commands.code, 0);
  EXPECT_NE(commands.out.find("bake"), std::string::npos) << commands.out;
  EXPECT_EQ(cli::run(folder, "$LUXEL help").out, commands.out);
  EXPECT_EQ(cli::run(folder, "$LUXEL help bake").out, cli::run(folder, "$LUXEL bake --help").out);
  for (const char* command : {"bake", "render", "export", "info"}) {
    const auto help = cli::run(folder, std::string("$LUXEL ") + command + " --help");
    EXPECT_EQ(help.code, 0);
    EXPECT_NE(help.out.find(std::string("luxel ") + command), std::string::npos) << help.out;
  }
  EXPECT_NE(cli::run(folder, "$LUXEL bake --help").out.find("--max-edge <m> [auto]"), std::string::npos);
}

TEST(Program, describes_a_solution_and_a_scene) {
  const auto folder = fresh_folder("info");
  ASSERT_EQ(cli::run(folder, quick + "-o a.vtkhdf --quiet").code, 0);
  const auto solution = cli::run(folder, "$LUXEL info a.vtkhdf");
  EXPECT_NE(solution.out.find("luxel bake cornell-box.obj --max-edge 0.1 --method shooting --rays 100000"),
            std::string::npos)
      << solution.out;
  EXPECT_NE(solution.out.find("standard error"), std::string::npos);
  EXPECT_EQ(Json::parse(cli::run(folder, "$LUXEL info a.vtkhdf --json").out)["solution"]["method"],
            "stochastic-jacobi");
  const auto scene = Json::parse(cli::run(folder, "$LUXEL info cornell-box.obj --json").out);
  EXPECT_EQ(scene["triangles"], 32);
}

struct Misuse {
  const char* line;
  int code;
  const char* said;
};

class Refusal : public testing::TestWithParam<Misuse> {};

TEST_P(Refusal, is_one_sentence_and_an_exit_code) {
  const auto folder = fresh_folder("refusal");
  write_file(folder / "bad.toml", "\nrayz = 3\n");
  write_file(folder / "bad-value.toml", "rays = many\n");
  write_file(folder / "no-lamp.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write_file(folder / "bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  write_file(folder / "far.obj", "v 0 0 0\nv 1e18 0 0\nv 0 1e18 0\nf 1 2 3\n");
  write_file(folder / "binary.toml", std::string("\0\1\2", 3));
  write_file(folder / "nested.toml", "[bake.x]\nseed = 3\n");
  std::filesystem::create_directory(folder / "folder.glb");
  write_file(folder / "junk.vtkhdf", "this is no HDF5 file");
  const auto run = cli::run(folder, GetParam().line);
  EXPECT_EQ(run.code, GetParam().code) << run.err;
  EXPECT_NE(run.err.find(GetParam().said), std::string::npos) << run.err;
  EXPECT_EQ(run.out, "");
  const auto last = run.err.substr(run.err.rfind("luxel: "));
  EXPECT_EQ(std::count(last.begin(), last.end(), '\n'), 1) << "more than one line: " << last;
}

INSTANTIATE_TEST_SUITE_P(
    Program, Refusal,
    testing::Values(
        Misuse{"$LUXEL fly", 2, "'luxel help'"}, Misuse{"$LUXEL bake", 2, "SCENE"},
        Misuse{"$LUXEL render cornell-box.obj", 2, "-o"},
        Misuse{"$LUXEL bkae cornell-box.obj", 2, "there is no command 'bkae', did you mean 'bake'?"},
        Misuse{"$LUXEL bake cornell-box.obj --eror 5%", 2, "no option '--eror', did you mean '--error'?"},
        Misuse{"$LUXEL bake cornell-box.obj --frobnicate", 2,
               "no option '--frobnicate'; 'luxel bake --help-all'"},
        Misuse{"$LUXEL bake cornell-box.obj -error 5%", 2, "no option '-error', did you mean '--error'?"},
        Misuse{"$LUXEL bake cornell-box.obj --resolution 640x480", 2,
               "'--resolution', did you mean '--width'?"},
        Misuse{"$LUXEL bake cornell-box.obj --quali draft", 2, "'--quali', did you mean '--quality'?"},
        Misuse{"$LUXEL bake cornell-box.obj -x", 2, "no option '-x'"},
        Misuse{"$LUXEL bake cornell-box.obj --error", 2, "--error needs a value: <fraction>"},
        Misuse{"$LUXEL bake cornell-box.obj more.obj", 2, "'more.obj' is one word too many"},
        Misuse{"$LUXEL cornell-box.obj", 2, "such as 'luxel bake cornell-box.obj'"},
        Misuse{"$LUXEL --quiet bake cornell-box.obj", 2, "expected a command before '--quiet'"},
        Misuse{"$LUXEL bake missing.obj", 1, "missing.obj: no such file"},
        Misuse{"$LUXEL bake .", 1, "it is a folder"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.jpeg", 2, ".glb .ply .html .png"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb -o a.glb", 2, "twice"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --rays 5X", 2, "50M"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.png --as lightmap", 2, "--as lightmap applies to a .glb"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.ply --preserve-topology", 2,
               "--preserve-topology applies to a .glb"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.html --for godot", 2, "--for godot applies to a .glb"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.html --compress none", 2,
               "--compress none applies to a .glb"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --compress zip", 2,
               "none, quantize, meshopt, not 'zip'"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --compress meshopt --for godot", 2,
               "use --compress quantize"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --method shooting --tolerance 2", 2, "0.9"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --tolerance 0.1", 2, "--method shooting"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --method shooting --error 1%", 2, "--method sampled"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --method shooting --memory 1GiB", 2, "--method sampled"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --method fast", 2, "sampled|shooting"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --error 1", 2, "such as 1%"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --error 0", 2, "--rays or --time"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --time 3d", 2, "30s, 5min or 2h, or none"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --memory 4GB", 2, "4GiB, or auto"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --replicates 3", 2, "4 to 32"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --smoothing yes", 2, "on or off"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --max-edge -1", 2, "--max-edge"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.png --eye 1,2", 2, "three numbers"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.png --fov 200", 2, "--fov"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.png --eye 1,2,3 --target 1,2,3", 2, "same point"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.png -o ./a.png", 2, "twice"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.png --json-file nowhere/r.json", 1, "--json-file"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.png --json-file a.png", 2, "twice"},
        Misuse{"$LUXEL bake missing.obj -o folder.glb", 1, "folder.glb: it is a folder"},
        Misuse{"$LUXEL bake missing.obj -o a.png --eye 1e30,0,0", 2, "--eye"},
        Misuse{"$LUXEL bake far.obj -o a.glb", 1, "far.obj:2"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --config binary.toml", 1, "binary"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --config nested.toml", 1, "bake.x.seed"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --config /dev/zero", 1, "/dev/zero"},
        Misuse{"$LUXEL info cornell-box.obj > /dev/full", 1, "No space left"},
        Misuse{"$LUXEL --version >&-", 1, "standard output"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.png --tone sepia", 2, "reinhard"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --config none.toml", 1, "none.toml"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --config bad.toml", 1, "bad.toml:2"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --config bad-value.toml", 1, "bad-value.toml:1"},
        Misuse{"$LUXEL bake cornell-box.obj -o nowhere/a.glb", 1, "nowhere"},
        Misuse{"$LUXEL bake missing.obj -o a.glb", 1, "missing.obj"},
        Misuse{"$LUXEL bake bad.obj -o a.glb", 1, "bad.obj:4"},
        Misuse{"$LUXEL bake no-lamp.obj -o a.glb --sky none", 1, "no-lamp.obj: the scene has no lamp"},
        Misuse{"$LUXEL bake no-lamp.obj -o a.glb --sky 0", 1, "--sky 1"},
        Misuse{"$LUXEL bake no-lamp.obj -o a.glb --sky blue", 2, "--sky: expected auto, none, uniform"},
        Misuse{"$LUXEL bake no-lamp.obj -o a.glb --sky 1,-1,1", 2, "--sky: expected auto, none, uniform"},
        Misuse{"$LUXEL bake . -o a.glb", 1, "."},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --flip nothing", 1, "nothing"},
        Misuse{"$LUXEL bake cornell-box.obj -o a.glb --max-edge 0.000001", 1, "would fit"},
        Misuse{"$LUXEL render junk.vtkhdf -o a.png", 1, "junk.vtkhdf"},
        Misuse{"$LUXEL render cornell-box.obj -o a.png", 1, "cornell-box.obj"},
        Misuse{"$LUXEL export none.vtkhdf -o a.glb", 1, "none.vtkhdf"}));

TEST(Program, that_meets_a_full_disk_says_so_and_leaves_the_old_file) {
  const auto folder = fresh_folder("full");
  std::filesystem::create_symlink("/dev/full", folder / "full.glb");
  const auto run = cli::run(folder, quick + "-o full.glb -o a.png --quiet");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.err.find("No space left"), std::string::npos) << run.err;
  EXPECT_TRUE(std::filesystem::exists(folder / "a.png"))
      << "one file that cannot be written must not cost the others";
}

TEST(Program, with_no_ear_to_speak_to_still_does_its_work) {
  const auto folder = fresh_folder("mute");
  EXPECT_EQ(cli::run(folder, quick + "-o heard.ply -o heard.vtkhdf").code, 0);
  EXPECT_EQ(cli::run(folder, quick + "-o a.ply -o a.vtkhdf 2>&-").code, 0);
  EXPECT_EQ(cli::run(folder, quick + "-o b.ply 2> /dev/full").code, 0);
  EXPECT_EQ(cli::run(folder, quick + "-o c.ply <&- >&- 2>&-").code, 1) << "the names could not be printed";
  for (const char* name : {"a.ply", "b.ply", "c.ply"})
    EXPECT_EQ(read_file(folder / name), read_file(folder / "heard.ply")) << name;
}

TEST(Program, at_a_limit_on_file_sizes_says_so_and_leaves_nothing_behind) {
  const auto folder = fresh_folder("limit");
  const auto run = cli::run(folder, "ulimit -f 8; " + quick + "-o a.ply --quiet");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.err.find("luxel: cannot write a.ply: File too large"), std::string::npos) << run.err;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    EXPECT_EQ(entry.path().string().find(".tmp"), std::string::npos) << entry.path();
}

TEST(Program, draws_strips_and_plans) {
  const auto folder = fresh_folder("strip");
  const auto strip = cli::run(folder, quick + "--width 2000 --height 1 -o strip.png --quiet");
  EXPECT_EQ(strip.code, 0) << strip.err;
  const auto plan = cli::run(folder, quick + "--eye 0,2,0 --target 0,0,0 --up y -o plan.png --quiet");
  EXPECT_EQ(plan.code, 0) << plan.err;
}

TEST(Program, reads_options_that_begin_with_a_byte_order_mark) {
  const auto folder = fresh_folder("mark");
  write_file(folder / "mark.toml", "\xef\xbb\xbfseed = 4\r\n");
  const auto run = cli::run(folder, "$LUXEL bake cornell-box.obj --config mark.toml --print-config");
  EXPECT_NE(run.out.find("seed = \"4\"  # count; file"), std::string::npos) << run.out << run.err;
}

TEST(Program, tells_another_program_line_by_line_how_far_it_has_come) {
  const auto folder = fresh_folder("progress");
  const auto run = cli::run(folder, quick + "--progress json --quiet -o a.vtkhdf");
  ASSERT_EQ(run.code, 0) << run.err;
  std::istringstream lines(run.err);
  bool has_light = false;
  for (std::string line; std::getline(lines, line);) {
    const auto json = Json::parse(line);
    has_light |= json["stage"] == "light";
    EXPECT_GE(json["done"].get<double>(), 0.0) << line;
    EXPECT_LE(json["done"].get<double>(), 1.0) << line;
    EXPECT_GE(json["error"].get<double>(), 0.0) << line;
    EXPECT_GE(json["seconds"].get<double>(), 0.0) << line;
    EXPECT_EQ(json["seconds_left"].is_null(), json["done"].get<double>() < 0.01) << line;
  }
  EXPECT_TRUE(has_light) << run.err;
  EXPECT_EQ(cli::run(folder, quick + "--progress loud -o a.vtkhdf").code, 2);
}

TEST(Program, records_a_command_that_a_shell_reads_back) {
  const auto folder = fresh_folder("quoted");
  std::filesystem::copy_file(folder / "cornell-box.obj", folder / "my box.obj");
  ASSERT_EQ(
      cli::run(
          folder,
          "$LUXEL bake 'my box.obj' --method shooting --rays 10k --max-edge 0.2 --fov 50 -o a.vtkhdf --quiet")
          .code,
      0);
  const auto info = Json::parse(cli::run(folder, "$LUXEL info a.vtkhdf --json").out);
  EXPECT_EQ(info["solution"]["command_line"],
            "luxel bake 'my box.obj' --max-edge 0.2 --method shooting --rays 10000 --fov 50");
}

TEST(Program, turned_round_lamps_are_reported_with_the_flag_that_mends_them) {
  const auto folder = fresh_folder("flip");
  const auto wrong = cli::run(folder, quick + "-o a.glb --flip lamp");
  EXPECT_EQ(wrong.code, 0);
  EXPECT_NE(wrong.err.find("--flip lamp"), std::string::npos) << wrong.err;
  const auto right = cli::run(folder, quick + "-o a.glb");
  EXPECT_EQ(right.err.find("warning"), std::string::npos) << right.err;
}

}  // namespace
}  // namespace luxel::cli
