#include "budget/profile_json.hpp"

#include <nlohmann/json.hpp>

#include "budget/plain_name.hpp"

namespace spanline::host {
namespace {

using Json = nlohmann::ordered_json;

// Nothing where neither the node nor anything below it took part in what was counted.
Json node_json(const RunReport& run, std::uint32_t index) {
  const CallTree::Node& node = run.calls.nodes()[index];
  Json children = Json::array();
  for (const auto& [frame, child] : node.children) {
    Json below = node_json(run, child);
    if (!below.is_null()) children.push_back(std::move(below));
  }
  if (node.self.instructions == 0 && children.empty()) return nullptr;
  const bool is_root = node.frame == CallTree::kRoot;
  Json json = {{"name", is_root ? "run" : plain_name(run.places[node.frame].name)},
               {"file", is_root ? "" : run.places[node.frame].file},
               {"stage", name(node.stage)},
               {"self", node.self.cycles == 0 ? node.self.instructions : node.self.busy()},
               {"waiting", node.self.waiting},
               {"instructions", node.self.instructions}};
  if (!children.empty()) json["children"] = std::move(children);
  return json;
}

}  // namespace

std::string profile_json(const RunReport& run) {
  return node_json(run, 0).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace spanline::host
