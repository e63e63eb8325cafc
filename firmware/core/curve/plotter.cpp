#include "core/curve/plotter.hpp"

namespace spanline {
namespace {

// The lines that a cubic within its control points' hull can touch, drawn with a pen of `radius` (1/16 px).
struct Lines {
  std::int32_t first = INT32_MAX, last = INT32_MIN;
  void add(const Cubic& cubic, std::int32_t radius) {
    for (const CurvePoint& p : cubic.p) {
      const std::int32_t top = (p.y - radius) >> 4, bottom = (p.y + radius) >> 4;
      if (top < first) first = top;
      if (bottom > last) last = bottom;
    }
  }
};

}  // namespace

void CurvePlotter::open(const Screen& screen) {
  screen_ = screen;
  strands_ = FreeList<StrandBlock, &StrandBlock::next>(storage_.strands);
  coverage_ = LineCoverage(storage_.masks, screen.width);
  alive_ = 0;
  scene_ = {};
}

void CurvePlotter::begin(const SceneView& scene, const CameraRecord& camera, std::int32_t top, std::int32_t bottom) {
  const bool onward = top != 0 && top == line_ && &scene.scene() == &scene_.scene() && camera == camera_;
  if (top == 0) status_ = {};
  bottom_ = bottom;
  planned_ = top;
  if (onward) return;
  scene_ = scene;
  camera_ = camera;
  reader_ = CurveReader(scene_, camera_, screen_);
  strands_.clear();
  alive_ = 0;
  afresh_ = true;
}

// Files the pieces of the longest run of lines from `top` on whose waiting pieces fit.
void CurvePlotter::plan(std::int32_t top) {
  std::int32_t lines = bottom_ - top;
  if (lines > storage_.buckets.capacity()) lines = storage_.buckets.capacity();
  while (!file_all(top, top + lines)) lines /= 2;
  top_ = top;
  planned_ = top + lines;
  afresh_ = false;
}

// False where the waiting pieces do not fit and there are lines to give up.
bool CurvePlotter::file_all(std::int32_t top, std::int32_t bottom) {
  for (std::int32_t line = top; line < bottom; ++line) storage_.buckets[static_cast<std::uint32_t>(line - top + 1)] = 0;
  waiting_ = 0;
  std::uint32_t refused = 0;
  for (std::uint16_t curve = 0; curve < scene_.curve_count(); ++curve) {
    reader_.select(curve);
    const std::uint32_t pieces = reader_.hidden() ? 0 : reader_.record().pieces();
    for (std::uint16_t piece = 0; piece < pieces; ++piece) {
      if (file(curve, piece, top, bottom)) continue;
      if (bottom - top > 1) return false;
      ++refused;
    }
  }
  if (refused != 0) {
    const std::uint16_t capacity = storage_.pieces.capacity();
    status_ = {Code::pool_exhausted, "curves", "", 0, static_cast<std::uint32_t>(top), capacity + refused, capacity};
  }
  return true;
}

bool CurvePlotter::file(std::uint16_t curve, std::uint16_t piece, std::int32_t top, std::int32_t bottom) {
  Lines lines;
  const std::int32_t radius = pen().radius;
  reader_.read(piece, [&](const Cubic& part) { lines.add(part, radius); });
  if (lines.first >= bottom || lines.last < top || (!afresh_ && lines.first < top)) return true;
  if (waiting_ == storage_.pieces.capacity()) return false;
  const std::int32_t first = lines.first > top ? lines.first : top;
  std::uint16_t& bucket = storage_.buckets[static_cast<std::uint32_t>(first - top + 1)];
  storage_.pieces[++waiting_] = {bucket, curve, piece};
  bucket = waiting_;
  return true;
}

// A smooth curve is a pixel wide at least.
Pen CurvePlotter::pen() const {
  const CurveRecord& record = reader_.record();
  const bool smooth = (record.flags & CurveRecord::kSmooth) != 0;
  const std::uint16_t width = smooth && record.width < kSubpixels ? std::uint16_t{kSubpixels} : record.width;
  return {static_cast<std::uint16_t>((width + 1) / 2), smooth};
}

void CurvePlotter::begin_pieces(std::int32_t line) {
  for (std::uint16_t at = storage_.buckets[static_cast<std::uint32_t>(line - top_ + 1)]; at != 0;
       at = storage_.pieces[at].next) {
    const WaitingPiece waiting = storage_.pieces[at];
    reader_.select(waiting.curve);
    reader_.read(waiting.piece, [&](const Cubic& part) { begin(part, waiting.curve, line); });
  }
}

// Puts in the strands of a part; those that ended above `line` come to an end when they are drawn there.
void CurvePlotter::begin(const Cubic& cubic, std::uint16_t curve, std::int32_t line) {
  const Strands strands(cubic);
  for (unsigned i = 0; i < strands.count(); ++i) {
    const Stroke stroke(strands[i], pen());
    const std::int32_t first = stroke.first_line();
    if (first >= screen_.height) continue;
    std::uint16_t index = strands_.take();
    while (index == 0) {
      if (!make_room(curve, line)) return;
      index = strands_.take();
    }
    strands_[index] = {0, curve, static_cast<std::int16_t>(first), reader_.color(), stroke};
    insert(index);
  }
}

// Drops the last strand of the curve with the highest number, if that is above `curve`. Notes the shortage.
bool CurvePlotter::make_room(std::uint16_t curve, std::int32_t line) {
  const auto at_line = static_cast<std::uint32_t>(line);
  const bool same = status_.code == Code::pool_exhausted && status_.line == at_line;
  const std::uint32_t capacity = strands_.capacity();
  status_ = {Code::pool_exhausted, "strands", "", curve, at_line, (same ? status_.needed : capacity) + 1, capacity};
  std::uint16_t* link = &alive_;
  if (*link == 0) return false;
  while (strands_[*link].next != 0) link = &strands_[*link].next;
  if (strands_[*link].curve <= curve) return false;
  strands_.give(*link);
  *link = 0;
  return true;
}

// Behind the strands of its own curve: among those the order does not matter.
void CurvePlotter::insert(std::uint16_t index) {
  std::uint16_t* link = &alive_;
  while (*link != 0 && strands_[*link].curve <= strands_[index].curve) link = &strands_[*link].next;
  strands_[index].next = *link;
  *link = index;
}

// Draws the strands of the curve that *link begins with; those that have ended are given back. Returns the link to the
// next curve.
std::uint16_t* CurvePlotter::draw_curve(std::uint16_t* link, std::int32_t line) {
  const std::uint16_t curve = strands_[*link].curve;
  while (*link != 0 && strands_[*link].curve == curve) {
    StrandBlock& block = strands_[*link];
    if (block.first_line > line || block.stroke.draw(line, coverage_)) {
      link = &block.next;
      continue;
    }
    const std::uint16_t ended = *link;
    *link = block.next;
    strands_.give(ended);
  }
  return link;
}

}  // namespace spanline
