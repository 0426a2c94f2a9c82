// Lets one allocation after the other fail in detections, decisions and packings: the failure must come out as
// an exception (or not matter), and the next answer must be the right one. Not in the simulated camera: there Embree ends
// the process.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <sstream>
#include <stdexcept>

#include <mixed_palletizing/adapters/command_line.hpp>
#include <mixed_palletizing/detection/box_detector.hpp>
#include <mixed_palletizing/packing/order_packing.hpp>
#include <mixed_palletizing/planning/pallet_session.hpp>
#include <mixed_palletizing/simulation/capture.hpp>

#include "../unit/planning/support.hpp"
#include "../unit/simulation/small_scenes.hpp"
#include "failing_new.hpp"
#include "tally.hpp"

namespace {

using namespace mixed_palletizing;

/// Something that is asked for again and again, and its answer as a text.
struct Job {
  std::string name;
  std::function<std::string()> answer;
};

/// A stream that tells of running out of memory: by itself it would write less.
std::ostringstream strictText() {
  std::ostringstream text;
  text.exceptions(std::ios::badbit | std::ios::failbit);
  return text;
}

std::string textOf(const packing::Placement& p) {
  std::ostringstream text = strictText();
  text << p.type << ':' << p.origin.x << ',' << p.origin.y << ',' << p.origin.z << ',' << p.size.x << ' ';
  return text.str();
}

constexpr int kCloudWidth = 160;

Job detection(const char* name, detection::Method method, detection::Mode mode, std::uint64_t seed) {
  auto scene = std::make_shared<simulation::Scene>(simulation::smallScene(seed, kCloudWidth));
  auto capture = std::make_shared<simulation::Capture>(simulation::capture(*scene, seed));
  detection::DetectionOptions options;
  options.method = method;
  options.mode = mode;
  auto detector = std::make_shared<detection::BoxDetector>(options);
  return {name, [=] {
            const auto found = detector->detect(capture->cloud.view(), scene->camera.world_from_camera);
            std::ostringstream text = strictText();
            text << found.rejected.size();
            for (const auto& box : found.boxes) {
              text << " [" << box.center.transpose() << "; " << box.size.transpose() << "; " << box.yaw_rad
                   << ']';
            }
            return text.str();
          }};
}

Job decision(const char* name, int threads, bool ponder, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  const packing::Order order = planning::test::randomOrder(rng);
  std::vector<int> visible = planning::test::shuffledItems(order, rng);
  visible.resize(std::min<std::size_t>(visible.size(), 3));
  planning::PlannerOptions options;
  options.best.threads = threads;
  options.best.samples = 2;
  options.best.candidates = 3;
  auto session = std::make_shared<planning::PalletSession>(options);
  session->start("p", order, false);
  if (ponder) session->ponder();
  return {name, [=] {
            const planning::ChooseReply reply = session->choose(
                "", visible, [] { return false; }, 0.0, {}, 1.0);
            std::string text = reply.decision.chosen ? std::to_string(*reply.decision.chosen) + " " : "none ";
            for (const auto& option : reply.decision.options) text += textOf(option.placement);
            return text + std::to_string(session->revision());
          }};
}

Job packing(packing::PackMethod method, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  packing::Order order = planning::test::randomOrder(rng);
  order.rules.gap = 0;
  const std::vector<int> items = planning::test::shuffledItems(order, rng);
  packing::PackOptions options;
  options.method = method;
  options.threads = 2;
  options.key_genetic.population = 12;
  options.key_genetic.generations = 2;
  options.genetic.generations = 2;
  return {"packing", [=] {
            // Two copies of this count apart, each in its thread.
            const auto stop = [asked = 0]() mutable { return ++asked > 60; };
            std::string text;
            for (const auto& item : packing::packOrder(order, items, options, stop).packed) {
              text += textOf(item.placement);
            }
            return text;
          }};
}

/// Empty, or what went wrong when the `n`-th allocation failed.
std::string faultAt(const Job& job, long n, const std::string& right) {
  std::string thrown;
  std::string answer = right;
  torture::failAllocation(n);
  try {
    answer = job.answer();
  } catch (const std::exception& error) {
    thrown = error.what();
  }
  const bool failed = torture::stopFailing();
  if (!thrown.empty() && !failed) return "threw without need: " + thrown;
  if (answer != right) return "another answer";
  return job.answer() == right ? "" : "another answer afterwards";
}

torture::Cases failEach(const Job& job, long tries) {
  torture::Cases cases;
  const std::string right = job.answer();
  const long before = torture::allocations();
  if (job.answer() != right) throw std::logic_error(job.name + ": gives two answers");
  const long all = torture::allocations() - before;
  const long step = std::max(1L, all / std::max(1L, tries));
  for (long n = 1; n <= all; n += step) {
    const std::string fault = faultAt(job, n, right);
    cases.add(fault.empty() ? "" : job.name + ", allocation " + std::to_string(n) + ": " + fault);
  }
  std::printf("%-28s %7ld allocations, %6ld failed one at a time, %ld lost\n", job.name.c_str(), all,
              cases.tried, cases.lost);
  if (cases.lost > 0) std::printf("first lost: %s\n", cases.first_lost.c_str());
  std::fflush(stdout);
  return cases;
}

std::vector<Job> jobs(std::uint64_t seed) {
  using detection::Method;
  using detection::Mode;
  return {detection("detection", Method::kBest, Mode::kPalletize, seed),
          detection("detection in stacks", Method::kBest, Mode::kDepalletize, seed),
          detection("detection of the thesis", Method::kThesis, Mode::kPalletize, seed),
          decision("decision", 1, false, seed),
          decision("decision on two threads", 2, false, seed),
          decision("decision while thinking ahead", 1, true, seed),
          packing(packing::PackMethod::kBrkga, seed),
          packing(packing::PackMethod::kBest, seed)};
}

}  // namespace

int main(int argc, char** argv) {
  int tries = 1000;
  std::string only;
  std::uint64_t seed = 1;
  adapters::CommandLine line("out_of_memory", "Lets one allocation after the other fail.");
  line.option("tries", &tries, "allocations of each job, spread evenly over all of it");
  line.option("only", &only, "one of the jobs by its name");
  line.option("seed", &seed, "of clouds and orders");
  return line.run(argc, argv, [&] {
    if (tries < 1) throw std::invalid_argument("tries: at least 1");
    torture::Cases all;
    for (const Job& job : jobs(seed)) {
      if (!only.empty() && job.name != only) continue;
      const torture::Cases cases = failEach(job, tries);
      all.tried += cases.tried;
      all.lost += cases.lost;
      if (all.first_lost.empty()) all.first_lost = cases.first_lost;
    }
    return torture::report("out of memory", all);
  });
}
