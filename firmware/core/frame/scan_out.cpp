#include "core/frame/scan_out.hpp"

#include "core/shade/painter.hpp"

namespace spanline {

namespace {

// Marks a line of which nothing is known; no line has so many columns.
constexpr Columns kUnknown{0, UINT16_MAX};

// The line is bytes to everybody else.
using Word = std::uint32_t __attribute__((may_alias));

// Multiply and fold, a word at a time: one product spreads a bit upwards, the fold brings it down again, so that no bit
// of a tile can be made up for by the same bit of another one, as with a plain sum or FNV's even steps.
std::uint32_t mixed(std::uint32_t hash, std::uint32_t word) {
  hash = (hash ^ word) * 0x9E3779B1u;
  return hash ^ hash >> 15;
}

std::uint32_t hash_of(const std::uint8_t* bytes, std::uint32_t count) {
  std::uint32_t hash = count;
  const std::uint8_t* const words_end = bytes + count / 4 * 4;
  for (; bytes != words_end; bytes += 4) hash = mixed(hash, *reinterpret_cast<const Word*>(bytes));
  for (count %= 4; count != 0; --count) hash = mixed(hash, *bytes++);
  return hash;
}

Columns hull(Columns a, Columns b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {a.left < b.left ? a.left : b.left, a.right > b.right ? a.right : b.right};
}

}  // namespace

ScanOut::ScanOut(const ScanOutStorage& storage)
    : screen_(storage.screen),
      policy_(storage.policy),
      window_bytes_(storage.window_bytes),
      lines_(storage.lines),
      hashes_(storage.hashes) {
  CHECK(policy_ == ScanPolicy::full || lines_.size() >= screen_.height);
  CHECK(policy_ != ScanPolicy::tiles || hashes_.size() >= tiles_per_line(screen_.width) * screen_.height);
  lost();
}

void ScanOut::lost() {
  for (Columns& line : lines_) line = kUnknown;
  window_ = pending_ = {};
}

void ScanOut::begin_frame(const BackgroundRecord& background) {
  window_ = {};
  if (policy_ == ScanPolicy::full) return;
  if (background != background_) lost();
  background_ = background;
  refreshed_ = static_cast<std::uint16_t>(refreshed_ + 1 < screen_.height ? refreshed_ + 1 : 0);
  lines_[refreshed_] = kUnknown;
}

// A line of background is one word over and over: dither repeats every eight pixels.
std::uint32_t ScanOut::background_word(std::uint16_t line) const {
  std::uint32_t word = 0;
  Painter painter(screen_);
  painter.begin_lines(background_);
  painter.begin_line(line, reinterpret_cast<std::uint8_t*>(&word));
  const auto pixels = static_cast<std::uint16_t>(32 / bits_per_pixel(screen_.format));
  painter.span({.line = line, .left = 0, .right = pixels, .depth = {}});
  return word;
}

std::uint16_t ScanOut::column_at(std::uint32_t byte) const {
  const std::uint32_t column = byte * 8 / bits_per_pixel(screen_.format);
  return static_cast<std::uint16_t>(column < screen_.width ? column : screen_.width);
}

// What is not background lies between these columns, whole words apart from the end of the line.
Columns ScanOut::covered(std::uint16_t line, Slice<const std::uint8_t> bytes) const {
  const std::uint32_t blank = background_word(line);
  const auto* const begin = reinterpret_cast<const Word*>(bytes.data());
  const Word* end = begin + bytes.size() / 4;
  const Word* first = begin;
  while (first != end && *first == blank) ++first;
  std::uint32_t right = bytes.size();
  const auto* const blank_bytes = reinterpret_cast<const std::uint8_t*>(&blank);
  while (right % 4 != 0 && bytes[right - 1] == blank_bytes[(right - 1) % 4]) --right;
  if (right % 4 == 0) {
    while (end != first && end[-1] == blank) --end;
    right = static_cast<std::uint32_t>(end - begin) * 4;
  }
  return {column_at(static_cast<std::uint32_t>(first - begin) * 4), column_at(right)};
}

void ScanOut::line(std::uint16_t line, Slice<const std::uint8_t> bytes) {
  // Of the line before something was not taken: it has not been sent.
  if (!pending_.empty() && policy_ != ScanPolicy::full) lines_[line_] = kUnknown;
  line_ = line;
  pending_ = whole();
  if (policy_ != ScanPolicy::full) {
    const Columns shown = lines_[line];
    const bool all = shown == kUnknown;
    lines_[line] = covered(line, bytes);
    if (!all) pending_ = hull(shown, lines_[line]);
    if (policy_ == ScanPolicy::tiles && !pending_.empty()) {
      find_changed_tiles(line, bytes, pending_, all);
      join_tiles();
    }
  }
  continues_ = goes_on(line);
}

// Notes which tiles within `where` differ from what the panel shows, and narrows pending_ to them.
void ScanOut::find_changed_tiles(std::uint16_t line, Slice<const std::uint8_t> bytes, Columns where, bool all) {
  for (std::uint32_t& word : changed_) word = 0;
  const std::uint32_t end = tiles_per_line(where.right);
  std::uint32_t* const hashes = &hashes_[line * tiles_per_line(screen_.width)];
  std::uint32_t first = end, last = 0;
  for (std::uint32_t tile = where.left / kTilePixels; tile < end; ++tile) {
    const std::uint32_t from = bytes_of(kTilePixels) * tile;
    const std::uint32_t rest = bytes_of(screen_.width) - from;
    const std::uint32_t hash = hash_of(&bytes[from], rest < bytes_of(kTilePixels) ? rest : bytes_of(kTilePixels));
    if (hash == hashes[tile] && !all) continue;
    hashes[tile] = hash;
    set_changed(tile);
    if (first == end) first = tile;
    last = tile + 1;
  }
  const std::uint32_t left = first * kTilePixels, right = last * kTilePixels;
  pending_ = {static_cast<std::uint16_t>(left > where.left ? left : where.left),
              static_cast<std::uint16_t>(right < where.right ? right : where.right)};
}

// Before a second window is opened the run before must have left, and meanwhile nobody computes; a gap that is sent
// along leaves while the next line is computed. So it is sent along unless it takes kHeldUp times as long as that run
// and a window. Counted on an STM32F4: with 3 no demo's frame takes longer than 1.02 times the longer of computing and
// sending each line, with 1 it is 1.06, and 1.39 where a gap may be no longer than a window.
void ScanOut::join_tiles() {
  constexpr std::uint32_t kHeldUp = 3;
  const std::uint32_t tile_bytes = bytes_of(kTilePixels), end = tiles_per_line(pending_.right);
  std::uint32_t begin = pending_.left / kTilePixels, after = begin;  // of the run so far
  for (std::uint32_t tile = begin; tile < end; ++tile) {
    if (!is_changed(tile)) continue;
    const std::uint32_t gap = tile - after, run = after - begin;
    if (tile_bytes * gap > kHeldUp * (tile_bytes * run + window_bytes_)) begin = after = tile;
    for (; after <= tile; ++after) set_changed(after);
  }
}

// The run that begins in or after `tile`.
Columns ScanOut::run_from(std::uint32_t tile) const {
  if (policy_ != ScanPolicy::tiles) return pending_;
  const std::uint32_t end = tiles_per_line(pending_.right);
  while (tile < end && !is_changed(tile)) ++tile;
  std::uint32_t after = tile;
  while (after < end && is_changed(after)) ++after;
  const std::uint32_t left = tile * kTilePixels, right = after * kTilePixels;
  return {static_cast<std::uint16_t>(left > pending_.left ? left : pending_.left),
          static_cast<std::uint16_t>(right < pending_.right ? right : pending_.right)};
}

// Whether the open window, which may be wider, is cheaper than windows for what has to be sent. pending_ is then what
// it takes.
bool ScanOut::goes_on(std::uint16_t line) {
  if (window_.empty() || window_line_ != line || pending_.empty()) return false;
  if (pending_.left < window_.left || pending_.right > window_.right) return false;
  std::uint32_t cost = 0;
  for (std::uint32_t left = pending_.left; left < pending_.right;) {
    const Columns run = run_from(left / kTilePixels);
    cost += window_bytes_ + bytes_of(run.right) - bytes_of(run.left);
    left = run.right;
  }
  if (bytes_of(window_.right) - bytes_of(window_.left) > cost) return false;
  pending_ = window_;
  return true;
}

bool ScanOut::next(PixelRun& run) {
  if (pending_.empty()) return false;
  const Columns columns = continues_ ? pending_ : run_from(pending_.left / kTilePixels);
  run = {columns.left, columns.right, !continues_};
  continues_ = false;
  pending_.left = columns.right;
  window_ = columns;
  window_line_ = static_cast<std::uint16_t>(line_ + 1);
  return true;
}

}  // namespace spanline
