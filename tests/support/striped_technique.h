#pragma once

#include <string>

#include "technique/technique.h"

namespace timeshade {

/// For tests of the code around a technique: everything is lit, the view "columns" holds the number of each pixel's
/// column, negative in the lower half of the picture, and there are statistics with and without a warning.
class StripedTechnique final : public Technique {
  public:
    const TechniqueDescription& description() const override {
        static const TechniqueDescription description{
            "striped", "Stripes", "Stripes", "A picture of its own columns.", "a test", {}, {}, {}, {}};
        return description;
    }
    void visitSettings(SettingsVisitor&) override {}
    std::vector<PassDecision> passes(const FramePlan&) const override { return {}; }
    void build(const TechniqueFrame&) override {}
    LookupProgram lookupProgram(const TechniqueFrame&, Casters) override { return {}; }
    bool hasOwnLookup() const override { return true; }
    void drawLookup(const TechniqueFrame& frame) override {
        const float lit = 1.0f;
        glClearTexImage(frame.visibility.lit().name(), 0, GL_RED, GL_FLOAT, &lit);
    }
    std::vector<TechniqueView> views() const override {
        return {{"columns", "The number of the column", "columns", 0.0, 15.0, false},
                {"powers", "The same, in powers", "columns", 1.0, 16.0, true}};
    }
    void drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) override {
        const int width = values.width(), height = values.height();
        std::vector<float> columns;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) columns.push_back(2 * y < height ? -1.0f : static_cast<float>(x));
        glTextureSubImage2D(values.name(), 0, 0, 0, width, height, GL_RED, GL_FLOAT, columns.data());
        drawn_ = name;
        samples_ = static_cast<double>(frame.plan.request.samplesPerPixel);
    }
    std::vector<TechniqueStatistic> statistics() const override {
        return {{"samples", samples_, "a pixel", ""},
                {"lists with unpaired fragments", 12345.0, "", "the picture may be wrong there"}};
    }
    std::size_t bytes() const override { return 0; }

    const std::string& drawn() const { return drawn_; }

  private:
    std::string drawn_;
    double samples_ = 0.0;
};

}  // namespace timeshade
