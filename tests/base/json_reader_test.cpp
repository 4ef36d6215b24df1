#include "base/json_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limbwave {
namespace {

using testing::HasSubstr;

struct Fixture {
  explicit Fixture(const char* text) : json(nlohmann::json::parse(text)) {}
  nlohmann::json json;
  JsonReader::State state{"rig.json", {}};
  JsonReader reader{json, "", state};
  [[nodiscard]] std::string error() const { return state.error ? state.error->text() : ""; }
};

TEST(JsonReader, ReadsWhatIsRight) {
  Fixture f(R"({"a": 1.5, "b": -3, "c": "text", "d": true, "e": [1, 2, 3], "f": {"g": [{"h": 2}, {"h": 3}]}})");
  f.reader.allow({"a", "b", "c", "d", "e", "f"});
  EXPECT_EQ(f.reader.at("a").number(), 1.5);
  EXPECT_EQ(f.reader.at("b").integer(-5, 5), -3);
  EXPECT_EQ(f.reader.at("c").string(), "text");
  EXPECT_TRUE(f.reader.at("d").boolean());
  EXPECT_EQ(f.reader.at("e").numbers(3), (std::vector<double>{1, 2, 3}));
  double sum = 0.0;
  for (const JsonReader& item : f.reader.at("f").at("g").items()) {
    sum += item.at("h").number(0.0, 10.0);
  }
  EXPECT_EQ(sum, 5.0);
  EXPECT_EQ(f.reader.number_or("a", 7.0), 1.5);
  EXPECT_EQ(f.reader.number_or("none", 7.0), 7.0);
  EXPECT_EQ(f.reader.string_or("none", "x"), "x");
  EXPECT_TRUE(f.reader.boolean_or("none", true));
  EXPECT_EQ(f.error(), "");
}

TEST(JsonReader, NamesThePathOfWhatIsWrong) {
  const auto error = [](const char* text, auto read) {
    Fixture f(text);
    read(f.reader);
    return f.error();
  };
  EXPECT_EQ(
      error(R"({"a": {"b": [0, "x"]}})", [](const JsonReader& r) { (void)r.at("a").at("b").items()[1].number(); }),
      "rig.json: /a/b/1: is not a number");
  EXPECT_EQ(error("{}", [](const JsonReader& r) { (void)r.at("a").string(); }), "rig.json: /a: is missing");
  EXPECT_EQ(error(R"({"a": 4})", [](const JsonReader& r) { (void)r.at("a").number(0, 3); }),
            "rig.json: /a: is 4, outside 0 to 3");
  EXPECT_EQ(error(R"({"a": 1.5})", [](const JsonReader& r) { (void)r.at("a").integer(0, 3); }),
            "rig.json: /a: is not a whole number");
  EXPECT_EQ(error(R"({"a": 1})", [](const JsonReader& r) { (void)r.at("a").boolean(); }),
            "rig.json: /a: is not true or false");
  EXPECT_EQ(error(R"({"a": 1})", [](const JsonReader& r) { (void)r.at("a").string(); }), "rig.json: /a: is not a text");
  EXPECT_EQ(error(R"({"a": [1, 2]})", [](const JsonReader& r) { (void)r.at("a").numbers(3); }),
            "rig.json: /a: has 2 values instead of 3");
  EXPECT_EQ(error("[]", [](const JsonReader& r) { r.allow({"a"}); }), "rig.json: top level: is not an object");
  EXPECT_EQ(error(R"({"a": 1, "wrong": 2})",
                  [](const JsonReader& r) {
                    r.allow({"a", "b"});
                  }),
            "rig.json: /wrong: is not a known key; known here: a, b");
}

TEST(JsonReader, KeepsTheFirstErrorAndReadsOn) {
  Fixture f(R"({"a": "x", "b": "y"})");
  EXPECT_EQ(f.reader.at("a").number(2.0, 3.0), 2.0);
  EXPECT_EQ(f.reader.at("b").integer(5, 9), 5);
  EXPECT_EQ(f.reader.at("c").at("d").items().size(), 0U);
  EXPECT_EQ(f.error(), "rig.json: /a: is not a number");
}

TEST(JsonReader, RefusesWholeNumbersThatDoNotFit) {
  Fixture f(R"({"a": 18446744073709551615})");
  (void)f.reader.at("a").integer(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max());
  EXPECT_THAT(f.error(), HasSubstr("/a: is"));
}

TEST(ParseJson, NamesLineAndColumn) {
  EXPECT_TRUE(parse_json("{\"a\": 1}", "x").ok());
  EXPECT_EQ(parse_json("{\n  \"a\": 1,\n  oops\n}", "rig.json").error().place, "rig.json:3:3");
  EXPECT_EQ(parse_json("", "rig.json").error().place, "rig.json:1:1");
  EXPECT_EQ(parse_json("{\"a\": ", "rig.json").error().place, "rig.json:1:7");
  EXPECT_FALSE(parse_json("{\"a\": NaN}", "rig.json").ok());
  EXPECT_FALSE(parse_json("\xFF\xFE", "rig.json").ok());
}

TEST(ParseJson, RefusesWhatWouldOverflowTheStack) {
  EXPECT_THAT(parse_json(std::string(100000, '['), "x").error().text(), HasSubstr("nested deeper"));
  EXPECT_TRUE(parse_json("\"" + std::string(1000, '[') + "\"", "x").ok()) << "brackets in a text do not nest";
  EXPECT_TRUE(parse_json(R"("\"[[")", "x").ok());
}

TEST(ParseJson, RefusesNumbersBeyondDouble) {
  const Result<nlohmann::json> json = parse_json(R"({"a": 1e999})", "x");
  EXPECT_FALSE(json.ok());
}

}  // namespace
}  // namespace limbwave
