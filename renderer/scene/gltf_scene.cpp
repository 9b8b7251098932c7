#include "scene/gltf_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <new>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "core/one_line.h"
#include "scene/clip_clock.h"
#include "scene/gltf_compression.h"
#include "scene/gltf_defaults.h"
#include "scene/gltf_document.h"
#include "scene/gltf_geometry.h"
#include "scene/gltf_images.h"
#include "scene/gltf_instances.h"
#include "scene/gltf_instancing.h"
#include "scene/gltf_probes.h"
#include "scene/gltf_views.h"

namespace timeshade {

namespace {

using namespace gltf;

/// Deforms instances into shared lists of vertices.
void deformInstances(const Stage& stage, const Pose& pose, bool movingOnes, std::vector<glm::dvec3>& positions,
                     std::vector<glm::vec3>& normals) {
    std::vector<std::vector<glm::dmat4x3>> joints(stage.skins.size());
    for (const Instance& instance : stage.instances) {
        if (instance.moves != movingOnes) continue;
        std::span<const glm::dmat4x3> own;
        if (instance.skin >= 0) {
            auto& matrices = joints[static_cast<std::size_t>(instance.skin)];
            if (matrices.empty()) matrices = jointMatrices(stage.skins[static_cast<std::size_t>(instance.skin)], pose);
            own = matrices;
        }
        const std::size_t count = instance.geometry->positions.size();
        deform(instance, pose, own, std::span(positions).subspan(instance.firstVertex, count),
               std::span(normals).subspan(instance.firstVertex, count));
    }
}

/// The file's clips, with unique names, and the one that plays.
struct ClipNames {
    std::vector<std::string> all;
    std::size_t chosen = 0;
};

class GltfScene final : public Scene {
  public:
    GltfScene(std::string name, const Model& model, ClipNames clips, NodeMotion motion, Stage stage, Looks looks,
              std::vector<std::string> notes, const std::string& wantedLight, const LoadingWatch& watch)
        : name_(std::move(name)),
          clips_(std::move(clips)),
          motion_(std::move(motion)),
          stage_(std::move(stage)),
          looks_(std::move(looks)),
          notes_(std::move(notes)),
          clock_(0.0, true) {
        positions_.resize(stage_.topology->vertexCount);
        normals_.resize(stage_.topology->vertexCount);
        deformInstances(stage_, motion_.rest(), false, positions_, normals_);
        moves_ =
            std::any_of(stage_.instances.begin(), stage_.instances.end(), [](const Instance& i) { return i.moves; });
        measure(watch);
        views_ = readViews(model, motion_.clip(), bounds_, wantedLight, notes_);
        const auto moving = [&](int node) { return node >= 0 && motion_.moves(node); };
        const bool viewsMove = moving(views_.light.node) || !views_.light.tracks.empty() ||
                               std::any_of(views_.cameras.begin(), views_.cameras.end(),
                                           [&](const PlacedCamera& c) { return moving(c.node); });
        duration_ = moves_ || viewsMove ? motion_.clip().duration : 0.0;
        clock_ = ClipClock(duration_, endMeetsStart());
        if (moves_) probes_ = probesOf(model, stage_);
    }

    void setDefaults(const SceneDefaults& defaults, std::vector<std::string> notes) {
        constexpr std::size_t most = 40;
        defaults_ = defaults;
        notes_.insert(notes_.end(), notes.begin(), notes.end());
        if (notes_.size() <= most) return;
        const std::size_t more = notes_.size() - most;
        notes_.resize(most);
        notes_.push_back(fmt::format("{} more notes like these", more));
    }

    /// What contentDigest() says from now on.
    void setDigest(std::string digest) { digest_ = std::move(digest); }

    const std::string& name() const override { return name_; }
    std::string contentDigest() const override { return digest_; }
    double duration() const override { return duration_; }
    bool loops() const override { return clock_.loops(); }
    const SceneDefaults& defaults() const override { return defaults_; }
    const std::vector<Material>& materials() const override { return looks_.materials; }
    const std::vector<Image>& images() const override { return looks_.images; }
    const std::vector<CameraBookmark>& cameras() const override { return views_.names; }
    const Bounds& bounds() const override { return bounds_; }
    const std::vector<std::string>& clips() const override { return clips_.all; }
    std::size_t clip() const override { return clips_.chosen; }
    const std::vector<std::string>& lights() const override { return views_.lightNames; }
    std::size_t chosenLight() const override { return views_.chosenLight; }
    const std::vector<std::string>& notes() const override { return notes_; }

