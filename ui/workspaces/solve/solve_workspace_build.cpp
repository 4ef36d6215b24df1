// How the Solve workspace is put together.
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include "common/icons.h"
#include "common/theme.h"
#include "common/widgets.h"
#include "workspaces/solve/bone_card.h"
#include "workspaces/solve/quality_card.h"
#include "workspaces/solve/settings_card.h"
#include "workspaces/solve/solve_workspace.h"

namespace limbwave::ui {

namespace {

/// Scrolls up and down and is never narrower than what is in it: nothing is cut off at the right.
class InspectorArea : public QScrollArea {
 public:
  InspectorArea() {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  }
  void follow(QWidget* content) {
    setWidget(content);
    content->installEventFilter(this);
  }

  [[nodiscard]] QSize minimumSizeHint() const override {
    const int content = widget() == nullptr ? 0 : widget()->minimumSizeHint().width();
    return {content + verticalScrollBar()->sizeHint().width(), QScrollArea::minimumSizeHint().height()};
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::LayoutRequest && watched == widget()) {
      updateGeometry();
    }
    return QScrollArea::eventFilter(watched, event);
  }
};

}  // namespace

QWidget* SolveWorkspace::make_toolbar() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(2 * kGrid, kGrid / 2, kGrid, kGrid / 2);
  row->setSpacing(4);
  verdict_ = new QLabel(bar);
  verdict_->setObjectName(QStringLiteral("solve_verdict"));
  row->addWidget(verdict_);
  row->addSpacing(4);
  status_ = new ElidedLabel({}, bar);
  status_->setFont(tabular(font()));
  live_button_ = new QPushButton(tr("Live"), bar);
  live_button_->setCheckable(true);
  live_button_->setToolTip(tr("Show what is being captured instead of the take"));
  status_->setObjectName(QStringLiteral("solve_status"));
  row->addWidget(status_, 1);
  row->addWidget(live_button_);
  row->addSpacing(kGrid);
  const auto view = [&](const QString& text, const QString& keys, ViewDirection direction) {
    auto* button = new QPushButton(text, bar);
    button->setProperty("flat", true);
    button->setToolTip(tr("Look from this side (%1)").arg(keys));
    connect(button, &QPushButton::clicked, this, [this, direction] { viewer_->look(direction); });
    row->addWidget(button);
  };
  view(tr("Front"), tr("Shift+F"), ViewDirection::kFront);
  view(tr("Side"), tr("Shift+S"), ViewDirection::kSide);
  view(tr("Top"), tr("Shift+T"), ViewDirection::kTop);
  QToolButton* frame = icon_button(QStringLiteral("frame"), tr("Frame the selection (F)"), bar);
  connect(frame, &QToolButton::clicked, this, [this] { viewer_->frame_selection(); });
  row->addWidget(frame);
  const auto toggle = [&](const QString& icon_name, const QString& text, auto&& handler) {
    QToolButton* button = icon_button(icon_name, text, bar);
    button->setCheckable(true);
    button->setChecked(true);
    connect(button, &QToolButton::toggled, this, handler);
    row->addWidget(button);
    return button;
  };
  toggle(QStringLiteral("grid"), tr("Show the floor"), [this](bool on) { viewer_->set_floor_visible(on); });
  toggle(QStringLiteral("sensor"), tr("Show the sensors"), [this](bool on) { viewer_->set_sensors_visible(on); });
  // Not at first: without headings the two point elsewhere, which looks like a fault of the solve.
  ghost_ = toggle(QStringLiteral("person"), tr("Show the truth of this simulated take"),
                  [this](bool on) { viewer_->set_ghost_visible(on); });
  ghost_->setChecked(false);
  connect(live_button_, &QPushButton::clicked, this, [this](bool live) {
    wish_ = live;
    follow_live();
  });
  return bar;
}

QWidget* SolveWorkspace::make_failure_bar() {
  failure_bar_ = new QWidget(this);
  auto* row = new QHBoxLayout(failure_bar_);
  row->setContentsMargins(2 * kGrid, kGrid / 2, kGrid, kGrid / 2);
  row->setSpacing(kGrid);
  failure_ = new QLabel(failure_bar_);
  failure_->setWordWrap(true);
  failure_icon_ = new QLabel(failure_bar_);
  retry_ = new QPushButton(tr("Try again"), failure_bar_);
  calibrate_ = new QPushButton(tr("Calibrate"), failure_bar_);
  row->addWidget(failure_icon_);
  row->addWidget(failure_, 1);
  row->addWidget(calibrate_);
  row->addWidget(retry_);
  failure_bar_->hide();
  return failure_bar_;
}

QWidget* SolveWorkspace::make_main_page() {
  auto* page = new QWidget(this);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  viewer_ = new ViewerWidget(page);
  curves_ = new CurvesPanel(context_.time(), page);
  layout->addWidget(make_toolbar());
  layout->addWidget(make_failure_bar());
  auto* splitter = new QSplitter(Qt::Vertical, page);
  splitter->setObjectName(QStringLiteral("solve_splitter"));
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(viewer_);
  splitter->addWidget(curves_);
  splitter->setStretchFactor(0, 1);
  splitter->setStretchFactor(1, 0);
  splitter->setSizes({480, curves_->sizeHint().height()});
  layout->addWidget(splitter, 1);
  return page;
}

QWidget* SolveWorkspace::create_inspector() {
  auto* area = new InspectorArea;
  auto* content = new QWidget(area);
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid);
  layout->addWidget(new BoneCard(context_, model_, content));
  auto* of_take = new QWidget(content);
  auto* cards = new QVBoxLayout(of_take);
  cards->setContentsMargins(0, 0, 0, 0);
  cards->setSpacing(kGrid);
  cards->addWidget(new SettingsCard(model_, of_take));
  cards->addWidget(new TruthCard(model_, of_take));
  cards->addWidget(new QualityCard(model_, of_take));
  layout->addWidget(of_take);
  layout->addStretch(1);
  // Beside the live figure nothing is said about the take.
  connect(&model_, &SolveModel::shows_live_changed, of_take,
          [this, of_take] { of_take->setVisible(!model_.shows_live()); });
  of_take->setVisible(!model_.shows_live());
  area->follow(content);
  return area;
}

}  // namespace limbwave::ui
