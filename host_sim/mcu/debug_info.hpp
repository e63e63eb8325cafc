// What the debug information of an image tells: which functions are inlined where, and what a structure is made of.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace spanline::host {

class DebugInfo {
 public:
  struct Frame {
    std::string name;  // without template arguments
    std::string file;  // that defines it, as the compiler was given it
  };
  struct Member {
    std::string name;
    std::string type;             // of one element, with template arguments
    std::uint32_t offset, bytes;  // in the structure
    std::uint32_t elements = 1;   // of an array
  };
  struct Structure {
    std::uint32_t bytes = 0;
    std::vector<Member> members;
  };

  // An image without debug information has none of it.
  explicit DebugInfo(const std::string& path);
  ~DebugInfo();
  DebugInfo(const DebugInfo&) = delete;
  DebugInfo& operator=(const DebugInfo&) = delete;

  // The function at `address` and what is inlined there, outermost first; empty where nothing is known.
  std::vector<Frame> frames_at(std::uint32_t address) const;

  // The file that defines the function or variable at `address`; empty where nothing is known.
  std::string file_of(std::uint32_t address) const;

  // The first structure whose name begins so.
  std::optional<Structure> structure(const std::string& name_begin) const;

 private:
  struct Reader;
  std::unique_ptr<Reader> reader_;
};

}  // namespace spanline::host
