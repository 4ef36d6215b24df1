/// limbwave-studio: the desktop program.
#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QLibraryInfo>
#include <QLocale>
#include <QTimer>
#include <QTranslator>
#include <cstdio>

#include "base/files.h"
#include "common/core_services.h"
#include "common/studio_context.h"
#include "common/theme.h"
#include "pictures.h"
#include "workspaces/main_window.h"
#include "workspaces/studio_application.h"
#include "workspaces/take_actions.h"
#include "workspaces/workspace.h"

namespace {

void install_translations(QApplication& application) {
  static QTranslator english, ours, qt;
  const QLocale locale;
  // Plurals, also where there is no translation; what is installed later is asked first.
  if (english.load(QStringLiteral(":/translations/limbwave_en.qm"))) {
    QApplication::installTranslator(&english);
  }
  if (qt.load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
              QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
    QApplication::installTranslator(&qt);
  }
  if (ours.load(locale, QStringLiteral("limbwave"), QStringLiteral("_"), QStringLiteral(":/translations"))) {
    QApplication::installTranslator(&ours);
  }
  Q_UNUSED(application);
}

}  // namespace

int main(int argc, char** argv) {
  limbwave::ui::StudioApplication application(argc, argv);
  QApplication::setApplicationName(QStringLiteral("limbwave-studio"));
  QApplication::setApplicationDisplayName(QStringLiteral("Limbwave"));
  QApplication::setApplicationVersion(QStringLiteral(LIMBWAVE_VERSION));
  QApplication::setDesktopFileName(QStringLiteral("limbwave-studio"));
  install_translations(application);

  QCommandLineParser parser;
  parser.setApplicationDescription(
      QApplication::translate("main", "Records wearable motion sensors and turns them into animation."));
  parser.addHelpOption();
  parser.addVersionOption();
  const QCommandLineOption demo(QStringLiteral("demo"),
                                QApplication::translate("main", "Open a demo take of the simulator."));
  const QCommandLineOption theme(QStringLiteral("theme"), QApplication::translate("main", "Colours: dark or light."),
                                 QStringLiteral("dark|light"));
  const QCommandLineOption pictures(
      QStringLiteral("pictures"),
      QApplication::translate("main", "Write pictures of the solved TAKE into this folder and end; needs no display."),
      QStringLiteral("folder"));
  parser.addOptions({demo, theme, pictures});
  parser.addPositionalArgument(
      QStringLiteral("TAKE"),
      QApplication::translate("main", "Take folder or animation to open, or recordings to import."),
      QStringLiteral("[TAKE]"));
  parser.process(application);
  const QStringList arguments = parser.positionalArguments();

  if (parser.isSet(pictures)) {
    const limbwave::Status written =
        arguments.size() == 1
            ? limbwave::studio::write_pictures(parser.value(pictures).toStdString(), arguments.first().toStdString())
            : limbwave::Status(limbwave::Error{"--pictures needs one TAKE", "", ""});
    if (!written) {
      std::fprintf(stderr, "limbwave-studio: %s\n", written.error().text().c_str());
      return 1;
    }
    return 0;
  }

  limbwave::ui::StudioContext context(limbwave::ui::core_services(),
                                      QString::fromStdString(limbwave::user_data_folder().string()));
  application.set_notifications(&context.notifications());
  QString colours = parser.value(theme);
  if (colours.isEmpty()) {
    colours = context.settings().value(QStringLiteral("theme")).toString();
  }
  apply_theme(application,
              colours == QLatin1String("light") ? limbwave::ui::ThemeKind::kLight : limbwave::ui::ThemeKind::kDark);
  limbwave::ui::MainWindow window(context, limbwave::ui::studio_parts());
  window.show();

  QTimer::singleShot(0, &window, [&] {
    if (parser.isSet(demo)) {
      const auto motions =
          context.services().demo_motions ? context.services().demo_motions() : std::vector<std::string>();
      if (!motions.empty()) {
        window.take_actions().open_demo(QString::fromStdString(motions.front()));
      }
    } else if (!arguments.isEmpty()) {
      if (QFileInfo(arguments.first()).isDir()) {
        window.take_actions().open(arguments.first());
      } else if (limbwave::ui::TakeActions::is_animation(arguments.first())) {
        window.take_actions().open_animation(arguments.first());
      } else {
        window.take_actions().import_files(arguments);
      }
    }
  });
  return QApplication::exec();
}
