#include <iomanip>
#include <sstream>

#include "frames/count.hpp"
#include "frames/rivals.hpp"

namespace spanline::bench {
namespace {

// "tgx 1202 k (0.41)": a rival's figure, and ours as a part of it.
std::string beside(const Rival& rival, std::uint64_t ours) {
  std::ostringstream text;
  text << rival.name << " " << rival.thousands << " k (" << std::fixed << std::setprecision(2)
       << static_cast<double>(ours) / 1000.0 / rival.thousands << ")";
  return text.str();
}

}  // namespace

std::string frames_table(const std::vector<FrameCount>& frames) {
  std::ostringstream out;
  out << std::left << std::setw(14) << "scene" << std::setw(8) << "cpu" << std::setw(11) << "shading" << std::right
      << std::setw(14) << "instructions" << std::setw(12) << "cycles" << std::setw(9) << "RAM" << std::setw(9) << "text"
      << "   others (ours as a part of theirs)\n";
  for (const FrameCount& f : frames) {
    out << std::left << std::setw(14) << f.frame.scene << std::setw(8) << f.cpu << std::setw(11) << f.frame.shading
        << std::right << std::setw(14) << f.count.instructions << std::setw(12) << f.count.cycles << std::setw(9)
        << f.ram_bytes() << std::setw(9) << f.text_bytes << "  ";
    const char* separator = " ";
    for (const Rival& rival : rivals_of(f.frame.scene, f.cpu, f.frame.shading)) {
      out << separator << beside(rival, f.count.instructions);
      separator = ", ";
    }
    out << "\n";
  }
  out << "One whole frame, background included, counted instruction by instruction; cycles: core cycles at zero wait "
         "states.\nRAM: pools and Frame, line buffers, measured stack; text: the engine with the compiler's "
         "helpers. Bytes.\nOthers: thousands of instructions, drawing and clearing.\n";
  return out.str();
}

}  // namespace spanline::bench
