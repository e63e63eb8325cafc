// What an emulator asks of an image: it writes the request into RAM before the reset, so that one and the same image
// runs on a real board, where nobody wrote one, and stops at a frame of the emulator's choice.
#pragma once

#include <cstdint>

namespace spanline::boards {

struct RunRequest {
  static constexpr std::uint32_t kSeal = 0x5350414E;
  std::uint32_t last_frame;
  std::uint32_t seal;  // last_frame ^ kSeal, else there is no request

  // An emulator with semihosting runs this image, and it has to stop after frame last_frame.
  bool made() const { return (last_frame ^ kSeal) == seal; }
};

}  // namespace spanline::boards

// Neither cleared nor set at start-up; the linker script keeps it, `nm` tells an emulator its address.
extern "C" volatile spanline::boards::RunRequest run_request;

namespace spanline::boards {

inline RunRequest request() { return {run_request.last_frame, run_request.seal}; }

}  // namespace spanline::boards
