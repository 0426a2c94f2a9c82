#include <utility>

#include <mixed_palletizing/adapters/cloud_inbox.hpp>

namespace mixed_palletizing::adapters {
namespace {

/// Clocks of several computers that are kept together differ by less.
constexpr double kClocksDifferS = 1.0;

}  // namespace

bool aheadOfTheClock(const Arrival& arrival) {
  return arrival.stamp.toSec() - arrival.received.toSec() > kClocksDifferS;
}

std::uint64_t CloudInbox::accept(AcceptedCloud cloud, const ros::Time& now) {
  std::lock_guard<std::mutex> lock(mutex_);
  last_.kind = Arrival::Kind::kCloud;
  last_.dropped.clear();
  last_.stamp = cloud.message->header.stamp;
  last_.received = now;
  cloud.sequence = ++last_.sequence;
  last_.cloud = std::move(cloud);
  changed_.notify_all();
  return last_.sequence;
}

std::uint64_t CloudInbox::drop(const std::string& reason, const ros::Time& stamp, const ros::Time& now) {
  std::lock_guard<std::mutex> lock(mutex_);
  last_.kind = Arrival::Kind::kDropped;
  last_.cloud = {};
  last_.dropped = reason;
  last_.stamp = stamp;
  last_.received = now;
  ++last_.sequence;
  changed_.notify_all();
  return last_.sequence;
}

std::uint64_t CloudInbox::sequence() const {
  std::lock_guard<std::mutex> lock(mutex_);
  return last_.sequence;
}

Arrival CloudInbox::since(const ros::Time& not_before, const ros::Time& now) const {
  std::lock_guard<std::mutex> lock(mutex_);
  const bool wanted = last_.sequence > 0 && !not_before.isZero() && last_.stamp >= not_before;
  return wanted && last_.received <= now && !aheadOfTheClock(last_) ? last_ : Arrival();
}

Arrival CloudInbox::latest() const {
  std::lock_guard<std::mutex> lock(mutex_);
  return last_;
}

Arrival CloudInbox::waitAfter(std::uint64_t sequence, Deadline deadline) {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait_until(lock, deadline, [&] { return closed_ || last_.sequence > sequence; });
  Arrival arrival;
  if (closed_) {
    arrival.kind = Arrival::Kind::kClosed;
  } else if (last_.sequence > sequence) {
    arrival = last_;
  }
  return arrival;
}

void CloudInbox::close() {
  std::lock_guard<std::mutex> lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

}  // namespace mixed_palletizing::adapters
