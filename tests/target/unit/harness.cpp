#include <gtest/gtest.h>

#include "boards/common/report.hpp"

namespace testing {
namespace {

using spanline::boards::print;

Entry* newest = nullptr;
bool failed = false, failed_for_good = false;

void print_name(const Entry& entry) {
  print(entry.suite);
  print(".");
  print(entry.name);
}

// Oldest first: the list holds them the other way round.
const Entry* in_order() {
  Entry* turned = nullptr;
  for (Entry* at = newest; at != nullptr;) {
    Entry* const moved = at;
    at = at->next;
    moved->next = turned;
    turned = moved;
  }
  return turned;
}

}  // namespace

void Message::append(bool negative, std::uint64_t magnitude) {
  char digits[21];
  char* at = digits + sizeof digits - 1;
  *at = 0;
  do {
    *--at = static_cast<char>('0' + magnitude % 10);
    magnitude /= 10;
  } while (magnitude != 0);
  if (negative) *--at = '-';
  text_ += at;
}

Entry::Entry(const char* of_suite, const char* of_name, Run to_run)
    : suite(of_suite), name(of_name), run(to_run), next(newest) {
  newest = this;
}

bool Test::HasFailure() { return failed; }
bool Test::HasFatalFailure() { return failed_for_good; }

void Failure::operator=(const Message& message) const {
  failed = true;
  failed_for_good = failed_for_good || fatal_;
  const std::string text =
      (Message() << file_ << ":" << line_ << ": expected: " << expected_ << " " << message << Trace::all() << "\n")
          .text();
  print(text.c_str());
}

std::string Trace::all() {
  std::string text;
  for (const Trace* at = innermost; at != nullptr; at = at->outer_) text += " [" + at->text_ + "]";
  return text;
}

bool run_all() {
  std::uint32_t ran = 0, bad = 0;
  for (const Entry* entry = in_order(); entry != nullptr; entry = entry->next, ++ran) {
    failed = failed_for_good = false;
    entry->run();
    if (!failed) continue;
    ++bad;
    print("failed: ");
    print_name(*entry);
    print("\n");
  }
  print("tests ran=");
  print(ran);
  print(" failed=");
  print(bad);
  print("\n");
  return bad == 0;
}

}  // namespace testing
