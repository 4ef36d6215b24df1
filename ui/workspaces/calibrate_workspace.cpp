#include "workspaces/calibrate_workspace.h"

#include <QVBoxLayout>
#include <utility>

#include "workspaces/calibrate_history.h"
#include "workspaces/solve/solve_model.h"

namespace limbwave::ui {

CalibrateWorkspace::CalibrateWorkspace(StudioContext& context, take::CalibrationLibrary library,
                                       std::unique_ptr<CalibrationSource> source, QWidget* parent)
    : Workspace(parent),
      context_(context),
      source_(source ? std::move(source) : std::make_unique<LiveCalibrationSource>(context.live())),
      desk_(std::make_unique<CalibrationDesk>(context, *source_, std::move(library))),
      range_model_(std::make_unique<RangeWizardModel>(*desk_)),
      limb_model_(std::make_unique<LimbWizardModel>(*desk_)),
      stretch_model_(std::make_unique<StretchModel>(*desk_)),
      pages_(new QStackedWidget(this)),
      empty_(new EmptyState(QStringLiteral("calibrate"), pages_)),
      overview_(new CalibrateOverview(*desk_, pages_)),
      range_wizard_(new RangeWizard(*range_model_, pages_)),
      limb_wizard_(new LimbWizard(*limb_model_, pages_)),
      stretch_page_(new StretchPage(*stretch_model_, pages_)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(pages_);
  QPushButton* device = empty_->add_button(tr("Open a device in Capture"), true);
  device->setObjectName(QStringLiteral("open_device"));
  const auto go_to_devices = [this] { context_.reveal(QStringLiteral("capture"), QStringLiteral("devices")); };
  connect(device, &QPushButton::clicked, this, go_to_devices);
  connect(empty_->add_link(tr("Learn how sensors are calibrated")), &QLabel::linkActivated, this,
          [this] { context_.reveal(QStringLiteral("manual"), QStringLiteral("range")); });
  QPushButton* recording = empty_->add_button(tr("Calibrate from a recording"), false);
  recording->setObjectName(QStringLiteral("empty_from_take"));
  connect(recording, &QPushButton::clicked, this, &CalibrateWorkspace::start_stretch);
  for (QWidget* page : std::initializer_list<QWidget*>{empty_, overview_, range_wizard_, limb_wizard_, stretch_page_}) {
    pages_->addWidget(page);
  }
  connect(desk_.get(), &CalibrationDesk::changed, this, [this] {
    if (pages_->currentWidget() == empty_ || pages_->currentWidget() == overview_) {
      show_overview();
    }
  });
  connect(overview_, &CalibrateOverview::range_wanted, this, &CalibrateWorkspace::start_range);
  connect(overview_, &CalibrateOverview::mount_wanted, this, &CalibrateWorkspace::start_limb);
  connect(overview_, &CalibrateOverview::recording_wanted, this, &CalibrateWorkspace::start_stretch);
  connect(range_wizard_, &RangeWizard::device_wanted, this, go_to_devices);
  connect(limb_wizard_, &LimbWizard::device_wanted, this, go_to_devices);
  connect(limb_wizard_, &LimbWizard::range_wanted, this, &CalibrateWorkspace::start_range);
  for (WizardModel* model : std::initializer_list<WizardModel*>{range_model_.get(), limb_model_.get()}) {
    connect(model, &WizardModel::left, this, &CalibrateWorkspace::leave_wizard);
  }
  connect(range_model_.get(), &WizardModel::saved, this,
          [this](int count) { tell_saved(count, tr("Range calibration"), *range_model_); });
  connect(limb_model_.get(), &WizardModel::saved, this,
          [this](int count) { tell_saved(count, tr("Mounting calibration"), *limb_model_); });
  connect(stretch_page_, &StretchPage::left, this, &CalibrateWorkspace::show_overview);
  connect(stretch_model_.get(), &StretchModel::range_found, this, [this](const std::vector<RangeOutcome>& outcomes) {
    pages_->setCurrentWidget(range_wizard_);
    range_model_->show_outcomes(outcomes, stretch_model_->target());
  });
  connect(stretch_model_.get(), &StretchModel::limb_found, this, [this](const LimbFromTake& found) {
    pages_->setCurrentWidget(limb_wizard_);
    limb_model_->show_outcomes(found.group, found.outcomes, found.refusal, stretch_model_->target());
  });
  connect(stretch_model_.get(), &StretchModel::failed, this, [this](const Error& error) {
    context_.notifications().post_error(tr("Calibration from a recording"), error);
  });
  SolveModel& solving = SolveModel::of(context_);
  const auto follow_solve = [this, &solving] {
    overview_->set_used(solving.solve() ? solving.solve()->report.used_calibration : std::nullopt);
  };
  connect(&solving, &SolveModel::solve_changed, this, follow_solve);
  follow_solve();
  show_overview();
}

CalibrateWorkspace::~CalibrateWorkspace() {
  // Pages look at the models until they are gone.
  delete pages_;
}

void CalibrateWorkspace::activate() {
  desk_->refresh();
}

QWidget* CalibrateWorkspace::create_inspector() {
  auto* history = new CalibrateHistory(*desk_);
  // The window owns it from now on and may keep it longer than the desk that it
  // shows.
  connect(this, &QObject::destroyed, history, &QObject::deleteLater);
  return history;
}

void CalibrateWorkspace::reveal(const QString& topic) {
  if (topic == QLatin1String("range")) {
    start_range({});
  } else if (topic == QLatin1String("mounting")) {
    start_limb(-1, false);
  } else if (topic == QLatin1String("recording")) {
    start_stretch();
  } else if (topic.startsWith(QLatin1String("sensor:"))) {
    context_.selection().select(SelectionKind::kSensor, topic.mid(7).toInt());
  }
}

void CalibrateWorkspace::show_overview() {
  overview_->refresh();
  // The wizards are for boards on a sound card.
  const bool by_filter =
      desk_->subject() == CalibrationDesk::Subject::kTake && !SolveModel::of(context_).by_inclination();
  if (by_filter) {
    empty_->set_texts(tr("This take needs no calibration by hand"),
                      tr("The body filter estimates offsets, mountings and lengths while it solves. Begin takes with a "
                         "second of standing still in the rest pose."));
  } else {
    empty_->set_texts(tr("Nothing to calibrate yet"), tr("Open a device in Capture to calibrate its sensors, or open a "
                                                         "take to look at its calibration and compute it anew."));
  }
  pages_->setCurrentWidget(desk_->has_rig() && !by_filter ? static_cast<QWidget*>(overview_) : empty_);
}

void CalibrateWorkspace::start_range(const std::vector<int>& sensors) {
  if (desk_->has_rig()) {
    pages_->setCurrentWidget(range_wizard_);
    range_model_->begin(sensors);
  }
}

void CalibrateWorkspace::start_limb(int sensor, bool only) {
  if (desk_->has_rig()) {
    pages_->setCurrentWidget(limb_wizard_);
    limb_model_->begin(sensor, only);
  }
}

void CalibrateWorkspace::start_stretch() {
  pages_->setCurrentWidget(stretch_page_);
  stretch_model_->begin();
  stretch_page_->setFocus();
}

void CalibrateWorkspace::leave_wizard() {
  // Verdicts that were thrown away lead back to the stretch that they came
  // from: another one may be better.
  const auto* wizard = dynamic_cast<CalibrationWizard*>(pages_->currentWidget());
  const WizardModel* model = wizard == limb_wizard_ ? static_cast<WizardModel*>(limb_model_.get()) : range_model_.get();
  if (wizard != nullptr && model->from_take() && !std::exchange(just_saved_, false)) {
    pages_->setCurrentWidget(stretch_page_);
  } else {
    show_overview();
  }
}

void CalibrateWorkspace::tell_saved(int count, const QString& what, const WizardModel& model) {
  just_saved_ = model.from_take();
  if (!desk_->is_current(model.target())) {
    return;  // The desk has told that it is in the library alone.
  }
  const QString where = model.from_take() || desk_->recording_folder().empty() ? QString() : desk_->recording_note();
  context_.notifications().post(Severity::kInfo, tr("%1 of %2 is saved and in use.").arg(what, counted_sensors(count)),
                                where);
}

WorkspaceEntry calibrate_entry() {
  WorkspaceEntry entry;
  entry.id = QStringLiteral("calibrate");
  entry.title = CalibrateWorkspace::tr("Calibrate");
  entry.hint = CalibrateWorkspace::tr("Find each sensor's zero and scale, and how it sits on its limb");
  entry.icon = QStringLiteral("calibrate");
  entry.shortcuts = {{CalibrateWorkspace::tr("Enter"), CalibrateWorkspace::tr("Next step of a calibration")},
                     {CalibrateWorkspace::tr("Esc"), CalibrateWorkspace::tr("Leave a calibration, asking first")}};
  entry.create = [](StudioContext& context, QWidget* parent) {
    return new CalibrateWorkspace(context, take::CalibrationLibrary(), nullptr, parent);
  };
  return entry;
}

}  // namespace limbwave::ui
