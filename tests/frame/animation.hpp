// Random pictures that change from frame to frame as scenes do: patches that move, turn or stand still before a
// background.
#pragma once

#include <cstring>
#include <vector>

#include "core/shade/painter.hpp"
#include "oracle/random.hpp"

namespace spanline::oracle {

class Animation {
 public:
  Animation(const Screen& screen, std::uint64_t seed) : screen_(screen), random_(seed), patches_(4) {
    for (Patch& patch : patches_) place(patch);
  }

  static constexpr BackgroundRecord kBackground{{10, 40, 90}, {200, 180, 60}};

  // The next frame: some patches stay, some move, some change colour.
  void step() {
    for (Patch& patch : patches_) {
      if (random_.percent(50)) continue;
      if (random_.percent(10)) {
        place(patch);
      } else if (random_.percent(50)) {
        patch.seed = random_.next();
      } else {
        patch.left += random_.between(-9, 9);
        patch.top += random_.between(-3, 3);
      }
    }
  }

  std::vector<std::uint8_t> bytes(int y) const {
    std::vector<std::uint8_t> out(bytes_per_line(screen_.format, screen_.width));
    std::vector<std::uint32_t> words(out.size() / 4 + 1);  // the painter's line begins on a word
    Painter painter(screen_);
    painter.begin_lines(kBackground);
    painter.begin_line(static_cast<std::uint16_t>(y), reinterpret_cast<std::uint8_t*>(words.data()));
    painter.span({.line = static_cast<std::uint16_t>(y), .left = 0, .right = screen_.width, .depth = {}});
    std::memcpy(out.data(), words.data(), out.size());
    for (int x = 0; x < screen_.width; ++x) {
      if (const Patch* patch = patch_at(x, y)) put(out, static_cast<std::uint32_t>(x), pixel(*patch, x, y));
    }
    return out;
  }

 private:
  struct Patch {
    int left = 0, top = 0, width = 0, height = 0;
    bool flat = false;
    std::uint64_t seed = 0;
  };

  void place(Patch& p) {
    p.width = random_.between(1, screen_.width / 2 + 1);
    p.height = random_.between(1, screen_.height / 2 + 1);
    p.left = random_.between(-p.width, screen_.width);
    p.top = random_.between(-p.height, screen_.height);
    p.flat = random_.percent(60);
    p.seed = random_.next();
  }

  const Patch* patch_at(int x, int y) const {
    for (const Patch& p : patches_) {
      if (x >= p.left && x < p.left + p.width && y >= p.top && y < p.top + p.height) return &p;
    }
    return nullptr;
  }

  std::uint32_t pixel(const Patch& p, int x, int y) const {
    const auto spot = static_cast<std::uint64_t>((y - p.top) * 4096 + x - p.left);
    return static_cast<std::uint32_t>(Random(p.flat ? p.seed : p.seed + spot).next());
  }

  void put(std::vector<std::uint8_t>& line, std::uint32_t x, std::uint32_t value) const {
    switch (screen_.format) {
      case PixelFormat::rgb565:
        line[2 * x] = static_cast<std::uint8_t>(value >> 8);
        line[2 * x + 1] = static_cast<std::uint8_t>(value);
        break;
      case PixelFormat::grey8:
        line[x] = static_cast<std::uint8_t>(value);
        break;
      case PixelFormat::grey4:
        line[x / 2] = static_cast<std::uint8_t>(x % 2 == 0 ? value << 4 | (line[x / 2] & 15u)
                                                           : (line[x / 2] & 240u) | (value & 15u));
        break;
      case PixelFormat::mono1:
        line[x / 8] = static_cast<std::uint8_t>((line[x / 8] & ~(128u >> x % 8)) | (value & 1u) << (7 - x % 8));
        break;
    }
  }

  Screen screen_;
  Random random_;
  std::vector<Patch> patches_;
};

}  // namespace spanline::oracle
