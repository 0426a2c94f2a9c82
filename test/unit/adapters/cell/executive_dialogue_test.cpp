#include <algorithm>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/cell/executive_dialogue.hpp>

namespace mixed_palletizing::cell {
namespace {

constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();

/// An order of one type: `count` boxes of 400 x 300 x 200 mm.
instances::Instance orderOf(int count) {
  instances::Instance instance;
  instance.name = "order";
  instance.order.rules.size = {1200, 800, 600};
  instance.order.types.push_back({"a", {400, 300, 200}, packing::Rotations::yawOnly(), 0.0, 0.0});
  instance.order.counts = {count};
  return instance;
}

/// A box in the fake pick area. Its x is its name.
struct FakeBox {
  int name = 0;
  bool known = true;
  bool fits = true;
  bool seen = true;  // otherwise only a rejected cluster
};

/// Camera, detector, planner and gripper in memory; counts what it is asked, and fails where a test says so.
class FakeCell : public CellLink {
 public:
  explicit FakeCell(std::vector<FakeBox> arrival, std::size_t n_pick = 3)
      : waiting(std::move(arrival)), n_pick_(n_pick) {
    remaining = static_cast<std::uint32_t>(waiting.size());
    fill();
  }

  void capture() override { note("capture"); }

  DetectBoxesResponse detect() override {
    note("detect");
    DetectBoxesResponse response;
    response.status = DetectBoxesResponse::OK;
    if (!calibrated) response.status = DetectBoxesResponse::NOT_CALIBRATED;
    if (bad_looks > 0) {
      --bad_looks;
      response.status = bad_look_status;
    }
    response.success = response.status == DetectBoxesResponse::OK;
    response.message = response.success ? "" : "no cloud";
    response.boxes.header.frame_id = "base";
    response.boxes.processing_ms = 12.5;
    for (const FakeBox& fake : area) show(fake, response.boxes);
    return response;
  }

  CalibrateResponse calibrate() override {
    note("calibrate");
    CalibrateResponse response;
    response.success = calibration_works;
    calibrated = calibration_works && !forgets_calibration;
    response.message = calibration_works ? "marker 0" : "no marker";
    return response;
  }

  StartPalletResponse startPallet(const StartPalletRequest& request) override {
    note("start");
    start = request;
    StartPalletResponse response;
    response.status = start_status;
    response.message = "why start failed";
    return response;
  }

  ChooseNextPickResponse choose(const ChooseNextPickRequest& request) override {
    note("choose");
    requests.push_back(request);
    ChooseNextPickResponse response = answer(request);
    if (tamper) tamper(response);
    return response;
  }

  ReportPickResponse report(const ReportPickRequest& request) override {
    note("report");
    reports.push_back(request);
    remaining -= request.outcome == ReportPickRequest::PLACED ? 1 : identified_;
    ReportPickResponse response;
    response.status = report_status;
    response.message = "why the report failed";
    return response;
  }

  GetPalletStateResponse palletState() override {
    note("state");
    GetPalletStateResponse response;
    response.status = state_status;
    response.message = "no pallet";
    response.state.remaining = {remaining + forgotten};
    response.state.utilization = 0.75;
    return response;
  }

  void move() override { note("move"); }

  TakeBoxResponse take(const geometry_msgs::PointStamped& point, bool discard) override {
    note(discard ? "discard" : "take");
    TakeBoxResponse response;
    EXPECT_EQ(point.header.frame_id, "base");
    const auto found = std::find_if(
        area.begin(), area.end(), [&](const FakeBox& box) { return box.name == std::lround(point.point.x); });
    response.success = takes && found != area.end();
    response.message = "nothing there";
    if (!response.success) return response;
    (discard ? thrown : packed).push_back(found->name);
    response.type_id = taken_type;
    response.item = static_cast<std::uint32_t>(found->name);
    area.erase(found);
    if (!discard || area.empty()) fill();
    return response;
  }

