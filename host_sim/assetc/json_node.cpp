#include "assetc/json_node.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "assetc/text_file.hpp"

namespace spanline::host {
namespace {

using nlohmann::json;

std::string shown(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

// The library's own words without its tag and its count of lines: "unexpected end of input; expected …". It quotes
// bytes as they are: what is not ASCII becomes '?'.
std::string cause(std::string what) {
  for (char& c : what) {
    if (static_cast<unsigned char>(c) > 0x7f) c = '?';
  }
  for (const std::string_view mark : {" - ", "]: ", "] "}) {
    const std::size_t at = what.find(mark);
    if (at != std::string::npos) return what.substr(at + mark.size());
  }
  return what;
}

// `place`: index of the byte.
[[noreturn]] void fail_syntax(const std::string& file, std::string_view text, std::size_t place, const char* what) {
  const std::string_view before = text.substr(0, place);
  const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  throw InputError(file, line,
                   "column " + std::to_string(before.size() - line_start + 1) + ": not valid JSON: " + cause(what));
}

// Where the number stands that "number overflow parsing '1e999'" quotes.
std::size_t place_of_quoted(std::string_view text, std::string_view what) {
  const std::size_t first = what.find('\'') + 1, last = what.rfind('\'');
  const std::size_t place = last > first ? text.find(what.substr(first, last - first)) : 0;
  return place == std::string_view::npos ? 0 : place;
}

// Refuses a key that an object already has: the library would take the last silently.
class TwinGuard {
 public:
  explicit TwinGuard(const std::string& file) : file_(file) {}

  bool operator()(json::parse_event_t event, const json& parsed) {
    if (event == json::parse_event_t::object_start) {
      open_.emplace_back();
    } else if (event == json::parse_event_t::object_end) {
      open_.pop_back();
    } else if (event == json::parse_event_t::key) {
      take_key(parsed.get_ref<const std::string&>());
    }
    return true;
  }

 private:
  struct Object {
    std::set<std::string> keys;
    std::string last;
  };

  void take_key(const std::string& key) {
    if (!open_.back().keys.insert(key).second) {
      std::string path;
      for (std::size_t i = 0; i + 1 < open_.size(); ++i) path += "/" + printable(open_[i].last);
      throw InputError(file_ + ": " + (path.empty() ? "/" : path), "key '" + printable(key) + "' is written twice");
    }
    open_.back().last = key;
  }

  std::string file_;
  std::vector<Object> open_;  // from the outermost in
};

}  // namespace

json parse_json(const std::string& file, std::string_view text) {
  TwinGuard guard(file);
  try {
    return json::parse(text, [&](int, json::parse_event_t event, json& parsed) { return guard(event, parsed); });
  } catch (const json::parse_error& error) {
    fail_syntax(file, text, std::min(error.byte == 0 ? 0 : error.byte - 1, text.size()), error.what());
  } catch (const json::exception& error) {
    fail_syntax(file, text, place_of_quoted(text, error.what()), error.what());
  }
}

void JsonNode::allow_keys(std::initializer_list<std::string_view> keys) const {
  if (!value_->is_object()) fail("must be an object");
  for (const auto& [key, value] : value_->items()) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) fail("unknown key '" + printable(key) + "'");
  }
}

std::optional<JsonNode> JsonNode::find(const char* key) const {
  const auto found = value_->find(key);
  if (found == value_->end()) return std::nullopt;
  return child(*found, key);
}

JsonNode JsonNode::require(const char* key) const {
  const std::optional<JsonNode> found = find(key);
  if (!found) fail(std::string("key '") + key + "' is missing");
  return *found;
}

std::vector<JsonNode> JsonNode::elements(std::size_t least) const {
  if (!value_->is_array()) fail("must be a list");
  if (value_->size() < least) {
    fail(least == 1 ? "must not be empty" : "must have at least " + std::to_string(least) + " elements");
  }
  std::vector<JsonNode> nodes;
  nodes.reserve(value_->size());
  for (std::size_t i = 0; i < value_->size(); ++i) nodes.push_back(child((*value_)[i], std::to_string(i)));
  return nodes;
}

double JsonNode::number(double low, double high) const {
  if (!value_->is_number()) fail("must be a number");
  const double value = value_->get<double>();
  if (!(value >= low && value <= high)) fail("must be from " + shown(low) + " to " + shown(high));
  return value;
}

std::int64_t JsonNode::whole(std::int64_t low, std::int64_t high) const {
  const auto range = [&] {
    fail("must be a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  };
  if (!value_->is_number_integer()) range();
  if (value_->is_number_unsigned() && value_->get<std::uint64_t>() > static_cast<std::uint64_t>(INT64_MAX)) range();
  const auto value = value_->get<std::int64_t>();
  if (value < low || value > high) range();
  return value;
}

bool JsonNode::boolean() const {
  if (!value_->is_boolean()) fail("must be true or false");
  return value_->get<bool>();
}

std::string JsonNode::text() const {
  if (!value_->is_string() || value_->get_ref<const std::string&>().empty()) fail("must be a text that is not empty");
  return value_->get<std::string>();
}

std::vector<double> JsonNode::numbers(std::size_t count) const {
  if (!value_->is_array() || value_->size() != count) fail("must be a list of " + std::to_string(count) + " numbers");
  std::vector<double> values;
  for (const JsonNode& element : elements()) values.push_back(element.number(-kMaxCoordinate, kMaxCoordinate));
  return values;
}

Vec3 JsonNode::point() const {
  const std::vector<double> n = numbers(3);
  return {n[0], n[1], n[2]};
}

}  // namespace spanline::host
