#pragma once

namespace timeshade {

/// While it lives, this thread works on the shares [from, to) of what the part around it is; without one around it, of
/// all. So nested loops tell together how far they have come.
class WorkPart {
  public:
    WorkPart(double from, double to);
    ~WorkPart();
    WorkPart(const WorkPart&) = delete;
    WorkPart& operator=(const WorkPart&) = delete;

  private:
    double outerFrom_, outerTo_;
};

/// The `number`-th of `count` equal parts.
inline WorkPart workPart(int number, int count) {
    return {static_cast<double>(number) / count, static_cast<double>(number + 1) / count};
}

/// Share in [0, 1] of this thread's work that has been done.
double workDone();

}  // namespace timeshade
