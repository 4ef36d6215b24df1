/// Undo of the Export page: which choice a step was about, which steps are one, and what comes back with them.
#include "workspaces/export/export_edits.h"

#include <QSignalSpy>

#include "ui/export/export_fixture.h"

namespace limbwave::ui::testing {

class ExportEditsTest : public QObject, protected ExportCase {
  Q_OBJECT

 private:
  void open() {
    QVERIFY(open_studio(solving_->services()));
    QVERIFY(studio_->open_take());
    undo().clear();
  }
  void change(const std::function<void(ExportChoices&)>& how) const {
    ExportChoices choices = model().choices();
    how(choices);
    model().change(choices);
  }

 private Q_SLOTS:
  void init() { set_up(); }
  void cleanup() { tear_down(); }

  void a_step_is_named_after_what_differs_first() {
    const ExportState before;
    const auto field = [&](const std::function<void(ExportState&)>& change) {
      ExportState after = before;
      change(after);
      return changed_field(before, after);
    };
    QCOMPARE(field([](ExportState&) {}), ExportField::kNone);
    QCOMPARE(field([](ExportState& s) { s.sources.chosen = "other"; }), ExportField::kSource);
    QCOMPARE(field([](ExportState& s) { s.sources.others.resize(1); }), ExportField::kActors);
    QCOMPARE(field([](ExportState& s) { s.choices.fps = 25.0; }), ExportField::kRate);
    QCOMPARE(field([](ExportState& s) { s.choices.end_s = 3.5; }), ExportField::kRange);
    QCOMPARE(field([](ExportState& s) { s.choices.rest_frame = true; }), ExportField::kRest);
    QCOMPARE(field([](ExportState& s) { s.choices.key_tolerance_deg += 0.5; }), ExportField::kKeys);
    QCOMPARE(field([](ExportState& s) { s.file = QStringLiteral("a.fbx"); }), ExportField::kFile);
    // A preset brings others with it, and the name that follows.
    QCOMPARE(field([](ExportState& s) {
               s.choices.preset = "another";
               s.choices.fps = 25.0;
               s.file = QStringLiteral("a.fbx");
             }),
             ExportField::kPreset);
    QStringList texts;
    for (int f = static_cast<int>(ExportField::kSource); f <= static_cast<int>(ExportField::kFile); ++f) {
      texts << field_text(static_cast<ExportField>(f));
      QVERIFY(!texts.back().isEmpty());
    }
    QCOMPARE(texts.removeDuplicates(), 0);
  }

  void letters_and_turned_numbers_are_one_step_and_choices_are_not() {
    ExportState a, b;
    QVERIFY(is_typed(ExportField::kFile, a, b));
    QVERIFY(is_typed(ExportField::kKeys, a, b));
    QVERIFY(!is_typed(ExportField::kPreset, a, b));
    b.choices.range = ExportRange::kPart;
    QVERIFY2(!is_typed(ExportField::kRange, a, b), "to choose a part is a step of its own");
    a.choices.range = ExportRange::kPart;
    QVERIFY(is_typed(ExportField::kRange, a, b));
    a.choices.fps = 33.0;
    b.choices.fps = 34.0;
    QVERIFY(is_typed(ExportField::kRate, a, b));
    b.choices.fps = 30.0;
    QVERIFY2(!is_typed(ExportField::kRate, a, b), "one of the list is chosen, not typed");
  }

  void typing_a_name_is_one_step_and_nothing_when_it_ends_where_it_began() {
    open();
    const QString proposed = model().file();
    model().set_file(QStringLiteral("/tmp/a.fbx"));
    model().set_file(QStringLiteral("/tmp/ab.fbx"));
    QCOMPARE(undo().count(), 1);
    undo().undo();
    QCOMPARE(model().file(), proposed);
    undo().redo();
    QCOMPARE(model().file(), QStringLiteral("/tmp/ab.fbx"));
    model().set_file(proposed);
    QCOMPARE(undo().count(), 0);
    // Another field between them divides.
    model().set_file(QStringLiteral("/tmp/a.fbx"));
    change([](ExportChoices& c) { c.key_tolerance_deg = 0.7; });
    model().set_file(QStringLiteral("/tmp/b.fbx"));
    QCOMPARE(undo().count(), 3);
  }

  void a_name_of_ones_own_follows_the_format_in_the_same_step() {
    open();
    model().set_file(QStringLiteral("/tmp/arm.v2.fbx"));
    const QString format = model().choices().format;
    QVERIFY(studio_->pick("Format", "BVH"));
    QCOMPARE(model().file(), QStringLiteral("/tmp/arm.v2.bvh"));
    QCOMPARE(undo().count(), 2);
    undo().undo();
    QCOMPARE(model().file(), QStringLiteral("/tmp/arm.v2.fbx"));
    QCOMPARE(model().choices().format, format);
    undo().undo();
    QVERIFY2(model().file().endsWith(QStringLiteral("swing.fbx")), "the proposed name is proposed again");
    QVERIFY(studio_->pick("Format", "BVH"));
    QVERIFY2(model().file().endsWith(QStringLiteral("swing.bvh")), "and follows the format by itself");
  }

  void another_program_keeps_the_range() {
    open();
    change([](ExportChoices& c) {
      c.range = ExportRange::kPart;
      c.begin_s = 1.0;
      c.end_s = 2.5;
    });
    const std::string preset = model().choices().preset;
    model().choose_preset("maya");
    QCOMPARE(model().choices().preset, std::string("maya"));
    QCOMPARE(model().choices().begin_s, 1.0);
    QCOMPARE(model().choices().end_s, 2.5);
    QCOMPARE(undo().undoText(), field_text(ExportField::kPreset));
    undo().undo();
    QCOMPARE(model().choices().preset, preset);
    QCOMPARE(model().choices().end_s, 2.5);
  }

  void what_is_chosen_already_is_no_step() {
    open();
    QSignalSpy changed(&model(), &ExportModel::choices_changed);
    model().change(model().choices());
    model().set_file(model().file());
    QCOMPARE(undo().count(), 0);
    QVERIFY(changed.isEmpty());
  }
};

}  // namespace limbwave::ui::testing

QTEST_MAIN(limbwave::ui::testing::ExportEditsTest)
#include "export_edits_test.moc"