    CameraPose camera(std::size_t index, double seconds) const override {
        return cameraAt(index, ClipInstant::of(clock_.clipTime(seconds)));
    }
    LightPose light(double seconds) const override { return lightAt(ClipInstant::of(clock_.clipTime(seconds))); }
    ShutterEnds<CameraPose> cameraEnds(std::size_t index, double openSeconds, double closeSeconds) const override {
        return {cameraAt(index, during(openSeconds, closeSeconds, 0.0)),
                cameraAt(index, during(openSeconds, closeSeconds, 1.0))};
    }
    ShutterEnds<LightPose> lightEnds(double openSeconds, double closeSeconds) const override {
        return {lightAt(during(openSeconds, closeSeconds, 0.0)), lightAt(during(openSeconds, closeSeconds, 1.0))};
    }
    MotionMesh motionMesh(double openSeconds, double closeSeconds) const override;
    InnerMotion innerMotion(double openSeconds, double closeSeconds) const override {
        return innerMotionOf(probes_, stage_, motion_, clock_, openSeconds, closeSeconds);
    }

  private:
    /// The moment at a share of a shutter. Tracks of STEP keys are read at its middle throughout.
    ClipInstant during(double openSeconds, double closeSeconds, double share) const {
        return {clock_.during(openSeconds, closeSeconds, share), clock_.during(openSeconds, closeSeconds, 0.5)};
    }
    CameraPose cameraAt(std::size_t index, const ClipInstant& instant) const {
        const PlacedCamera& camera = views_.cameras.at(index);
        return camera.node < 0 ? camera.pose : placedCamera(camera, motion_.worldFromNode(camera.node, instant));
    }
    LightPose lightAt(const ClipInstant& instant) const {
        const PlacedLight& light = views_.light;
        return light.node < 0 ? light.pose : placedLight(motion_.worldFromNode(light.node, instant), instant);
    }
    CameraPose placedCamera(const PlacedCamera& camera, const glm::dmat4& worldFromNode) const;
    LightPose placedLight(const glm::dmat4& worldFromNode, const ClipInstant& instant) const;
    bool viewsLoop(const Pose& start, const Pose& end) const;
    void measure(const LoadingWatch& watch);
    bool endMeetsStart() const;
    std::shared_ptr<const MeshTopology> topologyIn(const Pose& pose) const;

