#include "core/image/atomic_file.h"

#include <iterator>
#include <set>
#include <string>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/temporary_folder.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using test::text_of;
using test::write_text;

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

TEST(AtomicFile, TakesItsFinalNameOnCommit) {
  const TemporaryFolder folder;
  Result<AtomicFile> file = AtomicFile::create(folder / "out.exr");
  ASSERT_TRUE(file) << file.error().message();
  EXPECT_EQ(file->temporary().parent_path(), folder.path());
  EXPECT_EQ(file->temporary().extension(), ".exr");
  write_text(file->temporary(), "new");
  EXPECT_FALSE(fs::exists(folder / "out.exr"));
  ASSERT_TRUE(file->commit());
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"out.exr"});
  EXPECT_EQ(text_of(folder / "out.exr"), "new");
}

TEST(AtomicFile, LeavesTheOldFileWholeWithoutCommit) {
  const TemporaryFolder folder;
  write_text(folder / "out.csv", "old");
  {
    const Result<AtomicFile> file = AtomicFile::create(folder / "out.csv");
    ASSERT_TRUE(file);
    write_text(file->temporary(), "half of the new");
    EXPECT_EQ(text_of(folder / "out.csv"), "old");
  }
  EXPECT_EQ(text_of(folder / "out.csv"), "old");
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"out.csv"});
}

TEST(AtomicFile, StaysOneFileWhenMoved) {
  const TemporaryFolder folder;
  Result<AtomicFile> first = AtomicFile::create(folder / "a.txt");
  Result<AtomicFile> second = AtomicFile::create(folder / "b.txt");
  ASSERT_TRUE(first && second);
  *second = std::move(*first);  // b's temporary goes
  EXPECT_EQ(std::size(names_in(folder.path())), 1U);
  const AtomicFile third = std::move(*second);
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{third.temporary().filename().string()});
}

TEST(AtomicFile, TwoWritersOfOneNameDoNotMeet) {
  const TemporaryFolder folder;
  Result<AtomicFile> first = AtomicFile::create(folder / "out.png");
  Result<AtomicFile> second = AtomicFile::create(folder / "out.png");
  ASSERT_TRUE(first && second);
  EXPECT_NE(first->temporary(), second->temporary());
}

TEST(AtomicFile, KeepsPermissionsAndLinks) {
  const TemporaryFolder folder;
  write_text(folder / "real.txt", "old");
  fs::permissions(folder / "real.txt", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real.txt", folder / "link.txt");
  ASSERT_TRUE(write_file(folder / "link.txt", "new"));
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_EQ(text_of(folder / "real.txt"), "new");
  EXPECT_EQ(fs::status(folder / "real.txt").permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(names_in(folder.path()), (std::set<std::string>{"link.txt", "real.txt"}));
}

TEST(AtomicFile, RefusesWhatCannotBeWrittenInOneSentence) {
  const TemporaryFolder folder;
  const auto refusal = [](const fs::path& target) {
    const Result<AtomicFile> file = AtomicFile::create(target);
    EXPECT_TRUE(!file && file.error().kind == ErrorKind::request && file.error().subject == target.string());
    return file ? "created" : file.error().sentence;
  };
  EXPECT_EQ(refusal(folder / "missing/out.txt"), "cannot be written: No such file or directory");
  EXPECT_EQ(refusal(folder.path()), "cannot be written: it is a folder");
  EXPECT_EQ(refusal(folder.path() / ""), "cannot be written: a file name is needed");
  EXPECT_EQ(refusal(""), "cannot be written: a file name is needed");
  EXPECT_EQ(refusal("/dev/null"), "cannot be written: it is not a regular file");
  EXPECT_EQ(refusal(folder / (std::string(300, 'x') + ".txt")), "cannot be written: File name too long");
  EXPECT_TRUE(names_in(folder.path()).empty());
}

TEST(AtomicFile, LeavesReadOnlyFilesAndFoldersAlone) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const TemporaryFolder folder;
  write_text(folder / "kept.txt", "old");
  fs::permissions(folder / "kept.txt", fs::perms::owner_read);
  EXPECT_EQ(write_file(folder / "kept.txt", "new").error().sentence, "cannot be written: Permission denied");
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_EQ(write_file(folder / "other.txt", "new").error().sentence, "cannot be written: Permission denied");
  fs::permissions(folder.path(), fs::perms::owner_all);
}

TEST(WriteFile, WritesEveryByteAndReplaces) {
  const TemporaryFolder folder;
  const std::string bytes("a\r\nb\0c\xff", 7);
  ASSERT_TRUE(write_file(folder / "data.bin", "something longer before"));
  ASSERT_TRUE(write_file(folder / "data.bin", bytes));
  EXPECT_EQ(text_of(folder / "data.bin"), bytes);
  ASSERT_TRUE(write_file(folder / "data.bin", ""));
  EXPECT_EQ(fs::file_size(folder / "data.bin"), 0U);
}

}  // namespace
}  // namespace glint
