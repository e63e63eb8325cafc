// What each frame of a run took, line by line, and when its bytes crossed the wire.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mcu/display_wire.hpp"
#include "mcu/ledger.hpp"

namespace spanline::host {

struct FrameRecord {
  // A line: from the first byte of the line before (or the frame's begin) to its own first byte given to the port.
  struct Line {
    Count count;
    StageCounts stages;
    std::uint64_t given = 0;           // when its first byte was given to the port
    std::uint64_t begin = 0, end = 0;  // on the wire
  };
  std::uint64_t begin = 0, end = 0;  // of the frame, core cycles since reset
  Count count;
  StageCounts stages;
  Count prepare;  // before its first line began; the first line's count is without it
  std::vector<Line> lines;
  std::uint64_t bytes = 0;       // on the wire, commands too
  std::uint64_t wire = 0;        // cycles in which the wire was busy
  std::uint64_t overlapped = 0;  // of these: the core did something else than wait
};

class FrameRecorder {
 public:
  // `lines` of `line_bytes` make a frame.
  FrameRecorder(std::uint32_t lines, std::uint32_t line_bytes) : lines_(lines), line_bytes_(line_bytes) {}

  void begin_frame(const Ledger& so_far);
  // The first line of a frame begins; where nobody says so, its preparation counts as the first line's.
  void begin_lines(const Ledger& so_far);
  void end_frame(const Ledger& so_far, const std::vector<DisplayWire::Byte>& wire);

  // The core gave the port pixel bytes, `pixels` in all since reset.
  void gave(std::uint64_t pixels, const Ledger& so_far);

  // A loop waited from `begin` to `end`.
  void waited(std::uint64_t begin, std::uint64_t end);

  std::vector<FrameRecord>& frames() { return frames_; }

 private:
  struct Interval {
    std::uint64_t begin, end;
  };
  void place_bytes(FrameRecord& frame, const std::vector<DisplayWire::Byte>& wire);

  std::uint32_t lines_, line_bytes_;
  bool open_ = false, prepared_ = false;
  Count begin_, line_begin_;
  StageCounts stages_begin_{}, stages_line_begin_{};
  std::uint64_t pixels_ = 0, first_pixel_ = 0;
  std::size_t placed_ = 0;  // bytes of the wire's record that belong to earlier frames
  std::vector<Interval> waits_;
  std::vector<FrameRecord> frames_;
};

}  // namespace spanline::host
