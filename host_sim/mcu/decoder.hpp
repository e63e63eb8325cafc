#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "mcu/board.hpp"
#include "mcu/instruction.hpp"

namespace spanline::host {

// Thumb instructions one by one. Slow: whoever runs code keeps what it was told.
class Decoder {
 public:
  explicit Decoder(Core core);
  ~Decoder();
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  // `first`, `second`: the halfwords at `address`.
  Instruction decode(std::uint32_t address, std::uint16_t first, std::uint16_t second) const;

 private:
  struct Engine;
  Core core_;
  std::unique_ptr<Engine> engine_;
};

// Bytes of the instruction that begins with this halfword.
inline std::uint8_t thumb_size(std::uint16_t first) { return (first & 0xF800) >= 0xE800 ? 4 : 2; }

}  // namespace spanline::host
