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

}  // namespace

PanelOutput::PanelOutput(const std::string& panel, int rotation)
    : name_(lower(panel)), run_(PanelRun::make(name_, static_cast<hal::Rotation>(rotation))) {
  const std::vector<std::string>& names = panel_names();
  if (std::find(names.begin(), names.end(), name_) == names.end()) {
    throw UsageError("--panel: '" + printable(panel) + "' is not one of " + known_panels());
  }
  if (!run_) throw UsageError("--rotation: the " + name_ + " can be turned by 0 and 2 only");
}

void PanelOutput::require(hal::Fault fault) const {
  if (fault != hal::Fault::none) throw InputError(name_, hal::name(fault));
}

void PanelOutput::begin_frame() {
  if (!begun_) require(run_->begin());
  begun_ = true;
  require(run_->open({0, 0, width(), height()}));
}

void PanelOutput::line(Slice<const std::uint8_t> wire) {
  turn_ = !turn_;
  std::vector<std::uint8_t>& sent = lines_[turn_ ? 1 : 0];
  sent.assign(wire.begin(), wire.end());
  require(run_->send({sent.data(), static_cast<std::uint32_t>(sent.size())}));
}

Picture PanelOutput::finish_frame() {
  require(run_->wait());
  const std::vector<std::string>& complaints = run_->model().complaints();
  if (!complaints.empty()) throw std::runtime_error(complaints.front());
  return run_->picture();
}

}  // namespace spanline::host
