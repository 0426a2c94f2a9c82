// Source: BSG, the beam search of Araya and Riff (2014), on supported maximal spaces.
//   1. A state is a pallet with some blocks. The space to fill is the first in the order of SpaceOrder that can hold
//      a remaining item; blocks go to its corner nearest to a corner of the pallet.
//   2. Every state of a level has as successors the `width` best blocks for its space, in two spaces at a time.
//   3. A successor is worth the volume packed when it is completed greedily, always with the best block.
//   4. The `width` best successors form the next level; equal pallets count once.
#include "block_search.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <unordered_set>

#include "block.hpp"
#include "block_scorer.hpp"
#include "block_state.hpp"

namespace mixed_palletizing::packing {

namespace {

constexpr std::size_t kSpacesTried = 2;  ///< of a state, when its successors are made

constexpr std::size_t kSpareWidths = 4;  ///< successors kept, in widths, before the best are picked

struct Node {
  BlockState state;
  std::int64_t outcome = 0;           ///< volume of the greedy completion
  std::vector<BlockStep> completion;  ///< its steps from the empty pallet on
};

void keepBest(std::vector<Node>& nodes, std::size_t count) {
  std::stable_sort(nodes.begin(), nodes.end(),
                   [](const Node& a, const Node& b) { return a.outcome > b.outcome; });
  while (nodes.size() > count) nodes.pop_back();
}

}  // namespace

class BlockSearch::Impl {
 public:
  Impl(const Vec3& pallet, const std::vector<ItemType>& types, const std::vector<int>& counts,
       const BlockSearchOptions& options)
      : catalog_(makeCatalog(pallet, types, counts, options.max_blocks, weights_.items_exponent)),
        lengths_(catalog_, counts),
        scorer_(catalog_, lengths_, weights_),
        root_(catalog_, counts) {
    for (std::size_t t = 0; t < types.size(); ++t) all_items_ += counts[t] * volume(types[t].size);
  }

  bool run(SpaceOrder order, std::size_t width, const StopCallback& stop) {
    order_ = order;
    last_volume_ = 0;
    std::vector<Node> level{{root_, -1, {}}};
    while (!level.empty() && !complete()) {
      std::vector<Node> next;
      std::unordered_set<std::uint64_t> seen;
      for (const Node& node : level) {
        if (!expand(node, width, stop, seen, next)) return false;
        if (next.size() > kSpareWidths * width) keepBest(next, width);
      }
      keepBest(next, width);
      level = std::move(next);
    }
    return true;
  }

  std::int64_t bestVolume() const { return best_volume_; }
  std::int64_t lastVolume() const { return last_volume_; }
  bool complete() const { return best_volume_ == all_items_; }

  std::vector<Placement> bestPlacements() const {
    std::vector<Placement> placements;
    for (const BlockStep& step : best_) appendItems(catalog_.blocks, step.block, step.origin, placements);
    return placements;
  }

 private:
  /// Appends the successors of a node; false when the search has to end.
  bool expand(const Node& node, std::size_t width, const StopCallback& stop,
              std::unordered_set<std::uint64_t>& seen, std::vector<Node>& next) {
    std::size_t share = width;
    bool follows_parent =
        node.outcome >= 0;  // the first successor is the first step of the parent's completion
    for (const AnchoredSpace& where : firstSpaces(node.state, kSpacesTried)) {
      const std::vector<ScoredBlock> blocks = scorer_.best(node.state, where, share);
      for (const ScoredBlock& scored : blocks) {
        if (complete() || (!best_.empty() && stop && stop())) return false;
        Node child{node.state, node.outcome, node.completion};
        child.state.place(catalog_, stepInto(where, scored));
        if (seen.insert(child.state.fingerprint()).second) {
          if (!follows_parent) evaluate(child);
          next.push_back(std::move(child));
        }
        follows_parent = false;
      }
      share = std::max<std::size_t>(1, share / 2);
    }
    return true;
  }

  void evaluate(Node& node) {
    BlockState state = node.state;
    while (const auto where = firstSpace(state)) {
      state.place(catalog_, stepInto(*where, scorer_.best(state, *where, 1).front()));
    }
    node.outcome = state.packedVolume();
    node.completion = state.steps();
    last_volume_ = std::max(last_volume_, node.outcome);
    if (node.outcome <= best_volume_) return;
    best_volume_ = node.outcome;
    best_ = node.completion;
  }

  BlockStep stepInto(const AnchoredSpace& where, const ScoredBlock& scored) const {
    return {scored.block, where.originOf(catalog_.blocks[scored.block].size)};
  }

  using Rank = std::tuple<std::int64_t, std::int64_t>;

  AnchoredSpace anchored(const Space& space) const {
    return {space, catalog_.pallet.x - space.max.x < space.min.x,
            catalog_.pallet.y - space.max.y < space.min.y};
  }

  Rank rankOf(const Space& space) const {
    const std::int64_t x = std::min(space.min.x, catalog_.pallet.x - space.max.x);
    const std::int64_t y = std::min(space.min.y, catalog_.pallet.y - space.max.y);
    const std::int64_t z = space.min.z;
    const std::int64_t distance = x + y + (order_ == SpaceOrder::kLowest ? z * 4 * kMaxPalletLength : z);
    return {distance, -volume(space.size())};
  }

  std::optional<AnchoredSpace> firstSpace(const BlockState& state) const {
    const Space* first = nullptr;
    Rank first_rank{};
    for (const Space& space : state.spaces()) {
      const Rank rank = rankOf(space);
      if ((first != nullptr && rank >= first_rank) || !state.isUseful(space)) continue;
      first = &space;
      first_rank = rank;
    }
    return first == nullptr ? std::nullopt : std::make_optional(anchored(*first));
  }

  std::vector<AnchoredSpace> firstSpaces(const BlockState& state, std::size_t count) const {
    std::vector<const Space*> useful;
    for (const Space& space : state.spaces()) {
      if (state.isUseful(space)) useful.push_back(&space);
    }
    std::stable_sort(useful.begin(), useful.end(),
                     [this](const Space* a, const Space* b) { return rankOf(*a) < rankOf(*b); });
    std::vector<AnchoredSpace> spaces;
    for (std::size_t i = 0; i < std::min(count, useful.size()); ++i) spaces.push_back(anchored(*useful[i]));
    return spaces;
  }

  ScoreWeights weights_;
  BlockCatalog catalog_;
  ReachableLengths lengths_;
  BlockScorer scorer_;
  BlockState root_;
  SpaceOrder order_ = SpaceOrder::kNearest;
  std::int64_t all_items_ = 0;
  std::int64_t best_volume_ = 0;
  std::int64_t last_volume_ = 0;
  std::vector<BlockStep> best_;
};

BlockSearch::BlockSearch(const Vec3& pallet, const std::vector<ItemType>& types,
                         const std::vector<int>& counts, const BlockSearchOptions& options)
    : impl_(std::make_unique<Impl>(pallet, types, counts, options)) {}

BlockSearch::~BlockSearch() = default;

bool BlockSearch::run(SpaceOrder order, std::size_t width, const StopCallback& stop) {
  return impl_->run(order, width, stop);
}

std::int64_t BlockSearch::bestVolume() const { return impl_->bestVolume(); }
std::int64_t BlockSearch::lastVolume() const { return impl_->lastVolume(); }
bool BlockSearch::complete() const { return impl_->complete(); }
std::vector<Placement> BlockSearch::bestPlacements() const { return impl_->bestPlacements(); }

}  // namespace mixed_palletizing::packing
