#include "workspaces/capture/capture_workspace.h"

#include <QHBoxLayout>
#include <QScrollArea>
#include <QShortcut>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "common/core_services.h"
#include "common/format.h"
#include "common/theme.h"
#include "common/widgets.h"
#include "plots/scope_view.h"
#include "plots/sensor_strips.h"
#include "plots/wire_view.h"
#include "workspaces/capture/box_panel.h"
#include "workspaces/capture/level_panel.h"
#include "workspaces/capture/marker_panel.h"
#include "workspaces/capture/overview_panel.h"
#include "workspaces/capture/record_panel.h"
#include "workspaces/capture/source_bar.h"

namespace limbwave::ui {
namespace {

bool is_simulator(const acquire::DeviceInfo& device) {
  return device.id.starts_with(kSimulatorPrefix);
}

}  // namespace

CaptureWorkspace::CaptureWorkspace(StudioContext& context, QWidget* parent)
    : Workspace(parent),
      context_(context),
      model_(CaptureModel::of(context)),
      source_(new SourceBar(context, model_, this)),
      center_(new QStackedWidget(this)),
      empty_(new EmptyState(QStringLiteral("no-device"), this)) {
  setObjectName(QStringLiteral("capture_workspace"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2 * kGrid, 2 * kGrid, 0, kGrid);
  layout->setSpacing(2 * kGrid);
  auto* column = new QVBoxLayout;
  column->setSpacing(2 * kGrid);
  column->addWidget(source_);
  column->addWidget(center_, 1);
  overview_ = new OverviewPanel(context_, this);
  column->addWidget(overview_);
  layout->addLayout(column, 1);

  empty_refresh_ = empty_->add_button(tr("Look again"), false);
  empty_refresh_->setObjectName(QStringLiteral("empty_refresh"));
  empty_simulator_ = empty_->add_button(tr("Use the simulator"), true);
  empty_simulator_->setObjectName(QStringLiteral("use_simulator"));
  connect(empty_->add_link(tr("Learn how the board is connected")), &QLabel::linkActivated, this,
          [this] { context_.reveal(QStringLiteral("manual"), QStringLiteral("wiring")); });
  connect(empty_refresh_, &QPushButton::clicked, &model_, &CaptureModel::refresh_devices);
  connect(empty_simulator_, &QPushButton::clicked, this, [this] {
    const auto& devices = model_.devices();
    const auto found = std::find_if(devices.begin(), devices.end(), is_simulator);
    if (found != devices.end()) {
      model_.open_device(QString::fromStdString(found->id));
    }
  });
  center_->addWidget(empty_);
  make_signals();
  make_side();
  layout->addWidget(side_);
  make_shortcuts();

  connect(&model_, &CaptureModel::devices_changed, this, &CaptureWorkspace::follow_state);
  connect(&model_, &CaptureModel::setup_changed, this, &CaptureWorkspace::follow_state);
  connect(&context_.live(), &LiveModel::state_changed, this, &CaptureWorkspace::follow_state);
  connect(&context_.live(), &LiveModel::snapshot_changed, this, &CaptureWorkspace::follow_snapshot);
  connect(&context_.live(), &LiveModel::recording_finished, this, &CaptureWorkspace::announce);
  connect(&context_.selection(), &Selection::changed, this, [this] {
    const int sensor = context_.selection().index_of(SelectionKind::kSensor);
    scope_->set_selected_sensor(sensor);
    strips_->set_selected_sensor(sensor);
    wires_->set_selected(sensor);
  });
  connect(&context_.markers(), &MarkerModel::changed, this, &CaptureWorkspace::show_markers);
  connect(overview_, &OverviewPanel::rename_wanted, this, [this](std::int64_t number) {
    side_->ensureWidgetVisible(markers_);
    markers_->edit_name(number);
  });
  follow_state();
}

void CaptureWorkspace::show_markers() {
  const auto& snapshot = context_.live().snapshot();
  std::vector<SensorStrips::Mark> marks;
  if (snapshot && context_.markers().recording()) {
    const double start_s = snapshot->stream_time_s - snapshot->recorded_s;
    for (const Marker& marker : context_.markers().markers()) {
      marks.push_back({start_s + context_.markers().time_s(marker), marker.text});
    }
  }
  strips_->set_marks(std::move(marks));
}

void CaptureWorkspace::make_signals() {
  live_page_ = new QWidget(center_);
  auto* layout = new QVBoxLayout(live_page_);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* splitter = new QSplitter(Qt::Vertical, live_page_);
  splitter->setChildrenCollapsible(false);
  splitter->setHandleWidth(2 * kGrid);
  scope_ = new ScopeView(splitter);
  strips_ = new SensorStrips(splitter);
  splitter->addWidget(scope_);
  splitter->addWidget(strips_);
  splitter->setStretchFactor(0, 3);
  splitter->setStretchFactor(1, 4);
  layout->addWidget(splitter);
  center_->addWidget(live_page_);
  const auto select = [this](int sensor) {
    if (sensor >= 0) {
      context_.selection().select(SelectionKind::kSensor, sensor);
    } else {
      context_.selection().clear();
    }
  };
  auto* scroll = new QScrollArea(center_);
  box_page_ = scroll;
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  wires_ = new WireView(scroll);
  scroll->setWidget(wires_);
  center_->addWidget(box_page_);
  connect(wires_, &WireView::wire_clicked, this, select);
  connect(scope_, &ScopeView::sensor_clicked, this, select);
  connect(strips_, &SensorStrips::sensor_clicked, this, select);
}

void CaptureWorkspace::make_side() {
  side_ = new QScrollArea(this);
  side_->setWidgetResizable(true);
  side_->setFrameShape(QFrame::NoFrame);
  side_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  side_->setFixedWidth(43 * kGrid);
  auto* page = new QWidget(side_);
  page->setProperty("scroll", true);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 2 * kGrid, 0);
  layout->setSpacing(2 * kGrid);
  record_ = new RecordPanel(context_, model_, page);
  level_ = new LevelPanel(context_, page);
  box_ = new BoxPanel(context_, model_, page);
  layout->addWidget(record_);
  layout->addWidget(level_);
  layout->addWidget(box_);
  markers_ = new MarkerPanel(context_, page);
  layout->addWidget(markers_, 1);
  side_->setWidget(page);
}

void CaptureWorkspace::make_shortcuts() {
  const auto add = [this](int key, auto&& handler) {
    auto* shortcut = new QShortcut(QKeySequence(key), this);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    shortcut->setAutoRepeat(false);
    connect(shortcut, &QShortcut::activated, this, handler);
  };
  add(Qt::Key_F5, [this] { model_.refresh_devices(); });
}

std::vector<ShortcutHelp> CaptureWorkspace::shortcuts() {
  return {{QStringLiteral("F2"), tr("Rename the selected marker")},
          {tr("Delete"), tr("Delete the selected marker")},
          {tr("Shift+← / →"), tr("In the signal: move the selected marker by 10 ms, with Ctrl by 100 ms")},
          {QStringLiteral("F5"), tr("Look for devices again")}};
}

void CaptureWorkspace::activate() {
  setFocus();
  if (!searched_) {
    searched_ = true;
    model_.refresh_devices();
  }
}

void CaptureWorkspace::deactivate() {
  // Elsewhere nobody needs to be told how to get there.
  context_.notifications().dismiss(std::exchange(announced_, 0));
}

void CaptureWorkspace::follow_state() {
  const LiveModel& live = context_.live();
  if (scope_->property("names").toStringList() != model_.sensor_names()) {
    scope_->setProperty("names", model_.sensor_names());
    scope_->set_sensors(model_.sensor_names(), model_.slot_count());
    strips_->set_sensors(model_.sensor_names());
  }
  level_->setVisible(!model_.is_box());
  box_->setVisible(model_.is_box());
  if (live.running()) {
    center_->setCurrentWidget(model_.is_box() ? box_page_ : live_page_);
    return;
  }
  center_->setCurrentWidget(empty_);
  const auto simulators = std::count_if(model_.devices().begin(), model_.devices().end(), is_simulator);
  const bool simulator = simulators > 0;
  const bool others = static_cast<std::ptrdiff_t>(model_.devices().size()) > simulators;
  if (live.state() == LiveState::kOpening || model_.searching()) {
    empty_->set_texts(model_.searching() ? tr("Looking for devices") : tr("Opening %1").arg(live.device_title()), {});
  } else if (!live.problem().isEmpty()) {
    empty_->set_texts(tr("%1 cannot be opened").arg(live.device_title()),
                      live.problem() + QLatin1Char(' ') + live.remedy());
  } else if (!model_.search_problem().isEmpty()) {
    empty_->set_texts(tr("The sound system does not answer"), model_.search_problem());
  } else if (others) {
    empty_->set_texts(tr("Choose a device"),
                      tr("Choose above the line input that the board is plugged into, or the driver box. Levels and "
                         "signals show at once; nothing is recorded before you say so."));
  } else {
    empty_->set_texts(tr("No sound card with a stereo input was found"),
                      tr("Plug in a sound card with a stereo line input and look again. A microphone input is mono and "
                         "does not do. Without hardware, the simulator is a device as well."));
  }
  empty_refresh_->setVisible(!model_.searching() && live.state() == LiveState::kOff);
  empty_simulator_->setVisible(simulator && !model_.searching() && live.state() == LiveState::kOff);
}

void CaptureWorkspace::follow_snapshot() {
  const auto& snapshot = context_.live().snapshot();
  if (isVisible() || !snapshot) {
    wires_->set_snapshot(snapshot ? snapshot->box : nullptr);
  }
  if ((isVisible() && snapshot && !snapshot->box) || !snapshot) {
    scope_->set_snapshot(snapshot);
    strips_->set_snapshot(snapshot);
  }
}

void CaptureWorkspace::announce(const take::Take& take) {
  if (!isVisible()) {
    return;
  }
  const double seconds =
      take.info.format.rate.hz > 0.0 ? static_cast<double>(take.info.frames) / take.info.format.rate.hz : 0.0;
  announced_ = context_.notifications().post(
      Severity::kInfo,
      tr("%1 is recorded: %2.").arg(QString::fromStdString(take.folder.stem().string()), format_clock_tenths(seconds)),
      {}, tr("Solve it"), [this] { context_.reveal(QStringLiteral("solve")); });
}

void CaptureWorkspace::reveal(const QString& topic) {
  if (topic == QLatin1String("devices")) {
    source_->focus_devices();
  } else if (topic == QLatin1String("record") || topic == QLatin1String("disk")) {
    side_->ensureWidgetVisible(record_);
    record_->focus_record();
  } else if (topic == QLatin1String("line")) {
    side_->ensureWidgetVisible(model_.is_box() ? static_cast<QWidget*>(box_) : level_);
    (model_.is_box() ? static_cast<QWidget*>(wires_) : scope_)->setFocus();
  } else if (topic.startsWith(QLatin1String("sensor"))) {
    (model_.is_box() ? static_cast<QWidget*>(wires_) : strips_)->setFocus();
    bool ok = false;
    const int sensor = topic.section(QLatin1Char(':'), 1).toInt(&ok);
    if (ok) {
      context_.selection().select(SelectionKind::kSensor, sensor);
    }
  }
}

}  // namespace limbwave::ui
