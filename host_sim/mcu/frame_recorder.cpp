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
  prepared_ = line_open_ = between_bands_ = false;
  begin_ = so_far.total();
  stages_begin_ = so_far.stages();
  frame_pixel_ = pixels_;
  waits_.clear();
  frames_.emplace_back();
  frames_.back().begin = so_far.total().time();
}

void FrameRecorder::begin_line(std::uint64_t promised, const Ledger& so_far) {
  if (!open_) return;
  if (line_open_) end_line(so_far);
  if (!prepared_) frames_.back().prepare = so_far.total() - begin_;
  if (!between_bands_) {
    line_begin_ = so_far.total();
    stages_line_begin_ = so_far.stages();
  }
  prepared_ = line_open_ = true;
  between_bands_ = line_given_ = false;
  line_pixel_ = promised;
  frames_.back().lines.emplace_back();
  frames_.back().lines.back().first_pixel = promised - frame_pixel_;
}

void FrameRecorder::no_line() {
  if (!line_open_) return;
  line_open_ = false;
  between_bands_ = true;
  frames_.back().lines.pop_back();
}

void FrameRecorder::end_line(const Ledger& so_far) {
  FrameRecord::Line& line = frames_.back().lines.back();
  line.count = so_far.total() - line_begin_;
  line.stages = difference(so_far.stages(), stages_line_begin_);
  line_open_ = false;
}

void FrameRecorder::gave(std::uint64_t pixels, const Ledger& so_far) {
  pixels_ = pixels;
  if (!line_open_ || line_given_ || pixels <= line_pixel_) return;
  line_given_ = true;
  frames_.back().lines.back().ready = so_far.total().time() - (so_far.total() - line_begin_).waiting;
}

void FrameRecorder::waited(std::uint64_t begin, std::uint64_t end) {
  if (!waits_.empty() && waits_.back().end == begin) {
    waits_.back().end = end;
  } else {
    waits_.push_back({begin, end});
  }
}

// Pixel bytes by the line that they were promised in, and how much of the wire's time the core did not wait for.
void FrameRecorder::place_bytes(FrameRecord& frame, const std::vector<DisplayWire::Byte>& wire) {
  std::uint64_t pixels = 0;
  std::size_t at_line = 0;
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
    const std::uint64_t pixel = pixels++;
    if (frame.lines.empty()) continue;
    while (at_line + 1 < frame.lines.size() && frame.lines[at_line + 1].first_pixel <= pixel) ++at_line;
    FrameRecord::Line& line = frame.lines[at_line];
    if (line.bytes++ == 0) line.begin = byte.begin;
    line.end = byte.end;
  }
}

void FrameRecorder::end_frame(const Ledger& so_far, const std::vector<DisplayWire::Byte>& wire) {
  if (!open_) return;
  if (line_open_) end_line(so_far);
  open_ = false;
  FrameRecord& frame = frames_.back();
  frame.end = so_far.total().time();
  frame.count = so_far.total() - begin_;
  frame.stages = difference(so_far.stages(), stages_begin_);
  place_bytes(frame, wire);
}

}  // namespace spanline::host
