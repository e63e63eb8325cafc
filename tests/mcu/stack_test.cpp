// Stack bounds from machine code, assembled by arm-none-eabi-as; the functions' names are the symbols below.
#include <gtest/gtest.h>

#include <fstream>

#include "assetc/input_error.hpp"
#include "budget/stack_analysis.hpp"
#include "mcu/tiny_elf.hpp"

namespace spanline::host {
namespace {

struct Program {
  std::vector<std::uint16_t> code;
  std::vector<TinySymbol> symbols = {{"f", 0x41}};
  Core core = Core::m4;
  std::string notes = {};
};

StackBound bound_of(const Program& program) {
  TinyElf elf;
  elf.code = program.code;
  elf.symbols = program.symbols;
  const Image image(write_tiny_elf(elf, "stack.elf"));
  StackNotes notes;
  if (!program.notes.empty()) {
    const std::string path = temporary_file("notes.txt");
    std::ofstream(path) << program.notes;
    notes = read_stack_notes(image, path);
  }
  return stack_bound(image, program.core, TinyElf::kCode, notes);
}

TEST(StackBound, NamesTheDeepestPath) {
  // f: push {r4,lr}; sub sp,#24; bl g; add sp,#24; pop {r4,pc}. g: push {r4-r7,lr}; sub.w sp,#1024; add.w; pop
  const StackBound bound =
      bound_of({{0xB510, 0xB086, 0xF000, 0xF802, 0xB006, 0xBD10, 0xB5F0, 0xF5AD, 0x6D80, 0xF50D, 0x6D80, 0xBDF0},
                {{"f", 0x41}, {"g", 0x4D}}});
  EXPECT_EQ(bound.bytes, 8u + 24 + 20 + 1024);
  ASSERT_EQ(bound.path.size(), 2u);
  EXPECT_EQ(bound.path[0].function, "f");
  EXPECT_EQ(bound.path[0].bytes, 32u);
  EXPECT_EQ(bound.path[1].function, "g");
  EXPECT_EQ(bound.path[1].bytes, 1044u);
  EXPECT_TRUE(bound.problems.empty());
}

TEST(StackBound, ReadsFramesOutOfLiterals) {
  // push {r4,lr}; ldr r4,=-1000; add sp,r4; ldr r4,=1000; add sp,r4; pop {r4}; pop {r3}; bx r3
  const StackBound bound =
      bound_of({{0xB510, 0x4C03, 0x44A5, 0x4C03, 0x44A5, 0xBC10, 0xBC08, 0x4718, 0xFC18, 0xFFFF, 0x03E8, 0x0000},
                {{"f", 0x41, 16}},
                Core::m0});
  EXPECT_EQ(bound.bytes, 1008u);
  EXPECT_TRUE(bound.problems.empty());
}

TEST(StackBound, ReportsAFrameThatOnlyTheRunKnows) {
  // push {r7,lr}; add r7,sp,#0; sub sp,sp,r0; mov sp,r7; pop {r7,pc}
  const StackBound bound = bound_of({{0xB580, 0xAF00, 0xEBAD, 0x0D00, 0x46BD, 0xBD80}});
  ASSERT_EQ(bound.problems.size(), 1u);
  EXPECT_NE(bound.problems[0].find("at 0x00000044 in f"), std::string::npos) << bound.problems[0];
}

TEST(StackBound, ReportsALoopThatPushes) {
  EXPECT_EQ(bound_of({{0xBF00, 0xB401, 0x3801, 0xD1FC, 0x4770}}).problems.size(),
            1u);  // nop; 1: push {r0}; subs; bne 1b; bx lr
}

TEST(StackBound, WantsToKnowWherePointersGo) {
  // f: push {r4,lr}; blx r0; pop {r4,pc}. g: push {r4-r6,lr}; pop {r4-r6,pc}
  Program program{{0xB510, 0x4780, 0xBD10, 0xB570, 0xBD70}, {{"f", 0x41}, {"g", 0x47}}};
  const StackBound open = bound_of(program);
  ASSERT_EQ(open.problems.size(), 1u);
  EXPECT_EQ(open.problems[0], "a call through a pointer at 0x00000042 in f");
  program.notes = "# f is given g\nf calls g\n";
  EXPECT_TRUE(bound_of(program).problems.empty());
  EXPECT_EQ(bound_of(program).bytes, 8u + 16);
  program.notes = "f calls nothing";
  EXPECT_EQ(bound_of(program).bytes, 8u);
  program.notes = "f calls nobody";
  EXPECT_THROW(bound_of(program), InputError);
  program.notes = "f likes g";
  EXPECT_THROW(bound_of(program), InputError);
}

TEST(StackBound, WantsToKnowHowDeepRecursionGoes) {
  // push {r4,r5,lr}; sub sp,#4; subs r0,#1; beq 1f; bl f; 1: add sp,#4; pop {r4,r5,pc}
  Program program{{0xB530, 0xB081, 0x3801, 0xD001, 0xF7FF, 0xFFFA, 0xB001, 0xBD30}};
  ASSERT_EQ(bound_of(program).problems.size(), 1u);
  EXPECT_EQ(bound_of(program).problems[0], "recursion: f");
  program.notes = "f recurses 5";
  EXPECT_TRUE(bound_of(program).problems.empty());
  EXPECT_EQ(bound_of(program).bytes, 5u * 16);
  program.notes = "f recurses often";
  EXPECT_THROW(bound_of(program), InputError);
}

TEST(StackBound, FollowsTables) {
  // f: push {r4,lr}; cmp r0,#1; bhi 3f; tbb [pc,r0]; .byte 1,3; 1: bl g; b 3f; 2: bl h; 3: pop {r4,pc}; g: bx lr;
  // h: push {r0-r7}; pop {r0-r7}; bx lr
  const StackBound bound = bound_of({{0xB510, 0x2801, 0xD807, 0xE8DF, 0xF000, 0x0301, 0xF000, 0xF804, 0xE001, 0xF000,
                                      0xF802, 0xBD10, 0x4770, 0xB4FF, 0xBCFF, 0x4770},
                                     {{"f", 0x41},
                                      {"g", 0x59},
                                      {"h", 0x5B},
                                      {"$t", 0x40, 0, false},
                                      {"$d", 0x4A, 0, false},
                                      {"$t", 0x4C, 0, false}}});
  EXPECT_EQ(bound.bytes, 8u + 32);
  EXPECT_TRUE(bound.problems.empty());
}

TEST(StackBound, TakesAFarJumpForNoCall) {
  const StackBound bound =
      bound_of({{0xB510, 0xF000, 0xF801, 0x46C0, 0xBD10}, {{"f", 0x41}}, Core::m0});  // push; bl 1f; nop; 1: pop
  EXPECT_EQ(bound.bytes, 8u);
  EXPECT_TRUE(bound.problems.empty());
}

TEST(StackBound, AddsAnException) {
  TinyElf elf;
  elf.code = {0xBE00, 0xB510, 0xBD10};  // bkpt; tick: push {r4,lr}; pop {r4,pc}
  elf.symbols = {{"reset", 0x41, 2}, {"tick", 0x43, 4}};
  const auto bytes = [&](Core core) {
    return exception_bound(Image(write_tiny_elf(elf, "tick.elf")), core, 0, {}).bytes;
  };
  EXPECT_EQ(bytes(Core::m3), 0u);
  elf.tick = 0x43;
  EXPECT_EQ(bytes(Core::m3), 8u + 36);
  EXPECT_EQ(bytes(Core::m4), 8u + 108);

  StackBound bound{100, {{"reset", 100}}, {}};
  bound.add(exception_bound(Image(write_tiny_elf(elf, "tick.elf")), Core::m3, 0, {}));
  EXPECT_EQ(bound.bytes, 100u + 8 + 36);
  ASSERT_EQ(bound.path.size(), 2u);
  EXPECT_EQ(bound.path[1].function, "tick");
  EXPECT_EQ(bound.path[1].bytes, 8u + 36);
}

}  // namespace
}  // namespace spanline::host
