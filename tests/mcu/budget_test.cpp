// The report of `spanline budget`, and how its command line answers what is wrong.
#include "budget/budget.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "host/support.hpp"
#include "mcu/tiny_elf.hpp"
#include "sim/output_file.hpp"

namespace spanline::host {
namespace {

// push {r4,lr}; bl f; bkpt; f: push {r4-r6,lr}; pop {r4-r6,pc}
TinyElf two_functions() {
  TinyElf elf;
  elf.code = {0xB510, 0xF000, 0xF801, 0xBE00, 0xB570, 0xBD70};
  elf.symbols = {{"reset", 0x41, 8}, {"f", 0x49, 4}, {"table", 0x44, 2, false}};
  return elf;
}

TEST(Budget, ReportsMemoryRunAndStack) {
  const Image image(write_tiny_elf(two_functions(), "budget.elf"));
  const BoardDescription& board = board_named("ek-lm3s6965");
  BudgetReport budget{&image, &board, memory_report(image, board), {}, {}, run_image(image, board, {}), {}};
  budget.stack = stack_bound(image, board.core, start_of(image, board).pc, {});
  const nlohmann::json json = nlohmann::json::parse(budget_json(budget));
  EXPECT_EQ(json["instructions"], 5);
  EXPECT_EQ(json["cycles"], 3 + 2 + 5 + 5 + 3 + 1);
  EXPECT_EQ(json["memory"]["flash"], 0x40 + 12);
  EXPECT_EQ(json["memory"]["ram"], 0);
  EXPECT_EQ(json["memory"]["symbols"].size(), 3u);
  EXPECT_EQ(json["functions"].size(), 2u);
  EXPECT_EQ(json["stack"]["bound"], 24);
  EXPECT_EQ(json["stack"]["reached"], 24);
  EXPECT_EQ(json["stack"]["path"][1]["function"], "f");
  EXPECT_NE(budget_text(budget).find("bound: 24 bytes by the code, 0 more than the run reached"), std::string::npos)
      << budget_text(budget);
}

TEST(Budget, GivesNoCyclesWhereThereIsNoTable) {
  const Image image(write_tiny_elf(two_functions(), "budget.elf"));
  const BoardDescription& board = board_named("cortex-m7");
  const BudgetReport budget{&image, &board, memory_report(image, board), {}, {}, run_image(image, board, {}), {}};
  EXPECT_TRUE(nlohmann::json::parse(budget_json(budget))["cycles"].is_null());
  EXPECT_NE(budget_text(budget).find("no cycle table for a Cortex-M7"), std::string::npos);
}

using Words = std::vector<std::string>;

TEST(BudgetCommand, WritesTheReport) {
  const std::string image = write_tiny_elf(two_functions(), "budget.elf");
  const TemporaryFolder folder;
  const ToolRun run =
      run_tool({"budget", image, "--board", "cortex-m3", "--until", "f", "--json", folder.file("b.json")});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("run: reached f\n  2 instructions, 5 core cycles"), std::string::npos) << run.out;
  EXPECT_EQ(folder.names(), Words{"b.json"});
}

TEST(BudgetCommand, SaysWhatIsWrong) {
  const std::string image = write_tiny_elf(two_functions(), "budget.elf");
  TinyElf pointer;
  pointer.code = {0xA001, 0x3001, 0x4780, 0xBE00, 0x4770};  // adr r0; adds r0, #1; blx r0; bkpt; bx lr
  const std::string through_pointer = write_tiny_elf(pointer, "pointer.elf");
  const TemporaryFolder folder;
  const auto refuse = [&](const Words& words, int code, const std::string& part) {
    const ToolRun run = run_tool(words);
    EXPECT_EQ(run.exit_code, code) << run.err;
    EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
  };
  refuse({"budget", image}, 2, "--board");
  refuse({"budget", image, "--board", "toaster"}, 2, "no board 'toaster'");
  refuse({"budget", image, "--board", "cortex-m3", "--limit", "none"}, 2, "--limit");
  refuse({"budget", image, "--board", "pico"}, 1, "is for another board");
  refuse({"budget", image, "--board", "cortex-m3", "--until", "nobody"}, 1, "has no symbol 'nobody'");
  refuse({"budget", folder.file("none.elf"), "--board", "cortex-m3"}, 1, "none.elf");
  refuse({"run", folder.file("none.elf"), "--board", "cortex-m3"}, 1, "none.elf");
  refuse({"budget", through_pointer, "--board", "cortex-m3"}, 1, "the stack is not bounded: a call through a pointer");
  EXPECT_EQ(run_tool({"budget", through_pointer, "--board", "cortex-m3", "--no-stack"}).exit_code, 0);
}

TEST(BudgetCommand, HoldsAnImageToItsLimits) {
  const std::string image = write_tiny_elf(two_functions(), "budget.elf");
  const TemporaryFolder folder;
  const std::string limits = folder.file("limits.json");
  const auto hold = [&](const std::string& how) {
    return run_tool({"budget", image, "--board", "cortex-m3", how, limits});
  };
  EXPECT_EQ(hold("--limits").exit_code, 1);  // there is no such file
  EXPECT_EQ(hold("--accept").exit_code, 0);
  EXPECT_EQ(hold("--limits").exit_code, 0);
  write_file(limits, R"({"budget": {"flash": {"limit": 10, "parts": {"libraries": 4}}, "ram": {"limit": 0},
                                    "stack": {"limit": 24}}})");
  const ToolRun over = hold("--limits");
  EXPECT_EQ(over.exit_code, 1);
  EXPECT_NE(over.out.find("over budget: budget on cortex-m3: flash 76 is over 10 by 66\n"), std::string::npos)
      << over.out;
  EXPECT_NE(over.out.find("over budget:   libraries: 14, was 4\n"), std::string::npos) << over.out;
  EXPECT_EQ(over.out.find("stack 24 is over"), std::string::npos);
  for (const char* broken : {"[]", "{", "{}", R"({"budget": {}})", R"({"budget": {"flash": {"limit": -1}}})"}) {
    write_file(limits, broken);
    EXPECT_EQ(hold("--limits").exit_code, 1) << broken;
  }
}

TEST(BudgetCommand, RefusesATableOfSomethingElse) {
  const TemporaryFolder folder;
  write_file(folder.file("a.json"), "{}");
  const ToolRun run = run_tool({"budget-table", folder.file("a.json")});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("is no report of"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace spanline::host
