/// The first page: what Limbwave is, demo takes as pictures, a new take, an import, the recent takes.
#pragma once

#include <QWidget>

#include "common/studio_context.h"

class QListWidget;
class QVBoxLayout;

namespace limbwave::ui {

class TakeActions;

class WelcomePage : public QWidget {
  Q_OBJECT
 public:
  WelcomePage(StudioContext& context, TakeActions& actions, QWidget* parent = nullptr);

 private:
  QWidget* make_demos();
  void update_recent();
  StudioContext& context_;
  TakeActions& actions_;
  QListWidget* recent_;
  QWidget* recent_box_;
};

}  // namespace limbwave::ui
