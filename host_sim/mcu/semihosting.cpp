#include "mcu/semihosting.hpp"

namespace spanline::host {
namespace {

constexpr std::uint32_t kOpen = 0x01, kClose = 0x02, kWriteC = 0x03, kWrite0 = 0x04, kWrite = 0x05, kIsTty = 0x09,
                        kClock = 0x10, kExit = 0x18, kExitExtended = 0x20, kApplicationExit = 0x20026;
constexpr std::uint32_t kConsole = 1, kFailed = UINT32_MAX;
constexpr std::uint32_t kMostText = 1u << 20;  // a lost terminator ends somewhere
constexpr std::uint64_t kMicrosecondsPerTick = 10'000;

}  // namespace

SemihostingAnswer answer_semihosting(std::uint32_t operation, std::uint32_t argument,
                                     const std::function<std::optional<std::uint8_t>(std::uint32_t)>& read,
                                     std::uint64_t microseconds, std::string& output) {
  const auto word = [&](std::uint32_t index) {
    std::uint32_t value = 0;
    for (std::uint32_t i = 4; i-- > 0;) value = value << 8 | read(argument + index * 4 + i).value_or(0);
    return value;
  };
  const auto say = [&](std::uint32_t from, std::uint32_t count, bool to_zero) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::optional<std::uint8_t> byte = read(from + i);
      if (!byte || (to_zero && *byte == 0)) return;
      output.push_back(static_cast<char>(*byte));
    }
  };
  switch (operation) {
    case kOpen:
      return {true, kConsole, {}};
    case kClose:
      return {true, 0, {}};
    case kWriteC:
      say(argument, 1, false);
      return {true, 0, {}};
    case kWrite0:
      say(argument, kMostText, true);
      return {true, 0, {}};
    case kWrite:
      say(word(1), word(2) < kMostText ? word(2) : kMostText, false);
      return {true, 0, {}};
    case kIsTty:
      return {true, 1, {}};
    case kClock:
      return {true, static_cast<std::uint32_t>(microseconds / kMicrosecondsPerTick), {}};
    case kExit:
      return {true, 0, argument == kApplicationExit ? 0u : 1u};
    case kExitExtended:
      return {true, 0, word(0) == kApplicationExit ? word(1) : 1u};
    default:
      return {false, kFailed, {}};
  }
}

}  // namespace spanline::host
