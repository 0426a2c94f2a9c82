#include <exception>
#include <utility>

#include <XmlRpcValue.h>
#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/this_node.h>

#include <mixed_palletizing/adapters/master_watch.hpp>

namespace mixed_palletizing::adapters {
namespace {

/// One answer alone may fall between the registrations of a node that is just starting.
constexpr int kForgottenAnswers = 2;

constexpr const char* kServiceOfEveryNode = "/get_loggers";

}  // namespace

MasterState askMaster() {
  if (!ros::master::check()) return MasterState::kAway;
  XmlRpc::XmlRpcValue arguments;
  arguments[0] = ros::this_node::getName();
  // Not lookupNode: a master knows a node again that only asked it for a parameter.
  arguments[1] = ros::this_node::getName() + kServiceOfEveryNode;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue uri;
  if (ros::master::execute("lookupService", arguments, response, uri, false)) return MasterState::kKnowsUs;
  return ros::master::check() ? MasterState::kForgot : MasterState::kAway;
}

MasterWatch::MasterWatch(std::function<void()> on_forgotten, std::function<MasterState()> ask,
                         std::chrono::milliseconds period)
    : on_forgotten_(std::move(on_forgotten)),
      ask_(std::move(ask)),
      period_(period),
      thread_(&MasterWatch::watch, this) {}

MasterWatch::~MasterWatch() {
  {
    std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  ends_.notify_all();
  thread_.join();
}

void MasterWatch::watch() {
  MasterState before = MasterState::kKnowsUs;
  int forgot = 0;
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ends_.wait_for(lock, period_, [this] { return ending_; })) {
    lock.unlock();
    const MasterState now = askOr(before);
    forgot = now == MasterState::kForgot ? forgot + 1 : 0;
    say(before, now);
    before = now;
    if (forgot == kForgottenAnswers && !ros::isShuttingDown()) {
      ROS_FATAL_STREAM("the ROS master at " << ros::master::getURI()
                                            << " was started anew and does not know this node: start the "
                                               "launch file again");
      forgotten_ = true;
      on_forgotten_();
      return;
    }
    lock.lock();
  }
}

/// Out of memory the question itself may fail: then the next one tells.
MasterState MasterWatch::askOr(MasterState before) const {
  try {
    return ask_();
  } catch (const std::exception&) {
    return before;
  }
}

void MasterWatch::say(MasterState before, MasterState now) const {
  if (ros::isShuttingDown() || (before == MasterState::kAway) == (now == MasterState::kAway)) return;
  if (now == MasterState::kAway) {
    ROS_ERROR_STREAM("the ROS master at " << ros::master::getURI()
                                          << " does not answer: nobody finds this node's services");
  } else {
    ROS_WARN_STREAM("the ROS master at " << ros::master::getURI() << " answers again");
  }
}

void endNode() { ros::requestShutdown(); }

}  // namespace mixed_palletizing::adapters
