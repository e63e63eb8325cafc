// Every protocol error that the models of the SSD controllers know, made once.
#include "hal/hand.hpp"

namespace spanline::host {
namespace {

struct Grey : testing::Test, Hand {
  Grey() : Hand("ssd0323") {}
};
struct Mono : testing::Test, Hand {
  Mono() : Hand("ssd1306") {}
};

TEST_F(Grey, DataWithoutAWindow) {
  command(0x15, {0, 63});
  data({1});
  expect("data without a window");
}

TEST_F(Grey, DataPastTheWindow) {
  command(0x15, {0, 0});
  command(0x75, {0, 1});
  data({1, 2, 3});
  expect("data past the window");
}

TEST_F(Grey, AWindowBeyondTheMemory) {
  command(0x75, {0, 80});
  expect("window 0-80 of 80");
}

TEST_F(Grey, ArgumentsThatAreMissing) {
  command(0x15, {0, 63});
  command(0x75, {0});
  data({1});
  EXPECT_EQ(model().complaints().front(), "ssd0323: 75h with 1 of 2 arguments");
}

// QEMU 7.2 writes an error for this one.
TEST_F(Grey, AnUnknownCommand) {
  command(0xB4, {});
  expect("unknown command B4h");
}

TEST_F(Grey, TooFastAClock) {
  bus().set_clock(4'000'001);
  command(0xE3);
  expect("clock of 4000001 Hz");
}

TEST_F(Grey, RowsThatAreNotDriven) {
  command(0xA8, {31});
  command(0xAF);
  expect("display on with 32 of 64 rows");
}

TEST_F(Grey, VerticalIncrement) {
  command(0xA0, {0x04});
  expect("vertical increment");
}

TEST(Ssd1327Protocol, LockedCommands) {
  Hand hand("ssd1327");
  hand.command(0xFD, {0x16});
  hand.command(0xAE);
  hand.expect("AEh while commands are locked");
}

TEST_F(Mono, DisplayOnWithoutItsChargePump) {
  command(0xAF);
  expect("display on without its charge pump");
}

TEST_F(Mono, DataInPageAddressing) {
  command(0x21, {0, 127});
  command(0x22, {0, 7});
  data({1});
  expect("data while addresses do not run along the window");
}

}  // namespace
}  // namespace spanline::host
