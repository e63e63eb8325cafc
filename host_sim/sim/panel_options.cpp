#include "sim/panel_options.hpp"

#include <CLI/CLI.hpp>

#include "assetc/input_error.hpp"
#include "sim/arguments.hpp"
#include "sim/output_file.hpp"
#include "sim/usage_error.hpp"

namespace spanline::host {

void PanelOptions::add_to(CLI::App& verb) {
  std::string names;
  for (const std::string& name : panel_names()) names += (names.empty() ? "" : ", ") + name;
  verb.add_option(
      "--panel", panel_,
      "send the picture through this panel's driver and show what its controller makes of the bytes: " + names);
  verb.add_option("--rotation", rotation_, "of the panel, in quarter turns: 0 (default) to 3");
  verb.add_option(
      "--scan-out", scan_out_,
      "what is sent of each line: full (default), extents (what is or was covered), tiles (runs of 16 pixels "
      "that have changed)");
  verb.add_option("--spi-log", spi_log_,
                  "the bytes sent to the panel, two by two: 0 command, 1 data, 2 chip select, 3 reset, then the value");
}

std::unique_ptr<PanelOutput> PanelOptions::make() const {
  const std::int64_t rotation = rotation_ ? parse_integer("--rotation", *rotation_, 0, 3) : 0;
  return make(panel_.value(), static_cast<int>(rotation));
}

std::unique_ptr<PanelOutput> PanelOptions::make(const std::string& panel, int rotation) const {
  auto output = std::make_unique<PanelOutput>(panel, rotation, policy());
  if (spi_log_) output->keep_log();
  return output;
}

ScanPolicy PanelOptions::policy() const {
  if (!scan_out_ || *scan_out_ == "full") return ScanPolicy::full;
  if (*scan_out_ == "extents") return ScanPolicy::extents;
  if (*scan_out_ == "tiles") return ScanPolicy::tiles;
  throw UsageError("--scan-out: '" + printable(*scan_out_) + "' is not one of full, extents, tiles");
}

void PanelOptions::save_log(const PanelOutput& panel) const {
  if (!spi_log_) return;
  const std::vector<std::uint8_t>& log = panel.log();
  write_file(*spi_log_, {reinterpret_cast<const char*>(log.data()), log.size()});
}

}  // namespace spanline::host
