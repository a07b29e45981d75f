#include "gui/memory/session.h"

#include <functional>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/document/preset.h"
#include "tests/temporary_folder.h"

namespace glint::gui {
namespace {

using test::TemporaryFolder;
using ::testing::HasSubstr;

Document example(std::uint64_t seed = 7) {
  Document document;
  document.name = "brushed \"steel\"";
  document.surface.source = SurfaceSource::file;
  document.surface.path = "/maps/brushed.png";
  document.intrinsic_roughness = 0.1 + 0.2;
  document.seed = seed;
  return document;
}

Session claim(const std::filesystem::path& folder) {
  Result<Session> session = Session::begin(folder);
  EXPECT_TRUE(session) << session.error().message();
  return std::move(*session);
}

// Runs `work` in a process of its own, which ends as in a crash; gives its result.
int in_process_that_dies(const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work());
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  return WEXITSTATUS(status);
}

// The slot in which a process died that had saved a document with this seed.
int crash(const std::filesystem::path& folder, std::uint64_t seed, bool is_saved = false) {
  return in_process_that_dies([&] {
    Result<Session> session = Session::begin(folder);
    if (!session || !session->save(example(seed), "/p/steel.json", is_saved)) return 100;
    return session->slot();
  });
}

TEST(Session, BeginsEmpty) {
  const TemporaryFolder folder;
  const Session session = claim(folder / "new/state");
  EXPECT_EQ(session.slot(), 1);
  EXPECT_FALSE(session.recovered());
  EXPECT_FALSE(session.fault());
  EXPECT_FALSE(std::filesystem::exists(folder / "new/state/session-1.json"));
}

TEST(Session, BringsBackTheLastDocumentAfterACleanEnd) {
  const TemporaryFolder folder;
  {
    Session session = claim(folder.path());
    ASSERT_TRUE(session.save(Document(), "", false));
    ASSERT_TRUE(session.save(example(), "/p/steel.json", true));
    ASSERT_TRUE(session.end());
  }
  const Session session = claim(folder.path());
  ASSERT_TRUE(session.recovered());
  EXPECT_EQ(session.recovered()->document, example());
  EXPECT_EQ(session.recovered()->preset_file, "/p/steel.json");
  EXPECT_TRUE(session.recovered()->was_saved);
  EXPECT_FALSE(session.recovered()->crashed);
}

TEST(Session, RecoversWhatACrashedProgramHadSaved) {
  const TemporaryFolder folder;
  ASSERT_EQ(crash(folder.path(), 12), 1);
  const Session session = claim(folder.path());
  EXPECT_EQ(session.slot(), 1);
  ASSERT_TRUE(session.recovered());
  EXPECT_EQ(session.recovered()->document, example(12));
  EXPECT_FALSE(session.recovered()->was_saved);
  EXPECT_TRUE(session.recovered()->crashed);
}

TEST(Session, RecoversAgainIfTheRecoveringProgramDiesAtOnce) {
  const TemporaryFolder folder;
  crash(folder.path(), 12);
  in_process_that_dies([&] { return Session::begin(folder.path()) ? 0 : 1; });
  const Session session = claim(folder.path());
  ASSERT_TRUE(session.recovered());
  EXPECT_EQ(session.recovered()->document.seed, 12U);
  EXPECT_TRUE(session.recovered()->crashed);
}

TEST(Session, OfEveryRunningProgramHasASlotOfItsOwn) {
  const TemporaryFolder folder;
  Session first = claim(folder.path());
  ASSERT_TRUE(first.save(example(1), "", false));
  EXPECT_EQ(crash(folder.path(), 2), 2);
  const Session second = claim(folder.path());
  EXPECT_EQ(second.slot(), 2);
  ASSERT_TRUE(second.recovered());
  EXPECT_EQ(second.recovered()->document.seed, 2U);
  const Session third = claim(folder.path());
  EXPECT_EQ(third.slot(), 3);
  EXPECT_FALSE(third.recovered());
}

TEST(Session, TakesASlotThatLostSomethingBeforeOneThatDidNot) {
  const TemporaryFolder folder;
  {
    Session first = claim(folder.path());
    ASSERT_TRUE(first.save(example(1), "", false));
    ASSERT_EQ(crash(folder.path(), 2), 2);
    ASSERT_TRUE(first.end());
  }
  Session next = claim(folder.path());
  EXPECT_EQ(next.slot(), 2);
  ASSERT_TRUE(next.recovered());
  EXPECT_EQ(next.recovered()->document.seed, 2U);
  ASSERT_TRUE(next.save(next.recovered()->document, "", false));
  ASSERT_TRUE(next.end());
  const Session other = claim(folder.path());
  EXPECT_EQ(other.slot(), 1);
}

TEST(Session, LosesNothingInACrashAfterSaving) {
  const TemporaryFolder folder;
  {
    Session first = claim(folder.path());
    ASSERT_TRUE(first.save(example(1), "", true));
    ASSERT_EQ(crash(folder.path(), 2, true), 2);
    ASSERT_TRUE(first.end());
  }
  const Session next = claim(folder.path());
  EXPECT_EQ(next.slot(), 1);
}

TEST(Session, KeepsItsSlotWhenMoved) {
  const TemporaryFolder folder;
  Session session = claim(folder.path());
  Session moved = std::move(session);
  EXPECT_EQ(claim(folder.path()).slot(), 2);
  moved = claim(folder.path());
  EXPECT_EQ(moved.slot(), 2);
  EXPECT_EQ(claim(folder.path()).slot(), 1);
}

TEST(Session, StoresWholePaths) {
  const TemporaryFolder folder;
  {
    Session session = claim(folder.path());
    Document document = example();
    document.surface.path = "maps/brushed.png";
    ASSERT_TRUE(session.save(document, "steel.json", false));
  }
  const Session session = claim(folder.path());
  ASSERT_TRUE(session.recovered());
  EXPECT_EQ(session.recovered()->document.surface.path, std::filesystem::current_path() / "maps/brushed.png");
  EXPECT_EQ(session.recovered()->preset_file, std::filesystem::current_path() / "steel.json");
}

TEST(Session, LeavesWhatItFoundIfItNeverSaved) {
  const TemporaryFolder folder;
  crash(folder.path(), 12);
  const std::string before = test::text_of(folder / "session-1.json");
  ASSERT_TRUE(claim(folder.path()).end());
  EXPECT_EQ(test::text_of(folder / "session-1.json"), before);
}

TEST(Session, SetsAnUnreadableFileAside) {
  const std::string document = preset_text(example());
  const std::vector<std::string> texts = {
      "",
      "{",
      "[]",
      "{\"saved\": true}",
      R"({"saved": 1, "ended": true, "preset": null, "document": )" + document + "}",
      R"({"saved": true, "ended": true, "preset": 3, "document": )" + document + "}",
      R"({"saved": true, "ended": true, "preset": null})",
      R"({"saved": true, "ended": true, "preset": null, "document": {"glintscope": "preset", "version": 99}})"};
  for (const std::string& text : texts) {
    const TemporaryFolder folder;
    test::write_text(folder / "session-1.json", text);
    const Session session = claim(folder.path());
    EXPECT_FALSE(session.recovered()) << text;
    ASSERT_TRUE(session.fault()) << text;
    EXPECT_THAT(session.fault()->message(), HasSubstr("it was kept as session-1.json.unreadable")) << text;
    EXPECT_EQ(test::text_of(folder / "session-1.json.unreadable"), text);
    EXPECT_FALSE(std::filesystem::exists(folder / "session-1.json"));
  }
}

TEST(Session, SaysWhereItCannotBegin) {
  const TemporaryFolder folder;
  test::write_text(folder / "file", "");
  EXPECT_FALSE(Session::begin(folder / "file"));
  EXPECT_FALSE(Session::begin(folder / "file/below"));
}

}  // namespace
}  // namespace glint::gui
