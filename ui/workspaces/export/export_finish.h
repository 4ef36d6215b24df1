/// The end of the Export page, always in view: where the file goes, what to look out for, the button, and what came of
/// it.
#pragma once

#include "common/widgets.h"
#include "workspaces/export/export_model.h"

class QHBoxLayout;
class QLineEdit;
class QProgressBar;

namespace limbwave::ui {

class ExportFinish : public QWidget {
  Q_OBJECT
 public:
  explicit ExportFinish(ExportModel& model, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  /// A sentence with the shape of its tone in front; hidden while it is empty.
  struct Told {
    QWidget* row = nullptr;
    QLabel *icon = nullptr, *text = nullptr;
  };
  Told add_told(const QString& name, QVBoxLayout* column);
  void tell(const Told& told, Tone tone, const QString& text);
  void make_file_row(QVBoxLayout* column);
  void make_buttons(QVBoxLayout* column);
  QWidget* make_result();
  void show_plan();
  void show_job();
  void show_result(const Result<interchange::ExportReport>& result);
  void browse();
  /// A typed ending of another format means that format.
  void follow_ending();

  ExportModel& model_;
  QLineEdit* file_ = nullptr;
  Told problem_, warnings_, replaced_;
  QLabel* step_ = nullptr;
  QPushButton *export_ = nullptr, *cancel_ = nullptr, *open_folder_ = nullptr, *copy_path_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QFrame* result_ = nullptr;
  QLabel *result_icon_ = nullptr, *result_text_ = nullptr, *result_detail_ = nullptr;
  bool failed_ = false;  ///< What the result tells of.
  std::filesystem::path written_;
};

}  // namespace limbwave::ui
