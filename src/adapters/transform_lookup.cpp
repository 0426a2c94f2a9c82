#include <chrono>
#include <cmath>
#include <thread>

#include <tf2/exceptions.h>

#include <mixed_palletizing/adapters/message_parts.hpp>
#include <mixed_palletizing/adapters/transform_lookup.hpp>

namespace mixed_palletizing::adapters {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPoll(5);

bool usable(const geometry_msgs::Transform& transform) {
  const auto& t = transform.translation;
  return std::isfinite(t.x) && std::isfinite(t.y) && std::isfinite(t.z) && isRotation(transform.rotation);
}

}  // namespace

FoundTransform lookUpTransform(const tf2::BufferCore& buffer, const std::string& target,
                               const std::string& source, const ros::Time& stamp, double timeout_s) {
  const auto deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(timeout_s));
  for (;;) {
    FoundTransform found;
    try {
      found.transform = buffer.lookupTransform(target, source, stamp);
      if (usable(found.transform->transform)) return found;
      found.transform.reset();
      found.problem = "the transform from '" + source + "' to '" + target + "' is not finite or no rotation";
    } catch (const tf2::TransformException& error) {
      found.problem = error.what();
    }
    if (Clock::now() >= deadline) return found;
    std::this_thread::sleep_for(kPoll);
  }
}

}  // namespace mixed_palletizing::adapters
