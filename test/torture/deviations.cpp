#include <cmath>

#include <mixed_palletizing/adapters/message_parts.hpp>
#include <mixed_palletizing/adapters/pallet_messages.hpp>
#include <mixed_palletizing/adapters/planner_options.hpp>
#include <mixed_palletizing/planning/pallet_session.hpp>

#include "../unit/planning/support.hpp"
#include "invariants.hpp"
#include "standing_check.hpp"

namespace mixed_palletizing::torture {
namespace {

using packing::Placement;
using planning::PickOutcome;
using planning::test::draw;

constexpr double kMostMm = 50.0;
constexpr double kMostDegrees = 10.0;
constexpr double kNoiseM = 1e-9;  ///< nearer to a tolerance than this, either side of it is right

double uniform(std::mt19937_64& rng, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(rng);
}

/// A pallet, its planner, and what really stands there.
class Pallet {
 public:
  explicit Pallet(std::uint64_t seed)
      : rng_(seed), order_(planning::test::randomOrder(rng_)), session_(planner()) {
    if (draw(rng_, 0, 3) == 0) {
      for (packing::ItemType& type : order_.types) type.max_load_kg = draw(rng_, 0, 1) * draw(rng_, 5, 60);
    }
    session_.start("p", order_, false);
  }

  bool complete() const { return session_.complete(); }
  const char* kind() const { return kind_; }  ///< what happened last

  /// One deviation; empty, or what went wrong.
  std::string step() {
    const std::string fault = happens();
    if (!fault.empty()) return fault;
    if (!(session_.pallet()->placements() == standing_)) return "the planner knows another pallet";
    return unsound(order_, standing_);
  }

 private:
  planning::PlannerOptions planner() {
    planning::PlannerOptions options;
    options.method = draw(rng_, 0, 1) == 0 ? planning::PlanMethod::kDblf : planning::PlanMethod::kBest;
    options.best.samples = 1;
    options.best.candidates = 2;
    return options;
  }

  std::string happens() {
    const int what = draw(rng_, 0, 9);
    if (what == 0 && last_was_placed_) return fellOff();
    if (what == 1) return added();
    visible_ = planning::test::shuffledItems({order_.rules, order_.types, session_.remaining()}, rng_);
    visible_.resize(std::min<std::size_t>(visible_.size(), static_cast<std::size_t>(draw(rng_, 1, 4))));
    reply_ = session_.choose("", visible_, {});
    if (const std::string fault = planFault(); !fault.empty()) return fault;
    if (!reply_.decision.chosen) return discarded();
    planned_ = reply_.decision.options[*reply_.decision.chosen].placement;
    if (what == 2) return missing();
    if (what == 3) return swappedBoxes();
    if (what == 4) return swappedDecisions();
    return putDown();
  }

  /// Every place that the planner names keeps all rules on what really stands there.
  std::string planFault() const {
    if (reply_.decision.options.size() != visible_.size()) return "no answer: " + reply_.message;
    for (const planning::PickOption& option : reply_.decision.options) {
      if (!option.feasible) continue;
      std::vector<Placement> then = standing_;
      then.push_back(option.placement);
      const std::string fault = unsound(order_, then);
      if (!fault.empty()) return "a plan breaks a rule: " + fault;
    }
    return "";
  }

  std::string report(PickOutcome outcome, const std::optional<Placement>& measured = {},
                     const std::vector<std::size_t>& indices = {}) {
    const planning::SessionReply reply = session_.report(reply_.decision_id, outcome, measured, indices);
    if (!reply.ok()) return reply.message.empty() ? "refused without a word" : reply.message;
    if (outcome == PickOutcome::kPlaced) standing_.push_back(measured.value_or(planned_));
    if (outcome != PickOutcome::kFailed) last_was_placed_ = outcome == PickOutcome::kPlaced;
    return "";
  }

