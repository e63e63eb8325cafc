#include "mcu/frame_recorder.hpp"

#include <algorithm>

namespace spanline::host {
namespace {

StageCounts difference(const StageCounts& a, const StageCounts& b) {
  StageCounts result;
  for (std::size_t i = 0; i < kStages; ++i) result[i] = a[i] - b[i];
  return result;
}

}  // namespace

void FrameRecorder::begin_frame(const Ledger& so_far) {
  open_ = true;
  prepared_ = false;
  begin_ = line_begin_ = so_far.total();
  stages_begin_ = stages_line_begin_ = so_far.stages();
  first_pixel_ = pixels_;
  waits_.clear();
  frames_.emplace_back();
  frames_.back().begin = so_far.total().time();
}

void FrameRecorder::begin_lines(const Ledger& so_far) {
  if (!open_ || prepared_) return;
  prepared_ = true;
  frames_.back().prepare = so_far.total() - begin_;
  line_begin_ = so_far.total();
  stages_line_begin_ = so_far.stages();
}

void FrameRecorder::gave(std::uint64_t pixels, const Ledger& so_far) {
  const std::uint64_t before = pixels_;
  pixels_ = pixels;
  if (!open_) return;
  std::vector<FrameRecord::Line>& lines = frames_.back().lines;
  const std::uint64_t next_line = first_pixel_ + lines.size() * line_bytes_;
  if (lines.size() == lines_ || before > next_line || pixels <= next_line) return;
  lines.push_back(
      {so_far.total() - line_begin_, difference(so_far.stages(), stages_line_begin_), so_far.total().time(), 0, 0});
  line_begin_ = so_far.total();
  stages_line_begin_ = so_far.stages();
}

void FrameRecorder::waited(std::uint64_t begin, std::uint64_t end) {
  if (!waits_.empty() && waits_.back().end == begin) {
    waits_.back().end = end;
  } else {
    waits_.push_back({begin, end});
  }
}

// Pixel bytes by line, and how much of the wire's time the core did not wait for.
void FrameRecorder::place_bytes(FrameRecord& frame, const std::vector<DisplayWire::Byte>& wire) {
  std::uint64_t pixels = 0;
  auto wait = waits_.begin();
  for (; placed_ < wire.size(); ++placed_) {
    const DisplayWire::Byte& byte = wire[placed_];
    if (byte.begin < frame.begin) continue;
    ++frame.bytes;
    frame.wire += byte.end - byte.begin;
    frame.overlapped += byte.end - byte.begin;
    while (wait != waits_.end() && wait->end <= byte.begin) ++wait;
    for (auto at = wait; at != waits_.end() && at->begin < byte.end; ++at) {
      frame.overlapped -= std::min(at->end, byte.end) - std::max(at->begin, byte.begin);
    }
    if (!byte.pixel) continue;
    const std::uint64_t line = pixels++ / line_bytes_;
    if (line >= frame.lines.size()) continue;
    if ((pixels - 1) % line_bytes_ == 0) frame.lines[line].begin = byte.begin;
    frame.lines[line].end = byte.end;
  }
}

void FrameRecorder::end_frame(const Ledger& so_far, const std::vector<DisplayWire::Byte>& wire) {
  if (!open_) return;
  open_ = false;
  FrameRecord& frame = frames_.back();
  frame.end = so_far.total().time();
  frame.count = so_far.total() - begin_;
  frame.stages = difference(so_far.stages(), stages_begin_);
  place_bytes(frame, wire);
}

}  // namespace spanline::host
