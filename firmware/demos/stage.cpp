#include "core/fx/bits.hpp"
#include "demos/demo.hpp"

namespace spanline::demos {

namespace {

// The focal length that shows at least `shot`'s picture on `screen`: focal * min(width ratio, height ratio).
Fx12 fitted_focal(const Shot& shot, const Screen& screen) {
  const auto ratio_of = [focal = std::int64_t{shot.camera->focal.raw}](std::uint16_t have, std::uint16_t asked) {
    return Fx12::from_raw(static_cast<std::int32_t>(focal * have / asked));
  };
  const Fx12 across = ratio_of(screen.width, shot.width);
  const Fx12 down = ratio_of(screen.height, shot.height);
  return across < down ? across : down;
}

}  // namespace

Status Stage::begin(const Demo& demo, const Screen& screen) {
  const std::uint32_t count = demo.shot.scene->instances.size();
  if (count > kMaxInstances) return {Code::bad_record, "SceneRecord", "instances", 0, 0, count, kMaxInstances};
  demo_ = demo;
  focal_ = fitted_focal(demo.shot, screen);
  scene_ = *demo.shot.scene;
  scene_.instances = Slice<const InstanceRecord>(instances_, count);
  show(0);
  return SceneView::validate(scene_, view_);
}

void Stage::show(std::uint32_t frame) {
  const Slice<const InstanceRecord> rest = demo_.shot.scene->instances;
  for (std::uint32_t i = 0; i < rest.size(); ++i) instances_[i] = rest[i];
  camera_ = *demo_.shot.camera;
  camera_.focal = focal_;
  demo_.pose(frame, demo_.shot, {{instances_, rest.size()}, camera_});
}

}  // namespace spanline::demos
