#include "passes/interval_samples.h"

#include <algorithm>
#include <array>
#include <bit>

#include <fmt/format.h>

#include "core/error.h"
#include "gl/read_back.h"
#include "passes/seen_tiles.h"

namespace timeshade {

namespace {

const std::string staticName = "interval samples: static";
constexpr std::array<int, 4> roundsAtOnce{600, 2400, 150, 40};  // of the loops of one pixel
constexpr int mostDraws = 200;                                  // of one position a pixel
constexpr std::size_t bytesOfState = 5 * 4;                     // SeenState of passes/seen_segments.frag
const std::string advice = "draw a smaller picture, or lower --spp";

template <typename T>
gl::Buffer bufferOf(const char* label, const std::vector<T>& data) {
    return gl::Buffer(label, std::span<const T>(data));
}

}  // namespace

IntervalSamples::StaticSamples::StaticSamples(int width, int height, int positions)
    : depth(gl::Texture::array2D("static position depth", GL_DEPTH_COMPONENT32F, width, height, positions)) {}

IntervalSamples::IntervalSamples(gl::ProgramCache& programs, FrameCaches& caches)
    : programs_(programs),
      caches_(caches),
      rasterizer_(programs),
      target_("interval samples target"),
      parts_("parts of what positions see", GL_RGBA32UI),
      countsBuffer_("counts of parts", sizeof(Counts)) {}

IntervalSamples::Candidates::Candidates(const FramePlan& plan) : Candidates(seenTiles(plan)) {}

IntervalSamples::Candidates::Candidates(const SeenTiles& tiles)
    : triangles(bufferOf("seen triangles", tiles.triangles)),
      ids(bufferOf("ids of seen triangles", tiles.ids)),
      offsets(bufferOf("offsets of tiles", tiles.offsets)),
      entries(bufferOf("candidates of tiles", tiles.candidates)),
      trianglesView(gl::Texture::ofBuffer("seen triangles", GL_RGBA32F, triangles)),
      idsView(gl::Texture::ofBuffer("ids of seen triangles", GL_R32UI, ids)),
      offsetsView(gl::Texture::ofBuffer("offsets of tiles", GL_R32UI, offsets)),
      entriesView(gl::Texture::ofBuffer("candidates of tiles", GL_RG32UI, entries)),
      columns(tiles.columns),
      tileSide(static_cast<std::uint32_t>(tiles.side)),
      buckets(static_cast<std::uint32_t>(tiles.buckets)) {}

std::size_t IntervalSamples::Candidates::bytes() const {
    return triangles.bytes() + ids.bytes() + offsets.bytes() + entries.bytes();
}

const gl::Texture& IntervalSamples::drawStatic(const FramePlan& plan, const GpuMesh& mesh, SampleBuffer& samples) {
    const gl::Texture& ids = samples.ids();
    const CacheKey key = plan.versions.samples;
    auto& entry = caches_.entry<StaticSamples>(staticName);
    const bool held = key != 0 && entry.holds(key);
    StaticSamples& cached = entry.get(ids.width(), ids.height(), ids.layers());
    if (!held) {
        // Times do not matter to what is static.
        const StochasticRasterizer::Strata positions{plan.block.positions,
                                                     1.0f / static_cast<float>(plan.block.positions), 0};
        rasterizer_.draw(mesh, plan.camera, {&plan.camera.staticTriangles}, StochasticRasterizer::Role::Camera,
                         StochasticRasterizer::Output::TriangleId, positions, &ids, cached.depth);
    }
    entry.setKey(key);
    return cached.depth;
}

void IntervalSamples::draw(const FramePlan& plan, const GpuMesh& mesh, const Fullscreen& fullscreen,
                           SampleBuffer& samples, bool cutAtStrata) {
    positions_ = plan.block.positions;
    const gl::Texture& ids = samples.ids();
    if (!heads_ || heads_->width() != ids.width() || heads_->height() != ids.height() ||
        heads_->layers() != ids.layers())
        heads_ = gl::Texture::array2D("parts of positions", GL_RG32UI, ids.width(), ids.height(), ids.layers());
    const gl::Texture& depth = drawStatic(plan, mesh, samples);
    candidates_.reset();
    if (!plan.camera.dynamicTriangles.empty()) candidates_.emplace(plan);

    const std::size_t places = static_cast<std::size_t>(ids.width()) * static_cast<std::size_t>(ids.height()) *
                               static_cast<std::size_t>(ids.layers());
    std::size_t wanted = std::max<std::size_t>(counts_.parts, places * (cutAtStrata ? plan.block.strata : 1));
    for (;;) {
        parts_.reserve(wanted, advice);
        solve(plan, fullscreen, samples, depth, cutAtStrata);
        if (counts_.parts <= parts_.buffer().bytes() / sizeof(SeenPart)) break;
        wanted = counts_.parts;
    }
}

gl::ShaderDefines IntervalSamples::definesFor(const FramePlan& plan, bool cutAtStrata) const {
    gl::ShaderDefines defines;
    if (plan.camera.turns) defines.emplace_back("CAMERA_TURNS", "1");
    if (cutAtStrata) defines.emplace_back("CUT_AT_STRATA", "1");
    if (candidates_) defines.emplace_back("MOVING_TRIANGLES", "1");
    return defines;
}

void IntervalSamples::drawPosition(const gl::Program& program, const Fullscreen& fullscreen,
                                   std::uint32_t position) const {
    target_.attach(GL_COLOR_ATTACHMENT0, *heads_, static_cast<int>(position));
    target_.bindForDrawing(heads_->width(), heads_->height());
    program.set("position", position);
    fullscreen.draw(program);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

void IntervalSamples::solve(const FramePlan& plan, const Fullscreen& fullscreen, const SampleBuffer& samples,
                            const gl::Texture& staticDepth, bool cutAtStrata) {
    counts_ = {};
    countsBuffer_.upload(std::span<const Counts>(&counts_, 1));
    gl::Inputs inputs;
    inputs.texture("staticDepth", staticDepth)
        .set("room", static_cast<std::uint32_t>(parts_.buffer().bytes() / sizeof(SeenPart)));
    const gl::ShaderDefines defines = definesFor(plan, cutAtStrata);
    if (candidates_) {
        inputs.texture("seenTriangles", candidates_->trianglesView)
            .texture("seenTriangleIds", candidates_->idsView)
            .texture("tileOffsets", candidates_->offsetsView)
            .texture("tileCandidates", candidates_->entriesView)
            .set("tilesInRow", candidates_->columns)
            .set("tileSide", candidates_->tileSide)
            .set("buckets", candidates_->buckets);
        const std::size_t bytes =
            static_cast<std::size_t>(heads_->width()) * static_cast<std::size_t>(heads_->height()) * bytesOfState;
        if (!states_ || states_->bytes() < bytes) states_.emplace("positions that are left", bytes, advice);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SEEN_STATES_BINDING, states_->name());
    }
    const auto programFor = [&](gl::ShaderDefines all) -> const gl::Program& {
        const gl::Program& program =
            programs_.get({"seen segments", "passes/fullscreen.vert", "passes/seen_segments.frag", std::move(all)});
        program.use(inputs);
        return program;
    };
    samples.ids().bind(SAMPLE_IDS_UNIT);
    parts_.bindForWriting(SEEN_PARTS_BINDING);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SEEN_COUNTS_BINDING, countsBuffer_.name());
    target_.setColorCount(1);
    const std::uint32_t none = SEEN_NO_PLACE;
    glClearNamedBufferData(parts_.buffer().name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
    gl::ShaderDefines goesOn = defines;
    goesOn.emplace_back("GOES_ON", "1");
    for (std::uint32_t position = 0; position < plan.block.positions; ++position) {
        const gl::Program& program = programFor(defines);
        if (candidates_) program.set("roundsAtOnce", roundsAtOnce.front());
        drawPosition(program, fullscreen, position);
        if (candidates_ && takeCounts().unfinished > 0) finishPosition(programFor(goesOn), fullscreen, position);
    }
    counts_ = gl::readElements<Counts>(countsBuffer_, 0, 1).front();
}

/// Goes on until nothing is left. Where none of the positions came on, with more rounds of loops at once, as one of
/// them may need them, then with fewer, as the driver may have ended them.
void IntervalSamples::finishPosition(const gl::Program& program, const Fullscreen& fullscreen, std::uint32_t position) {
    Counts drawn;
    std::size_t tries = 0;
    int draws = 0;
    do {
        program.set("roundsAtOnce", roundsAtOnce[tries]);
        drawPosition(program, fullscreen, position);
        drawn = takeCounts();
        tries = drawn.advances > 0 ? 0 : tries + 1;
        if (drawn.unfinished > 0 && (tries == roundsAtOnce.size() || ++draws == mostDraws))
            throw LimitError(
                fmt::format("{} positions see more triangles at once than this device's loops can sort: draw a larger "
                            "picture, or use --samples strata",
                            drawn.unfinished));
    } while (drawn.unfinished > 0);
}

/// What has been counted, of the last draw alone what is left and what came on.
IntervalSamples::Counts IntervalSamples::takeCounts() {
    const Counts counts = gl::readElements<Counts>(countsBuffer_, 0, 1).front();
    Counts next = counts;
    next.unfinished = next.advances = 0;
    countsBuffer_.upload(std::span<const Counts>(&next, 1));
    return counts;
}

std::vector<glm::u32vec2> IntervalSamples::readHeads() const {
    std::vector<glm::u32vec2> heads(heads_->bytes() / sizeof(glm::u32vec2));
    glGetTextureImage(heads_->name(), 0, GL_RG_INTEGER, GL_UNSIGNED_INT, static_cast<GLsizei>(heads_->bytes()),
                      heads.data());
    return heads;
}

IntervalSamples::Read IntervalSamples::read() const {
    const std::vector<SeenPart> stored = gl::readElements<SeenPart>(parts_.buffer(), 0, counts_.parts);
    const std::vector<glm::u32vec2> heads = readHeads();
    const std::size_t pixels = heads.size() / positions_;
    Read read;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
        for (std::size_t position = 0; position < positions_; ++position) {
            glm::u32vec2 chunk = heads[position * pixels + pixel];
            for (bool goesOn = true; goesOn;) {
                goesOn = (chunk.y & SEEN_PARTS_GO_ON) != 0;
                const std::uint32_t end = chunk.x + (chunk.y & ~SEEN_PARTS_GO_ON);
                for (std::uint32_t at = chunk.x; at < end; ++at) {
                    read.parts.push_back(stored[at]);
                    read.places.push_back(at);
                }
                if (goesOn) {
                    const SeenPart& next = stored[end];
                    chunk = {next.triangle, std::bit_cast<std::uint32_t>(next.begin)};
                }
            }
        }
    return read;
}

std::size_t IntervalSamples::bytes() const {
    return rasterizer_.bytes() + parts_.bytes() + countsBuffer_.bytes() + (heads_ ? heads_->bytes() : 0) +
           (candidates_ ? candidates_->bytes() : 0) + (states_ ? states_->bytes() : 0);
}

}  // namespace timeshade
