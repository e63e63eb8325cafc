// The tool as a user types it: exit codes, one line on standard error, and no file left behind.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "assetc/text_file.hpp"
#include "host/support.hpp"
#include "sim/picture.hpp"

namespace spanline::host {
namespace {

using Words = std::vector<std::string>;

const std::string kCube = "good/cube.obj";

bool is_one_line(const std::string& text) {
  return text.ends_with('\n') && std::count(text.begin(), text.end(), '\n') == 1 && text.starts_with("spanline: ");
}

TEST(CommandLine, BrokenFilesFailWithOneLineAndLeaveNothing) {
  for (const BrokenFile& file : broken_files()) {
    const TemporaryFolder folder;
    const ToolRun run = run_tool({"render", file.path, "--out", folder.file("o.ppm"), "--ids", folder.file("i.ppm"),
                                  "--depth", folder.file("d.pgm"), "--stats", folder.file("s.json")});
    EXPECT_EQ(run.exit_code, 1) << file.path;
    EXPECT_TRUE(is_one_line(run.err)) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_TRUE(folder.names().empty()) << file.path;
  }
}

TEST(CommandLine, WrongUsageIsTwo) {
  const std::vector<Words> wrong = {
      {},
      {"paint"},
      {"render"},
      {"render", kCube},
      {"render", kCube, "--out"},
      {"render", kCube, "--out", "o.gif"},
      {"render", kCube, "--out", "o.ppm", "extra"},
      {"render", kCube, "--out", "o.ppm", "--unknown"},
      {"render", kCube, "--out", "o.ppm", "--surface", "voxels"},
      {"render", "good/good.mtl", "--out", "o.ppm"},
      {"render", kCube, "--out", "o.ppm", "--size", "0x0"},
      {"render", kCube, "--out", "o.ppm", "--size", "100000x100000"},
      {"render", kCube, "--out", "o.ppm", "--size", "2047x1"},
      {"render", kCube, "--out", "o.ppm", "--size", "-4x4"},
      {"render", kCube, "--out", "o.ppm", "--size", "4"},
      {"render", kCube, "--out", "o.ppm", "--size", "4x4x4"},
      {"render", kCube, "--out", "o.ppm", "--size", "4x"},
      {"render", kCube, "--out", "o.ppm", "--eye", "1,2"},
      {"render", kCube, "--out", "o.ppm", "--eye", "1,2,nan"},
      {"render", kCube, "--out", "o.ppm", "--eye", "1,2,3,4"},
      {"render", kCube, "--out", "o.ppm", "--eye", "1,2,3", "--target", "1,2,3"},
      {"render", kCube, "--out", "o.ppm", "--eye", "0,9,0", "--target", "0,0,0"},
      {"render", kCube, "--out", "o.ppm", "--eye", "1,2,3", "--target", "0,0,0", "--up", "0,0,0"},
      {"render", kCube, "--out", "o.ppm", "--fov", "0"},
      {"render", kCube, "--out", "o.ppm", "--fov", "180"},
      {"render", kCube, "--out", "o.ppm", "--fov", "wide"},
      {"render", kCube, "--out", "o.ppm", "--near", "0"},
      {"render", kCube, "--out", "o.ppm", "--near", "5", "--far", "5"},
      {"render", kCube, "--out", "o.ppm", "--light", "0,0,0"},
      {"render", kCube, "--out", "o.ppm", "--frame", "-1"},
      {"render", kCube, "--out", "o.ppm", "--frame", "1.5"},
      {"render", kCube, "--out", "o.ppm", "--frames", "3"},
      {"render", kCube, "--out", "o.ppm", "--frames", "5:3"},
      {"render", kCube, "--out", "o.ppm", "--frame", "1", "--frames", "0:3"},
      {"render", kCube, "--out", "o.ppm", "--comparator", "float"},
      {"render", kCube, "--out", "o.ppm", "--walker", "faces"},
      {"render", kCube, "--out", "o.ppm", "--bands", "0"},
      {"render", kCube, "--out", "o.ppm", "--pools", "facets"},
      {"render", kCube, "--out", "o.ppm", "--pools", "beans=3"},
      {"render", kCube, "--out", "o.ppm", "--pools", "facets=-3"},
      {"render", kCube, "--out", "o.ppm", "--format", "rgb888"},
      {"render", kCube, "--out", "o.ppm", "--shading", "phong"},
      {"render", kCube, "--out", "o.ppm", "--screen", "--fov", "30"},
      {"render", "broken/scene/null.json", "--out", "o.ppm", "--screen"},
      {"assets", kCube},
      {"view"},
  };
  for (const Words& words : wrong) {
    const ToolRun run = run_tool(words);
    EXPECT_EQ(run.exit_code, 2) << testing::PrintToString(words);
    EXPECT_TRUE(is_one_line(run.err)) << run.err;
  }
}

TEST(CommandLine, HelpIsZero) {
  for (const Words& words :
       {Words{"--help"}, Words{"render", "--help"}, Words{"view", "--help"}, Words{"assets", "--help"}}) {
    const ToolRun run = run_tool(words);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_NE(run.out.find("Usage"), std::string::npos);
  }
}

TEST(CommandLine, WorkThatFailsIsOne) {
  const TemporaryFolder folder;
  const std::vector<Words> failing = {
      {"render", "absent.obj", "--out", folder.file("o.ppm")},
      {"render", kCube, "--out", folder.file("no/such/folder/o.ppm")},
      {"render", kCube, "--fov", "0.01", "--out", folder.file("o.ppm")},
      {"render", kCube, "--screen", "--out", folder.file("o.ppm")},  // z is negative
      {"assets", kCube, "--out", folder.file("no/such/folder/o.cpp")},
  };
  for (const Words& words : failing) {
    const ToolRun run = run_tool(words);
    EXPECT_EQ(run.exit_code, 1) << testing::PrintToString(words);
    EXPECT_TRUE(is_one_line(run.err)) << run.err;
    EXPECT_TRUE(folder.names().empty());
  }
}

TEST(CommandLine, WritesEveryOutput) {
  const TemporaryFolder folder;
  const ToolRun run = run_tool({"render", kCube, "--size", "40x30", "--out", folder.file("o.ppm"), "--ids",
                                folder.file("i.ppm"), "--depth", folder.file("d.pgm"), "--stats", "-"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(folder.names(), (Words{"d.pgm", "i.ppm", "o.ppm"}));
  EXPECT_EQ(read_file(folder.file("o.ppm")).size(), 13u + 40 * 30 * 3);
  EXPECT_EQ(read_file(folder.file("d.pgm")).size(), 15u + 40 * 30 * 2);
  EXPECT_NE(run.out.find("\"segment_references\""), std::string::npos);
}

TEST(CommandLine, NumbersFrames) {
  const TemporaryFolder folder;
  const ToolRun run = run_tool({"render", "good/motion.json", "--frames", "9:11", "--out", folder.file("f.ppm")});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(folder.names(), (Words{"f-0009.ppm", "f-0010.ppm", "f-0011.ppm"}));
  EXPECT_NE(read_file(folder.file("f-0009.ppm")), read_file(folder.file("f-0010.ppm")));
}

TEST(CommandLine, ExpectComparesPictures) {
  if (!png_available()) GTEST_SKIP() << "this build has no libpng";
  const TemporaryFolder folder;
  const std::string png = folder.file("o.png");
  EXPECT_EQ(run_tool({"render", kCube, "--size", "40x30", "--out", png}).exit_code, 0);
  EXPECT_EQ(run_tool({"render", kCube, "--size", "40x30", "--expect", png}).exit_code, 0);
  const ToolRun other = run_tool({"render", kCube, "--size", "40x30", "--expect", png, "--eye", "3,4,5"});
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.err.find(" of 1200 pixels differ"), std::string::npos) << other.err;
  EXPECT_EQ(run_tool({"render", kCube, "--size", "41x30", "--expect", png}).exit_code, 1);
  EXPECT_EQ(run_tool({"render", kCube, "--expect", "good/cube.obj"}).exit_code, 1);
}

TEST(CommandLine, PointsAreAnotherWayToDrawPatches) {
  const TemporaryFolder folder;
  const std::string assets = SPANLINE_ASSETS, teapot = assets + "/teapot.bpt";
  const auto draw = [&](const std::string& scene, const std::string& out, const std::string& surface) {
    return run_tool({"render", scene, "--up", "0,0,1", "--surface", surface, "--out", folder.file(out)});
  };
  EXPECT_EQ(draw(teapot, "points.ppm", "points").exit_code, 0);
  EXPECT_EQ(draw(teapot, "dice.ppm", "dice").exit_code, 0);
  EXPECT_NE(read_file(folder.file("points.ppm")), read_file(folder.file("dice.ppm")));
  EXPECT_EQ(draw(kCube, "mesh.ppm", "points").exit_code, 0);

  const std::string scene = folder.file("glass.json");
  std::ofstream(scene) << R"({"materials":[{"name":"g","color":[1,1,1],"opacity":0.5}],"meshes":[{"name":"p","bpt":")"
                       << teapot << R"("},{"name":"c","obj":")" << assets
                       << R"(/cubes.obj"}],"instances":[{"mesh":"p"},{"mesh":"c","material":"g"}]})";
  const ToolRun refused = draw(scene, "glass.ppm", "points");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_TRUE(is_one_line(refused.err)) << refused.err;
  EXPECT_NE(refused.err.find("--surface points"), std::string::npos) << refused.err;
  EXPECT_EQ(draw(scene, "glass.ppm", "dice").exit_code, 0);
}

TEST(CommandLine, AFullPoolWarnsAndNamesIt) {
  const TemporaryFolder folder;
  const ToolRun run = run_tool({"render", kCube, "--out", folder.file("o.ppm"), "--pools", "segments=1"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.err.find("warning"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("'segments'"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace spanline::host
