// Where an instruction belongs: its function, and, where the image has debug information, what is inlined there.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mcu/debug_info.hpp"
#include "mcu/image.hpp"
#include "mcu/stage.hpp"

namespace spanline::host {

class Places {
 public:
  using Frame = DebugInfo::Frame;  // no file where it is not known

  Places(const Image& image, const DebugInfo& debug) : image_(image), debug_(debug) {}

  // The place of an instruction, a small number.
  std::uint32_t at(std::uint32_t address);
  // Its frames, outermost first.
  const std::vector<std::uint32_t>& frames(std::uint32_t place) const { return chains_[place]; }
  const std::vector<Frame>& all() const { return frames_; }
  // Of a frame's file; nothing for helpers.
  std::optional<Stage> stage(std::uint32_t frame) const { return stages_[frame]; }

 private:
  std::uint32_t intern(const Frame& frame);

  const Image& image_;
  const DebugInfo& debug_;
  std::vector<Frame> frames_;
  std::vector<std::optional<Stage>> stages_;
  std::map<std::pair<std::string, std::string>, std::uint32_t> known_frames_;
  std::vector<std::vector<std::uint32_t>> chains_;
  std::map<std::vector<std::uint32_t>, std::uint32_t> known_chains_;
};

}  // namespace spanline::host