  void say(const std::string& line) override { said.push_back(line); }
  void warn(const std::string& line) override { warned.push_back(line); }

  std::size_t count(const std::string& what) const {
    return static_cast<std::size_t>(std::count(calls.begin(), calls.end(), what));
  }

  std::vector<FakeBox> waiting;
  std::vector<FakeBox> area;
  std::uint32_t remaining = 0;
  std::uint32_t forgotten = 0;  // boxes of the order that only the planner knows
  bool calibrated = true;
  bool calibration_works = true;
  bool forgets_calibration = false;
  bool takes = true;
  std::string taken_type = "a";
  int bad_looks = 0;
  std::uint8_t bad_look_status = DetectBoxesResponse::TIMEOUT;
  std::uint8_t start_status = StartPalletResponse::OK;
  std::uint8_t report_status = ReportPickResponse::OK;
  std::uint8_t state_status = GetPalletStateResponse::OK;
  std::function<void(ChooseNextPickResponse&)> tamper;
  std::uint32_t fails_at = kNever;  // number of the call that gets no answer
  std::vector<std::string> calls;
  std::vector<ChooseNextPickRequest> requests;
  std::vector<ReportPickRequest> reports;
  StartPalletRequest start;
  std::vector<int> packed;
  std::vector<int> thrown;
  std::vector<std::string> said;
  std::vector<std::string> warned;

 private:
  void note(const std::string& call) {
    if (calls.size() == fails_at) throw CellError("call " + std::to_string(fails_at) + " timed out");
    calls.push_back(call);
  }

  void fill() {
    while (area.size() < n_pick_ && !waiting.empty()) {
      area.push_back(waiting.front());
      waiting.erase(waiting.begin());
    }
  }

  static void show(const FakeBox& fake, BoxArray& boxes) {
    if (!fake.seen) {
      RejectedCluster cluster;
      cluster.text = "no level top";
      cluster.centroid.x = fake.name;
      cluster.extent.x = cluster.extent.y = cluster.extent.z = 0.1 * fake.name;
      boxes.rejected.push_back(cluster);
      return;
    }
    Box box;
    box.top_center.x = fake.name;
    box.size.x = 0.401;
    box.size.y = 0.299;
    box.size.z = 0.2;
    boxes.boxes.push_back(box);
  }

  const FakeBox& named(double name) const {
    return *std::find_if(area.begin(), area.end(),
                         [&](const FakeBox& box) { return box.name == std::lround(name); });
  }

  ChooseNextPickResponse answer(const ChooseNextPickRequest& request) {
    ChooseNextPickResponse response;
    response.decision_id = ++decisions_;
    response.decision_ms = 5.0;
    response.status = ChooseNextPickResponse::UNKNOWN_BOX;
    response.chosen_index = -1;
    response.message = "none is known";
    identified_ = 0;
    for (std::size_t i = 0; i < request.boxes.size(); ++i) {
      const FakeBox& box = named(request.boxes[i].top_center.x);
      PickOption option;
      option.status =
          !box.known ? PickOption::UNKNOWN_BOX : (box.fits ? PickOption::FEASIBLE : PickOption::DOES_NOT_FIT);
      option.reason = box.known ? "no room" : "no such type";
      if (box.known) {
        ++identified_;
        option.type_id = "a";
        if (response.status == ChooseNextPickResponse::UNKNOWN_BOX) {
          response.status = ChooseNextPickResponse::NONE_FITS;
        }
      }
      if (option.status == PickOption::FEASIBLE && response.chosen_index < 0) {
        response.status = ChooseNextPickResponse::PICK;
        response.chosen_index = static_cast<std::int32_t>(i);
        response.type_id = "a";
        response.placement.size.x = 0.4;
        response.placement.size.y = 0.3;
        response.placement.size.z = 0.2;
      }
      response.options.push_back(option);
    }
    return response;
  }

