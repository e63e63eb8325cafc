// Where an instruction belongs: its function, and, where the image has debug information, what is inlined there.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "mcu/image.hpp"

namespace spanline::host {

class Places {
 public:
  struct Frame {
    std::string name;
    std::string file;  // that defines it, as the debug information names it; empty where that is not known
  };

  explicit Places(const Image& image);

  // The place of an instruction, a small number.
  std::uint32_t at(std::uint32_t address);
  // Its frames, outermost first.
  const std::vector<std::uint32_t>& frames(std::uint32_t place) const { return chains_[place]; }
  const std::vector<Frame>& all() const { return frames_; }

 private:
  std::uint32_t intern(const Frame& frame);

  const Image& image_;
  std::vector<Frame> frames_;
  std::map<std::pair<std::string, std::string>, std::uint32_t> known_frames_;
  std::vector<std::vector<std::uint32_t>> chains_;
  std::map<std::vector<std::uint32_t>, std::uint32_t> known_chains_;
};

}  // namespace spanline::host
