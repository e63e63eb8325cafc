// Every panel shows the pictures of an animation, whatever the policy, also after frames that came to grief on the
// wire.
#include "boards/common/presenter.hpp"

#include "frame/animation.hpp"
#include "hal/panel_support.hpp"
#include "sim/host_memory.hpp"

namespace spanline::host {
namespace {

struct Way {
  Turn turn;
  ScanPolicy policy;
  friend std::ostream& operator<<(std::ostream& out, const Way& way) {
    constexpr const char* kNames[] = {" full", " extents", " tiles"};
    return out << way.turn << kNames[static_cast<std::size_t>(way.policy)];
  }
};

class PresenterTest : public testing::TestWithParam<Way> {
 protected:
  PresenterTest()
      : run_(PanelRun::make(GetParam().turn.panel, GetParam().turn.rotation)),
        screen_{run_->width(), run_->height(), run_->format()},
        memory_(screen_, GetParam().policy, run_->window_bytes()),
        presenter_(*run_, memory_.storage()),
        animation_(screen_, 3) {}

  void SetUp() override { ASSERT_EQ(run_->begin(), hal::Fault::none); }

  // In two buffers by turns, as boards do; the free one is spoilt meanwhile.
  hal::Fault show() {
    presenter_.begin_frame(oracle::Animation::kBackground);
    for (std::uint16_t y = 0; y < screen_.height; ++y) {
      Line& line = buffers_[back_];
      line = animation_.bytes(y);
      bool in_flight;
      const hal::Fault fault = presenter_.line(y, view(line), in_flight);
      if (fault != hal::Fault::none) return fault;
      if (in_flight) back_ ^= 1;
    }
    return presenter_.end_frame();
  }

  Picture expected() const {
    Picture picture(screen_.width, screen_.height);
    const hal::Window all{0, 0, screen_.width, screen_.height};
    for (std::uint16_t y = 0; y < screen_.height; ++y) draw(animation_.bytes(y), screen_.format, all, y, picture);
    return picture;
  }

  std::unique_ptr<PanelRun> run_;
  Screen screen_;
  HostScanOutMemory memory_;
  boards::Presenter<PanelRun> presenter_;
  oracle::Animation animation_;
  Line buffers_[2];
  unsigned back_ = 0;
};

TEST_P(PresenterTest, ShowsEveryFrame) {
  for (int frame = 0; frame < 6; ++frame) {
    ASSERT_EQ(show(), hal::Fault::none);
    ASSERT_EQ(run_->picture().rgb, expected().rgb) << "frame " << frame;
    animation_.step();
  }
  EXPECT_EQ(run_->model().complaints(), std::vector<std::string>{});
}

TEST_P(PresenterTest, ShowsTheFrameAfterAFault) {
  oracle::Random random(4);
  ASSERT_EQ(show(), hal::Fault::none);
  for (int frame = 0; frame < 4; ++frame) {
    animation_.step();
    run_->bus().plant(hal::Fault::spi_timeout, static_cast<unsigned>(random.below(300)));
    const hal::Fault fault = show();
    run_->bus().plant(hal::Fault::none, 0);
    if (fault == hal::Fault::none) continue;  // the frame took fewer transfers
    // Half a command may have arrived: only a reset makes sure that the panel listens.
    ASSERT_EQ(run_->begin(), hal::Fault::none);
    animation_.step();
    ASSERT_EQ(show(), hal::Fault::none);
    ASSERT_EQ(run_->picture().rgb, expected().rgb) << "frame " << frame;
  }
}

std::vector<Way> ways() {
  std::vector<Way> all;
  for (const Turn& turn : all_turns()) {
    const bool pages = PanelRun::make(turn.panel, turn.rotation)->snap({2, 1, 4, 2}).height() != 1;
    for (const ScanPolicy policy : {ScanPolicy::full, ScanPolicy::extents, ScanPolicy::tiles}) {
      if (!pages || policy == ScanPolicy::full) all.push_back({turn, policy});
    }
  }
  return all;
}

std::string way_name(const testing::TestParamInfo<Way>& info) {
  constexpr const char* kNames[] = {"_full", "_extents", "_tiles"};
  return turn_name({info.param.turn, info.index}) + kNames[static_cast<std::size_t>(info.param.policy)];
}

INSTANTIATE_TEST_SUITE_P(Panels, PresenterTest, testing::ValuesIn(ways()), way_name);

}  // namespace
}  // namespace spanline::host
