#include "common/motion_names.h"

#include <QCoreApplication>
#include <array>

namespace limbwave::ui {
namespace {

struct MotionName {
  const char* motion;
  const char* title;
  const char* hint;
};

constexpr std::array<MotionName, 11> kNames{
    {{"wave", QT_TRANSLATE_NOOP("Motions", "Waving"), QT_TRANSLATE_NOOP("Motions", "Quick turns of the forearm")},
     {"arm-raise", QT_TRANSLATE_NOOP("Motions", "Arm raises"), QT_TRANSLATE_NOOP("Motions", "Slow and exact")},
     {"reach", QT_TRANSLATE_NOOP("Motions", "Reaching for a glass"),
      QT_TRANSLATE_NOOP("Motions", "All segments at once")},
     {"walk", QT_TRANSLATE_NOOP("Motions", "Walking"), QT_TRANSLATE_NOOP("Motions", "The arm swings along")},
     {"box", QT_TRANSLATE_NOOP("Motions", "Boxing"), QT_TRANSLATE_NOOP("Motions", "Hard accelerations")},
     {"every-joint", QT_TRANSLATE_NOOP("Motions", "Every joint"), QT_TRANSLATE_NOOP("Motions", "One after another")},
     {"run", QT_TRANSLATE_NOOP("Motions", "Running"), QT_TRANSLATE_NOOP("Motions", "Quick and hard")},
     {"squat", QT_TRANSLATE_NOOP("Motions", "Squats"), QT_TRANSLATE_NOOP("Motions", "Slow, with the whole body")},
     {"still", QT_TRANSLATE_NOOP("Motions", "Still poses"), QT_TRANSLATE_NOOP("Motions", "For measuring accuracy")},
     {"range", QT_TRANSLATE_NOOP("Motions", "Turning the sensors"),
      QT_TRANSLATE_NOOP("Motions", "For the range calibration")},
     {"poses", QT_TRANSLATE_NOOP("Motions", "Holding the poses"),
      QT_TRANSLATE_NOOP("Motions", "For the mounting calibration")}}};

const MotionName* find(const QString& motion) {
  for (const MotionName& name : kNames) {
    if (motion == QLatin1String(name.motion)) {
      return &name;
    }
  }
  return nullptr;
}

}  // namespace

QString motion_title(const QString& motion) {
  const MotionName* name = find(motion);
  return name != nullptr ? QCoreApplication::translate("Motions", name->title) : motion;
}

QString motion_hint(const QString& motion) {
  const MotionName* name = find(motion);
  return name != nullptr ? QCoreApplication::translate("Motions", name->hint)
                         : QCoreApplication::translate("Motions", "From the simulator");
}

}  // namespace limbwave::ui
