// `spanline render --panel` as a user types it.
#include <gtest/gtest.h>

#include "assetc/text_file.hpp"
#include "hal/panel_support.hpp"
#include "host/support.hpp"

namespace spanline::host {
namespace {

using Words = std::vector<std::string>;

const std::string kScene = "../host/good/cube.obj";

ToolRun render(const Words& options) {
  Words words = {"render", kScene};
  words.insert(words.end(), options.begin(), options.end());
  return run_tool(words);
}

const char* format_name(PixelFormat format) {
  return format == PixelFormat::rgb565 ? "rgb565" : format == PixelFormat::grey4 ? "grey4" : "mono1";
}

TEST(PanelCommandLine, ShowsTheEnginesPicture) {
  for (const Turn& turn : all_turns()) {
    const TemporaryFolder folder;
    const std::unique_ptr<PanelRun> run = PanelRun::make(turn.panel, turn.rotation);
    const std::string size = std::to_string(run->width()) + "x" + std::to_string(run->height());
    const std::string rotation = std::to_string(static_cast<int>(turn.rotation));
    const ToolRun shown = render({"--panel", turn.panel, "--rotation", rotation, "--out", folder.file("panel.ppm")});
    EXPECT_EQ(shown.exit_code, 0) << turn << shown.err;
    EXPECT_EQ(
        render({"--size", size, "--format", format_name(run->format()), "--out", folder.file("plain.ppm")}).exit_code,
        0);
    EXPECT_EQ(read_file(folder.file("panel.ppm")), read_file(folder.file("plain.ppm"))) << turn;
  }
}

TEST(PanelCommandLine, KeepsTheStreamThatWentOut) {
  const TemporaryFolder folder;
  ASSERT_EQ(render({"--panel", "SSD0323", "--spi-log", folder.file("log")}).exit_code, 0);
  const std::string log = read_file(folder.file("log"));
  ASSERT_EQ(log.size() % 2, 0u);
  std::size_t counts[4] = {};
  for (std::size_t i = 0; i < log.size(); i += 2) {
    ASSERT_LT(log[i], 4);
    ++counts[static_cast<unsigned char>(log[i])];
    EXPECT_TRUE(log[i] < 2 || log[i + 1] == 0 || log[i + 1] == 1);
  }
  EXPECT_EQ(counts[1], 128u * 64 / 2);
  EXPECT_EQ(counts[3], 2u);  // into reset and out of it
  EXPECT_EQ(log.substr(0, 4), std::string("\3\0\3\1", 4));
  const std::string window("\0\x15\0\0\0\x3F\0\x75\0\0\0\x3F\1", 13);
  EXPECT_NE(log.find(window), std::string::npos);
}

TEST(PanelCommandLine, AllFramesGoThroughOnePanel) {
  const TemporaryFolder folder;
  ASSERT_EQ(
      render({"--panel", "ssd1306", "--frames", "0:1", "--out", folder.file("o.ppm"), "--spi-log", folder.file("log")})
          .exit_code,
      0);
  EXPECT_EQ(folder.names(), (Words{"log", "o-0000.ppm", "o-0001.ppm"}));
  std::size_t data = 0;
  const std::string log = read_file(folder.file("log"));
  for (std::size_t i = 0; i < log.size(); i += 2) data += log[i] == 1;
  EXPECT_EQ(data, 2u * 1024);
}

TEST(PanelCommandLine, WrongUsageIsTwo) {
  const std::vector<Words> wrong = {
      {"--panel", "vt100"},
      {"--panel", "ssd0323", "--rotation", "1"},
      {"--panel", "ssd1306", "--rotation", "3"},
      {"--panel", "ili9341", "--rotation", "4"},
      {"--panel", "ili9341", "--rotation", "-1"},
      {"--panel", "ili9341", "--size", "320x240"},
      {"--panel", "ili9341", "--format", "grey4"},
      {"--rotation", "1"},
      {"--spi-log", "log"},
  };
  for (Words words : wrong) {
    const TemporaryFolder folder;
    words.insert(words.end(), {"--out", folder.file("o.ppm")});
    const ToolRun run = render(words);
    EXPECT_EQ(run.exit_code, 2) << words[0] << " " << words[1];
    EXPECT_TRUE(run.err.starts_with("spanline: ")) << run.err;
    EXPECT_TRUE(folder.names().empty());
  }
}

}  // namespace
}  // namespace spanline::host
