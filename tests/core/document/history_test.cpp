#include "core/document/history.h"

#include <gtest/gtest.h>

namespace glint {
namespace {

Document with_seed(std::uint64_t seed) {
  Document document;
  document.seed = seed;
  return document;
}

TEST(History, BeginsSavedWithNothingToUndo) {
  History history(with_seed(5));
  EXPECT_EQ(history.current().seed, 5U);
  EXPECT_TRUE(history.is_saved());
  EXPECT_FALSE(history.can_undo());
  EXPECT_FALSE(history.can_redo());
  EXPECT_FALSE(history.undo());
  EXPECT_FALSE(history.redo());
  EXPECT_EQ(history.revision(), 0U);
  EXPECT_EQ(history.undo_label(), "");
  EXPECT_EQ(history.redo_label(), "");
}

TEST(History, TakesEditsBackAndDoesThemAgain) {
  History history(with_seed(1));
  EXPECT_TRUE(history.commit(with_seed(2), "two"));
  EXPECT_TRUE(history.commit(with_seed(3), "three"));
  EXPECT_EQ(history.undo_label(), "three");
  ASSERT_TRUE(history.undo());
  EXPECT_EQ(history.current().seed, 2U);
  EXPECT_EQ(history.undo_label(), "two");
  EXPECT_EQ(history.redo_label(), "three");
  ASSERT_TRUE(history.undo());
  EXPECT_EQ(history.current().seed, 1U);
  EXPECT_FALSE(history.can_undo());
  ASSERT_TRUE(history.redo());
  ASSERT_TRUE(history.redo());
  EXPECT_EQ(history.current().seed, 3U);
  EXPECT_FALSE(history.can_redo());
}

TEST(History, CountsEveryChangeAndOnlyChanges) {
  History history(with_seed(1));
  EXPECT_FALSE(history.commit(with_seed(1), "the same again"));
  EXPECT_EQ(history.revision(), 0U);
  EXPECT_FALSE(history.can_undo());
  history.commit(with_seed(2), "two");
  EXPECT_EQ(history.revision(), 1U);
  history.undo();
  EXPECT_EQ(history.revision(), 2U);
  history.redo();
  EXPECT_EQ(history.revision(), 3U);
  history.redo();
  EXPECT_EQ(history.revision(), 3U);
}

TEST(History, ForgetsWhatWasUndoneAtTheNextEdit) {
  History history(with_seed(1));
  history.commit(with_seed(2), "two");
  history.commit(with_seed(3), "three");
  history.undo();
  history.undo();
  history.commit(with_seed(4), "four");
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(history.undo_label(), "four");
  history.undo();
  EXPECT_EQ(history.current().seed, 1U);
  EXPECT_EQ(history.redo_label(), "four");
}

TEST(History, AnEditThatChangesNothingKeepsWhatCanBeRedone) {
  History history(with_seed(1));
  history.commit(with_seed(2), "two");
  history.undo();
  EXPECT_FALSE(history.commit(with_seed(1), "nothing"));
  EXPECT_TRUE(history.can_redo());
}

TEST(History, IsBounded) {
  History history(with_seed(0));
  const std::uint64_t edits = History::k_most_steps + 10;
  for (std::uint64_t seed = 1; seed <= edits; ++seed) history.commit(with_seed(seed), "edit");
  std::size_t undone = 0;
  while (history.undo()) ++undone;
  EXPECT_EQ(undone, History::k_most_steps);
  EXPECT_EQ(history.current().seed, 10U);
  while (history.redo()) --undone;
  EXPECT_EQ(undone, 0U);
  EXPECT_EQ(history.current().seed, edits);
}

TEST(History, KnowsWhetherTheDocumentIsTheSavedOne) {
  History history(with_seed(1));
  history.commit(with_seed(2), "two");
  EXPECT_FALSE(history.is_saved());
  history.mark_saved();
  EXPECT_TRUE(history.is_saved());
  history.undo();
  EXPECT_FALSE(history.is_saved());
  history.commit(with_seed(3), "three");  // cuts off the saved step
  EXPECT_FALSE(history.is_saved());
  history.commit(with_seed(2), "back to two by hand");
  EXPECT_TRUE(history.is_saved());
}

}  // namespace
}  // namespace glint
