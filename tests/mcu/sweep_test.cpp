#include "budget/sweep.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/frame/storage.hpp"
#include "host/support.hpp"
#include "sim/host_memory.hpp"
#include "sim/scene_options.hpp"

namespace spanline::host {
namespace {

// Frames of the benchmark that were counted, and what was in them.
TEST(FramePrices, MeetWhatWasCounted) {
  struct Counted {
    const char* core;
    double references, cycles;
  };
  const Counted counted[] = {{"m0+", 1259, 956'381}, {"m0+", 13570, 9'230'014}, {"m0+", 38857, 25'041'536},
                             {"m3", 1259, 589'327},  {"m3", 13570, 4'763'131},  {"m3", 38857, 13'917'677},
                             {"m4", 1259, 582'592},  {"m4", 13570, 4'685'910},  {"m4", 38857, 13'785'109}};
  for (const Counted& frame : counted) {
    const FrameWork work{.pixels = 76800, .references = frame.references};
    const double cycles = estimated_cycles(price_of(frame.core, Walker::segments, false), work);
    EXPECT_NEAR(cycles / frame.cycles, 1, 0.05) << frame.core << " " << frame.cycles;
  }
}

TEST(FramePrices, MeetTheEdgeWalkersFrames) {
  struct Scene {
    double faces, crossings, depth_tests;
    double cycles[3][2];  // of kPricedCores, flat and Gouraud
  };
  const Scene scenes[] = {
#include "mcu/edge_frames.inc"
  };
  for (const Scene& scene : scenes) {
    const FrameWork work{.pixels = 76800,
                         .faces = scene.faces,
                         .crossings = scene.crossings,
                         .overlaps = scene.depth_tests - scene.crossings / 2};
    for (std::size_t core = 0; core < 3; ++core) {
      for (const bool gouraud : {false, true}) {
        const FramePrice& price = price_of(kPricedCores[core], Walker::edges, gouraud);
        EXPECT_NEAR(estimated_cycles(price, work) / scene.cycles[core][gouraud ? 1 : 0], 1, 0.13)
            << price.core << " " << scene.faces;
      }
    }
  }
}

// The pools that the host counts are those of a FrameMemory.
template <Budget kBudget>
void expect_bytes_of_a_board() {
  PoolSizes pools = pools_of(kBudget);
  pools.walker = kBudget.walker;
  pools.exact = true;
  const HostMemory memory({kBudget.width, kBudget.height, kBudget.format}, kBudget.height, pools);
  constexpr double kPadding = 64;
  EXPECT_NEAR(static_cast<double>(memory.bytes()), static_cast<double>(sizeof(FrameMemory<kBudget>)), kPadding);
}

TEST(HostMemory, IsAsLargeAsABoards) {
  expect_bytes_of_a_board<Budget{}>();
  expect_bytes_of_a_board<Budget{.active = 30, .gouraud = false}>();
  expect_bytes_of_a_board<Budget{.patch_facets = 40, .patch_vertices = 70, .layers = 12}>();
  expect_bytes_of_a_board<Budget{.point_lines = 30}>();
  expect_bytes_of_a_board<Budget{.facets = 992, .vertices = 530, .edges = 60, .walker = Walker::edges}>();
  expect_bytes_of_a_board<Budget{
      .facets = 992, .vertices = 530, .edges = 60, .gouraud = false, .walker = Walker::edges, .planes = 7}>();
}

TEST(Sweep, SmallerPoolsTakeLessMemoryAndMoreBands) {
  const Sweep swept = sweep(SceneOptions::load_plain(std::string(SPANLINE_ASSETS) + "/scenes/S3.json"));
  ASSERT_EQ(swept.rows.size(), 30u);
  for (std::size_t i = 0; i < swept.rows.size(); ++i) {
    const SweepRow& row = swept.rows[i];
    if (i % 5 == 0) {  // the edge walker, then the segment walker with ever smaller pools
      EXPECT_EQ(row.budget.walker, Walker::edges);
      EXPECT_EQ(row.bands, 1u);
      EXPECT_LT(row.cycles_on("m4"), swept.rows[i + 1].cycles_on("m4"));
      continue;
    }
    EXPECT_EQ(row.budget.walker, Walker::segments);
    if (row.percent == 100) {
      EXPECT_EQ(row.bands, 1u) << row.budget.width;
      EXPECT_EQ(row.work.faces_again, 0);
    } else {
      EXPECT_LT(row.bytes, swept.rows[i - 1].bytes);
      const bool fits = row.bands != 0;
      EXPECT_TRUE(!fits || row.bands >= swept.rows[i - 1].bands) << row.budget.width;
    }
  }
  const Budget& own = swept.rows[20].budget;  // 320 x 240, the scene's own size
  EXPECT_EQ(swept.suggested.walker, Walker::edges);
  EXPECT_EQ(swept.suggested.facets, own.facets);
  EXPECT_GE(swept.suggested.edges * 100u, own.edges * 115u);
}

// What the edge walker cannot draw is swept by the segment walker alone.
TEST(Sweep, KnowsWhatTheEdgeWalkerIsNotFor) {
  const Sweep swept = sweep(SceneOptions::load_plain(std::string(SPANLINE_ASSETS) + "/scenes/S3-patches.json"));
  ASSERT_EQ(swept.rows.size(), 24u);
  EXPECT_EQ(swept.rows[0].budget.walker, Walker::segments);
  EXPECT_EQ(swept.suggested.walker, Walker::segments);
  EXPECT_GT(swept.suggested.patch_facets, swept.rows[16].budget.patch_facets);
}

TEST(SweepCommand, WritesTableAndSuggestion) {
  const TemporaryFolder folder;
  const ToolRun run = run_tool(
      {"budget", std::string(SPANLINE_ASSETS) + "/scenes/S3.json", "--sweep", "--json", folder.file("s.json")});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("320x240     edges  100 %"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("320x240  segments  100 %"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("inline constexpr spanline::Budget kBudget{"), std::string::npos) << run.out;
  EXPECT_EQ(run_tool({"budget", "none.obj", "--sweep"}).exit_code, 1);
  EXPECT_EQ(run_tool({"budget", "none.elf"}).exit_code, 2);
}

}  // namespace
}  // namespace spanline::host
