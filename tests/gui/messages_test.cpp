#include "gui/window/messages.h"

#include <gtest/gtest.h>

namespace glint::gui {
namespace {

TEST(ErrorText, GoesOnFromItsSubjectWhereTheSentenceHasNone) {
  EXPECT_EQ(error_text(content_error("/a/wood.json", "cannot be read: there is no such file")),
            "/a/wood.json cannot be read: there is no such file.");
  EXPECT_EQ(error_text(content_error("wood.png", "is empty (0 bytes)")), "wood.png is empty (0 bytes).");
}

TEST(ErrorText, BeginsANewSentenceOtherwise) {
  EXPECT_EQ(error_text(content_error("wood.dds", "no such file")), "wood.dds: No such file.");
  EXPECT_EQ(error_text(content_error("wood.dds", "issue 7 is not it")), "wood.dds: Issue 7 is not it.");
}

TEST(ErrorText, CallsAFieldByItsLabel) {
  EXPECT_EQ(error_text(request_error("intrinsic_roughness", "is 2; allowed: a number above 0 and at most 1")),
            "Intrinsic roughness is 2; allowed: a number above 0 and at most 1.");
}

TEST(ErrorText, EndsWithOneFullStop) {
  EXPECT_EQ(error_text(content_error("", "out of memory")), "Out of memory.");
  EXPECT_EQ(error_text(content_error("", "out of memory. What was open is unchanged.")),
            "Out of memory. What was open is unchanged.");
  EXPECT_EQ(error_text(content_error("", "")), "");
}

TEST(Messages, AreNewestFirst) {
  Messages messages;
  EXPECT_EQ(messages.newest(), nullptr);
  messages.post({Message::Kind::info, "One.", {}});
  messages.post({Message::Kind::error, "Two.", {}});
  ASSERT_EQ(messages.all().size(), 2U);
  EXPECT_EQ(messages.newest()->text, "Two.");
  EXPECT_EQ(messages.all()[1].message.text, "One.");
}

TEST(Messages, CountWhatIsSaidAgain) {
  Messages messages;
  messages.post({Message::Kind::error, "One.", {}});
  messages.post({Message::Kind::error, "Two.", {}});
  messages.post({Message::Kind::error, "One.", {"file.open"}});
  ASSERT_EQ(messages.all().size(), 2U);
  EXPECT_EQ(messages.newest()->text, "One.");
  EXPECT_EQ(messages.newest()->action_names, std::vector<std::string>{"file.open"});
  EXPECT_EQ(messages.all()[0].count, 2);
  EXPECT_EQ(messages.all()[1].count, 1);
}

TEST(Messages, OfAnotherKindAreOthers) {
  Messages messages;
  messages.post({Message::Kind::error, "One.", {}});
  messages.post({Message::Kind::warning, "One.", {}});
  EXPECT_EQ(messages.all().size(), 2U);
}

TEST(Messages, AreDismissedOneByOneOrTogether) {
  Messages messages;
  for (const char* text : {"One.", "Two.", "Three."}) messages.post({Message::Kind::info, text, {}});
  messages.dismiss(1);
  ASSERT_EQ(messages.all().size(), 2U);
  EXPECT_EQ(messages.all()[0].message.text, "Three.");
  EXPECT_EQ(messages.all()[1].message.text, "One.");
  messages.dismiss(2);
  EXPECT_EQ(messages.all().size(), 2U);
  messages.dismiss_all();
  EXPECT_TRUE(messages.all().empty());
  messages.post({Message::Kind::info, "Two.", {}});
  EXPECT_EQ(messages.all()[0].count, 1);
}

}  // namespace
}  // namespace glint::gui
