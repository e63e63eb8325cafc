// LM3S6965 (datasheet DS-LM3S6965): system control, GPIO ports, SSI0. Flash has no wait states up to 50 MHz.
#include "mcu/chip.hpp"
#include "mcu/pl022.hpp"

namespace spanline::host {
namespace {

constexpr std::uint32_t kResetKilohertz = 12'000;  // internal oscillator
constexpr std::uint32_t kPllKilohertz = 200'000, kCrystalKilohertz = 8'000;
constexpr std::uint32_t kGate1 = 0x104, kGate2 = 0x108, kRunClock = 0x060, kRawInterrupt = 0x050;
constexpr std::uint32_t kSsi0 = 1u << 4;

class SystemControl final : public RegisterBank {
 public:
  using SetClock = std::function<void(std::uint32_t kilohertz)>;
  explicit SystemControl(SetClock set_clock)
      : RegisterBank("system control", 0x400F'E000, 0x1000,
                     {{kRawInterrupt, 0}, {kRunClock, 0x0780'3AD1}, {kGate1, 0}, {kGate2, 0}}),
        set_clock_(std::move(set_clock)) {}

  bool gate1(std::uint32_t bits) const { return (at(kGate1) & bits) == bits; }
  bool gate2(std::uint32_t bits) const { return (at(kGate2) & bits) == bits; }

  bool write(std::uint32_t offset, std::uint32_t value) override {
    if (!RegisterBank::write(offset, value)) return false;
    constexpr std::uint32_t kPowerDown = 1u << 13, kLocked = 1u << 6;
    if (offset != kRunClock) return true;
    if ((value & kPowerDown) == 0) at(kRawInterrupt) |= kLocked;
    set_clock_(kilohertz(value));
    return true;
  }

 private:
  static std::uint32_t kilohertz(std::uint32_t control) {
    constexpr std::uint32_t kBypass = 1u << 11, kDivide = 1u << 22;
    const bool crystal = (control >> 4 & 3) == 0;
    const std::uint32_t source = (control & kBypass) == 0 ? kPllKilohertz
                                 : crystal                ? kCrystalKilohertz
                                                          : kResetKilohertz;
    return (control & kDivide) != 0 ? source / ((control >> 23 & 15) + 1) : source;
  }

  SetClock set_clock_;
};

// The address masks the data register: bits 2 to 9 of it say which pins are meant.
class Port final : public RegisterBank {
 public:
  using SetPin = std::function<void(unsigned number, bool level)>;
  using GivePin = std::function<void(unsigned number, bool to_peripheral)>;

  Port(char letter, std::uint32_t base, const SystemControl& system, SetPin set_pin, GivePin give_pin)
      : RegisterBank(std::string("GPIO port ") + letter, base, 0x1000,
                     {{kDirection, 0}, {kFunction, 0}, {kDigital, 0}, {kPullUp, 0}}),
        gate_(1u << (letter - 'A')),
        system_(system),
        set_pin_(std::move(set_pin)),
        give_pin_(std::move(give_pin)) {}

  bool alive() const override { return system_.gate2(gate_); }

  std::optional<std::uint32_t> read(std::uint32_t offset) override {
    return offset < kDirection ? std::optional(level_ & offset >> 2) : RegisterBank::read(offset);
  }
  bool write(std::uint32_t offset, std::uint32_t value) override {
    if (offset < kDirection) {
      level_ = (level_ & ~(offset >> 2)) | (value & offset >> 2);
    } else if (!RegisterBank::write(offset, value)) {
      return false;
    }
    const std::uint32_t digital = at(kDigital);
    for (unsigned i = 0; i < 8; ++i) {
      give_pin_(i, (at(kFunction) & digital) >> i & 1);
      if (((at(kDirection) & digital & ~at(kFunction)) >> i & 1) != 0) set_pin_(i, (level_ >> i & 1) != 0);
    }
    return true;
  }

 private:
  static constexpr std::uint32_t kDirection = 0x400, kFunction = 0x420, kPullUp = 0x510, kDigital = 0x51C;
  std::uint32_t gate_, level_ = 0;
  const SystemControl& system_;
  SetPin set_pin_;
  GivePin give_pin_;
};

class Lm3s6965 final : public Chip {
 public:
  Lm3s6965(const BoardDescription& board, ReadByte read) : Chip(board, kResetKilohertz, Pl022::kFifo, std::move(read)) {
    SystemControl& system = add<SystemControl>([this](std::uint32_t kilohertz) { run_at(kilohertz); });
    constexpr std::uint32_t kBases[] = {0x4000'4000, 0x4000'5000, 0x4000'6000, 0x4000'7000,
                                        0x4002'4000, 0x4002'5000, 0x4002'6000};
    for (unsigned i = 0; i < 7; ++i) {
      const char letter = static_cast<char>('A' + i);
      add<Port>(
          letter, kBases[i], system,
          [this, letter](unsigned number, bool level) {
            set_pin({letter, number}, level);
          },
          [this, letter](unsigned number, bool to_port) {
            give_pin({letter, number}, to_port);
          });
    }
    add<Pl022>("SSI0", 0x4000'8000u, port_,
               Pl022::Around{[this] { return now_; }, [this] { return clock_.kilohertz(); },
                             [&system] { return system.gate1(kSsi0); },
                             [this](const std::string& what) { complain(what); }, [](bool) {}});
  }
};

}  // namespace

std::unique_ptr<Chip> make_lm3s6965(const BoardDescription& board, ReadByte read) {
  return std::make_unique<Lm3s6965>(board, std::move(read));
}

}  // namespace spanline::host
