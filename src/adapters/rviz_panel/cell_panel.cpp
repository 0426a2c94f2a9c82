#include "cell_panel.hpp"

#include <QFileDialog>
#include <QMessageBox>
#include <QMetaObject>
#include <QUrl>
#include <exception>
#include <utility>

#include <pluginlib/class_list_macros.hpp>

#include <mixed_palletizing/Calibrate.h>
#include <mixed_palletizing/ChooseNextPick.h>
#include <mixed_palletizing/ClosePallet.h>
#include <mixed_palletizing/DetectBoxes.h>
#include <mixed_palletizing/ReportPick.h>
#include <mixed_palletizing/StartPallet.h>
#include <mixed_palletizing/UndoLast.h>

#include "order_file.hpp"
#include "panel_text.hpp"

namespace mixed_palletizing::rviz_panel {
namespace {

constexpr char kCellKey[] = "Cell";
constexpr char kFileKey[] = "Order File";
constexpr char kIndexKey[] = "Order Index";

}  // namespace

CellPanel::CellPanel(QWidget* parent)
    : rviz::Panel(parent), widgets_(*this), thread_(std::make_unique<WorkThread>()) {
  connectButtons();
  connectCell();
}

CellPanel::~CellPanel() {
  link_->close();
  thread_.reset();
}

void CellPanel::connectButtons() {
  const auto on = [this](QPushButton* button, void (CellPanel::*act)()) {
    connect(button, &QPushButton::clicked, this, [this, act] { (this->*act)(); });
  };
  on(widgets_.calibrate, &CellPanel::calibrate);
  on(widgets_.detect, &CellPanel::detect);
  on(widgets_.start, &CellPanel::start);
  on(widgets_.next, &CellPanel::next);
  on(widgets_.undo, &CellPanel::undo);
  on(widgets_.close, &CellPanel::askToClose);
  on(widgets_.browse, &CellPanel::browse);
  connect(widgets_.placed, &QPushButton::clicked, this, [this] { report(ReportPickRequest::PLACED); });
  connect(widgets_.discarded, &QPushButton::clicked, this, [this] { report(ReportPickRequest::DISCARDED); });
  connect(widgets_.failed, &QPushButton::clicked, this, [this] { report(ReportPickRequest::FAILED); });
  connect(widgets_.cell, &QLineEdit::editingFinished, this, [this] {
    connectCell();
    Q_EMIT configChanged();
  });
}

void CellPanel::connectCell() {
  CellLink::Handlers handlers;
  handlers.state = [this](const PalletState& state) { later([this, state] { onState(state); }); };
  handlers.decision = [this](const PickDecision& decision) {
    later([this, decision] { widgets_.show(decision); });
  };
  handlers.report = [this](const std::string& path) {
    later([this, path] {
      const QString file = QString::fromStdString(path);
      widgets_.report->setText("<a href=\"" + QUrl::fromLocalFile(file).toString() + "\">" +
                               file.toHtmlEscaped() + "</a>");
    });
  };
  onState(PalletState());
  widgets_.show(PickDecision());
  try {
    if (link_) link_->close();
    link_ = std::make_shared<CellLink>(widgets_.cell->text().toStdString(), handlers);
  } catch (const std::exception& error) {  // a name that ROS does not take
    widgets_.cell->clear();
    link_ = std::make_shared<CellLink>("", handlers);
    say(error.what());
  }
}

void CellPanel::later(Update update) {
  QMetaObject::invokeMethod(this, std::move(update), Qt::QueuedConnection);
}

void CellPanel::say(const std::string& text) { widgets_.status->setText(QString::fromStdString(text)); }

void CellPanel::refresh() { widgets_.enable(!busy_, pallet_open_, decision_id_ != 0); }

void CellPanel::run(const char* doing, Work work) {
  busy_ = true;
  say(doing);
  refresh();
  thread_->post([this, link = link_, work = std::move(work)] {
    Update update;
    try {
      update = work(*link);
    } catch (const std::exception& error) {
      update = [this, text = std::string(error.what())] { say(text); };
    }
    later([this, update = std::move(update)] {
      busy_ = false;
      update();
      refresh();
    });
  });
}

void CellPanel::calibrate() {
  run("calibrating ...", [this](CellLink& link) -> Update {
    const auto answer = link.call<Calibrate>("box_detector/calibrate", {});
    return [this, answer] { say(calibrateLine(answer)); };
  });
}

void CellPanel::detect() {
  run("looking ...", [this](CellLink& link) -> Update {
    const auto answer = link.call<DetectBoxes>("box_detector/detect", {});
    return [this, answer] { say(detectLine(answer)); };
  });
}

void CellPanel::start() {
  const std::string path = widgets_.order_file->text().toStdString();
  const int index = widgets_.order_index->value();
  run("starting a pallet ...", [this, path, index](CellLink& link) -> Update {
    const auto answer = link.call<StartPallet>("pick_planner/start_pallet", readOrder(path, index));
    return [this, answer] { say(answer.message.empty() ? "started" : answer.message); };
  });
}

void CellPanel::next() {
  run("looking and choosing ...", [this](CellLink& link) -> Update {
    const auto seen = link.call<DetectBoxes>("box_detector/detect", {});
    if (seen.success == 0 || seen.boxes.boxes.empty()) return [this, seen] { say(detectLine(seen)); };
    ChooseNextPickRequest request;
    request.boxes = seen.boxes.boxes;
    const auto answer = link.call<ChooseNextPick>("pick_planner/choose_next_pick", request);
    return [this, seen, answer] {
      decision_id_ = answer.decision_id;
      leaving_ = leavingBoxes(seen.boxes, answer);
      say(chooseLine(answer));
    };
  });
}

void CellPanel::report(std::uint8_t outcome) {
  ReportPickRequest request;
  request.decision_id = decision_id_;
  request.outcome = outcome;
  LeavingBoxes leaving;
  if (outcome != ReportPickRequest::FAILED && leaving_.decision_id == decision_id_) leaving = leaving_;
  run("reporting ...", [this, request, leaving](CellLink& link) -> Update {
    const auto answer = link.call<ReportPick>("pick_planner/report_pick", request);
    if (answer.status != ReportPickResponse::OK) return [this, answer] { say(answer.message); };
    const bool discard = request.outcome == ReportPickRequest::DISCARDED;
    const std::string taken = takeFromSimulation(link, leaving, discard);
    return [this, answer, taken] {
      decision_id_ = 0;
      say((answer.message.empty() ? "reported" : answer.message) + (taken.empty() ? "" : "; " + taken));
    };
  });
}

void CellPanel::undo() {
  run("taking back ...", [this](CellLink& link) -> Update {
    const auto answer = link.call<UndoLast>("pick_planner/undo_last", {});
    return [this, answer] { say(answer.message.empty() ? "taken back" : answer.message); };
  });
}

void CellPanel::askToClose() {
  if (unfinished_.empty()) return closePallet();
  // Not exec(): rviz may take the panel away meanwhile.
  auto* question = new QMessageBox(
      QMessageBox::Question, "Close pallet",
      QString::fromStdString(unfinished_) + ".\nClose it all the same? It cannot be opened again.",
      QMessageBox::Yes | QMessageBox::No, this);
  question->setDefaultButton(QMessageBox::No);
  question->setAttribute(Qt::WA_DeleteOnClose);
  connect(question, &QMessageBox::finished, this, [this](int answer) {
    if (answer == QMessageBox::Yes) closePallet();
  });
  question->open();
}

void CellPanel::closePallet() {
  run("closing ...", [this](CellLink& link) -> Update {
    const auto answer = link.call<ClosePallet>("pick_planner/close_pallet", {});
    return [this, answer] { say(closeLine(answer)); };
  });
}

void CellPanel::browse() {
  const QString path = QFileDialog::getOpenFileName(this, "Orders", widgets_.order_file->text(),
                                                    "Orders (*.jsonl);;All files (*)");
  if (path.isEmpty()) return;
  widgets_.order_file->setText(path);
  Q_EMIT configChanged();
}

void CellPanel::onState(const PalletState& state) {
  pallet_open_ = state.is_open != 0;
  // A decision where nothing fits is not in the state: it lasts until something is reported.
  if (state.has_pending != 0) {
    decision_id_ = state.pending_decision_id;
  } else if (!pallet_open_ || state.revision != revision_) {
    decision_id_ = 0;
  }
  revision_ = state.revision;
  const OrderProgress progress = orderProgress(state);
  unfinished_ = progress.placed + progress.discarded < progress.total ? palletLine(state) : "";
  widgets_.show(state);
  refresh();
}

void CellPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  QString text;
  if (config.mapGetString(kFileKey, &text)) widgets_.order_file->setText(text);
  int index = 0;
  if (config.mapGetInt(kIndexKey, &index)) widgets_.order_index->setValue(index);
  if (!config.mapGetString(kCellKey, &text) || text == widgets_.cell->text()) return;
  widgets_.cell->setText(text);
  connectCell();
}

void CellPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue(kCellKey, widgets_.cell->text());
  config.mapSetValue(kFileKey, widgets_.order_file->text());
  config.mapSetValue(kIndexKey, widgets_.order_index->value());
}

}  // namespace mixed_palletizing::rviz_panel

PLUGINLIB_EXPORT_CLASS(mixed_palletizing::rviz_panel::CellPanel, rviz::Panel)
