#include "workspaces/capture/marker_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QShortcut>
#include <QSignalBlocker>
#include <QTableWidget>

#include "common/format.h"
#include "common/icons.h"
#include "common/theme.h"

namespace limbwave::ui {
namespace {

constexpr int kTime = 0, kName = 1;

}  // namespace

MarkerPanel::MarkerPanel(StudioContext& context, QWidget* parent)
    : Card(tr("Markers"), parent),
      context_(context),
      table_(new QTableWidget(0, 2, this)),
      mark_(new QPushButton(tr("Set marker"), this)),
      rename_(icon_button(QStringLiteral("rename"), tr("Rename the marker (F2)"), this)),
      remove_(icon_button(QStringLiteral("delete"), tr("Delete the marker (Delete)"), this)),
      hint_(dim_label({}, this)) {
  table_->setObjectName(QStringLiteral("marker_list"));
  table_->setAccessibleName(tr("Markers"));
  table_->setFont(tabular(table_->font()));
  table_->setMinimumHeight(18 * kGrid);
  table_->setHorizontalHeaderLabels({tr("Time"), tr("Name")});
  table_->horizontalHeader()->setSectionResizeMode(kTime, QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(kName, QHeaderView::Stretch);
  table_->horizontalHeader()->hide();
  table_->verticalHeader()->hide();
  table_->setShowGrid(false);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->setTabKeyNavigation(false);
  hint_->setAlignment(Qt::AlignTop);
  hint_->setWordWrap(true);
  mark_->setObjectName(QStringLiteral("marker_button"));
  mark_->setIcon(icon(QStringLiteral("marker")));
  mark_->setToolTip(tr("Set a marker at this moment of the recording (M)"));
  rename_->setObjectName(QStringLiteral("marker_rename"));
  remove_->setObjectName(QStringLiteral("marker_delete"));
  body()->addWidget(hint_);
  body()->addWidget(table_, 1);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid);
  buttons->addWidget(mark_, 1);
  buttons->addWidget(rename_);
  buttons->addWidget(remove_);
  body()->addLayout(buttons);

  connect(mark_, &QPushButton::clicked, this, [this] { context_.markers().mark_now(); });
  connect(rename_, &QToolButton::clicked, this, [this] { edit_name(number_of(table_->currentRow())); });
  connect(remove_, &QToolButton::clicked, this, &MarkerPanel::remove_selected);
  auto* erase = new QShortcut(QKeySequence(Qt::Key_Delete), table_);
  erase->setContext(Qt::WidgetShortcut);
  connect(erase, &QShortcut::activated, this, &MarkerPanel::remove_selected);
  connect(table_, &QTableWidget::cellChanged, this, [this](int row, int column) {
    // The table is still busy with its editor, which a refresh would take away.
    const std::int64_t number = number_of(row);
    const QString text = table_->item(row, column)->text();
    QMetaObject::invokeMethod(
        this, [this, number, column, text] { accept_edit(number, column, text); }, Qt::QueuedConnection);
  });
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int row) { choose_row(row); });
  connect(&context_.markers(), &MarkerModel::changed, this, &MarkerPanel::refresh);
  connect(&context_.selection(), &Selection::changed, this, &MarkerPanel::follow_selection);
  connect(&context_.live(), &LiveModel::recording_changed, this, &MarkerPanel::refresh);
  refresh();
}

std::int64_t MarkerPanel::number_of(int row) const {
  const QTableWidgetItem* item = row >= 0 ? table_->item(row, kTime) : nullptr;
  return item != nullptr ? item->data(Qt::UserRole).toLongLong() : 0;
}

int MarkerPanel::row_of(std::int64_t number) const {
  for (int row = 0; row < table_->rowCount(); ++row) {
    if (number_of(row) == number) {
      return row;
    }
  }
  return -1;
}

