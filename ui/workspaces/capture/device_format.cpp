#include "workspaces/capture/device_format.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>

#include "common/format.h"

namespace limbwave::ui {
namespace {

/// lupdate knows this as the context "DeviceFormat".
struct DeviceFormat {
  Q_DECLARE_TR_FUNCTIONS(DeviceFormat)
};

constexpr std::array kUsualRates{44100.0, 48000.0, 88200.0, 96000.0, 176400.0, 192000.0};
constexpr std::array kTypes{acquire::SampleType::kInt16, acquire::SampleType::kInt24, acquire::SampleType::kInt32,
                            acquire::SampleType::kFloat32};
constexpr int kMostPairs = 32;  // of inputs

bool offers_rate(const acquire::DeviceInfo& device, double hz) {
  return std::any_of(device.rates_hz.begin(), device.rates_hz.end(),
                     [hz](double rate) { return std::abs(rate - hz) < 0.5; });
}

bool offers_type(const acquire::DeviceInfo& device, acquire::SampleType type) {
  return std::find(device.types.begin(), device.types.end(), type) != device.types.end();
}

// Ids hold colons and slashes, which settings take for groups.
QString settings_key(const acquire::DeviceInfo& device) {
  return QStringLiteral("capture/formats/") +
         QString::fromLatin1(QByteArray::fromStdString(device.id).toBase64(QByteArray::Base64UrlEncoding));
}

std::vector<FormatChoice> rate_choices(const acquire::DeviceInfo& device, const DeviceSetup& chosen) {
  DeviceSetup setup = chosen;
  setup.rate_hz = 0.0;
  std::vector<FormatChoice> list{{DeviceFormat::tr("Automatic"), {}, chosen.rate_hz <= 0.0, setup}};
  std::vector<double> rates(kUsualRates.begin(), kUsualRates.end());
  std::copy_if(device.rates_hz.begin(), device.rates_hz.end(), std::back_inserter(rates), [](double rate) {
    return std::none_of(kUsualRates.begin(), kUsualRates.end(),
                        [rate](double usual) { return std::abs(usual - rate) < 0.5; });
  });
  std::sort(rates.begin(), rates.end());
  for (const double rate : rates) {
    setup.rate_hz = rate;
    list.push_back({format_rate(rate),
                    offers_rate(device, rate) ? QString()
                    : device.rates_hz.empty() ? DeviceFormat::tr("the device does not say what it offers; another "
                                                                 "program may be using it")
                                              : DeviceFormat::tr("the device does not run at this rate"),
                    std::abs(chosen.rate_hz - rate) < 0.5, setup});
  }
  return list;
}

std::vector<FormatChoice> type_choices(const acquire::DeviceInfo& device, const DeviceSetup& chosen) {
  DeviceSetup setup = chosen;
  setup.type.reset();
  std::vector<FormatChoice> list{{DeviceFormat::tr("Automatic"), {}, !chosen.type, setup}};
  for (const acquire::SampleType type : kTypes) {
    setup.type = type;
    list.push_back({sample_type_words(type),
                    offers_type(device, type) ? QString()
                    : device.types.empty()    ? DeviceFormat::tr("the device does not say what it offers; another "
                                                                    "program may be using it")
                                              : DeviceFormat::tr("the device does not give such samples"),
                    chosen.type == type, setup});
  }
  return list;
}

std::vector<FormatChoice> input_choices(const acquire::DeviceInfo& device, const DeviceSetup& chosen) {
  std::vector<FormatChoice> list;
  const int pairs = std::clamp(device.channels / 2, 1, kMostPairs);
  for (int pair = 0; pair < pairs; ++pair) {
    DeviceSetup setup = chosen;
    setup.left = 2 * pair;
    setup.right = 2 * pair + 1;
    const bool own = chosen.left == setup.left && chosen.right == setup.right;
    list.push_back({DeviceFormat::tr("Left %1, right %2").arg(setup.left + 1).arg(setup.right + 1), {}, own, setup});
  }
  if (pairs == 1) {
    // A choice that is none needs a reason too.
    list.push_back({DeviceFormat::tr("Other inputs"),
                    device.channels < 2 ? DeviceFormat::tr("the device is mono; the board needs two channels")
                                        : DeviceFormat::tr("the device has no more than these"),
                    false, chosen});
  }
  return list;
}

}  // namespace

FormatChoices format_choices(const acquire::DeviceInfo& device, const DeviceSetup& chosen) {
  return {rate_choices(device, chosen), type_choices(device, chosen), input_choices(device, chosen)};
}

QString sample_type_words(acquire::SampleType type) {
  const auto bits = static_cast<int>(8 * acquire::bytes_per_sample(type));
  return type == acquire::SampleType::kFloat32 ? DeviceFormat::tr("%1 bit float").arg(bits)
                                               : DeviceFormat::tr("%1 bit").arg(bits);
}

QString format_words(const acquire::StreamFormat& format, const DeviceSetup& setup) {
  const QString words = DeviceFormat::tr("%1, %2").arg(format_rate(format.rate.hz), sample_type_words(format.type));
  return setup.left == 0 && setup.right == 1
             ? words
             : DeviceFormat::tr("%1, inputs %2 + %3").arg(words).arg(setup.left + 1).arg(setup.right + 1);
}

DeviceSetup remembered_setup(QSettings& settings, const acquire::DeviceInfo& device) {
  const QStringList parts = settings.value(settings_key(device)).toStringList();
  DeviceSetup setup;
  if (parts.size() != 4 && parts.size() != 7 && parts.size() != 8) {
    return setup;
  }
  if (parts.size() >= 7) {
    setup.temperature_c = std::clamp(parts[4].toDouble(), -30.0, 60.0);
    setup.humidity = std::clamp(parts[5].toDouble(), 0.0, 100.0);
    setup.height_m = std::clamp(parts[6].toDouble(), 0.0, 2.6);
    setup.ranging_take = parts.value(7).toStdString();
  }
  if (const double rate = parts[0].toDouble(); offers_rate(device, rate)) {
    setup.rate_hz = rate;
  }
  if (const auto type = acquire::sample_type(parts[1].toStdString()); type && offers_type(device, *type)) {
    setup.type = type;
  }
  const int left = parts[2].toInt(), right = parts[3].toInt();
  if (std::min(left, right) >= 0 && std::max(left, right) < device.channels) {
    setup.left = left;
    setup.right = right;
  }
  return setup;
}

void remember_setup(QSettings& settings, const acquire::DeviceInfo& device, const DeviceSetup& setup) {
  const auto type = setup.type ? acquire::name(*setup.type) : std::string_view();
  settings.setValue(
      settings_key(device),
      QStringList{QString::number(setup.rate_hz, 'g', 12),
                  QString::fromLatin1(type.data(), static_cast<qsizetype>(type.size())), QString::number(setup.left),
                  QString::number(setup.right), QString::number(setup.temperature_c), QString::number(setup.humidity),
                  QString::number(setup.height_m), QString::fromStdString(setup.ranging_take)});
}

}  // namespace limbwave::ui
