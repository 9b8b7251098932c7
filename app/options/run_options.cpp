#include "options/run_options.h"

#include <charconv>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "core/error.h"
#include "options/option_checks.h"
#include "scene_memory.h"

namespace timeshade {

namespace {

/// "512M" or "2G", from 1M to 1024G.
std::uint64_t readMemory(const std::string& text) {
    constexpr std::uint64_t most = std::uint64_t{1} << 40;
    const char unit = text.empty() ? '\0' : text.back();
    const int shift = unit == 'M' ? 20 : 30;
    std::uint64_t count = 0;
    const char* const end = text.data() + text.size() - (text.empty() ? 0 : 1);
    const auto [rest, failure] = std::from_chars(text.data(), end, count);
    if ((unit != 'M' && unit != 'G') || failure != std::errc{} || rest != end || count == 0 || count > most >> shift)
        throw UsageError(
            fmt::format("--memory-limit: '{}' given, expected a whole number of M or G (MiB, GiB) from 1M "
                        "to 1024G",
                        text));
    return count << shift;
}

}  // namespace

void declareContext(CLI::App& app, RunOptions& options) {
    addChoice<ContextKind>(app, "--context", options.context.kind,
                           {{"auto", ContextKind::Auto},
                            {"window", ContextKind::Window},
                            {"egl", ContextKind::Egl},
                            {"osmesa", ContextKind::OsMesa}},
                           "auto, window, egl, osmesa");
    app.add_option("--device", options.context.device, "number of an EGL device (list --devices)")
        ->check(numberFrom(0, 1000))
        ->multi_option_policy(lastWins);
    app.add_flag("--gl-debug", options.debugGl,
                 "fail on anything that the driver complains of, and on a NaN or an infinity in any buffer");
}

void declareOptions(CLI::App& app, RunOptions& options) {
    app.option_defaults()->group("Running");
    declareContext(app, options);
    app.add_flag("--explain", options.explain, "print the plan: which passes run, and why");
    app.add_option("--json", options.json, "write a report of the frame")
        ->check(notEmpty("a file name"))
        ->multi_option_policy(lastWins);
    app.add_option_function<std::string>(
           "--memory-limit", [](const std::string& text) { limitSceneMemory(readMemory(text)); },
           "how much memory a scene of a file may take, as 512M or 2G; it is refused before it takes more (default: a "
           "quarter of the machine's)")
        ->multi_option_policy(lastWins);
}

}  // namespace timeshade