  /// A report or request that must be refused: says so, and changes nothing.
  std::string refused(const std::string& answer, std::uint64_t revision, const char* what) const {
    if (answer.empty()) return std::string(what) + " was not noticed";
    return session_.revision() == revision ? "" : std::string(what) + " changed the pallet";
  }

  std::string putDown() {
    kind_ = "put down within the tolerances";
    const double angle = uniform(rng_, 0.0, draw(rng_, 0, 1) == 0 ? kMostDegrees : 2.0) * M_PI / 180.0;
    const double away = uniform(rng_, 0.0, draw(rng_, 0, 2) == 0 ? 6.0 : kMostMm) * 1e-3;
    const double direction = uniform(rng_, 0.0, 2.0 * M_PI);
    const double lifted = draw(rng_, 0, 3) == 0 ? uniform(rng_, -away, away) : 0.0;
    const Eigen::Vector3d offset(away * std::cos(direction), away * std::sin(direction), lifted);
    const Eigen::Vector3d corner =
        1e-3 * Eigen::Vector3d(planned_.origin.x, planned_.origin.y, planned_.origin.z) + offset;
    const Eigen::Vector3d half = 0.5e-3 * Eigen::Vector3d(planned_.size.x, planned_.size.y, planned_.size.z);
    const adapters::MeasuredPlacement measured = adapters::measuredPlacement(
        adapters::poseMessage(geometry::poseFromYaw(corner + half, angle)), planned_,
        tolerances_.position_tolerance_m, tolerances_.angle_tolerance_rad);
    const std::uint64_t revision = session_.revision();
    if (std::abs(angle - tolerances_.angle_tolerance_rad) < kNoiseM ||
        std::abs(offset.cwiseAbs().maxCoeff() - tolerances_.position_tolerance_m) < kNoiseM) {
      return "";
    }
    if (angle > tolerances_.angle_tolerance_rad) {
      kind_ = "turned beyond the tolerance: refused";
      const std::string fault = refused(measured.placement ? "" : measured.problem, revision, "a turned box");
      return fault.empty() ? report(PickOutcome::kFailed) : fault;
    }
    if (!measured.placement) return "refused within the tolerance of angles: " + measured.problem;
    const bool within = offset.cwiseAbs().maxCoeff() < tolerances_.position_tolerance_m;
    if (within != (*measured.placement == planned_)) return "the tolerance of positions is not kept";
    if (within) return report(PickOutcome::kPlaced);
    return putDownAt(*measured.placement, corner);
  }

  /// Beyond the tolerance: stands in the planner's books where it is, or is refused because it may not stay there.
  std::string putDownAt(const Placement& measured, const Eigen::Vector3d& corner) {
    const Eigen::Vector3d origin(measured.origin.x, measured.origin.y, measured.origin.z);
    if ((1e-3 * origin - corner).cwiseAbs().maxCoeff() > 0.5e-3 + kNoiseM) return "measured elsewhere";
    std::vector<Placement> then = standing_;
    then.push_back(measured);
    const std::string rule = unsound(order_, then);
    const std::uint64_t revision = session_.revision();
    kind_ =
        rule.empty() ? "moved beyond the tolerance: planned around" : "moved beyond the tolerance: refused";
    const std::string answer = report(PickOutcome::kPlaced, measured);
    if (rule.empty()) return answer.empty() ? "" : "a sound place is refused: " + answer;
    const std::string fault = refused(answer, revision, "a box that may not stay");
    if (!fault.empty()) return fault;
    // Put right by hand, or taken away again.
    return draw(rng_, 0, 1) == 0 ? report(PickOutcome::kPlaced) : report(PickOutcome::kFailed);
  }

  std::string missing() {
    kind_ = "missing";
    const std::vector<int> before = session_.remaining();
    const std::size_t chosen = *reply_.decision.chosen;
    const bool lost = draw(rng_, 0, 1) == 0;
    const std::string fault =
        lost ? report(PickOutcome::kDiscarded, {}, {chosen}) : report(PickOutcome::kFailed);
    if (!fault.empty()) return "a missing box: " + fault;
    std::vector<int> expected = before;
    if (lost) --expected[static_cast<std::size_t>(visible_[chosen])];
    return session_.remaining() == expected ? "" : "a missing box is counted wrongly";
  }

