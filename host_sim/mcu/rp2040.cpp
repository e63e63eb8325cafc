// RP2040 (datasheet RP-008371-DS): resets, clocks, crystal, system PLL, pins, SPI0 with DMA channel 0, the serial
// flash.
#include "mcu/chip.hpp"
#include "mcu/pl022.hpp"
#include "mcu/sio_divider.hpp"

namespace spanline::host {
namespace {

constexpr std::uint32_t kRingKilohertz = 6'500, kCrystalKilohertz = 12'000;

// Blocks of the reset controller.
enum Block : std::uint32_t { kDmaBlock = 2, kIoBank0 = 5, kPadsBank0 = 8, kPllSys = 12, kSpi0 = 16 };

class Resets final : public RegisterBank {
 public:
  Resets() : RegisterBank("RESETS", 0x4000'C000, 0x1000, {{kReset, 0x01FF'FFFF}}) {}
  bool released(Block block) const { return (at(kReset) >> block & 1) == 0; }
  std::optional<std::uint32_t> read(std::uint32_t offset) override {
    return offset == kDone ? std::optional(~at(kReset) & 0x01FF'FFFF) : RegisterBank::read(offset);
  }

 private:
  static constexpr std::uint32_t kReset = 0, kDone = 8;
};

// Registers of a block that must have left reset.
class Held : public RegisterBank {
 public:
  Held(const char* name, std::uint32_t base, std::initializer_list<Reset> registers, const Resets& resets, Block block)
      : RegisterBank(name, base, 0x1000, registers), resets_(resets), block_(block) {}
  bool alive() const override { return resets_.released(block_); }

 private:
  const Resets& resets_;
  Block block_;
};

class Crystal final : public RegisterBank {
 public:
  Crystal() : RegisterBank("XOSC", 0x4002'4000, 0x1000, {{kControl, 0}, {kStartup, 0xC4}}) {}
  bool runs() const { return (at(kControl) & 0xFF'FFFF) == 0xFA'BAA0; }
  std::optional<std::uint32_t> read(std::uint32_t offset) override {
    constexpr std::uint32_t kState = 4, kStable = 1u << 31;
    return offset == kState ? std::optional(runs() ? kStable : 0u) : RegisterBank::read(offset);
  }

 private:
  static constexpr std::uint32_t kControl = 0, kStartup = 0xC;
};

class Pll final : public Held {
 public:
  Pll(const Crystal& crystal, const Resets& resets, std::function<void(const std::string&)> complain)
      : Held("PLL_SYS", 0x4002'8000, {{kControl, 1}, {kPower, 0x2D}, {kFeedback, 0}, {kDivide, 0x7'7000}}, resets,
             kPllSys),
        crystal_(crystal),
        complain_(std::move(complain)) {}

  std::uint32_t kilohertz() const {
    const std::uint32_t divide = at(kDivide), first = divide >> 16 & 7, second = divide >> 12 & 7;
    return locked() && first != 0 && second != 0 ? oscillator() / first / second : 0;
  }
  std::optional<std::uint32_t> read(std::uint32_t offset) override {
    const std::optional<std::uint32_t> value = Held::read(offset);
    constexpr std::uint32_t kLock = 1u << 31;
    return value && offset == kControl && locked() ? *value | kLock : value;
  }
  bool write(std::uint32_t offset, std::uint32_t value) override {
    if (!Held::write(offset, value)) return false;
    if (offset == kPower && locked() && (oscillator() < 750'000 || oscillator() > 1'600'000)) {
      complain_("PLL_SYS's oscillator is not at 750 to 1600 MHz");
    }
    return true;
  }

 private:
  static constexpr std::uint32_t kControl = 0, kPower = 4, kFeedback = 8, kDivide = 0xC;
  bool locked() const {
    constexpr std::uint32_t kDown = 1u << 0 | 1u << 5;
    return crystal_.runs() && (at(kPower) & kDown) == 0 && at(kFeedback) >= 16;
  }
  std::uint32_t oscillator() const { return kCrystalKilohertz / (at(kControl) & 63) * at(kFeedback); }

  const Crystal& crystal_;
  std::function<void(const std::string&)> complain_;
};

class Clocks final : public RegisterBank {
 public:
  Clocks(const Pll& pll, std::function<void(std::uint32_t)> set_clock, std::function<void(const std::string&)> complain)
      : RegisterBank("CLOCKS", 0x4000'8000, 0x1000,
                     {{kReference, 0}, {kSystem, 0}, {kDivide, 0x100}, {kPeripheral, 0}}),
        pll_(pll),
        set_clock_(std::move(set_clock)),
        complain_(std::move(complain)) {}

  bool feeds_peripherals() const { return (at(kPeripheral) & (1u << 11 | 7u << 5)) == 1u << 11; }

