/// The manual: chapters at the left, the chosen one at the right. Its texts are Markdown in resources/manual.
#pragma once

#include <QDialog>
#include <QString>
#include <QTextBrowser>
#include <vector>

#include "workspaces/shortcut_sheet.h"

class QListWidget;

namespace limbwave::ui {

/// Shows Markdown with pictures in the colours of the theme.
class ManualBrowser : public QTextBrowser {
  Q_OBJECT
 public:
  explicit ManualBrowser(QWidget* parent = nullptr);
  void show_markdown(const QString& markdown);

 Q_SIGNALS:
  void chapter_wanted(const QString& chapter);

 protected:
  QVariant loadResource(int type, const QUrl& url) override;
  void changeEvent(QEvent* event) override;

 private:
  QString markdown_;
};

class ManualWindow : public QDialog {
  Q_OBJECT
 public:
  ManualWindow(const std::vector<ShortcutGroup>& shortcuts, QWidget* parent);
  /// By its name: "levels". An unknown one is the first.
  void show_chapter(const QString& chapter);
  [[nodiscard]] QString chapter() const;
  [[nodiscard]] static QStringList chapters();

 private:
  void refresh();
  QString keys_;  ///< The chapter of keys, as Markdown.
  QListWidget* list_;
  ManualBrowser* text_;
};

}  // namespace limbwave::ui
