#include "frames/count.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "assetc/input_error.hpp"
#include "boards/common/run_request.hpp"
#include "frames/link_map.hpp"
#include "sim/usage_error.hpp"

namespace spanline::bench {
namespace {

using namespace host;

const BoardDescription& core_named(const std::string& cpu) {
  if (cpu == "m0plus" || cpu == "m3" || cpu == "m4" || cpu == "m7") return board_named("cortex-" + cpu);
  throw UsageError("--cpu: '" + printable(cpu) + "' is not one of m0plus, m3, m4, m7");
}

// The image's lines "key=value".
std::map<std::string, std::string> said_by(const RunReport& run) {
  std::map<std::string, std::string> said;
  std::istringstream lines(run.output);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t sign = line.find('=');
    if (sign != std::string::npos) said[line.substr(0, sign)] = line.substr(sign + 1);
  }
  return said;
}

}  // namespace

RunReport run_frames(const Image& image, const std::string& cpu, unsigned frames) {
  const std::uint32_t request = image.address_of("run_request");
  RunOptions options;
  options.from = "frame_begin_mark";
  options.until = "frame_end_mark";
  options.passages = frames;
  options.words = {{request, 0}, {request + 4, boards::RunRequest::kSeal}};
  return run_image(image, core_named(cpu), options);
}

FrameCount count_frame(const std::string& path, const std::string& cpu, const Expected& expected) {
  const Image image(path);
  constexpr unsigned kEveryFrame = 1000;  // it stops by itself, after it has said what it found
  const RunReport run = run_frames(image, cpu, kEveryFrame);
  std::map<std::string, std::string> said = said_by(run);
  if (said["status"] != "ok") throw InputError(path, "the frame's status is '" + printable(said["status"]) + "'");
  if (said["checksum"] != std::to_string(expected.checksum)) {
    throw InputError(path, "draws another picture than the host: checksum " + printable(said["checksum"]) + ", not " +
                               std::to_string(expected.checksum));
  }
  const auto bytes = [&](const char* key) { return static_cast<std::uint32_t>(std::stoul(said.at(key))); };
  const std::string map = path.substr(0, path.rfind('.')) + ".map";
  return {cpu, expected, run.passages.front(), bytes("memory"), bytes("lines"), bytes("stack"), engine_text_bytes(map)};
}

std::string frames_json(const std::vector<FrameCount>& frames) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const FrameCount& f : frames) {
    out.push_back({{"scene", f.frame.scene},
                   {"cpu", f.cpu},
                   {"shading", f.frame.shading},
                   {"instructions", f.count.instructions},
                   {"ram_bytes", f.ram_bytes()},
                   {"text_bytes", f.text_bytes}});
  }
  return out.dump(2) + "\n";
}

}  // namespace spanline::bench
