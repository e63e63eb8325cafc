// What the engine's bytes in an image are for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/verb.hpp"

namespace spanline::bench {

struct CodePart {
  std::string name;
  std::uint32_t bytes = 0;
};

// The engine's code and constants in the image of the link map `path`, by what they are for, each part once and in the
// same order for every map; their sum is engine_text_bytes(path). Throws InputError as that does.
std::vector<CodePart> code_parts(const std::string& path);

// `spanline-frames parts FLAT.map GOURAUD.map`: a table in Markdown on the standard output.
class PartsCommand : public host::Verb {
 public:
  explicit PartsCommand(CLI::App& app);

  // Throws InputError where a map is none.
  void run() const;

 private:
  std::string flat_, gouraud_;
};

}  // namespace spanline::bench
