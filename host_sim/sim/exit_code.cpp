#include "sim/exit_code.hpp"

#include <CLI/CLI.hpp>
#include <iostream>

#include "assetc/input_error.hpp"
#include "sim/usage_error.hpp"

namespace spanline::host {
namespace {

constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;

int complain(const std::string& text, int code) {
  std::cerr << "spanline: " << one_line(text) << "\n";
  return code;
}

}  // namespace

int exit_code_of(CLI::App& app, const std::function<void()>& work) {
  try {
    work();
    return 0;
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return complain(error.what(), kWrongUsage);
  } catch (const UsageError& error) {
    return complain(error.what(), kWrongUsage);
  } catch (const std::exception& error) {
    return complain(error.what(), kFailed);
  }
}

}  // namespace spanline::host
