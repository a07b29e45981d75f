#include "gui/dialogs/file_listing.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"

namespace glint::gui {
namespace {

namespace fs = std::filesystem;

const FileFilter k_all{"All files", {}};
const FileFilter k_pictures{"Pictures", {".png", ".exr"}};

std::vector<std::string> names_of(const Result<FolderListing>& listing) {
  std::vector<std::string> names;
  if (listing) {
    for (const ListedFile& file : listing->entries) names.push_back(file.name);
  }
  return names;
}

using Names = std::vector<std::string>;

TEST(FileListing, FoldersStandFirstAndNumbersCountByTheirValue) {
  const test::TemporaryFolder folder;
  for (const char* name : {"map10.png", "map2.png", "Map1.png", "alpha.png", "map02.png"})
    test::write_text(folder / name, "x");
  fs::create_directory(folder / "zoo");
  fs::create_directory(folder / "Area");
  EXPECT_EQ(names_of(list_folder(folder.path(), k_all)),
            (Names{"Area", "zoo", "alpha.png", "Map1.png", "map02.png", "map2.png", "map10.png"}));
}

TEST(FileListing, NaturalOrderIsAnOrder) {
  const Names names{"a", "A", "a1", "a01", "a001b", "a1b", "a2", "a10", "b", "", "1", "01", "10", "9", "a1c"};
  for (const std::string& a : names) {
    EXPECT_FALSE(natural_less(a, a)) << a;
    for (const std::string& b : names) {
      EXPECT_EQ(natural_less(a, b) != natural_less(b, a), a != b) << a << ' ' << b;
      for (const std::string& c : names) {
        const bool in_order = natural_less(a, b) && natural_less(b, c);
        EXPECT_TRUE(!in_order || natural_less(a, c)) << a << ' ' << b << ' ' << c;
      }
    }
  }
}

TEST(FileListing, AFilterKeepsFoldersAndItsOwnExtensionsInAnyCase) {
  const test::TemporaryFolder folder;
  for (const char* name : {"a.PNG", "b.exr", "c.txt", "png", ".png"}) test::write_text(folder / name, "x");
  fs::create_directory(folder / "d.txt");
  EXPECT_EQ(names_of(list_folder(folder.path(), k_pictures)), (Names{"d.txt", "a.PNG", "b.exr"}));
}

TEST(FileListing, HiddenFilesAreShownWhenAskedFor) {
  const test::TemporaryFolder folder;
  test::write_text(folder / ".secret.png", "x");
  fs::create_directory(folder / ".git");
  EXPECT_TRUE(names_of(list_folder(folder.path(), k_all)).empty());
  EXPECT_EQ(names_of(list_folder(folder.path(), k_all, true)), (Names{".git", ".secret.png"}));
}

TEST(FileListing, LinksCountAsWhatTheyPointToAndBrokenOnesAreLeftOut) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder / "real");
  fs::create_symlink(folder / "real", folder / "link");
  fs::create_symlink(folder / "nowhere", folder / "broken");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const Result<FolderListing> listing = list_folder(folder.path(), k_all);
  EXPECT_EQ(names_of(listing), (Names{"link", "real"}));
  EXPECT_TRUE(listing->entries[0].is_folder);
}

TEST(FileListing, NamesInAnyScriptAreKeptAndBrokenBytesAreShownAsQuestionMarks) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "Äpfel – σ.png", "x");
  test::write_text(folder / "bad\xFF\n.png", "x");
  const Result<FolderListing> listing = list_folder(folder.path(), k_all);
  ASSERT_EQ(names_of(listing), (Names{"bad??.png", "Äpfel – σ.png"}));
  EXPECT_TRUE(fs::exists(listing->entries[0].path)) << "the path has the bytes of the disk";
}

