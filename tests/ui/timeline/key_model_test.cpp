#include "timeline/key_model.h"

#include <gtest/gtest.h>

#include <QUndoStack>
#include <limits>

#include "timeline/key_commands.h"

namespace limbwave::ui {
namespace {

constexpr double kFrame = 1.0 / 60.0;

struct Keys : ::testing::Test {
  KeyModel model;
  QUndoStack stack;
  KeyEditor editor{model, stack};

  void SetUp() override { model.reset({QStringLiteral("upper"), QStringLiteral("lower")}, 10.0, kFrame); }
  [[nodiscard]] KeyPlace place(int lane, int index) const {
    return {lane, model.keys(lane)[static_cast<std::size_t>(index)].id};
  }
  [[nodiscard]] std::vector<std::vector<LaneKey>> all() const { return {model.keys(0), model.keys(1)}; }
};

TEST_F(Keys, ValueIsLinearBetweenKeysAndHeldOutside) {
  EXPECT_DOUBLE_EQ(model.value_at(0, 3.0), 0.0);
  model.load(0, {{0, 2.0, 1.0}, {0, 4.0, 3.0}});
  EXPECT_DOUBLE_EQ(model.value_at(0, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(model.value_at(0, 3.0), 2.0);
  EXPECT_DOUBLE_EQ(model.value_at(0, 9.0), 3.0);
  EXPECT_DOUBLE_EQ(model.value_at(7, 1.0), 0.0);
}

TEST_F(Keys, ChangesAreAllOrNothing) {
  model.load(0, {{0, 1.0, 0.5}});
  const auto before = all();
  const LaneKey key = model.keys(0)[0];
  const std::vector<KeyChange> good_and_bad{{0, key, LaneKey{key.id, 2.0, 0.5}},
                                            {1, LaneKey{99, 1.0, 0.0}, std::nullopt}};
  EXPECT_FALSE(model.apply(good_and_bad));
  EXPECT_EQ(all(), before);
  EXPECT_FALSE(model.apply({{0, std::nullopt, LaneKey{50, 1.0 + kFrame / 4, 0.0}}})) << "too near";
  EXPECT_FALSE(model.apply({{0, std::nullopt, LaneKey{50, 10.5, 0.0}}})) << "outside";
  EXPECT_FALSE(model.apply({{0, std::nullopt, LaneKey{50, 5.0, std::numeric_limits<double>::quiet_NaN()}}}));
  EXPECT_FALSE(model.apply({{2, std::nullopt, LaneKey{50, 5.0, 0.0}}})) << "no such lane";
  EXPECT_EQ(all(), before);
}

TEST_F(Keys, UndoAndRedoWalkThroughEveryState) {
  std::vector<std::vector<std::vector<LaneKey>>> states{all()};
  const auto note = [&](bool done) {
    EXPECT_TRUE(done);
    states.push_back(all());
  };
  note(editor.set_value(0, 1.0, 0.3));
  note(editor.set_value(0, 2.0, 0.6));
  note(editor.set_value(1, 1.5, -0.2));
  note(editor.set_value(0, 1.0, 0.9));  // The same key gets another value.
  EXPECT_EQ(model.keys(0).size(), 2U);
  note(editor.move({place(0, 0), place(1, 0)}, 0.25));
  note(editor.turn({place(0, 1)}, 0.1));
  note(editor.remove({place(0, 0), place(1, 0)}));
  for (int walk = 0; walk < 2; ++walk) {
    for (auto i = static_cast<int>(states.size()) - 2; i >= 0; --i) {
      stack.undo();
      EXPECT_EQ(all(), states[static_cast<std::size_t>(i)]) << "undo to " << i;
    }
    EXPECT_FALSE(stack.canUndo());
    for (std::size_t i = 1; i < states.size(); ++i) {
      stack.redo();
      EXPECT_EQ(all(), states[i]) << "redo to " << i;
    }
    EXPECT_FALSE(stack.canRedo());
  }
}

TEST_F(Keys, OneDragIsOneStep) {
  model.load(0, {{0, 1.0, 0.5}});
  const auto before = all();
  const int drag = editor.begin_gesture();
  for (int i = 0; i < 10; ++i) {
    ASSERT_TRUE(editor.move({place(0, 0)}, 0.1, drag));
  }
  EXPECT_NEAR(model.keys(0)[0].time_s, 2.0, 1e-9);
  EXPECT_EQ(stack.count(), 1);
  ASSERT_TRUE(editor.move({place(0, 0)}, 0.1, editor.begin_gesture()));
  EXPECT_EQ(stack.count(), 2);
  stack.undo();
  EXPECT_NEAR(model.keys(0)[0].time_s, 2.0, 1e-9);
  stack.undo();
  EXPECT_EQ(all(), before);
}

TEST_F(Keys, ASliderThatMakesAKeyAndTravelsIsOneStep) {
  const int gesture = editor.begin_gesture();
  for (int i = 1; i <= 5; ++i) {
    ASSERT_TRUE(editor.set_value(0, 3.0, 0.1 * i, gesture));
  }
  ASSERT_EQ(model.keys(0).size(), 1U);
  EXPECT_EQ(stack.count(), 1);
  stack.undo();
  EXPECT_TRUE(model.keys(0).empty());
  stack.redo();
  ASSERT_EQ(model.keys(0).size(), 1U);
  EXPECT_DOUBLE_EQ(model.keys(0)[0].value, 0.5);
}

TEST_F(Keys, MovedKeysStopBeforeOthersAndAtTheEnds) {
  model.load(0, {{0, 1.0, 0.0}, {0, 1.1, 0.0}});
  editor.move({place(0, 0)}, 0.1);
  EXPECT_GE(model.keys(0)[1].time_s - model.keys(0)[0].time_s, kFrame - 1e-9);
  EXPECT_TRUE(editor.move({place(0, 0)}, -50.0));
  EXPECT_DOUBLE_EQ(model.keys(0)[0].time_s, 0.0);
  EXPECT_FALSE(editor.move({place(0, 0)}, -1.0));
  EXPECT_TRUE(editor.move({place(0, 1)}, 50.0));
  EXPECT_DOUBLE_EQ(model.keys(0)[1].time_s, 10.0);
}

TEST_F(Keys, SelectionForgetsKeysThatUndoTakesAway) {
  editor.set_value(0, 1.0, 0.3);
  ASSERT_EQ(editor.selected().size(), 1U);
  stack.undo();
  EXPECT_TRUE(editor.selected().empty());
}

TEST_F(Keys, AKeySetAfterTwoUndoneStepsIsSelected) {
  editor.set_value(0, 1.0, 0.3);
  editor.set_value(0, 2.0, 0.3);
  stack.undo();
  stack.undo();
  EXPECT_TRUE(editor.set_value(0, 3.0, 0.4));
  EXPECT_EQ(editor.selected().size(), 1U);
  EXPECT_EQ(stack.count(), 1);
}

TEST_F(Keys, NothingToDoLeavesNoStep) {
  EXPECT_FALSE(editor.remove({}));
  EXPECT_FALSE(editor.set_value(5, 1.0, 0.0));
  EXPECT_FALSE(editor.change_value({0, 77}, 1.0));
  EXPECT_EQ(stack.count(), 0);
}

}  // namespace
}  // namespace limbwave::ui
