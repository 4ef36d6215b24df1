/// Which rates, sample formats and inputs a device offers, and in words why it does not offer the others. Pure
/// functions, and what was chosen last for each device.
#pragma once

#include <QSettings>
#include <QString>
#include <vector>

#include "acquire/live_source.h"
#include "common/studio_services.h"

namespace limbwave::ui {

/// One choice of a list.
struct FormatChoice {
  QString text;     ///< "96 kHz"
  QString why_not;  ///< Why it cannot be chosen; empty: it can.
  bool chosen = false;
  DeviceSetup setup;  ///< What choosing it leads to.
};

struct FormatChoices {
  std::vector<FormatChoice> rates, types, inputs;
};

/// Every list begins with the studio's own choice ("Automatic"), and holds the usual values whether or not the device
/// has them.
FormatChoices format_choices(const acquire::DeviceInfo& device, const DeviceSetup& chosen);

/// "16 bit", "32 bit float"
QString sample_type_words(acquire::SampleType type);
/// "48 kHz, 24 bit", and the inputs where they are not the first two.
QString format_words(const acquire::StreamFormat& format, const DeviceSetup& setup);

/// What was chosen last for a device; what the device does not offer any more becomes the studio's choice again.
DeviceSetup remembered_setup(QSettings& settings, const acquire::DeviceInfo& device);
void remember_setup(QSettings& settings, const acquire::DeviceInfo& device, const DeviceSetup& setup);

}  // namespace limbwave::ui
