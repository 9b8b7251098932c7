// Settings of techniques: declared once, read from text, kept inside their ranges.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "core/error.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

class Settings : public testing::Test {
  protected:
    static Setting settingOf(Technique& technique, const std::string& key) {
        for (const Setting& setting : settingsOf(technique))
            if (setting.key == key) return setting;
        ADD_FAILURE() << technique.description().name << " has no setting " << key;
        return {};
    }

    /// The message of the refusal; empty if the text was taken.
    static std::string refusal(Technique& technique, const std::string& key, const std::string& text) {
        try {
            setFromText(technique, key, text);
        } catch (const UsageError& error) {
            return error.what();
        }
        return {};
    }

    gl::ProgramCache programs_;  // OpenGL is touched only when a technique draws
    std::unique_ptr<Technique> tsm_ = makeTechnique("tsm", programs_);
    std::unique_ptr<Technique> ranges_ = makeTechnique("ranges", programs_);
    std::unique_ptr<Technique> accumulation_ = makeTechnique("accumulation", programs_);
};

/// Techniques hold numbers as floats: not every default is one.
float asHeld(double number) { return static_cast<float>(number); }

TEST_F(Settings, EveryDeclarationIsWhole) {
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        const std::unique_ptr<Technique> technique = makeTechnique(description.name, programs_);
        EXPECT_EQ(technique->description().name, description.name);
        std::set<std::string> keys;
        for (const Setting& setting : settingsOf(*technique)) {
            SCOPED_TRACE(description.name + "." + setting.key);
            EXPECT_TRUE(keys.insert(setting.key).second) << "declared twice";
            EXPECT_EQ(setting.key.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string::npos);
            EXPECT_LT(setting.minimum, setting.maximum);
            EXPECT_GE(setting.defaultValue, setting.minimum);
            EXPECT_LE(setting.defaultValue, setting.maximum);
            EXPECT_EQ(asHeld(setting.get()), asHeld(setting.defaultValue))
                << "a new technique starts with its defaults";
            EXPECT_GE(setting.help.size(), 20u);
            EXPECT_EQ(setting.unit.empty(), setting.isSwitch() || setting.isChoice());
            if (setting.isChoice()) {
                EXPECT_EQ(setting.maximum + 1.0, static_cast<double>(setting.choices.size()));
            }
            EXPECT_TRUE(!setting.logarithmic || setting.minimum > 0.0);
            for (const double limit : {setting.minimum, setting.maximum})
                EXPECT_TRUE(!setting.isWhole() || limit == std::floor(limit));
        }
    }
}

TEST_F(Settings, EverySettingTakesItsWholeRangeAndNoMore) {
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        const std::unique_ptr<Technique> technique = makeTechnique(description.name, programs_);
        for (const Setting& setting : settingsOf(*technique)) {
            SCOPED_TRACE(description.name + "." + setting.key);
            if (setting.isSwitch()) continue;
            const auto text = [](double number) { return std::to_string(number); };
            for (const double number : {setting.minimum, setting.maximum, setting.defaultValue}) {
                const std::string whole = setting.isWhole() ? std::to_string(std::lround(number)) : text(number);
                EXPECT_EQ(refusal(*technique, setting.key, whole), "");
                EXPECT_EQ(asHeld(settingOf(*technique, setting.key).get()), asHeld(number));
            }
            for (const double number : {setting.minimum - 1.0, setting.maximum + 1.0}) {
                EXPECT_NE(refusal(*technique, setting.key, text(number)), "");
                EXPECT_EQ(asHeld(settingOf(*technique, setting.key).get()), asHeld(setting.defaultValue))
                    << "changed although refused";
            }
        }
    }
}

TEST_F(Settings, NumbersAreReadWholly) {
    for (const char* text : {"2", "2.0", "2e0", "0.2e1", "002"}) {
        EXPECT_EQ(refusal(*tsm_, "bias", text), "") << text;
        EXPECT_EQ(settingOf(*tsm_, "bias").get(), 2.0) << text;
        EXPECT_EQ(refusal(*tsm_, "bias", "1"), "");
    }
    for (const char* text : {"", " ", " 2", "2 ", "2\n", "2x", "2,5", "+2", "0x2", "nan", "NaN", "inf", "-inf",
                             "infinity", "1e999", "two", "on", "--2", "2.0.0"}) {
        const std::string line = refusal(*tsm_, "bias", text);
        EXPECT_NE(line.find("--set tsm.bias=" + std::string(text)), std::string::npos) << line;
        EXPECT_NE(line.find("expected a number from 0 to 64 (texels)"), std::string::npos) << line;
        EXPECT_EQ(settingOf(*tsm_, "bias").get(), 1.0) << text;
    }
}

