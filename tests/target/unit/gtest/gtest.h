// As much of GoogleTest as the engine's own tests use, small enough for a microcontroller: on the host the same sources
// are compiled with GoogleTest itself, here they find this file in its place. No iostream, no exceptions; a failure
// names file, line, the expression, its whole-number operands, and the text that the test streams to it.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace testing {

// Text that a test adds to what it expects.
class Message {
 public:
  template <typename T>
  Message& operator<<(const T& value) {
    if constexpr (std::is_enum_v<T>) {
      return *this << static_cast<std::underlying_type_t<T>>(value);
    } else if constexpr (std::is_same_v<T, Message>) {
      text_ += value.text();
    } else if constexpr (std::is_same_v<T, char>) {
      text_ += value;
    } else if constexpr (std::is_integral_v<T>) {
      append(value < T{0}, value < T{0} ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value));
    } else if constexpr (std::is_convertible_v<const T&, std::string>) {
      text_ += std::string(value);
    } else {
      text_ += '?';
    }
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  void append(bool negative, std::uint64_t magnitude);

  std::string text_;
};

class Test {
 public:
  virtual ~Test() = default;
  virtual void SetUp() {}
  virtual void TestBody() = 0;

  // Of the test that runs.
  static bool HasFailure();
  static bool HasFatalFailure();
  // Nobody keeps the report's extras here.
  template <typename T>
  static void RecordProperty(const char*, const T&) {}
};

// A test in the list of all; its constructor puts it there.
class Entry {
 public:
  using Run = void (*)();
  Entry(const char* suite, const char* name, Run run);

  const char* suite;
  const char* name;
  Run run;
  Entry* next;
};

// Runs every test, prints those that fail and, last, how many ran; true where all passed.
bool run_all();

// The outcome of an expectation: empty where it holds, else what was expected.
using Outcome = std::string;

// What `<<` is assigned to reports one failure.
class Failure {
 public:
  Failure(bool fatal, const char* file, int line, Outcome expected)
      : fatal_(fatal), file_(file), line_(line), expected_(static_cast<Outcome&&>(expected)) {}
  void operator=(const Message& message) const;

 private:
  bool fatal_;
  const char* file_;
  int line_;
  Outcome expected_;
};

class Trace {
 public:
  explicit Trace(const Message& message) : text_(message.text()), outer_(innermost) { innermost = this; }
  ~Trace() { innermost = outer_; }
  Trace(const Trace&) = delete;
  Trace& operator=(const Trace&) = delete;
  static std::string all();

 private:
  static inline const Trace* innermost = nullptr;
  std::string text_;
  const Trace* outer_;
};

template <typename A, typename B>
Outcome compared(bool holds, const char* expression, const A& a, const B& b) {
  if (holds) return {};
  return (Message() << expression << ", with " << a << " and " << b).text();
}

inline Outcome truth(bool holds, const char* expression) { return holds ? Outcome() : Outcome(expression); }

inline Outcome near(double a, double b, double most, const char* expression) {
  const double apart = a < b ? b - a : a - b;
  return truth(apart <= most, expression);
}

}  // namespace testing

#define SPANLINE_TEST(suite, test, base)                                                 \
  class suite##_##test##_Test : public base {                                            \
    void TestBody() override;                                                            \
  };                                                                                     \
  static testing::Entry suite##_##test##_entry(#suite, #test, [] {                       \
    suite##_##test##_Test body;                                                          \
    static_cast<testing::Test&>(body).SetUp();                                           \
    if (!testing::Test::HasFatalFailure()) static_cast<testing::Test&>(body).TestBody(); \
  });                                                                                    \
  void suite##_##test##_Test::TestBody()
#define TEST(suite, test) SPANLINE_TEST(suite, test, testing::Test)
#define TEST_F(suite, test) SPANLINE_TEST(suite, test, suite)

