// The contract of hal::Panel, for every driver in every rotation that it allows.
#include "hal/panel_support.hpp"

namespace spanline::host {
namespace {

using hal::Fault;
using hal::Window;

class PanelContract : public testing::TestWithParam<Turn> {
 protected:
  void SetUp() override {
    run_ = PanelRun::make(GetParam().panel, GetParam().rotation);
    ASSERT_TRUE(run_);
    line_.assign(bytes_per_line(run_->format(), run_->width()), 0);
  }
  void expect_no_complaints() { EXPECT_EQ(run_->model().complaints(), std::vector<std::string>{}); }

  std::unique_ptr<PanelRun> run_;
  Line line_;  // of the whole width
};

TEST_P(PanelContract, TakesAWholePictureAndNotALineMore) {
  ASSERT_EQ(run_->begin(), Fault::none);
  ASSERT_EQ(run_->open(all_of(*run_)), Fault::none);
  for (int y = 0; y < run_->height(); ++y) ASSERT_EQ(run_->send(view(line_)), Fault::none);
  EXPECT_EQ(run_->send(view(line_)), Fault::bad_window);
  EXPECT_EQ(run_->wait(), Fault::none);
  EXPECT_EQ(run_->wait(), Fault::none);
  EXPECT_TRUE(run_->bench().select_level);
  expect_no_complaints();
}

TEST_P(PanelContract, RefusesALineWithNoWindowOpen) {
  ASSERT_EQ(run_->begin(), Fault::none);
  EXPECT_EQ(run_->send(view(line_)), Fault::bad_window);
  expect_no_complaints();
}

TEST_P(PanelContract, RefusesALineOfAnotherWidth) {
  ASSERT_EQ(run_->begin(), Fault::none);
  ASSERT_EQ(run_->open(all_of(*run_)), Fault::none);
  line_.push_back(0);
  EXPECT_EQ(run_->send(view(line_)), Fault::bad_window);
  EXPECT_EQ(run_->send({line_.data(), 1}), Fault::bad_window);
  EXPECT_EQ(run_->send({}), Fault::bad_window);
  expect_no_complaints();
}

TEST_P(PanelContract, RefusesAWindowThatDoesNotFit) {
  ASSERT_EQ(run_->begin(), Fault::none);
  const std::uint16_t w = run_->width(), h = run_->height();
  const auto after = [](std::uint16_t n) { return static_cast<std::uint16_t>(n + 8); };
  for (const Window& window :
       {Window{0, 0, 0, h}, Window{0, 0, w, 0}, Window{8, 0, 8, h}, Window{16, 0, 8, h}, Window{0, 0, after(w), h},
        Window{0, 0, w, after(h)}, Window{0, 16, w, 8}, Window{w, h, after(w), after(h)}}) {
    EXPECT_EQ(run_->open(window), Fault::bad_window);
    EXPECT_EQ(run_->send(view(line_)), Fault::bad_window);
  }
  expect_no_complaints();
}

TEST_P(PanelContract, SnapsToTheSmallestWindowThatOpens) {
  ASSERT_EQ(run_->begin(), Fault::none);
  oracle::Random random(31);
  for (int i = 0; i < 50; ++i) {
    Window window{};
    window.left = static_cast<std::uint16_t>(random.below(run_->width()));
    window.right = static_cast<std::uint16_t>(random.between(window.left + 1, run_->width()));
    window.top = static_cast<std::uint16_t>(random.below(run_->height()));
    window.bottom = static_cast<std::uint16_t>(random.between(window.top + 1, run_->height()));
    const Window snapped = run_->snap(window);
    EXPECT_TRUE(snapped.left <= window.left && snapped.top <= window.top && snapped.right >= window.right &&
                snapped.bottom >= window.bottom);
    EXPECT_EQ(run_->open(snapped), Fault::none);
    const Window again = run_->snap(snapped);
    EXPECT_TRUE(again.left == snapped.left && again.top == snapped.top && again.right == snapped.right &&
                again.bottom == snapped.bottom);
  }
  expect_no_complaints();
}

TEST_P(PanelContract, AnotherWindowMayBeOpenedInTheMiddle) {
  ASSERT_EQ(run_->begin(), Fault::none);
  ASSERT_EQ(run_->open(all_of(*run_)), Fault::none);
  for (int y = 0; y < 9; ++y) ASSERT_EQ(run_->send(view(line_)), Fault::none);
  Picture expected(run_->width(), run_->height());
  oracle::Random random(7);
  send_random(*run_, all_of(*run_), random, expected);
  EXPECT_EQ(run_->picture().rgb, expected.rgb);
  expect_no_complaints();
}

TEST_P(PanelContract, SaysWhatTheBusReached) {
  run_->bus().limit_clock(3'000'000);
  ASSERT_EQ(run_->begin(), Fault::none);
  expect_no_complaints();
}

// Whatever operation of the bus fails, the fault comes out of the call that was made, or of the next that has to know;
// the panel is deselected and takes no line until a window is opened.
TEST_P(PanelContract, AFaultOfTheBusComesOutAndClosesTheWindow) {
  for (const Fault planted : {Fault::spi_timeout, Fault::dma_timeout, Fault::dma_error}) {
    for (unsigned after = 0; after < 8; ++after) {
      run_ = PanelRun::make(GetParam().panel, GetParam().rotation);
      ASSERT_EQ(run_->begin(), Fault::none);
      run_->bus().plant(planted, after);
      Fault fault = run_->open(all_of(*run_));
      for (int y = 0; fault == Fault::none && y < run_->height(); ++y) fault = run_->send(view(line_));
      EXPECT_EQ(fault, planted);
      EXPECT_EQ(run_->send(view(line_)), Fault::bad_window);
      EXPECT_TRUE(run_->bench().select_level);
      run_->bus().plant(Fault::none, 0);
      EXPECT_EQ(run_->wait(), Fault::none);
      EXPECT_EQ(run_->open(all_of(*run_)), Fault::none);
    }
  }
}

TEST_P(PanelContract, AFaultEndsBegin) {
  for (unsigned after = 0; after < 20; ++after) {
    run_->bus().plant(Fault::spi_timeout, after);
    EXPECT_EQ(run_->begin(), Fault::spi_timeout);
    EXPECT_TRUE(run_->bench().select_level);
  }
  run_->bus().plant(Fault::none, 0);
  EXPECT_EQ(run_->begin(), Fault::none);
}

TEST(PanelRun, KnowsItsPanelsAndTheirTurns) {
  EXPECT_EQ(panel_names().size(), 11u);
  for (const std::string& name : panel_names()) {
    EXPECT_NE(PanelRun::make(name, hal::Rotation::r0), nullptr) << name;
    EXPECT_NE(PanelRun::make(name, hal::Rotation::r180), nullptr) << name;
    EXPECT_EQ(PanelRun::make(name, hal::Rotation::r90) == nullptr, name.substr(0, 3) == "ssd") << name;
  }
  EXPECT_EQ(PanelRun::make("none", hal::Rotation::r0), nullptr);
}

INSTANTIATE_TEST_SUITE_P(Drivers, PanelContract, testing::ValuesIn(all_turns()), turn_name);

}  // namespace
}  // namespace spanline::host
