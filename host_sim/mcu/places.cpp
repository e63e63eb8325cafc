#include "mcu/places.hpp"

namespace spanline::host {

std::uint32_t Places::intern(const Frame& frame) {
  const auto next = static_cast<std::uint32_t>(frames_.size());
  const auto [known, is_new] = known_frames_.try_emplace({frame.name, frame.file}, next);
  if (is_new) {
    frames_.push_back(frame);
    stages_.push_back(stage_of(frame.file));
  }
  return known->second;
}

std::uint32_t Places::at(std::uint32_t address) {
  const int function = image_.function_at(address);
  const std::string name = function < 0 ? "(no symbol)" : image_.functions()[static_cast<std::size_t>(function)].name;
  std::vector<Frame> frames = debug_.frames_at(address);
  if (frames.empty()) frames.emplace_back();
  frames.front().name = name;
  std::vector<std::uint32_t> chain;
  chain.reserve(frames.size());
  for (const Frame& frame : frames) chain.push_back(intern(frame));
  const auto next = static_cast<std::uint32_t>(chains_.size());
  const auto [known, is_new] = known_chains_.try_emplace(chain, next);
  if (is_new) chains_.push_back(chain);
  return known->second;
}

}  // namespace spanline::host
