#include "assetc/lit_parts.hpp"

#include <algorithm>

#include "assetc/input_error.hpp"
#include "assetc/sort_memory.hpp"
#include "core/area/light_view.hpp"

namespace spanline::host {
namespace {

// A window cuts what reaches across its sides, and nobody wants more parts than there are.
constexpr std::uint32_t kMostInWindow = 400;

// The faces as the light sees them, for area::LightView.
class LightScene {
 public:
  LightScene(const std::vector<LitFace>& faces, Vec3 direction) {
    const Vec3 back = -1.0 * direction;
    const Vec3 across = std::fabs(back.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
    const Vec3 right = unit_or(cross(across, back), {}), up = cross(back, right);
    const auto seen = [&](Vec3 p) { return Vec3{dot(right, p), dot(up, p), dot(back, p)}; };
    Box box;
    for (const LitFace& face : faces) {
      for (const Ring3& ring : face.rings) {
        for (const Vec3& p : ring) box.add(seen(p));
      }
    }
    const Vec3 size = box.high - box.low, middle = 0.5 * (box.low + box.high);
    unit_ = std::max({size.x, size.y, 1e-30}) / (2.0 * kReach);
    const double depths = size.z > 0 ? area::kMaxDepth / size.z : 0;
    for (const LitFace& face : faces) {
      Seen& out = faces_.emplace_back();
      out.opacity = face.transmission == Color{} ? area::Opacity::opaque : area::Opacity::translucent;
      if (!face.plane) continue;
      for (std::size_t r = 0; r < face.rings.size(); ++r) {
        std::vector<Corner>& ring = out.rings.emplace_back();
        for (std::size_t i = 0; i < face.rings[r].size(); ++i) {
          const Vec3 v = seen(face.rings[r][i]);
          const Corner corner{{to_grid((v.x - middle.x) / unit_), to_grid((v.y - middle.y) / unit_)},
                              static_cast<std::int32_t>(std::lround((v.z - box.low.z) * depths))};
          ring.push_back(corner);
          out.bounds.widen(corner.at);
          out.carrier.corner(corner.at, face.own[r][i]);
        }
      }
    }
  }

  double unit() const { return unit_; }

  std::uint32_t count() const { return static_cast<std::uint32_t>(faces_.size()); }
  const area::Box& bounds(std::uint16_t i) const { return faces_[i].bounds; }
  const area::Carrier& carrier(std::uint16_t i) const { return faces_[i].carrier; }
  void put(std::uint16_t i, area::AreaSort& sort) const {
    sort.begin_polygon(i, faces_[i].opacity);
    for (const std::vector<Corner>& ring : faces_[i].rings) {
      sort.begin_contour();
      for (const Corner& corner : ring) sort.vertex(corner.at.x, corner.at.y, corner.depth);
      sort.end_contour();
    }
    sort.end_polygon();
  }

 private:
  static constexpr double kReach = 32000;  // units

  struct Corner {
    area::GridPoint at;
    std::int32_t depth;
  };
  struct Seen {
    std::vector<std::vector<Corner>> rings;
    area::Box bounds = area::Box::none();
    area::Carrier carrier;
    area::Opacity opacity;
  };

  static std::int16_t to_grid(double value) { return static_cast<std::int16_t>(std::lround(value)); }

  std::vector<Seen> faces_;
  double unit_;
};

// Takes what area::LightView hands out.
class Collect {
 public:
  Collect(const std::vector<LitFace>& faces, LitParts& parts) : faces_(faces), parts_(parts) {}

  void begin_part(std::uint16_t face) {
    parts_.of_face[face].push_back({{255, 255, 255}, {}});
    part_ = &parts_.of_face[face].back();
  }
  void film(std::uint16_t face) {
    const Color glass = faces_[face].transmission;
    const auto through = [](unsigned light, unsigned part) {
      return static_cast<std::uint8_t>((light * part + 127) / 255);
    };
    part_->light = {through(part_->light.r, glass.r), through(part_->light.g, glass.g),
                    through(part_->light.b, glass.b)};
  }
  void begin_contour() { part_->region.emplace_back(); }
  void vertex(area::GridPoint p) { part_->region.back().push_back(p); }
  void end_contour() {}
  void end_part() {}

 private:
  const std::vector<LitFace>& faces_;
  LitParts& parts_;
  LitPart* part_ = nullptr;
};

}  // namespace

LitParts find_lit_parts(const std::vector<LitFace>& faces, Vec3 direction, const std::string& place) {
  const LightScene scene(faces, direction);
  LitParts parts{std::vector<std::vector<LitPart>>(faces.size()), scene.unit()};
  Collect collect(faces, parts);
  SortMemory memory;
  std::vector<std::uint16_t> names(UINT16_MAX);
  area::AreaSort sort(memory.refs(), area::Panes::shown);
  area::LightView<LightScene, Collect> view(scene, collect);
  const Status status = view.solve(sort, {names.data(), UINT16_MAX - 1}, kMostInWindow, area::Box::all());
  if (!status.ok()) {
    throw InputError(place, "the shadows are too intricate: what the light sees needs more than " +
                                std::to_string(status.limit) + " " + status.where);
  }
  return parts;
}

}  // namespace spanline::host
