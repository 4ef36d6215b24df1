#include "plots/wire_view.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "common/format.h"
#include "common/icons.h"
#include "common/shown_names.h"
#include "common/theme.h"
#include "common/widgets.h"
#include "plots/level_meter.h"

namespace limbwave::ui {
namespace {

constexpr int kHeader = 24;
constexpr double kLeastRow = 20.0, kMostRow = 34.0;
constexpr double kUsualWords_hz = 140.0;
constexpr double kNarrow = 520.0;

Tone tone_of(const solve::BoxWire& wire) {
  if (!wire.plugged || wire.state != estimate::BoardState::kWell) {
    return Tone::kWarning;
  }
  if (!wire.locked) {
    return wire.frames > 0 || wire.level > 0.0 ? Tone::kWarning : Tone::kUnknown;
  }
  return wire.clipped ? Tone::kWarning : Tone::kGood;
}

// Where columns begin, by the width there is. A narrow view has neither bars nor rates: tips have them.
struct Columns {
  bool narrow;
  double icon = kGrid, name = 32.0, level, words, ranges, state;
  explicit Columns(double width)
      : narrow(width < kNarrow),
        level(narrow ? 0.42 * width : std::max(130.0, 0.22 * width)),
        words((narrow ? 0.6 : 0.52) * width),
        ranges((narrow ? 0.6 : 0.65) * width),
        state((narrow ? 0.6 : 0.78) * width) {}
};

}  // namespace

WireView::WireView(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Wires of the driver box"));
  setObjectName(QStringLiteral("wire_view"));
  setMouseTracking(true);
}

int WireView::wires() const {
  return snapshot_ ? static_cast<int>(snapshot_->wires.size()) : 0;
}

double WireView::row_height() const {
  return std::clamp((height() - kHeader) / std::max(1.0, static_cast<double>(wires())), kLeastRow, kMostRow);
}

QSize WireView::sizeHint() const {
  return {640, kHeader + 18 * 26};
}

QSize WireView::minimumSizeHint() const {
  return {270, kHeader + static_cast<int>(std::ceil(std::max(1, wires()) * kLeastRow))};
}

void WireView::set_snapshot(std::shared_ptr<const solve::LiveBodySnapshot> snapshot) {
  const int before = wires();
  snapshot_ = std::move(snapshot);
  if (wires() != before) {
    updateGeometry();
  }
  QStringList troubles;
  const bool away = snapshot_ && !snapshot_->connected;
  for (int w = 0; w < wires() && !away; ++w) {
    const solve::BoxWire& wire = snapshot_->wires[static_cast<std::size_t>(w)];
    if (tone_of(wire) == Tone::kWarning) {
      troubles << tr("%1: %2").arg(shown_name(wire.board), state_words(wire));
    }
  }
  const QString words = away                                ? tr("The box is away.")
                        : troubles.isEmpty() && wires() > 0 ? tr("All wires are well.")
                                                            : troubles.join(QStringLiteral("; "));
  if (accessibleDescription() != words) {
    setAccessibleDescription(words);
  }
  update();
}

void WireView::set_selected(int wire) {
  if (wire != selected_) {
    selected_ = wire;
    update();
  }
}

QString WireView::state_words(const solve::BoxWire& wire) {
  if (!wire.plugged) {
    return tr("pulled out");
  }
  if (!wire.locked) {
    return wire.frames > 0 ? tr("not understood") : wire.level > 0.0 ? tr("listening") : tr("silent");
  }
  switch (wire.state) {
    case estimate::BoardState::kSilent:
      return tr("no words");
    case estimate::BoardState::kFrozen:
      return tr("frozen");
    case estimate::BoardState::kWell:
      break;
  }
  return wire.clipped ? tr("clips") : wire.ranges_hz > 0.0 ? tr("well") : tr("well, no source in sight");
}

int WireView::wire_at(double y) const {
  const int wire = static_cast<int>(std::floor((y - kHeader) / row_height()));
  return wire >= 0 && wire < wires() ? wire : -1;
}

void WireView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) {
    Q_EMIT wire_clicked(wire_at(event->position().y()));
  }
}

void WireView::keyPressEvent(QKeyEvent* event) {
  const int step = event->key() == Qt::Key_Down ? 1 : event->key() == Qt::Key_Up ? -1 : 0;
  if (step == 0 || wires() == 0) {
    QWidget::keyPressEvent(event);
    return;
  }
  Q_EMIT wire_clicked(std::clamp(selected_ + step, 0, wires() - 1));
}