// One statement, that an else outside cannot take over.
#define SPANLINE_CHECK(outcome, fatal, on_failure)                               \
  switch (0)                                                                     \
  case 0:                                                                        \
  default:                                                                       \
    if (testing::Outcome spanline_outcome = (outcome); spanline_outcome.empty()) \
      ;                                                                          \
    else                                                                         \
      on_failure testing::Failure(fatal, __FILE__, __LINE__, spanline_outcome) = testing::Message()
#define SPANLINE_EXPECT(outcome) SPANLINE_CHECK(outcome, false, )
#define SPANLINE_ASSERT(outcome) SPANLINE_CHECK(outcome, true, return )

// Each operand is evaluated once.
#define SPANLINE_COMPARED(a, op, b) \
  [](const auto& x, const auto& y) { return testing::compared(x op y, #a " " #op " " #b, x, y); }((a), (b))
#define SPANLINE_SAME_TEXT(a, b) testing::truth(std::strcmp(a, b) == 0, #a " is the text " #b)
#define SPANLINE_NEAR(a, b, most)                                                          \
  testing::near(static_cast<double>(a), static_cast<double>(b), static_cast<double>(most), \
                #a " is within " #most " of " #b)

#define EXPECT_EQ(a, b) SPANLINE_EXPECT(SPANLINE_COMPARED(a, ==, b))
#define EXPECT_NE(a, b) SPANLINE_EXPECT(SPANLINE_COMPARED(a, !=, b))
#define EXPECT_LT(a, b) SPANLINE_EXPECT(SPANLINE_COMPARED(a, <, b))
#define EXPECT_LE(a, b) SPANLINE_EXPECT(SPANLINE_COMPARED(a, <=, b))
#define EXPECT_GT(a, b) SPANLINE_EXPECT(SPANLINE_COMPARED(a, >, b))
#define EXPECT_GE(a, b) SPANLINE_EXPECT(SPANLINE_COMPARED(a, >=, b))
#define EXPECT_TRUE(a) SPANLINE_EXPECT(testing::truth(static_cast<bool>(a), #a))
#define EXPECT_FALSE(a) SPANLINE_EXPECT(testing::truth(!static_cast<bool>(a), "not " #a))
#define EXPECT_STREQ(a, b) SPANLINE_EXPECT(SPANLINE_SAME_TEXT(a, b))
#define EXPECT_NEAR(a, b, most) SPANLINE_EXPECT(SPANLINE_NEAR(a, b, most))
#define ASSERT_EQ(a, b) SPANLINE_ASSERT(SPANLINE_COMPARED(a, ==, b))
#define ASSERT_NE(a, b) SPANLINE_ASSERT(SPANLINE_COMPARED(a, !=, b))
#define ASSERT_LT(a, b) SPANLINE_ASSERT(SPANLINE_COMPARED(a, <, b))
#define ASSERT_LE(a, b) SPANLINE_ASSERT(SPANLINE_COMPARED(a, <=, b))
#define ASSERT_GT(a, b) SPANLINE_ASSERT(SPANLINE_COMPARED(a, >, b))
#define ASSERT_GE(a, b) SPANLINE_ASSERT(SPANLINE_COMPARED(a, >=, b))
#define ASSERT_TRUE(a) SPANLINE_ASSERT(testing::truth(static_cast<bool>(a), #a))
#define ASSERT_FALSE(a) SPANLINE_ASSERT(testing::truth(!static_cast<bool>(a), "not " #a))
#define ASSERT_NEAR(a, b, most) SPANLINE_ASSERT(SPANLINE_NEAR(a, b, most))
#define FAIL() SPANLINE_ASSERT(testing::Outcome("not to come here"))
#define ADD_FAILURE() SPANLINE_EXPECT(testing::Outcome("not to come here"))
#define SPANLINE_JOIN(a, b) a##b
#define SPANLINE_TRACE(line, message) \
  const testing::Trace SPANLINE_JOIN(spanline_trace_, line)(testing::Message() << message)
#define SCOPED_TRACE(message) SPANLINE_TRACE(__LINE__, (message))
