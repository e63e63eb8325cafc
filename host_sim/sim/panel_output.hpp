// Pictures sent through a panel's driver into the model of its controller: --panel.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "boards/common/presenter.hpp"
#include "panel/panel_run.hpp"
#include "sim/engine.hpp"
#include "sim/host_memory.hpp"

namespace spanline::host {

class PanelOutput {
 public:
  // `rotation` 0 to 3. Throws UsageError for a name that is not one of panel_names(), and for a turn or a policy that
  // the panel does not allow.
  PanelOutput(const std::string& panel, int rotation, ScanPolicy policy);

  PixelFormat format() const { return run_->format(); }
  std::uint16_t width() const { return run_->width(); }
  std::uint16_t height() const { return run_->height(); }

  // Keeps the stream from here on: records of two bytes, the kind (0 command, 1 data, 2 chip select, 3 reset) and the
  // value.
  void keep_log() { run_->bench().keep_log = true; }
  const std::vector<std::uint8_t>& log() const { return run_->bench().log; }

  // Sends a picture line by line, each while the next one is made; before the first, initialises the panel.
  // Throws InputError for a fault, finish_frame() an error that says what the model complains about.
  void begin_frame(const BackgroundRecord& background);
  void line(const FinishedLine& line);
  Picture finish_frame();

 private:
  void require(hal::Fault fault) const;
  Screen screen() const { return {width(), height(), format()}; }

  std::string name_;
  std::unique_ptr<PanelRun> run_;
  HostScanOutMemory shown_;
  boards::Presenter<PanelRun> presenter_;
  std::vector<std::uint8_t> lines_[2];  // by turns: one is in flight
  unsigned back_ = 0;
  bool begun_ = false;
};

}  // namespace spanline::host
