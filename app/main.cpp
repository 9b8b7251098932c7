#include <cstdio>
#include <exception>

#include <fmt/format.h>

#include "headless.h"
#include "interactive.h"
#include "options.h"
#include "scene/error.h"

namespace {

int run(const timeshade::Options& options) {
    switch (options.command) {
    case timeshade::Command::View: return timeshade::runInteractive(options);
    case timeshade::Command::Shot: return timeshade::runShot(options);
    case timeshade::Command::Pictures: return timeshade::runPictures(options);
    case timeshade::Command::List: return timeshade::runList(options);
    }
    return 1;
}

int fail(int code, const char* what) {
    std::fflush(stdout);
    fmt::print(stderr, "timeshade: error: {}\n", what);
    return code;
}

} // namespace

int main(int argumentCount, char** arguments) {
    try {
        return run(timeshade::parseCommandLine(argumentCount, arguments));
    } catch (const timeshade::UsageError& error) {
        return fail(2, error.what());
    } catch (const std::exception& error) {
        return fail(1, error.what());
    }
}
