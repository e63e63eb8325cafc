#include "measure.hpp"

#include "assetc/compile.hpp"
#include "assetc/input_error.hpp"
#include "core/frame/frame_impl.hpp"
#include "sim/host_memory.hpp"
#include "sim/stats_json.hpp"
#include "sim/status_text.hpp"

namespace spanline::figures {
namespace {

using host::Rendering;

constexpr FrameOptions kVsg6{
    .comparator = Comparator::midpoint, .x_sort = XSort::list, .statistics = true, .taps = true};
constexpr FrameOptions kVsg5{
    .comparator = Comparator::midpoint, .x_sort = XSort::buckets, .statistics = true, .taps = true};
constexpr FrameOptions kPlane{.comparator = Comparator::plane, .x_sort = XSort::list, .statistics = true, .taps = true};

void record_span(void* context, const VisibleSpan& span) {
  auto& ids = static_cast<Rendering*>(context)->ids;
  if (span.face == kNoFace) return;
  for (std::size_t x = span.left; x < span.right; ++x) ids[std::size_t{span.line} * kRaster + x] = span.face + 1u;
}

template <FrameOptions kOptions>
Status render(const SceneView& scene, const CameraRecord& camera, const host::PoolSizes& pools, Rendering& out) {
  host::HostMemory memory({kRaster, kRaster, PixelFormat::rgb565}, kRaster, pools);
  FrameStorage storage = memory.storage();
  typename XSortBuckets<true>::Buckets buckets{};
  storage.vsg.buckets = &buckets;
  Frame<kOptions> frame(storage);
  frame.set_tap({&out, record_span});
  out.ids.assign(std::size_t{kRaster} * kRaster, 0);
  std::vector<std::uint32_t> wire((frame.line_bytes() + 3) / 4);  // words: a line begins on a 4-byte boundary
  for (Band rest{0, kRaster}; !rest.empty();) {
    const Band band = frame.prepare(scene, camera, rest);
    if (band.empty()) break;
    while (frame.next_line({reinterpret_cast<std::uint8_t*>(wire.data()), frame.line_bytes()})) {
      const Statistics before = out.statistics;
      out.statistics = frame.statistics();
      out.lines.push_back({out.statistics.segment_references - before.segment_references,
                           out.statistics.output_segments - before.output_segments});
    }
    rest.top = band.bottom;
  }
  return frame.status();
}

Status render(Machine machine, const SceneView& scene, const CameraRecord& camera, const host::PoolSizes& pools,
              Rendering& out) {
  switch (machine) {
    case Machine::vsg5:
      return render<kVsg5>(scene, camera, pools, out);
    case Machine::plane:
      return render<kPlane>(scene, camera, pools, out);
    case Machine::vsg6:
      break;
  }
  return render<kVsg6>(scene, camera, pools, out);
}

}  // namespace

Measured measure(const std::string& folder, const Object& object, Machine machine) {
  const std::string stem = folder + "/" + object.file;
  const std::string place = stem + ".obj";
  host::SceneDescription facing = host::describe_screen_obj(place);
  facing.width = facing.height = kRaster;
  host::CompiledScene scene = host::compile(std::move(facing));
  const SceneRecord record = scene.record();
  const host::PoolSizes pools;
  Rendering out;
  const Status status = render(machine, host::validated(record, place), scene.camera(), pools, out);
  if (!status.ok()) throw host::InputError(place, host::status_text(status));

  const host::SceneCounts counts = host::count_scene(host::describe_screen_obj(stem + ".all.obj"));
  return {nlohmann::json::parse(host::stats_json(counts, out, pools)), out.statistics.active_references,
          std::move(out.ids)};
}

std::vector<ObjectFigures> measure_all(const std::string& folder) {
  std::vector<ObjectFigures> all;
  for (const Object& object : kObject) {
    all.push_back({measure(folder, object, Machine::vsg6), measure(folder, object, Machine::vsg5),
                   measure(folder, object, Machine::plane)});
  }
  return all;
}

}  // namespace spanline::figures
