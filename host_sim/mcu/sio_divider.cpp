#include "mcu/sio_divider.hpp"

namespace spanline::host {
namespace {

constexpr std::uint64_t kCycles = 8;
enum Register : std::uint32_t {
  kUnsignedDividend = 0x00,
  kUnsignedDivisor = 0x04,
  kSignedDividend = 0x08,
  kSignedDivisor = 0x0C,
  kQuotient = 0x10,
  kRemainder = 0x14,
  kState = 0x18
};
constexpr std::uint32_t kReady = 1u << 0, kDirty = 1u << 1;

std::uint32_t magnitude(std::uint32_t value) { return value >> 31 != 0 ? 0u - value : value; }

}  // namespace

// By zero the remainder is the dividend and the quotient all ones, or of a negative dividend 1.
void SioDivider::divide(std::uint64_t now) {
  const bool negative = signed_ && dividend_ >> 31 != 0, other_sign = signed_ && (dividend_ ^ divisor_) >> 31 != 0;
  const std::uint32_t a = signed_ ? magnitude(dividend_) : dividend_, b = signed_ ? magnitude(divisor_) : divisor_;
  const std::uint32_t quotient = b == 0 ? UINT32_MAX : a / b, remainder = b == 0 ? a : a % b;
  if (b == 0) {
    quotient_ = negative ? 1 : UINT32_MAX;
  } else {
    quotient_ = other_sign ? 0u - quotient : quotient;
  }
  remainder_ = negative ? 0u - remainder : remainder;
  ready_at_ = now + kCycles;
  dirty_ = true;
}

std::optional<std::uint32_t> SioDivider::read(std::uint32_t offset, std::uint64_t now) {
  const bool ready = now >= ready_at_;
  switch (offset) {
    case kUnsignedDividend:
    case kSignedDividend:
      return dividend_;
    case kUnsignedDivisor:
    case kSignedDivisor:
      return divisor_;
    case kState:
      return (ready ? kReady : 0) | (dirty_ ? kDirty : 0);
    case kRemainder:
      return ready ? std::optional(remainder_) : std::nullopt;
    case kQuotient:
      dirty_ = false;
      return ready ? std::optional(quotient_) : std::nullopt;
    default:
      return std::nullopt;
  }
}

bool SioDivider::write(std::uint32_t offset, std::uint32_t value, std::uint64_t now) {
  switch (offset) {
    case kUnsignedDividend:
    case kSignedDividend:
      dividend_ = value;
      break;
    case kUnsignedDivisor:
    case kSignedDivisor:
      divisor_ = value;
      break;
    case kQuotient:  // what an interrupted division had reached, put back
      quotient_ = value;
      dirty_ = true;
      return true;
    case kRemainder:
      remainder_ = value;
      dirty_ = true;
      return true;
    default:
      return false;
  }
  signed_ = offset == kSignedDividend || offset == kSignedDivisor;
  divide(now);
  return true;
}

}  // namespace spanline::host
