#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "demo/boards.hpp"
#include "host/support.hpp"
#include "sim/picture.hpp"

namespace spanline::host {
namespace {

TEST(DemoVerb, ListsBareNames) {
  const ToolRun run = run_tool({"demo", "--list"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out, "teapot\ncubes\ngears\ngauges\n");
}

TEST(DemoVerb, WrongNamesAreUsageErrorsThatListTheRightOnes) {
  const TemporaryFolder folder;
  const std::string out = folder.file("a.png");
  const ToolRun demo = run_tool({"demo", "kettle", "--board", "pico", "--out", out});
  EXPECT_EQ(demo.exit_code, 2);
  EXPECT_EQ(demo.err, "spanline: NAME: 'kettle' is none of teapot, cubes, gears, gauges\n");
  const ToolRun board = run_tool({"demo", "teapot", "--board", "pica", "--out", out});
  EXPECT_EQ(board.exit_code, 2);
  EXPECT_NE(board.err.find("'pica' is none of ek-lm3s6965, stm32f429i-disc1, nucleo-f411re, pico"), std::string::npos);
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"demo"},
        {"demo", "teapot"},
        {"demo", "teapot", "--board", "pico"},
        {"demo", "teapot", "--board", "pico", "--out", folder.file("a.gif")},
        {"demo", "teapot", "--board", "pico", "--out", out, "--frame", "-1"}}) {
    EXPECT_EQ(run_tool(arguments).exit_code, 2);
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(DemoVerb, DrawsForThePanelOfTheBoard) {
  const TemporaryFolder folder;
  const std::string out = folder.file("a.png");
  const ToolRun run = run_tool({"demo", "gauges", "--board", "stm32f429i-disc1", "--frame", "7", "--out", out});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  if (!png_available()) GTEST_SKIP() << "no libpng";
  const Picture picture = read_png(out);
  EXPECT_EQ(picture.width, 240);
  EXPECT_EQ(picture.height, 320);
}

TEST(DemoVerb, KnowsEveryBoardOfTheFirmware) {
  std::set<std::string> known;
  for (const Board& board : boards()) known.insert(board.name);
  std::set<std::string> built;
  for (const auto& entry : std::filesystem::directory_iterator("firmware/boards")) {
    if (entry.path().filename() != "template" && exists(entry.path() / "board.hpp")) {
      built.insert(entry.path().filename().string());
    }
  }
  EXPECT_EQ(known, built);
}

}  // namespace
}  // namespace spanline::host
