#include <utility>

#include <mixed_palletizing/adapters/cloud_inbox.hpp>

namespace mixed_palletizing::adapters {

std::uint64_t CloudInbox::accept(AcceptedCloud cloud) {
  std::lock_guard<std::mutex> lock(mutex_);
  last_.kind = Arrival::Kind::kCloud;
  last_.dropped.clear();
  last_.stamp = cloud.message->header.stamp;
  cloud.sequence = ++last_.sequence;
  last_.cloud = std::move(cloud);
  changed_.notify_all();
  return last_.sequence;
}

std::uint64_t CloudInbox::drop(const std::string& reason, const ros::Time& stamp) {
  std::lock_guard<std::mutex> lock(mutex_);
  last_.kind = Arrival::Kind::kDropped;
  last_.cloud = {};
  last_.dropped = reason;
  last_.stamp = stamp;
  ++last_.sequence;
  changed_.notify_all();
  return last_.sequence;
}

std::uint64_t CloudInbox::sequence() const {
  std::lock_guard<std::mutex> lock(mutex_);
  return last_.sequence;
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
