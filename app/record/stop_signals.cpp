#include "record/stop_signals.h"

#include <array>
#include <csignal>
#include <cstddef>

namespace timeshade {

namespace {

volatile std::sig_atomic_t caught = 0;
volatile std::sig_atomic_t first = 0;

constexpr std::array<int, 3> watched{SIGINT, SIGTERM, SIGHUP};
std::array<struct sigaction, watched.size()> before;

void onSignal(int number) {
    if (caught == 0) first = number;
    caught = caught + 1;
}

}  // namespace

StopSignals::StopSignals() {
    caught = 0;
    struct sigaction action {};
    action.sa_handler = onSignal;  // without SA_RESTART: waiting ends
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < watched.size(); ++i) {
        sigaction(watched[i], nullptr, &before[i]);
        // What was started to be ignored, as nohup does, stays ignored.
        if (before[i].sa_handler != SIG_IGN) sigaction(watched[i], &action, nullptr);
    }
}

StopSignals::~StopSignals() {
    for (std::size_t i = 0; i < watched.size(); ++i) sigaction(watched[i], &before[i], nullptr);
    caught = 0;
}

int StopSignals::count() { return caught; }

const char* StopSignals::name() { return first == SIGINT ? "SIGINT" : first == SIGTERM ? "SIGTERM" : "SIGHUP"; }

}  // namespace timeshade
