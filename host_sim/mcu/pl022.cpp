#include "mcu/pl022.hpp"

namespace spanline::host {
namespace {

constexpr std::uint32_t kControl0 = 0x00, kControl1 = 0x04, kData = 0x08, kState = 0x0C, kPrescale = 0x10,
                        kDmaControl = 0x24;
constexpr std::uint32_t kEnable = 1u << 1, kSlave = 1u << 2, kTransmitDma = 1u << 1;

}  // namespace

Pl022::Pl022(std::string name, std::uint32_t base, SerialPort& port, Around around)
    : RegisterBank(std::move(name), base, 0x1000, {{kControl0, 0}, {kControl1, 0}, {kPrescale, 0}, {kDmaControl, 0}}),
      port_(port),
      around_(std::move(around)) {}

std::optional<std::uint32_t> Pl022::read(std::uint32_t offset) {
  if (offset == kData) return port_.take_received();
  if (offset != kState) return RegisterBank::read(offset);
  constexpr std::uint32_t kEmpty = 1, kNotFull = 1u << 1, kReceived = 1u << 2, kBusy = 1u << 4;
  return (port_.empty() ? kEmpty : 0) | (port_.full() ? 0 : kNotFull) | (port_.has_received() ? kReceived : 0) |
         (port_.busy() ? kBusy : 0);
}

bool Pl022::write(std::uint32_t offset, std::uint32_t value) {
  if (offset == kData) {
    send(value);
    return true;
  }
  if (!RegisterBank::write(offset, value)) return false;
  if (offset == kDmaControl) around_.want_dma((value & kTransmitDma) != 0);
  if (offset != kControl1 || (value & kEnable) == 0) return true;
  const std::uint32_t control = at(kControl0), prescale = at(kPrescale) & 0xFF;
  if ((control & 0x3F) != 7) around_.complain(name() + " is not in 8-bit SPI format");
  if ((value & kSlave) != 0) around_.complain(name() + " is a slave");
  if (prescale < 2 || prescale % 2 != 0) around_.complain(name() + "'s prescaler is not even and at least 2");
  const std::uint32_t divisor = (prescale < 2 ? 2 : prescale) * (1 + (control >> 8 & 0xFF));
  const unsigned phase = control >> 7 & 1, polarity = control >> 6 & 1;
  port_.set(std::uint64_t{8} * divisor, around_.kilohertz() * 1000 / divisor, polarity << 1 | phase);
  return true;
}

void Pl022::send(std::uint32_t value) {
  if ((at(kControl1) & kEnable) == 0) around_.complain(name() + " is given data while off");
  if (port_.full()) around_.complain(name() + " is given data while its FIFO is full");
  port_.push(static_cast<std::uint8_t>(value), around_.now());
}

}  // namespace spanline::host
