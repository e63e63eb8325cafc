#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "assetc/text_file.hpp"
#include "core/frame/frame_impl.hpp"
#include "core/frame/line_frame.hpp"
#include "demo/boards.hpp"
#include "demos/all.hpp"
#include "host/support.hpp"
#include "panel/panel_run.hpp"
#include "sim/picture.hpp"

namespace spanline::host {
namespace {

TEST(DemoVerb, ListsBareNames) {
  const ToolRun run = run_tool({"demo", "--list"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out, "teapot\ncubes\ngears\ngauges\npatches\ndice\nhouse\npanes\nplot\ndial\n");
}

TEST(DemoVerb, WrongNamesAreUsageErrorsThatListTheRightOnes) {
  const TemporaryFolder folder;
  const std::string out = folder.file("a.png");
  const ToolRun demo = run_tool({"demo", "kettle", "--board", "pico", "--out", out});
  EXPECT_EQ(demo.exit_code, 2);
  EXPECT_EQ(
      demo.err,
      "spanline: NAME: 'kettle' is none of teapot, cubes, gears, gauges, patches, dice, house, panes, plot, dial\n");
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

// The stream that the panel's model decodes into the picture is the one that --spi-log keeps.
TEST(DemoVerb, GoesThroughTheDriverOfTheBoard) {
  const TemporaryFolder folder;
  const ToolRun run = run_tool(
      {"demo", "cubes", "--board", "ek-lm3s6965", "--out", folder.file("a.ppm"), "--spi-log", folder.file("log")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string log = read_file(folder.file("log"));
  EXPECT_NE(log.find(std::string("\0\x15\0\0\0\x3F\0\x75\0\0\0\x3F\1", 13)), std::string::npos);
  const ToolRun none =
      run_tool({"demo", "cubes", "--board", "microbit", "--out", folder.file("a.ppm"), "--spi-log", folder.file("no")});
  EXPECT_EQ(none.exit_code, 2);
}

TEST(DemoVerb, GoesThroughAnyPanelTurnedAnyWay) {
  const TemporaryFolder folder;
  const std::string out = folder.file("a.ppm");
  for (const std::string& panel : panel_names()) {
    for (const char* demo :
         {"teapot", "cubes", "gears", "gauges", "patches", "dice", "house", "panes", "plot", "dial"}) {
      const ToolRun run = run_tool({"demo", demo, "--panel", panel, "--rotation", "2", "--frame", "3", "--out", out});
      EXPECT_EQ(run.exit_code, 0) << panel << " " << demo << ": " << run.err;
    }
  }
  const ToolRun quarter = run_tool({"demo", "gears", "--panel", "st7789", "--rotation", "1", "--out", out});
  ASSERT_EQ(quarter.exit_code, 0) << quarter.err;
  const ToolRun board = run_tool({"demo", "gears", "--board", "pico", "--out", folder.file("b.ppm")});
  ASSERT_EQ(board.exit_code, 0) << board.err;
  EXPECT_EQ(read_file(out), read_file(folder.file("b.ppm")));
  EXPECT_EQ(run_tool({"demo", "gears", "--panel", "ssd1306", "--rotation", "1", "--out", out}).exit_code, 2);
  EXPECT_EQ(run_tool({"demo", "gears", "--panel", "st7789", "--board", "pico", "--out", out}).exit_code, 2);
}

// What an image for that screen draws, in no more than the demo's own budget.
template <const demos::Layouts& kLayouts>
std::vector<std::uint8_t> in_a_boards_pools(std::uint32_t frame_number) {
  constexpr Screen kScreen{128, 64, PixelFormat::grey4};
  constexpr demos::Demo kDemo = kLayouts.framed_for(kScreen);
  constexpr Budget kBudget = demos::budget_for(kDemo, kScreen);
  static MemoryFor<kBudget> memory;
  static demos::Stage stage;
  EXPECT_TRUE(stage.begin(kDemo, kScreen).ok());
  stage.show(frame_number);
  FrameFor<kBudget> frame(memory.storage());
  Picture picture(kScreen.width, kScreen.height);
  alignas(4) std::uint8_t wire[kScreen.width / 2];
  std::uint16_t line = 0;
  for (Band rest{0, kScreen.height}; !rest.empty();) {
    const Band band = frame.prepare(stage.view(), stage.camera(), rest);
    if (band.empty()) break;
    while (frame.next_line(wire)) {
      decode_line(kScreen.format, wire, kScreen.width, picture.rgb.data() + std::size_t{3} * kScreen.width * line++);
    }
    rest.top = band.bottom;
  }
  EXPECT_TRUE(frame.status().ok());
  return picture.rgb;
}

TEST(DemoVerb, ShowsWhatTheBoardDoesInEveryPixel) {
  const auto check = [](const std::string& name, const std::vector<std::uint8_t>& expected) {
    const TemporaryFolder folder;
    const std::string out = folder.file("a.ppm");
    const ToolRun run = run_tool({"demo", name, "--board", "ek-lm3s6965", "--frame", "5", "--out", out});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const std::string ppm = read_file(out);
    ASSERT_GE(ppm.size(), expected.size());
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), ppm.end() - static_cast<std::ptrdiff_t>(expected.size()),
                           [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); }))
        << name;
  };
  check("teapot", in_a_boards_pools<demos::teapot>(5));
  check("cubes", in_a_boards_pools<demos::cubes>(5));
  check("gears", in_a_boards_pools<demos::gears>(5));
  check("gauges", in_a_boards_pools<demos::gauges>(5));
  check("patches", in_a_boards_pools<demos::patches>(5));
  check("dice", in_a_boards_pools<demos::dice>(5));
  check("house", in_a_boards_pools<demos::house>(5));
  check("panes", in_a_boards_pools<demos::panes>(5));
  check("plot", in_a_boards_pools<demos::plot>(5));
  check("dial", in_a_boards_pools<demos::dial>(5));
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
