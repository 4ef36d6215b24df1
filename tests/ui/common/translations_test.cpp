/// German: nothing is left out, and what core/ says is understood.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTranslator>
#include <QXmlStreamReader>
#include <array>
#include <memory>
#include <set>

#include "body/rig.h"
#include "common/core_text.h"
#include "common/core_texts.h"
#include "common/health_text.h"
#include "common/shown_names.h"
#include "decode/line_in.h"
#include "solve/sensor_health.h"

namespace limbwave::ui {
namespace {

const QString kSources = QStringLiteral(LIMBWAVE_SOURCE_DIR);
const QString kGerman = kSources + QStringLiteral("/translations/limbwave_de.ts");

struct Message {
  QString context, source;
  QStringList translations;  // all forms of a plural in one
  QString type;              // "unfinished", "vanished", "obsolete" or nothing
};

std::vector<Message> messages_of(const QString& path) {
  QFile file(path);
  std::vector<Message> list;
  if (!file.open(QIODevice::ReadOnly)) {
    return list;
  }
  QXmlStreamReader xml(&file);
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) {
      continue;
    }
    const QStringView tag = xml.name();
    if (tag == QLatin1String("name")) {
      context = xml.readElementText();
    } else if (tag == QLatin1String("message")) {
      list.push_back({context, {}, {}, {}});
    } else if (tag == QLatin1String("source")) {
      list.back().source = xml.readElementText();
    } else if (tag == QLatin1String("translation")) {
      list.back().type = xml.attributes().value(QLatin1String("type")).toString();
      const QString text = xml.readElementText(QXmlStreamReader::IncludeChildElements);
      list.back().translations << text.trimmed();
    }
  }
  return list;
}

std::multiset<QString> placeholders(const QString& text) {
  static const QRegularExpression one(QStringLiteral("%(\\d+|n|L\\d+)"));
  std::multiset<QString> found;
  for (auto match = one.globalMatch(text); match.hasNext();) {
    found.insert(match.next().captured());
  }
  return found;
}

class German : public testing::Test {
 protected:
  void SetUp() override {
    application_ = std::make_unique<QCoreApplication>(count_, arguments_.data());
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    ASSERT_TRUE(translator_.load(QStringLiteral(LIMBWAVE_BINARY_DIR "/app/studio/limbwave_de.qm")));
    QCoreApplication::installTranslator(&translator_);
  }
  void TearDown() override {
    QCoreApplication::removeTranslator(&translator_);
    QLocale::setDefault(QLocale::c());
    application_.reset();
  }

 private:
  int count_ = 1;
  std::string name_ = "test";
  std::array<char*, 2> arguments_{name_.data(), nullptr};
  std::unique_ptr<QCoreApplication> application_;
  QTranslator translator_;
};

TEST(Translations, NothingIsUnfinished) {
  const std::vector<Message> messages = messages_of(kGerman);
  ASSERT_GT(messages.size(), 500U);
  for (const Message& message : messages) {
    const std::string where = (message.context + QStringLiteral(": ") + message.source).toStdString();
    EXPECT_EQ(message.type, QString()) << where;
    ASSERT_FALSE(message.translations.isEmpty()) << where;
    EXPECT_FALSE(message.translations.last().isEmpty()) << where;
    if (!message.source.contains(QLatin1String("%n"))) {  // plurals may leave the number out
      EXPECT_EQ(placeholders(message.source), placeholders(message.translations.front())) << where;
    }
  }
}

TEST(Translations, NoTextOfTheSourcesIsMissing) {
  const QTemporaryDir folder;
  const QString copy = folder.filePath(QStringLiteral("limbwave_de.ts"));
  ASSERT_TRUE(QFile::copy(kGerman, copy));
  QProcess lupdate;
  lupdate.start(QStringLiteral(LUPDATE), {QStringLiteral("-no-obsolete"), QStringLiteral("-locations"),
                                          QStringLiteral("none"), kSources + QStringLiteral("/ui"),
                                          kSources + QStringLiteral("/app/studio"), QStringLiteral("-ts"), copy});
  ASSERT_TRUE(lupdate.waitForFinished(120000));
  ASSERT_EQ(lupdate.exitCode(), 0) << lupdate.readAllStandardError().toStdString();
  int missing = 0;
  for (const Message& message : messages_of(copy)) {
    if (message.type == QLatin1String("unfinished")) {
      ++missing;
      ADD_FAILURE() << "not translated: " << message.context.toStdString() << ": " << message.source.toStdString();
    }
  }
  EXPECT_EQ(missing, 0) << "run `ninja update_translations` and translate";
}

TEST(Translations, EnglishHasItsPlurals) {
  const std::vector<Message> messages = messages_of(kSources + QStringLiteral("/translations/limbwave_en.ts"));
  ASSERT_GT(messages.size(), 3U);
  for (const Message& message : messages) {
    EXPECT_EQ(message.type, QString()) << message.source.toStdString();
    EXPECT_FALSE(message.translations.last().isEmpty()) << message.source.toStdString();
    EXPECT_FALSE(message.translations.last().contains(QLatin1String("(s)"))) << message.source.toStdString();
  }
  std::size_t plurals = 0;
  for (const Message& message : messages_of(kGerman)) {
    plurals += message.source.contains(QLatin1String("%n")) ? 1 : 0;
  }
  EXPECT_EQ(plurals, messages.size()) << "run `ninja update_translations` and fill in limbwave_en.ts";
}

