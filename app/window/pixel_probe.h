#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frame/frame_renderer.h"
#include "gl/texture.h"
#include "oracle/oracle.h"
#include "oracle/segment_oracle.h"
#include "window/probe_bars.h"

namespace timeshade {

struct Session;

/// One pixel under a magnifier: its surroundings, and the lit value of each of its camera samples by each technique,
/// with the ground truth over the same footprint.
class PixelProbe {
  public:
    static constexpr int side = 17;              ///< pixels of the magnified square
    static constexpr std::uint32_t rays = 1024;  ///< of each true mean, where the truth is not a single test

    /// The values of one technique, from the first stratum of the shutter to the last; none where the oracle tests
    /// nothing (nothing is seen, or a surface that faces away from the light or lies outside its cone).
    struct Row {
        std::string name, title;  ///< "tsm", "TSM"
        std::vector<ProbeValue> values;
        /// Mean of the values, or of the truths, weighted as in the picture. 0 where there are none.
        double mean(float ProbeValue::*what) const;
    };

    bool on() const { return on_; }
    /// x from the left, y from the top. Work on another pixel ends at its next pause.
    void pick(int x, int y);
    void clear();
    /// Within a pause of update(): another pixel has been picked, or none.
    bool outdated() const { return working_ && of_ < 0; }
    int x() const { return x_; }
    int y() const { return y_; }

    /// Does a step once the picture is complete and nothing moves: the technique that is shown, then one other after
    /// the other. True if the window has to be drawn again.
    bool update(Session& session);

    /// The square around the pixel, first row uppermost; null until it has been read.
    const gl::Texture* square() const { return square_ ? &*square_ : nullptr; }
    const std::vector<Row>& rows() const { return rows_; }
    /// What the pixel's centre sees over the shutter, and how much of it is lit; empty until it has been
    /// solved, and in scenes of which alpha cuts something out.
    const std::vector<LitSegment>& segments() const { return segments_; }
    bool complete() const { return complete_; }
    /// What is being evaluated; or why something can't be.
    const std::string& caption() const { return caption_; }

  private:
    /// One of the pixel's camera samples, and what the oracle says of it.
    struct Sample {
        SampleIndex index;
        std::uint32_t triangle = NO_TRIANGLE;
        OracleAnswer answer;
    };

    void begin(Session& session);
    void solveSegments(const FramePlan& plan);
    void evaluateNext(Session& session);
    void drawOther(Session& session, Technique& technique);
    void announceNext();
    void addRow(const FramePlan& plan, const FrameRenderer& renderer, const Technique& technique);
    void traceSamples(const FramePlan& plan, const FrameRenderer& renderer);
    void addTruth(const FramePlan& plan, const Footprint& footprint, std::vector<ProbeValue>& values) const;
    template <typename T>
    std::vector<T> ofPixel(const FrameRequest& request, const std::vector<T>& all) const;

    void release();
    void step(Session& session);

    bool on_ = false, complete_ = false;
    bool working_ = false;  ///< within update()
    int x_ = 0, y_ = 0;
    int of_ = -1;                            ///< number of the picture that is magnified
    std::optional<FrameRenderer> renderer_;  ///< made when first needed
    std::vector<std::unique_ptr<Technique>> others_;
    std::size_t next_ = 0;  ///< of the others
    std::unique_ptr<Oracle> oracle_;
    std::vector<Sample> samples_;
    std::optional<gl::Texture> square_;
    std::vector<Row> rows_;
    std::vector<LitSegment> segments_;
    std::string caption_;
};

}  // namespace timeshade
