#include "frames/units.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "core/fx/bits.hpp"
#include "core/geom/projection.hpp"
#include "core/scene/instance_cursor.hpp"

namespace spanline::bench {
namespace {

// An edge that crosses lines, and the face that begins or ends at it.
struct Side {
  ScreenXY top, bottom;
  std::uint32_t face;
};

std::vector<ScreenXY> placed(const InstanceCursor& at, const CameraRecord& camera, const Screen& screen) {
  const ClipMatrix matrix = compose(camera, at.instance().transform, at.mesh());
  const Projection projection(camera, screen);
  Normaliser normaliser;
  std::vector<ScreenXY> points;
  for (const Position& position : at.mesh().positions) points.push_back(projection.place(matrix(position), normaliser));
  return points;
}

class Counter {
 public:
  explicit Counter(const Screen& screen) : screen_(screen) {}

  void add(const InstanceCursor& at, const std::vector<ScreenXY>& points) {
    const MeshRecord& mesh = at.mesh();
    units_.vertices += mesh.positions.size();
    units_.faces += mesh.face_count;
    std::set<std::pair<std::uint16_t, std::uint16_t>> edges;
    for (std::uint32_t face = 0; face < mesh.face_count; ++face) {
      const std::uint16_t* const corner = &mesh.corners[3 * face];
      if (!is_front(points[corner[0]], points[corner[1]], points[corner[2]])) continue;
      ++units_.fronts;
      for (int i = 0; i < 3; ++i) {
        const std::uint16_t a = corner[i], b = corner[(i + 1) % 3];
        sides_.push_back({points[a], points[b], at.first_face() + face});
        Side& side = sides_.back();
        if (side.top.y > side.bottom.y) std::swap(side.top, side.bottom);
        if (edges.insert(std::minmax(a, b)).second) count_edge(side);
      }
    }
  }

  Units units() {
    std::set<std::uint32_t> overlapping;
    for (int line = 0; line < screen_.height; ++line) count_overlaps(line, overlapping);
    units_.overlapping = static_cast<std::uint32_t>(overlapping.size());
    return units_;
  }

 private:
  void count_edge(const Side& side) {
    const std::int32_t first = std::max(first_centre(side.top.y), 0);
    const std::int32_t end = std::min<std::int32_t>(first_centre(side.bottom.y), screen_.height);
    if (first >= end) return;
    ++units_.edges;
    units_.edge_lines += static_cast<std::uint32_t>(end - first);
  }

  // ceil((x - half a pixel) / pixel) where the side meets the line's centre.
  int column(const Side& side, int line) const {
    const std::int64_t dy = side.bottom.y - side.top.y, below = line * kSubpixels + kSubpixels / 2 - side.top.y;
    const std::int64_t x = (side.top.x - kSubpixels / 2) * dy + (side.bottom.x - side.top.x) * below;
    return static_cast<int>(std::clamp<std::int64_t>(-floor_div(-x, kSubpixels * dy), 0, screen_.width));
  }

  void count_overlaps(int line, std::set<std::uint32_t>& overlapping) {
    std::map<int, std::vector<std::uint32_t>> turns;  // by column: faces that begin or end there
    for (const Side& side : sides_) {
      if (first_centre(side.top.y) > line || first_centre(side.bottom.y) <= line) continue;
      turns[column(side, line)].push_back(side.face);
    }
    std::set<std::uint32_t> over;
    for (const auto& [at, faces] : turns) {
      for (const std::uint32_t face : faces) {
        if (!over.insert(face).second) over.erase(face);
      }
      if (over.size() < 2) continue;
      ++units_.overlaps;
      overlapping.insert(over.begin(), over.end());
    }
  }

  Screen screen_;
  Units units_;
  std::vector<Side> sides_;
};

}  // namespace

Units units_of(const SceneView& view, const CameraRecord& camera, const Screen& screen) {
  Counter counter(screen);
  for (InstanceCursor at(view.scene()); !at.at_end(); at.next()) {
    if ((at.instance().flags & InstanceRecord::kHidden) == 0 && !at.mesh().fans.empty()) {
      counter.add(at, placed(at, camera, screen));
    }
  }
  return counter.units();
}

}  // namespace spanline::bench
