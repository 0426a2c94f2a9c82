// CloudInbox and FaultCounter: what threads wait for and what is counted.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <thread>
#include <vector>

#include <boost/make_shared.hpp>
#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/camera_trigger.hpp>
#include <mixed_palletizing/adapters/cloud_inbox.hpp>
#include <mixed_palletizing/adapters/fault_counter.hpp>
#include <mixed_palletizing/adapters/master_watch.hpp>

namespace mixed_palletizing::adapters {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

AcceptedCloud cloud(unsigned stamp_s) {
  auto message = boost::make_shared<sensor_msgs::PointCloud2>();
  message->header.stamp = ros::Time(stamp_s, 0);
  AcceptedCloud accepted;
  accepted.message = message;
  return accepted;
}

TEST(CloudInbox, remembersTheLastArrival) {
  CloudInbox inbox;
  EXPECT_EQ(inbox.sequence(), 0u);
  EXPECT_EQ(inbox.latest().kind, Arrival::Kind::kTimeout);
  EXPECT_EQ(inbox.accept(cloud(5), ros::Time(100, 0)), 1u);
  EXPECT_EQ(inbox.latest().cloud.sequence, 1u);
  EXPECT_EQ(inbox.latest().stamp, ros::Time(5, 0));
  EXPECT_EQ(inbox.drop("bad", ros::Time(6, 0), ros::Time(100, 0)), 2u);
  const Arrival dropped = inbox.latest();
  EXPECT_EQ(dropped.kind, Arrival::Kind::kDropped);
  EXPECT_EQ(dropped.dropped, "bad");
  EXPECT_FALSE(dropped.cloud.message);
  inbox.accept(cloud(7), ros::Time(100, 0));
  EXPECT_TRUE(inbox.latest().dropped.empty());
}

TEST(CloudInbox, anArrivalFromBeforeTheClockWentBackIsNoAnswer) {
  CloudInbox inbox;
  const ros::Time noon(43200, 0);
  const ros::Time morning(39600, 0);
  EXPECT_EQ(inbox.since(morning, noon).kind, Arrival::Kind::kTimeout);
  inbox.accept(cloud(43199), noon);
  EXPECT_EQ(inbox.since(ros::Time(43199, 0), noon).kind, Arrival::Kind::kCloud);
  EXPECT_EQ(inbox.since(noon, noon).kind, Arrival::Kind::kTimeout);
  EXPECT_EQ(inbox.since(ros::Time(), noon).kind, Arrival::Kind::kTimeout);
  // Put back by an hour: the stamp is later than all that is asked for, but the cloud is old.
  EXPECT_EQ(inbox.since(morning, morning).kind, Arrival::Kind::kTimeout);
  inbox.accept(cloud(39601), ros::Time(39602, 0));
  EXPECT_EQ(inbox.since(morning, ros::Time(39602, 0)).stamp, ros::Time(39601, 0));
}

TEST(CloudInbox, aCloudFromTheFutureAnswersNoWishForANewOne) {
  CloudInbox inbox;
  const ros::Time noon(43200, 0);
  inbox.accept(cloud(43200 + 1), noon);
  EXPECT_EQ(inbox.since(noon, noon).kind, Arrival::Kind::kCloud);
  inbox.accept(cloud(43200 + 5), noon);
  EXPECT_EQ(inbox.since(noon, noon).kind, Arrival::Kind::kTimeout);
  EXPECT_TRUE(aheadOfTheClock(inbox.latest()));
}

TEST(CameraTrigger, tellsWhatTheCameraDid) {
  bool answer = true;
  CameraTrigger trigger([&] { return answer; });
  const auto deadline = steady_clock::now() + std::chrono::seconds(60);
  EXPECT_EQ(trigger.trigger(deadline), CameraTrigger::Outcome::kTriggered);
  answer = false;
  EXPECT_EQ(trigger.trigger(deadline), CameraTrigger::Outcome::kRefused);
}

TEST(CameraTrigger, doesNotWaitForACameraThatHangs) {
  std::promise<void> freed;
  std::atomic<int> captures{0};
  CameraTrigger trigger([&, wait = freed.get_future().share()] {
    ++captures;
    wait.wait();
    return true;
  });
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(trigger.trigger(steady_clock::now()), CameraTrigger::Outcome::kNoAnswer);
  }
  freed.set_value();
  const auto deadline = steady_clock::now() + std::chrono::seconds(60);
  EXPECT_EQ(trigger.trigger(deadline), CameraTrigger::Outcome::kTriggered);
  EXPECT_LE(captures, 2);  // one thread however many callers
}

