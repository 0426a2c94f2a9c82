#include <utility>

#include <mixed_palletizing/adapters/camera_trigger.hpp>

namespace mixed_palletizing::adapters {

CameraTrigger::CameraTrigger(std::function<bool()> capture) : capture_(std::move(capture)) {}

CameraTrigger::~CameraTrigger() {
  if (thread_.joinable()) thread_.join();
}

CameraTrigger::Outcome CameraTrigger::trigger(Deadline deadline) {
  const std::shared_future<bool> answer = underWay();
  if (answer.wait_until(deadline) != std::future_status::ready) return Outcome::kNoAnswer;
  return answer.get() ? Outcome::kTriggered : Outcome::kRefused;
}

std::shared_future<bool> CameraTrigger::underWay() {
  std::lock_guard<std::mutex> lock(mutex_);
  const bool busy = answer_.valid() && answer_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
  if (busy) return answer_;
  if (thread_.joinable()) thread_.join();
  std::packaged_task<bool()> task(capture_);
  answer_ = task.get_future().share();
  thread_ = std::thread(std::move(task));
  return answer_;
}

}  // namespace mixed_palletizing::adapters
