// A lantern that turns on a board's panel: the frame one way, the flame the other. A line is computed while the one
// before is on its way to the panel. Nothing here knows which board: its types say what its panel takes.
#include "board.hpp"
#include "boards/common/frame_marks.hpp"
#include "boards/common/report.hpp"
#include "boards/common/run_request.hpp"
#include "core/frame/frame.hpp"
#include "core/fx/bits.hpp"
#include "core/fx/sine.hpp"
#include "scene.hpp"

namespace {

using namespace spanline;
using boards::Board;
using Panel = Board::Panel;

constexpr Budget kBudget{.width = Panel::kWidth,
                         .height = Panel::kHeight,
                         .format = Panel::kFormat,
                         .facets = 32,
                         .vertices = 32,
                         .polygons = 24,
                         .gouraud = false};

FrameMemory<kBudget> memory;  // all that the engine ever needs: no heap, no frame buffer
alignas(4) std::uint8_t lines[2][bytes_per_line(Panel::kFormat, Panel::kWidth)];
constinit Board board;
constinit InstanceRecord instances[2]{};

// After a fault the light blinks its number (docs/porting.md).
void demand(hal::Fault fault) {
  if (fault != hal::Fault::none) boards::stop(hal::name(fault), static_cast<std::uint32_t>(fault), 0, 0);
}

void demand(const Status& status) {
  if (!status.ok()) boards::stop(status.where, 8 + static_cast<std::uint32_t>(status.code), status.line, 0);
}

Fx16 times(Fx30 factor, Fx16 value) {
  return Fx16::from_raw(static_cast<std::int32_t>(shift_round(std::int64_t{factor.raw} * value.raw, 30)));
}

// About the world's vertical: [x'; z'] = [cos sin; -sin cos] [x; z], in every column of the matrix.
void turn(Transform& transform, Turn16 angle) {
  auto& x = transform.matrix[0];
  auto& z = transform.matrix[2];
  for (unsigned column = 0; column < 3; ++column) {
    const Fx16 old = x[column];
    x[column] = times(cosine(angle), old) + times(sine(angle), z[column]);
    z[column] = times(cosine(angle), z[column]) - times(sine(angle), old);
  }
}

// From the compiled scene anew in every frame, so that no rounding adds up.
void pose(std::uint32_t number) {
  for (unsigned i = 0; i < 2; ++i) instances[i] = scene::scene.instances[i];
  turn(instances[0].transform, {static_cast<std::uint16_t>(number * 300)});
  turn(instances[1].transform, {static_cast<std::uint16_t>(0 - number * 500)});
}

void draw(Frame<>& frame, const SceneView& view, const CameraRecord& camera, Panel& panel) {
  demand(panel.open(panel.all()));
  unsigned back = 0;
  for (Band rest{0, Panel::kHeight}; !rest.empty();) {
    const Band band = frame.prepare(view, camera, rest);
    if (band.empty()) break;
    while (frame.next_line(lines[back])) {
      demand(panel.send(lines[back]));
      back ^= 1;
    }
    rest.top = band.bottom;
  }
  demand(panel.wait());
  demand(frame.status());
}

}  // namespace

void spanline::boards::light(bool on) { Board::light(on); }
extern "C" void tick() { Board::tick(); }

int main() {
  demand(board.begin());
  Panel& panel = board.panel();
  demand(panel.begin());

  SceneRecord moving = scene::scene;
  moving.instances = instances;
  pose(0);
  SceneView view;
  demand(SceneView::validate(moving, view));

  // The scene was laid out for a square: it fits the panel's shorter side.
  CameraRecord camera = scene::camera;
  constexpr std::int32_t kSide = Panel::kWidth < Panel::kHeight ? Panel::kWidth : Panel::kHeight;
  camera.focal = Fx12::from_raw(camera.focal.raw / scene::kHeight * kSide);

  Frame<> frame(memory.storage());
  for (std::uint32_t number = 0;; ++number) {
    frame_begin_mark();  // what counts cycles counts between the marks (docs/budget.md)
    pose(number);
    draw(frame, view, camera, panel);
    frame_end_mark();
    // Only an emulator asks for an end.
    if (boards::request().made() && number == boards::request().last_frame) {
      boards::print("shown frame=");
      boards::print(number);
      boards::print("\n");
      board.rest();
    }
  }
}
