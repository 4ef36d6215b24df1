/// What both wizards share in front of people: the frame and its buttons, where
/// the signal comes from, the list of verdicts, notes, sounds, and the question
/// before something is lost.
#pragma once

#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <vector>

#include "calibration/cue_sounds.h"
#include "calibration/verdict_row.h"
#include "calibration/wizard_frame.h"
#include "calibration/wizard_model.h"

namespace limbwave::ui {

class CalibrationWizard : public QWidget {
  Q_OBJECT
 public:
  CalibrationWizard(WizardModel& model, const QString& title, bool with_map, QWidget* parent);
  [[nodiscard]] WizardFrame* frame() const { return frame_; }
  [[nodiscard]] CueSounds& sounds() { return sounds_; }

 Q_SIGNALS:
  /// No signal: the technician wants to open a device.
  void device_wanted();

 protected:
  /// 16 px text of a page, which wraps.
  [[nodiscard]] static QLabel* paragraph(const QString& text, QWidget* parent);
  /// A page of two columns: what is chosen or shown, and words.
  struct Columns {
    QWidget* page;
    QHBoxLayout* both;
    QVBoxLayout* words;
  };
  [[nodiscard]] Columns make_columns();
  /// Adds "Signal: ...", the button that opens a device, and the way to a chapter of the manual.
  void add_source_line(QVBoxLayout* words, QWidget* page, const QString& chapter);
  /// The page of verdicts; returns the row below the list for further buttons.
  [[nodiscard]] QWidget* make_result_page(QHBoxLayout** buttons);
  /// Findings about the calibration as a whole, above the rows; empty: none.
  void set_findings(const QString& text);
  [[nodiscard]] VerdictRow* row(int i) const { return rows_.at(static_cast<std::size_t>(i)); }

  /// What verdict `i` says, in the words of its row.
  [[nodiscard]] virtual VerdictRowContent row_content(int i) const = 0;
  /// The part of the verdicts' page that only this wizard has.
  virtual void refresh_own_results() {}
  /// Steps and buttons for the present page.
  virtual void refresh_own_buttons() = 0;
  /// What leaving now would lose, when it is not verdicts.
  [[nodiscard]] virtual QString movement_lost() const = 0;
  /// The page on which verdicts, and nothing else, would be lost.
  [[nodiscard]] virtual bool on_verdicts() const = 0;

  void refresh_results();
  void refresh_buttons();
  void show_note(bool relevant);

 private:
  void leave();
  void refresh_sound_button();

  WizardModel& shared_;
  WizardFrame* frame_;
  CueSounds sounds_;
  QToolButton* sound_button_;
  bool with_map_;
  QLabel* source_line_ = nullptr;
  QPushButton* open_device_ = nullptr;
  QLabel* summary_ = nullptr;
  QLabel* findings_ = nullptr;
  QVBoxLayout* rows_layout_ = nullptr;
  std::vector<VerdictRow*> rows_;
};

}  // namespace limbwave::ui
