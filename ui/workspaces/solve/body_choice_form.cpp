#include "workspaces/solve/body_choice_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>

#include "common/theme.h"
#include "common/widgets.h"
#include "solve/body_solve.h"

namespace limbwave::ui {
namespace {

QString method_hint(const QString& method) {
  if (method == QLatin1String("filter")) {
    return BodyChoiceForm::tr("By the past alone, as the live figure is solved.");
  }
  if (method == QLatin1String("batch")) {
    return BodyChoiceForm::tr("The smoother again and again, until nothing changes. Takes several times as long.");
  }
  return BodyChoiceForm::tr("All sensors together, forward and backward in time. The most exact for most takes.");
}

QString root_hint(const QString& root) {
  if (root == QLatin1String("contacts")) {
    return BodyChoiceForm::tr("Feet that stand hold the figure to the ground. For somebody who stands or walks.");
  }
  if (root == QLatin1String("fixed")) {
    return BodyChoiceForm::tr("The root stays where it is. For somebody who sits, or an arm alone.");
  }
  if (root == QLatin1String("free")) {
    return BodyChoiceForm::tr("By gravity and the sensors alone: the figure drifts away with time.");
  }
  if (root == QLatin1String("truth")) {
    return BodyChoiceForm::tr("As it was simulated. To compare joints alone.");
  }
  return BodyChoiceForm::tr("As the file tells.");
}

QComboBox* box(const QString& name, const QString& object, QWidget* parent) {
  auto* made = new QComboBox(parent);
  made->setAccessibleName(name);
  made->setObjectName(object);
  made->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  made->setMinimumContentsLength(10);
  return made;
}

QLabel* hint_label(QWidget* parent) {
  QLabel* label = dim_label({}, parent);
  label->setWordWrap(true);
  return label;
}

}  // namespace

BodyChoiceForm::BodyChoiceForm(SolveModel& model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      method_(box(tr("Method"), QStringLiteral("body_method"), this)),
      sensors_(box(tr("Sensors"), QStringLiteral("body_sensors"), this)),
      root_(box(tr("Root"), QStringLiteral("body_root"), this)),
      tune_(new QCheckBox(tr("Find noises from the take"), this)),
      method_hint_(hint_label(this)),
      root_hint_(hint_label(this)) {
  method_->addItem(tr("Both directions"), QStringLiteral("smoother"));
  method_->addItem(tr("Forward only"), QStringLiteral("filter"));
  method_->addItem(tr("Optimiser"), QStringLiteral("batch"));
  sensors_->addItem(tr("All"), QStringLiteral("AGD"));
  sensors_->addItem(tr("Accelerometers and gyroscopes"), QStringLiteral("AG"));
  sensors_->addItem(tr("Gyroscopes and ranges"), QStringLiteral("GD"));
  sensors_->addItem(tr("Accelerometers and ranges"), QStringLiteral("AD"));
  sensors_->addItem(tr("Accelerometers"), QStringLiteral("A"));
  sensors_->addItem(tr("Gyroscopes"), QStringLiteral("G"));
  sensors_->addItem(tr("Ranges"), QStringLiteral("D"));
  tune_->setObjectName(QStringLiteral("body_tune"));
  tune_->setToolTip(
      tr("For sensors that nobody has measured: how noisy they are, and how lively the wearer is, from the "
         "first seconds. Errors that are not noise deceive it."));

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(kGrid);
  grid->setVerticalSpacing(kGrid);
  grid->setColumnStretch(1, 1);
  int row = 0;
  const auto add = [&](QComboBox* field, QLabel* hint) {
    auto* label = dim_label(field->accessibleName(), this);
    label->setBuddy(field);
    grid->addWidget(label, row, 0);
    grid->addWidget(field, row++, 1);
    if (hint != nullptr) {
      grid->addWidget(hint, row++, 0, 1, 2);
    }
  };
  add(method_, method_hint_);
  add(sensors_, nullptr);
  add(root_, root_hint_);
  grid->addWidget(tune_, row, 0, 1, 2);

  const auto text = [](const QComboBox* field) { return field->currentData().toString().toStdString(); };
  connect(method_, &QComboBox::activated, this, [this, text] {
    change([&](solve::BodyChoice& choice) { choice.method = text(method_); }, tr("change method"));
  });
  connect(sensors_, &QComboBox::activated, this, [this, text] {
    change([&](solve::BodyChoice& choice) { choice.sensors = text(sensors_); }, tr("change sensors to solve with"));
  });
  connect(root_, &QComboBox::activated, this,
          [this, text] { change([&](solve::BodyChoice& choice) { choice.root = text(root_); }, tr("change root")); });
  connect(tune_, &QCheckBox::clicked, this, [this](bool on) {
    change([&](solve::BodyChoice& choice) { choice.tune = on; }, tr("change finding of noises"));
  });
}

void BodyChoiceForm::change(const std::function<void(solve::BodyChoice&)>& edit, const QString& what) {
  solve::SolveSettings settings = model_.settings();
  const solve::BodyChoice before = model_.body_choice();
  solve::BodyChoice after = before;
  edit(after);
  if (!(after == before)) {
    settings.body = after;
    model_.change_settings(settings, what);
  }
}

void BodyChoiceForm::fill_roots(const solve::BodyChoice& choice) {
  root_->clear();
  root_->addItem(tr("Feet on the ground"), QStringLiteral("contacts"));
  root_->addItem(tr("Free"), QStringLiteral("free"));
  root_->addItem(tr("Fixed"), QStringLiteral("fixed"));
  if (model_.has_truth()) {
    root_->addItem(tr("Of the truth"), QStringLiteral("truth"));
  }
  const QString current = QString::fromStdString(choice.root);
  if (root_->findData(current) < 0) {
    root_->addItem(current, current);  // A file, from the command line.
  }
  root_->setCurrentIndex(root_->findData(current));
}

void BodyChoiceForm::refresh() {
  const solve::BodyChoice choice = model_.body_choice();
  method_->setCurrentIndex(method_->findData(QString::fromStdString(choice.method)));
  sensors_->setCurrentIndex(sensors_->findData(QString::fromStdString(choice.sensors)));
  fill_roots(choice);
  tune_->setChecked(choice.tune);
  method_hint_->setText(method_hint(method_->currentData().toString()));
  root_hint_->setText(root_hint(root_->currentData().toString()));
}

}  // namespace limbwave::ui
