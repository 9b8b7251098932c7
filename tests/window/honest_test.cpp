// Status and labels against the manifests of the pictures that are shown, in random states of a session.

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "compare/compared_techniques.h"
#include "image/image_file.h"
#include "random_hand.h"
#include "report.h"
#include "scene_catalogue.h"
#include "support/gl_environment.h"
#include "window/session.h"
#include "window/status_line.h"

namespace timeshade {
namespace {

constexpr int states = 200, width = 100, height = 60;  // a little more than the least that previews have

/// The manifest of a picture, from when it came to be shown, and whether it was asked for less than it is.
struct Made {
    int number = 0;
    nlohmann::json manifest;
    FrameRequest asked;

    int spp() const { return manifest["spp"]; }
    std::string map() const {
        const nlohmann::json& map = manifest["map"];
        return map.is_number() ? std::to_string(map.get<int>())
                               : fmt::format("{}x{}", map[0].get<int>(), map[1].get<int>());
    }
    bool preview() const {
        return manifest["size"][0] != asked.width || manifest["size"][1] != asked.height ||
               spp() != asked.samplesPerPixel || map() != asked.mapSize.text();
    }
    /// The technique as the manifest has it.
    std::unique_ptr<Technique> technique() const {
        gl::ProgramCache none;
        std::unique_ptr<Technique> technique = makeTechnique(manifest["technique"], none);
        for (const auto& [key, value] : manifest["settings"].items())
            setFromText(*technique, key,
                        value.is_string()    ? value.get<std::string>()
                        : value.is_boolean() ? (value.get<bool>() ? "on" : "off")
                                             : fmt::format("{}", value.get<double>()));
        return technique;
    }
};

class HonestFigures : public ::testing::Test {
  protected:
    HonestFigures() {
        PictureOptions options;
        options.scene = "cubes";
        options.settings = {{"cubes.count", "12"}, {"accumulation.renders", "3"}};
        options.width = width;
        options.height = height;
        options.mapSize = 64;
        options.compared = {"accumulation", "static"};
        file_ = (std::filesystem::path(::testing::TempDir()) / "timeshade_honest.png").string();
        writePng(file_, {width, height, std::vector<std::uint8_t>(3 * width * height, 90)});
        session_.emplace(options, openScene(options.scene, "", options.settings), "test");
    }
    ~HonestFigures() override { std::filesystem::remove(file_); }

    /// As the window does once a frame. What has come to be shown is written down.
    void work(bool held) {
        session_->moment.request.width = width;
        session_->moment.request.height = height;
        const FrameDriver::Wanted wanted = session_->wanted(held);
        session_->driver.update(wanted, session_->now);
        // Errors and the ground truth come at rest, and take the longest: not in every state.
        if (mayFindOut_ || !session_->comparison.settled(*session_)) session_->comparison.update(*session_, wanted);
        note(first_, session_->driver.shown(), session_->renderer, session_->technique.current(), wanted.request);
        Comparison& comparison = session_->comparison;
        if (comparison.technique() == nullptr || comparison.shown() == nullptr) return;
        FrameRequest second = wanted.request;
        if (comparison.ownSamples()) second.samplesPerPixel = *comparison.ownSamples();
        note(second_, *comparison.shown(), *comparison.renderer(), *comparison.technique(), second);
    }

    void note(Made& made, const ShownPicture& shown, const FrameRenderer& renderer, Technique& technique,
              const FrameRequest& asked) {
        if (shown.number == 0 || shown.number == made.number) return;
        made = {shown.number,
                nlohmann::json::parse(
                    manifest(renderer, technique, session_->scene.name(), session_->scene.current(), "test", {})),
                asked};
    }

    void checkStatus() {
        if (session_->driver.shown().number == 0) return;
        const std::unique_ptr<Technique> technique = first_.technique();
        const bool brute = technique->renders() > 1;
        const std::string expected =
            fmt::format("{}{} x {}, {} {}, map {}", first_.preview() ? "Preview " : "",
                        first_.manifest["size"][0].get<int>(), first_.manifest["size"][1].get<int>(),
                        brute ? technique->renders() : first_.spp(), brute ? "renders" : "spp", first_.map());
        EXPECT_TRUE(statusOf(*session_).starts_with(expected)) << statusOf(*session_) << "\n" << expected;
        ++(first_.preview() ? previews_ : wholes_);
    }

    void checkLabel(const Made& made, bool ofSecond) {
        const std::string label = session_->comparison.label(*session_, ofSecond);
        std::string expected = fmt::format("{}, map {}", sampleCountLabel(*made.technique(), made.spp()), made.map());
        EXPECT_TRUE(label.starts_with(expected)) << label << "\n" << expected;
        EXPECT_EQ(label.find("preview") != std::string::npos, made.preview()) << label;
        EXPECT_FALSE(made.preview() && label.find("error") != std::string::npos) << label;
        ++labels_;
    }

    void checkLabels() {
        Comparison& comparison = session_->comparison;
        if (!comparison.on() || session_->driver.shown().number == 0) return;
        checkLabel(first_, false);
        if (comparison.kind() == ComparedSide::Kind::File) {
            EXPECT_EQ(comparison.label(*session_, true), "timeshade_honest.png");
            ++others_;
        } else if (comparison.truth().samples() == 0 && comparison.shown() != nullptr &&
                   comparison.shown()->technique == truthName) {
            EXPECT_TRUE(comparison.label(*session_, true).starts_with("Ground truth, "))
                << "also where it was B before";
        } else if (comparison.picture() != nullptr && comparison.technique() != nullptr) {
            checkLabel(second_, true);
        } else if (comparison.truth().samples() > 0) {
            const nlohmann::json manifests = nlohmann::json::parse(comparison.manifests(*session_));
            EXPECT_EQ(comparison.label(*session_, true),
                      fmt::format("Ground truth, {} spp", manifests["compare"][1]["spp"].get<int>()));
            ++others_;
        }
    }

    std::string file_;
    std::optional<Session> session_;
    Made first_, second_;
    bool mayFindOut_ = false;
    int previews_ = 0, wholes_ = 0, labels_ = 0, others_ = 0;
};

TEST_F(HonestFigures, StatusAndLabelsAreThoseOfThePictureInRandomStates) {
    RandomHand hand(*session_, 11, {"accumulation", "static"}, file_);
    for (int i = 0; i < states; ++i) {
        hand.change();
        FrameRequest& request = session_->moment.request;
        request.samplesPerPixel = std::min(request.samplesPerPixel, 6);  // more would only take longer
        request.motionSteps = std::min(request.motionSteps, 2);
        request.mapSize = std::min(request.mapSize.longerSide(), 512);
        for (Technique* technique : {&session_->technique.current(), session_->comparison.technique()})
            if (technique != nullptr && technique->description().name == "accumulation")
                setFromText(*technique, "renders", std::to_string(2 + i % 3));  // a thousand would show no more
        // Some changes are looked at before anything is drawn of them, some while a button is held, some at rest.
        const bool held = hand.upTo(2) == 0;
        mayFindOut_ = i % 8 == 0;
        session_->now += held ? 0.01 : 1.0;
        const int frames = hand.upTo(3);
        for (int frame = 0; frame < frames; ++frame) work(held);
        checkStatus();
        checkLabels();
        if (HasFailure()) FAIL() << "state " << i;
    }
    EXPECT_GT(previews_, 20);
    EXPECT_GT(wholes_, 60);
    EXPECT_GT(labels_, 100);
    EXPECT_GT(others_, 5);
}

}  // namespace
}  // namespace timeshade