TEST_F(Settings, WholeNumbersAreWhole) {
    EXPECT_EQ(refusal(*accumulation_, "renders", "7"), "");
    EXPECT_EQ(accumulation_->renders(), 7);
    EXPECT_EQ(refusal(*accumulation_, "renders", "1e2"), "");
    EXPECT_EQ(accumulation_->renders(), 100);
    for (const char* text : {"7.5", "0.999", "1e-1", "4096.0001", "4097", "0", "-1", "1e300"}) {
        const std::string line = refusal(*accumulation_, "renders", text);
        EXPECT_NE(line.find("expected a whole number from 1 to 4096 (renders)"), std::string::npos)
            << text << ": " << line;
        EXPECT_EQ(accumulation_->renders(), 100);
    }
}

TEST_F(Settings, SwitchesAreOnOrOff) {
    for (const auto& [text, state] :
         {std::pair{"on", 1.0}, {"off", 0.0}, {"true", 1.0}, {"false", 0.0}, {"1", 1.0}, {"0", 0.0}}) {
        EXPECT_EQ(refusal(*ranges_, "as_published", text), "");
        EXPECT_EQ(settingOf(*ranges_, "as_published").get(), state) << text;
    }
    EXPECT_EQ(refusal(*ranges_, "as_published", "on"), "");
    for (const char* text : {"", "2", "0.5", "ON", "yes", "maybe", "on "}) {
        const std::string line = refusal(*ranges_, "as_published", text);
        EXPECT_EQ(line, "--set ranges.as_published=" + std::string(text) + ": expected on or off");
        EXPECT_EQ(settingOf(*ranges_, "as_published").get(), 1.0);
    }
}

/// It was a switch once, which files and scripts of that time still have.
TEST_F(Settings, AChoiceThatWasASwitchIsStillSwitched) {
    for (const auto& [text, name] : {std::pair{"on", "both_times"},
                                     {"true", "both_times"},
                                     {"1", "both_times"},
                                     {"off", "off"},
                                     {"false", "off"},
                                     {"0", "off"},
                                     {"eq12", "eq12"}}) {
        EXPECT_EQ(refusal(*tsm_, "dynamic_bias", text), "");
        EXPECT_EQ(textOf(settingOf(*tsm_, "dynamic_bias")), name) << text;
    }
    EXPECT_EQ(refusal(*tsm_, "dynamic_bias", "maybe"),
              "--set tsm.dynamic_bias=maybe: expected one of off, both_times, eq12");
}

TEST_F(Settings, UnknownKeysListTheKnownOnes) {
    for (const char* key : {"", "Bias", "bias ", "renders", "tsm.bias"}) {
        const std::string line = refusal(*tsm_, key, "1");
        EXPECT_NE(line.find("--set tsm." + std::string(key) + ": no such setting"), std::string::npos) << line;
        for (const Setting& setting : settingsOf(*tsm_))
            EXPECT_NE(line.find("tsm." + setting.key), std::string::npos) << line;
    }
}

TEST_F(Settings, TechniquesOfOneKindKeepTheirOwnValues) {
    const std::unique_ptr<Technique> other = makeTechnique("tsm", programs_);
    setFromText(*tsm_, "bias", "7");
    EXPECT_EQ(settingOf(*tsm_, "bias").get(), 7.0);
    EXPECT_EQ(settingOf(*other, "bias").get(), settingOf(*other, "bias").defaultValue);
    EXPECT_EQ(settingOf(*tsm_, "bias").defaultValue, settingOf(*other, "bias").defaultValue)
        << "a default is no current value";
}

TEST_F(Settings, UnknownTechniquesListTheKnownOnes) {
    for (const char* name : {"", "TSM", "nonsense"}) {
        try {
            makeTechnique(name, programs_);
            ADD_FAILURE() << name;
        } catch (const UsageError& error) {
            const std::string line = error.what();
            EXPECT_NE(line.find("'" + std::string(name) + "'"), std::string::npos) << line;
            for (const TechniqueDescription& known : techniqueDescriptions())
                EXPECT_NE(line.find(known.name), std::string::npos) << line;
        }
    }
}

}  // namespace
}  // namespace timeshade
