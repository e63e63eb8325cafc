// Runs of a few instructions: what is counted, where a run ends, what a fault says.
#include "mcu/machine.hpp"

#include <gtest/gtest.h>

#include "assetc/input_error.hpp"
#include "mcu/sio_divider.hpp"
#include "mcu/tiny_elf.hpp"
#include "sim/usage_error.hpp"

namespace spanline::host {
namespace {

RunReport run(const std::vector<std::uint16_t>& code, const char* board = "cortex-m4", const RunOptions& options = {},
              std::vector<TinySymbol> symbols = {{"reset", 0x41, 0}}) {
  TinyElf elf;
  elf.code = code;
  elf.symbols = std::move(symbols);
  return run_image(Image(write_tiny_elf(elf, "run.elf")), board_named(board), options);
}

std::string fault(const std::vector<std::uint16_t>& code, const char* board = "cortex-m4") {
  try {
    run(code, board);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Machine, CountsWhatAnItBlockSkips) {
  // cmp r0, r0; ittet ne; three of the four are skipped; bkpt
  const RunReport report = run({0x4280, 0xBF15, 0x3101, 0x3101, 0x3201, 0x3101, 0xBE00});
  EXPECT_EQ(report.total.instructions, 7u);
  // The same within a loop, the last of the block a branch: movs r1, #3; subs r1, #1; it ne; bne back; bkpt
  EXPECT_EQ(run({0x2103, 0x3901, 0xBF18, 0xE7FC, 0xBE00}).total.instructions, 1u + 3 * 3 + 1);
}

TEST(Machine, EndsAtBreakpointCallAndIdleLoop) {
  EXPECT_EQ(run({0xBE00}).end, "BKPT at 0x00000040 in reset");
  EXPECT_EQ(run({0xDF00}).end, "SVC at 0x00000040 in reset");
  EXPECT_EQ(run({0xE7FE}).end, "spins at 0x00000040 in reset");
  EXPECT_EQ(run({0xBF30}).end, "waits for an interrupt at 0x00000040 in reset");
  EXPECT_EQ(run({0xBF20}).end, "waits for an interrupt at 0x00000040 in reset");
  EXPECT_EQ(run({0xBF00, 0xBE00}).total.instructions, 2u);
}

TEST(Machine, SpeaksBySemihosting) {
  // movs r0, #4; adr r1, text; bkpt 0xab; movs r0, #0x18; ldr r1, =0x20026; bkpt 0xab; text "hi", 0; 0x20026
  const RunReport report = run({0x2004, 0xA102, 0xBEAB, 0x2018, 0x4901, 0xBEAB, 0x6968, 0x0000, 0x0026, 0x0002});
  EXPECT_EQ(report.output, "hi");
  EXPECT_EQ(report.end, "exit 0");
  EXPECT_EQ(report.total.instructions, 6u);
}

// Waits for three ticks of 50,000 cycles in a loop that asks the timer, goes another way in every other 512 cycles of
// it, and counts its turns:
// reset: ldr r0, =0xe000e010; ldr r1, =49999; str r1, [r0, #4]; movs r1, #0; str r1, [r0, #8]; movs r5, #0;
//        ldr r2, =0x20000000; str r5, [r2]; movs r1, #7; str r1, [r0];
// loop:  ldr r3, [r0, #8]; ldr r4, [r2]; adds r5, #1; lsls r6, r3, #22; bpl next; nop; next: cmp r4, #3; bne loop; bkpt
// tick:  ldr r1, =0x20000000; ldr r0, [r1]; adds r0, #1; str r0, [r1]; bx lr
const std::vector<std::uint16_t> kWait = {0x480B, 0x490C, 0x6041, 0x2100, 0x6081, 0x2500, 0x4A0A, 0x6015,
                                          0x2107, 0x6001, 0x6883, 0x6814, 0x3501, 0x059E, 0xD500, 0x46C0,
                                          0x2C03, 0xD1F7, 0xBE00, 0x4904, 0x6808, 0x3001, 0x6008, 0x4770,
                                          0xE010, 0xE000, 0xC34F, 0x0000, 0x0000, 0x2000};

TEST(Machine, ReplaysLoopsThatWaitAndCountsTheSame) {
  for (const char* board : {"cortex-m0", "cortex-m0plus", "cortex-m3", "cortex-m4", "ek-lm3s6965"}) {
    TinyElf elf;
    elf.code = kWait;
    elf.symbols = {{"reset", 0x41, 38}, {"tick", 0x67, 10}};
    elf.tick = 0x67;
    const Image image(write_tiny_elf(elf, "wait.elf"));
    RunOptions options;
    const RunReport replayed = run_image(image, board_named(board), options);
    options.step_by_step = true;
    const RunReport stepped = run_image(image, board_named(board), options);
    const auto expect_same = [&](const Count& a, const Count& b, const std::string& what) {
      EXPECT_EQ(a.instructions, b.instructions) << board << " " << what;
      EXPECT_EQ(a.cycles, b.cycles) << board << " " << what;
      EXPECT_EQ(a.stalls, b.stalls) << board << " " << what;
      EXPECT_EQ(a.waiting, b.waiting) << board << " " << what;
    };
    EXPECT_EQ(replayed.end, "BKPT at 0x00000064 in reset") << board;
    EXPECT_EQ(replayed.end, stepped.end) << board;
    EXPECT_GT(stepped.total.waiting, 140000u) << board;
    expect_same(replayed.total, stepped.total, "total");
    ASSERT_EQ(replayed.functions.size(), stepped.functions.size());
    for (std::size_t i = 0; i < stepped.functions.size(); ++i) {
      expect_same(replayed.functions[i], stepped.functions[i], "function " + std::to_string(i));
    }
    ASSERT_EQ(replayed.calls.nodes().size(), stepped.calls.nodes().size());
    for (std::size_t i = 0; i < stepped.calls.nodes().size(); ++i) {
      expect_same(replayed.calls.nodes()[i].self, stepped.calls.nodes()[i].self, "node " + std::to_string(i));
    }
  }
}

// reset: bl begin; adds; adds; bl end; b reset. begin and end: bx lr.
const std::vector<std::uint16_t> kFrames = {0xF000, 0xF806, 0x3001, 0x3001, 0xF000,
                                            0xF803, 0xE7F8, 0xBF00, 0x4770, 0x4770};
const std::vector<TinySymbol> kMarks = {
    {"reset", 0x41, 16}, {"frame_begin_mark", 0x51, 2}, {"frame_end_mark", 0x53, 2}};

TEST(Machine, CountsBetweenTwoSymbols) {
  RunOptions options;
  options.from = "frame_begin_mark";
  options.until = "frame_end_mark";
  options.passages = 3;
  const RunReport report = run(kFrames, "cortex-m4", options, kMarks);
  ASSERT_EQ(report.passages.size(), 3u);
  for (const Count& frame : report.passages) EXPECT_EQ(frame.instructions, 4u);  // bx lr; adds; adds; bl
  EXPECT_EQ(report.passages[1].cycles, 2u + 1 + 1 + 2);
  EXPECT_EQ(report.end, "reached frame_end_mark");
  EXPECT_EQ(report.functions[0].instructions, 9u);
  EXPECT_EQ(report.functions[1].instructions, 3u);
  EXPECT_EQ(report.total.instructions, 12u);
}

TEST(Machine, SaysWhereAnImageFaults) {
  // movs r0, #0x40; lsls r0, r0, #24; ldr r1, [r0]
  const std::string missing = fault({0x2040, 0x0600, 0x6801, 0xBE00});
  EXPECT_NE(missing.find("reads 0x40000000, where nothing is modelled, at 0x00000044 in reset; r0=0x40000000"),
            std::string::npos)
      << missing;
  // movs r0, #0; str r0, [r0]
  EXPECT_NE(fault({0x2000, 0x6000, 0xBE00}).find("writes 0x00000000, which is flash"), std::string::npos);
  // movs r0, #0xE0; lsls r0, r0, #24; ldr r1, [r0]: a register of the core's that nobody modelled
  EXPECT_NE(fault({0x20E0, 0x0600, 0x6801, 0xBE00}).find("reads the register 0xe0000000, which is not modelled"),
            std::string::npos);
  EXPECT_NE(fault({0xDE00, 0xBE00}).find("at 0x00000040 in reset"), std::string::npos);  // udf
}

// An image in the flash of a board whose peripherals are modelled.
std::string fault_on(const char* board, std::uint32_t flash, const std::vector<std::uint16_t>& code) {
  TinyElf elf;
  elf.base = flash;
  elf.code = code;
  elf.symbols = {{"reset", flash + TinyElf::kCode + 1, 0}};
  try {
    run_image(Image(write_tiny_elf(elf, "board.elf")), board_named(board), {});
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Machine, SaysWhichRegisterIsNotModelled) {
  // ldr r0, =ADDRESS; ldr r1, [r0]; bkpt
  const auto reads = [](std::uint32_t address) {
    return std::vector<std::uint16_t>{
        0x4801, 0x6801, 0xBE00, 0xBF00, static_cast<std::uint16_t>(address), static_cast<std::uint16_t>(address >> 16)};
  };
  constexpr std::uint32_t kFlash = 0x0800'0000;
  EXPECT_EQ(fault_on("stm32f429i-disc1", kFlash, reads(0x4002'3800)), "none");
  EXPECT_NE(fault_on("stm32f429i-disc1", kFlash, reads(0x4002'3814))
                .find("reads the register 0x40023814, which is not modelled, at 0x08000042 in reset; r0=0x40023814"),
            std::string::npos);
  EXPECT_NE(fault_on("stm32f429i-disc1", kFlash, reads(0x4001'5008))
                .find("reads the register 0x40015008 of SPI5, which has no clock or is in reset"),
            std::string::npos);
  EXPECT_NE(fault_on("ek-lm3s6965", 0, reads(0x4000'8000)).find("of SSI0, which has no clock"), std::string::npos);
  EXPECT_NE(fault_on("ek-lm3s6965", 0, reads(0x4003'0000)).find("where nothing is modelled"), std::string::npos);
}

struct Division {
  std::uint32_t at;  // of the dividend's register; the divisor's follows
  std::uint32_t a, b, quotient, remainder;
};

TEST(SioDivider, DividesAsTheChip) {
  constexpr std::uint32_t kUnsigned = 0x00, kSigned = 0x08, kQuotient = 0x10, kRemainder = 0x14, kState = 0x18;
  const auto minus = [](std::uint32_t value) { return 0u - value; };
  const Division divisions[] = {{kUnsigned, 1000, 7, 142, 6},
                                {kUnsigned, minus(1), 2, 0x7FFF'FFFF, 1},
                                {kUnsigned, 5, 0, minus(1), 5},
                                {kSigned, minus(1000), 7, minus(142), minus(6)},
                                {kSigned, 1000, minus(7), minus(142), 6},
                                {kSigned, minus(1000), minus(7), 142, minus(6)},
                                {kSigned, 0x8000'0000, minus(1), 0x8000'0000, 0},
                                {kSigned, 5, 0, minus(1), 5},
                                {kSigned, minus(5), 0, 1, minus(5)}};
  SioDivider divider;
  std::uint64_t now = 100;
  for (const Division& division : divisions) {
    EXPECT_TRUE(divider.write(division.at, division.a, now));
    EXPECT_TRUE(divider.write(division.at + 4, division.b, now + 1));
    EXPECT_EQ(divider.read(kState, now + 8), 2u);
    EXPECT_FALSE(divider.read(kQuotient, now + 8));
    EXPECT_EQ(divider.read(kRemainder, now + 9), division.remainder);
    EXPECT_EQ(divider.read(kQuotient, now + 9), division.quotient) << division.a << " / " << division.b;
    EXPECT_EQ(divider.read(kState, now + 9), 1u);
    now += 20;
  }
  EXPECT_FALSE(divider.write(kState, 0, now));
}

TEST(Machine, RefusesWhatTheCoreLacks) {
  const std::vector<std::uint16_t> divide = {0xFBB1, 0xF0F2, 0xBE00}, square_root = {0xEEB1, 0x0AC0, 0xBE00};
  EXPECT_NE(fault(divide, "cortex-m0").find("an instruction that a Cortex-M0 lacks"), std::string::npos);
  EXPECT_EQ(fault(divide, "cortex-m3"), "none");
  EXPECT_NE(fault(square_root, "cortex-m3").find("an instruction that a Cortex-M3 lacks"), std::string::npos);
  EXPECT_EQ(fault(square_root, "cortex-m4"), "none");
  // movs r0, #0x20; lsls r0, r0, #24; adds r0, #1; ldr r1, [r0]
  const std::vector<std::uint16_t> unaligned = {0x2020, 0x0600, 0x3001, 0x6801, 0xBE00};
  EXPECT_NE(fault(unaligned, "cortex-m0plus").find("unaligned address 0x20000001"), std::string::npos);
  EXPECT_EQ(fault(unaligned, "cortex-m3"), "none");
}

TEST(Machine, GivesUpAtTheLimit) {
  RunOptions options;
  options.limit = 1000;
  // nop; b back
  EXPECT_THROW(run({0xBF00, 0xE7FD}, "cortex-m4", options), InputError);
  options.until = "nobody";
  EXPECT_THROW(run({0xBE00}, "cortex-m4", options), InputError);
  options.until.clear();
  // And where it waits for what never comes: ldr r0, =0xe000e010; ldr r1, [r0, #8]; b back
  try {
    run({0x4801, 0x6881, 0xE7FD, 0xBF00, 0xE010, 0xE000}, "cortex-m4", options);
    FAIL() << "waits for ever";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("has not stopped after"), std::string::npos) << error.what();
  }
}

TEST(Machine, MeasuresTheStack) {
  const RunReport report = run({0xB5F0, 0xB084, 0xB004, 0xBE00});  // push 5; sub sp, #16; add sp, #16
  EXPECT_EQ(report.stack_reached, 36u);
}

TEST(Board, UnknownNamesAreRefusedWithTheList) { EXPECT_THROW(board_named("toaster"), UsageError); }

TEST(Machine, RefusesAnImageForAnotherBoard) {
  EXPECT_NE(fault({0xBE00}, "pico").find("is for another board"), std::string::npos);
}

}  // namespace
}  // namespace spanline::host