  std::string swappedBoxes() {
    kind_ = "swapped for another";
    const std::uint64_t revision = session_.revision();
    Placement other = planned_;
    other.type = draw(rng_, 0, static_cast<int>(order_.types.size()));
    if (other.type == planned_.type) return report(PickOutcome::kPlaced);
    if (static_cast<std::size_t>(other.type) < order_.types.size()) {
      other.size = order_.types[static_cast<std::size_t>(other.type)].size;
    }
    const std::string fault = refused(report(PickOutcome::kPlaced, other), revision, "a swapped box");
    return fault.empty() ? report(PickOutcome::kFailed) : fault;
  }

  /// The report of one decision after that of another.
  std::string swappedDecisions() {
    kind_ = "reported for a decision out of date";
    const planning::ChooseReply first = reply_;
    reply_ = session_.choose("", visible_, {});
    if (!reply_.decision.chosen) return "the same question has another answer";
    planned_ = reply_.decision.options[*reply_.decision.chosen].placement;
    if (const std::string fault = report(PickOutcome::kPlaced); !fault.empty()) return fault;
    const std::uint64_t revision = session_.revision();
    const planning::SessionReply late = session_.report(first.decision_id, PickOutcome::kPlaced, {}, {});
    return refused(late.ok() ? "" : late.message, revision, "a decision out of date");
  }

  /// More boxes than the order has, or one of no type of it.
  std::string added() {
    kind_ = "added";
    const std::uint64_t revision = session_.revision();
    const int type = draw(rng_, 0, static_cast<int>(order_.types.size()));
    std::vector<int> visible{type};
    if (static_cast<std::size_t>(type) < order_.types.size()) {
      visible.resize(static_cast<std::size_t>(session_.remaining()[static_cast<std::size_t>(type)]) + 1,
                     type);
    }
    const planning::ChooseReply reply = session_.choose("", visible, {});
    const bool answered = reply.status == planning::ChooseStatus::kPick;
    return refused(answered ? "" : reply.message, revision, "an added box");
  }

  std::string fellOff() {
    kind_ = "fell off again";
    std::vector<int> expected = session_.remaining();
    ++expected[static_cast<std::size_t>(standing_.back().type)];
    if (!session_.undoLast().ok()) return "a box that fell off is not taken back";
    standing_.pop_back();
    last_was_placed_ = false;  // not known
    return session_.remaining() == expected ? "" : "a box that fell off is counted wrongly";
  }

  std::string discarded() {
    kind_ = "none fits: discarded";
    const std::string fault = report(PickOutcome::kDiscarded);
    return fault.empty() ? "" : "none fits, yet they cannot be discarded: " + fault;
  }

  const adapters::PickPlannerOptions tolerances_;
  std::mt19937_64 rng_;
  packing::Order order_;
  planning::PalletSession session_;
  std::vector<Placement> standing_;
  bool last_was_placed_ = false;  ///< the last change was a box put down
  const char* kind_ = "";
  std::vector<int> visible_;
  planning::ChooseReply reply_;
  Placement planned_;
};

}  // namespace

Cases deviate(long deviations, std::uint64_t seed) {
  constexpr int kMostSteps = 100;
  Cases cases;
  for (std::uint64_t s = seed; cases.tried < deviations; ++s) {
    Pallet pallet(s);
    for (int step = 0; step < kMostSteps && cases.tried < deviations && !pallet.complete(); ++step) {
      const std::string fault = pallet.step();
      ++cases.kinds[pallet.kind()];
      cases.add(
          fault.empty() ? "" : "seed " + std::to_string(s) + ", step " + std::to_string(step) + ": " + fault);
      if (!fault.empty()) break;
    }
  }
  return cases;
}

}  // namespace mixed_palletizing::torture
