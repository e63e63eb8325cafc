// A JSON value that knows its place, read strictly: every wrong type, range and unknown key names file and path.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "assetc/input_error.hpp"
#include "assetc/vec.hpp"

namespace spanline::host {

// Parses a whole document. Throws InputError with line and column of a syntax error, and for a key written twice.
nlohmann::json parse_json(const std::string& file, std::string_view text);

class JsonNode {
 public:
  JsonNode(const nlohmann::json& value, std::string file, std::string path = "")
      : value_(&value), file_(std::move(file)), path_(std::move(path)) {}

  [[noreturn]] void fail(const std::string& text) const { throw InputError(place(), text); }
  std::string place() const { return file_ + ": " + (path_.empty() ? "/" : path_); }
  const std::string& file() const { return file_; }

  bool is_array() const { return value_->is_array(); }
  bool is_string() const { return value_->is_string(); }
  bool is_object() const { return value_->is_object(); }
  std::size_t size() const { return value_->size(); }

  // Fails unless this is an object with no keys but these.
  void allow_keys(std::initializer_list<std::string_view> keys) const;
  std::optional<JsonNode> find(const char* key) const;
  JsonNode require(const char* key) const;

  // The elements of an array; fails where it has fewer than `least`.
  std::vector<JsonNode> elements(std::size_t least = 0) const;

  double number(double low, double high) const;
  std::int64_t whole(std::int64_t low, std::int64_t high) const;
  bool boolean() const;
  std::string text() const;  // not empty
  Vec3 point() const;        // three numbers within ±1e12

  // Exactly `count` numbers within ±1e12.
  std::vector<double> numbers(std::size_t count) const;

 private:
  JsonNode child(const nlohmann::json& value, const std::string& step) const {
    return {value, file_, path_ + "/" + printable(step)};
  }

  const nlohmann::json* value_;
  std::string file_;
  std::string path_;
};

}  // namespace spanline::host
