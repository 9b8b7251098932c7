#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <string>
#include <system_error>
#include <variant>

#include "core/error.h"
#include "epipolar.h"
#include "headless.h"
#include "interactive.h"
#include "measure.h"
#include "options/command.h"
#include "reproduce/reproduce.h"
#include "standard_error.h"
#include "verify.h"

namespace {

using namespace timeshade;

/// The one function that does what each command says.
struct Runner {
    int operator()(const ViewOptions& options) const { return runInteractive(options); }
    int operator()(const ShotOptions& options) const { return runShot(options); }
    int operator()(const RecordOptions& options) const { return runRecord(options); }
    int operator()(const PicturesOptions& options) const { return runPictures(options); }
    int operator()(const VerifyOptions& options) const { return runVerify(options); }
    int operator()(const MeasureOptions& options) const { return runMeasure(options); }
    int operator()(const EpipolarOptions& options) const { return runEpipolar(options); }
    int operator()(const ReproduceOptions& options) const { return runReproduce(options); }
    int operator()(const CasesOptions& options) const { return runCases(options); }
    int operator()(const ListOptions& options) const { return runList(options); }
};

int fail(int code, const std::string& what) {
    std::fflush(stdout);
    tell("error: " + what);
    return code;
}

}  // namespace

int main(int argumentCount, char** arguments) {
    std::signal(SIGPIPE, SIG_IGN);  // a reader that is gone is an error of writing
    try {
        const int code = std::visit(Runner{}, parseCommandLine(argumentCount, arguments));
        if (std::fflush(stdout) != 0)
            throw std::system_error(errno, std::generic_category(), "cannot write to standard output");
        return code;
    } catch (const UsageError& error) {
        return fail(2, error.what());
    } catch (const std::system_error& error) {
        // fmt does not say which file it could not print to; there is but one.
        const bool printing = std::ferror(stdout) != 0;
        return fail(1, printing ? "cannot write to standard output: " + error.code().message() : error.what());
    } catch (const std::exception& error) {
        return fail(1, error.what());
    }
}
