#pragma once

namespace timeshade {

/// Progress of long work on standard error where that is a terminal: one line that is written over and wiped at the
/// end.
class Progress {
  public:
    explicit Progress(int steps);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void update(int done) const;

  private:
    bool shown_;
    int steps_;
};

}  // namespace timeshade
