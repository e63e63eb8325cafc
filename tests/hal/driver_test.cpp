// What drivers promise and refuse at compile time, and their arithmetic.
#include <gtest/gtest.h>

#include "hal/panel/panels.hpp"
#include "panel/models.hpp"
#include "panel/panel_run.hpp"

namespace spanline::hal {
namespace {

using R = Rotation;
using host::SimBus;
using host::SimClock;
using host::SimPin;

// A bus as plain as the concept allows: no choice of SPI mode.
struct PlainBus {
  std::uint32_t set_clock(std::uint32_t hz) { return hz; }
  Fault write(Slice<const std::uint8_t>) { return Fault::none; }
  Fault start(Slice<const std::uint8_t>) { return Fault::none; }
  Fault wait() { return Fault::none; }
};

using Full = Wires<SimBus, SimPin, SimPin, SimPin, SimClock>;
using Plain = Wires<PlainBus, NoPin, NoPin, NoPin, SimClock>;

static_assert(SpiBus<SimBus> && SpiModes<SimBus> && SpiReads<SimBus> && SpiBus<PlainBus> && !SpiModes<PlainBus>);
static_assert(OutPin<SimPin> && OutPin<NoPin> && Clock<SimClock>);

template <template <Rotation, typename> class Driver, Rotation kRotation, typename Wiring>
concept Offered = requires {
  typename Driver<kRotation, Wiring>;
};

template <template <Rotation, typename> class Driver>
constexpr bool every_turn() {
  return Panel<Driver<R::r0, Full>> && Panel<Driver<R::r90, Full>> && Panel<Driver<R::r180, Full>> &&
         Panel<Driver<R::r270, Full>> && Panel<Driver<R::r0, Plain>>;
}
template <template <Rotation, typename> class Driver>
constexpr bool half_turns_only() {
  return Panel<Driver<R::r0, Full>> && Panel<Driver<R::r180, Full>> && Panel<Driver<R::r0, Plain>> &&
         !Offered<Driver, R::r90, Full> && !Offered<Driver, R::r270, Full>;
}
static_assert(every_turn<Ili9341>() && every_turn<St7789>() && every_turn<St7789Square>() &&
              every_turn<St7789Narrow>());
static_assert(every_turn<Gc9a01>() && every_turn<Ili9488>() && every_turn<St7796>());
static_assert(half_turns_only<Ssd0323>() && half_turns_only<Ssd1325>() && half_turns_only<Ssd1327>());
static_assert(half_turns_only<Ssd1306>());

// A panel that needs SPI mode 3 refuses a bus that cannot have it.
constexpr DcsTraits kMode3 = [] {
  DcsTraits traits = kSt7789Square;
  traits.spi_mode = 3;
  return traits;
}();
template <Rotation kRotation, typename Wiring>
using Mode3 = DcsPanel<kMode3, kRotation, Wiring>;
static_assert(Offered<Mode3, R::r0, Full> && !Offered<Mode3, R::r0, Plain>);

// Drivers need no code to run before main.
PlainBus plain_bus;
SimClock any_clock;
constexpr Plain plain_wires() { return {plain_bus, {}, {}, {}, any_clock}; }
constinit Ili9341<R::r90, Plain> colour_at_rest(plain_wires());
constinit Ili9488<R::r90, Plain> wide_at_rest(plain_wires());
constinit Ssd0323<R::r180, Plain> grey_at_rest(plain_wires());
constinit Ssd1306<R::r0, Plain> mono_at_rest(plain_wires());

TEST(Driver, BeginsFromRest) {
  EXPECT_EQ(colour_at_rest.begin(), Fault::none);
  EXPECT_EQ(wide_at_rest.begin(), Fault::none);
  EXPECT_EQ(grey_at_rest.begin(), Fault::none);
  EXPECT_EQ(mono_at_rest.begin(), Fault::none);
}

// Without a reset line the colour controllers are reset by command, with the waits that the model asks for.
TEST(Driver, ManagesWithoutAResetLine) {
  SimClock clock;
  for (const char* name : {"st7789", "ssd0323"}) {
    const std::unique_ptr<host::PanelModel> model = host::make_model(name, clock);
    host::Bench bench{.model = *model, .clock = clock};
    SimBus bus(bench);
    const Wires wires(bus, SimPin(bench, SimPin::data), SimPin(bench, SimPin::select), NoPin{}, clock);
    using Wiring = std::remove_const_t<decltype(wires)>;
    if (name[2] == '7') {
      EXPECT_EQ((St7789<R::r0, Wiring>(wires).begin()), Fault::none);
    } else {
      EXPECT_EQ((Ssd0323<R::r0, Wiring>(wires).begin()), Fault::none);
    }
    EXPECT_EQ(model->complaints(), std::vector<std::string>{}) << name;
  }
}

TEST(Driver, SizesFollowTheRotation) {
  EXPECT_EQ((St7789Narrow<R::r0, Full>::width()), 135);
  EXPECT_EQ((St7789Narrow<R::r90, Full>::width()), 240);
  EXPECT_EQ((St7789Narrow<R::r90, Full>::height()), 135);
  EXPECT_EQ((St7796<R::r270, Full>::kLineBytes), 960u);
  EXPECT_EQ((Ssd0323<R::r180, Full>::kLineBytes), 64u);
  EXPECT_EQ((Ssd1306<R::r0, Full>::kLineBytes), 16u);
}

TEST(Driver, MadctlOfTheCommonPanelsIsWhatTheTradeUses) {
  EXPECT_EQ(madctl(kIli9341, R::r0), 0x48);
  EXPECT_EQ(madctl(kIli9341, R::r90), 0x28);
  EXPECT_EQ(madctl(kIli9341, R::r180), 0x88);
  EXPECT_EQ(madctl(kIli9341, R::r270), 0xE8);
  EXPECT_EQ(madctl(kSt7789, R::r0), 0x00);
  EXPECT_EQ(madctl(kSt7789, R::r90), 0x60);
  EXPECT_EQ(madctl(kSt7789, R::r180), 0xC0);
  EXPECT_EQ(madctl(kSt7789, R::r270), 0xA0);
}

TEST(Driver, OffsetsBelongToTheRotation) {
  EXPECT_EQ(origin(kSt7789Square, R::r0), (Origin{0, 0}));
  EXPECT_EQ(origin(kSt7789Square, R::r90), (Origin{0, 0}));
  EXPECT_EQ(origin(kSt7789Square, R::r180), (Origin{0, 80}));
  EXPECT_EQ(origin(kSt7789Square, R::r270), (Origin{80, 0}));
  EXPECT_EQ(origin(kSt7789Narrow, R::r0), (Origin{52, 40}));
  EXPECT_EQ(origin(kSt7789Narrow, R::r90), (Origin{40, 53}));
  EXPECT_EQ(origin(kSt7789Narrow, R::r180), (Origin{53, 40}));
  EXPECT_EQ(origin(kSt7789Narrow, R::r270), (Origin{40, 52}));
}

TEST(Driver, RemapAndOffsetOfTheGreyPanelsAreWhatTheTradeUses) {
  EXPECT_EQ(ssd_remap(kSsd0323, R::r0), 0x52);
  EXPECT_EQ(ssd_remap(kSsd0323, R::r180), 0x41);
  EXPECT_EQ(ssd_offset(kSsd0323, R::r0), 0x40);
  EXPECT_EQ(ssd_offset(kSsd0323, R::r180), 0x00);
  EXPECT_EQ(ssd_offset(kSsd1325, R::r0), 0x4C);
  EXPECT_EQ(ssd_remap(kSsd1327, R::r0), 0x51);
  EXPECT_EQ(ssd_remap(kSsd1327, R::r180), 0x42);
  EXPECT_EQ(ssd_offset(kSsd1327, R::r0), 0x00);
}

TEST(Driver, ReportsTheClockThatTheBusReached) {
  struct SlowBus : PlainBus {
    std::uint32_t set_clock(std::uint32_t hz) { return hz < 37'500'000 ? hz : 37'500'000; }
  };
  SlowBus bus;
  SimClock clock;
  St7789<R::r0, Wires<SlowBus, NoPin, NoPin, NoPin, SimClock>> panel(
      Wires<SlowBus, NoPin, NoPin, NoPin, SimClock>(bus, {}, {}, {}, clock));
  EXPECT_EQ(panel.clock_hz(), 0u);
  EXPECT_EQ(panel.begin(), Fault::none);
  EXPECT_EQ(panel.kMaxClockHz, 62'500'000u);
  EXPECT_EQ(panel.clock_hz(), 37'500'000u);
}

TEST(Driver, FindsAPanelAbsentWhereItCanAsk) {
  for (const char* name : {"ili9341", "ili9488", "st7796"}) {
    for (const std::uint8_t floating : {std::uint8_t{0xFF}, std::uint8_t{0x00}}) {
      const auto run = host::PanelRun::make(name, R::r0);
      run->bus().unplug(floating);
      EXPECT_EQ(run->begin(), Fault::panel_absent) << name;
    }
  }
}

TEST(Driver, WidensToTheWholeRange) {
  Widener widener;
  const std::uint8_t line[] = {0xFF, 0xFF, 0x00, 0x00, 0x84, 0x10};
  const Slice<const std::uint8_t> wide = widener.widen(line, 0);
  const std::uint8_t expected[] = {0xFC, 0xFC, 0xFC, 0, 0, 0, 0x84, 0x80, 0x84};
  ASSERT_EQ(wide.size(), sizeof expected);
  for (std::uint32_t i = 0; i < wide.size(); ++i) EXPECT_EQ(wide[i], expected[i]) << i;
}

}  // namespace
}  // namespace spanline::hal