TEST(CoreTemplate, TakesArgumentsOut) {
  QStringList arguments;
  const CoreTemplate one(QStringLiteral("only %1 % of all directions were covered; %2 % are needed"));
  EXPECT_TRUE(one.match(QStringLiteral("only 43 % of all directions were covered; 80 % are needed"), arguments));
  EXPECT_EQ(arguments, QStringList({QStringLiteral("43"), QStringLiteral("80")}));
  EXPECT_FALSE(one.match(QStringLiteral("only 43 % of all directions were covered"), arguments));
  const CoreTemplate plain(QStringLiteral("record in stereo"));
  EXPECT_TRUE(plain.match(QStringLiteral("record in stereo"), arguments));
  EXPECT_FALSE(plain.match(QStringLiteral("record in stereo now"), arguments));
  const CoreTemplate ends(QStringLiteral("%1 has stopped giving samples"));
  EXPECT_TRUE(ends.match(QStringLiteral("USB card has stopped giving samples"), arguments));
  EXPECT_EQ(arguments, QStringList({QStringLiteral("USB card")}));
}

TEST(CoreTemplate, WithoutATranslatorTheCoreSpeaksForItself) {
  for (const char* text : {"the recording has 5 channels", "no such words anywhere", "", "100 % %1 odd"}) {
    EXPECT_EQ(core_text(text).toStdString(), text);
  }
}

TEST_F(German, AFindingOfTheDecoder) {
  decode::LineInDecoder decoder({}, SampleRate{48000.0});
  const std::vector<float> silence(2 * 96000, 0.0F);
  decoder.push(silence);
  decoder.finish();
  const Diagnostics found = decoder.take_diagnostics();
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front().code, "line-in.silent");
  const QString message = core_sentence(found.front().message);
  EXPECT_TRUE(message.startsWith(QStringLiteral("Beide Kanäle sind still (links "))) << message.toStdString();
  EXPECT_TRUE(core_text(found.front().remedy).startsWith(QStringLiteral("Die Platine einschalten")));
}

TEST_F(German, NumbersNamesAndTextsWithinTexts) {
  EXPECT_EQ(core_text("the two directions of gravity are 75.5° apart, not about 90°"),
            QStringLiteral("die beiden Richtungen der Schwerkraft liegen 75,5° auseinander, nicht etwa 90°"));
  EXPECT_EQ(core_text("the right channel (sensors) is inverted by this sound card"),
            QStringLiteral("der Kanal rechts (Sensoren) wird von dieser Soundkarte invertiert"));
  EXPECT_EQ(core_text("reads 1.3 g at rest instead of 1 g; repeat its range calibration"),
            QStringLiteral("zeigt in Ruhe 1,3 g statt 1 g; die Bereichskalibrierung wiederholen"));
  EXPECT_EQ(core_text("range calibration failed: there are no readings"),
            QStringLiteral("die Bereichskalibrierung schlug fehl: es gibt keine Messwerte"));
  // An event in a take: message and remedy in one.
  EXPECT_EQ(core_text("120 samples were lost; close programs that keep the computer busy, or choose a larger buffer of "
                      "the sound card"),
            QStringLiteral("120 Abtastwerte gingen verloren; Programme schließen, die den Rechner beschäftigen, oder "
                           "einen größeren Puffer der Soundkarte wählen"));
  EXPECT_EQ(core_text("something that nobody has translated"), QStringLiteral("something that nobody has translated"));
}

// Names in rigs and skeletons that we ship are read in German wherever they stand; others stay as they are.
TEST_F(German, NamesOfShippedRigsAndBones) {
  EXPECT_EQ(shown_name("left_hand"), QStringLiteral("linke Hand"));
  EXPECT_EQ(shown_name("left hand"), QStringLiteral("linke Hand"));
  EXPECT_EQ(shown_name("my_own bone"), QStringLiteral("my_own bone"));
  EXPECT_EQ(shown_name(""), QString());
  EXPECT_TRUE(
      core_text("\"left hand\" was never heard: the filter did without it").contains(QStringLiteral("linke Hand")));
  EXPECT_TRUE(
      core_text("\"pelvis\", \"head\" and 3 more moved in the first second: the pose at the start is hardly known")
          .contains(QStringLiteral("\"Becken\", \"Kopf\"")));
  for (const char* name : kShippedNames) {
    const QString german = shown_name(name);
    EXPECT_TRUE(german != QString::fromUtf8(name)) << name;
  }
}

TEST_F(German, TheHealthOfASensor) {
  const auto rig = body::load_rig("line-in-arm");
  ASSERT_TRUE(rig.ok());
  std::vector<decode::AccelerationFrame> frames(60);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i].usable = i % 4 == 0 ? 1U : 0U;
  }
  const auto calibration = calibrate::nominal_calibration(*rig);
  const auto health = solve::sensor_health(*rig, calibration.sensors[0], 0, frames);
  EXPECT_TRUE(health_text(health).startsWith(QStringLiteral("nur 25 % der Messwerte sind brauchbar")))
      << health_text(health).toStdString();
}

TEST_F(German, EveryWordingOfTheCoreIsTranslated) {
  EXPECT_GT(core_templates().size(), 300U);
  for (const CoreTemplate& one : core_templates()) {
    const QByteArray key = one.wording().toUtf8();
    const QString translated = QCoreApplication::translate("Core", key.constData());
    EXPECT_EQ(placeholders(translated), placeholders(one.wording())) << key.toStdString();
    QStringList arguments;
    EXPECT_TRUE(one.match(one.wording(), arguments)) << key.toStdString();
  }
}

}  // namespace
}  // namespace limbwave::ui
