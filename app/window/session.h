#pragma once

#include <functional>
#include <memory>
#include <string>

#include "frame/frame_renderer.h"
#include "options/picture_options.h"
#include "scene/scene.h"
#include "window/accuracy.h"
#include "window/camera_control.h"
#include "window/case_study.h"
#include "window/comparison.h"
#include "window/diagnostic_picture.h"
#include "window/frame_driver.h"
#include "window/frame_graph.h"
#include "window/moment.h"
#include "window/notices.h"
#include "window/page_pictures.h"
#include "window/panel_state.h"
#include "window/pixel_probe.h"
#include "window/recent_files.h"
#include "window/recording.h"
#include "window/requests.h"
#include "window/scene_loading.h"
#include "window/screenshots.h"
#include "window/shader_state.h"
#include "window/shown_scene.h"
#include "window/shown_technique.h"
#include "window/shown_view.h"
#include "window/trail_chart.h"
#include "window/undo_history.h"

namespace timeshade {

/// All that the window knows, each idea in a type of its own. Panels and keys set the values; what replaces a scene or
/// a technique they only request, and it is done between two frames.
struct Session {
    Session(const PictureOptions& givenOptions, std::unique_ptr<Scene> firstScene, std::string backEndName);

    /// Does what scenes, techniques and the comparison were requested to become since the last frame.
    void applyRequests();
    /// Builds all shader programs anew; what is wrong with some of them stands in the shaders' log.
    void reloadShaders();
    /// The scene is another one: nothing of earlier frames is used again.
    void invalidateAll();
    /// Shows what the options say, as at a start. Throws and stays as it is where that can't be.
    void become(const PictureOptions& wanted);
    /// The same, but for the frame that is shown; a scene that stays the same is not opened again.
    void restore(const PictureOptions& wanted);
    /// Notes the settings as they are, as a step that can be undone, unless they are on their way: something plays, is
    /// loaded or is to be replaced.
    void keepForUndo();
    /// How much of the full picture that is being drawn is done; of two, of both.
    std::optional<double> progress() const;
    /// Settings of techniques and scenes that are not shown now, where they are not at their defaults.
    void addOtherSettings(SettingTexts& settings);
    /// Moves the clock on, in seconds; and the playback, whose frame stays while `atWork`.
    void advance(double newNow, bool atWork = false);
    /// The frame that is to be drawn now.
    FrameDriver::Wanted wanted(bool mouseHeld);
    /// The moment's frame as the techniques that are shown ask for it: in a comparison both are drawn on the same
    /// camera samples.
    FrameRequest askedRequest() const;
    void notify(std::string text, bool bad = false) { notices.show(std::move(text), bad, now); }

    PictureOptions options;    ///< as given; what belongs to the first scene alone is cleared when another is opened
    std::string backEnd;       ///< of the window's context
    double now = 0.0;          ///< seconds of the window's clock
    std::string building;      ///< what can't be left just now: "building shader shade"; empty for nothing
    double playedUntil = 0.0;  ///< what the playback has seen of it

    // What is shown.
    FrameRenderer renderer;
    ShownScene scene;
    SceneLoading loading;  ///< of the scene that comes next
    ShownTechnique technique;
    ShownView view;
    Moment moment;
    CameraControl camera;
    Comparison comparison;

    // How it gets to the screen.
    FrameDriver driver;
    ShaderState shaders;

    // What is found out about it.
    PixelProbe probe;
    DiagnosticPicture diagnosticPicture;
    Accuracy accuracy;
    CaseStudy caseStudy;
    TrailChart trailChart;
    std::string accuracyOther;  ///< the technique that equal time and equal error choose

    // What is saved.
    Recording recording;
    Screenshots screenshots;
    RecentFiles recentFiles;

    // What surrounds it.
    Requests requests;
    UndoHistory<std::string> undo;  ///< of settingsText
    FrameGraph graph;
    Notices notices;
    PanelState panels;
    PagePictures pagePictures;

  private:
    void show(std::unique_ptr<Scene> scene, const std::string& name);
    void showMoment(const Scene& shown);
    void openScene(const std::string& name);
    /// The same file with another clip or light.
    void openChoice(const SceneChoice& choice);
    /// Begins, or shows at once what takes no longer than a moment. `then` makes the window show it.
    void load(const std::string& name, SceneLoading::Load load, std::function<void(std::unique_ptr<Scene>)> then);
    /// Shows what has been loaded meanwhile.
    void finishLoading();
    void showOther(std::unique_ptr<Scene> opened, const std::string& name);
    void showChoice(std::unique_ptr<Scene> opened, const SceneChoice& choice);
    void setGround(const GroundSettings& ground);
    void rebuildScene();
    /// Samples, map and all else that the next scene is to be drawn with, too, into the options.
    void keepPicture();
    void applyComparison();
    void applyUndo();
    bool hasScene(const PictureOptions& wanted) const;
    void showAs(const PictureOptions& wanted, std::unique_ptr<Scene> opened);
    /// The second of what is to be compared, if anything is. Throws for what can't be had.
    Comparison::Partner partnerOf(const PictureOptions& wanted);
    /// Makes the comparison, if any, what the options say.
    void compareAsOptions(Comparison::Partner partner);

    std::function<void(std::unique_ptr<Scene>)> whenLoaded_;
};

}  // namespace timeshade
