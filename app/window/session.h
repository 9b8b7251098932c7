#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "frame/frame_renderer.h"
#include "options/picture_options.h"
#include "scene/scene.h"
#include "scene_catalogue.h"
#include "scenes/scene_recipe.h"
#include "technique/technique.h"
#include "window/accuracy.h"
#include "window/comparison.h"
#include "window/diagnostic_picture.h"
#include "window/frame_driver.h"
#include "window/orbit_camera.h"
#include "window/page_pictures.h"
#include "window/pixel_probe.h"
#include "window/playback.h"
#include "window/recording.h"
#include "window/shader_watch.h"
#include "window/trail_chart.h"

namespace timeshade {

/// A line that is shown over the picture for a few seconds.
struct Notice {
    std::string text;
    bool bad = false;
    double shownUntil = 0.0;  ///< seconds of the window's clock
};

/// All that the window knows; the panels read it and change it. Opening a scene and choosing a technique are only
/// asked for by the panels and done between two frames, when nobody looks at the old ones.
struct Session {
    Session(const PictureOptions& givenOptions, std::unique_ptr<Scene> firstScene, std::string backEndName);

    /// Does what was asked for since the last frame.
    void applyWishes();
    /// Builds all shader programs anew; what is wrong with some of them stands in shaderLog, and the last good ones
    /// stay.
    void reloadShaders();
    /// Opens what the options say, as at a start. Throws and stays as it is where that can't be.
    void become(const PictureOptions& wanted);
    /// Settings of techniques and scenes that are not shown now, where they are not at their defaults.
    void addCachedSettings(SettingTexts& settings);
    /// Moves the clock on. `now` in seconds.
    void advance(double now);
    FrameDriver::Wanted wanted(bool mouseHeld);

    CameraPose currentPose() const;
    /// Takes the camera into the user's hand, from where it is.
    OrbitCamera& freeCamera();
    /// The views that can be shown, by the names of the command line: those of light first, then the technique's.
    std::vector<std::string> viewNames() const;
    std::string viewName() const;
    /// Ends a comparing view, too.
    void showView(const std::string& name);
    /// What the technique counted in the picture that is shown; empty while it is being drawn.
    const std::vector<TechniqueStatistic>& statistics();
    /// Another object stands in for the technique.
    void techniqueChanged() { statistics_.clear(); }
    void useSceneCamera(std::size_t index);
    /// Puts a scene that is a file in front of the recent ones.
    void remember(const std::string& name);
    void setShutter(const Shutter& shutter);
    void notify(std::string text, bool bad = false);
    /// "timeshade-SCENE-TECHNIQUE-0012.png"
    std::string screenshotName() const;

    PictureOptions options;  ///< as given; what belongs to the first scene alone is cleared when another is opened
    std::string backEnd;     ///< of the window's context
    FrameRenderer renderer;
    FrameDriver driver;

    std::string sceneName;  ///< as on the command line
    std::unique_ptr<Scene> scene;
    SceneRecipe* recipe = nullptr;  ///< of a computed scene; null for a file. Its settings are the sliders' own.
    std::unique_ptr<FramePlanner> planner;
    int sceneNumber = 0;
    ShaderWatch shaderWatch;
    std::vector<std::string> shaderLog;                    ///< empty while all programs are as their files say
    int shaderNumber = 0;                                  ///< changes with the programs
    std::string settingsPath = "timeshade-settings.json";  ///< what is typed in the field of settings files
    std::vector<std::string> recentScenes;                 ///< absolute paths of files that were opened, the last first
    std::string scenePath;                                 ///< what is typed in the field
    std::string sceneError;                                ///< one line, why the last one could not be opened

    std::unique_ptr<Technique> technique;
    std::map<std::string, std::vector<double>> cachedSettings;  ///< of techniques that are not chosen now

    FrameRequest request;  ///< width and height are those of the picture's place in the window
    View view = View::Final;
    std::string techniqueView;  ///< of the technique's own, instead of `view`; empty for none
    Playback playback;
    std::optional<double> instant;  ///< the one instant of the shutter that is drawn, u; none for all of it
    Recording recording;
    std::optional<OrbitCamera> camera;  ///< while the camera is not the scene's own
    std::vector<SavedView> savedViews;

    Comparison comparison;

    PixelProbe probe;

    Diagnostic diagnostic = Diagnostic::None;  ///< in place of the view
    DiagnosticPicture diagnosticPicture;
    Accuracy accuracy;
    TrailChart trailChart;
    std::string accuracyOther;  ///< the technique that equal time and equal error choose

    std::optional<std::string> wishedScene, wishedTechnique;
    std::optional<std::string> wishedClip;  ///< of the scene that is shown
    bool wishedRebuild = false;             ///< the recipe's settings have changed
    bool wishedScreenshot = false;
    bool wishedRecording = false;           ///< start or stop
    bool wishedExr = false;                 ///< the picture is to be saved as EXR
    bool wishedSave = false;                ///< of the settings
    bool wishedCommand = false;             ///< the command line into the clipboard
    std::optional<std::string> wishedLoad;  ///< path of a settings file
    std::string lastCommand;
    std::optional<std::string> wishedComparison;  ///< a technique to compare with; empty for none
    bool wishedPin = false;                       ///< compare with a copy of the technique as it is set now
    bool wishedSwap = false;                      ///< exchange the techniques that are compared
    bool panelsVisible = true;
    bool keysVisible = false;
    bool pageVisible = false;  ///< of the technique
    PagePictures pagePictures;
    std::map<std::string, bool>
        sections;            ///< of the side panel: unfolded or not, where that is not as at a first start
    double textScale = 1.0;  ///< the user's own, on top of the display's
    std::string lastScreenshot;
    int screenshots = 0;  ///< saved so far
    std::optional<Notice> notice;
    double now = 0.0;

  private:
    void adopt(std::unique_ptr<Scene> newScene, const std::string& name);
    void openWished(const std::string& name);
    void openClip(const std::string& name);
    /// Samples, map and all else that the next scene is to be drawn with, too, into the options.
    void keepPicture();
    void rebuild();
    SceneRecipe* cachedRecipe(const std::string& name);
    void chooseWished(const std::string& name);
    void compareWished();
    /// Makes the comparison, if any, what the options say.
    void adoptComparison();

    std::vector<TechniqueStatistic> statistics_;
    int statisticsOf_ = 0;  ///< the picture that they belong to, by its number
    std::map<std::string, std::unique_ptr<SceneRecipe>>
        recipes_;  ///< of all computed scenes opened so far, as they were left
};

}  // namespace timeshade
