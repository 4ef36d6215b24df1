/// Undo steps of the Capture workspace. Each knows what was before and what came after, and tells the model.
#pragma once

#include <QUndoCommand>
#include <string>
#include <utility>

#include "workspaces/capture/capture_model.h"

namespace limbwave::ui {

/// The rig, the subject or the take's name. Letters of one field that follow each other are one step.
class SetupCommand : public QUndoCommand {
 public:
  SetupCommand(CaptureModel& model, CaptureSetup after, int field, const QString& text)
      : QUndoCommand(text), model_(model), before_(model.setup()), after_(std::move(after)), field_(field) {}
  void redo() override { setObsolete(!model_.apply(after_)); }
  void undo() override { setObsolete(!model_.apply(before_)); }
  [[nodiscard]] int id() const override { return 0x6370; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = dynamic_cast<const SetupCommand*>(other);
    if (next == nullptr || next->field_ != field_ || next->before_ != after_) {
      return false;
    }
    after_ = next->after_;
    return true;
  }

 private:
  CaptureModel& model_;
  CaptureSetup before_, after_;
  int field_;
};

/// How a device is opened.
class FormatCommand : public QUndoCommand {
 public:
  FormatCommand(CaptureModel& model, acquire::DeviceInfo device, DeviceSetup before, DeviceSetup after,
                const QString& text)
      : QUndoCommand(text),
        model_(model),
        device_(std::move(device)),
        before_(std::move(before)),
        after_(std::move(after)) {}
  void redo() override { model_.put_format(device_, after_); }
  void undo() override { model_.put_format(device_, before_); }

 private:
  CaptureModel& model_;
  acquire::DeviceInfo device_;
  DeviceSetup before_, after_;
};

/// Which sensors hang on a device, and where they are worn.
class BoardCommand : public QUndoCommand {
 public:
  BoardCommand(CaptureModel& model, QString device, std::string rig, take::Board before, take::Board after,
               const QString& text)
      : QUndoCommand(text),
        model_(model),
        device_(std::move(device)),
        rig_(std::move(rig)),
        before_(std::move(before)),
        after_(std::move(after)) {}
  void redo() override { model_.put_board(device_, rig_, after_); }
  void undo() override { model_.put_board(device_, rig_, before_); }

 private:
  CaptureModel& model_;
  QString device_;
  std::string rig_;
  take::Board before_, after_;
};

}  // namespace limbwave::ui
