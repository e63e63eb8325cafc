// Every protocol error that the models of the colour controllers know, made once.
#include <algorithm>

#include "hal/hand.hpp"

namespace spanline::host {
namespace {

struct Colour : testing::Test, Hand {
  Colour() : Hand("ili9341") {}
};

TEST_F(Colour, AProperConversationIsSilent) {
  wake();
  window(1, 1);
  command(0x2C);
  data({1, 2, 3, 4, 5, 6, 7, 8});
  EXPECT_TRUE(model().complaints().empty());
}

TEST_F(Colour, TooFastAClock) {
  bus().set_clock(40'000'001);
  command(0x00);
  expect("clock of 40000001 Hz, allowed are 40000000");
}

TEST_F(Colour, AnotherSpiMode) {
  bus().set_mode(3);
  command(0x00);
  expect("SPI mode 3");
}

TEST_F(Colour, AByteWhileNotSelected) {
  select().set(true);
  command(0x00);
  expect("byte while not selected");
}

TEST_F(Colour, AByteDuringReset) {
  reset().set(false);
  command(0x00);
  expect("byte during reset");
}

TEST_F(Colour, AByteTooSoonAfterAReset) {
  reset().set(false);
  wait_ms(1);
  reset().set(true);
  wait_ms(4);
  command(0x00);
  expect("byte too soon after a reset");
}

TEST_F(Colour, AResetPulseTooShort) {
  reset().set(false);
  reset().set(true);
  expect("reset pulse too short");
}

TEST_F(Colour, SleepOutTooSoonAfterAReset) {
  command(0x01);
  wait_ms(119);
  command(0x11);
  expect("SLPOUT less than 120 ms after a reset");
}

TEST_F(Colour, ACommandTooSoonAfterSleepOut) {
  command(0x11);
  wait_ms(4);
  command(0x00);
  expect("command too soon after SLPOUT");
}

TEST_F(Colour, DisplayOnTooSoonAfterSleepOut) {
  command(0x11);
  wait_ms(119);
  command(0x29);
  expect("29h less than 120 ms after SLPOUT");
}

TEST_F(Colour, DisplayOnWhileAsleep) {
  command(0x29);
  expect("DISPON while asleep");
}

TEST_F(Colour, SleepOutWhileAwake) {
  wake();
  command(0x11);
  expect("SLPOUT while awake");
}

TEST_F(Colour, MemoryWriteWhileAsleep) {
  window(1, 1);
  command(0x2C);
  expect("RAMWR while asleep");
}

TEST_F(Colour, MemoryWriteWithoutAWindow) {
  wake();
  command(0x2A, {0, 0, 0, 1});
  command(0x2C);
  expect("RAMWR without a window");
}

TEST_F(Colour, TurnedAxesNeedAnotherWindow) {
  wake();
  window(1, 1);
  command(0x36, {0x20});
  command(0x2C);
  expect("RAMWR without a window");
}

TEST_F(Colour, DataThatNoCommandTakes) {
  wake();
  data({1});
  expect("data that no command takes");
}

TEST_F(Colour, APixelPastTheWindow) {
  wake();
  window(0, 0);
  command(0x2C);
  data({1, 2, 3});
  expect("pixel past the window");
}

TEST_F(Colour, HalfAPixel) {
  wake();
  window(1, 1);
  command(0x2C);
  data({1, 2, 3});
  command(0x00);
  expect("half a pixel");
}

TEST_F(Colour, AWindowBeyondTheMemory) {
  wake();
  window(240, 0);
  expect("window 0-240 of 240");
}

TEST_F(Colour, AWindowWithItsEndsSwapped) {
  wake();
  command(0x2A, {0, 9, 0, 8});
  expect("window 9-8 of 240");
}

TEST_F(Colour, ArgumentsThatAreMissing) {
  command(0x2A, {0, 0, 0});
  command(0x00);
  expect("2Ah with 3 of 4 arguments");
}

TEST_F(Colour, AnUnknownCommand) {
  command(0x7E);
  expect("unknown command 7Eh");
}

TEST_F(Colour, AnOddColourDepth) {
  command(0x3A, {0x53});
  expect("COLMOD 53h is neither 16 nor 18 bits");
}

TEST_F(Colour, APinThatMovesInFlight) {
  const std::uint8_t byte[] = {0};
  bus().start(byte);
  select().set(true);
  expect("pin moved with a transfer in flight");
}

TEST_F(Colour, AWriteWithATransferInFlight) {
  const std::uint8_t byte[] = {0};
  bus().start(byte);
  bus().write(byte);
  expect("bus written to with a transfer in flight");
}

TEST_F(Colour, AReadThatNoCommandAnswers) {
  command(0x00);
  EXPECT_EQ(read(), 0xFF);
  expect("read that no command answers");
}

TEST_F(Colour, AReadTooFast) {
  command(0x0A);
  bus().set_clock(10'000'000);
  read();
  expect("read at 10000000 Hz");
}

TEST(Ili9488Protocol, SixteenBitColour) {
  Hand hand("ili9488");
  hand.command(0x3A, {0x55});
  hand.expect("16-bit colour");
}

TEST(St7796Protocol, ALockedCommandSet) {
  Hand hand("st7796");
  hand.command(0xF0, {0xC3});
  hand.command(0xF0, {0x96});
  hand.command(0xB4, {0x01});
  EXPECT_TRUE(hand.model().complaints().empty());
  hand.command(0xF0, {0x69});
  hand.command(0xB4, {0x01});
  hand.expect("B4h while its command set is locked");
}

TEST(Gc9a01Protocol, ALockedCommandSet) {
  Hand hand("gc9a01");
  hand.command(0xB6, {0x00, 0x20});
  hand.expect("B6h while its command set is locked");
}

// A glass that is dark: asleep, or switched off.
TEST_F(Colour, AsleepOrOffIsDark) {
  wake();
  window(239, 0);
  command(0x2C);
  data({0xFF, 0xFF});
  const auto lit = [this] {
    const Picture picture = model().picture();
    return std::any_of(picture.rgb.begin(), picture.rgb.end(), [](std::uint8_t v) { return v != 0; });
  };
  EXPECT_TRUE(lit());
  command(0x28);
  EXPECT_FALSE(lit());
  command(0x29);
  EXPECT_TRUE(lit());
  command(0x10);
  EXPECT_FALSE(lit());
}

}  // namespace
}  // namespace spanline::host
