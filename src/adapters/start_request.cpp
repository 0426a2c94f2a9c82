#include <mixed_palletizing/adapters/pallet_messages.hpp>
#include <mixed_palletizing/adapters/start_request.hpp>
#include <mixed_palletizing/adapters/units.hpp>

namespace mixed_palletizing::adapters {

StartPalletRequest startRequest(const std::string& pallet_id, const packing::Order& order) {
  const packing::PalletRules& rules = order.rules;
  StartPalletRequest request;
  request.pallet_id = pallet_id;
  request.size.x = toMeters(rules.size.x);
  request.size.y = toMeters(rules.size.y);
  request.size.z = toMeters(rules.size.z);
  request.order = toLines(order);
  request.gap = toMeters(rules.gap);
  request.min_support_ratio = rules.min_support_ratio;
  return request;
}

}  // namespace mixed_palletizing::adapters