/// What the watch did with these answers of the master, the last one again and again.
struct Watched {
  explicit Watched(const std::vector<MasterState>& answers, std::size_t wait_for) {
    std::atomic<std::size_t> asked{0};
    MasterWatch watch([this] { ++ends; },
                      [&] { return answers[std::min<std::size_t>(asked++, answers.size() - 1)]; },
                      milliseconds(1));
    while (asked < wait_for && !watch.forgotten()) std::this_thread::sleep_for(milliseconds(1));
    forgotten = watch.forgotten();
  }
  std::atomic<int> ends{0};
  bool forgotten = false;
};

TEST(MasterWatch, endsOnceWhenTheMasterForgot) {
  const Watched watched({MasterState::kKnowsUs, MasterState::kAway, MasterState::kForgot}, 1000000);
  EXPECT_TRUE(watched.forgotten);
  EXPECT_EQ(watched.ends, 1);
}

TEST(MasterWatch, outlastsAMasterThatIsAway) {
  const Watched watched({MasterState::kAway, MasterState::kForgot, MasterState::kAway, MasterState::kKnowsUs},
                        20);
  EXPECT_FALSE(watched.forgotten);
  EXPECT_EQ(watched.ends, 0);
}

TEST(CloudInbox, answersAtOnceWhenSomethingCame) {
  CloudInbox inbox;
  inbox.accept(cloud(1), ros::Time(100, 0));
  EXPECT_EQ(inbox.waitAfter(0, steady_clock::now()).kind, Arrival::Kind::kCloud);
  EXPECT_EQ(inbox.waitAfter(1, steady_clock::now()).kind, Arrival::Kind::kTimeout);
}

TEST(CloudInbox, wakesEveryoneForANewCloud) {
  CloudInbox inbox;
  std::vector<std::thread> threads;
  std::vector<Arrival> arrivals(4);
  const auto deadline = steady_clock::now() + std::chrono::seconds(60);
  for (Arrival& arrival : arrivals) {
    threads.emplace_back([&inbox, &arrival, deadline] { arrival = inbox.waitAfter(0, deadline); });
  }
  inbox.accept(cloud(9), ros::Time(100, 0));
  for (std::thread& thread : threads) thread.join();
  for (const Arrival& arrival : arrivals) {
    EXPECT_EQ(arrival.kind, Arrival::Kind::kCloud);
    EXPECT_EQ(arrival.stamp, ros::Time(9, 0));
  }
}

TEST(CloudInbox, closingEndsAllWaiting) {
  CloudInbox inbox;
  Arrival arrival;
  std::thread waiting([&] { arrival = inbox.waitAfter(0, steady_clock::now() + std::chrono::seconds(60)); });
  inbox.close();
  waiting.join();
  EXPECT_EQ(arrival.kind, Arrival::Kind::kClosed);
  EXPECT_EQ(inbox.waitAfter(0, steady_clock::now() + std::chrono::seconds(60)).kind, Arrival::Kind::kClosed);
}

TEST(FaultCounter, warnsOncePerReasonAndInterval) {
  std::vector<std::string> lines;
  FaultCounter counter([&](const std::string& line) { lines.push_back(line); }, std::chrono::hours(1));
  for (int i = 0; i < 5; ++i) counter.count("empty", "0 x 0");
  counter.count("mirrored", "x");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], "empty: 0 x 0");
  EXPECT_EQ(counter.counts().at("empty"), 5u);
  EXPECT_EQ(counter.total(), 6u);
}

TEST(FaultCounter, saysHowManyItKeptToItself) {
  std::vector<std::string> lines;
  FaultCounter counter([&](const std::string& line) { lines.push_back(line); }, milliseconds(0));
  counter.count("a", "x");
  counter.count("a", "x");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[1], "a: x");
}

TEST(FaultCounter, countsFromManyThreads) {
  std::atomic<int> warnings{0};
  FaultCounter counter([&](const std::string&) { ++warnings; }, std::chrono::hours(1));
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&] {
      for (int i = 0; i < 1000; ++i) counter.count("reason", "m");
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(counter.total(), 4000u);
  EXPECT_EQ(warnings, 1);
}

}  // namespace
}  // namespace mixed_palletizing::adapters
