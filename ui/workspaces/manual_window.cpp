#include "workspaces/manual_window.h"

#include <QEvent>
#include <QFile>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QListWidget>
#include <QPainter>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollBar>
#include <QSvgRenderer>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextTable>
#include <algorithm>
#include <array>

#include "common/theme.h"

// Resources of a static library are linked only when asked for; the macro must stand outside any namespace.
static void init_manual_resources() {
  Q_INIT_RESOURCE(manual);
}

namespace limbwave::ui {
namespace {

constexpr auto kKeys = "keys";

struct Chapter {
  const char* name;
  const char* title;
};
constexpr std::array<Chapter, 10> kChapters{{{"overview", QT_TRANSLATE_NOOP("Manual", "From sensors to an animation")},
                                             {"wiring", QT_TRANSLATE_NOOP("Manual", "Wiring and the signal")},
                                             {"levels", QT_TRANSLATE_NOOP("Manual", "Levels")},
                                             {"range", QT_TRANSLATE_NOOP("Manual", "Calibrating the range")},
                                             {"mounting", QT_TRANSLATE_NOOP("Manual", "Calibrating the mounting")},
                                             {"recording", QT_TRANSLATE_NOOP("Manual", "Recording alone")},
                                             {"recorder", QT_TRANSLATE_NOOP("Manual", "With a portable recorder")},
                                             {"driver-box", QT_TRANSLATE_NOOP("Manual", "The driver box")},
                                             {"exporting", QT_TRANSLATE_NOOP("Manual", "Solving and exporting")},
                                             {kKeys, QT_TRANSLATE_NOOP("Manual", "Keys")}}};

QString title_of(const Chapter& chapter) {
  return QCoreApplication::translate("Manual", chapter.title);
}

QString read_chapter(const QString& name) {
  static const bool initialised = (init_manual_resources(), true);
  Q_UNUSED(initialised);
  // Folders of other languages are named by their translations; what they lack is read in English.
  //: Folder of resources/manual that holds the chapters in your language: its code, "de". Without one leave it as it
  //: is.
  const QString language = QCoreApplication::translate("Manual", "en", "language of the manual");
  for (const QString& path :
       {QStringLiteral(":/manual/%1/%2.md").arg(language, name), QStringLiteral(":/manual/%1.md").arg(name)}) {
    if (QFile file(path); file.open(QIODevice::ReadOnly)) {
      return QString::fromUtf8(file.readAll());
    }
  }
  return {};
}

// The words in the pictures; they stand there in English.
[[maybe_unused]] constexpr std::array kPictureWords{
    QT_TRANSLATE_NOOP("ManualPicture", "too low"),
    QT_TRANSLATE_NOOP("ManualPicture", "noise is as large as the signal"),
    QT_TRANSLATE_NOOP("ManualPicture", "good"),
    QT_TRANSLATE_NOOP("ManualPicture", "peaks stay in the green zone"),
    QT_TRANSLATE_NOOP("ManualPicture", "too high"),
    QT_TRANSLATE_NOOP("ManualPicture", "peaks are cut off"),
    QT_TRANSLATE_NOOP("ManualPicture", "1  horizontal: forward, level, palm down"),
    QT_TRANSLATE_NOOP("ManualPicture", "2  vertical: hanging, palm to the rear"),
    QT_TRANSLATE_NOOP("ManualPicture", "left"),
    QT_TRANSLATE_NOOP("ManualPicture", "right"),
    QT_TRANSLATE_NOOP("ManualPicture", "sensor 1: x y z"),
    QT_TRANSLATE_NOOP("ManualPicture", "sensor 2: x y z"),
    QT_TRANSLATE_NOOP("ManualPicture", "sensor 3: x y z"),
    QT_TRANSLATE_NOOP("ManualPicture", "sensor 4: x y z"),
    QT_TRANSLATE_NOOP("ManualPicture", "sensor 5: x y z"),
    QT_TRANSLATE_NOOP("ManualPicture", "ref."),
    QT_TRANSLATE_NOOP("ManualPicture", "low"),
    QT_TRANSLATE_NOOP("ManualPicture", "high"),
    QT_TRANSLATE_NOOP("ManualPicture",
                      "every face looks up once, then edges and corners: slowly, about ten seconds for a full turn"),
    QT_TRANSLATE_NOOP("ManualPicture", "sensors"),
    QT_TRANSLATE_NOOP("ManualPicture", "five, worn"),
    QT_TRANSLATE_NOOP("ManualPicture", "line input"),
    QT_TRANSLATE_NOOP("ManualPicture", "stereo, 44.1 kHz or more"),
    QT_TRANSLATE_NOOP("ManualPicture", "take"),
    QT_TRANSLATE_NOOP("ManualPicture", "raw samples, kept"),
    QT_TRANSLATE_NOOP("ManualPicture", "solve"),
    QT_TRANSLATE_NOOP("ManualPicture", "skeleton, keys"),
    QT_TRANSLATE_NOOP("ManualPicture", "export"),
    QT_TRANSLATE_NOOP("ManualPicture", "FBX, BVH, glTF, CSV")};

QString keys_chapter(const std::vector<ShortcutGroup>& groups) {
  const auto cell = [](QString text) { return text.replace(QLatin1Char('|'), QLatin1String("\\|")); };
  QString text = QStringLiteral("# %1\n\n").arg(QCoreApplication::translate("Manual", "Keys"));
  for (const ShortcutGroup& group : groups) {
    text += QStringLiteral("## %1\n\n| | |\n| --- | --- |\n").arg(group.title);
    for (const ShortcutHelp& shortcut : group.shortcuts) {
      text += QStringLiteral("| **%1** | %2 |\n").arg(cell(shortcut.keys), cell(shortcut.what));
    }
    text += QLatin1Char('\n');
  }
  return text;
}

QByteArray with_words(const QByteArray& svg) {
  static const QRegularExpression word(QStringLiteral(">([^<>]+)</text>"));
  const QString text = QString::fromUtf8(svg);
  QString made;
  qsizetype done = 0;
  for (auto found = word.globalMatch(text); found.hasNext();) {
    const QRegularExpressionMatch one = found.next();
    made += text.mid(done, one.capturedStart(1) - done);
    made += QCoreApplication::translate("ManualPicture", one.captured(1).toUtf8().constData()).toHtmlEscaped();
    done = one.capturedEnd(1);
  }
  return (made + text.mid(done)).toUtf8();
}

/// Colours of the dark theme, as the pictures are drawn in, become those of the theme in use.
QByteArray themed(QByteArray svg, const ThemeColors& theme) {
  const ThemeColors& drawn = dark_theme();
  const std::array<std::pair<QColor, QColor>, 5> kin{{{drawn.accent, theme.accent},
                                                      {drawn.good, theme.good},
                                                      {drawn.warning, theme.warning},
                                                      {drawn.danger, theme.danger},
                                                      {drawn.dim, theme.dim}}};
  for (const auto& [from, to] : kin) {
    svg.replace(from.name().toLatin1(), to.name().toLatin1());
  }
  // Series that would vanish on white.
  for (int i = 0; i < 5; ++i) {
    svg.replace(series_color(drawn, i).name().toLatin1(), series_color(theme, i).name().toLatin1());
  }
  return svg.replace("currentColor", theme.text.name().toLatin1());
}

}  // namespace

ManualBrowser::ManualBrowser(QWidget* parent) : QTextBrowser(parent) {
  setObjectName(QStringLiteral("manual_text"));
  setAccessibleName(tr("Manual"));
  setFrameShape(QFrame::NoFrame);
  setOpenLinks(false);
  connect(this, &QTextBrowser::anchorClicked, this, [this](const QUrl& url) {
    if (url.scheme() == QLatin1String("manual")) {
      Q_EMIT chapter_wanted(url.path());
    }
  });
}

void ManualBrowser::show_markdown(const QString& markdown) {
  markdown_ = markdown;
  const ThemeColors& theme = theme_colors(palette());
  document()->clear();
  document()->setDocumentMargin(4 * kGrid);
  setMarkdown(markdown);
  // Markdown knows nothing of how wide a line may be or how much air a table needs.
  struct Span {
    int position, length;
    int heading;  ///< Its level; 0: a link.
  };
  std::vector<Span> spans;  // first found, then changed: changing joins and splits what is walked over
  QTextCursor cursor(document());
  cursor.beginEditBlock();
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
    QTextBlockFormat format = block.blockFormat();
    const bool picture = !block.begin().atEnd() && block.begin().fragment().charFormat().isImageFormat();
    // A proportion of a picture's height would be a gap below it.
    format.setLineHeight(picture ? 100 : 135, QTextBlockFormat::ProportionalHeight);
    if (format.headingLevel() > 0) {
      format.setTopMargin(format.headingLevel() == 1 ? 0 : 3 * kGrid);
      format.setBottomMargin(1.5 * kGrid);
    } else {
      format.setBottomMargin(format.hasProperty(QTextFormat::BlockCodeFence) ? 2 : kGrid);
    }
    format.setNonBreakableLines(false);  // A long command goes on in the next line.
    QTextCursor(block).setBlockFormat(format);
    for (auto it = block.begin(); !it.atEnd(); ++it) {
      const bool anchor = it.fragment().charFormat().isAnchor();
      if (anchor || format.headingLevel() > 0) {
        spans.push_back({it.fragment().position(), it.fragment().length(), anchor ? 0 : format.headingLevel()});
      }
    }
  }
  for (const Span& span : spans) {
    QTextCursor words(document());
    words.setPosition(span.position);
    words.setPosition(span.position + span.length, QTextCursor::KeepAnchor);
    QTextCharFormat better;
    if (span.heading == 0) {
      better.setForeground(theme.accent);
    } else {
      better.setProperty(QTextFormat::FontPixelSize, span.heading == 1 ? 26 : 18);
      better.setFontWeight(QFont::DemiBold);
    }
    words.mergeCharFormat(better);
  }
  for (QTextFrame* frame : document()->rootFrame()->childFrames()) {
    if (auto* table = qobject_cast<QTextTable*>(frame)) {
      QTextTableFormat format = table->format();
      format.setBorder(0);
      format.setCellPadding(kGrid);
      format.setCellSpacing(1);
      format.setBackground(theme.panel);
      format.setWidth(QTextLength(QTextLength::VariableLength, 0));
      table->setFormat(format);
    }
  }
  cursor.endEditBlock();
  moveCursor(QTextCursor::Start);
  verticalScrollBar()->setValue(0);
}

