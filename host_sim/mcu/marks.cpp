#include "mcu/marks.hpp"

#include "mcu/machine.hpp"

namespace spanline::host {

Marks find_marks(const Image& image, const RunOptions& options) {
  const auto code_at = [&](const std::string& name) { return image.address_of(name) & ~1u; };
  Marks marks;
  if (!options.from.empty()) marks.from = code_at(options.from);
  if (!options.until.empty()) marks.until = code_at(options.until);
  if (image.defines("main")) marks.main = code_at("main");
  if (!image.defines(kFrameBeginMark) || !image.defines(kFrameEndMark)) return marks;
  marks.frame_begin = code_at(kFrameBeginMark);
  marks.frame_end = code_at(kFrameEndMark);
  for (const Image::Symbol& function : image.functions()) {
    if (function.name.find("Frame<") != std::string::npos && function.name.find("::next_line(") != std::string::npos) {
      marks.next_line = function.address;
    }
  }
  return marks;
}

}  // namespace spanline::host
