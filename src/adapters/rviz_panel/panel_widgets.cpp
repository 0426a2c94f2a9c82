#include "panel_widgets.hpp"

#include <QFont>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <cmath>
#include <initializer_list>

#include "panel_text.hpp"

namespace mixed_palletizing::rviz_panel {
namespace {

constexpr int kMostOrders = 1000000;
constexpr int kPerMille = 1000;
constexpr int kTableHeightPx = 110;
constexpr int kTableWidthPx = 430;  // all columns

QPushButton* button(const char* name, const char* text, const char* hint) {
  auto* made = new QPushButton(text);
  made->setObjectName(name);
  made->setToolTip(hint);
  return made;
}

QLabel* label(const char* name) {
  auto* made = new QLabel;
  made->setObjectName(name);
  made->setWordWrap(true);
  return made;
}

QLineEdit* field(const char* name, const char* placeholder) {
  auto* made = new QLineEdit;
  made->setObjectName(name);
  made->setPlaceholderText(placeholder);
  return made;
}

QProgressBar* bar(const char* name, const char* format) {
  auto* made = new QProgressBar;
  made->setObjectName(name);
  made->setFormat(format);
  made->setValue(0);
  return made;
}

QTableWidget* table() {
  auto* made = new QTableWidget(0, static_cast<int>(kOptionTitles.size()));
  made->setObjectName("options");
  QStringList titles;
  for (const char* title : kOptionTitles) titles << title;
  made->setHorizontalHeaderLabels(titles);
  for (int k = 0; k < titles.size(); ++k)
    made->horizontalHeaderItem(k)->setToolTip(kOptionHints[static_cast<std::size_t>(k)]);
  made->verticalHeader()->hide();
  made->setEditTriggers(QAbstractItemView::NoEditTriggers);
  made->setSelectionMode(QAbstractItemView::NoSelection);
  made->setMinimumSize(kTableWidthPx, kTableHeightPx);
  return made;
}

QHBoxLayout* row(std::initializer_list<QWidget*> widgets) {
  auto* made = new QHBoxLayout;
  for (QWidget* widget : widgets) made->addWidget(widget);
  return made;
}

void arrange(const PanelWidgets& w, QWidget& window) {
  auto* fields = new QGridLayout;
  fields->addWidget(new QLabel("cell"), 0, 0);
  fields->addWidget(w.cell, 0, 1, 1, 3);
  fields->addWidget(new QLabel("order"), 1, 0);
  fields->addWidget(w.order_file, 1, 1);
  fields->addWidget(w.order_index, 1, 2);
  fields->addWidget(w.browse, 1, 3);
  auto* column = new QVBoxLayout(&window);
  column->addLayout(fields);
  column->addLayout(row({w.calibrate, w.detect}));
  column->addLayout(row({w.start, w.close}));
  column->addLayout(row({w.next, w.undo}));
  column->addLayout(row({w.placed, w.discarded, w.failed}));
  column->addWidget(w.status);
  column->addWidget(w.pallet);
  column->addWidget(w.order);
  column->addWidget(w.utilization);
  column->addWidget(w.options, 1);
  column->addWidget(w.report);
}

}  // namespace

PanelWidgets::PanelWidgets(QWidget& window)
    : cell(field("cell", "namespace of the cell, empty for none")),
      order_file(field("order_file", "orders, a JSON object a line")),
      order_index(new QSpinBox),
      browse(button("browse", "...", "Choose the file of orders")),
      calibrate(button("calibrate", "Calibrate", "Find the base frame in the next clouds")),
      detect(button("detect", "Detect", "Boxes of the next cloud")),
      start(button("start", "Start pallet", "Start a pallet for the chosen order")),
      next(button("next", "Next pick", "Look, and ask which box to pick and where to put it")),
      placed(button("placed", "Placed", "Report that the box stands on the pallet")),
      discarded(button("discarded", "Discarded", "Report that the box, or all that fit nowhere, are gone")),
      failed(button("failed", "Failed", "Report that nothing happened: the box is still to be had")),
      undo(button("undo", "Undo", "Take the last report back")),
      close(button("close", "Close pallet", "End the pallet, complete or not")),
      status(label("status")),
      pallet(label("pallet")),
      report(label("report")),
      order(bar("order", "order %v of %m")),
      utilization(bar("utilization", "utilization %p %")),
      options(table()) {
  order_index->setObjectName("order_index");
  order_index->setMaximum(kMostOrders);
  order_index->setToolTip("Which order of the file, from 0");
  order->setMaximum(1);
  utilization->setMaximum(kPerMille);
  order_file->setToolTip("File of orders, one JSON object a line");
  QObject::connect(order_file, &QLineEdit::textChanged, order_file, &QWidget::setToolTip);
  report->setOpenExternalLinks(true);
  arrange(*this, window);
  enable(true, false, false);
}

void PanelWidgets::show(const PalletState& state) {
  const OrderProgress progress = orderProgress(state);
  pallet->setText(QString::fromStdString(palletLine(state)));
  order->setMaximum(progress.total > 0 ? static_cast<int>(progress.total) : 1);
  order->setValue(static_cast<int>(progress.placed + progress.discarded));
  utilization->setValue(static_cast<int>(std::lround(kPerMille * state.utilization)));
}

void PanelWidgets::show(const PickDecision& decision) {
  const auto rows = optionRows(decision);
  options->setRowCount(static_cast<int>(rows.size()));
  for (int i = 0; i < options->rowCount(); ++i) {
    const auto& texts = rows[static_cast<std::size_t>(i)];
    for (std::size_t k = 0; k < texts.size(); ++k) {
      auto* item = new QTableWidgetItem(QString::fromStdString(texts[k]));
      QFont font = item->font();
      font.setBold(i == decision.chosen_index);
      item->setFont(font);
      options->setItem(i, static_cast<int>(k), item);
    }
  }
  options->resizeColumnsToContents();
}

void PanelWidgets::enable(bool idle, bool pallet_open, bool decision_pending) {
  for (QPushButton* always : {calibrate, detect, start}) always->setEnabled(idle);
  for (QPushButton* opened : {next, undo, close}) opened->setEnabled(idle && pallet_open);
  for (QPushButton* decided : {placed, discarded, failed}) decided->setEnabled(idle && decision_pending);
}

}  // namespace mixed_palletizing::rviz_panel
