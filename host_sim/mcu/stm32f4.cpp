// STM32F4 (RM0090, RM0383): GPIO ports, SPI1 and SPI5, the streams of DMA2 that feed them.
#include "mcu/chip.hpp"
#include "mcu/stm32f4_clock.hpp"

namespace spanline::host {
namespace {

constexpr std::uint32_t kDma2 = 1u << 22;  // of AHB1's gates
constexpr std::uint32_t kDmaBase = 0x4002'6400;

class Port final : public RegisterBank {
 public:
  using SetPin = std::function<void(unsigned number, bool level)>;
  using GivePin = std::function<void(unsigned number, bool to_port)>;

  Port(char letter, const Stm32Rcc& rcc, SetPin set_pin, GivePin give_pin)
      : RegisterBank(std::string("GPIO") + letter, base(letter), 0x400,
                     {{kMode, letter == 'A'   ? 0xA800'0000u
                              : letter == 'B' ? 0x280u
                                              : 0u},
                      {kSpeed, 0},
                      {kPull, 0},
                      {kFunctionLow, 0},
                      {kFunctionHigh, 0}}),
        gate_(1u << (letter - 'A')),
        rcc_(rcc),
        set_pin_(std::move(set_pin)),
        give_pin_(std::move(give_pin)) {}

  bool alive() const override { return rcc_.ahb1(gate_); }

  bool write(std::uint32_t offset, std::uint32_t value) override {
    if (offset == kSetReset) {
      level_ = (level_ & ~(value >> 16)) | (value & 0xFFFF);
    } else if (!RegisterBank::write(offset, value)) {
      return false;
    }
    for (unsigned i = 0; i < 16; ++i) {
      constexpr std::uint32_t kOutput = 1, kAlternate = 2, kSpi = 5;
      const std::uint32_t mode = at(kMode) >> 2 * i & 3;
      const std::uint32_t function = at(i < 8 ? kFunctionLow : kFunctionHigh) >> 4 * (i % 8) & 15;
      give_pin_(i, mode == kAlternate && function == kSpi);
      if (mode == kOutput) set_pin_(i, (level_ >> i & 1) != 0);
    }
    return true;
  }

 private:
  static constexpr std::uint32_t kMode = 0x00, kSpeed = 0x08, kPull = 0x0C, kSetReset = 0x18, kFunctionLow = 0x20,
                                 kFunctionHigh = 0x24;
  static std::uint32_t base(char letter) { return 0x4002'0000 + 0x400 * static_cast<std::uint32_t>(letter - 'A'); }

  std::uint32_t gate_, level_ = 0;
  const Stm32Rcc& rcc_;
  SetPin set_pin_;
  GivePin give_pin_;
};

// What the peripherals of the port below need of their chip.
struct Around {
  std::function<std::uint64_t()> now;
  std::function<std::uint32_t()> kilohertz;
  std::function<void(const std::string&)> complain;
};

class Spi final : public RegisterBank {
 public:
  Spi(const char* name, std::uint32_t base, std::uint32_t gate, SerialPort& port, const Stm32Rcc& rcc, Around around,
      std::function<void(bool)> want_dma)
      : RegisterBank(name, base, 0x400, {{kControl1, 0}, {kControl2, 0}}),
        gate_(gate),
        port_(port),
        rcc_(rcc),
        around_(std::move(around)),
        want_dma_(std::move(want_dma)) {}

  bool alive() const override { return rcc_.apb2(gate_); }

  std::optional<std::uint32_t> read(std::uint32_t offset) override {
    constexpr std::uint32_t kReceived = 1, kEmpty = 1u << 1, kBusy = 1u << 7;
    if (offset == kData) return port_.take_received();
    if (offset != kState) return RegisterBank::read(offset);
    return (port_.has_received() ? kReceived : 0) | (port_.full() ? 0 : kEmpty) | (port_.busy() ? kBusy : 0);
  }

  bool write(std::uint32_t offset, std::uint32_t value) override {
    constexpr std::uint32_t kMaster = 1u << 2, kEnable = 1u << 6, kSelected = 3u << 8, kTransmitDma = 1u << 1;
    constexpr std::uint32_t kOneLine = 1u << 15, kDrive = 1u << 14;
    if (offset == kData) {
      if ((at(kControl1) & kEnable) == 0) around_.complain(name() + " is given data while off");
      if (port_.full()) around_.complain(name() + " is given data while its buffer is full");
      port_.push(static_cast<std::uint8_t>(value), around_.now());
      return true;
    }
    if (!RegisterBank::write(offset, value)) return false;
    if (offset == kControl2) want_dma_((value & kTransmitDma) != 0);
    if (offset != kControl1) return true;
    if ((value & kEnable) == 0) {
      port_.listen(false, around_.now());
      return true;
    }
    if ((value & (kMaster | kSelected)) != (kMaster | kSelected)) around_.complain(name() + " is no master");
    if ((value & ~(3u | 7u << 3 | kMaster | kEnable | kSelected | kOneLine | kDrive)) != 0) {
      around_.complain(name() + " is in a format that is not modelled");
    }
    const std::uint32_t divisor = rcc_.apb2_divisor() << ((value >> 3 & 7) + 1);  // of the core's clock
    port_.set(std::uint64_t{8} * divisor, around_.kilohertz() * 1000 / divisor, value & 3);
    port_.listen((value & (kOneLine | kDrive)) == kOneLine, around_.now());
    return true;
  }

