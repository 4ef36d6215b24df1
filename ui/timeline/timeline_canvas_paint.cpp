// The painting half of the timeline's canvas.
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "common/theme.h"
#include "timeline/timeline_canvas.h"
#include "timeline/timeline_layout.h"

namespace limbwave::ui {

namespace {

constexpr double kClosestKeys = 2.0;  // pixels
constexpr double kMarkerText = 160.0;

void paint_diamond(QPainter& painter, const QPointF& at, double half, const QColor& fill, const QColor& edge) {
  QPainterPath path;
  path.moveTo(at.x(), at.y() - half);
  path.lineTo(at.x() + half, at.y());
  path.lineTo(at.x(), at.y() + half);
  path.lineTo(at.x() - half, at.y());
  path.closeSubpath();
  painter.setPen(QPen(edge, 1.25));
  painter.setBrush(fill);
  painter.drawPath(path);
}

}  // namespace

void TimelineCanvas::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColors& theme = theme_colors(palette());
  painter.fillRect(rect(), theme.panel);
  painter.fillRect(QRectF(kLabelWidth, 0, width() - kLabelWidth, height()), theme.base);
  paint_ruler(painter);
  paint_lanes(painter);
  paint_markers(painter);
  paint_overview(painter);
  if (time_.duration_s() > 0.0) {
    paint_playhead(painter);
  }
}

void TimelineCanvas::paint_ruler(QPainter& painter) const {
  const ThemeColors& theme = theme_colors(palette());
  const TimeScale s = scale();
  painter.save();
  painter.setClipRect(QRectF(kLabelWidth, 0, width() - kLabelWidth, height()));
  painter.fillRect(QRectF(kLabelWidth, 0, width() - kLabelWidth, kRulerHeight), theme.panel);
  painter.setFont(tabular(font(), 0.85));
  const TickSpacing spacing = tick_spacing(s.seconds_per_pixel(), time_.frame_s(), 72.0);
  const QFontMetricsF metrics(painter.font());
  if (time_.duration_s() > 0.0) {
    for (const Tick& tick : ticks(s, spacing, time_.duration_s())) {
      const double x = std::round(s.x(tick.time_s)) + 0.5;
      painter.setPen(QPen(theme.grid, 1));
      if (tick.major) {
        painter.drawLine(QPointF(x, kRulerHeight), QPointF(x, overview_rect().top() - 4));
      }
      painter.setPen(QPen(tick.major ? theme.dim : theme.line, 1));
      painter.drawLine(QPointF(x, kRulerHeight - (tick.major ? 8 : 4)), QPointF(x, kRulerHeight));
      if (tick.major) {
        const QString label = time_text(tick.time_s, spacing.major_s);
        painter.setPen(theme.dim);
        painter.drawText(QPointF(x + 4, metrics.ascent() + 2), label);
      }
    }
  }
  for (const TimelineStretch& stretch : stretches_) {
    const QRectF band(s.x(stretch.begin_s), kRulerHeight - 3, s.x(stretch.end_s) - s.x(stretch.begin_s), 3);
    painter.fillRect(band, theme.accent);
  }
  painter.setPen(QPen(theme.line, 1));
  painter.drawLine(QPointF(kLabelWidth, kRulerHeight + 0.5), QPointF(width(), kRulerHeight + 0.5));
  painter.restore();
  painter.setPen(QPen(theme.line, 1));
  painter.drawLine(QPointF(kLabelWidth - 0.5, 0), QPointF(kLabelWidth - 0.5, height()));
}

