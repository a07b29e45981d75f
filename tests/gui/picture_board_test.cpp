#include "gui/jobs/picture_board.h"

#include <cstdint>
#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace glint::gui {
namespace {

PictureBoard::Request exact_request(std::uint64_t number, std::uint64_t revision) {
  PictureBoard::Request request;
  request.label = {number, revision, Document()};
  request.identities.push_back({nullptr, "recipe " + std::to_string(number), PndfGrid()});
  return request;
}

view::MethodPicture exact_picture(bool coarse) {
  view::MethodPicture picture;
  picture.image = std::make_shared<const PndfImage>();
  picture.coarse = coarse;
  return picture;
}

TEST(PictureBoard, PublishesNothingBeforeTheFirstPicture) {
  PictureBoard board;
  board.announce({1, 10, Document()});
  board.begin(exact_request(1, 10));
  EXPECT_EQ(board.results(), nullptr);
  EXPECT_FALSE(board.has_picture(0));
  board.set_picture(0, exact_picture(true));
  ASSERT_NE(board.results(), nullptr);
  EXPECT_EQ(board.results()->revision, 10U);
  EXPECT_TRUE(board.has_picture(0));
  EXPECT_FALSE(board.has_full_picture(0));
  board.set_picture(0, exact_picture(false));
  EXPECT_TRUE(board.has_full_picture(0));
}

TEST(PictureBoard, ALabelThatChangesBeforeTheFirstPictureIsItsLabel) {
  PictureBoard board;
  board.announce({1, 10, Document()});
  board.begin(exact_request(1, 10));
  Document renamed;
  renamed.name = "another";
  board.announce({1, 11, renamed});
  board.set_picture(0, exact_picture(false));
  EXPECT_EQ(board.results()->revision, 11U);
  EXPECT_EQ(board.results()->document, renamed);
  EXPECT_EQ(board.results()->methods[0].revision, 11U);
}

TEST(PictureBoard, PicturesOfASupersededRequestKeepItsLabel) {
  PictureBoard board;
  board.announce({1, 10, Document()});
  board.begin(exact_request(1, 10));
  board.announce({2, 11, Document()});
  board.set_picture(0, exact_picture(true));
  EXPECT_EQ(board.results()->revision, 10U);
  board.begin(exact_request(2, 11));
  EXPECT_EQ(board.results()->revision, 10U);
  board.set_picture(0, exact_picture(true));
  EXPECT_EQ(board.results()->revision, 11U);
  EXPECT_EQ(board.results()->methods[0].revision, 11U);
}

TEST(PictureBoard, ProgressOnlyGrowsAndEndsWithTheFullPicture) {
  PictureBoard board;
  board.announce({1, 10, Document()});
  board.begin(exact_request(1, 10));
  board.set_picture(0, exact_picture(true));
  const auto progress = [&] { return board.results()->methods[0].progress; };
  EXPECT_EQ(progress(), 0);
  board.set_progress(PndfMethod::exact, 0.5);
  board.set_progress(PndfMethod::exact, 0.25);
  board.set_progress(PndfMethod::binning, 0.75);
  EXPECT_EQ(progress(), 0.5);
  board.set_picture(0, exact_picture(false));
  EXPECT_EQ(progress(), 1);
}

}  // namespace
}  // namespace glint::gui