QVariant ManualBrowser::loadResource(int type, const QUrl& url) {
  if (type != QTextDocument::ImageResource) {
    return QTextBrowser::loadResource(type, url);
  }
  QFile file(QStringLiteral(":/manual/") + url.path());
  if (!file.open(QIODevice::ReadOnly)) {
    return {};
  }
  QSvgRenderer renderer(themed(with_words(file.readAll()), theme_colors(palette())));
  const double ratio = devicePixelRatioF();
  QSize size = renderer.defaultSize();
  if (const int room = viewport()->width() - 8 * kGrid; room > 240 && size.width() > room) {
    size.scale(room, size.height(), Qt::KeepAspectRatio);  // A small window shows it smaller, not cut off.
  }
  QImage picture(size * ratio, QImage::Format_ARGB32_Premultiplied);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  renderer.render(&painter);
  painter.end();
  picture.setDevicePixelRatio(ratio);
  return picture;
}

void ManualBrowser::changeEvent(QEvent* event) {
  QTextBrowser::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && !markdown_.isEmpty()) {
    show_markdown(markdown_);
  }
}

ManualWindow::ManualWindow(const std::vector<ShortcutGroup>& shortcuts, QWidget* parent)
    : QDialog(parent), keys_(keys_chapter(shortcuts)), list_(new QListWidget(this)), text_(new ManualBrowser(this)) {
  setObjectName(QStringLiteral("manual"));
  setWindowTitle(tr("Manual"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2 * kGrid, 2 * kGrid, 0, 0);
  layout->setSpacing(2 * kGrid);
  list_->setObjectName(QStringLiteral("manual_chapters"));
  list_->setAccessibleName(tr("Chapters"));
  for (const Chapter& chapter : kChapters) {
    auto* item = new QListWidgetItem(title_of(chapter), list_);
    item->setData(Qt::UserRole, QString::fromLatin1(chapter.name));
  }
  list_->setFixedWidth(list_->sizeHintForColumn(0) + 4 * kGrid);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  layout->addWidget(list_);
  layout->addWidget(text_, 1);
  connect(list_, &QListWidget::currentRowChanged, this, &ManualWindow::refresh);
  connect(text_, &ManualBrowser::chapter_wanted, this, &ManualWindow::show_chapter);
  const QSize room = QGuiApplication::primaryScreen()->availableSize() * 0.9;
  resize(std::min(1100, room.width()), std::min(780, room.height()));
  list_->setCurrentRow(0);
}

QStringList ManualWindow::chapters() {
  QStringList names;
  for (const Chapter& chapter : kChapters) {
    names << QString::fromLatin1(chapter.name);
  }
  return names;
}

void ManualWindow::show_chapter(const QString& chapter) {
  list_->setCurrentRow(std::max(0, static_cast<int>(chapters().indexOf(chapter))));
}

QString ManualWindow::chapter() const {
  return list_->currentItem() != nullptr ? list_->currentItem()->data(Qt::UserRole).toString() : QString();
}

void ManualWindow::refresh() {
  text_->show_markdown(chapter() == QLatin1String(kKeys) ? keys_ : read_chapter(chapter()));
}

}  // namespace limbwave::ui
