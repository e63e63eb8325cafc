// What the tests of panels share.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "oracle/random.hpp"
#include "panel/panel_run.hpp"

namespace spanline::host {

struct Turn {
  std::string panel;
  hal::Rotation rotation;
  friend std::ostream& operator<<(std::ostream& out, const Turn& turn) {
    return out << turn.panel << " r" << 90 * static_cast<int>(turn.rotation);
  }
};

// Every panel in every rotation that its driver allows.
inline std::vector<Turn> all_turns() {
  std::vector<Turn> turns;
  for (const std::string& panel : panel_names()) {
    for (int r = 0; r < 4; ++r) {
      const Turn turn{panel, static_cast<hal::Rotation>(r)};
      if (PanelRun::make(turn.panel, turn.rotation)) turns.push_back(turn);
    }
  }
  return turns;
}

inline std::string turn_name(const testing::TestParamInfo<Turn>& info) {
  std::string name = info.param.panel + "_r" + std::to_string(90 * static_cast<int>(info.param.rotation));
  for (char& c : name) {
    if (c == '-') c = '_';
  }
  return name;
}

using Line = std::vector<std::uint8_t>;

inline Slice<const std::uint8_t> view(const Line& line) {
  return {line.data(), static_cast<std::uint32_t>(line.size())};
}

inline Line random_line(PixelFormat format, std::uint16_t width, oracle::Random& random) {
  Line line(bytes_per_line(format, width));
  for (std::uint8_t& byte : line) byte = static_cast<std::uint8_t>(random.next());
  return line;
}

inline hal::Window all_of(const PanelRun& run) { return {0, 0, run.width(), run.height()}; }

// A window that the driver accepts.
inline hal::Window random_window(const PanelRun& run, oracle::Random& random) {
  const auto side = [&](int size, std::uint16_t& low, std::uint16_t& high) {
    low = static_cast<std::uint16_t>(random.below(size));
    high = static_cast<std::uint16_t>(random.between(low + 1, size));
  };
  hal::Window window{};
  side(run.width(), window.left, window.right);
  side(run.height(), window.top, window.bottom);
  return run.snap(window);
}

// What a line leaves in the picture.
inline void draw(const Line& line, PixelFormat format, const hal::Window& window, std::uint16_t y, Picture& picture) {
  decode_line(format, line.data(), window.width(),
              &picture.rgb[std::size_t{3} * (std::size_t{y} * picture.width + window.left)]);
}

// Fills a window with random pixels, in two buffers by turns: the one that has been sent is overwritten as soon as the
// driver allows it, which is when the next send() has returned.
inline void send_random(PanelRun& run, const hal::Window& window, oracle::Random& random, Picture& expected) {
  ASSERT_EQ(run.open(window), hal::Fault::none);
  Line buffers[2];
  for (std::uint16_t y = window.top; y < window.bottom; ++y) {
    Line& line = buffers[y % 2];
    line = random_line(run.format(), window.width(), random);
    draw(line, run.format(), window, y, expected);
    ASSERT_EQ(run.send(view(line)), hal::Fault::none);
    std::fill(buffers[1 - y % 2].begin(), buffers[1 - y % 2].end(), std::uint8_t{0x5A});
  }
  ASSERT_EQ(run.wait(), hal::Fault::none);
}

}  // namespace spanline::host
