#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "core/error.h"
#include "headless.h"
#include "interactive.h"
#include "measure.h"
#include "options.h"
#include "verify.h"

namespace {

int run(const timeshade::Options& options) {
    switch (options.command) {
    case timeshade::Command::View: return timeshade::runInteractive(options);
    case timeshade::Command::Shot: return timeshade::runShot(options);
    case timeshade::Command::Record: return timeshade::runRecord(options);
    case timeshade::Command::Pictures: return timeshade::runPictures(options);
    case timeshade::Command::Measure: return timeshade::runMeasure(options);
    case timeshade::Command::Cases: return timeshade::runCases(options);
    case timeshade::Command::Verify: return timeshade::runVerify(options);
    case timeshade::Command::List: return timeshade::runList(options);
    }
    return 1;
}

/// One line, whatever the names and values in it hold.
int fail(int code, std::string what) {
    std::fflush(stdout);
    std::replace_if(
        what.begin(), what.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    fmt::print(stderr, "timeshade: error: {}\n", what);
    return code;
}

}  // namespace

int main(int argumentCount, char** arguments) {
    try {
        const int code = run(timeshade::parseCommandLine(argumentCount, arguments));
        if (std::fflush(stdout) != 0)
            throw std::system_error(errno, std::generic_category(), "cannot write to standard output");
        return code;
    } catch (const timeshade::UsageError& error) {
        return fail(2, error.what());
    } catch (const std::system_error& error) {
        // fmt does not say which file it could not print to; there is but one.
        const bool printing = std::ferror(stdout) != 0;
        return fail(1, printing ? "cannot write to standard output: " + error.code().message() : error.what());
    } catch (const std::exception& error) {
        return fail(1, error.what());
    }
}
