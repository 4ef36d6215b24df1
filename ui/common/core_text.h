/// What core/ says, in the user's language.
///
/// core/ knows no languages. Its sentences are the stable identifiers of what they say: the studio carries a table of
/// them, read off the sources (translations/core_texts.py), with %1, %2 ... where numbers and names stand. A text is
/// matched with the table, its arguments are taken out, translated if they are texts themselves, and put into the
/// translation (context "Core"). What no entry fits, or nobody has translated, stays English.
#pragma once

#include <QString>
#include <QStringList>
#include <string>
#include <vector>

namespace limbwave::ui {

QString core_text(const std::string& text);

/// The same as a sentence: with a capital and a full stop.
QString core_sentence(const std::string& text);

/// One wording, taken apart at its placeholders; for `core_text` and its tests.
class CoreTemplate {
 public:
  explicit CoreTemplate(const QString& wording);
  /// The arguments of %1, %2 ... when the text has this wording; empty optional otherwise. `arguments` is empty for
  /// wordings without any.
  [[nodiscard]] bool match(const QString& text, QStringList& arguments) const;
  [[nodiscard]] const QString& wording() const { return wording_; }
  /// Letters that have to be there: the more, the better a match.
  [[nodiscard]] qsizetype weight() const { return weight_; }

 private:
  QString wording_;
  QStringList pieces_;  // one more than placeholders
  qsizetype weight_ = 0;
};

/// All wordings that are known.
const std::vector<CoreTemplate>& core_templates();

}  // namespace limbwave::ui
