// The widgets of the panel and where they stand; what they do is the panel's business.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QWidget>
#include <vector>

#include <mixed_palletizing/PalletState.h>
#include <mixed_palletizing/PickDecision.h>

namespace mixed_palletizing::rviz_panel {

/// Every widget has its member's name without '_' as object name. All belong to the window.
struct PanelWidgets {
  explicit PanelWidgets(QWidget& window);

  QLineEdit* cell;        ///< namespace
  QLineEdit* order_file;  ///< JSON lines
  QSpinBox* order_index;
  QPushButton* browse;

  QPushButton* calibrate;
  QPushButton* detect;
  QPushButton* start;
  QPushButton* next;
  QPushButton* placed;
  QPushButton* discarded;
  QPushButton* failed;
  QPushButton* undo;
  QPushButton* close;

  QLabel* status;
  QLabel* pallet;
  QLabel* report;
  QProgressBar* order;
  QProgressBar* utilization;
  QTableWidget* options;

  void show(const PalletState& state);
  void show(const PickDecision& decision);

  /// Enables what can be done now.
  void enable(bool idle, bool pallet_open, bool decision_pending);
};

}  // namespace mixed_palletizing::rviz_panel
