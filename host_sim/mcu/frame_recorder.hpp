// What each frame of a run took, line by line, and when its bytes crossed the wire.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mcu/display_wire.hpp"
#include "mcu/ledger.hpp"

namespace spanline::host {

struct FrameRecord {
  // A line of the picture: from the call that makes it to the next line's, so handing it to the port is in it.
  struct Line {
    Count count;
    StageCounts stages;
    std::uint64_t ready = 0;           // when its first byte was given to the port, had nothing in the line waited
    std::uint64_t first_pixel = 0;     // bytes of pixels of the lines before it
    std::uint64_t bytes = 0;           // of its pixels, on the wire
    std::uint64_t begin = 0, end = 0;  // on the wire
  };
  std::uint64_t begin = 0, end = 0;  // of the frame, core cycles since reset
  Count count;
  StageCounts stages;
  Count prepare;  // before its first line began; what prepares a later band is in that band's first line
  std::vector<Line> lines;
  std::uint64_t bytes = 0;       // on the wire, commands too
  std::uint64_t wire = 0;        // cycles in which the wire was busy
  std::uint64_t overlapped = 0;  // of these: the core did something else than wait
};

class FrameRecorder {
 public:
  void begin_frame(const Ledger& so_far);
  // The core begins to make a line, and the one before is done with. `promised`: pixel bytes since reset that the port
  // was given, or a DMA transfer under way still has to give it.
  void begin_line(std::uint64_t promised, const Ledger& so_far);
  // What began was no line: the band was finished.
  void no_line();
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
  void end_line(const Ledger& so_far);
  void place_bytes(FrameRecord& frame, const std::vector<DisplayWire::Byte>& wire);

  bool open_ = false, prepared_ = false;
  bool line_open_ = false, line_given_ = false;
  bool between_bands_ = false;
  Count begin_, line_begin_;
  StageCounts stages_begin_{}, stages_line_begin_{};
  std::uint64_t frame_pixel_ = 0, line_pixel_ = 0;  // pixel bytes since reset before the frame, the line
  std::uint64_t pixels_ = 0;
  std::size_t placed_ = 0;  // bytes of the wire's record that belong to earlier frames
  std::vector<Interval> waits_;
  std::vector<FrameRecord> frames_;
};

}  // namespace spanline::host
