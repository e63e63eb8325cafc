// What of a finished line has to cross the wire so that the panel, which keeps what it was sent, shows what was drawn.
//
//   scan_out.begin_frame(background);
//   … each line, once it is finished:
//   scan_out.line(line, bytes);
//   for (PixelRun run; scan_out.next(run);) {
//     if (run.opens) panel.open({run.left, line, run.right, height});  // down to the bottom: later lines may follow on
//     panel.send(the bytes of [run.left, run.right));
//   }
//
// What has been handed out counts as shown. A frame may end anywhere, and a line may be left out: what the panel shows
// of it is still known. Where a transfer fails, or the panel is initialised anew, say lost().
#pragma once

#include <cstdint>

#include "core/base/slice.hpp"
#include "core/frame/budget.hpp"
#include "core/geom/screen.hpp"
#include "core/scene/format.hpp"

namespace spanline {

struct PixelRun {
  std::uint16_t left = 0, right = 0;
  bool opens = false;  // in a window of its own; otherwise the open one goes on
};

inline constexpr std::uint32_t kTilePixels = 16;
constexpr std::uint32_t tiles_per_line(std::uint32_t width) { return (width + kTilePixels - 1) / kTilePixels; }

struct ScanOutStorage {
  Screen screen;
  ScanPolicy policy = ScanPolicy::full;
  Slice<Columns> lines;            // one a line, unless full: what is not background on the panel
  Slice<std::uint32_t> hashes;     // tiles_per_line(width) a line, for tiles only: of what the panel shows
  std::uint8_t window_bytes = 11;  // what opening a window costs: two addresses and a command, as DCS panels take them
};

class ScanOut {
 public:
  // Nothing is known of what the panel shows. `storage` is used until the ScanOut is gone.
  explicit ScanOut(const ScanOutStorage& storage);

  // `background`: of the pictures to come; a change makes every line unknown. One line a frame is sent whole: whatever
  // disturbed the panel, or two tiles of one hash (one pair in 2^32), is mended in as many frames as there are lines.
  void begin_frame(const BackgroundRecord& background);

  // Begins to hand out what of `line` is to be sent: `bytes` is the whole line in wire order, on a word boundary.
  void line(std::uint16_t line, Slice<const std::uint8_t> bytes);

  // The next run of the line, from left to right; on whole bytes. False when there is none left.
  bool next(PixelRun& run);

  // The line of this frame of which nothing is known from now on until it is drawn. Where only what has changed is
  // drawn it is to be drawn, too, now or later.
  std::uint16_t refreshed() const { return refreshed_; }

  // The panel shows nobody knows what: a Frame that draws only what has changed is to redraw() every line.
  void lost();

 private:
  static constexpr std::uint32_t kMaskWords = (tiles_per_line(kMaxExtent) + 31) / 32;

  Columns whole() const { return {0, screen_.width}; }
  Columns covered(std::uint16_t line, Slice<const std::uint8_t> bytes) const;
  std::uint32_t background_word(std::uint16_t line) const;
  std::uint16_t column_at(std::uint32_t byte) const;
  std::uint32_t bytes_of(std::uint32_t columns) const { return bytes_per_line(screen_.format, columns); }
  void find_changed_tiles(std::uint16_t line, Slice<const std::uint8_t> bytes, Columns where, bool all);
  void join_tiles();
  bool goes_on(std::uint16_t line);
  Columns run_from(std::uint32_t tile) const;
  bool is_changed(std::uint32_t tile) const { return (changed_[tile / 32] >> tile % 32 & 1u) != 0; }
  void set_changed(std::uint32_t tile) { changed_[tile / 32] |= 1u << tile % 32; }

  Screen screen_;
  ScanPolicy policy_;
  std::uint8_t window_bytes_;
  Slice<Columns> lines_;
  Slice<std::uint32_t> hashes_;
  BackgroundRecord background_{};
  Columns pending_;  // what is left to hand out: all of it, or the tiles in it that have changed
  Columns window_;   // the one that is open, down to the screen's end
  std::uint16_t line_ = 0, window_line_ = 0;  // the line handed out; the one that the open window takes next
  std::uint16_t refreshed_ = 0;
  bool continues_ = false;
  std::uint32_t changed_[kMaskWords]{};
};

// The memory that a policy takes; the budget says which.
template <Budget kBudget>
class ScanOutMemory {
 public:
  ScanOutStorage storage() {
    return {{kBudget.width, kBudget.height, kBudget.format},
            kBudget.scan_out,
            {lines_, kBudget.scan_out == ScanPolicy::full ? 0u : kBudget.height},
            {hashes_, kBudget.scan_out == ScanPolicy::tiles ? kHashes : 0u}};
  }

 private:
  static constexpr std::uint32_t kHashes = tiles_per_line(kBudget.width) * kBudget.height;
  Columns lines_[kBudget.scan_out == ScanPolicy::full ? 1 : kBudget.height];
  std::uint32_t hashes_[kBudget.scan_out == ScanPolicy::tiles ? kHashes : 1];
};

}  // namespace spanline
