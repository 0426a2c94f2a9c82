#include "event_json.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace mixed_palletizing::planning {
namespace {

TEST(EventJson, deepTextsAreRefused) {
  for (const char* part : {"[", "{\"a\":", "[{\"order\":["}) {
    std::string text;
    for (int i = 0; i < 100000; ++i) text += part;
    EXPECT_THROW(parseEvent(text), std::invalid_argument) << part;
  }
  EXPECT_EQ(parseEvent("{\"a\": [1, {\"b\": 2}]}").at("a").at(1).at("b").get<int>(), 2);
}

TEST(EventJson, anEventWithFewerOptionsThanTypesIsRefused) {
  const nlohmann::json body = parseEvent(
      R"({"request_id": "", "available": [0, 0, 1], "decision_id": 1, "message": "", "options": [{"feasible": false}]})");
  EXPECT_THROW(eventFromJson("decided", body), std::invalid_argument);
}

}  // namespace
}  // namespace mixed_palletizing::planning