  std::optional<std::uint32_t> read(std::uint32_t offset) override {
    if (offset == kReferenceSelected) return 1u << (at(kReference) & 3);
    if (offset == kSystemSelected) return 1u << (at(kSystem) & 1);
    return RegisterBank::read(offset);
  }
  bool write(std::uint32_t offset, std::uint32_t value) override {
    if (!RegisterBank::write(offset, value)) return false;
    const bool from_crystal = (at(kReference) & 3) == 2, from_pll = (at(kSystem) & 1) != 0;
    const std::uint32_t reference = from_crystal ? kCrystalKilohertz : kRingKilohertz;
    const std::uint32_t kilohertz = from_pll ? pll_.kilohertz() : reference;
    if (from_pll && (at(kSystem) >> 5 & 7) != 0) complain_("the core's clock comes from a source that is not modelled");
    if (kilohertz == 0) complain_("the core is switched to a clock that does not run");
    if (kilohertz > 133'000) complain_("the core runs at " + std::to_string(kilohertz) + " kHz, 133000 are allowed");
    if (kilohertz != 0) set_clock_(kilohertz);
    return true;
  }

 private:
  static constexpr std::uint32_t kReference = 0x30, kReferenceSelected = 0x38, kSystem = 0x3C, kDivide = 0x40,
                                 kSystemSelected = 0x44, kPeripheral = 0x48;
  const Pll& pll_;
  std::function<void(std::uint32_t)> set_clock_;
  std::function<void(const std::string&)> complain_;
};

constexpr unsigned kPins = 30;

// Who owns each pin, and what the core drives it to.
class PinBank {
 public:
  using SetPin = std::function<void(unsigned number, bool level)>;
  using GivePin = std::function<void(unsigned number, bool to_port)>;
  PinBank(SetPin set_pin, GivePin give_pin) : set_pin_(std::move(set_pin)), give_pin_(std::move(give_pin)) {}

  void change(std::uint32_t set, std::uint32_t clear, std::uint32_t enable) {
    level_ = (level_ & ~clear) | set;
    enabled_ |= enable;
    for (unsigned i = 0; i < kPins; ++i) update(i);
  }
  void give(unsigned number, std::uint32_t function) {
    functions_[number] = function;
    update(number);
  }

 private:
  void update(unsigned number) {
    constexpr std::uint32_t kSpi = 1, kSio = 5;
    give_pin_(number, functions_[number] == kSpi);
    const bool driven = functions_[number] == kSio && (enabled_ >> number & 1) != 0;
    if (driven) set_pin_(number, (level_ >> number & 1) != 0);
  }

  SetPin set_pin_;
  GivePin give_pin_;
  std::uint32_t level_ = 0, enabled_ = 0;
  std::uint32_t functions_[kPins] = {};
};

class IoBank final : public Held {
 public:
  IoBank(PinBank& pins, const Resets& resets) : Held("IO_BANK0", 0x4001'4000, {}, resets, kIoBank0), pins_(pins) {}
  std::optional<std::uint32_t> read(std::uint32_t) override { return std::nullopt; }
  bool write(std::uint32_t offset, std::uint32_t value) override {
    if (offset >= 8 * kPins || offset % 8 != 4) return false;
    pins_.give(offset / 8, value & 31);
    return true;
  }

 private:
  PinBank& pins_;
};

class Pads final : public Held {
 public:
  explicit Pads(const Resets& resets) : Held("PADS_BANK0", 0x4001'C000, {}, resets, kPadsBank0) {}
  std::optional<std::uint32_t> read(std::uint32_t) override { return std::nullopt; }
  bool write(std::uint32_t offset, std::uint32_t) override { return offset >= 4 && offset < 4 + 4 * kPins; }
};

class SingleCycleIo final : public Peripheral {
 public:
  SingleCycleIo(PinBank& pins, std::function<std::uint64_t()> now)
      : Peripheral("SIO", 0xD000'0000, 0x1000), pins_(pins), now_(std::move(now)) {}
  std::optional<std::uint32_t> read(std::uint32_t offset) override {
    const std::uint32_t of_divider = offset - SioDivider::kOffset;
    return of_divider < SioDivider::kBytes ? divider_.read(of_divider, now_()) : std::nullopt;
  }
  bool write(std::uint32_t offset, std::uint32_t value) override {
    const std::uint32_t of_divider = offset - SioDivider::kOffset;
    if (of_divider < SioDivider::kBytes) return divider_.write(of_divider, value, now_());
    constexpr std::uint32_t kSet = 0x14, kClear = 0x18, kEnable = 0x24;
    if (offset != kSet && offset != kClear && offset != kEnable) return false;
    pins_.change(offset == kSet ? value : 0, offset == kClear ? value : 0, offset == kEnable ? value : 0);
    return true;
  }

 private:
  PinBank& pins_;
  std::function<std::uint64_t()> now_;
  SioDivider divider_;
};

// The serial flash's interface: what a line of the execute-in-place cache costs follows from it. Each of the line's two
// words is a command, an address and 32 bits on one data wire.
class FlashPort final : public RegisterBank {
 public:
  explicit FlashPort(std::function<void(unsigned)> set_miss)
      : RegisterBank("XIP_SSI", 0x1800'0000, 0x1000,
                     {{kControl0, 0}, {kControl1, 0}, {kEnable, 0}, {kDivider, 0}, {kSpiControl0, 0}}),
        set_miss_(std::move(set_miss)) {}
  bool write(std::uint32_t offset, std::uint32_t value) override {
    if (!RegisterBank::write(offset, value)) return false;
    constexpr unsigned kCommand = 8, kAddress = 24, kWord = 32, kWords = 2;
    if (offset == kEnable && (value & 1) != 0) set_miss_(kWords * (kCommand + kAddress + kWord) * at(kDivider));
    return true;
  }

