#include "gui/memory/settings.h"

#include <cstdlib>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gui/memory/user_folders.h"
#include "tests/temporary_folder.h"

namespace glint::gui {
namespace {

using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Sets or unsets a variable of the environment for the life of the object.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    set(value);
  }
  ~Variable() { set(old_ ? old_->c_str() : nullptr); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  void set(const char* value) { value ? ::setenv(name_, value, 1) : ::unsetenv(name_); }

  const char* name_;
  std::optional<std::string> old_;
};

TEST(UserFolders, FollowTheEnvironment) {
  const Variable home("HOME", "/home/ada");
  {
    const Variable config("XDG_CONFIG_HOME", nullptr);
    const Variable state("XDG_STATE_HOME", "");
    EXPECT_EQ(config_folder(), "/home/ada/.config/glintscope");
    EXPECT_EQ(state_folder(), "/home/ada/.local/state/glintscope");
    EXPECT_EQ(user_presets_folder(), "/home/ada/.config/glintscope/presets");
  }
  const Variable config("XDG_CONFIG_HOME", "/c");
  const Variable state("XDG_STATE_HOME", "not/absolute");
  EXPECT_EQ(config_folder(), "/c/glintscope");
  EXPECT_EQ(state_folder(), "/home/ada/.local/state/glintscope");
}

TEST(UserFolders, AreNoneWithoutAHome) {
  const Variable home("HOME", nullptr);
  const Variable config("XDG_CONFIG_HOME", nullptr);
  const Variable state("XDG_STATE_HOME", nullptr);
  EXPECT_EQ(config_folder(), std::nullopt);
  EXPECT_EQ(state_folder(), std::nullopt);
  EXPECT_EQ(user_presets_folder(), std::nullopt);
}

TEST(UserFolders, AreMadeForTheirOwnerOnly) {
  const TemporaryFolder folder;
  ASSERT_TRUE(make_folder(folder / "a/b"));
  EXPECT_EQ(std::filesystem::status(folder / "a/b").permissions(), std::filesystem::perms::owner_all);
  ASSERT_TRUE(make_folder(folder / "a/b"));
  test::write_text(folder / "file", "");
  const Status blocked = make_folder(folder / "file/b");
  ASSERT_FALSE(blocked);
  EXPECT_THAT(blocked.error().message(), HasSubstr("cannot be created"));
}

Settings example() {
  Settings settings;
  settings.ui_scale = 1.25;
  settings.window_size = {1280, 720};
  settings.maximised = true;
  settings.splitters = {{"main", 0.1}, {"bottom", 1.0 / 3}};
  settings.open_sections = {{"surface", true}, {"footprint", false}};
  settings.recent = {"/b/ö.png", "/a \"quoted\".json"};
  settings.last_folder = "/maps";
  settings.maximised_panel = "pndf";
  return settings;
}

TEST(Settings, ComeBackAsTheyWereSaved) {
  const TemporaryFolder folder;
  ASSERT_TRUE(save_settings(folder / "new/glintscope", example()));
  const LoadedSettings loaded = load_settings(folder / "new/glintscope");
  EXPECT_EQ(loaded.settings, example());
  EXPECT_FALSE(loaded.fault) << loaded.fault->message();
}

TEST(Settings, AreDefaultsWhereThereIsNoFile) {
  const TemporaryFolder folder;
  const LoadedSettings loaded = load_settings(folder / "nothing");
  EXPECT_EQ(loaded.settings, Settings());
  EXPECT_FALSE(loaded.fault);
  EXPECT_FALSE(std::filesystem::exists(folder / "nothing"));
}

TEST(Settings, AreDefaultsForAFileThatIsNone) {
  const TemporaryFolder folder;
  for (const std::string text : {"", "{", "[]", "3", "{\"ui_scale\": 1,}", "\xFF", "{\"maximised\": tru"}) {
    test::write_text(folder / "settings.json", text);
    const LoadedSettings loaded = load_settings(folder.path());
    EXPECT_EQ(loaded.settings, Settings()) << text;
    ASSERT_TRUE(loaded.fault) << text;
    EXPECT_THAT(loaded.fault->message(), HasSubstr("settings.json: is not JSON"));
  }
  std::filesystem::remove(folder / "settings.json");
  std::filesystem::create_directory(folder / "settings.json");
  EXPECT_TRUE(load_settings(folder.path()).fault);
}

TEST(Settings, KeepWhatIsRightOfAPartlyWrongFile) {
  const TemporaryFolder folder;
  test::write_text(folder / "settings.json", R"({
    "ui_scale": 9, "window_size": [800], "maximised": "yes", "splitters": {"main": 0.25, "bottom": 2},
    "open_sections": {"surface": 1, "grid": false}, "recent": ["/a", 3, "/b", "/a"], "last_folder": "/maps",
    "maximised_panel": null, "of a later version": {}})");
  const LoadedSettings loaded = load_settings(folder.path());
  Settings expected;
  expected.splitters = {{"main", 0.25}};
  expected.open_sections = {{"grid", false}};
  expected.recent = {"/a", "/b"};
  expected.last_folder = "/maps";
  EXPECT_EQ(loaded.settings, expected);
  ASSERT_TRUE(loaded.fault);
  EXPECT_THAT(loaded.fault->message(),
              HasSubstr("'ui_scale', 'window_size', 'maximised', 'splitters.bottom', 'open_sections.surface', "
                        "'recent', 'maximised_panel'; the default is used"));
}

TEST(Settings, TakeNoSizeThatNoScreenHas) {
  const TemporaryFolder folder;
  for (const char* size : {"[1e300, 720]", "[1280, -1]", "[0, 0]", "[\"1280\", 720]", "[1280, 720, 1]"}) {
    test::write_text(folder / "settings.json", std::string("{\"window_size\": ") + size + "}");
    const LoadedSettings loaded = load_settings(folder.path());
    EXPECT_EQ(loaded.settings, Settings()) << size;
    EXPECT_TRUE(loaded.fault) << size;
  }
}

TEST(Settings, LeaveOutPathsThatJsonCannotHold) {
  const TemporaryFolder folder;
  Settings settings;
  settings.recent = {"/\xFF.png", "/good.png"};
  settings.last_folder = "/\xFF";
  ASSERT_TRUE(save_settings(folder.path(), settings));
  const LoadedSettings loaded = load_settings(folder.path());
  EXPECT_FALSE(loaded.fault);
  EXPECT_THAT(loaded.settings.recent, ElementsAre("/good.png"));
  EXPECT_EQ(loaded.settings.last_folder, "");
}

TEST(Settings, SayWhereTheyCannotBeSaved) {
  const TemporaryFolder folder;
  test::write_text(folder / "file", "");
  EXPECT_FALSE(save_settings(folder / "file", Settings()));
}

TEST(RecentFiles, AreNewestFirstAndFew) {
  Settings settings;
  for (int k = 0; k < 20; ++k) remember_recent(settings, std::filesystem::path("/") / std::to_string(k));
  ASSERT_EQ(settings.recent.size(), k_most_recent);
  EXPECT_EQ(settings.recent.front(), "/19");
  EXPECT_EQ(settings.recent.back(), "/8");
}

TEST(RecentFiles, StandOnceAndWithTheirWholePath) {
  Settings settings;
  remember_recent(settings, "/a/one.png");
  remember_recent(settings, "two.png");
  remember_recent(settings, "/a/../a/one.png");
  remember_recent(settings, "");
  EXPECT_THAT(settings.recent, ElementsAre("/a/one.png", std::filesystem::current_path() / "two.png"));
}

}  // namespace
}  // namespace glint::gui
