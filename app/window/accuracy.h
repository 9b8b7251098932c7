#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure/sample_count_search.h"
#include "window/accuracy_probe.h"

namespace timeshade {

struct Session;

/// What the accuracy panel shows: where the current settings lie between error and time, where earlier ones of the same
/// frame lay, and the search for settings of another technique that lie level with them.
class Accuracy {
  public:
    enum class State {
        Waiting,  ///< for the picture, or for the playback to stop
        Reference,
        Measuring,
        Idle,    ///< all is known
        Failed,  ///< see failure()
    };

    /// To be called on every frame in which the panel can be seen; nothing is measured on the others.
    void keepOn() { wanted_ = true; }
    /// Does one step after the picture of this frame has been drawn. True if the window has to be drawn again.
    bool update(Session& session);
    void clear();

    State state() const { return state_; }
    bool working() const { return state_ == State::Reference || state_ == State::Measuring; }
    const AccuracyProbe& probe() const { return probe_; }
    const std::string& failure() const { return failure_; }
    /// Oldest first. Each subject is there once.
    const std::vector<ProbePoint>& trail() const { return trail_; }
    /// The trail's point of the current settings; null until it has been measured.
    const ProbePoint* current() const;
    /// Changes with the trail and with which point is the current one.
    int revision() const { return revision_; }

    enum class Level { Time, Error };
    /// Begins the search for the sample count at which the other technique is level with the current point; what it
    /// finds becomes side B of a comparison, and the picture's own settings stay.
    void match(Session& session, const std::string& technique, Level level);
    /// What is being tried: "tsm at 4 spp"; empty when nothing is.
    std::string trying() const;
    void stopMatch() { match_.reset(); }
    /// The last search's result in words.
    const std::string& said() const { return said_; }

  private:
    struct Match {
        ProbePoint of;
        ProbeSubject other;
        Level level;
        SampleCountSearch search;
    };
    const ProbePoint* find(const ProbeSubject& subject) const;
    /// Lets the search have what is known. The subject that it wants to be measured, if any.
    std::optional<ProbeSubject> advanceMatch(Session& session);
    void finishMatch(Session& session);

    AccuracyProbe probe_;
    ProbeSubject now_;
    std::vector<ProbePoint> trail_;
    std::optional<Match> match_;
    State state_ = State::Waiting;
    bool wanted_ = false;
    int revision_ = 0;
    std::string failure_, said_;
};

/// What the session draws now.
ProbeSubject subjectOf(const Session& session);
/// "TSM at 8 spp", "Accumulation at 64 renders"
std::string sampleCountInWords(const ProbeSubject& subject);
/// "8", "64x"
std::string sampleCountLabel(const ProbeSubject& subject);

}  // namespace timeshade
