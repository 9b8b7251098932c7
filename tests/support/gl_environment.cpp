#include "support/gl_environment.h"

#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace timeshade {

namespace {

ContextKind kindOfEnvironment() {
    const char* name = std::getenv("TIMESHADE_TEST_CONTEXT");
    const std::string kind = name != nullptr ? name : "egl";
    if (kind == "egl") return ContextKind::Egl;
    if (kind == "osmesa") return ContextKind::OsMesa;
    throw std::runtime_error("TIMESHADE_TEST_CONTEXT is '" + kind + "'; expected egl or osmesa");
}

/// Members are destroyed in reverse order: those that need the context before it.
struct SharedGl {
    SharedGl() : context(makeHeadlessContext({kindOfEnvironment(), -1, true})) {}

    std::unique_ptr<GlContext> context;
    gl::DebugLog log;
    std::optional<FrameRenderer> renderer;
};

std::unique_ptr<SharedGl> shared;

class GlEnvironment final : public testing::Environment {
  public:
    void SetUp() override {
        try {
            shared = std::make_unique<SharedGl>();
        } catch (const std::exception& error) {
            // Exits instead of failing: GoogleTest would report every test as skipped, which CTest counts as passed.
            std::cerr << "no OpenGL for the tests: " << error.what() << std::endl;
            std::_Exit(EXIT_FAILURE);
        }
    }
    void TearDown() override { shared.reset(); }
};

class DriverSilence final : public testing::EmptyTestEventListener {
  public:
    void OnTestStart(const testing::TestInfo&) override {
        if (shared) shared->log.clear();
    }
    void OnTestEnd(const testing::TestInfo&) override {
        if (!shared) return;
        for (const std::string& message : shared->log.messages()) ADD_FAILURE() << "the driver complains: " << message;
    }
};

SharedGl& made() {
    if (!shared) throw std::logic_error("no OpenGL context: it lives from before the first test to after the last");
    return *shared;
}

}  // namespace

GlContext& sharedContext() { return *made().context; }

gl::DebugLog& sharedDebugLog() { return made().log; }

FrameRenderer& sharedRenderer() {
    if (!made().renderer) {
        made().renderer.emplace();
        made().renderer->setChecked(true);
    }
    return *made().renderer;
}

}  // namespace timeshade

int main(int argumentCount, char** arguments) {
    testing::InitGoogleTest(&argumentCount, arguments);
    testing::AddGlobalTestEnvironment(new timeshade::GlEnvironment);
    testing::UnitTest::GetInstance()->listeners().Append(new timeshade::DriverSilence);
    return RUN_ALL_TESTS();
}
