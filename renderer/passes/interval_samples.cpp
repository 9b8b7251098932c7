#include "passes/interval_samples.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.h"
#include "gl/dispatch.h"
#include "gl/read_back.h"
#include "passes/seen_tiles.h"
#include "shared/seen_slices.shared.h"

namespace timeshade {

namespace {

const std::string staticName = "interval samples: static";
constexpr std::uint32_t slicesTogether = 1u << 20;  // 24 MB
constexpr std::size_t wordsOfSlice = 6;             // Slice of lib/seen_slices.glsl
const std::string advice = "draw a smaller picture, or lower --spp";

template <typename T>
gl::Buffer bufferOf(const char* label, const std::vector<T>& data) {
    return gl::Buffer(label, std::span<const T>(data));
}

LimitError tooManyTriangles(std::uint32_t positions) {
    return LimitError(
        fmt::format("{} positions see more triangles than this device's loops can sort: draw a larger picture, or use "
                    "--samples strata",
                    positions));
}

}  // namespace

IntervalSamples::StaticSamples::StaticSamples(int width, int height, int positions)
    : depth(gl::Texture::array2D("static position depth", GL_DEPTH_COMPONENT32F, width, height, positions)) {}

IntervalSamples::IntervalSamples(gl::ProgramCache& programs, FrameCaches& caches)
    : programs_(programs),
      caches_(caches),
      rasterizer_(programs),
      parts_("parts of what positions see", GL_RGBA32UI),
      slices_("slices of the shutter", GL_R32UI),
      segments_("segments of slices", GL_RG32UI),
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

void IntervalSamples::draw(const FramePlan& plan, const GpuMesh& mesh, SampleBuffer& samples, bool cutAtStrata) {
    const gl::Texture& ids = samples.ids();
    if (!partsOfPositions_ || partsOfPositions_->width() != ids.width() ||
        partsOfPositions_->height() != ids.height() || partsOfPositions_->layers() != ids.layers())
        partsOfPositions_ =
            gl::Texture::array2D("parts of positions", GL_RG32UI, ids.width(), ids.height(), ids.layers());
    const gl::Texture& depth = drawStatic(plan, mesh, samples);
    candidates_.reset();
    if (!plan.camera.dynamicTriangles.empty()) candidates_.emplace(plan);

    const std::size_t places = static_cast<std::size_t>(ids.width()) * static_cast<std::size_t>(ids.height()) *
                               static_cast<std::size_t>(ids.layers());
    std::size_t wanted = std::max<std::size_t>(counts_.parts, places * (cutAtStrata ? plan.block.strata : 1));
    for (std::uint32_t apart = 1;;) {
        parts_.reserve(wanted, advice);
        solve(plan, samples, depth, cutAtStrata, apart);
        const bool fits = counts_.parts <= parts_.buffer().bytes() / sizeof(SeenPart);
        if (fits && counts_.unsolved == 0) break;
        if (counts_.unsolved > 0 && apart > 1) throw tooManyTriangles(counts_.unsolved);
        if (counts_.unsolved > 0) apart = SEEN_GROUP;
        wanted = std::max<std::size_t>(wanted, counts_.parts);
    }
}

std::uint32_t IntervalSamples::placesTogether() const {
    return candidates_ ? std::max(slicesTogether / candidates_->buckets, 1u) : slicesTogether;
}

void IntervalSamples::solve(const FramePlan& plan, const SampleBuffer& samples, const gl::Texture& staticDepth,
                            bool cutAtStrata, std::uint32_t apart) {
    counts_ = {};
    std::uint32_t unsolved = 0;
    samples.ids().bind(SAMPLE_IDS_UNIT);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SEEN_COUNTS_BINDING, countsBuffer_.name());
    const auto places = static_cast<std::uint32_t>(partsOfPositions_->width() * partsOfPositions_->height() *
                                                   partsOfPositions_->layers());
    for (Batch batch{0, 0}; batch.first < places; batch.first += batch.places) {
        batch.places = std::min(placesTogether(), places - batch.first);
        gl::Inputs inputs;
        inputs.set("firstPlace", batch.first).set("places", batch.places).set("twoRounds", 2);
        if (candidates_) {
            gl::Inputs all = inputs;
            all.texture("staticDepth", staticDepth)
                .texture("seenTriangles", candidates_->trianglesView)
                .texture("seenTriangleIds", candidates_->idsView)
                .texture("tileOffsets", candidates_->offsetsView)
                .texture("tileCandidates", candidates_->entriesView)
                .set("tilesInRow", candidates_->columns)
                .set("tileSide", candidates_->tileSide)
                .set("buckets", candidates_->buckets);
            solveBatch(plan, all, batch);
        }
        writeParts(inputs, batch, cutAtStrata, apart);
        unsolved += counts_.unsolved;
    }
    counts_.unsolved = unsolved;
}