bool WireView::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = dynamic_cast<QHelpEvent*>(event);
    const int wire = help != nullptr ? wire_at(help->pos().y()) : -1;
    if (wire >= 0) {
      const solve::BoxWire& one = snapshot_->wires[static_cast<std::size_t>(wire)];
      QToolTip::showText(help->globalPos(),
                         tr("Wire %1, %2: %3. Words lost: %4 of %5; bits put right: %6.")
                             .arg(wire + 1)
                             .arg(shown_name(one.board), state_words(one))
                             .arg(one.lost_frames)
                             .arg(one.frames)
                             .arg(one.bit_errors),
                         this);
    } else {
      QToolTip::hideText();
    }
    return true;
  }
  return QWidget::event(event);
}

void WireView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ThemeColors& theme = theme_colors(palette());
  painter.fillRect(rect(), theme.base);
  const Columns at(width());
  const QFont figures = tabular(font());
  painter.setPen(theme.dim);
  const auto heading = [&](double x, double until, const QString& text) {
    painter.drawText(QRectF(x, 0, until - x - kGrid, kHeader), Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(text, Qt::ElideRight, static_cast<int>(until - x - kGrid)));
  };
  heading(at.name, at.level, tr("Board"));
  heading(at.level, at.words, tr("Level"));
  if (!at.narrow) {
    heading(at.words, at.ranges, tr("Words/s"));
    heading(at.ranges, at.state, tr("Ranges/s"));
  }
  heading(at.state, width(), tr("State"));
  painter.setPen(theme.line);
  painter.drawLine(QPointF(0, kHeader - 0.5), QPointF(width(), kHeader - 0.5));
  const double row = row_height();
  for (int w = 0; w < wires(); ++w) {
    const solve::BoxWire& wire = snapshot_->wires[static_cast<std::size_t>(w)];
    const QRectF area(0, kHeader + w * row, width(), row);
    if (w == selected_) {
      painter.fillRect(area, theme.raised);
      painter.fillRect(QRectF(0, area.top(), 3, row), theme.accent);
    }
    // What a box that is away said last is of no use any more.
    const bool away = !snapshot_->connected;
    const Tone tone = away ? Tone::kUnknown : tone_of(wire);
    painter.drawPixmap(QPointF(at.icon, area.center().y() - 7),
                       icon_pixmap(tone_icon(tone), tone_color(palette(), tone), 14, devicePixelRatioF()));
    const auto text = [&](double x, double until, const QString& words, const QColor& color, const QFont& with) {
      painter.setFont(with);
      painter.setPen(color);
      painter.drawText(QRectF(x, area.top(), until - x - kGrid, row), Qt::AlignLeft | Qt::AlignVCenter,
                       QFontMetrics(with).elidedText(words, Qt::ElideRight, static_cast<int>(until - x - kGrid)));
    };
    text(at.name, at.level, shown_name(wire.board), away ? theme.dim : theme.text, font());
    if (away) {
      text(at.state, width(), tr("away"), theme.dim, font());
      painter.setPen(theme.grid);
      painter.drawLine(QPointF(0, area.bottom() + 0.5), QPointF(width(), area.bottom() + 0.5));
      continue;
    }
    double figure_at = at.level;
    if (!at.narrow) {
      const QRectF bar(at.level, area.center().y() - 4, at.words - at.level - 9 * kGrid, 8);
      figure_at = bar.right() + kGrid;
      painter.fillRect(bar, theme.panel);
      if (wire.level > 0.0) {
        painter.fillRect(QRectF(bar.left(), bar.top() + 1, level_position(wire.level) * bar.width(), bar.height() - 2),
                         wire.clipped ? theme.warning : theme.good);
      }
      const bool few = wire.locked && wire.words_hz < 0.9 * kUsualWords_hz;
      text(at.words, at.ranges, QString::number(std::lround(wire.words_hz)), few ? theme.warning : theme.text, figures);
      text(at.ranges, at.state, QString::number(std::lround(wire.ranges_hz)), theme.text, figures);
    }
    text(figure_at, at.words, wire.level > 0.0 ? format_level(wire.level) : QStringLiteral("–"), theme.dim, figures);
    text(at.state, width(), state_words(wire), tone == Tone::kWarning ? theme.warning : theme.dim, font());
    painter.setPen(theme.grid);
    painter.drawLine(QPointF(0, area.bottom() + 0.5), QPointF(width(), area.bottom() + 0.5));
  }
  painter.setFont(font());
  if (hasFocus()) {
    painter.setPen(theme.accent);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

}  // namespace limbwave::ui
