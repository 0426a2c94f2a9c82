// One topic as another, for as long as somebody listens.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include <ros/node_handle.h>

namespace mixed_palletizing::converters {

/// Subscribes to `from` only while `to` has subscribers: the detector computes nothing for nobody. For a spinner of
/// one thread.
template <typename From, typename To>
class TopicConverter {
 public:
  using Convert = std::function<typename To::Ptr(const From&)>;

  TopicConverter(const ros::NodeHandle& node, const std::string& from, const std::string& to, Convert convert)
      : node_(node), from_(from), convert_(std::move(convert)) {
    const auto follow = [this](const ros::SingleSubscriberPublisher&) { followSubscribers(); };
    publisher_ = node_.advertise<To>(to, kQueue, follow, follow);
  }
  TopicConverter(const TopicConverter&) = delete;
  TopicConverter& operator=(const TopicConverter&) = delete;

 private:
  static constexpr std::uint32_t kQueue = 10;

  void followSubscribers() {
    const bool wanted = publisher_.getNumSubscribers() > 0;
    if (wanted && !subscriber_) {
      subscriber_ = node_.subscribe<From>(from_, kQueue, [this](const typename From::ConstPtr& message) {
        publisher_.publish(convert_(*message));
      });
    } else if (!wanted) {
      subscriber_.shutdown();
    }
  }

  ros::NodeHandle node_;
  std::string from_;
  Convert convert_;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace mixed_palletizing::converters
