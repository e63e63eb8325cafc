#include "core/base/status.hpp"

namespace spanline {

Status bad_argument(const char* where, const char* field, std::uint32_t line, std::uint32_t value,
                    std::uint32_t limit) {
  return {Code::bad_argument, where, field, 0, line, value, limit};
}

Status bad_record(const char* record, const char* field, std::uint32_t index, std::uint32_t value) {
  return {Code::bad_record, record, field, index, 0, value};
}

Status pool_exhausted(const char* pool, std::uint32_t line, std::uint32_t needed, std::uint32_t capacity) {
  return {Code::pool_exhausted, pool, "", 0, line, needed, capacity};
}

}  // namespace spanline
