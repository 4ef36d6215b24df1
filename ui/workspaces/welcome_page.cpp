#include "workspaces/welcome_page.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "common/icons.h"
#include "common/motion_names.h"
#include "common/theme.h"
#include "common/widgets.h"
#include "workspaces/demo_picture.h"
#include "workspaces/take_actions.h"

namespace limbwave::ui {

WelcomePage::WelcomePage(StudioContext& context, TakeActions& actions, QWidget* parent)
    : QWidget(parent), context_(context), actions_(actions), recent_(new QListWidget(this)) {
  setObjectName(QStringLiteral("welcome_page"));
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  outer->addWidget(scroll);
  auto* page = new QWidget(scroll);
  page->setProperty("scroll", true);
  scroll->setWidget(page);
  auto* centered = new QHBoxLayout(page);
  centered->setContentsMargins(3 * kGrid, 3 * kGrid, 3 * kGrid, 3 * kGrid);
  centered->addStretch(1);
  auto* content = new QWidget(page);
  content->setMaximumWidth(1040);
  centered->addWidget(content, 20);
  centered->addStretch(1);
  auto* column = new QVBoxLayout(content);
  column->setSpacing(2 * kGrid);
  column->addStretch(1);

  auto* name = new QLabel(QStringLiteral("Limbwave"), content);
  QFont large = name->font();
  large.setPixelSize(34);
  large.setWeight(QFont::DemiBold);
  name->setFont(large);
  column->addWidget(name);
  auto* sentence = new QLabel(tr("Records what low-cost sensors on a body feel and turns it into animation for "
                                 "Blender, Maya, MotionBuilder, Unreal and Unity."),
                              content);
  QFont medium = sentence->font();
  medium.setPixelSize(16);
  sentence->setFont(medium);
  sentence->setProperty("role", "dim");
  sentence->setWordWrap(true);
  column->addWidget(sentence);
  column->addSpacing(kGrid);

  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid);
  const auto add_button = [&](const QString& icon_name, const QString& text, const QString& hint, bool primary) {
    auto* button = new QPushButton(text, content);
    button->setIcon(primary ? accent_icon(icon_name) : icon(icon_name));
    button->setProperty("primary", primary);
    button->setToolTip(hint);
    buttons->addWidget(button);
    return button;
  };
  auto* create = add_button(QStringLiteral("plus"), tr("New take"), tr("Choose a device and record"), true);
  create->setObjectName(QStringLiteral("welcome_new_take"));
  setFocusProxy(create);
  connect(create, &QPushButton::clicked, this, [this] { actions_.new_take(); });
  auto* import = add_button(QStringLiteral("import"), tr("Import recording"),
                            tr("WAV, FLAC or MP3 files of a sound recorder that was worn"), false);
  connect(import, &QPushButton::clicked, this, [this] { actions_.choose_and_import(); });
  auto* open = add_button(QStringLiteral("folder"), tr("Open take"), tr("A folder that ends in .take"), false);
  connect(open, &QPushButton::clicked, this, [this] { actions_.choose_and_open(); });
  auto* animation = add_button(QStringLiteral("export"), tr("Open animation"),
                               tr("BVH, FBX or glTF of another program, to look at it and to export it on"), false);
  connect(animation, &QPushButton::clicked, this, [this] { actions_.choose_and_open_animation(); });
  auto* manual = add_button(QStringLiteral("help"), tr("Manual"), tr("From the wiring to the animation (F1)"), false);
  manual->setObjectName(QStringLiteral("welcome_manual"));
  connect(manual, &QPushButton::clicked, this,
          [this] { context_.reveal(QStringLiteral("manual"), QStringLiteral("overview")); });
  buttons->addStretch();
  column->addLayout(buttons);
  column->addWidget(dim_label(tr("or drop recordings, takes and animations anywhere on this window"), content));
  column->addSpacing(2 * kGrid);
  column->addWidget(make_demos());
  column->addSpacing(kGrid);

  recent_box_ = new QWidget(content);
  auto* recent_layout = new QVBoxLayout(recent_box_);
  recent_layout->setContentsMargins(0, 0, 0, 0);
  recent_layout->addWidget(heading_label(tr("Recent takes"), recent_box_));
  recent_->setAccessibleName(tr("Recent takes"));
  recent_->setTextElideMode(Qt::ElideMiddle);
  recent_->setUniformItemSizes(true);
  recent_layout->addWidget(recent_);
  column->addWidget(recent_box_);
  column->addStretch(2);
  const auto open_item = [this](QListWidgetItem* item) { actions_.open(item->data(Qt::UserRole).toString()); };
  connect(recent_, &QListWidget::itemActivated, this, open_item);
  connect(&context_.recent_takes(), &RecentTakes::changed, this, &WelcomePage::update_recent);
  update_recent();
}

QWidget* WelcomePage::make_demos() {
  auto* box = new QWidget(this);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  layout->addWidget(heading_label(tr("Try it without hardware"), box));
  auto* row = new QHBoxLayout;
  row->setSpacing(2 * kGrid);
  layout->addLayout(row);
  int shown = 0;
  if (context_.services().demo_motions) {
    for (const std::string& name : context_.services().demo_motions()) {
      const QString motion = QString::fromStdString(name);
      auto* button = new DemoButton(motion, motion_title(motion), motion_hint(motion), box);
      button->setObjectName(QStringLiteral("demo_") + motion);
      connect(button, &QPushButton::clicked, this, [this, motion] { actions_.open_demo(motion); });
      row->addWidget(button);
      constexpr int kFitting = 5;
      if (++shown == kFitting) {
        break;
      }
    }
  }
  box->setVisible(shown > 0);
  return box;
}

void WelcomePage::update_recent() {
  recent_->clear();
  for (const QString& folder : context_.recent_takes().folders()) {
    const QFileInfo info(folder);
    auto* item = new QListWidgetItem(icon(QStringLiteral("folder")),
                                     QStringLiteral("%1   ·   %2").arg(info.completeBaseName(), info.path()), recent_);
    item->setData(Qt::UserRole, folder);
    item->setToolTip(folder);
  }
  recent_box_->setVisible(recent_->count() > 0);
  if (recent_->count() > 0) {
    constexpr int kRows = 6;
    recent_->setFixedHeight(recent_->sizeHintForRow(0) * std::min(kRows, recent_->count()) + 2 * kGrid);
  }
}

}  // namespace limbwave::ui
