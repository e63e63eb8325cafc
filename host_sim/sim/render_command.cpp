#include "sim/render_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "assetc/input_error.hpp"
#include "sim/arguments.hpp"
#include "sim/output_file.hpp"
#include "sim/progress.hpp"
#include "sim/status_text.hpp"
#include "sim/usage_error.hpp"

namespace spanline::host {
namespace {

Comparator parse_comparator(const std::string& text) {
  if (text == "plane") return Comparator::plane;
  if (text == "midpoint") return Comparator::midpoint;
  throw UsageError("--comparator: '" + printable(text) + "' is not one of plane, midpoint");
}

Surface parse_surface(const std::string& text) {
  if (text == "dice") return Surface::dice;
  if (text == "points") return Surface::points;
  throw UsageError("--surface: '" + printable(text) + "' is not one of dice, points");
}

// In 1/16 px.
std::uint16_t parse_tolerance(const std::string& text) {
  constexpr double kFinest = 1.0 / 16, kCoarsest = 64;
  const double px = parse_real("--tolerance", text);
  if (!(px >= kFinest && px <= kCoarsest)) throw UsageError("--tolerance: must be from 0.0625 to 64 pixels");
  return static_cast<std::uint16_t>(px * 16);
}

// Both: what the edge walker cannot draw is left to the segment walker.
Walker parse_walker(const std::string& text) {
  if (text == "segments") return Walker::segments;
  if (text == "edges") return Walker::both;
  throw UsageError("--walker: '" + printable(text) + "' is not one of segments, edges");
}

Picture picture_of_ids(const Rendering& rendering) {
  Picture picture(rendering.picture.width, rendering.picture.height);
  std::uint8_t* rgb = picture.rgb.data();
  for (const std::uint32_t id : rendering.ids) {
    *rgb++ = static_cast<std::uint8_t>(id >> 16);
    *rgb++ = static_cast<std::uint8_t>(id >> 8);
    *rgb++ = static_cast<std::uint8_t>(id);
  }
  return picture;
}

constexpr const char* kRenderFooter =
    "At least one of --out, --ids, --depth, --stats, --expect and --spi-log is needed. With --frames, frame 7 of F.png "
    "goes "
    "to "
    "F-0007.png. Where a pool is too small for some line, the picture lacks the highest face numbers there, a warning "
    "names "
    "the pool and the line, and the exit code stays 0.";

}  // namespace

RenderCommand::RenderCommand(CLI::App& app) : Verb(app.add_subcommand("render", "draw a scene into picture files")) {
  scene_.add_to(*verb_);
  verb_->add_option("--out", out_, "the picture, .png or .ppm");
  verb_->add_option("--ids", ids_, "PPM: per pixel 1 + the number of the visible face, 24 bits, high byte red");
  verb_->add_option("--depth", depth_, "16-bit PGM of the depth; larger is nearer, 0 background");
  verb_->add_option("--stats", stats_, "JSON file of the statistics, - for standard output");
  verb_->add_option("--expect", expect_, "compare the picture with this .png: exit 1 and say how many pixels differ");
  verb_->add_option("--frame", frame_, "which frame of the motion (default: 0)");
  verb_->add_option("--frames", frames_, "A:B, all frames from A to B, both included, in numbered files");
  verb_->add_option("--format", format_, "pixels as a panel gets them: rgb565 (default), grey8, grey4, mono1");
  verb_->add_option("--comparator", comparator_, "how depths are compared: plane (default) or midpoint");
  verb_->add_option("--walker", walker_,
                    "what finds the visible spans: edges (default, where the scene has triangle meshes within the view "
                    "and neither --stats nor --comparator asks for the other) or segments");
  verb_->add_option("--surface", surface_,
                    "how patches are drawn: dice (default), or points, stepped off into a band with a depth buffer");
  verb_->add_option("--bands", bands_, "prepare the picture in at least so many equal bands");
  verb_->add_option("--pools", pools_,
                    "NAME=N,...: shrink facets, edges, polygons, segments, samples, implied, vertices, layers, "
                    "patch_facets, patch_vertices, point_lines, curves, strands");
  verb_->add_option("--tolerance", tolerance_, "px that an edge of a diced patch may be off it (default: 0.5)");
  verb_->add_flag("--screen", on_screen_,
                  "the .obj is on the screen already: x, y in 1/16 px, z a depth from 0 to 65535");
  panel_.add_to(*verb_);
  verb_->footer(kRenderFooter);
}

void RenderCommand::check_outputs() const {
  if (!out_ && !ids_ && !depth_ && !stats_ && !expect_ && !panel_.log_given()) {
    throw UsageError("nothing to do: give --out, --ids, --depth, --stats, --expect or --spi-log");
  }
  if (!panel_.panel_given() && (panel_.rotation_given() || panel_.scan_out_given() || panel_.log_given()))
    throw UsageError("--rotation, --scan-out and --spi-log need --panel");
  if (panel_.panel_given() && scene_.size_given()) throw UsageError("--size: the panel's size is the picture's");
  if (panel_.panel_given() && format_) throw UsageError("--format: the panel's pixels are the picture's");
  if (out_) check_picture_path(*out_);
  if (expect_ && !png_available()) throw UsageError("--expect: this build has no libpng to read PNG files");
  if (expect_ && frames_) throw UsageError("--expect compares one picture: choose it with --frame");
  if (frame_ && frames_) throw UsageError("--frame and --frames exclude each other");
}

RenderCommand::Frames RenderCommand::frames() const {
  constexpr std::int64_t kMaxFrame = 1'000'000'000;
  Frames range;
  if (frame_) range.first = range.last = parse_integer("--frame", *frame_, 0, kMaxFrame);
  if (frames_) {
    std::tie(range.first, range.last) = parse_range("--frames", *frames_);
    range.numbered = true;
  }
  return range;
}

SceneDescription RenderCommand::description(const PanelOutput* panel) const {
  SceneDescription scene = scene_.load(on_screen_);
  if (panel != nullptr) {
    scene.width = panel->width();
    scene.height = panel->height();
  }
  return scene;
}

EngineOptions RenderCommand::engine_options(const SceneDescription& scene) const {
  EngineOptions options;
  options.width = scene.width;
  options.height = scene.height;
  options.observe = ids_ || depth_ || stats_;
  if (format_) options.format = parse_format("--format", *format_);
  if (comparator_) options.comparator = parse_comparator(*comparator_);
  // The statistics are the segment walker's, and the comparators are two of its ways.
  options.walker = stats_ || comparator_ ? Walker::segments : Walker::both;
  if (walker_) options.walker = parse_walker(*walker_);
  const auto of_patches = [](const MeshSource& mesh) { return mesh.of_patches(); };
  if (surface_ && parse_surface(*surface_) == Surface::points &&
      std::any_of(scene.meshes.begin(), scene.meshes.end(), of_patches)) {
    options.surface = Surface::points;
  }
  if (bands_) options.bands = static_cast<std::uint16_t>(parse_integer("--bands", *bands_, 1, kMaxExtent));
  if (tolerance_) options.pools.patch_tolerance = parse_tolerance(*tolerance_);
  if (pools_) {
    for (const PoolLimit& limit : parse_pools("--pools", *pools_)) {
      std::uint16_t& size = *options.pools.find(limit.name);
      size = std::min(size, limit.limit);
    }
  }
  return options;
}

void RenderCommand::write_outputs(const Rendering& rendering, const SceneCounts& counts, const PoolSizes& pools,
                                  const Frames& range, std::int64_t frame) const {
  const auto path = [&](const std::string& name) {
    return range.numbered ? numbered_path(name, frame, range.last) : name;
  };
  const Picture& picture = rendering.picture;
  if (out_) write_picture(path(*out_), picture);
  if (ids_) write_file(path(*ids_), encode_ppm(picture_of_ids(rendering)));
  if (depth_) write_file(path(*depth_), encode_pgm16(picture.width, picture.height, rendering.depth));
  if (!stats_) return;
  const std::string text = stats_json(counts, rendering, pools);
  if (*stats_ == "-") {
    std::cout << text << std::flush;
  } else {
    write_file(path(*stats_), text);
  }
}

void RenderCommand::compare_with_expected(const Picture& picture) const {
  const Picture expected = read_png(*expect_);
  if (expected.width != picture.width || expected.height != picture.height) {
    throw InputError(*expect_, "is " + std::to_string(expected.width) + "x" + std::to_string(expected.height) +
                                   ", the picture is " + std::to_string(picture.width) + "x" +
                                   std::to_string(picture.height));
  }
  std::size_t differ = 0, first = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
    if (std::equal(&picture.rgb[i], &picture.rgb[i] + 3, &expected.rgb[i])) continue;
    if (differ++ == 0) first = i / 3;
  }
  if (differ == 0) return;
  throw InputError(*expect_, std::to_string(differ) + " of " + std::to_string(picture.rgb.size() / 3) +
                                 " pixels differ, the first at column " + std::to_string(first % picture.width) +
                                 ", line " + std::to_string(first / picture.width));
}

