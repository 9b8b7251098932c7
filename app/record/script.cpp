#include "record/script.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "core/error.h"
#include "options/command.h"
#include "record/script_text.h"
#include "settings_file.h"

namespace timeshade {

namespace {

ScriptPart partOf(const PartText& text, const std::vector<FileSetting>& common, const RecordOptions& options) {
    ScriptPart part;
    part.frames = text.frames;
    part.step = text.step;
    part.cameraTo = text.cameraTo;
    part.seams = text.seams;
    part.title = text.title;
    part.caption = text.caption;
    std::vector<FileSetting> settings;
    for (const std::vector<FileSetting>* some : {&common, &text.settings})
        for (const FileSetting& setting : *some)
            // The command line wins, but here --scene would be what excludes a script.
            if (setting.key != "scene") settings.push_back(setting);
    part.drawn = std::get<RecordOptions>(parseWithSettings(options.arguments, settings));
    part.drawn.scene = text.scene;
    if (options.frames) part.frames = *options.frames;
    return part;
}

}  // namespace

std::vector<ScriptPart> partsOf(const RecordOptions& options) {
    if (options.script.empty()) {
        ScriptPart part;
        part.drawn = options;
        part.frames = options.frames.value_or(0);
        part.seams = {options.seam};
        return {part};
    }
    const ScriptText script = scriptOfJson(textOfFile(options.script, "--script"), options.script);
    std::vector<ScriptPart> parts;
    for (const PartText& text : script.parts) {
        try {
            parts.push_back(partOf(text, script.common, options));
            const PictureOptions &first = parts.front().drawn, &last = parts.back().drawn;
            if (first.width != last.width || first.height != last.height)
                throw Error(fmt::format("\"size\" is {}x{}; expected {}x{} as of the first part", last.width,
                                        last.height, first.width, first.height));
        } catch (const UsageError& error) {
            throw UsageError(fmt::format("{}: {}", text.place, error.what()));
        } catch (const Error& error) {
            throw Error(fmt::format("{}: {}", text.place, error.what()));
        }
    }
    return parts;
}

double eased(double share) {
    const double t = std::clamp(share, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double easedThrough(const std::vector<double>& values, double share) {
    if (values.size() == 1) return values.front();
    const double along = std::clamp(share, 0.0, 1.0) * static_cast<double>(values.size() - 1);
    const std::size_t from = std::min(static_cast<std::size_t>(along), values.size() - 2);
    return values[from] + (values[from + 1] - values[from]) * eased(along - static_cast<double>(from));
}

}  // namespace timeshade
