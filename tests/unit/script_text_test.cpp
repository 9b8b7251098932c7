// Scripts as JSON: what a part says, and which line is named where something is wrong.
#include <gtest/gtest.h>

#include "core/error.h"
#include "json_lines.h"
#include "record/script_text.h"

namespace timeshade {
namespace {

std::string refusal(const std::string& text) {
    try {
        scriptOfJson(text, "s.json");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(ScriptText, PartsHaveTheirOwnAndCommonSettings) {
    const ScriptText script = scriptOfJson(
        R"({"options": {"spp": 2}, "parts": [{"scene": "chess", "frames": 3, "seam": [0, 1], "title": "a"},
            {"set": {"tsm.bias": 2}, "scene": "cubes", "step": 0.5}]})",
        "s.json");
    ASSERT_EQ(script.parts.size(), 2u);
    ASSERT_EQ(script.common.size(), 1u);
    EXPECT_EQ(script.common[0].key, "spp");
    EXPECT_EQ(script.parts[0].frames, 3);
    EXPECT_EQ(script.parts[0].seams, (std::vector<double>{0.0, 1.0}));
    EXPECT_EQ(script.parts[0].title, "a");
    ASSERT_EQ(script.parts[0].settings.size(), 1u);  // the scene
    EXPECT_EQ(script.parts[1].scene, "cubes");
    EXPECT_EQ(script.parts[1].step, 0.5);
    ASSERT_EQ(script.parts[1].settings.size(), 2u);
    EXPECT_EQ(script.parts[1].settings[1].place, "s.json:2");
}

TEST(ScriptText, TheLineIsNamed) {
    EXPECT_TRUE(refusal("{\"parts\": [{\"scene\": \"a\"},\n{\"scene\": \"b\",\n\"json\": \"x\"}]}")
                    .starts_with("s.json:3: \"json\""));
    EXPECT_TRUE(refusal("{\n\"options\": {\n\"output\": \"x\"}, \"parts\": [{\"scene\": \"a\"}]}")
                    .starts_with("s.json:3: \"output\""));
    EXPECT_TRUE(refusal(R"({"parts": [{"scene": "a"}, 3]})").starts_with("s.json: part 2 is number"));
    EXPECT_NE(refusal(std::string("{\"parts\": [{\"scene\": \"a\"}]}\0 \"\xc4\":", 33)), "");
    EXPECT_TRUE(refusal(R"({"options": 3, "parts": [{"scene": "a"}]})").starts_with("s.json: \"options\" is number"));
}

TEST(JsonLines, KeysAndObjectsAreFoundWhereTheyStand) {
    const std::string text =
        "{\"a\\\"\": [{\"b\": \"]}\"}, [{}]],\n \"set\": {\"x\": [1],\n\"y\": 2}, \"p\": [\n{\"q\": []}, {}]}";
    const std::map<std::string, int> lines = linesOfKeys(text);
    EXPECT_EQ(lines, (std::map<std::string, int>{{"a\"", 1}, {"set", 2}, {"set/x", 2}, {"set/y", 3}, {"p", 3}}));
    const std::vector<JsonPiece> pieces = objectsUnder(text, "p");
    ASSERT_EQ(pieces.size(), 2u);
    EXPECT_EQ(pieces[0].text, "{\"q\": []}");
    EXPECT_EQ(pieces[0].line, 4);
    EXPECT_EQ(pieces[1].text, "{}");
    ASSERT_EQ(objectsUnder(text, "set").size(), 1u);
    EXPECT_EQ(objectsUnder(text, "set")[0].line, 2);
    EXPECT_TRUE(objectsUnder(text, "x").empty());
}

}  // namespace
}  // namespace timeshade
