// What a panel shows is what was drawn: random pixels through every driver into the model of its controller.
#include "hal/panel_support.hpp"

namespace spanline::host {
namespace {

class PanelPicture : public testing::TestWithParam<Turn> {};

TEST_P(PanelPicture, EqualsWhatWasSentThroughRandomWindows) {
  const std::unique_ptr<PanelRun> run = PanelRun::make(GetParam().panel, GetParam().rotation);
  ASSERT_TRUE(run);
  ASSERT_EQ(run->begin(), hal::Fault::none);
  oracle::Random random(20 + static_cast<unsigned>(GetParam().rotation));
  Picture expected(run->width(), run->height());
  send_random(*run, all_of(*run), random, expected);
  ASSERT_EQ(run->picture().rgb, expected.rgb);
  for (int i = 0; i < 12; ++i) {
    send_random(*run, random_window(*run, random), random, expected);
    ASSERT_EQ(run->picture().rgb, expected.rgb) << "window " << i;
  }
  EXPECT_EQ(run->model().complaints(), std::vector<std::string>{});
}

TEST_P(PanelPicture, SurvivesASecondBegin) {
  const std::unique_ptr<PanelRun> run = PanelRun::make(GetParam().panel, GetParam().rotation);
  Picture expected(run->width(), run->height());
  oracle::Random random(3);
  ASSERT_EQ(run->begin(), hal::Fault::none);
  send_random(*run, all_of(*run), random, expected);
  ASSERT_EQ(run->begin(), hal::Fault::none);
  EXPECT_EQ(run->picture().rgb, expected.rgb);
  EXPECT_EQ(run->model().complaints(), std::vector<std::string>{});
}

// A turn is clockwise: the picture's first pixel wanders from the upright glass's top left corner to its top right one.
TEST_P(PanelPicture, TurnsClockwise) {
  const std::unique_ptr<PanelRun> run = PanelRun::make(GetParam().panel, GetParam().rotation);
  ASSERT_EQ(run->begin(), hal::Fault::none);
  const hal::Window first = run->snap({0, 0, 1, 1});
  ASSERT_EQ(run->open(first), hal::Fault::none);
  Line line(bytes_per_line(run->format(), first.width()));
  line[0] = run->format() == PixelFormat::grey4 ? 0xF0 : run->format() == PixelFormat::mono1 ? 0x80 : 0xFF;
  if (run->format() == PixelFormat::rgb565) line[1] = 0xFF;
  ASSERT_EQ(run->send(view(line)), hal::Fault::none);
  const Line dark(line.size());
  for (std::uint16_t y = 1; y < first.height(); ++y) ASSERT_EQ(run->send(view(dark)), hal::Fault::none);
  ASSERT_EQ(run->wait(), hal::Fault::none);
  const Picture glass = run->model().picture();
  const auto lit = std::find(glass.rgb.begin(), glass.rgb.end(), 255);
  const std::size_t right = glass.width - 1u, bottom = glass.height - 1u;
  const std::size_t corners[] = {0, right, bottom * glass.width + right, bottom * glass.width};
  EXPECT_EQ(static_cast<std::size_t>(lit - glass.rgb.begin()),
            3 * corners[static_cast<std::size_t>(GetParam().rotation)]);
}

INSTANTIATE_TEST_SUITE_P(Drivers, PanelPicture, testing::ValuesIn(all_turns()), turn_name);

// The proof that the pictures above could fail: a line that is overwritten in flight shows.
TEST(PanelInFlight, AnOverwrittenLineShows) {
  const std::unique_ptr<PanelRun> run = PanelRun::make("ili9341", hal::Rotation::r0);
  ASSERT_EQ(run->begin(), hal::Fault::none);
  ASSERT_EQ(run->open({0, 0, 1, 1}), hal::Fault::none);
  Line line = {0xF8, 0x00};
  ASSERT_EQ(run->send(view(line)), hal::Fault::none);
  line = {0x00, 0x1F};
  ASSERT_EQ(run->wait(), hal::Fault::none);
  const Picture picture = run->picture();
  EXPECT_EQ(picture.rgb[0], 0);
  EXPECT_EQ(picture.rgb[2], 255);
}

}  // namespace
}  // namespace spanline::host
