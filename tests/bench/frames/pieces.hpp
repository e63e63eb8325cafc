// What each stage of the edge walker's frames costs for a vertex, a face, an edge, a span, a pixel.
#pragma once

#include <string>
#include <vector>

#include "sim/verb.hpp"

namespace spanline::bench {

// `spanline-frames pieces FOLDER CPU…`: from the images of S1 and S4 that frames.sh left in FOLDER, flat and Gouraud
// shaded, a table in Markdown: instructions by stage, through the call tree, divided by what the scene has of it.
class PiecesCommand : public host::Verb {
 public:
  explicit PiecesCommand(CLI::App& app);

  // Throws InputError, also where a stage is not found in an image.
  void run() const;

 private:
  std::string folder_;
  std::vector<std::string> cpus_;
};

}  // namespace spanline::bench
