#include "budget/sweep.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "host/support.hpp"
#include "sim/scene_options.hpp"

namespace spanline::host {
namespace {

// Frames of the benchmark that were counted, and what was in them.
TEST(FramePrices, MeetWhatWasCounted) {
  struct Counted {
    const char* core;
    FrameWork work;
    double cycles;
  };
  const Counted counted[] = {
      {"m0+", {1259, 76800, 0}, 956'381}, {"m0+", {13570, 76800, 0}, 9'230'014}, {"m0+", {38857, 76800, 0}, 25'041'536},
      {"m3", {1259, 76800, 0}, 589'327},  {"m3", {13570, 76800, 0}, 4'763'131},  {"m3", {38857, 76800, 0}, 13'917'677},
      {"m4", {1259, 76800, 0}, 582'592},  {"m4", {13570, 76800, 0}, 4'685'910},  {"m4", {38857, 76800, 0}, 13'785'109}};
  for (const Counted& frame : counted) {
    for (const FramePrice& price : frame_prices()) {
      if (std::string(price.core) != frame.core) continue;
      EXPECT_NEAR(estimated_cycles(price, frame.work) / frame.cycles, 1, 0.05) << frame.core << " " << frame.cycles;
    }
  }
}

TEST(Sweep, SmallerPoolsTakeLessMemoryAndMoreBands) {
  const Sweep swept = sweep(SceneOptions::load_plain(std::string(SPANLINE_ASSETS) + "/scenes/S3.json"));
  ASSERT_EQ(swept.rows.size(), 24u);
  for (std::size_t i = 0; i < swept.rows.size(); ++i) {
    const SweepRow& row = swept.rows[i];
    if (row.percent == 100) {
      EXPECT_EQ(row.bands, 1u) << row.budget.width;
      EXPECT_EQ(row.work.faces_again, 0u);
    } else {
      EXPECT_LT(row.bytes, swept.rows[i - 1].bytes);
      const bool fits = row.bands != 0;
      EXPECT_TRUE(!fits || row.bands >= swept.rows[i - 1].bands) << row.budget.width;
    }
  }
  EXPECT_GE(swept.suggested.facets * 100u, swept.rows[16].budget.facets * 115u);  // 320 x 240, the scene's own size
}

TEST(SweepCommand, WritesTableAndSuggestion) {
  const TemporaryFolder folder;
  const ToolRun run = run_tool(
      {"budget", std::string(SPANLINE_ASSETS) + "/scenes/S3.json", "--sweep", "--json", folder.file("s.json")});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("320x240  100 %"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("inline constexpr spanline::Budget kBudget{"), std::string::npos) << run.out;
  EXPECT_EQ(run_tool({"budget", "none.obj", "--sweep"}).exit_code, 1);
  EXPECT_EQ(run_tool({"budget", "none.elf"}).exit_code, 2);
}

}  // namespace
}  // namespace spanline::host