void MarkerPanel::refresh() {
  const QSignalBlocker block(table_);
  const std::int64_t chosen = context_.selection().marker();
  const auto& markers = context_.markers().markers();
  const bool grew = static_cast<int>(markers.size()) > table_->rowCount();
  const Qt::ItemFlags flags =
      Qt::ItemIsSelectable | Qt::ItemIsEnabled | (context_.markers().editable() ? Qt::ItemIsEditable : Qt::NoItemFlags);
  table_->setRowCount(static_cast<int>(markers.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const Marker& marker = markers[static_cast<std::size_t>(row)];
    const QStringList texts{format_clock_hundredths(context_.markers().time_s(marker)), marker.text};
    for (const int column : {kTime, kName}) {
      QTableWidgetItem* item = table_->item(row, column);
      if (item == nullptr) {
        item = new QTableWidgetItem;
        table_->setItem(row, column, item);
      }
      item->setText(texts[column]);
      item->setToolTip(column == kName ? marker.text : tr("Double click to type another time"));
      item->setData(Qt::UserRole, static_cast<qlonglong>(marker.number));
      // Setting them, even to what they are, puts the old text into an editor that is open on the item.
      if (item->flags() != flags) {
        item->setFlags(flags);
      }
    }
  }
  const int row = row_of(chosen);
  if (row >= 0) {
    if (row != table_->currentRow()) {
      table_->selectRow(row);  // Another cell of the row would end what is being typed in this one.
    }
  } else {
    table_->setCurrentCell(-1, -1);
    if (grew && context_.markers().recording()) {
      table_->scrollToBottom();
    }
  }
  table_->setVisible(table_->rowCount() > 0);
  hint_->setVisible(table_->rowCount() == 0);
  hint_->setText(context_.document().is_open() && !context_.live().recording()
                     ? tr("Press M while recording. In the signal below, double click at the upper edge.")
                     : tr("Press M while recording."));
  refresh_buttons();
}

void MarkerPanel::refresh_buttons() {
  mark_->setEnabled(context_.markers().recording());
  const bool chosen = table_->currentRow() >= 0 && context_.markers().editable();
  rename_->setEnabled(chosen);
  remove_->setEnabled(chosen);
}

void MarkerPanel::follow_selection() {
  const QSignalBlocker block(table_);
  const int row = row_of(context_.selection().marker());
  if (row < 0) {
    table_->setCurrentCell(-1, -1);
  } else if (row != table_->currentRow()) {
    table_->selectRow(row);
  }
  refresh_buttons();
}

void MarkerPanel::choose_row(int row) {
  const Marker* marker = context_.markers().find(number_of(row));
  if (marker != nullptr) {
    context_.selection().select_marker(marker->number);
    if (!context_.markers().recording()) {
      context_.time().set_playhead(context_.markers().time_s(*marker) - context_.document().capture_start_s());
    }
  }
  refresh_buttons();
}

void MarkerPanel::accept_edit(std::int64_t number, int column, const QString& text) {
  MarkerModel& markers = context_.markers();
  bool done = false;
  if (column == kName) {
    done = markers.rename(number, text);
  } else if (const std::optional<double> seconds = parse_clock(text)) {
    done = markers.move(number, *seconds);
  } else {
    context_.notifications().post(Severity::kWarning, tr("\"%1\" is not a time.").arg(text),
                                  tr("Write it like 1:07.3 or 67.3."));
  }
  if (!done) {
    refresh();  // As it was.
  }
}

void MarkerPanel::edit_name(std::int64_t number) {
  const int row = row_of(number);
  if (row >= 0 && context_.markers().editable()) {
    table_->setFocus();
    table_->setCurrentCell(row, kName);
    table_->editItem(table_->item(row, kName));
  }
}

void MarkerPanel::remove_selected() {
  const int row = table_->currentRow();
  if (context_.markers().remove(number_of(row)) && table_->rowCount() > 0) {
    table_->setCurrentCell(std::min(row, table_->rowCount() - 1), kName);
  }
}

}  // namespace limbwave::ui
