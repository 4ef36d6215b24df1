#include "workspaces/import_sheet.h"

#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLineEdit>
#include <QPushButton>

#include "common/format.h"
#include "common/shown_names.h"
#include "common/widgets.h"

namespace limbwave::ui {

QString import_name(const QString& takes_folder, const QString& file) {
  const QString stem = file_name_part(QFileInfo(file).completeBaseName());
  const QString wanted = stem.isEmpty() ? QStringLiteral("import") : stem;
  QString name = wanted;
  for (int n = 2; QFileInfo::exists(QDir(takes_folder).filePath(name + QStringLiteral(".take"))); ++n) {
    name = QStringLiteral("%1-%2").arg(wanted).arg(n);
  }
  return name;
}

namespace {

QString sentence(const QStringList& files) {
  QStringList names;
  for (const QString& file : files) {
    names << QFileInfo(file).fileName();
  }
  return files.size() == 1
             ? ImportSheet::tr("%1 becomes a take.").arg(names.first())
             : ImportSheet::tr("These become one take, in this order: %1").arg(names.join(ImportSheet::tr(", ")));
}

}  // namespace

ImportSheet::ImportSheet(StudioContext& context, const QStringList& files, QWidget* parent)
    : FormSheet(tr("Import recordings"), sentence(files), tr("Import"), parent),
      context_(context),
      rig_(new QComboBox(this)) {
  setObjectName(QStringLiteral("import_sheet"));
  name_ = add_line(tr("Take"), QStringLiteral("import_name"), import_name(context_.takes_folder(), files.first()), {});
  rig_->setObjectName(QStringLiteral("import_rig"));
  rig_->setToolTip(tr("What was worn where"));
  if (context_.services().list_rigs) {
    for (const RigChoice& rig : context_.services().list_rigs()) {
      if (rig.driver_box) {
        continue;  // recordings are a sound card's
      }
      rig_->addItem(shown_name(rig.title), QString::fromStdString(rig.name));
    }
  }
  const QString last =
      context_.settings().value(QStringLiteral("capture/rig"), QStringLiteral("line-in-arm")).toString();
  if (rig_->findData(last) < 0) {
    rig_->addItem(last, last);
  }
  rig_->setCurrentIndex(rig_->findData(last));
  add_row(tr("Rig"), rig_);
  subject_ = add_line(tr("Subject"), QStringLiteral("import_subject"), context_.wearer(), tr("Who wore the sensors"));
  subject_->setToolTip(tr("The mounting of this person in the calibration library is used"));
  QLabel* learn = link_label(tr("Learn how to record without a computer"), this);
  add_wide(learn);
  connect(learn, &QLabel::linkActivated, this,
          [this] { context_.reveal(QStringLiteral("manual"), QStringLiteral("recorder")); });
  verb()->setObjectName(QStringLiteral("import_button"));
  connect(name_, &QLineEdit::textChanged, this, &ImportSheet::check);
  check();
}

QString ImportSheet::take_name() const {
  return name_->text().trimmed();
}

QString ImportSheet::rig() const {
  return rig_->currentData().toString();
}

QString ImportSheet::subject() const {
  return subject_->text().trimmed();
}

void ImportSheet::check() {
  set_problem(take_name_problem(context_.takes_folder(), take_name()));
}

}  // namespace limbwave::ui
