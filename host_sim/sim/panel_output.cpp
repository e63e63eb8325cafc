#include "sim/panel_output.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "assetc/input_error.hpp"
#include "sim/usage_error.hpp"

namespace spanline::host {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string known_panels() {
  std::string all;
  for (const std::string& name : panel_names()) all += (all.empty() ? "" : ", ") + name;
  return all;
}

// Throws UsageError.
std::unique_ptr<PanelRun> opened(const std::string& panel, int rotation) {
  const std::vector<std::string>& names = panel_names();
  if (std::find(names.begin(), names.end(), panel) == names.end()) {
    throw UsageError("--panel: '" + printable(panel) + "' is not one of " + known_panels());
  }
  std::unique_ptr<PanelRun> run = PanelRun::make(panel, static_cast<hal::Rotation>(rotation));
  if (!run) throw UsageError("--rotation: the " + panel + " can be turned by 0 and 2 only");
  return run;
}

}  // namespace

PanelOutput::PanelOutput(const std::string& panel, int rotation, ScanPolicy policy)
    : name_(lower(panel)),
      run_(opened(name_, rotation)),
      shown_(screen(), policy, run_->window_bytes()),
      presenter_(*run_, shown_.storage()) {
  if (policy != ScanPolicy::full && run_->snap({2, 1, 4, 2}).height() != 1) {
    throw UsageError("--scan-out: the " + name_ + " takes whole pages of lines: full only");
  }
}

void PanelOutput::require(hal::Fault fault) const {
  if (fault != hal::Fault::none) throw InputError(name_, hal::name(fault));
}

void PanelOutput::begin_frame(const BackgroundRecord& background) {
  if (!begun_) require(run_->begin());
  begun_ = true;
  presenter_.begin_frame(background);
}

void PanelOutput::line(const FinishedLine& line) {
  std::vector<std::uint8_t>& back = lines_[back_];
  back.assign(line.wire.begin(), line.wire.end());
  bool in_flight;
  require(presenter_.line(line.line, {back.data(), static_cast<std::uint32_t>(back.size())}, in_flight));
  if (in_flight) back_ ^= 1;
}

Picture PanelOutput::finish_frame() {
  require(presenter_.end_frame());
  const std::vector<std::string>& complaints = run_->model().complaints();
  if (!complaints.empty()) throw std::runtime_error(complaints.front());
  return run_->picture();
}

}  // namespace spanline::host
