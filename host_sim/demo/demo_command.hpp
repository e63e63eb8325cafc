#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/geom/screen.hpp"
#include "sim/panel_options.hpp"
#include "sim/verb.hpp"

namespace spanline::host {

// `spanline demo`: what a board shows, drawn on the host by the same code.
class DemoCommand : public Verb {
 public:
  explicit DemoCommand(CLI::App& app);

  // Throws UsageError and InputError.
  void run() const;

 private:
  struct Shown {
    std::unique_ptr<PanelOutput> panel;  // null where the board exists for an emulator only
    Screen screen;
  };
  Shown shown() const;

  bool list_ = false;
  std::optional<std::string> name_, board_, frame_, out_;
  PanelOptions panel_;
};

}  // namespace spanline::host