  std::size_t n_pick_;
  std::uint64_t decisions_ = 0;
  std::uint32_t identified_ = 0;
};

CellReport play(FakeCell& cell, int retries = 2) {
  CellDialogueOptions options;
  options.retries = retries;
  return CellDialogue(orderOf(static_cast<int>(cell.waiting.size() + cell.area.size())), options, cell).run();
}

std::vector<FakeBox> boxes(int count) {
  std::vector<FakeBox> all;
  for (int i = 1; i <= count; ++i) all.push_back({i});
  return all;
}

TEST(CellDialogue, PlaysAnOrderToItsEnd) {
  FakeCell cell(boxes(5));
  const CellReport report = play(cell);
  EXPECT_TRUE(report.complete) << report.message;
  EXPECT_EQ(report.message, "");
  EXPECT_EQ(report.pallet_id, "order");
  EXPECT_EQ(cell.packed, (std::vector<int>{1, 2, 3, 4, 5}));
  EXPECT_TRUE(cell.thrown.empty());
  EXPECT_EQ(report.picks.size(), 5U);
  EXPECT_EQ(report.capture_ms.size(), 5U) << "no look at the empty pick area";
  EXPECT_EQ(report.decision_ms, std::vector<double>(5, 5.0));
  EXPECT_EQ(report.detection_ms, std::vector<double>(5, 12.5));
  EXPECT_EQ(report.utilization, 0.75) << "the planner's";
  EXPECT_NEAR(report.picks[1].utilization, 2 * 0.4 * 0.3 * 0.2 / (1.2 * 0.8 * 0.6), 1e-9);
  EXPECT_EQ(report.picks[0].nominal_mm, (std::array<double, 3>{400, 300, 200}));
  EXPECT_NEAR(report.picks[0].measured.size_mm[0], 401.0, 1e-9);
  EXPECT_EQ(report.picks[3].item, 4U);
  EXPECT_EQ(report.picks[0].available, 3U);
  EXPECT_EQ(report.picks[4].available, 1U);
  const std::vector<std::string> first{"start", "capture", "detect", "choose",
                                       "move",  "report",  "take",   "capture"};
  EXPECT_EQ(std::vector<std::string>(cell.calls.begin(), cell.calls.begin() + 8), first);
  EXPECT_EQ(cell.calls.back(), "state");
  EXPECT_EQ(cell.start.order.size(), 1U);
  EXPECT_NEAR(cell.start.size.z, 0.6, 1e-12);
  EXPECT_EQ(cell.reports[3].decision_id, 4U);
}

TEST(CellDialogue, EveryRequestHasAnIdOfItsOwn) {
  FakeCell cell(boxes(4));
  play(cell);
  for (std::size_t i = 1; i < cell.requests.size(); ++i) {
    EXPECT_NE(cell.requests[i].request_id, cell.requests[i - 1].request_id);
  }
}

TEST(CellDialogue, CalibratesOnceWhenAsked) {
  FakeCell cell(boxes(3));
  cell.calibrated = false;
  EXPECT_TRUE(play(cell).complete);
  EXPECT_EQ(cell.count("calibrate"), 1U);

  FakeCell blind(boxes(3));
  blind.calibrated = blind.calibration_works = false;
  EXPECT_EQ(play(blind).message, "calibrate: no marker");

  FakeCell forgetful(boxes(3));
  forgetful.calibrated = false;
  forgetful.forgets_calibration = true;
  EXPECT_FALSE(play(forgetful).complete);
  EXPECT_EQ(forgetful.count("calibrate"), 1U);
}

TEST(CellDialogue, LooksAgainWhenNoUsableCloudComes) {
  for (const std::uint8_t status : {DetectBoxesResponse::TIMEOUT, DetectBoxesResponse::BAD_CLOUD}) {
    FakeCell cell(boxes(3));
    cell.bad_look_status = status;
    cell.bad_looks = 2;
    EXPECT_TRUE(play(cell, 2).complete);
    FakeCell dark(boxes(3));
    dark.bad_look_status = status;
    dark.bad_looks = 1000;
    const CellReport report = play(dark, 2);
    EXPECT_FALSE(report.complete);
    EXPECT_EQ(report.message, "detect: no usable cloud in 3 looks: no cloud");
    EXPECT_EQ(dark.count("capture"), 3U);
  }
  FakeCell broken(boxes(3));
  broken.bad_look_status = DetectBoxesResponse::FAILED;
  broken.bad_looks = 1;
  EXPECT_EQ(play(broken).message, "detect: no cloud");
}

TEST(CellDialogue, DiscardsAllWhenNoneFits) {
  std::vector<FakeBox> arrival = boxes(7);
  for (std::size_t i = 1; i < 4; ++i) arrival[i].fits = false;
  FakeCell cell(arrival);
  const CellReport report = play(cell);
  EXPECT_TRUE(report.complete) << report.message;
  EXPECT_EQ(cell.packed, (std::vector<int>{1, 5, 6, 7}));
  EXPECT_EQ(cell.thrown, (std::vector<int>{2, 3, 4}));
  ASSERT_EQ(report.discards.size(), 3U);
  EXPECT_EQ(report.discards[0].type_id, "a");
  EXPECT_EQ(report.discards[0].item, 2U);
  EXPECT_EQ(report.discards[0].reason, "no room");
  ASSERT_EQ(cell.reports.size(), 5U);
  EXPECT_EQ(cell.reports[1].outcome, ReportPickRequest::DISCARDED);
  EXPECT_TRUE(cell.reports[1].discarded.empty()) << "all of the decision";
}

TEST(CellDialogue, ThrowsOutWhatIsNeverIdentified) {
  FakeCell cell({{1, false}}, 1);
  const CellReport report = play(cell, 2);
  EXPECT_FALSE(report.complete) << "a box of the order is missing";
  EXPECT_EQ(report.message, "the pick area is empty, but 1 of 1 boxes of the order have not been packed");
  EXPECT_EQ(cell.thrown, std::vector<int>{1});
  EXPECT_EQ(cell.count("choose"), 3U) << "two further looks";
  EXPECT_TRUE(cell.reports.empty());
  ASSERT_EQ(report.discards.size(), 1U);
  EXPECT_EQ(report.discards[0].type_id, "");
  EXPECT_EQ(report.discards[0].reason, "no such type");
  EXPECT_NEAR(report.discards[0].measured.size_mm[0], 401.0, 1e-9);
}

TEST(CellDialogue, PicksOthersBesideAnUnknownBoxAndThenThrowsItOut) {
  std::vector<FakeBox> arrival = boxes(6);
  arrival[1].known = false;
  FakeCell cell(arrival);
  const CellReport report = play(cell, 2);
  EXPECT_EQ(cell.packed, (std::vector<int>{1, 3, 4, 5, 6}));
  EXPECT_EQ(cell.thrown, std::vector<int>{2});
  EXPECT_FALSE(report.complete);
  EXPECT_EQ(report.picks.size(), 5U);
}

TEST(CellDialogue, AnUnknownBoxMayBecomeKnown) {
  std::vector<FakeBox> arrival = boxes(4);
  arrival[3].known = false;
  FakeCell cell(arrival, 1);
  cell.tamper = [&](ChooseNextPickResponse&) {
    if (cell.count("choose") == 5) cell.area.at(0).known = true;
  };
  const CellReport report = play(cell, 2);
  EXPECT_TRUE(report.complete) << report.message;
  EXPECT_EQ(report.picks.size(), 4U);
}

TEST(CellDialogue, ThrowsOutWhatIsNoBoxWhenNothingElseIsSeen) {
  std::vector<FakeBox> arrival = boxes(5);
  arrival[0].seen = arrival[1].seen = false;
  FakeCell cell(arrival, 2);
  const CellReport report = play(cell, 2);
  EXPECT_EQ(cell.thrown, (std::vector<int>{2, 1})) << "the larger one first, one a look";
  EXPECT_EQ(cell.packed, (std::vector<int>{3, 4, 5}));
  EXPECT_EQ(report.discards.size(), 2U);
  EXPECT_FALSE(report.complete);
}

TEST(CellDialogue, EndsWithTheReasonOfARefusal) {
  FakeCell open(boxes(3));
  open.start_status = StartPalletResponse::PALLET_OPEN;
  EXPECT_EQ(play(open).message, "start_pallet: why start failed");
  FakeCell stale(boxes(3));
  stale.report_status = ReportPickResponse::UNKNOWN_DECISION;
  EXPECT_EQ(play(stale).message, "report_pick: why the report failed");
  EXPECT_TRUE(stale.packed.empty()) << "what is not on record is not taken away";
  FakeCell stuck(boxes(3));
  stuck.takes = false;
  EXPECT_EQ(play(stuck).message, "take_box: nothing there");
  FakeCell mistaken(boxes(3));
  mistaken.taken_type = "b";
  EXPECT_EQ(play(mistaken).message, "take_box: the box that was packed as a is a b");
  FakeCell missing(boxes(3));
  missing.forgotten = 2;
  EXPECT_EQ(play(missing).message, "the planner still waits for 2 boxes");
  FakeCell gone(boxes(3));
  gone.state_status = GetPalletStateResponse::NO_PALLET;
  EXPECT_EQ(play(gone).message, "get_pallet_state: no pallet");
  for (const std::uint8_t status : {ChooseNextPickResponse::NO_PALLET, ChooseNextPickResponse::BAD_REQUEST,
                                    ChooseNextPickResponse::CONFLICT, ChooseNextPickResponse::FAILED}) {
    FakeCell cell(boxes(3));
    cell.tamper = [&](ChooseNextPickResponse& answer) {
      answer.status = status;
      answer.message = "refused";
      answer.options.clear();
    };
    EXPECT_EQ(play(cell).message, "choose_next_pick: refused");
  }
}

TEST(CellDialogue, DoesNotTrustTheAnswers) {
  const std::vector<std::function<void(ChooseNextPickResponse&)>> wrong{
      [](ChooseNextPickResponse& answer) { answer.options.pop_back(); },
      [](ChooseNextPickResponse& answer) { answer.chosen_index = 3; },
      [](ChooseNextPickResponse& answer) { answer.chosen_index = -1; },
      [](ChooseNextPickResponse& answer) { answer.placement.type_index = 1; },
      [](ChooseNextPickResponse& answer) { answer.status = 200; }};
  for (const auto& tamper : wrong) {
    FakeCell cell(boxes(3));
    cell.tamper = tamper;
    const CellReport report = play(cell);
    EXPECT_FALSE(report.complete);
    EXPECT_EQ(report.message.rfind("choose_next_pick: ", 0), 0U) << report.message;
    EXPECT_TRUE(cell.reports.empty());
  }
}

/// Whatever call gets no answer, the report says which, and tells what was done before.
TEST(CellDialogue, EveryCallMayTimeOut) {
  FakeCell whole(boxes(4));
  whole.calibrated = false;
  play(whole);
  for (std::uint32_t i = 0; i < whole.calls.size(); ++i) {
    FakeCell cell(boxes(4));
    cell.calibrated = false;
    cell.fails_at = i;
    const CellReport report = play(cell);
    EXPECT_FALSE(report.complete);
    EXPECT_EQ(report.message, "call " + std::to_string(i) + " timed out");
    EXPECT_EQ(report.picks.size(), cell.packed.size());
  }
}

TEST(CellDialogue, RefusesBadOptions) {
  FakeCell cell(boxes(1));
  CellDialogueOptions options;
  options.retries = -1;
  options.time_budget_s = -1.0;
  EXPECT_EQ(problems(options).size(), 2U);
  EXPECT_THROW(CellDialogue(orderOf(1), options, cell), std::invalid_argument);
}

}  // namespace
}  // namespace mixed_palletizing::cell