/// With room for all slices and segments of the batch: more is made where it did not suffice.
void IntervalSamples::solveBatch(const FramePlan& plan, const gl::Inputs& inputs, Batch batch) {
    gl::ShaderDefines defines;
    if (plan.camera.turns) defines.emplace_back("CAMERA_TURNS", "1");
    const gl::Program& program =
        programs_.get({.label = "seen slices", .defines = std::move(defines), .compute = "passes/seen_slices.comp"});
    const std::uint32_t firstSlices = batch.places * candidates_->buckets;
    const std::uint32_t parts = counts_.parts;
    for (std::size_t slices = firstSlices, segments = firstSlices;;) {
        slices_.reserve(slices * wordsOfSlice, advice);
        segments_.reserve(segments, advice);
        slices_.bindForWriting(SEEN_SLICES_BINDING);
        segments_.bindForWriting(SEEN_SEGMENTS_BINDING);
        program.use(inputs);
        program.set("sliceRoom", static_cast<std::uint32_t>(slices_.buffer().bytes() / 4 / wordsOfSlice));
        program.set("segmentRoom", static_cast<std::uint32_t>(segments_.buffer().bytes() / 8));
        counts_ = {parts, firstSlices, 0, 0};
        countsBuffer_.upload(std::span<const Counts>(&counts_, 1));
        if (solveSlices(program, firstSlices)) return;
        slices = std::max<std::size_t>(slices, counts_.slices);
        segments = std::max<std::size_t>(segments, counts_.segments);
    }
}

/// The first slices, then those that others were halved into, until none is left: a halving ends at one tick. After the
/// second time each has a work group to itself, and with it the driver's rounds of loops. False where there was no room
/// for all.
bool IntervalSamples::solveSlices(const gl::Program& program, std::uint32_t firstSlices) {
    int dispatches = 0;
    for (std::uint32_t begin = 0, end = firstSlices; begin < end; begin = end, end = counts_.slices) {
        const std::uint32_t apart = dispatches++ < 2 ? 1 : SEEN_GROUP;
        program.set("sliceBegin", begin);
        program.set("sliceEnd", end);
        program.set("apart", apart);
        gl::dispatch(gl::groupsFor(static_cast<std::size_t>(end - begin) * apart, SEEN_GROUP));
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
        counts_ = readCounts();
        const bool fits = counts_.slices <= slices_.buffer().bytes() / 4 / wordsOfSlice &&
                          counts_.segments <= segments_.buffer().bytes() / 8;
        if (!fits) return false;
        if (counts_.unsolved > 0) throw tooManyTriangles(counts_.unsolved);
    }
    return true;
}

void IntervalSamples::writeParts(const gl::Inputs& inputs, Batch batch, bool cutAtStrata, std::uint32_t apart) {
    gl::ShaderDefines defines;
    if (cutAtStrata) defines.emplace_back("CUT_AT_STRATA", "1");
    if (candidates_) defines.emplace_back("MOVING_TRIANGLES", "1");
    const gl::Program& program =
        programs_.get({.label = "seen parts", .defines = std::move(defines), .compute = "passes/seen_parts.comp"});
    parts_.bindForWriting(SEEN_PARTS_BINDING);
    counts_.unsolved = 0;
    countsBuffer_.upload(std::span<const Counts>(&counts_, 1));
    gl::Inputs all = inputs;
    all.texture("partsOfPositions", *partsOfPositions_)
        .set("partRoom", static_cast<std::uint32_t>(parts_.buffer().bytes() / sizeof(SeenPart)))
        .set("apart", apart);
    program.use(all);
    gl::dispatch(gl::groupsFor(static_cast<std::size_t>(batch.places) * apart, SEEN_GROUP));
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    counts_ = readCounts();
}

IntervalSamples::Counts IntervalSamples::readCounts() const { return gl::readElement<Counts>(countsBuffer_); }

IntervalSamples::Read IntervalSamples::read() const {
    const std::vector<SeenPart> stored = gl::readElements<SeenPart>(parts_.buffer(), 0, counts_.parts);
    const auto heads = gl::readTexture<glm::u32vec2>(*partsOfPositions_, GL_RG_INTEGER, GL_UNSIGNED_INT);
    const auto positions = static_cast<std::size_t>(partsOfPositions_->layers());
    const std::size_t pixels = heads.size() / positions;
    Read read;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
        for (std::size_t position = 0; position < positions; ++position) {
            const glm::u32vec2 head = heads[position * pixels + pixel];
            for (std::uint32_t at = head.x; at < head.x + head.y; ++at) {
                read.parts.push_back(stored[at]);
                read.places.push_back(at);
            }
        }
    return read;
}

std::size_t IntervalSamples::bytes() const {
    return rasterizer_.bytes() + parts_.bytes() + slices_.bytes() + segments_.bytes() + countsBuffer_.bytes() +
           (partsOfPositions_ ? partsOfPositions_->bytes() : 0) + (candidates_ ? candidates_->bytes() : 0);
}

}  // namespace timeshade