 private:
  static constexpr std::uint32_t kControl1 = 0x00, kControl2 = 0x04, kState = 0x08, kData = 0x0C;
  std::uint32_t gate_;
  SerialPort& port_;
  const Stm32Rcc& rcc_;
  Around around_;
  std::function<void(bool)> want_dma_;
};

// One stream in direct mode, memory to peripheral, bytes; the other seven are not modelled.
class Dma2 final : public RegisterBank {
 public:
  Dma2(unsigned stream, unsigned request, std::uint32_t target, DmaTransfer& transfer, const Stm32Rcc& rcc,
       Around around, std::function<void()> start)
      : RegisterBank("DMA2", kDmaBase, 0x400, {}),
        flags_(stream < 4 ? 0x0 : 0x4),
        own_(0x10 + 0x18 * stream),
        shift_(6 * (stream % 2) + 16 * (stream % 4 / 2)),
        request_(request),
        target_(target),
        transfer_(transfer),
        rcc_(rcc),
        around_(std::move(around)),
        start_(std::move(start)) {}

  bool alive() const override { return rcc_.ahb1(kDma2); }

  std::optional<std::uint32_t> read(std::uint32_t offset) override {
    note_end();
    if (offset == flags_) return raised_ << shift_;
    if (offset == own_) return control_ | (transfer_.active ? kEnable : 0);
    return offset == own_ + 4 ? std::optional(transfer_.left) : std::nullopt;
  }

  bool write(std::uint32_t offset, std::uint32_t value) override {
    note_end();
    if (offset == flags_ + 8) {
      raised_ &= ~(value >> shift_);
    } else if (offset == own_) {
      set_control(value);
    } else if (offset == own_ + 0x04) {
      count_ = value & 0xFFFF;
    } else if (offset == own_ + 0x08) {
      to_ = value;
    } else if (offset == own_ + 0x0C) {
      from_ = value;
    } else if (offset == own_ + 0x14) {
      if (value != 0) around_.complain("DMA2 is not in direct mode");
    } else {
      return false;
    }
    return true;
  }

 private:
  static constexpr std::uint32_t kEnable = 1, kFromMemory = 1u << 6, kStep = 1u << 10;
  static constexpr std::uint32_t kDone = 1u << 5, kError = 1u << 3;

  void set_control(std::uint32_t value) {
    control_ = value & ~kEnable;
    if ((value & kEnable) == 0) {
      transfer_.active = false;
      running_ = false;
      return;
    }
    if (running_) return;
    if (raised_ != 0) around_.complain("DMA2 is started with flags standing");
    if ((value & 3u << 6) != kFromMemory || (value & 15u << 11) != 0 || to_ != target_ || value >> 25 != request_) {
      around_.complain("DMA2 does not feed bytes to the serial port");
    }
    transfer_ = {true, from_, count_, (value & kStep) != 0, false};
    running_ = true;
    start_();
  }
  void note_end() {
    if (!running_ || transfer_.active) return;
    running_ = false;
    raised_ |= transfer_.failed ? kError : kDone;
  }

  std::uint32_t flags_, own_, shift_, request_, target_;
  DmaTransfer& transfer_;
  const Stm32Rcc& rcc_;
  Around around_;
  std::function<void()> start_;
  std::uint32_t control_ = 0, count_ = 0, to_ = 0, from_ = 0, raised_ = 0;
  bool running_ = false;
};

// Which serial port, and the stream that its requests go to.
struct Wired {
  const char* name;
  std::uint32_t base, gate;
  unsigned stream, request;
};
constexpr Wired kSpi1{"SPI1", 0x4001'3000, 1u << 12, 3, 3}, kSpi5{"SPI5", 0x4001'5000, 1u << 20, 4, 2};

class Stm32F4 final : public Chip {
 public:
  // ART accelerator: 64 lines of 128 bits for code, 8 for data; the shift register is the only FIFO behind a buffer of
  // one byte.
  Stm32F4(const BoardDescription& board, ReadByte read) : Chip(board, Stm32Rcc::kResetKilohertz, 1, std::move(read)) {
    memory_ = MemoryTiming({.base = 0x0800'0000,
                            .size = 0x0020'0000,
                            .line_bits = 4,
                            .code_sets = 1,
                            .code_ways = 64,
                            .data_sets = 1,
                            .data_ways = 8,
                            .prefetches = true});
    const auto complain_of = [this](const std::string& what) { complain(what); };
    const Around around{[this] { return now_; }, [this] { return clock_.kilohertz(); }, complain_of};
    Stm32Power& power = add<Stm32Power>();
    Stm32Flash& flash = add<Stm32Flash>([this](unsigned waits) { memory_.set_miss(waits); });
    Stm32Rcc& rcc = add<Stm32Rcc>(
        board.crystal_kilohertz, power, flash, [this](std::uint32_t kilohertz) { run_at(kilohertz); }, complain_of);
    for (char letter = 'A'; letter <= 'K'; ++letter) {
      add<Port>(
          letter, rcc,
          [this, letter](unsigned number, bool level) {
            set_pin({letter, number}, level);
          },
          [this, letter](unsigned number, bool to_port) {
            give_pin({letter, number}, to_port);
          });
    }
    const Wired& wired = board.panel->clock == PinName{'F', 7} ? kSpi5 : kSpi1;
    add<Spi>(wired.name, wired.base, wired.gate, port_, rcc, around, [this](bool wanted) { dma_wanted_ = wanted; });
    add<Dma2>(wired.stream, wired.request, wired.base + 0x0C, dma_, rcc, around, [this] { feed(now_); });
  }
};

}  // namespace

std::unique_ptr<Chip> make_stm32f4(const BoardDescription& board, ReadByte read) {
  return std::make_unique<Stm32F4>(board, std::move(read));
}

}  // namespace spanline::host
