#include "calibration/stretch_page.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLocale>
#include <QMenu>
#include <QShortcut>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "calibration/calibration_words.h"
#include "common/format.h"
#include "common/theme.h"

namespace limbwave::ui {
namespace {

// Entries of the box of named stretches before the named ones.
constexpr int kOwn = 0, kAll = 1, kFirstNamed = 2;

}  // namespace

StretchPage::StretchPage(StretchModel& model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      take_(new ElidedLabel({}, this)),
      other_take_(new QPushButton(tr("Other take"), this)),
      takes_(new QMenu(other_take_)),
      procedure_(new QComboBox(this)),
      sensor_(new QComboBox(this)),
      plot_(new StretchPlot(this)),
      obstacle_(dim_label({}, this)),
      compute_(new QPushButton(tr("Show the verdict"), this)) {
  setObjectName(QStringLiteral("stretch_page"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(3 * kGrid, 2 * kGrid, 3 * kGrid, 2 * kGrid);
  layout->setSpacing(2 * kGrid);
  auto* heading = new QLabel(tr("Calibrate from a recording"), this);
  heading->setStyleSheet(QStringLiteral("font-size: 20px;"));
  layout->addWidget(heading);
  layout->addWidget(make_head());
  layout->addWidget(plot_, 1);
  for (int i = 0; i < 2; ++i) {
    rows_.at(static_cast<std::size_t>(i)) = make_row(i);
    layout->addWidget(rows_.at(static_cast<std::size_t>(i)).widget);
  }
  auto* footer = new QHBoxLayout;
  footer->setSpacing(kGrid);
  obstacle_->setWordWrap(true);
  obstacle_->setObjectName(QStringLiteral("stretch_obstacle"));
  footer->addWidget(obstacle_, 1);
  auto* back = new QPushButton(tr("Cancel"), this);
  back->setObjectName(QStringLiteral("stretch_cancel"));
  back->setToolTip(tr("Esc"));
  footer->addWidget(back);
  compute_->setObjectName(QStringLiteral("stretch_compute"));
  compute_->setProperty("primary", true);
  footer->addWidget(compute_);
  layout->addLayout(footer);

  connect(back, &QPushButton::clicked, this, &StretchPage::left);
  auto* escape = new QShortcut(QKeySequence(Qt::Key_Escape), this);
  escape->setContext(Qt::WidgetWithChildrenShortcut);
  connect(escape, &QShortcut::activated, this, &StretchPage::left);
  connect(compute_, &QPushButton::clicked, &model_, &StretchModel::compute);
  connect(plot_, &StretchPlot::drag_begun, this, [this] { gesture_ = model_.begin_gesture(); });
  connect(plot_, &StretchPlot::stretch_dragged, this, [this](int i, const Stretch& stretch) {
    active_ = i;
    model_.set_stretch(i, stretch, gesture_);
  });
  connect(plot_, &StretchPlot::named_clicked, this, &StretchPage::use_named);
  connect(&model_, &StretchModel::changed, this, &StretchPage::refresh);
  connect(&model_, &StretchModel::stretch_changed, this, &StretchPage::refresh_stretches);
  refresh();
}

QWidget* StretchPage::make_head() {
  auto* head = new QWidget(this);
  auto* layout = new QHBoxLayout(head);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  take_->setObjectName(QStringLiteral("stretch_take"));
  layout->addWidget(dim_label(tr("Take"), head));
  layout->addWidget(take_, 1);
  other_take_->setObjectName(QStringLiteral("stretch_other_take"));
  other_take_->setMenu(takes_);
  connect(takes_, &QMenu::aboutToShow, this, &StretchPage::fill_takes);
  layout->addWidget(other_take_);
  layout->addSpacing(2 * kGrid);
  auto* what = dim_label(tr("&Movement"), head);
  what->setBuddy(procedure_);
  procedure_->setObjectName(QStringLiteral("stretch_procedure"));
  procedure_->setAccessibleName(tr("Movement"));
  procedure_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  layout->addWidget(what);
  layout->addWidget(procedure_);
  layout->addSpacing(2 * kGrid);
  auto* which = dim_label(tr("&Shown sensor"), head);
  which->setBuddy(sensor_);
  sensor_->setObjectName(QStringLiteral("stretch_sensor"));
  sensor_->setAccessibleName(tr("Shown sensor"));
  sensor_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  layout->addWidget(which);
  layout->addWidget(sensor_);
  connect(procedure_, &QComboBox::activated, this, [this](int entry) { model_.set_procedure(entry - 1); });
  connect(sensor_, &QComboBox::currentIndexChanged, plot_, &StretchPlot::set_sensor);
  return head;
}

StretchPage::Row StretchPage::make_row(int i) {
  Row row{};
  row.widget = new QWidget(this);
  auto* layout = new QHBoxLayout(row.widget);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  row.title = new QLabel(row.widget);
  row.title->setMinimumWidth(20 * kGrid);
  row.named = new QComboBox(row.widget);
  row.named->setObjectName(QStringLiteral("stretch_named_%1").arg(i));
  row.named->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  const auto field = [&](const QString& name, const QString& object) {
    auto* box = new QDoubleSpinBox(row.widget);
    box->setDecimals(2);
    box->setSingleStep(0.1);
    box->setSuffix(tr(" s"));
    box->setAccessibleName(name);
    box->setObjectName(object.arg(i));
    box->setMinimumWidth(13 * kGrid);
    // A number that is still being typed must not jump.
    box->setKeyboardTracking(false);
    return box;
  };
  row.begin = field(tr("Begin"), QStringLiteral("stretch_begin_%1"));
  row.end = field(tr("End"), QStringLiteral("stretch_end_%1"));
  row.length = dim_label({}, row.widget);
  row.visible = new QPushButton(tr("Take what is visible"), row.widget);
  row.visible->setObjectName(QStringLiteral("stretch_visible_%1").arg(i));
  layout->addWidget(row.title);
  layout->addWidget(row.named);
  layout->addSpacing(kGrid);
  layout->addWidget(dim_label(tr("from"), row.widget));
  layout->addWidget(row.begin);
  layout->addWidget(dim_label(tr("to"), row.widget));
  layout->addWidget(row.end);
  layout->addWidget(row.length);
  layout->addStretch();
  layout->addWidget(row.visible);
  connect(row.named, &QComboBox::activated, this, [this, i](int entry) { choose_named(i, entry); });
  const auto edited = [this, i] {
    const Row& own = rows_.at(static_cast<std::size_t>(i));
    active_ = i;
    model_.set_stretch(i, {own.begin->value(), own.end->value()});
  };
  connect(row.begin, &QDoubleSpinBox::valueChanged, this, edited);
  connect(row.end, &QDoubleSpinBox::valueChanged, this, edited);
  connect(row.visible, &QPushButton::clicked, this, [this, i] {
    active_ = i;
    model_.set_stretch(i, plot_->visible());
  });
  return row;
}

void StretchPage::fill_takes() {
  takes_->clear();
  StudioContext& context = model_.desk().context();
  const QString open = model_.take() ? QString::fromStdString(model_.take()->folder.string()) : QString();
  for (const QString& folder : context.recent_takes().folders()) {
    if (folder == open || !QFileInfo::exists(folder)) {
      continue;
    }
    QString name = QFileInfo(folder).completeBaseName();
    QAction* action = takes_->addAction(name.replace(QLatin1Char('&'), QLatin1String("&&")));
    action->setToolTip(folder);
    connect(action, &QAction::triggered, this, [&context, folder] { context.document().open(folder); });
  }
  if (!takes_->isEmpty()) {
    takes_->addSeparator();
  }
  takes_->addAction(tr("Browse…"), this, &StretchPage::browse);
}

void StretchPage::browse() {
  StudioContext& context = model_.desk().context();
  const QString folder = QFileDialog::getExistingDirectory(window(), tr("Choose a take"), context.takes_folder());
  if (!folder.isEmpty()) {
    context.document().open(folder);
  }
}

void StretchPage::refresh() {
  const auto& take = model_.take();
  take_->set_text(
      take ? QStringLiteral("%1  ·  %2")
                 .arg(QString::fromStdString(take->folder.stem().string()), format_clock_tenths(model_.duration_s()))
           : tr("none"));
  take_->setToolTip(take ? QString::fromStdString(take->folder.string()) : QString());
  const QSignalBlocker block_procedure(procedure_);
  procedure_->clear();
  procedure_->addItem(tr("Range: sensors are turned"));
  int shown = std::max(0, sensor_->currentIndex());
  if (take && model_.procedure() >= 0) {
    // A sensor that the movement is not of shows nothing of it.
    const std::vector<int>& members = take->info.rig.groups.at(static_cast<std::size_t>(model_.procedure())).sensors;
    if (!members.empty() && std::find(members.begin(), members.end(), shown) == members.end()) {
      shown = members.front();
    }
  }
  {
    const QSignalBlocker block_sensor(sensor_);
    sensor_->clear();
    if (take) {
      for (const body::CalibrationGroup& group : take->info.rig.groups) {
        procedure_->addItem(tr("Mounting: two poses of %1").arg(QString::fromStdString(group.name)));
      }
      for (const body::Accelerometer& sensor : take->info.rig.accelerometers) {
        sensor_->addItem(QString::fromStdString(sensor.name));
      }
    }
    sensor_->setCurrentIndex(std::min(shown, sensor_->count() - 1));
  }
  procedure_->setCurrentIndex(model_.procedure() + 1);
  procedure_->setEnabled(take != nullptr);
  sensor_->setEnabled(take != nullptr);
  active_ = std::min(active_, model_.count() - 1);
  plot_->set_take(take, model_.decoded(),
                  !take               ? tr("Open a take: its signals appear here.")
                  : model_.decoding() ? tr("Reading the signals…")
                                      : model_.problem());
  plot_->set_sensor(std::max(0, sensor_->currentIndex()));
  plot_->set_named(take ? named_stretches(take->info, {}) : std::vector<NamedStretch>{});
  refresh_stretches();
}

void StretchPage::refresh_stretches() {
  std::vector<StretchPlot::Chosen> chosen;
  for (int i = 0; i < 2; ++i) {
    const bool used = model_.take() && i < model_.count();
    rows_.at(static_cast<std::size_t>(i)).widget->setVisible(used);
    if (used) {
      chosen.push_back({model_.title(i), model_.stretch(i)});
      refresh_row(i);
    }
  }
  plot_->set_chosen(std::move(chosen));
  const QString obstacle = model_.obstacle();
  obstacle_->setText(
      obstacle.isEmpty()
          ? tr("The same procedure as with a running capture. Nothing is saved before you have seen the verdict.")
          : obstacle);
  compute_->setEnabled(obstacle.isEmpty());
  compute_->setToolTip(obstacle);
}

void StretchPage::refresh_row(int i) {
  const Row& row = rows_.at(static_cast<std::size_t>(i));
  const Stretch& stretch = model_.stretch(i);
  row.title->setText(model_.title(i));
  const QSignalBlocker block_named(row.named), block_begin(row.begin), block_end(row.end);
  row.named->clear();
  row.named->addItem(tr("Own choice"));
  row.named->addItem(tr("The whole take"));
  int current = stretch.begin_s <= 0.0 && stretch.end_s >= model_.duration_s() ? kAll : kOwn;
  for (const NamedStretch& named : model_.suggestions(i)) {
    row.named->addItem(named.title);
    if (named.stretch == stretch) {
      current = row.named->count() - 1;
    }
  }
  row.named->setCurrentIndex(current);
  for (QDoubleSpinBox* box : {row.begin, row.end}) {
    box->setRange(0.0, std::max(0.0, model_.duration_s()));
  }
  row.begin->setValue(stretch.begin_s);
  row.end->setValue(stretch.end_s);
  row.length->setText(tr("%1 s long").arg(QLocale().toString(stretch.seconds(), 'f', 1)));
}

void StretchPage::choose_named(int i, int entry) {
  active_ = i;
  if (entry == kAll) {
    model_.set_stretch(i, {0.0, model_.duration_s()});
  } else if (entry >= kFirstNamed) {
    const std::vector<NamedStretch> named = model_.suggestions(i);
    model_.set_stretch(i, named.at(static_cast<std::size_t>(entry - kFirstNamed)).stretch);
  }
  refresh_stretches();
}

void StretchPage::use_named(int named) {
  if (!model_.take()) {
    return;
  }
  const std::vector<NamedStretch> all = named_stretches(model_.take()->info, {});
  if (named < static_cast<int>(all.size())) {
    model_.set_stretch(active_, all[static_cast<std::size_t>(named)].stretch);
    active_ = (active_ + 1) % model_.count();  // The next click is for the other pose.
  }
}

}  // namespace limbwave::ui
