#include "budget/budget_table.hpp"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "assetc/input_error.hpp"
#include "assetc/text_file.hpp"

namespace spanline::host {
namespace {

using Json = nlohmann::json;

std::string thousands(std::uint64_t number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i != 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string amount(const Json& json) { return json.is_number_unsigned() ? thousands(json.get<std::uint64_t>()) : "–"; }

std::string real(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return value > 0 ? text.str() : "–";
}

std::string rate(const Json& json) { return real(json.get<double>(), 1); }

// The fullest pool whose size is not the screen's: "samples 36/64".
std::string fullest_pool(const Json& pools) {
  std::string name = "–";
  double most = 0;
  for (const Json& pool : pools) {
    const double capacity = pool.at("capacity"), used = pool.at("used");
    if (pool.at("name") == "buckets" || pool.at("name") == "vertices" || used / capacity <= most) continue;
    most = used / capacity;
    name = pool.at("name").get<std::string>() + " " + std::to_string(pool.at("used").get<unsigned>()) + "/" +
           std::to_string(pool.at("capacity").get<unsigned>());
  }
  return name;
}

std::string row_of(const Json& report) {
  const Json& frames = report.at("frames");
  const bool timed = !report.at("cycles").is_null();
  const Json& fps = frames.at("frames_a_second");
  const std::string image = report.at("image"), demo = image.substr(0, image.rfind('.'));
  std::ostringstream row;
  row << "| " << report.at("board").get<std::string>() << " | " << demo << " | "
      << report.at("core").get<std::string>().substr(7) << " | " << amount(report.at("memory").at("flash")) << " | "
      << amount(report.at("memory").at("ram")) << " | " << amount(report.at("stack").at("reached")) << " | "
      << amount(report.at("stack").value("bound", Json())) << " | " << amount(frames.at("instructions").at("median"))
      << " | " << (timed ? amount(frames.at("cycles").at("median")) : "–") << " | "
      << (timed ? amount(frames.at("cycles").at("most")) : "–") << " | " << (timed ? rate(fps.at("compute")) : "–")
      << " | " << rate(fps.at("wire")) << " | " << (timed ? rate(fps.at("both")) : "–") << " | "
      << (frames.at("pace").is_null() || frames.at("bytes") == 0 ? "–" : real(frames.at("pace"), 3)) << " | "
      << amount(frames.at("ring_lines")) << " | " << fullest_pool(report.at("pools")) << " |\n";
  return row.str();
}

}  // namespace

std::string budget_table(const std::vector<std::string>& reports) {
  std::string table =
      "| board | demo | core | flash | RAM | stack reached | stack bound | instructions | cycles, median | cycles, "
      "worst | "
      "f/s compute | f/s wire | f/s | pace | ring | fullest pool |\n"
      "|---|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|---|\n";
  for (const std::string& path : reports) {
    try {
      table += row_of(Json::parse(read_file(path)));
    } catch (const Json::exception&) {
      throw InputError(path, "is no report of `spanline budget --json` with frames");
    }
  }
  return table;
}

}  // namespace spanline::host
