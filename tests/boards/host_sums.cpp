// host_sums DEMO BOARD FRAME: what an emulated board without a panel prints of a demo, from the host.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/frame/frame.hpp"
#include "demo/boards.hpp"
#include "demo/line_memory.hpp"
#include "demos/all.hpp"

namespace spanline::host {
namespace {

constexpr Budget kAmple{.width = 320,
                        .height = 240,
                        .facets = 2048,
                        .vertices = 2048,
                        .polygons = 256,
                        .edges = 256,
                        .segments = 256,
                        .samples = 256,
                        .implied = 64,
                        .patch_facets = 4096,
                        .patch_vertices = 6144,
                        .layers = 64,
                        .curves = 512,
                        .strands = 160};
FrameMemory<kAmple> memory;

std::uint32_t sum(std::uint32_t from, Slice<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) from = (from ^ byte) * 16777619u;
  return from;
}

constexpr std::uint32_t kBasis = 2166136261u;

template <typename TheFrame>
Status print_sums(TheFrame& frame, const demos::Stage& stage, const Screen& screen, std::uint32_t number, bool lines) {
  std::uint32_t whole = kBasis;
  std::vector<std::uint32_t> words((frame.line_bytes() + 3) / 4);
  const Slice<std::uint8_t> line(reinterpret_cast<std::uint8_t*>(words.data()), frame.line_bytes());
  const Slice<const std::uint8_t> done(line.data(), line.size());
  for (Band rest{0, screen.height}; !rest.empty();) {
    const Band band = frame.prepare(stage.view(), stage.camera(), rest);
    if (band.empty()) break;
    for (unsigned y = band.top; frame.next_line(line); ++y) {
      if (lines) std::printf("line=%u checksum=%u\n", y, sum(kBasis, done));
      whole = sum(whole, done);
    }
    rest.top = band.bottom;
  }
  std::printf("frame=%u checksum=%u\n", number, whole);
  return frame.status();
}

template <FrameOptions kOptions>
Status draw(demos::Stage& stage, const demos::Demo& demo, const Screen& screen, std::uint32_t number, bool lines) {
  FrameStorage storage = memory.storage();
  storage.screen = screen;
  if (!demo.budget.gouraud) storage.vsg.shades.limit(0);
  Frame<kOptions> frame(storage);
  stage.show(number);
  return print_sums(frame, stage, screen, number, lines);
}

Status draw_lines(demos::Stage& stage, const demos::Demo& demo, const Screen& screen, std::uint32_t number,
                  bool lines) {
  HostLineMemory pools(screen, demo.budget);
  LineFrame frame(pools.storage());
  stage.show(number);
  return print_sums(frame, stage, screen, number, lines);
}

int run(const std::string& name, const std::string& board, std::uint32_t last) {
  const Screen screen = find_board(board).screen;
  demos::Stage stage;
  for (const demos::Layouts* layouts : demos::kAll) {
    const demos::Demo& demo = layouts->framed_for(screen);
    if (name != demo.name) continue;
    constexpr FrameOptions kPatches{.patches = true}, kLayers{.layers = true};
    const auto draw_demo = demo.budget.lines != 0    ? draw_lines
                           : demo.budget.layers != 0 ? draw<kLayers>
                                                     : draw<kPatches>;
    Status status = stage.begin(demo, screen);
    for (std::uint32_t number = 0; status.ok() && number <= last; ++number)
      status = draw_demo(stage, demo, screen, number, number == last);
    if (!status.ok()) std::fprintf(stderr, "%s: %s\n", status.where, status.field);
    return status.ok() ? 0 : 1;
  }
  std::fprintf(stderr, "no demo %s\n", name.c_str());
  return 2;
}

}  // namespace
}  // namespace spanline::host

int main(int argc, char** argv) {
  return argc == 4 ? spanline::host::run(argv[1], argv[2], static_cast<std::uint32_t>(std::atoi(argv[3]))) : 2;
}
