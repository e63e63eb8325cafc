#pragma once

#include <memory>
#include <string>

#include "panel/panel_model.hpp"

namespace spanline::host {

// The model of a panel by the name that --panel knows; null where there is none.
std::unique_ptr<PanelModel> make_model(const std::string& panel, const SimClock& clock);

}  // namespace spanline::host
