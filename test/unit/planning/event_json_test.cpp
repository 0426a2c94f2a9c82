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

TEST(EventJson, numbersThatAreNoWholeOnesOfTheirRangeAreRefused) {
  const auto reported = [](const std::string& id, const std::string& item) {
    return parseEvent("{\"decision_id\": " + id + ", \"outcome\": \"DISCARDED\", \"discarded\": [" + item +
                      "]}");
  };
  EXPECT_NO_THROW(eventFromJson("reported", reported("18446744073709551615", "3")));
  for (const char* number :
       {"1e128", "1.5", "-1", "-1e99", "18446744073709551616", "\"1\"", "null", "true"}) {
    EXPECT_THROW(eventFromJson("reported", reported(number, "3")), std::invalid_argument) << number;
    EXPECT_THROW(eventFromJson("reported", reported("1", number)), std::invalid_argument) << number;
  }
  for (const char* type : {"1e128", "2147483648", "-2147483649", "18446744073709551615"}) {
    const std::string measured =
        std::string("{\"type\": ") + type + ", \"origin_mm\": [0, 0, 0], \"size_mm\": [1, 1, 1]}";
    EXPECT_THROW(
        eventFromJson("reported", parseEvent("{\"decision_id\": 1, \"outcome\": \"PLACED\", \"discarded\": "
                                             "[], \"measured\": " +
                                             measured + "}")),
        std::invalid_argument)
        << type;
  }
}

}  // namespace
}  // namespace mixed_palletizing::planning