void RenderCommand::run() const {
  check_outputs();
  const Frames range = frames();
  const std::unique_ptr<PanelOutput> panel = panel_.panel_given() ? panel_.make() : nullptr;
  CompiledScene scene = compile(description(panel.get()));
  EngineOptions options = engine_options(scene.description());
  if (panel) {
    options.format = panel->format();
    options.on_line = [&panel](const FinishedLine& line) { panel->line(line); };
  }
  const std::unique_ptr<Engine> engine = Engine::make(options);
  const SceneCounts counts = stats_ ? count_scene(scene.description()) : SceneCounts{};
  Progress progress("frame", range.last - range.first + 1);
  Rendering rendering;
  for (std::int64_t frame = range.first; frame <= range.last; ++frame) {
    scene.show(frame);
    if (panel) panel->begin_frame(scene.description().background);
    const SceneRecord record = scene.record();
    const SceneView view = validated(record, scene.description().place);
    if (options.surface == Surface::points && view.layered()) {
      throw InputError(scene.description().place,
                       "--surface points: surface detail and see-through polygons need --surface dice");
    }
    const Status status = engine->render(view, scene.camera(), rendering);
    if (!status.ok()) throw InputError(scene.description().place, status_text(status));
    if (!rendering.status.ok()) {
      progress.warn(scene.description().place + ": frame " + std::to_string(frame) + ": " +
                    status_text(rendering.status));
    }
    if (panel) rendering.picture = panel->finish_frame();
    write_outputs(rendering, counts, options.pools, range, frame);
    progress.step();
  }
  if (panel) panel_.save_log(*panel);
  if (expect_) compare_with_expected(rendering.picture);
}

}  // namespace spanline::host
