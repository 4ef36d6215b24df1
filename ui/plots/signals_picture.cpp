#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <span>

#include "base/units.h"
#include "common/shown_names.h"
#include "plots/take_pictures.h"
#include "solve/front_end.h"
#include "take/take_reader.h"

namespace limbwave::ui {
namespace {

const QColor kBackground(24, 27, 31);
const QColor kPanel(31, 35, 40);
const QColor kGrid(58, 64, 72);
const QColor kText(200, 205, 212);
const QColor kLeft(86, 180, 233);
const QColor kRight(230, 159, 0);
const QColor kAxes[] = {QColor(213, 94, 0), QColor(0, 158, 115), QColor(86, 180, 233)};

QString text(const char* source) {
  return QCoreApplication::translate("SignalsPicture", source);
}

struct Decoded {
  std::vector<decode::AccelerationFrame> frames;
  std::vector<float> samples;  // one cycle and a bit, stereo
  decode::LineInCycle cycle;
  double first_sample = 0.0;
};

Result<Decoded> decode_take(const take::Take& take) {
  Result<take::TakeReader> reader = take::TakeReader::open(take);
  if (!reader) {
    return reader.error();
  }
  solve::FrontEnd front(take.info.rig, take.info.format.rate, {});
  front.keep_cycles(true);
  Decoded decoded;
  const take::TakeSegment capture = take.info.capture();
  const double middle = static_cast<double>(capture.first.value) + 0.5 * static_cast<double>(capture.count.value);
  std::vector<float> block(2 * 65536);
  while (true) {
    const Result<std::size_t> count = reader->next(block);
    if (!count) {
      return count.error();
    }
    if (*count == 0) {
      break;
    }
    front.push(std::span(block).first(2 * *count));
    for (const decode::LineInCycle& cycle : front.take_cycles()) {
      if (cycle.valid && (!decoded.cycle.valid || cycle.start_sample <= middle)) {
        decoded.cycle = cycle;
      }
    }
    for (const decode::AccelerationFrame& frame : front.take_frames()) {
      decoded.frames.push_back(frame);
    }
  }
  front.finish();
  for (const decode::AccelerationFrame& frame : front.take_frames()) {
    decoded.frames.push_back(frame);
  }
  decoded.first_sample = std::max(0.0, std::floor(decoded.cycle.start_sample - 0.1 * decoded.cycle.period_samples));
  const auto frames = static_cast<std::size_t>(std::ceil(1.2 * decoded.cycle.period_samples)) + 1;
  decoded.samples.resize(2 * frames);
  const Result<std::size_t> count =
      reader->read(SampleIndex{static_cast<std::int64_t>(decoded.first_sample)}, decoded.samples);
  if (!count) {
    return count.error();
  }
  decoded.samples.resize(2 * *count);
  return decoded;
}

void draw_scope(QPainter& painter, const QRectF& area, const Decoded& decoded, int slots) {
  painter.fillRect(area, kPanel);
  const double frames = std::max(2.0, static_cast<double>(decoded.samples.size()) / 2.0);
  const auto x = [&](double sample) { return area.left() + area.width() * (sample - decoded.first_sample) / frames; };
  const auto y = [&](double value) { return area.center().y() - 0.45 * area.height() * value; };
  painter.setPen(kGrid);
  painter.drawLine(QPointF(area.left(), y(0.0)), QPointF(area.right(), y(0.0)));
  for (int slot = 0; slot <= slots && decoded.cycle.valid; ++slot) {
    const double left = decoded.cycle.start_sample + decoded.cycle.period_samples * slot / slots;
    painter.setPen(kGrid);
    painter.drawLine(QPointF(x(left), area.top()), QPointF(x(left), area.bottom()));
    if (slot < slots) {
      const QString label = slot == slots - 1 ? text("ref") : QString::number(slot);
      painter.setPen(kText);
      painter.drawText(
          QRectF(x(left), area.top() + 2, area.width() * decoded.cycle.period_samples / frames / slots, 18),
          Qt::AlignCenter, label);
    }
  }
  for (int channel = 0; channel < 2; ++channel) {
    QPolygonF line;
    for (std::size_t i = 0; i < decoded.samples.size() / 2; ++i) {
      line << QPointF(x(decoded.first_sample + static_cast<double>(i)),
                      y(decoded.samples[2 * i + static_cast<std::size_t>(channel)]));
    }
    painter.setPen(QPen(channel == 0 ? kLeft : kRight, 1.5));
    painter.drawPolyline(line);
  }
}

void draw_accelerations(QPainter& painter, const QRectF& area, const take::Take& take, std::size_t sensor,
                        const std::vector<decode::AccelerationFrame>& frames,
                        const calibrate::RigCalibration& calibration, double from_s, double to_s) {
  painter.fillRect(area, kPanel);
  const auto x = [&](double time) { return area.left() + area.width() * (time - from_s) / (to_s - from_s); };
  const auto y = [&](double g) { return area.center().y() - area.height() * g / 4.4; };
  painter.setPen(kGrid);
  for (const double g : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
    painter.drawLine(QPointF(area.left(), y(g)), QPointF(area.right(), y(g)));
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    QPolygonF line;
    for (const decode::AccelerationFrame& frame : frames) {
      if (frame.time_s < from_s || frame.time_s > to_s || (frame.usable >> sensor & 1U) == 0) {
        continue;
      }
      const double g = calibration.sensors[sensor].apply(frame.volts[sensor])[axis] / kStandardGravity;
      line << QPointF(x(frame.time_s), y(std::clamp(g, -2.2, 2.2)));
    }
    painter.setPen(QPen(kAxes[axis], 1.3));
    painter.drawPolyline(line);
  }
  painter.setPen(kText);
  painter.drawText(area.adjusted(8, 4, 0, 0), Qt::AlignLeft | Qt::AlignTop,
                   shown_name(take.info.rig.accelerometers[sensor].name));
}

}  // namespace

Result<QImage> signals_picture(const take::Take& take, QSize size) {
  const Result<Decoded> decoded = decode_take(take);
  if (!decoded) {
    return decoded.error();
  }
  const calibrate::RigCalibration calibration =
      take.info.calibration ? *take.info.calibration : calibrate::nominal_calibration(take.info.rig);
  QImage image(size, QImage::Format_ARGB32_Premultiplied);
  image.fill(kBackground);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  QFont font = painter.font();
  font.setPixelSize(14);
  painter.setFont(font);
  const double margin = 16.0;
  const double scope_height = 0.34 * size.height();
  painter.setPen(kText);
  painter.drawText(QPointF(margin, 26.0),
                   text("Raw signal, one cycle: left channel (blue) with its slots, right channel (orange)"));
  draw_scope(painter, QRectF(margin, 36.0, size.width() - 2 * margin, scope_height - 44.0), *decoded,
             take.info.rig.line_in.slots);
  const take::TakeSegment capture = take.info.capture();
  const double from = take.info.format.rate.seconds(capture.first).value;
  const double to = from + std::max(0.1, take.info.format.rate.seconds(capture.count).value);
  painter.setPen(kText);
  painter.drawText(QPointF(margin, scope_height + 20.0),
                   text("Specific force, x red, y green, z blue, lines every 1 g; time %1 s to %2 s")
                       .arg(from, 0, 'f', 1)
                       .arg(to, 0, 'f', 1));
  const std::size_t sensors = take.info.rig.accelerometers.size();
  const double top = scope_height + 30.0;
  const double height = (size.height() - top - margin) / static_cast<double>(sensors);
  for (std::size_t sensor = 0; sensor < sensors; ++sensor) {
    draw_accelerations(
        painter, QRectF(margin, top + height * static_cast<double>(sensor), size.width() - 2 * margin, height - 6.0),
        take, sensor, decoded->frames, calibration, from, to);
  }
  return image;
}

}  // namespace limbwave::ui