    std::string name_, digest_;
    ClipNames clips_;
    NodeMotion motion_;
    Stage stage_;
    ProbeList probes_;
    mutable std::mutex topologiesMutex_;
    mutable std::map<std::vector<char>, std::shared_ptr<const MeshTopology>> topologies_;  ///< by mirrored instances
    Looks looks_;
    std::vector<std::string> notes_;
    ClipClock clock_;
    Views views_;
    SceneDefaults defaults_;
    Bounds bounds_;
    double duration_ = 0.0;
    bool moves_ = false;                 ///< some triangle moves
    std::vector<glm::dvec3> positions_;  ///< of instances that never move; the others' entries are scratch
    std::vector<glm::vec3> normals_;
};

CameraPose GltfScene::placedCamera(const PlacedCamera& camera, const glm::dmat4& worldFromNode) const {
    CameraPose pose = camera.pose;
    pose.eye = glm::dvec3(worldFromNode[3]);
    pose.axes = rotationOf(worldFromNode);
    return pose;
}

LightPose GltfScene::placedLight(const glm::dmat4& worldFromNode, const ClipInstant& instant) const {
    LightPose pose = views_.light.at(instant);
    pose.position = glm::dvec3(worldFromNode[3]);
    pose.axes = rotationOf(worldFromNode);
    if (views_.light.aimed) {
        glm::dvec3 target = bounds_.centre();
        if (glm::length(target - pose.position) < 1e-6 * bounds_.diagonal())
            target.y -= bounds_.diagonal();  // from inside: aim down
        pose.axes = lookAt(pose.position, target, glm::dvec3(0.0, 1.0, 0.0), 1.0, 1.0).axes;
    }
    return pose;
}

/// Bounds of all triangles during the clip.
void GltfScene::measure(const LoadingWatch& watch) {
    constexpr std::size_t samples = 16;
    constexpr double farthest = 1e18;  // squares of such distances are finite in float
    const double duration = motion_.clip().duration;
    std::vector<glm::dvec3> positions = positions_;
    std::vector<glm::vec3> normals = normals_;
    for (std::size_t sample = 0; sample <= (moves_ ? samples : 0); ++sample) {
        watch({"bounds", sample, moves_ ? samples + 1 : 1});
        if (moves_)
            deformInstances(stage_, motion_.at(ClipInstant::of(duration * static_cast<double>(sample) / samples)), true,
                            positions, normals);
        for (std::size_t v = 0; v < positions.size(); ++v) {
            const glm::dvec3& p = positions[v];
            if (!(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= farthest))
                throw Error(fmt::format("a vertex lies beyond {} units from the origin", farthest));
            if (stage_.used[v]) bounds_.add(p);
        }
    }
    if (!(bounds_.diagonal() > 1e-12)) throw Error("all its triangles together have no size");
}

/// Tolerance at the seam of a loop, as a share of the scene's extent: exporters round the last key.
constexpr double seamTolerance = 1e-4;

bool GltfScene::viewsLoop(const Pose& start, const Pose& end) const {
    const auto same = [&](const glm::dvec3& eye, const glm::dmat3& axes, const glm::dvec3& otherEye,
                          const glm::dmat3& otherAxes) {
        double difference = glm::length(eye - otherEye) / bounds_.diagonal();
        for (int axis = 0; axis < 3; ++axis)
            difference = std::max(difference, glm::length(axes[axis] - otherAxes[axis]));
        return difference <= seamTolerance;
    };
    for (const PlacedCamera& camera : views_.cameras) {
        if (camera.node < 0) continue;
        const CameraPose a = placedCamera(camera, start.worldFromNode[static_cast<std::size_t>(camera.node)]);
        const CameraPose b = placedCamera(camera, end.worldFromNode[static_cast<std::size_t>(camera.node)]);
        if (!same(a.eye, a.axes, b.eye, b.axes)) return false;
    }
    if (views_.light.node < 0) return true;
    const auto node = static_cast<std::size_t>(views_.light.node);
    const LightPose a = placedLight(start.worldFromNode[node], ClipInstant::of(0.0));
    const LightPose b = placedLight(end.worldFromNode[node], ClipInstant::of(duration_));
    const double brightest = std::max(glm::length(a.intensity), glm::length(b.intensity));
    const bool alike = glm::length(a.intensity - b.intensity) <= seamTolerance * brightest &&
                       std::abs(a.outerConeAngle - b.outerConeAngle) <= seamTolerance &&
                       std::abs(a.innerConeAngle - b.innerConeAngle) <= seamTolerance &&
                       std::abs(a.range - b.range) <= seamTolerance * bounds_.diagonal();
    return alike && same(a.position, a.axes, b.position, b.axes);
}

/// Whether the end of the clip equals its start.
bool GltfScene::endMeetsStart() const {
    if (!(duration_ > 0.0)) return true;
    const Pose start = motion_.at(ClipInstant::of(0.0));
    const Pose end = motion_.at(ClipInstant::of(duration_));
    if (!viewsLoop(start, end)) return false;
    if (!moves_) return true;
    std::vector<glm::dvec3> atStart = positions_;
    std::vector<glm::dvec3> atEnd = positions_;
    std::vector<glm::vec3> normals = normals_;
    deformInstances(stage_, start, true, atStart, normals);
    deformInstances(stage_, end, true, atEnd, normals);
    for (std::size_t v = 0; v < atStart.size(); ++v)
        if (stage_.used[v] && glm::length(atStart[v] - atEnd[v]) > seamTolerance * bounds_.diagonal()) return false;
    return true;
}

/// The topology whose triangles are counter-clockwise in the pose. Equal windings share one.
std::shared_ptr<const MeshTopology> GltfScene::topologyIn(const Pose& pose) const {
    std::vector<char> mirrored = mirroredInstances(stage_, pose);
    const std::lock_guard lock(topologiesMutex_);
    auto& known = topologies_[mirrored];
    if (!known) known = topologyMirrored(stage_, mirrored);
    return known;
}

MotionMesh GltfScene::motionMesh(double openSeconds, double closeSeconds) const {
    MotionMesh mesh{stage_.topology, positions_, positions_, normals_, normals_, 0.0};
    if (!moves_) return mesh;
    if (stage_.mayMirror) mesh.topology = topologyIn(motion_.at(during(openSeconds, closeSeconds, 0.5)));
    deformInstances(stage_, motion_.at(during(openSeconds, closeSeconds, 0.0)), true, mesh.positionsOpen,
                    mesh.normalsOpen);
    deformInstances(stage_, motion_.at(during(openSeconds, closeSeconds, 1.0)), true, mesh.positionsClose,
                    mesh.normalsClose);
    // In steps, because the two ends alone cannot distinguish a full turn from none.
    constexpr int steps = 4;
    std::vector<ClipInstant> path;
    for (int step = 0; step <= steps; ++step)
        path.push_back(during(openSeconds, closeSeconds, static_cast<double>(step) / steps));
    mesh.largestTurnDegrees = motion_.largestTurnDegrees(stage_.turningNodes, path);
    return mesh;
}

/// The clips' names, made unique: the second "walk" becomes "walk (2)".
std::vector<std::string> unlikeNames(const std::vector<Clip>& clips) {
    std::set<std::string> taken;
    std::map<std::string, int> times;
    std::vector<std::string> names;
    for (const Clip& clip : clips) {
        std::string name = clip.name;
        while (!taken.insert(name).second)
            name = fmt::format("{} ({})", clip.name, ++times.try_emplace(clip.name, 1).first->second);
        names.push_back(std::move(name));
    }
    return names;
}

Clip chooseClip(const Model& model, const std::string& wanted, ClipNames& names, std::vector<std::string>& notes,
                const LoadingWatch& watch) {
    std::vector<Clip> clips;
    KeyCache cache;
    std::vector<std::vector<std::string>> clipNotes(model.animations.size());
    for (std::size_t i = 0; i < model.animations.size(); ++i) {
        watch({"clips", i, model.animations.size()});
        clips.push_back(readClip(model, i, cache, clipNotes[i]));
    }
    names.all = unlikeNames(clips);
    if (!wanted.empty()) {
        names.chosen =
            static_cast<std::size_t>(std::find(names.all.begin(), names.all.end(), wanted) - names.all.begin());
        if (names.chosen == names.all.size())
            throw Error(fmt::format("has no clip \"{}\"; {}", oneLine(wanted),
                                    clips.empty() ? std::string("it has none at all")
                                                  : fmt::format("it has: {}", fmt::join(names.all, ", "))));
    }
    if (clips.empty()) return {};
    notes.insert(notes.end(), clipNotes[names.chosen].begin(), clipNotes[names.chosen].end());
    return std::move(clips[names.chosen]);
}

std::unique_ptr<Scene> load(const std::filesystem::path& path, const GltfOptions& options) {
    const LoadingWatch watch = options.watch ? options.watch : [](const LoadingStep&) {};
    const auto memory = std::make_shared<MemoryBudget>(options.memoryLimit);
    watch({"the file"});
    const Document document = readDocument(path, options.maxBufferBytes, memory);
    FilesBeside files(path.parent_path(), options.maxBufferBytes, memory);
    watch({"its structure"});
    Model model = readModel(document);
    watch({"buffers"});
    loadBuffers(model, document, files);
    decompress(model, document.json);
    validate(model);
    expandInstances(model, options.maxTriangles);

    std::vector<std::string> notes = std::move(model.notes);
    auto geometries = readGeometries(model, Budget{options.maxTriangles}, notes, watch);
    ClipNames clips;
    NodeMotion motion(model, chooseClip(model, options.clip, clips, notes, watch), notes);
    Looks looks = readLooks(model, files, notes, watch);
    watch({"instances"});
    Stage stage =
        buildStage(model, motion, std::move(geometries), static_cast<std::uint32_t>(looks.materials.size() - 1), notes);
    auto scene =
        std::make_unique<GltfScene>(path.stem().string(), model, std::move(clips), std::move(motion), std::move(stage),
                                    std::move(looks), std::move(notes), options.light, watch);
    std::vector<std::string> defaultNotes;
    const SceneDefaults defaults = readDefaults(document.json, model.scene, scene->duration(), defaultNotes);
    scene->setDefaults(defaults, std::move(defaultNotes));
    scene->setDigest(toHex(document.digest) + " " + toHex(files.digest()) +
                     (options.light.empty() ? "" : " light " + options.light));
    return scene;
}

}  // namespace

std::unique_ptr<Scene> loadGltf(const std::filesystem::path& path, const GltfOptions& options) {
    constexpr std::size_t longest = 200;
    std::string problem;
    try {
        return load(path, options);
    } catch (const LoadingCancelled&) {
        throw;
    } catch (const std::bad_alloc&) {
        problem = "needs more memory than there is";
    } catch (const std::exception& error) {
        problem = oneLine(error.what(), longest);
    }
    throw Error(fmt::format("{}: {}", oneLine(path.string(), 4096), problem));
}

}  // namespace timeshade
