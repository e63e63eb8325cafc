// What is soldered to what: facts of each controller and its glass, written down apart from the drivers' traits on
// purpose.
#include "panel/models.hpp"

#include "panel/dcs_model.hpp"
#include "panel/ssd1306_model.hpp"
#include "panel/ssd_grey_model.hpp"

namespace spanline::host {
namespace {

constexpr std::uint32_t kDcsAfterResetUs = 5'000;

constexpr std::uint32_t kDcsReadHz = 6'666'666;

// Glass as large as the controller's memory, its columns mirrored, blue first, and a controller that can be asked.
DcsGlass whole_glass(const std::string& name, std::uint32_t max_clock_hz, std::uint16_t width, std::uint16_t height) {
  return {.wire = {.name = name,
                   .max_clock_hz = max_clock_hz,
                   .max_read_hz = kDcsReadHz,
                   .after_reset_us = kDcsAfterResetUs},
          .ram_width = width,
          .ram_height = height,
          .width = width,
          .height = height,
          .mirrored = true,
          .bgr = true};
}

// The data sheet says 10 MHz; 40 MHz is what the trade relies on.
DcsGlass ili9341() { return whole_glass("ili9341", 40'000'000, 240, 320); }

DcsGlass ili9488() {
  DcsGlass glass = whole_glass("ili9488", 40'000'000, 320, 480);
  glass.only_18_bit = true;
  return glass;
}

DcsGlass st7796() {
  DcsGlass glass = whole_glass("st7796", 66'666'666, 320, 480);
  glass.lock = Lock::st7796;
  return glass;
}

DcsGlass st7789(const std::string& name, std::uint16_t width, std::uint16_t height, std::uint16_t left,
                std::uint16_t top) {
  return {.wire = {.name = name, .max_clock_hz = 62'500'000, .after_reset_us = kDcsAfterResetUs},
          .ram_width = 240,
          .ram_height = 320,
          .width = width,
          .height = height,
          .left = left,
          .top = top,
          .inverted = true};
}

DcsGlass gc9a01() {
  return {.wire = {.name = "gc9a01", .max_clock_hz = 100'000'000, .after_reset_us = kDcsAfterResetUs},
          .ram_width = 240,
          .ram_height = 240,
          .width = 240,
          .height = 240,
          .mirrored = true,
          .bgr = true,
          .inverted = true,
          .own_from = 0x60,
          .lock = Lock::gc9a01};
}

// What QEMU 7.2 knows of the SSD0323, and no more: the same image has to run there.
const std::vector<SsdCommand> kSsd0323Commands = {{0x15, 0x15, 2}, {0x75, 0x75, 2}, {0x81, 0x81, 1}, {0x84, 0x86, 0},
                                                  {0xA0, 0xA2, 1}, {0xA4, 0xA7, 0}, {0xA8, 0xA8, 1}, {0xAD, 0xAD, 1},
                                                  {0xAE, 0xAF, 0}, {0xB1, 0xB3, 1}, {0xB8, 0xB8, 8}, {0xBC, 0xBC, 1},
                                                  {0xBE, 0xBF, 1}, {0xE3, 0xE3, 0}};

const std::vector<SsdCommand> kSsd1327Commands = {
    {0x15, 0x15, 2}, {0x75, 0x75, 2}, {0x81, 0x81, 1}, {0xA0, 0xA2, 1}, {0xA4, 0xA7, 0}, {0xA8, 0xA8, 1},
    {0xAB, 0xAB, 1}, {0xAE, 0xAF, 0}, {0xB1, 0xB1, 1}, {0xB3, 0xB3, 1}, {0xB6, 0xB6, 1}, {0xB8, 0xB8, 15},
    {0xB9, 0xB9, 0}, {0xBC, 0xBC, 1}, {0xBE, 0xBE, 1}, {0xD5, 0xD5, 1}, {0xFD, 0xFD, 1}};

SsdGreyGlass ssd0323(const std::string& name, std::uint16_t first_row) {
  return {.wire = {.name = name, .max_clock_hz = 4'000'000, .reset_pulse_us = 3, .after_reset_us = 3},
          .ram_height = 80,
          .height = 64,
          .first_row = first_row,
          .commands = kSsd0323Commands};
}

SsdGreyGlass ssd1327() {
  return {.wire = {.name = "ssd1327", .max_clock_hz = 10'000'000, .reset_pulse_us = 3, .after_reset_us = 3},
          .ram_height = 128,
          .height = 128,
          .mirrored = true,
          .commands = kSsd1327Commands};
}

}  // namespace

std::unique_ptr<PanelModel> make_model(const std::string& panel, const SimClock& clock) {
  const auto dcs = [&](const DcsGlass& glass) { return std::make_unique<DcsModel>(glass, clock); };
  const auto grey = [&](const SsdGreyGlass& glass) { return std::make_unique<SsdGreyModel>(glass, clock); };
  if (panel == "ili9341") return dcs(ili9341());
  if (panel == "st7789") return dcs(st7789(panel, 240, 320, 0, 0));
  if (panel == "st7789-240x240") return dcs(st7789(panel, 240, 240, 0, 0));
  if (panel == "st7789-135x240") return dcs(st7789(panel, 135, 240, 52, 40));
  if (panel == "gc9a01") return dcs(gc9a01());
  if (panel == "ili9488") return dcs(ili9488());
  if (panel == "st7796") return dcs(st7796());
  if (panel == "ssd0323") return grey(ssd0323(panel, 0));
  if (panel == "ssd1325") return grey(ssd0323(panel, 12));
  if (panel == "ssd1327") return grey(ssd1327());
  if (panel == "ssd1306") return std::make_unique<Ssd1306Model>(clock);
  return nullptr;
}

}  // namespace spanline::host
