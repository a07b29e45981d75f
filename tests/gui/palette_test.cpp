#include "gui/dialogs/palette.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/document/parameter.h"
#include "tests/gui/example_actions.h"

namespace glint::gui {
namespace {

std::vector<std::string> keys(std::string_view words) {
  std::vector<std::string> keys;
  for (const PaletteRow& row : palette_rows(test::example_actions(), words)) keys.push_back(row.key);
  return keys;
}

std::ptrdiff_t place(const std::vector<std::string>& keys, const std::string& key) {
  return std::find(keys.begin(), keys.end(), key) - keys.begin();
}

TEST(PaletteRows, AreEverythingWhereNothingIsTyped) {
  EXPECT_EQ(keys("").size(), test::example_actions().all().size() + parameters().size());
  EXPECT_EQ(keys("  "), keys(""));
  EXPECT_EQ(keys("").front(), "file.open");
}

TEST(PaletteRows, PutWhatCannotBeUsedLast) {
  EXPECT_EQ(keys("").back(), "file.reload");
  const std::vector<PaletteRow> rows = palette_rows(test::example_actions(), "map again");
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows.back().key, "file.reload");
  EXPECT_EQ(rows.back().reason, "The map is generated, not read from a file.");
}

TEST(PaletteRows, SayWhereAnActionIsFoundOtherwise) {
  const std::vector<PaletteRow> rows = palette_rows(test::example_actions(), "slope colours");
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows.front().title, "Slope colours");
  EXPECT_EQ(rows.front().place, "View");
  EXPECT_EQ(rows.front().shortcut, "2");
  EXPECT_TRUE(rows.front().checked);
}

TEST(PaletteRows, FindFieldsByLabelPathAndSymbol) {
  for (const char* words :
       {"Roughness", "rough σ", "go to rough", "intrinsic_rough", "INTRINSIC roughness", "sigma_r"}) {
    const std::vector<std::string> found = keys(words);
    EXPECT_NE(std::find(found.begin(), found.end(), "field:intrinsic_roughness"), found.end()) << words;
  }
  EXPECT_TRUE(keys("roughness qx").empty());
}

TEST(PaletteRows, TellWhereAFieldStands) {
  const std::vector<PaletteRow> rows = palette_rows(test::example_actions(), "surface.generator.seed");
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows.front().key, "field:surface.generator.seed");
  EXPECT_EQ(rows.front().title, "Go to Map seed");
  EXPECT_EQ(rows.front().place, "Surface generator");
  EXPECT_FALSE(rows.front().help.empty());
}

TEST(PaletteRows, PutFieldsBeforeActionsThatMatchFromAfar) {
  Actions actions;
  actions.add(test::example_action("file.send", "File", "Go somewhere else and do it", "F2"));
  actions.add(test::example_action("edit.seed", "Edit", "New seed", "F3"));
  std::vector<std::string> found;
  for (const PaletteRow& row : palette_rows(actions, "seed")) found.push_back(row.key);
  EXPECT_EQ(place(found, "edit.seed"), 0);
  EXPECT_LT(place(found, "field:seed"), place(found, "file.send"));
  EXPECT_EQ(place(found, "file.send"), static_cast<std::ptrdiff_t>(found.size()) - 1);
}

}  // namespace
}  // namespace glint::gui
