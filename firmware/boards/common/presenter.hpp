// Between a finished line and the panel: sends what ScanOut finds to be sent.
#pragma once

#include "core/frame/band.hpp"
#include "core/frame/scan_out.hpp"
#include "hal/concepts.hpp"

namespace spanline::boards {

// A panel that takes windows of any place, and lets go of one that is not full.
template <typename T>
concept WindowedPanel = hal::Panel<T> && requires(T panel) {
  { panel.finish() } -> std::same_as<hal::Fault>;
};

// `wanted` where the panel takes windows of single lines, the whole picture otherwise: some have pages of eight lines.
template <hal::Panel Panel>
constexpr ScanPolicy policy_on(ScanPolicy wanted) {
  if constexpr (WindowedPanel<Panel>) {
    if (Panel::snap({2, 1, 4, 2}).height() == 1) return wanted;
  }
  return ScanPolicy::full;
}

// What a window costs on the panel's bus.
template <hal::Panel Panel>
constexpr std::uint8_t window_bytes_of() {
  if constexpr (WindowedPanel<Panel>) return Panel::kWindowBytes;
  return 0;
}

// Panel: as hal::Panel, and where the policy is another than full a WindowedPanel.
template <typename Panel>
class Presenter {
 public:
  Presenter(Panel& panel, const ScanOutStorage& storage) : panel_(panel), scan_out_(storage), screen_(storage.screen) {}

  void begin_frame(const BackgroundRecord& background) { scan_out_.begin_frame(background); }

  // The lines that have to be drawn in this frame, whatever has changed, so that they are refreshed: a few at once and
  // none in most frames, since each band that is drawn has its price.
  Band stale() const {
    constexpr std::uint16_t kAtOnce = 8;
    const std::uint16_t last = scan_out_.refreshed(), end = static_cast<std::uint16_t>(last + 1);
    if (end % kAtOnce != 0 && end != screen_.height) return {};
    return {static_cast<std::uint16_t>(last / kAtOnce * kAtOnce), end};
  }

  // Sends what has to be sent of a line. `in_flight` says whether anything was: `bytes` must then stay as they are
  // until something else of another buffer has been sent, or the frame has ended.
  hal::Fault line(std::uint16_t line, Slice<const std::uint8_t> bytes, bool& in_flight) {
    in_flight = false;
    scan_out_.line(line, bytes);
    for (PixelRun run; scan_out_.next(run);) {
      hal::Fault fault = hal::Fault::none;
      if (run.opens) fault = panel_.open({run.left, line, run.right, screen_.height});
      const std::uint32_t from = bytes_per_line(screen_.format, run.left);
      const std::uint32_t to = bytes_per_line(screen_.format, run.right);
      if (fault == hal::Fault::none) fault = panel_.send({bytes.data() + from, to - from});
      if (fault != hal::Fault::none) return lost(fault);
      in_flight = true;
    }
    return hal::Fault::none;
  }

  // Ends what is in flight; the panel is let go of.
  hal::Fault end_frame() {
    hal::Fault fault;
    if constexpr (requires { panel_.finish(); }) {
      fault = panel_.finish();
    } else {
      fault = panel_.wait();
    }
    return fault == hal::Fault::none ? fault : lost(fault);
  }

  // The panel has been initialised anew, or somebody else has drawn on it.
  void lost() { scan_out_.lost(); }

 private:
  hal::Fault lost(hal::Fault fault) {
    scan_out_.lost();
    return fault;
  }

  Panel& panel_;
  ScanOut scan_out_;
  Screen screen_;
};

}  // namespace spanline::boards