TEST(FileListing, SizesHaveTwoOrThreeDigits) {
  EXPECT_EQ(size_text(0), "0 B");
  EXPECT_EQ(size_text(999), "999 B");
  EXPECT_EQ(size_text(1000), "1.0 kB");
  EXPECT_EQ(size_text(1'449'000), "1.4 MB");
  EXPECT_EQ(size_text(99'960), "100 kB");
  EXPECT_EQ(size_text(999'600), "1.0 MB");
  EXPECT_EQ(size_text(23'500'000'000), "23.5 GB");
}

TEST(FileListing, AnEntryTellsItsSizeAndDate) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.png", std::string(1500, 'x'));
  std::tm moment{};
  moment.tm_year = 124;
  moment.tm_mon = 4;
  moment.tm_mday = 3;
  moment.tm_hour = 14;
  moment.tm_min = 7;
  moment.tm_isdst = -1;
  const std::time_t time = std::mktime(&moment);
  fs::last_write_time(folder / "a.png",
                      std::chrono::file_clock::from_sys(std::chrono::system_clock::from_time_t(time)));
  const Result<FolderListing> listing = list_folder(folder.path(), k_all);
  ASSERT_EQ(listing->entries.size(), 1U);
  EXPECT_EQ(listing->entries[0].bytes, 1500U);
  EXPECT_EQ(listing->entries[0].size, "1.5 kB");
  EXPECT_EQ(listing->entries[0].date, "2024-05-03 14:07");
  EXPECT_TRUE(listing->writable);
}

TEST(FileListing, AFolderThatCannotBeReadSaysWhy) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(list_folder(folder / "gone", k_all).error().sentence, "is not there any more");
  test::write_text(folder / "file", "x");
  EXPECT_EQ(list_folder(folder / "file", k_all).error().sentence, "is a file and holds nothing");
  if (::geteuid() == 0) GTEST_SKIP() << "nothing is forbidden to root";
  fs::create_directory(folder / "locked");
  fs::permissions(folder / "locked", fs::perms::none);
  EXPECT_EQ(list_folder(folder / "locked", k_all).error().sentence, "cannot be read: you have no permission to");
  fs::permissions(folder / "locked", fs::perms::owner_all);
}

TEST(FileListing, FiveThousandFilesAreListedInOrder) {
  const test::TemporaryFolder folder;
  for (int k = 0; k < 5000; ++k) test::write_text(folder / ("f" + std::to_string(k * 7919 % 5000) + ".png"), "");
  const Result<FolderListing> listing = list_folder(folder.path(), k_pictures);
  ASSERT_TRUE(listing);
  ASSERT_EQ(listing->entries.size(), 5000U);
  EXPECT_EQ(listing->entries.front().name, "f0.png");
  EXPECT_EQ(listing->entries[1234].name, "f1234.png");
  EXPECT_EQ(listing->entries.back().name, "f4999.png");
}

TEST(TypedPath, BeginsAtTheFolderTheRootOrHome) {
  ::setenv("HOME", "/home/mara", 1);
  EXPECT_EQ(typed_path("a.png", "/maps"), "/maps/a.png");
  EXPECT_EQ(typed_path("../x//y/.", "/maps"), "/x/y");
  EXPECT_EQ(typed_path("/etc/", "/maps"), "/etc");
  EXPECT_EQ(typed_path("/", "/maps"), "/");
  EXPECT_EQ(typed_path("", "/maps"), "/maps");
  EXPECT_EQ(typed_path("~", "/maps"), "/home/mara");
  EXPECT_EQ(typed_path("~/a", "/maps"), "/home/mara/a");
  EXPECT_EQ(typed_path("~a", "/maps"), "/maps/~a");
}

TEST(TypedPath, TheParentOfTheRootIsNone) {
  EXPECT_EQ(parent_of("/a/b"), fs::path("/a"));
  EXPECT_EQ(parent_of("/a"), fs::path("/"));
  EXPECT_FALSE(parent_of("/"));
}

TEST(Completions, GoOnWithWhatTheFolderHolds) {
  const test::TemporaryFolder folder;
  for (const char* name : {"wood.png", "Wool.png", "word.txt", ".wo.png"}) test::write_text(folder / name, "x");
  fs::create_directory(folder / "work");
  EXPECT_EQ(completions("wo", folder.path(), k_pictures), (Names{"work/", "wood.png", "Wool.png"}));
  EXPECT_EQ(completions("work/../WOO", folder.path(), k_pictures), (Names{"work/../wood.png", "work/../Wool.png"}));
  EXPECT_EQ(completions(folder.path().string() + "/", "/", k_all, 2).size(), 2U);
  EXPECT_EQ(completions(".w", folder.path(), k_all), (Names{".wo.png"}));
  EXPECT_TRUE(completions("wood.png", folder.path(), k_all).empty()) << "nothing is left to complete";
  EXPECT_TRUE(completions("nowhere/a", folder.path(), k_all).empty());
}

TEST(Slug, IsAFileNameWithoutSurprises) {
  EXPECT_EQ(slug("Scratched Steel 2"), "scratched-steel-2");
  EXPECT_EQ(slug("  ../etc/passwd  "), "etc-passwd");
  EXPECT_EQ(slug("h = 0.25 (fine)"), "h-0-25-fine");
  EXPECT_EQ(slug("Grüner Stahl"), "grüner-stahl");
  EXPECT_EQ(slug("…!"), "…");
  EXPECT_EQ(slug("?!"), "preset");
  EXPECT_EQ(slug(""), "preset");
}

TEST(Slug, IsCutBetweenLetters) {
  std::string name = "x";
  for (int k = 0; k < 200; ++k) name += "ü";
  const std::string cut = slug(name);
  EXPECT_LE(cut.size(), 100U);
  EXPECT_EQ(cut, name.substr(0, cut.size()));
  EXPECT_EQ(cut.size() % 2, 1U) << "ends in the middle of a letter";
}

}  // namespace
}  // namespace glint::gui
