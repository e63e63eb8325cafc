// The parts of a run's account: calls, waiting, stalls, names.
#include <gtest/gtest.h>

#include "budget/frame_report.hpp"
#include "budget/plain_name.hpp"
#include "mcu/frame_recorder.hpp"
#include "mcu/ledger.hpp"
#include "mcu/memory_timing.hpp"
#include "mcu/stage.hpp"

namespace spanline::host {
namespace {

TEST(PlainName, LeavesOutWhatNobodySays) {
  EXPECT_EQ(plain_name("void spanline::Sorter<A, B<C> >::run<D>(D&, int) [clone .isra.0]"), "spanline::Sorter::run");
  EXPECT_EQ(plain_name("spanline::boards::(anonymous namespace)::run()"), "spanline::boards::run");
  EXPECT_EQ(plain_name("__aeabi_lmul"), "__aeabi_lmul");
  EXPECT_EQ(plain_name("spanline::F::operator()(int) const"), "spanline::F::operator()");
}

TEST(Stages, ComeFromTheSource) {
  EXPECT_EQ(stage_of("/x/firmware/core/vsg/depth_sorter.hpp"), Stage::depth);
  EXPECT_EQ(stage_of("/x/firmware/core/vsg/x_sort.hpp"), Stage::segment);
  EXPECT_EQ(stage_of("/x/firmware/core/vsg/edge_table.cpp"), Stage::edges);
  EXPECT_EQ(stage_of("/x/firmware/core/base/pool.hpp"), std::nullopt);
  EXPECT_EQ(stage_of(""), std::nullopt);
}

TEST(WaitFinder, SeesALoopThatAsksAgain) {
  WaitFinder waits;
  EXPECT_FALSE(waits.asked(0x100, 10));
  const std::optional<WaitFinder::Wait> turn = waits.asked(0x100, 16);
  ASSERT_TRUE(turn);
  EXPECT_EQ(turn->begin, 10u);
  EXPECT_EQ(turn->end, 16u);
  waits.stored();
  EXPECT_FALSE(waits.asked(0x100, 22));
}

TEST(WaitFinder, CountsALoopWithTwoQuestionsOnce) {
  WaitFinder waits;
  std::uint64_t waited = 0;
  for (std::uint64_t now = 0; now < 100; now += 10) {
    for (const std::uint32_t instruction : {0x100u, 0x106u}) {
      const auto wait = waits.asked(instruction, now + (instruction == 0x106 ? 4 : 0));
      if (wait) waited += wait->end - wait->begin;
    }
  }
  EXPECT_EQ(waited, 94u);
}

// 5 before the first line; a line that computes longer than it sends, and one the other way round: 5 + 20 + 30.
TEST(FrameReport, HoldsAFrameAgainstWhatNoOverlapCanSave) {
  FrameRecord frame;
  frame.prepare = {5, 5, 0, 0};
  frame.lines.resize(2);
  frame.lines[0].count = {20, 24, 0, 4};
  frame.lines[0].end = 10;
  frame.lines[1].count = {20, 18, 2, 0};
  frame.lines[1].begin = 10;
  frame.lines[1].end = 40;
  frame.count = {45, 47, 2, 4};
  frame.end = 66;
  RunReport run;
  run.frames = {frame, frame};
  run.frames[1].end = 55;
  EXPECT_EQ(frame_report(run, 1000)->pace, 0);
  run.timed = true;
  EXPECT_DOUBLE_EQ(frame_report(run, 1000)->pace, 66.0 / 55);
}

// Two bands of two lines; of the second line nothing is sent, of the third four bytes by DMA while the fourth is made.
TEST(FrameRecorder, GivesEachLineOfThePictureItsOwn) {
  Ledger ledger(0);
  FrameRecorder recorder;
  const auto work = [&ledger](std::uint64_t cycles) { ledger.charge({}, {1, cycles, 0, 0}); };
  recorder.begin_frame(ledger);
  work(5);
  recorder.begin_line(0, ledger);
  work(10);
  recorder.gave(2, ledger);
  work(1);
  recorder.begin_line(2, ledger);
  work(20);
  recorder.begin_line(2, ledger);
  work(3);
  recorder.no_line();
  work(4);
  recorder.begin_line(2, ledger);
  work(30);
  recorder.gave(3, ledger);
  recorder.begin_line(6, ledger);
  work(40);
  recorder.gave(6, ledger);
  recorder.end_frame(ledger, {{16, 17, false},
                              {17, 18, true},
                              {18, 19, true},
                              {80, 81, true},
                              {81, 82, true},
                              {82, 83, true},
                              {83, 84, true}});

  const FrameRecord& frame = recorder.frames().front();
  EXPECT_EQ(frame.prepare.cycles, 5u);
  EXPECT_EQ(frame.bytes, 7u);
  ASSERT_EQ(frame.lines.size(), 4u);
  const std::uint64_t cycles[] = {11, 20, 37, 40}, bytes[] = {2, 0, 4, 0}, ready[] = {15, 0, 73, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(frame.lines[i].count.cycles, cycles[i]) << i;
    EXPECT_EQ(frame.lines[i].bytes, bytes[i]) << i;
    EXPECT_EQ(frame.lines[i].ready, ready[i]) << i;
  }
  EXPECT_EQ(frame.lines[2].begin, 80u);
  EXPECT_EQ(frame.lines[2].end, 84u);
}

TEST(CacheTags, ForgetWhatWasUsedLongestAgo) {
  CacheTags tags(1, 2);
  EXPECT_FALSE(tags.take(1));
  EXPECT_FALSE(tags.take(2));
  EXPECT_TRUE(tags.take(1));
  EXPECT_FALSE(tags.take(3));
  EXPECT_FALSE(tags.take(2));
  EXPECT_TRUE(tags.take(3));
}

TEST(MemoryTiming, PrefetchHidesAsMuchAsThePreviousLineTook) {
  MemoryTiming timing({.base = 0x1000, .size = 0x1000, .line_bits = 4, .code_ways = 4, .prefetches = true});
  timing.set_miss(5);
  EXPECT_EQ(timing.fetch(0x1000, 100), 5u);  // entered at 105
  EXPECT_EQ(timing.fetch(0x1004, 106), 0u);
  EXPECT_EQ(timing.fetch(0x1010, 108), 2u);  // three cycles were there to fetch it
  EXPECT_EQ(timing.fetch(0x1020, 200), 0u);  // long since fetched
  EXPECT_EQ(timing.fetch(0x1100, 201), 5u);  // a jump
  EXPECT_EQ(timing.fetch(0x1000, 300), 0u);  // still in the cache
  EXPECT_EQ(timing.fetch(0x5000, 301), 0u);  // another memory
}

}  // namespace
}  // namespace spanline::host
