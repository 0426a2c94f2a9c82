// CloudInbox and FaultCounter: what threads wait for and what is counted.
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include <boost/make_shared.hpp>
#include <gtest/gtest.h>

#include <mixed_palletizing/adapters/cloud_inbox.hpp>
#include <mixed_palletizing/adapters/fault_counter.hpp>

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
  EXPECT_EQ(inbox.accept(cloud(5)), 1u);
  EXPECT_EQ(inbox.latest().cloud.sequence, 1u);
  EXPECT_EQ(inbox.latest().stamp, ros::Time(5, 0));
  EXPECT_EQ(inbox.drop("bad", ros::Time(6, 0)), 2u);
  const Arrival dropped = inbox.latest();
  EXPECT_EQ(dropped.kind, Arrival::Kind::kDropped);
  EXPECT_EQ(dropped.dropped, "bad");
  EXPECT_FALSE(dropped.cloud.message);
  inbox.accept(cloud(7));
  EXPECT_TRUE(inbox.latest().dropped.empty());
}

TEST(CloudInbox, answersAtOnceWhenSomethingCame) {
  CloudInbox inbox;
  inbox.accept(cloud(1));
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
  inbox.accept(cloud(9));
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
