#include "core/frame/changed_lines.hpp"

#include "core/geom/projection.hpp"

namespace spanline {

namespace {

// At a distance of w a vertex lies within 2/16 px / w of its exact place (Projection), and so does a corner of the box
// around it.
constexpr std::int32_t kNearest = (1 << 16) / 8;  // Q16.16: nearer than this even
constexpr std::int32_t kMargin = 2 * kSubpixels;  // 28.4: do not make up for both
static_assert(2 * 2 * ((1 << 16) / kNearest) <= kMargin);

// Corners of boxes; may lie a little outside the positions.
struct Place {
  std::int32_t x, y, z;
};

struct Range {
  std::int32_t low = INT32_MAX, high = INT32_MIN;
  void add(std::int32_t v) {
    low = v < low ? v : low;
    high = v > high ? v : high;
  }
  // By a sixth of its length: a Catmull-Rom curve's control points lie that far from its points at most.
  void widen() {
    const std::int32_t sixth = (high - low) / 6 + 1;
    low -= sixth;
    high += sixth;
  }
};

void measure(const MeshRecord& mesh, KeptInstance& kept) {
  Range x, y, z;
  for (const Position& p : mesh.positions) {
    x.add(p.x);
    y.add(p.y);
    z.add(p.z);
  }
  const Range* const ranges[3] = {&x, &y, &z};
  for (int i = 0; i < 3; ++i) {
    kept.low[i] = static_cast<std::int16_t>(ranges[i]->low);
    kept.high[i] = static_cast<std::int16_t>(ranges[i]->high);
  }
  kept.stroke = 0;
  kept.beyond_hull = false;
  for (const CurveRecord& curve : mesh.curves) {
    const auto half = static_cast<std::uint16_t>(curve.width / 2 + kSubpixels);
    kept.stroke = half > kept.stroke ? half : kept.stroke;
    kept.beyond_hull = kept.beyond_hull || curve.kind == CurveRecord::kCatmullRom;
  }
}

}  // namespace

ChangedLines::ChangedLines(const ChangesStorage& storage, const Screen& screen)
    : instances_(storage.instances), lines_(storage.lines), screen_(screen) {
  CHECK(lines_.size() * 32 >= screen_.height);
  redraw({0, screen_.height});
}

void ChangedLines::begin_frame(const SceneView& view, const CameraRecord& camera) {
  const SceneRecord& scene = view.scene();
  const std::uint32_t count = scene.instances.size();
  const bool known = keeps_ && &scene == scene_ && count == count_;
  if (!known || background_ != scene.background) redraw({0, screen_.height});
  scene_ = &scene;
  count_ = count;
  background_ = scene.background;
  keeps_ = count <= instances_.size();
  still_ = still_ && known;
  if (!keeps_) return;
  const bool same_view = known && camera == camera_;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!same_view || scene.instances[i] != instances_[i].record) keep(scene, i, camera, known);
  }
  camera_ = camera;
}

void ChangedLines::keep(const SceneRecord& scene, std::uint32_t instance, const CameraRecord& camera, bool known) {
  KeptInstance& kept = instances_[instance];
  const InstanceRecord& now = scene.instances[instance];
  const MeshRecord& mesh = scene.meshes[now.mesh];
  if (known) redraw(kept.lines);
  if (!known || now.mesh != kept.record.mesh) measure(mesh, kept);
  kept.record = now;
  kept.moved = true;
  still_ = false;
  kept.lines = lines_of(kept, mesh, camera);
  redraw(kept.lines);
}

// What the box around the positions shows itself on: of what is drawn, clipped or not, nothing lies outside of it.
Band ChangedLines::lines_of(const KeptInstance& kept, const MeshRecord& mesh, const CameraRecord& camera) const {
  const InstanceRecord& instance = kept.record;
  if ((instance.flags & InstanceRecord::kHidden) != 0 || mesh.positions.empty()) return {};
  Range box[3];
  for (int i = 0; i < 3; ++i) {
    box[i] = {kept.low[i], kept.high[i]};
    if (kept.beyond_hull) box[i].widen();
  }
  Range y;  // 28.4
  if ((instance.flags & InstanceRecord::kScreen) != 0) {
    y = box[1];
  } else {
    const ClipMatrix matrix = compose(camera, instance.transform, mesh);
    const Projection projection(camera, screen_);
    if (projection.near_w < kNearest) return {0, screen_.height};
    Normaliser normaliser;
    for (unsigned corner = 0; corner < 8; ++corner) {
      const auto side = [&](unsigned axis) { return (corner >> axis & 1) != 0 ? box[axis].high : box[axis].low; };
      ClipPoint clip = matrix(Place{side(0), side(1), side(2)});
      if (clip.w < projection.near_w) return {0, screen_.height};
      clip.x = 0;
      clip.y = clip.y < -clip.w ? -clip.w : clip.y > clip.w ? clip.w : clip.y;  // beyond the screen in any case
      y.add(projection.place(clip, normaliser).y);
    }
    if (kept.beyond_hull) y.widen();
  }
  const auto line_at = [&](std::int32_t at) {
    const std::int32_t line = first_centre(at);
    return static_cast<std::uint16_t>(line < 0 ? 0 : line > screen_.height ? screen_.height : line);
  };
  return {line_at(y.low - kept.stroke - kMargin), line_at(y.high + kept.stroke + kMargin)};
}

Band ChangedLines::next(Band rest) const {
  Band found{rest.bottom, rest.bottom};
  for (std::uint16_t line = rest.top; line < rest.bottom; ++line) {
    if (!is_changed(line)) {
      if (!found.empty() && line - found.bottom >= kWorthABand) break;
      continue;
    }
    if (found.top == rest.bottom) found.top = line;
    found.bottom = static_cast<std::uint16_t>(line + 1);
  }
  return found;
}

void ChangedLines::redraw(Band lines) {
  for (std::uint32_t line = lines.top; line < lines.bottom; ++line) lines_[line / 32] |= 1u << line % 32;
}

void ChangedLines::geometry_kept() {
  still_ = true;  // within the frame
  for (std::uint32_t i = 0; keeps_ && i < count_; ++i) instances_[i].moved = false;
}

}  // namespace spanline
