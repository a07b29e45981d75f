#include "gui/jobs/editor.h"

#include <gtest/gtest.h>

namespace glint::gui {
namespace {

Document with_seed(std::uint64_t seed) {
  Document document;
  document.seed = seed;
  return document;
}

view::Edit step_of_gesture(std::uint64_t seed, const std::string& label) {
  return {with_seed(seed), label, false};
}

view::Edit finished(std::uint64_t seed, const std::string& label) {
  return {with_seed(seed), label, true};
}

TEST(Editor, BeginsSavedWithNothingToUndo) {
  const Editor editor(with_seed(5));
  EXPECT_EQ(editor.document().seed, 5U);
  EXPECT_EQ(editor.revision(), 0U);
  EXPECT_TRUE(editor.is_saved());
  EXPECT_FALSE(editor.can_undo());
  EXPECT_FALSE(editor.can_redo());
  EXPECT_FALSE(editor.in_gesture());
}

TEST(Editor, AFinishedEditIsAStepOfUndo) {
  Editor editor(with_seed(1));
  ASSERT_TRUE(editor.apply(finished(2, "two")));
  EXPECT_EQ(editor.document().seed, 2U);
  EXPECT_EQ(editor.undo_label(), "two");
  ASSERT_TRUE(editor.undo());
  EXPECT_EQ(editor.document().seed, 1U);
  EXPECT_EQ(editor.redo_label(), "two");
  ASSERT_TRUE(editor.redo());
  EXPECT_EQ(editor.document().seed, 2U);
  EXPECT_FALSE(editor.redo());
}

TEST(Editor, AGestureIsLiveAndOneStep) {
  Editor editor(with_seed(1));
  ASSERT_TRUE(editor.apply(step_of_gesture(2, "seed")));
  ASSERT_TRUE(editor.apply(step_of_gesture(3, "seed")));
  EXPECT_EQ(editor.document().seed, 3U);
  EXPECT_TRUE(editor.in_gesture());
  EXPECT_FALSE(editor.is_saved());
  ASSERT_TRUE(editor.apply(finished(4, "seed")));
  EXPECT_FALSE(editor.in_gesture());
  EXPECT_EQ(editor.undo_label(), "seed");
  ASSERT_TRUE(editor.undo());
  EXPECT_EQ(editor.document().seed, 1U);
  EXPECT_FALSE(editor.can_undo());
}

TEST(Editor, FinishingAGestureKeepsItAsItStands) {
  Editor editor(with_seed(1));
  ASSERT_TRUE(editor.apply(step_of_gesture(2, "seed")));
  const std::uint64_t revision = editor.revision();
  editor.finish_gesture();
  EXPECT_FALSE(editor.in_gesture());
  EXPECT_EQ(editor.document().seed, 2U);
  EXPECT_EQ(editor.revision(), revision);
  EXPECT_EQ(editor.undo_label(), "seed");
}

TEST(Editor, CancellingAGestureGoesBackToBeforeIt) {
  Editor editor(with_seed(1));
  ASSERT_TRUE(editor.apply(finished(2, "two")));
  ASSERT_TRUE(editor.undo());
  ASSERT_TRUE(editor.apply(step_of_gesture(3, "seed")));
  EXPECT_FALSE(editor.can_redo());
  editor.cancel_gesture();
  EXPECT_EQ(editor.document().seed, 1U);
  EXPECT_FALSE(editor.in_gesture());
  EXPECT_FALSE(editor.can_undo());
  EXPECT_EQ(editor.redo_label(), "two");  // nothing has happened
}

TEST(Editor, AnEditOfAnotherLabelFinishesTheOpenGesture) {
  Editor editor(with_seed(1));
  ASSERT_TRUE(editor.apply(step_of_gesture(2, "first")));
  ASSERT_TRUE(editor.apply(step_of_gesture(3, "second")));
  editor.cancel_gesture();
  EXPECT_EQ(editor.document().seed, 2U);
  EXPECT_EQ(editor.undo_label(), "first");
  ASSERT_TRUE(editor.apply(step_of_gesture(4, "third")));
  ASSERT_TRUE(editor.apply(finished(5, "fourth")));
  EXPECT_EQ(editor.undo_label(), "fourth");
  ASSERT_TRUE(editor.undo());
  EXPECT_EQ(editor.document().seed, 4U);
  EXPECT_EQ(editor.undo_label(), "third");
}

TEST(Editor, AGestureThatEndsWhereItBeganIsNoStep) {
  Editor editor(with_seed(1));
  ASSERT_TRUE(editor.apply(step_of_gesture(2, "seed")));
  ASSERT_TRUE(editor.apply(finished(1, "seed")));
  EXPECT_FALSE(editor.in_gesture());
  EXPECT_FALSE(editor.can_undo());
  EXPECT_TRUE(editor.is_saved());
}

TEST(Editor, UndoTakesTheOpenGestureBack) {
  Editor editor(with_seed(1));
  ASSERT_TRUE(editor.apply(step_of_gesture(2, "seed")));
  EXPECT_TRUE(editor.can_undo());
  EXPECT_EQ(editor.undo_label(), "seed");
  ASSERT_TRUE(editor.undo());
  EXPECT_EQ(editor.document().seed, 1U);
  EXPECT_FALSE(editor.in_gesture());
  ASSERT_TRUE(editor.redo());
  EXPECT_EQ(editor.document().seed, 2U);
}

TEST(Editor, TheRevisionGrowsWithEveryChangeAndOnlyThen) {
  Editor editor(with_seed(1));
  ASSERT_TRUE(editor.apply(finished(1, "nothing")));
  EXPECT_EQ(editor.revision(), 0U);
  ASSERT_TRUE(editor.apply(step_of_gesture(2, "seed")));
  EXPECT_EQ(editor.revision(), 1U);
  ASSERT_TRUE(editor.apply(step_of_gesture(2, "seed")));
  EXPECT_EQ(editor.revision(), 1U);
  ASSERT_TRUE(editor.apply(finished(2, "seed")));
  EXPECT_EQ(editor.revision(), 1U);
  editor.undo();
  EXPECT_EQ(editor.revision(), 2U);
  editor.undo();
  EXPECT_EQ(editor.revision(), 2U);
  editor.redo();
  EXPECT_EQ(editor.revision(), 3U);
  ASSERT_TRUE(editor.apply(step_of_gesture(9, "seed")));
  editor.cancel_gesture();
  EXPECT_EQ(editor.revision(), 5U);
}

TEST(Editor, RefusesADocumentWithAFault) {
  Editor editor(with_seed(1));
  ASSERT_TRUE(editor.apply(step_of_gesture(2, "seed")));
  view::Edit edit = step_of_gesture(3, "roughness");
  edit.document.intrinsic_roughness = -1;
  const Status status = editor.apply(edit);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().subject, "intrinsic_roughness");
  EXPECT_EQ(editor.document(), with_seed(2));
  EXPECT_EQ(editor.revision(), 1U);
  EXPECT_TRUE(editor.in_gesture());
  EXPECT_FALSE(editor.open(edit.document, "Open it"));
  EXPECT_EQ(editor.document(), with_seed(2));
}

TEST(Editor, AnOpenedDocumentIsAnUndoableStepThatCountsAsSaved) {
  Editor editor(with_seed(1));
  ASSERT_TRUE(editor.apply(finished(2, "two")));
  ASSERT_TRUE(editor.open(with_seed(7), "Open seven"));
  EXPECT_TRUE(editor.is_saved());
  EXPECT_EQ(editor.saved().seed, 7U);
  EXPECT_EQ(editor.undo_label(), "Open seven");
  ASSERT_TRUE(editor.undo());
  EXPECT_EQ(editor.document().seed, 2U);
  EXPECT_FALSE(editor.is_saved());
}

TEST(Editor, WhatIsSavedIsTheLiveDocument) {
  Editor editor(with_seed(1));
  ASSERT_TRUE(editor.apply(step_of_gesture(2, "seed")));
  editor.mark_saved();
  EXPECT_TRUE(editor.is_saved());
  EXPECT_EQ(editor.saved().seed, 2U);
  EXPECT_FALSE(editor.in_gesture());
  ASSERT_TRUE(editor.apply(step_of_gesture(3, "seed")));
  EXPECT_FALSE(editor.is_saved());
  editor.cancel_gesture();
  EXPECT_TRUE(editor.is_saved());
}

}  // namespace
}  // namespace glint::gui
