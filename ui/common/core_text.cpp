#include "common/core_text.h"

#include <QCoreApplication>
#include <QHash>
#include <QLocale>
#include <QRegularExpression>
#include <array>
#include <optional>

#include "common/core_texts.h"
#include "common/format.h"
#include "common/shown_names.h"

namespace limbwave::ui {
namespace {

// Single words that go into others, and the names of steps.
constexpr std::array kWords{
    QT_TRANSLATE_NOOP("Core", "left"),
    QT_TRANSLATE_NOOP("Core", "right"),
    QT_TRANSLATE_NOOP("Core", "inverted"),
    QT_TRANSLATE_NOOP("Core", "louder"),
    QT_TRANSLATE_NOOP("Core", "quieter"),
    QT_TRANSLATE_NOOP("Core", "importing"),
    QT_TRANSLATE_NOOP("Core", "preparing the motion"),
    QT_TRANSLATE_NOOP("Core", "writing the truth"),
    QT_TRANSLATE_NOOP("Core", "closing the take"),
    QT_TRANSLATE_NOOP("Core", "decoding"),
    QT_TRANSLATE_NOOP("Core", "pulled"),
    QT_TRANSLATE_NOOP("Core", "calibrating"),
    QT_TRANSLATE_NOOP("Core", "estimating"),
    QT_TRANSLATE_NOOP("Core", "writing"),
    QT_TRANSLATE_NOOP("Core", "checking"),
    QT_TRANSLATE_NOOP("Core", "done"),
    QT_TRANSLATE_NOOP("Core", "%1 up"),
};

constexpr int kDeepest = 3;        // texts within texts within texts
constexpr qsizetype kKept = 2000;  // texts whose translation is remembered

QString translated(const QString& text, int depth);

// The best wording for a text, in the user's language.
std::optional<QString> by_wording(const QString& text, int depth) {
  const CoreTemplate* best = nullptr;
  QStringList arguments;
  QStringList tried;
  for (const CoreTemplate& one : core_templates()) {
    if ((best == nullptr || one.weight() > best->weight()) && one.match(text, tried)) {
      best = &one;
      arguments = tried;
    }
  }
  if (best == nullptr) {
    return std::nullopt;
  }
  const QByteArray key = best->wording().toUtf8();
  QString result = QCoreApplication::translate("Core", key.constData());
  // All at once, so that an argument with a % in it stays as it is.
  static const QRegularExpression placeholder(QStringLiteral("%(\\d+)"));
  QString filled;
  qsizetype at = 0;
  for (auto found = placeholder.globalMatch(result); found.hasNext();) {
    const QRegularExpressionMatch place = found.next();
    filled += result.mid(at, place.capturedStart() - at);
    const int index = place.captured(1).toInt() - 1;
    filled += index >= 0 && index < arguments.size() ? translated(arguments[index], depth + 1) : place.captured();
    at = place.capturedEnd();
  }
  return filled + result.mid(at);
}

// A number as the language writes it; nothing else.
std::optional<QString> number(const QString& text) {
  static const QRegularExpression decimal(QStringLiteral("^-?\\d+\\.\\d+( s)?$"));
  if (!decimal.match(text).hasMatch()) {
    return std::nullopt;
  }
  QString result = text;
  return result.replace(QLatin1Char('.'), QLocale().decimalPoint());
}

// Names, alone or "between quotation marks" and in lists of such.
QString quoted_names(const QString& text) {
  if (!text.contains(QLatin1Char('"'))) {
    return shown_name(text.toStdString());
  }
  QStringList parts = text.split(QLatin1Char('"'));
  for (qsizetype i = 1; i + 1 < parts.size(); i += 2) {
    parts[i] = shown_name(parts[i].toStdString());
  }
  return parts.join(QLatin1Char('"'));
}

QString translated(const QString& text, int depth) {
  if (text.isEmpty() || depth > kDeepest) {
    return text;
  }
  if (auto value = number(text)) {
    return *value;
  }
  if (auto worded = by_wording(text, depth)) {
    return *worded;
  }
  // A place before, a remedy behind.
  for (const QString& joint : {QStringLiteral("; "), QStringLiteral(": ")}) {
    const qsizetype at = text.indexOf(joint);
    if (at > 0) {
      return translated(text.left(at), depth + 1) + joint + translated(text.mid(at + joint.size()), depth + 1);
    }
  }
  return quoted_names(text);
}

}  // namespace

CoreTemplate::CoreTemplate(const QString& wording) : wording_(wording) {
  static const QRegularExpression placeholder(QStringLiteral("%\\d+"));
  pieces_ = wording.split(placeholder);
  for (const QString& piece : pieces_) {
    weight_ += piece.size();
  }
}

bool CoreTemplate::match(const QString& text, QStringList& arguments) const {
  arguments.clear();
  if (pieces_.size() == 1) {
    return text == wording_;
  }
  if (!text.startsWith(pieces_.first()) || !text.endsWith(pieces_.last()) || text.size() < weight_) {
    return false;
  }
  const qsizetype end = text.size() - pieces_.last().size();
  qsizetype at = pieces_.first().size();
  for (qsizetype i = 1; i < pieces_.size(); ++i) {
    const qsizetype next = i + 1 == pieces_.size() ? end : text.indexOf(pieces_[i], at);
    if (next < at || next > end) {
      return false;
    }
    arguments << text.mid(at, next - at);
    at = next + pieces_[i].size();
  }
  return true;
}

const std::vector<CoreTemplate>& core_templates() {
  static const std::vector<CoreTemplate> kTemplates = [] {
    std::vector<CoreTemplate> list;
    for (const char* wording : kCoreTexts) {
      list.emplace_back(QString::fromUtf8(wording));
    }
    for (const char* word : kWords) {
      list.emplace_back(QString::fromUtf8(word));
    }
    return list;
  }();
  return kTemplates;
}

QString core_text(const std::string& text) {
  thread_local QHash<QString, QString> known;  // for the language it was asked in
  thread_local QString language;
  const QString original = QString::fromStdString(text);
  const QString now = QCoreApplication::translate("Core", "decoding") + QLocale().name();
  if (now != language || known.size() > kKept) {
    known.clear();
    language = now;
  }
  const auto found = known.constFind(original);
  return found != known.cend() ? *found : *known.insert(original, translated(original, 0));
}

QString core_sentence(const std::string& text) {
  return as_sentence(core_text(text));
}

}  // namespace limbwave::ui
