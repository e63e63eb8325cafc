// A panel's driver, chosen at run time, wired to the model of its controller.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "panel/bench.hpp"

namespace spanline::host {

class PanelRun {
 public:
  // Null where no panel has this name or the panel cannot be turned so: only half turns on the SSD controllers.
  static std::unique_ptr<PanelRun> make(const std::string& panel, hal::Rotation rotation);
  virtual ~PanelRun() = default;

  // The driver, as hal::Panel has it.
  virtual PixelFormat format() const = 0;
  virtual std::uint16_t width() const = 0;
  virtual std::uint16_t height() const = 0;
  virtual hal::Fault begin() = 0;
  virtual hal::Fault open(const hal::Window& window) = 0;
  virtual hal::Window snap(const hal::Window& window) const = 0;
  virtual hal::Fault send(Slice<const std::uint8_t> line) = 0;
  virtual hal::Fault wait() = 0;
  virtual hal::Fault finish() = 0;
  virtual std::uint8_t window_bytes() const = 0;

  // What the panel shows to a viewer for whom the picture is upright.
  Picture picture() const { return turned(model_->picture(), rotation_); }

  PanelModel& model() { return *model_; }
  Bench& bench() { return bench_; }
  SimBus& bus() { return bus_; }

 protected:
  PanelRun(const std::string& panel, hal::Rotation rotation);

  SimClock clock_;
  std::unique_ptr<PanelModel> model_;
  Bench bench_;
  SimBus bus_;
  hal::Rotation rotation_;
};

// The panels' names, as --panel takes them.
const std::vector<std::string>& panel_names();

}  // namespace spanline::host
