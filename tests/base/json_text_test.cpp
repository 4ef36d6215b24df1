#include "base/json_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace limbwave {
namespace {

TEST(JsonText, IsWhatItWas) {
  const nlohmann::json json = {{"a", {1, 2.5, nullptr}}, {"name", "Jürgen \"J\" \n"}};
  EXPECT_EQ(nlohmann::json::parse(json_text(json)), json);
  EXPECT_EQ(json_text({{"a", 1}}), "{\"a\":1}");
  EXPECT_EQ(json_text({{"a", 1}}, 2), "{\n  \"a\": 1\n}");
}

TEST(JsonText, BytesThatAreNotUtf8AreReplaced) {
  const nlohmann::json json = {{"file", "caf\xE9.bvh"}};
  std::string text;
  ASSERT_NO_THROW(text = json_text(json));
  EXPECT_EQ(nlohmann::json::parse(text)["file"], "caf\xEF\xBF\xBD.bvh");
}

}  // namespace
}  // namespace limbwave