 private:
  static constexpr std::uint32_t kControl0 = 0, kControl1 = 4, kEnable = 8, kDivider = 0x14, kSpiControl0 = 0xF4;
  std::function<void(unsigned)> set_miss_;
};

// Channel 0, bytes from memory to the serial port.
class Dma final : public Held {
 public:
  Dma(std::uint32_t target, DmaTransfer& transfer, const Resets& resets,
      std::function<void(const std::string&)> complain, std::function<void()> start)
      : Held("DMA", 0x5000'0000, {{kFrom, 0}, {kTo, 0}, {kCount, 0}, {kAbort, 0}}, resets, kDmaBlock),
        target_(target),
        transfer_(transfer),
        complain_(std::move(complain)),
        start_(std::move(start)) {}

  std::optional<std::uint32_t> read(std::uint32_t offset) override {
    constexpr std::uint32_t kBusy = 1u << 24, kReadError = 1u << 30, kBusError = 1u << 31;
    if (offset == kAbort) return 0;
    if (offset != kTrigger) return Held::read(offset);
    return control_ | (transfer_.active ? kBusy : 0) | (transfer_.failed ? kReadError | kBusError : 0);
  }
  bool write(std::uint32_t offset, std::uint32_t value) override {
    if (offset == kAbort) transfer_.active = false;
    if (offset != kTrigger) return Held::write(offset, value);
    constexpr std::uint32_t kEnable = 1, kStep = 1u << 4, kWriteStep = 1u << 5, kSpi0Transmit = 16;
    control_ = value & 0x00FF'FFFF;
    if ((value & kEnable) == 0) return true;
    if ((value >> 2 & 3) != 0 || (value & kWriteStep) != 0 || (value >> 15 & 63) != kSpi0Transmit ||
        at(kTo) != target_) {
      complain_("DMA does not feed bytes to SPI0");
    }
    transfer_ = {true, at(kFrom), at(kCount), (value & kStep) != 0, false};
    start_();
    return true;
  }

 private:
  static constexpr std::uint32_t kFrom = 0, kTo = 4, kCount = 8, kTrigger = 0xC, kAbort = 0x444;
  std::uint32_t target_;
  DmaTransfer& transfer_;
  std::function<void(const std::string&)> complain_;
  std::function<void()> start_;
  std::uint32_t control_ = 0;
};

class Rp2040 final : public Chip {
 public:
  Rp2040(const BoardDescription& board, ReadByte read)
      : Chip(board, kRingKilohertz, Pl022::kFifo, std::move(read)),
        pins_(
            [this](unsigned number, bool level) {
              set_pin({'P', number}, level);
            },
            [this](unsigned number, bool to_port) {
              give_pin({'P', number}, to_port);
            }) {
    // 16 KB in two ways of 8-byte lines, for code and data.
    memory_ =
        MemoryTiming({.base = 0x1000'0000, .size = 0x0100'0000, .line_bits = 3, .code_sets = 1024, .code_ways = 2});
    const auto complain_of = [this](const std::string& what) { complain(what); };
    constexpr std::uint32_t kSpi0Base = 0x4003'C000;
    const Resets& resets = add<Resets>();
    const Crystal& crystal = add<Crystal>();
    const Pll& pll = add<Pll>(crystal, resets, complain_of);
    const Clocks& clocks = add<Clocks>(
        pll, [this](std::uint32_t kilohertz) { run_at(kilohertz); }, complain_of);
    add<IoBank>(pins_, resets);
    add<Pads>(resets);
    add<SingleCycleIo>(pins_, [this] { return now_; });
    add<FlashPort>([this](unsigned cycles) { memory_.set_miss(cycles); });
    add<Dma>(kSpi0Base + 8, dma_, resets, complain_of, [this] { feed(now_); });
    add<Pl022>("SPI0", kSpi0Base, port_,
               Pl022::Around{[this] { return now_; }, [this] { return clock_.kilohertz(); },
                             [&resets, &clocks] { return resets.released(kSpi0) && clocks.feeds_peripherals(); },
                             complain_of, [this](bool wanted) { dma_wanted_ = wanted; }});
  }

 private:
  PinBank pins_;
};

}  // namespace

std::unique_ptr<Chip> make_rp2040(const BoardDescription& board, ReadByte read) {
  return std::make_unique<Rp2040>(board, std::move(read));
}

}  // namespace spanline::host
