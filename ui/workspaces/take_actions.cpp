#include "workspaces/take_actions.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include "common/format.h"
#include "common/motion_names.h"
#include "interchange/animation_file.h"
#include "workspaces/export/export_source_card.h"
#include "workspaces/import_sheet.h"
#include "workspaces/take_sheet.h"

namespace limbwave::ui {
namespace {

bool is_recording(const QFileInfo& info) {
  static const QStringList endings{QStringLiteral("wav"),  QStringLiteral("w64"), QStringLiteral("rf64"),
                                   QStringLiteral("flac"), QStringLiteral("mp3"), QStringLiteral("ogg"),
                                   QStringLiteral("aiff"), QStringLiteral("aif")};
  return info.isFile() && endings.contains(info.suffix().toLower());
}

bool is_take(const QFileInfo& info) {
  return info.isDir() && (info.suffix() == QLatin1String("take") || QFileInfo::exists(info.filePath() + "/take.json"));
}

}  // namespace

TakeActions::TakeActions(StudioContext& context, QWidget* window)
    : QObject(window), context_(context), window_(window) {}

void TakeActions::new_take() {
  if (!context_.live().recording()) {
    context_.document().close();
  }
  context_.reveal(QStringLiteral("capture"), QStringLiteral("devices"));
}

void TakeActions::choose_and_open() {
  const QString folder = QFileDialog::getExistingDirectory(window_, tr("Open a take (a folder that ends in .take)"),
                                                           context_.takes_folder());
  if (!folder.isEmpty()) {
    open(folder);
  }
}

void TakeActions::choose_and_open_animation() {
  const QString file =
      QFileDialog::getOpenFileName(window_, tr("Open an animation"), context_.takes_folder(), animation_filter());
  if (!file.isEmpty()) {
    open_animation(file);
  }
}

bool TakeActions::is_animation(const QString& file) {
  return QFileInfo(file).isFile() && interchange::is_animation_file(file.toStdString());
}

void TakeActions::open_animation(const QString& file) {
  context_.reveal(QStringLiteral("export"), QStringLiteral("animation:") + file);
}

void TakeActions::close() {
  if (context_.animation().isEmpty()) {
    context_.document().close();
  } else {
    context_.reveal(QStringLiteral("export"), QStringLiteral("close"));
  }
}

void TakeActions::choose_and_import() {
  const QStringList files = QFileDialog::getOpenFileNames(
      window_, tr("Import recordings of a sound recorder"), context_.takes_folder(),
      tr("Recordings (*.wav *.w64 *.rf64 *.flac *.aiff *.aif *.ogg *.mp3);;All files (*)"));
  if (!files.isEmpty()) {
    import_files(files);
  }
}

void TakeActions::open(const QString& folder) {
  if (context_.live().recording() || context_.live().starting() || context_.live().finishing()) {
    const bool aside = context_.live().aside();
    context_.notifications().post(Severity::kWarning,
                                  aside ? tr("A calibration is under way.") : tr("A take is being recorded."),
                                  aside ? tr("Finish or leave it before another take is opened.")
                                        : tr("Stop the recording before another take is opened."));
    return;
  }
  context_.document().open(folder);
}

void TakeActions::import_files(const QStringList& files) {
  if (files.isEmpty() || !context_.services().import_recording) {
    return;
  }
  auto* sheet = new ImportSheet(context_, files, window_);
  sheet->setAttribute(Qt::WA_DeleteOnClose);
  connect(sheet, &QDialog::accepted, this,
          [this, sheet, files] { import_as(files, sheet->take_name(), sheet->rig(), sheet->subject()); });
  sheet->open();
}

void TakeActions::import_as(const QStringList& files, const QString& name, const QString& rig, const QString& subject) {
  const QString folder = QDir(context_.takes_folder()).filePath(name + QStringLiteral(".take"));
  std::vector<std::filesystem::path> paths;
  for (const QString& file : files) {
    paths.emplace_back(file.toStdString());
  }
  const QString title = tr("Importing %1").arg(QFileInfo(files.first()).fileName());
  context_.jobs().start(
      title, this,
      [import_recording = context_.services().import_recording, folder, paths, rig, subject](const Progress& progress) {
        return import_recording(folder.toStdString(), paths, rig.toStdString(), subject.toStdString(), progress);
      },
      [this, title, folder](const Status& status) {
        if (!status) {
          context_.notifications().post_error(title, status.error());
          return;
        }
        open(folder);
      });
}

void TakeActions::edit_details() {
  if (context_.document().is_open()) {
    auto* sheet = new TakeSheet(context_, window_);
    sheet->setAttribute(Qt::WA_DeleteOnClose);
    sheet->open();
  }
}

void TakeActions::open_demo(const QString& motion) {
  const QString folder =
      QDir(context_.takes_folder()).filePath(QStringLiteral("demo-%1.take").arg(file_name_part(motion)));
  if (QFileInfo::exists(folder)) {
    open(folder);
    return;
  }
  if (!context_.services().simulate_take) {
    return;
  }
  const QString title = tr("Making the demo take \u201c%1\u201d").arg(motion_title(motion));
  context_.jobs().start(
      title, this,
      [simulate = context_.services().simulate_take, folder, motion](const Progress& progress) {
        return simulate(folder.toStdString(), motion.toStdString(), progress);
      },
      [this, title, folder](const Status& status) {
        if (!status) {
          context_.notifications().post_error(title, status.error());
          return;
        }
        open(folder);
      });
}

bool TakeActions::acceptable(const QList<QUrl>& urls) {
  for (const QUrl& url : urls) {
    const QFileInfo info(url.toLocalFile());
    if (url.isLocalFile() && (is_take(info) || is_recording(info) || is_animation(info.filePath()))) {
      return true;
    }
  }
  return false;
}

void TakeActions::handle_drop(const QList<QUrl>& urls) {
  QStringList recordings;
  QString take, animation;
  for (const QUrl& url : urls) {
    const QFileInfo info(url.toLocalFile());
    if (is_take(info)) {
      take = info.filePath();
    } else if (is_recording(info)) {
      recordings.append(info.filePath());
    } else if (is_animation(info.filePath())) {
      animation = info.filePath();
    }
  }
  if (!recordings.isEmpty()) {
    import_files(recordings);
  } else if (!take.isEmpty()) {
    open(take);
  } else if (!animation.isEmpty()) {
    open_animation(animation);
  }
}

}  // namespace limbwave::ui
