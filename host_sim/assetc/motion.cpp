#include "assetc/motion.hpp"

#include <algorithm>

namespace spanline::host {

Pose Motion::at(std::int64_t frame, const Pose& rest) const {
  if (keys.empty()) return rest;
  const std::int64_t time = loop ? frame % frames : frame;
  const auto next = std::find_if(keys.begin(), keys.end(), [time](const MotionKey& key) { return key.frame > time; });
  if (next == keys.begin()) return next->pose;
  const MotionKey& from = *(next - 1);
  if (next == keys.end()) return from.pose;
  double part = static_cast<double>(time - from.frame) / static_cast<double>(next->frame - from.frame);
  if (smooth) part = part * part * (3 - 2 * part);
  Pose pose;
  for (std::size_t i = 0; i < pose.size(); ++i) pose[i] = from.pose[i] + part * (next->pose[i] - from.pose[i]);
  return pose;
}

}  // namespace spanline::host
