#include "gui/input/actions.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glint::gui {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class ActionsTest : public ::testing::Test {
 protected:
  ActionsTest() {
    add({.name = "file.open",
         .menu = "File",
         .title = "Open…",
         .chord = Chord{Key::o, true},
         .tooltip = "Opens a map"});
    add({.name = "file.save",
         .menu = "File",
         .title = "Save preset",
         .chord = Chord{Key::s, true},
         .tooltip = "Writes the preset to its file",
         .reason_disabled = [this] { return reason_; }});
    add({.name = "view.zoom_in",
         .menu = "View",
         .title = "Zoom in",
         .chord = Chord{Key::equal, true},
         .more_chords = {{Key::keypad_plus, true}},
         .tooltip = "Shows texels larger",
         .checked = [] { return true; }});
    add({.name = "view.reset", .title = "Fit the whole map", .tooltip = "Opens the view up to the map's edges"});
  }

  void add(Action action) {
    action.run = [this, name = action.name] { ran_ += name + " "; };
    actions_.add(std::move(action));
  }
  std::vector<std::string> matching(std::string_view words) {
    std::vector<std::string> names;
    for (const Action* action : actions_.matching(words)) names.push_back(action->name);
    return names;
  }

  Actions actions_;
  std::string reason_;
  std::string ran_;
};

TEST_F(ActionsTest, AreFoundByNameAndChord) {
  ASSERT_TRUE(actions_.find("file.save"));
  EXPECT_EQ(actions_.find("file.save")->title, "Save preset");
  EXPECT_EQ(actions_.find("file"), nullptr);
  EXPECT_EQ(actions_.for_chord({Key::equal, true}), actions_.find("view.zoom_in"));
  EXPECT_EQ(actions_.for_chord({Key::keypad_plus, true}), actions_.find("view.zoom_in"));
  EXPECT_EQ(actions_.for_chord({Key::equal}), nullptr);
  ASSERT_EQ(actions_.all().size(), 4U);
  EXPECT_EQ(actions_.all().back().name, "view.reset");
  EXPECT_TRUE(actions_.find("view.zoom_in")->is_checked());
  EXPECT_FALSE(actions_.find("file.open")->is_checked());
}

TEST_F(ActionsTest, RunOrSayWhyNot) {
  EXPECT_EQ(actions_.run("file.open"), "");
  EXPECT_EQ(actions_.run("file.save"), "");
  reason_ = "nothing has changed";
  EXPECT_EQ(actions_.run("file.save"), "nothing has changed");
  EXPECT_EQ(actions_.run("file.sav"), "there is no action 'file.sav'; the nearest is 'file.save'");
  EXPECT_EQ(ran_, "file.open file.save ");
}

TEST_F(ActionsTest, MatchAllWordsInTitleNameMenuAndTooltip) {
  EXPECT_THAT(matching(""), ElementsAre("file.open", "file.save", "view.zoom_in", "view.reset"));
  EXPECT_THAT(matching("PRESET sav"), ElementsAre("file.save"));
  EXPECT_THAT(matching("zoom_in"), ElementsAre("view.zoom_in"));
  EXPECT_THAT(matching("texels"), ElementsAre("view.zoom_in"));
  EXPECT_THAT(matching("view"), ElementsAre("view.zoom_in", "view.reset"));
  EXPECT_THAT(matching("svprst"), ElementsAre("file.save"));
  EXPECT_THAT(matching("save texels"), IsEmpty());
}

TEST_F(ActionsTest, MatchTitlesBeforeTooltipsAndTheirBeginningFirst) {
  EXPECT_THAT(matching("open"), ElementsAre("file.open", "view.reset"));
  EXPECT_THAT(matching("the"), ElementsAre("view.reset", "file.save"));
  add({.name = "a", .title = "Reset zoom", .tooltip = "…"});
  add({.name = "b", .title = "Zoom out", .tooltip = "…"});
  EXPECT_THAT(matching("zoom"), ElementsAre("view.zoom_in", "b", "a"));
}

TEST_F(ActionsTest, MatchTheDisabledAfterTheOthers) {
  reason_ = "no";
  EXPECT_THAT(matching(""), ElementsAre("file.open", "view.zoom_in", "view.reset", "file.save"));
}

TEST_F(ActionsTest, HaveFaultsToBeFoundByATest) {
  EXPECT_THAT(actions_.faults(), IsEmpty());
  add({.name = "bare"});
  add({.name = "second", .title = "Second", .more_chords = {{Key::o, true}, {Key::none}}, .tooltip = "Is second"});
  EXPECT_THAT(actions_.faults(),
              ElementsAre("'bare' has no title", "'bare' has no tooltip", "'file.open' and 'second' both have Ctrl+O",
                          "'second' has a chord that cannot be written"));
}

TEST(NearestName, IsTheOneSpelledMostAlike) {
  constexpr std::array<std::string_view, 3> k_names = {"pndf.scale.log", "pndf.scale.linear", "map.fit"};
  EXPECT_EQ(nearest_name("pndf.scale.lg", k_names), "pndf.scale.log");
  EXPECT_EQ(nearest_name("fit", k_names), "map.fit");
  EXPECT_EQ(nearest_name("x", {}), "");
}

}  // namespace
}  // namespace glint::gui
