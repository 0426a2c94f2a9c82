// The panel of rviz from which a person runs a cell by hand, and sees what it does.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <rviz/panel.h>

#include <mixed_palletizing/PalletState.h>

#include "cell_link.hpp"
#include "panel_widgets.hpp"
#include "simulated_pick_area.hpp"
#include "work_thread.hpp"

namespace mixed_palletizing::rviz_panel {

class CellPanel : public rviz::Panel {
 public:
  explicit CellPanel(QWidget* parent = nullptr);
  ~CellPanel() override;

  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  using Update = std::function<void()>;           // changes widgets
  using Work = std::function<Update(CellLink&)>;  // waits for services, may throw

  void connectButtons();
  void connectCell();
  /// Does the work beside the window's thread and then the update on it.
  void run(const char* doing, Work work);
  /// On the window's thread, soon; nothing when the panel is gone by then.
  void later(Update update);
  void say(const std::string& text);
  void refresh();

  void calibrate();
  void detect();
  void start();
  void next();
  void report(std::uint8_t outcome);
  void undo();
  void askToClose();
  void closePallet();
  void browse();

  void onState(const PalletState& state);

  PanelWidgets widgets_;
  bool busy_ = false;
  bool pallet_open_ = false;
  std::string unfinished_;  // what is on the open pallet while boxes of its order are missing, else empty
  std::uint64_t revision_ = 0;
  std::uint64_t decision_id_ = 0;  // 0 = none to report
  LeavingBoxes leaving_;           // of the last decision that was asked for here
  std::shared_ptr<CellLink> link_;
  std::unique_ptr<WorkThread> thread_;
};

}  // namespace mixed_palletizing::rviz_panel