void TimelineCanvas::paint_markers(QPainter& painter) const {
  const ThemeColors& theme = theme_colors(palette());
  const TimeScale s = scale();
  painter.save();
  painter.setFont(tabular(font(), 0.85));
  painter.setPen(theme.dim);
  painter.drawText(QRectF(kGrid, kRulerHeight, kLabelWidth - 2 * kGrid, kMarkerHeight),
                   Qt::AlignVCenter | Qt::AlignLeft, tr("Events"));
  painter.setClipRect(QRectF(kLabelWidth, 0, width() - kLabelWidth, height()));
  const double middle = kRulerHeight + kMarkerHeight / 2.0;
  std::array<double, 3> drawn_until{-1e9, -1e9, -1e9};  // Per kind: one every few pixels is enough.
  double free_from = kLabelWidth;                       // Texts do not overlap: the earlier one stays.
  const QFontMetricsF metrics(painter.font());
  drawn_words_.clear();
  for (std::size_t i = 0; i < markers_.size(); ++i) {
    const TimelineMarker& marker = markers_[i];
    const bool selected = marker.number > 0 && marker.number == selected_marker_;
    const bool dragged = drag_ == Drag::kMarker && marker.number == dragged_marker_ && dragged_to_s_ >= 0.0;
    const double x = s.x(dragged ? dragged_to_s_ : marker.time_s);
    double& until = drawn_until.at(static_cast<std::size_t>(marker.kind));
    if (x < kLabelWidth - 8 || x > width() + 8 || (x < until && !selected && !dragged)) {
      continue;
    }
    until = x + kClosestKeys;
    const QString text = metrics.elidedText(marker.text, Qt::ElideRight, kMarkerText);
    const double text_width = metrics.horizontalAdvance(text);
    if (selected) {
      QColor tint = theme.accent;
      tint.setAlphaF(0.25F);
      painter.setPen(QPen(theme.accent, 1));
      painter.setBrush(tint);
      painter.drawRoundedRect(QRectF(x - 4.5, kRulerHeight + 1.5, text_width + 21, kMarkerHeight - 3), 4, 4);
    }
    // The shape says the kind, too: flag, cross, triangle.
    painter.setPen(Qt::NoPen);
    QPainterPath shape;
    switch (marker.kind) {
      case TimelineMarker::Kind::kMarker:
        painter.setBrush(theme.accent);
        shape.addPolygon(QPolygonF({{x, middle - 6},
                                    {x + 8, middle - 3},
                                    {x, middle},
                                    {x, middle + 6},
                                    {x - 1, middle + 6},
                                    {x - 1, middle - 6}}));
        painter.drawPath(shape);
        break;
      case TimelineMarker::Kind::kLoss:
        painter.setPen(QPen(theme.danger, 2));
        painter.drawLine(QPointF(x - 4, middle - 4), QPointF(x + 4, middle + 4));
        painter.drawLine(QPointF(x - 4, middle + 4), QPointF(x + 4, middle - 4));
        break;
      case TimelineMarker::Kind::kWarning:
        painter.setBrush(theme.warning);
        shape.addPolygon(QPolygonF({{x, middle - 5}, {x + 5, middle + 4}, {x - 5, middle + 4}}));
        painter.drawPath(shape);
        break;
    }
    if (x + 12 > free_from || selected) {
      painter.setPen(theme.text);
      painter.drawText(QPointF(x + 12, middle + metrics.ascent() / 2 - 1), text);
      free_from = x + 20 + text_width;
      drawn_words_.push_back({static_cast<int>(i), x, x + 16 + text_width});
    }
  }
  painter.restore();
}

