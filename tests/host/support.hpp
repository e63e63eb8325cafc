// What the host's tests share.
#pragma once

#include <string>
#include <vector>

#include "assetc/input_error.hpp"

namespace spanline::host {

// What a run of the tool left behind.
struct ToolRun {
  int exit_code;  // -1 where it did not end by itself
  std::string out, err;
};

// Runs the built `spanline` with these arguments, here.
ToolRun run_tool(const std::vector<std::string>& arguments);

// A folder of its own for one test, gone with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return path_ + "/" + name; }
  std::vector<std::string> names() const;  // what it holds, in order

 private:
  std::string path_;
};

// One line of broken/expected.txt: the file, from here, and how its message begins.
struct BrokenFile {
  std::string path;
  std::string message;
};
std::vector<BrokenFile> broken_files();

// The message of the InputError that `action` throws, or "" where it throws none.
template <typename Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace spanline::host
