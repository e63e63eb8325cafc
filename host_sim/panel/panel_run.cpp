#include "panel/panel_run.hpp"

#include <algorithm>

#include "hal/panel/panels.hpp"
#include "panel/models.hpp"

namespace spanline::host {
namespace {

using Wiring = hal::Wires<SimBus, SimPin, SimPin, SimPin, SimClock>;

template <hal::Panel Driver>
class DriverRun final : public PanelRun {
 public:
  DriverRun(const std::string& panel, hal::Rotation rotation)
      : PanelRun(panel, rotation),
        driver_(Wiring(bus_, {bench_, SimPin::data}, {bench_, SimPin::select}, {bench_, SimPin::reset}, clock_)) {}

  PixelFormat format() const override { return Driver::kFormat; }
  std::uint16_t width() const override { return Driver::kWidth; }
  std::uint16_t height() const override { return Driver::kHeight; }
  hal::Fault begin() override { return driver_.begin(); }
  hal::Fault open(const hal::Window& window) override { return driver_.open(window); }
  hal::Window snap(const hal::Window& window) const override { return Driver::snap(window); }
  hal::Fault send(Slice<const std::uint8_t> line) override { return driver_.send(line); }
  hal::Fault wait() override { return driver_.wait(); }
  hal::Fault finish() override { return driver_.finish(); }
  std::uint8_t window_bytes() const override { return Driver::kWindowBytes; }

 private:
  Driver driver_;
};

using Maker = std::unique_ptr<PanelRun> (*)(const std::string& panel, hal::Rotation rotation);

// Null for a rotation that the driver refuses at compile time.
template <template <hal::Rotation, typename> class Driver, hal::Rotation kRotation>
constexpr Maker maker() {
  if constexpr (requires { typename Driver<kRotation, Wiring>; }) {
    return [](const std::string& panel, hal::Rotation rotation) -> std::unique_ptr<PanelRun> {
      return std::make_unique<DriverRun<Driver<kRotation, Wiring>>>(panel, rotation);
    };
  }
  return nullptr;
}

struct Entry {
  const char* name;
  Maker makers[4];
};

template <template <hal::Rotation, typename> class Driver>
constexpr Entry entry(const char* name) {
  return {name,
          {maker<Driver, hal::Rotation::r0>(), maker<Driver, hal::Rotation::r90>(),
           maker<Driver, hal::Rotation::r180>(), maker<Driver, hal::Rotation::r270>()}};
}

constexpr Entry kPanels[] = {
    entry<hal::Ili9341>("ili9341"),
    entry<hal::St7789>("st7789"),
    entry<hal::St7789Square>("st7789-240x240"),
    entry<hal::St7789Narrow>("st7789-135x240"),
    entry<hal::Gc9a01>("gc9a01"),
    entry<hal::Ili9488>("ili9488"),
    entry<hal::St7796>("st7796"),
    entry<hal::Ssd0323>("ssd0323"),
    entry<hal::Ssd1325>("ssd1325"),
    entry<hal::Ssd1327>("ssd1327"),
    entry<hal::Ssd1306>("ssd1306"),
};

}  // namespace

PanelRun::PanelRun(const std::string& panel, hal::Rotation rotation)
    : model_(make_model(panel, clock_)), bench_{.model = *model_, .clock = clock_}, bus_(bench_), rotation_(rotation) {}

std::unique_ptr<PanelRun> PanelRun::make(const std::string& panel, hal::Rotation rotation) {
  const auto* found =
      std::find_if(std::begin(kPanels), std::end(kPanels), [&](const Entry& e) { return panel == e.name; });
  if (found == std::end(kPanels)) return nullptr;
  const Maker make = found->makers[static_cast<unsigned>(rotation)];
  return make == nullptr ? nullptr : make(panel, rotation);
}

const std::vector<std::string>& panel_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Entry& e : kPanels) all.emplace_back(e.name);
    return all;
  }();
  return names;
}

}  // namespace spanline::host
