#include <ros/ros.h>
#include <ros/service.h>
#include <std_srvs/Empty.h>

#include <mixed_palletizing/ClosePallet.h>
#include <mixed_palletizing/adapters/cell/executive_services.hpp>
#include <mixed_palletizing/adapters/names.hpp>

namespace mixed_palletizing::cell {
namespace {

constexpr std::chrono::milliseconds kPoll{50};
constexpr double kSayWaitingEveryS = 5.0;

using Clock = std::chrono::steady_clock;

Clock::time_point deadlineIn(double seconds) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

void requireRunning() {
  if (!ros::ok()) throw CellError("interrupted");
}

}  // namespace

CellServices::CellServices(const ros::NodeHandle& node, const CellLinkOptions& options)
    : node_(node), options_(options) {}

CellServices::~CellServices() {
  if (hanging_.empty()) return;
  ros::shutdown();  // wakes the calls
  for (std::thread& thread : hanging_) thread.join();
}

std::string CellServices::resolve(const std::string& name_space, const char* name) const {
  return node_.resolveName(name_space + "/" + name);
}

void CellServices::waitForAll() {
  if (!ros::Time::waitForValid(ros::WallDuration(options_.service_wait_s))) {
    requireRunning();
    throw CellError("use_sim_time is set, but nobody publishes /clock");
  }
  std::vector<std::string> wanted{resolve(options_.detector, adapters::names::kDetect),
                                  resolve(options_.detector, adapters::names::kCalibrate),
                                  resolve(options_.planner, adapters::names::kStartPallet),
                                  resolve(options_.planner, adapters::names::kChooseNextPick),
                                  resolve(options_.planner, adapters::names::kReportPick),
                                  resolve(options_.planner, adapters::names::kGetPalletState),
                                  resolve(options_.planner, adapters::names::kClosePallet),
                                  resolve(options_.camera, adapters::names::kTakeBox)};
  if (options_.triggers_camera) wanted.push_back(resolve(options_.camera, adapters::names::kCapture));
  const Clock::time_point deadline = deadlineIn(options_.service_wait_s);
  for (const std::string& name : wanted) waitFor(name, deadline);
}

void CellServices::waitFor(const std::string& name, Clock::time_point deadline) {
  requireRunning();
  while (!ros::service::exists(name, false)) {
    if (Clock::now() > deadline) {
      throw CellError("service " + name + " did not appear within " +
                      std::to_string(static_cast<int>(options_.service_wait_s)) + " s");
    }
    ROS_INFO_STREAM_DELAYED_THROTTLE(kSayWaitingEveryS, "waiting for service " << name);
    std::this_thread::sleep_for(kPoll);
    requireRunning();
  }
}

void CellServices::await(const std::string& name, std::future<bool>& answer, double timeout_s,
                         const std::function<void()>& meanwhile) {
  const Clock::time_point deadline = deadlineIn(timeout_s);
  while (answer.wait_for(kPoll) != std::future_status::ready) {
    requireRunning();
    if (Clock::now() > deadline) {
      throw CellError("service " + name + " has not answered within " +
                      std::to_string(static_cast<int>(timeout_s)) + " s");
    }
    if (meanwhile) meanwhile();
  }
}

template <typename Service>
typename Service::Response CellServices::call(const std::string& name,
                                              const typename Service::Request& request, double timeout_s,
                                              const std::function<void()>& meanwhile) {
  waitFor(name, deadlineIn(options_.service_wait_s));  // its node may just be starting again
  const auto exchange = std::make_shared<Service>();   // of the thread alone, should it hang
  exchange->request = request;
  std::packaged_task<bool()> task([name, exchange] { return ros::service::call(name, *exchange); });
  std::future<bool> answer = task.get_future();
  hanging_.emplace_back(std::move(task));
  await(name, answer, timeout_s, meanwhile);
  hanging_.back().join();
  hanging_.pop_back();
  requireRunning();
  if (!answer.get()) throw CellError("service " + name + " failed: see the log of its node");
  return exchange->response;
}

void CellServices::capture() {
  if (!options_.triggers_camera) return;
  last_trigger_ = ros::Time::now();
  call<std_srvs::Empty>(resolve(options_.camera, adapters::names::kCapture), {}, options_.call_timeout_s);
}

DetectBoxesResponse CellServices::detect() {
  DetectBoxesRequest request;
  request.timeout = options_.cloud_timeout_s;
  request.not_before = last_trigger_;
  return call<DetectBoxes>(resolve(options_.detector, adapters::names::kDetect), request,
                           options_.cloud_timeout_s + options_.call_timeout_s);
}

CalibrateResponse CellServices::calibrate() {
  CalibrateRequest request;
  request.cloud_count = static_cast<std::uint32_t>(options_.calibration_clouds);
  request.timeout = options_.cloud_timeout_s;
  // The calibration takes the next clouds, so they are triggered while it waits.
  return call<Calibrate>(resolve(options_.detector, adapters::names::kCalibrate), request,
                         options_.calibration_timeout_s, [this] { capture(); });
}

StartPalletResponse CellServices::startPallet(const StartPalletRequest& request) {
  return call<StartPallet>(resolve(options_.planner, adapters::names::kStartPallet), request,
                           options_.call_timeout_s);
}

ChooseNextPickResponse CellServices::choose(const ChooseNextPickRequest& request) {
  return call<ChooseNextPick>(resolve(options_.planner, adapters::names::kChooseNextPick), request,
                              request.time_budget + options_.call_timeout_s);
}

ReportPickResponse CellServices::report(const ReportPickRequest& request) {
  return call<ReportPick>(resolve(options_.planner, adapters::names::kReportPick), request,
                          options_.call_timeout_s);
}

GetPalletStateResponse CellServices::palletState() {
  return call<GetPalletState>(resolve(options_.planner, adapters::names::kGetPalletState), {},
                              options_.call_timeout_s);
}

void CellServices::closePallet() {
  const ClosePalletResponse response = call<ClosePallet>(
      resolve(options_.planner, adapters::names::kClosePallet), {}, options_.call_timeout_s);
  if (response.status != ClosePalletResponse::OK) throw CellError("close_pallet: " + response.message);
}

void CellServices::move() { ros::Duration(options_.move_s).sleep(); }

TakeBoxResponse CellServices::take(const geometry_msgs::PointStamped& point, bool discard) {
  TakeBoxRequest request;
  request.point = point;
  request.discard = discard;
  return call<TakeBox>(resolve(options_.camera, adapters::names::kTakeBox), request, options_.call_timeout_s);
}

void CellServices::say(const std::string& line) { ROS_INFO("%s", line.c_str()); }

void CellServices::warn(const std::string& line) { ROS_WARN("%s", line.c_str()); }

}  // namespace mixed_palletizing::cell
