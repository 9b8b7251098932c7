#include "core/work_part.h"

namespace timeshade {

namespace {

struct Range {
    double from = 0.0, to = 1.0;
};
thread_local Range current;
thread_local double done = 0.0;

}  // namespace

WorkPart::WorkPart(double from, double to) : outerFrom_(current.from), outerTo_(current.to) {
    const double length = current.to - current.from;
    current = {outerFrom_ + from * length, outerFrom_ + to * length};
    done = current.from;
}

WorkPart::~WorkPart() {
    done = current.to;
    current = {outerFrom_, outerTo_};
}

double workDone() { return done; }

}  // namespace timeshade
