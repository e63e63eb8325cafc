// --panel, --rotation, --scan-out and --spi-log, for every verb that can send its picture through a panel.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "sim/cli_app.hpp"
#include "sim/panel_output.hpp"

namespace spanline::host {

class PanelOptions {
 public:
  void add_to(CLI::App& verb);
  bool panel_given() const { return panel_.has_value(); }
  bool log_given() const { return spi_log_.has_value(); }
  bool rotation_given() const { return rotation_.has_value(); }
  bool scan_out_given() const { return scan_out_.has_value(); }

  // The panel of --panel, turned by --rotation. Throws UsageError.
  std::unique_ptr<PanelOutput> make() const;
  // Another verb's panel, whose stream is kept where --spi-log wants it.
  std::unique_ptr<PanelOutput> make(const std::string& panel, int rotation) const;

  // Writes the stream of `panel` where --spi-log asks for it.
  void save_log(const PanelOutput& panel) const;

 private:
  ScanPolicy policy() const;

  std::optional<std::string> panel_, rotation_, scan_out_, spi_log_;
};

}  // namespace spanline::host
