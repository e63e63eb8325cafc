#include "assetc/motion_json.hpp"

#include "assetc/camera.hpp"

namespace spanline::host {
namespace {

constexpr std::int64_t kMaxFrame = 1'000'000;

void put(Pose& pose, std::size_t at, Vec3 v) {
  pose[at] = v.x;
  pose[at + 1] = v.y;
  pose[at + 2] = v.z;
}

// Which of the two forms the turns of one instance have: unknown until the first.
enum class TurnForm { unknown, angles, axis };

void read_turn(const JsonNode& node, Pose& pose, TurnForm& form) {
  if (!node.is_array() || (node.size() != 3 && node.size() != 4))
    node.fail("must be 3 angles, or an axis and its angle");
  const std::vector<double> values = node.numbers(node.size());
  const TurnForm here = values.size() == 4 ? TurnForm::axis : TurnForm::angles;
  const Vec3 v{values[0], values[1], values[2]};
  if (here == TurnForm::axis && largest(v) == 0) node.fail("the axis is zero");
  if (form != TurnForm::unknown && form != here) node.fail("must have as many numbers as the turns before it");
  if (form == TurnForm::axis && !(v == Vec3{pose[3], pose[4], pose[5]})) {
    node.fail("must have the same axis as the turns before it");
  }
  form = here;
  put(pose, 3, v);
  pose[6] = here == TurnForm::axis ? values[3] : 0;
}

void read_scale(const JsonNode& node, Pose& pose) {
  constexpr double kLargest = 1e6;
  if (node.is_array()) {
    const std::vector<JsonNode> each = node.elements();
    if (each.size() != 3) node.fail("must be a number or three");
    put(pose, 7,
        {each[0].number(-kLargest, kLargest), each[1].number(-kLargest, kLargest),
         each[2].number(-kLargest, kLargest)});
  } else {
    const double all = node.number(-kLargest, kLargest);
    put(pose, 7, {all, all, all});
  }
}

// Reads translate, rotate and scale where they stand in `node` over what `pose` holds.
void read_instance_pose(const JsonNode& node, Pose& pose, TurnForm& form) {
  if (const auto translate = node.find("translate")) put(pose, 0, translate->point());
  if (const auto rotate = node.find("rotate")) read_turn(*rotate, pose, form);
  if (const auto scale = node.find("scale")) read_scale(*scale, pose);
}

// Everything of a motion but the poses: `read_key` reads one key over the pose of the one before.
template <typename ReadKey>
Motion read_motion(const JsonNode& node, Pose pose, ReadKey read_key) {
  node.allow_keys({"frames", "loop", "interpolation", "keys"});
  Motion motion;
  for (const JsonNode& key : node.require("keys").elements(1)) {
    if (!key.is_object()) key.fail("must be an object");
    const JsonNode frame = key.require("frame");
    const std::int64_t number = frame.whole(0, kMaxFrame);
    if (!motion.keys.empty() && number <= motion.keys.back().frame)
      frame.fail("must be greater than in the key before");
    read_key(key, pose);
    motion.keys.push_back({number, pose});
  }
  motion.frames = std::max<std::int64_t>(1, motion.keys.back().frame);
  if (const auto frames = node.find("frames")) motion.frames = frames->whole(1, kMaxFrame);
  if (motion.keys.back().frame > motion.frames) node.fail("a key is beyond its 'frames'");
  if (const auto loop = node.find("loop")) motion.loop = loop->boolean();
  if (const auto interpolation = node.find("interpolation")) {
    const std::string kind = interpolation->text();
    if (kind != "linear" && kind != "smooth") interpolation->fail("must be \"linear\" or \"smooth\"");
    motion.smooth = kind == "smooth";
  }
  return motion;
}

Placement read_matrix(const JsonNode& node) {
  const std::vector<double> m = node.numbers(12);
  return {{{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}}, {m[3], m[7], m[11]}};
}

void refuse_beside_matrix(const JsonNode& node) {
  for (const char* key : {"translate", "rotate", "scale", "motion"}) {
    if (const auto found = node.find(key)) found->fail("cannot stand beside 'matrix'");
  }
}

// A turn about an axis that keys name while the instance itself has none: at rest it is that axis with no angle.
void settle_axis(InstanceSpec& instance, TurnForm at_rest, TurnForm form) {
  instance.turn_by_axis = form == TurnForm::axis;
  if (!instance.turn_by_axis || at_rest != TurnForm::unknown) return;
  Pose axis = instance.pose;
  for (const MotionKey& key : instance.motion.keys) {
    if (largest({key.pose[3], key.pose[4], key.pose[5]}) > 0) axis = key.pose;
  }
  for (MotionKey& key : instance.motion.keys) put(key.pose, 3, {axis[3], axis[4], axis[5]});
  put(instance.pose, 3, {axis[3], axis[4], axis[5]});
}

void read_camera_pose(const JsonNode& node, CameraSpec& camera) {
  if (const auto eye = node.find("eye")) {
    camera.eye = eye->point();
    camera.has_eye = true;
  }
  if (const auto target = node.find("target")) {
    camera.target = target->point();
    camera.has_target = true;
  }
  if (const auto up = node.find("up")) camera.up = up->point();
  if (const auto fov = node.find("fov")) {
    camera.fov = fov->number(0, 180);
    if (camera.fov == 0 || camera.fov == 180) fov->fail("must be above 0 and below 180");
  }
  if (camera.has_eye != camera.has_target) node.fail("'eye' and 'target' come together or not at all");
  if (!camera.has_eye) return;
  if (const char* fault = view_fault(camera.eye, camera.target, camera.up)) node.fail(fault);
}

}  // namespace

void read_placement(const JsonNode& node, InstanceSpec& instance) {
  if (const auto matrix = node.find("matrix")) {
    refuse_beside_matrix(node);
    instance.matrix = read_matrix(*matrix);
    return;
  }
  auto form = TurnForm::unknown;
  read_instance_pose(node, instance.pose, form);
  const TurnForm at_rest = form;
  if (const auto motion = node.find("motion")) {
    instance.motion = read_motion(*motion, instance.pose, [&](const JsonNode& key, Pose& pose) {
      key.allow_keys({"frame", "translate", "rotate", "scale"});
      read_instance_pose(key, pose, form);
    });
  }
  settle_axis(instance, at_rest, form);
}

void read_camera(const JsonNode& node, CameraSpec& camera) {
  node.allow_keys({"eye", "target", "up", "fov", "near", "far", "motion"});
  read_camera_pose(node, camera);
  constexpr double kFarthest = 1e12;
  if (const auto near = node.find("near")) {
    camera.near = near->number(0, kFarthest);
    if (*camera.near == 0) near->fail("must be above 0");
  }
  if (const auto far = node.find("far")) camera.far = far->number(0, kFarthest);
  if (camera.far && *camera.far <= camera.near.value_or(0)) node.require("far").fail("must be greater than 'near'");
  if (const auto motion = node.find("motion")) {
    CameraSpec moved = camera;
    camera.motion = read_motion(*motion, camera_pose(camera), [&](const JsonNode& key, Pose& pose) {
      key.allow_keys({"frame", "eye", "target", "up", "fov"});
      read_camera_pose(key, moved);
      if (!moved.has_eye) key.fail("needs 'eye' and 'target'");
      pose = camera_pose(moved);
    });
    camera.has_eye = camera.has_target = true;
  }
}

}  // namespace spanline::host
