// A scene made ready for an image of tests/bench/image.
#pragma once

#include <cstdint>
#include <string>

#include "frames/units.hpp"
#include "sim/scene_options.hpp"
#include "sim/verb.hpp"

namespace spanline::bench {

// What is known of a frame before it is counted.
struct Expected {
  std::string scene;       // the scene's file, without folder and extension
  std::string shading;     // "flat", "gouraud", or "as written"
  std::uint32_t checksum;  // FNV-1a of the picture's bytes, as the host draws it
  std::uint32_t faces, edge_crossings, output_segments, depth_tests;
  Units units{};
};

// Throws InputError where it is not there.
Expected read_expected(const std::string& folder);

// `spanline-frames prepare SCENE --out FOLDER`: shown.cpp, shown.hpp (namespace shown: the scene's tables), budget.hpp
// (fitted to it), expected.json.
class PrepareCommand : public host::Verb {
 public:
  explicit PrepareCommand(CLI::App& app);

  // Throws UsageError and InputError.
  void run() const;

 private:
  host::SceneOptions scene_;
  std::string out_;
  std::uint16_t point_lines_ = 0;
  std::uint32_t memory_ = 0;
};

}  // namespace spanline::bench