void TimelineCanvas::paint_lanes(QPainter& painter) const {
  const ThemeColors& theme = theme_colors(palette());
  const TimeScale s = scale();
  const std::vector<int> lanes = visible_lanes();
  painter.save();
  painter.setFont(tabular(font(), 0.92));
  const QFontMetricsF metrics(painter.font());
  const QRectF area(0, lanes_top(), width(), overview_rect().top() - lanes_top() - 4);
  if (lanes.empty()) {
    painter.setPen(theme.dim);
    painter.drawText(area.adjusted(kLabelWidth + kGrid, 0, -kGrid, 0), Qt::AlignCenter | Qt::TextWordWrap, hint_);
    painter.restore();
    return;
  }
  painter.setClipRect(area);
  for (std::size_t row = static_cast<std::size_t>(first_row_); row < lanes.size(); ++row) {
    const int lane = lanes[row];
    const double middle = lane_middle(static_cast<int>(row));
    if (middle - kLaneHeight / 2.0 > area.bottom()) {
      break;
    }
    const bool current = lane == current_lane_;
    const QRectF line(0, middle - kLaneHeight / 2.0, width(), kLaneHeight);
    if (current) {
      QColor tint = theme.accent;
      tint.setAlphaF(0.10F);
      painter.fillRect(line, tint);
    }
    painter.setPen(QPen(theme.grid, 1));
    painter.drawLine(QPointF(kLabelWidth, middle), QPointF(width(), middle));
    painter.setPen(current ? theme.text : theme.dim);
    painter.drawText(line.adjusted(kGrid, 0, kLabelWidth - width() - kGrid, 0), Qt::AlignVCenter | Qt::AlignLeft,
                     metrics.elidedText(keys_.model().lane_name(lane), Qt::ElideRight, kLabelWidth - 2 * kGrid));
    painter.save();
    painter.setClipRect(QRectF(kLabelWidth, area.top(), width() - kLabelWidth, area.height()));
    const auto& list = keys_.model().keys(lane);
    if (list.size() > 1) {
      painter.setPen(QPen(theme.dim, 1));
      painter.drawLine(QPointF(s.x(list.front().time_s), middle), QPointF(s.x(list.back().time_s), middle));
    }
    // Only what is in view, and of keys that lie on one another the first: an hour may have thousands.
    const auto first = std::lower_bound(list.begin(), list.end(), s.time(kLabelWidth - kKeyHalf),
                                        [](const LaneKey& key, double time_s) { return key.time_s < time_s; });
    double drawn_until = -1e9;
    for (auto at = first; at != list.end(); ++at) {
      const LaneKey& key = *at;
      const double x = s.x(key.time_s);
      if (x > width() + kKeyHalf) {
        break;
      }
      const bool selected = keys_.is_selected({lane, key.id});
      if (x < drawn_until && !selected) {
        continue;
      }
      drawn_until = x + kClosestKeys;
      paint_diamond(painter, {x, middle}, selected ? kKeyHalf + 1 : kKeyHalf, selected ? theme.accent : theme.dim,
                    selected ? theme.text : theme.base);
    }
    painter.restore();
  }
  painter.restore();
}

void TimelineCanvas::paint_playhead(QPainter& painter) const {
  const ThemeColors& theme = theme_colors(palette());
  const double x = scale().x(time_.playhead_s());
  if (x < kLabelWidth - 1 || x > width() + 1) {
    return;
  }
  painter.save();
  painter.setClipRect(QRectF(kLabelWidth - 7, 0, width() - kLabelWidth + 7, height()));
  painter.setPen(QPen(theme.accent, 1));
  const double line = std::round(x) + 0.5;
  painter.drawLine(QPointF(line, 4), QPointF(line, overview_rect().top() - 4));
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.accent);
  painter.drawPolygon(QPolygonF({{line - 6, 0}, {line + 6, 0}, {line + 6, 7}, {line, 13}, {line - 6, 7}}));
  painter.restore();
}

void TimelineCanvas::paint_overview(QPainter& painter) const {
  const ThemeColors& theme = theme_colors(palette());
  const QRectF bar = overview_rect();
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.panel);
  painter.drawRoundedRect(bar, 4, 4);
  if (time_.duration_s() <= 0.0) {
    return;
  }
  const Span thumb =
      overview_thumb(time_.visible_begin_s(), time_.visible_end_s(), time_.duration_s(), bar.left(), bar.width(), 24);
  painter.setBrush(theme.line);
  painter.drawRoundedRect(QRectF(thumb.begin, bar.top(), thumb.end - thumb.begin, bar.height()), 4, 4);
  double losses_until = -1.0;  // One a pixel is enough.
  double others_until = -1.0;
  for (const TimelineMarker& marker : markers_) {
    const double x = bar.left() + bar.width() * marker.time_s / time_.duration_s();
    const bool loss = marker.kind == TimelineMarker::Kind::kLoss;
    double& until = loss ? losses_until : others_until;
    if (x < until) {
      continue;
    }
    until = x + 1.0;
    painter.setBrush(loss ? theme.danger : theme.dim);
    painter.drawRect(QRectF(x, bar.top(), 1.5, bar.height()));
  }
  painter.setBrush(theme.accent);
  painter.drawRect(QRectF(bar.left() + bar.width() * time_.playhead_s() / time_.duration_s() - 1, bar.top() - 1, 2,
                          bar.height() + 2));
}

}  // namespace limbwave::ui
