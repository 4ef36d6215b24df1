#include "workspaces/export/export_workspace.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>

#include "common/theme.h"
#include "common/widgets.h"
#include "workspaces/export/export_finish.h"
#include "workspaces/export/export_options_card.h"
#include "workspaces/export/export_preset_card.h"
#include "workspaces/export/export_source_card.h"

namespace limbwave::ui {

namespace {

constexpr int kFormWidth = 640;
constexpr int kPreviewWidth = 280;
const auto kAnimationTopic = QStringLiteral("animation:");

}  // namespace

ExportWorkspace::ExportWorkspace(StudioContext& context, QWidget* parent)
    : Workspace(parent),
      context_(context),
      solves_(SolveModel::of(context)),
      model_(new ExportModel(context, solves_, this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  pages_ = new QStackedWidget(this);
  layout->addWidget(pages_);
  empty_ = new EmptyState(QStringLiteral("export"), pages_);
  solve_button_ = empty_->add_button(tr("Go to Solve"), true);
  open_button_ = empty_->add_button(tr("Open animation…"), false);
  pages_->addWidget(empty_);
  pages_->addWidget(make_page());
  connect(solve_button_, &QPushButton::clicked, this, [this] { context_.reveal(QStringLiteral("solve")); });
  connect(open_button_, &QPushButton::clicked, this, [this] { source_->choose_animation(); });
  connect(&model_->sources(), &ExportSourceList::changed, this, &ExportWorkspace::show_state);
  connect(&solves_, &SolveModel::state_changed, this, &ExportWorkspace::show_state);
  connect(&context_.document(), &TakeDocument::changed, this, &ExportWorkspace::show_state);
  show_state();
}

QWidget* ExportWorkspace::make_page() {
  auto* page = new QWidget(pages_);
  auto* row = new QHBoxLayout(page);
  row->setContentsMargins(3 * kGrid, 3 * kGrid, 3 * kGrid, 3 * kGrid);
  row->setSpacing(2 * kGrid);
  // The choices scroll where they do not fit; the file, the button and the picture stay in view.
  auto* left = new QWidget(page);
  left->setMaximumWidth(kFormWidth);
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2 * kGrid);
  auto* area = new QScrollArea(left);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* choices = new QWidget(area);
  choices->setProperty("scroll", true);
  auto* cards = new QVBoxLayout(choices);
  cards->setContentsMargins(0, 0, 0, 0);
  cards->setSpacing(2 * kGrid);
  source_ = new ExportSourceCard(context_, *model_, choices);
  cards->addWidget(source_);
  cards->addWidget(new ExportPresetCard(*model_, choices));
  cards->addWidget(new ExportOptionsCard(context_, *model_, choices));
  cards->addStretch(1);
  area->setWidget(choices);
  area->setMinimumWidth(choices->minimumSizeHint().width() + area->verticalScrollBar()->sizeHint().width());
  column->addWidget(area, 1);
  column->addWidget(new ExportFinish(*model_, left));
  preview_ = new ExportPreview(context_, solves_, *model_, page);
  preview_->setMinimumWidth(kPreviewWidth);
  row->addWidget(left, 1);
  row->addWidget(preview_, 1);
  return page;
}

void ExportWorkspace::activate() {
  model_->set_active(true);
  preview_->set_active(true);
}

void ExportWorkspace::deactivate() {
  preview_->set_active(false);
  model_->set_active(false);
}

void ExportWorkspace::reveal(const QString& topic) {
  if (topic.startsWith(kAnimationTopic)) {
    model_->sources().open_animation(topic.mid(kAnimationTopic.size()));
  } else if (topic == QLatin1String("close")) {
    model_->sources().close_animations();
  }
}

void ExportWorkspace::show_state() {
  pages_->setCurrentIndex(model_->has_source() ? 1 : 0);
  const bool open = context_.document().is_open();
  const bool busy = solves_.state() == SolveState::kSolving || solves_.state() == SolveState::kLoading;
  if (!open) {
    empty_->set_texts(tr("There is nothing to export yet"),
                      tr("Open or capture a take, or open an animation of another program (BVH, FBX or glTF)."));
  } else if (busy) {
    empty_->set_texts(tr("The take is being solved"), tr("It can be exported in a moment."));
  } else {
    empty_->set_texts(tr("Nothing is solved yet"), tr("Solve the take first."));
  }
  solve_button_->setVisible(open);
}

}  // namespace limbwave::ui
