#include "plots/overview_view.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "common/format.h"
#include "common/theme.h"

namespace limbwave::ui {
namespace {
constexpr double kAxis = 18;
constexpr double kShortest_s = 0.02;  // about one cycle of the multiplexer
}  // namespace

OverviewView::OverviewView(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("overview"));
  setAccessibleName(tr("Recorded signal"));
  setFocusPolicy(Qt::StrongFocus);
  setToolTip(tr("Wheel: zoom. Drag: move. Double click: show all."));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void OverviewView::set_overview(std::shared_ptr<const TakeOverview> overview) {
  overview_ = std::move(overview);
  begin_s_ = 0.0;
  end_s_ = overview_ ? overview_->seconds() : 0.0;
  all_ = true;
  update();
}

void OverviewView::grown() {
  if (all_ && overview_) {
    begin_s_ = 0.0;
    end_s_ = overview_->seconds();
  }
  update();
}

void OverviewView::set_marks(std::vector<OverviewMark> marks) {
  marks_ = std::move(marks);
  update();
}

void OverviewView::set_visible(double begin_s, double end_s) {
  if (!overview_ || !std::isfinite(begin_s) || !std::isfinite(end_s)) {
    return;
  }
  const double all = overview_->seconds();
  const double width = std::clamp(end_s - begin_s, std::min(kShortest_s, all), all);
  const double begin = std::clamp(begin_s, 0.0, all - width);
  all_ = width >= all;
  if (begin != begin_s_ || begin + width != end_s_) {
    begin_s_ = begin;
    end_s_ = begin + width;
    Q_EMIT visible_changed(begin_s_, end_s_);
    update();
  }
}

AxisMap OverviewView::time_axis() const {
  return {begin_s_, std::max(end_s_, begin_s_ + 1e-6), 0.0, static_cast<double>(width())};
}

void OverviewView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const ThemeColors& theme = theme_colors(palette());
  const QRectF band(0, 0, width(), height() - kAxis);
  painter.fillRect(band, theme.base);
  QFont small = font();
  small.setPixelSize(11);
  painter.setFont(tabular(small));
  if (hasFocus()) {
    painter.setPen(theme.accent);
    painter.drawRect(band.adjusted(0, 0, -1, -1));
  }
  if (!overview_ || overview_->frames == 0) {
    painter.setPen(theme.dim);
    painter.drawText(band, Qt::AlignCenter, overview_ ? tr("The take is empty.") : tr("Reading the signal…"));
    return;
  }
  const AxisMap time = time_axis();
  const double rate = overview_->rate_hz;
  const AxisMap x{time.value_begin * rate, time.value_end * rate, time.pixel_begin, time.pixel_end};
  const auto first = static_cast<std::int64_t>(std::floor(x.value_begin));
  const auto last = static_cast<std::int64_t>(std::ceil(x.value_end)) + 1;
  const std::array<const signal::MinMaxPyramid*, 2> channels{&overview_->left, &overview_->right};
  for (std::size_t c = 0; c < 2; ++c) {
    const double share = c == 0 ? 0.64 : 0.36;
    const QRectF area(0, c == 0 ? 0.0 : band.height() * 0.64, width(), band.height() * share);
    const AxisMap y{-1.0, 1.0, area.bottom() - 1, area.top() + 1};
    const QColor color = c == 0 ? series_color(theme, 1) : theme.dim;
    painter.setPen(QPen(color, 1));
    painter.setBrush(color);
    painter.drawPolygon(min_max_outline(channels.at(c)->query(first, last, width()), x, y));
  }
  painter.setBrush(Qt::NoBrush);
  for (const OverviewMark& mark : marks_) {
    const double at = std::floor(time.to_pixel(mark.time_s)) + 0.5;
    if (at < 0.0 || at > width()) {
      continue;
    }
    painter.setPen(mark.problem ? theme.warning : theme.accent);
    painter.drawLine(QPointF(at, 0), QPointF(at, band.bottom()));
    painter.drawText(QPointF(at + 3, 12), painter.fontMetrics().elidedText(mark.text, Qt::ElideRight, 140));
  }
  const double step = nice_step(time.value_end - time.value_begin, std::max(1, width() / 90));
  painter.setPen(theme.dim);
  for (const double tick : ticks(time.value_begin, time.value_end, step)) {
    const double at = std::floor(time.to_pixel(tick)) + 0.5;
    painter.drawLine(QPointF(at, band.bottom()), QPointF(at, band.bottom() + 4));
    const QString text =
        step >= 1.0 ? format_clock(tick) : QLocale().toString(tick, 'f', step >= 0.1 ? 1 : 3) + tr(" s");
    painter.drawText(QPointF(at + 3, height() - 5), text);
  }
}

void OverviewView::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  const AxisMap time = time_axis();
  const double about = time.to_value(event->position().x());
  const double factor = std::pow(1.25, -notches);
  set_visible(about - (about - begin_s_) * factor, about - (about - begin_s_) * factor + (end_s_ - begin_s_) * factor);
  event->accept();
}

void OverviewView::mousePressEvent(QMouseEvent* event) {
  drag_x_ = event->position().x();
}

void OverviewView::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) != 0) {
    const AxisMap time = time_axis();
    const double shift = time.to_value(drag_x_) - time.to_value(event->position().x());
    drag_x_ = event->position().x();
    set_visible(begin_s_ + shift, end_s_ + shift);
  }
}

void OverviewView::mouseDoubleClickEvent(QMouseEvent*) {
  if (overview_) {
    set_visible(0.0, overview_->seconds());
  }
}

void OverviewView::keyPressEvent(QKeyEvent* event) {
  const double width_s = end_s_ - begin_s_;
  switch (event->key()) {
    case Qt::Key_Left:
      set_visible(begin_s_ - 0.1 * width_s, end_s_ - 0.1 * width_s);
      break;
    case Qt::Key_Right:
      set_visible(begin_s_ + 0.1 * width_s, end_s_ + 0.1 * width_s);
      break;
    case Qt::Key_Plus:
      set_visible(begin_s_ + 0.1 * width_s, end_s_ - 0.1 * width_s);
      break;
    case Qt::Key_Minus:
      set_visible(begin_s_ - 0.125 * width_s, end_s_ + 0.125 * width_s);
      break;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace limbwave::ui
