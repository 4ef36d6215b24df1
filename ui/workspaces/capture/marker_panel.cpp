#include "workspaces/capture/marker_panel.h"

#include <QListWidget>

#include "common/format.h"
#include "common/icons.h"
#include "common/theme.h"

namespace limbwave::ui {

MarkerPanel::MarkerPanel(StudioContext& context, CaptureModel& model, QWidget* parent)
    : Card(tr("Markers"), parent),
      context_(context),
      model_(model),
      list_(new QListWidget(this)),
      mark_(new QPushButton(tr("Set marker"), this)),
      hint_(dim_label(tr("Press M while recording."), this)) {
  list_->setObjectName(QStringLiteral("marker_list"));
  list_->setAccessibleName(tr("Markers"));
  list_->setFont(tabular(list_->font()));
  list_->setMinimumHeight(8 * kGrid);
  list_->setWordWrap(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  hint_->setAlignment(Qt::AlignTop);
  mark_->setObjectName(QStringLiteral("marker_button"));
  mark_->setIcon(icon(QStringLiteral("marker")));
  mark_->setToolTip(tr("Set a marker at this moment of the recording (M)"));
  body()->addWidget(hint_);
  body()->addWidget(list_, 1);
  body()->addWidget(mark_);
  connect(mark_, &QPushButton::clicked, this, [this] { model_.mark(); });
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (row >= 0 && row < static_cast<int>(model_.markers().size()) && !context_.live().recording()) {
      context_.selection().select(SelectionKind::kMarker, row);
      context_.time().set_playhead(model_.markers()[static_cast<std::size_t>(row)].time_s);
    }
  });
  connect(&model_, &CaptureModel::markers_changed, this, &MarkerPanel::refresh);
  connect(&context_.live(), &LiveModel::recording_changed, this, &MarkerPanel::refresh_button);
  refresh();
  refresh_button();
}

void MarkerPanel::refresh() {
  const QSignalBlocker block(list_);
  list_->clear();
  for (const MarkerRow& marker : model_.markers()) {
    auto* item =
        new QListWidgetItem(QStringLiteral("%1   %2").arg(format_clock_tenths(marker.time_s), marker.text), list_);
    item->setToolTip(marker.text);
  }
  list_->scrollToBottom();
  list_->setVisible(list_->count() > 0);
  hint_->setVisible(list_->count() == 0);
}

void MarkerPanel::refresh_button() {
  mark_->setEnabled(context_.live().recording());
}

}  // namespace limbwave::ui
