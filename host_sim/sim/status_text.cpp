#include "sim/status_text.hpp"

#include <string_view>

#include "assetc/input_error.hpp"

namespace spanline::host {

namespace {

bool of_curves(std::string_view pool) { return pool == "curves" || pool == "strands"; }

}  // namespace

std::string status_text(const Status& status) {
  const std::string figures = std::to_string(status.needed) + " (limit " + std::to_string(status.limit) + ")";
  switch (status.code) {
    case Code::ok:
      return "done";
    case Code::pool_exhausted:
      return std::string("pool '") + status.where + "' is too small: line " + std::to_string(status.line) + " needs " +
             std::to_string(status.needed) + ", it has " + std::to_string(status.limit) + "; the highest " +
             (of_curves(status.where) ? "curve" : "face") + " numbers are left out";
    case Code::unclosed:
      return "face " + std::to_string(status.index) + " is not closed on line " + std::to_string(status.line);
    case Code::bad_record:
      return std::string("record ") + status.where + " " + std::to_string(status.index) + ", field '" + status.field +
             "': bad value " + figures;
    default:
      return std::string(status.where) + ", field '" + status.field + "': out of range: " + figures;
  }
}

SceneView validated(const SceneRecord& record, const std::string& place) {
  SceneView view;
  const Status status = SceneView::validate(record, view);
  if (!status.ok()) throw InputError(place, status_text(status));
  return view;
}

}  // namespace spanline::host
