#include "options/epipolar_options.h"

#include "core/error.h"
#include "options/command_parts.h"
#include "options/number_list.h"

namespace timeshade {

namespace {

struct EpipolarReading : CommandReading<EpipolarOptions> {
    std::string line, pixel;
    std::optional<double> row;
};

MapLine lineIn(const std::string& text) {
    const UsageError wrong(
        fmt::format("--line {}: expected x0,y0,x1,y1, four numbers from 0 to 1 and two different points, as in "
                    "0.2,0.5,0.8,0.5",
                    text));
    const auto numbers = numbersIn<double>(text, 4);
    if (!numbers) throw wrong;
    for (const double number : *numbers)
        if (!(number >= 0.0 && number <= 1.0)) throw wrong;
    const MapLine line{{(*numbers)[0], (*numbers)[1]}, {(*numbers)[2], (*numbers)[3]}};
    if (line.from == line.to) throw wrong;
    return line;
}

glm::uvec2 pixelIn(const std::string& text, int width, int height) {
    const auto numbers = numbersIn<int>(text, 2);
    const bool inside =
        numbers && (*numbers)[0] >= 0 && (*numbers)[1] >= 0 && (*numbers)[0] < width && (*numbers)[1] < height;
    if (!inside)
        throw UsageError(fmt::format("--pixel {}: expected px,py, from the left and from the top, inside {} x {}", text,
                                     width, height));
    return {static_cast<unsigned>((*numbers)[0]), static_cast<unsigned>((*numbers)[1])};
}

void finish(EpipolarReading& read) {
    EpipolarOptions& options = read.options;
    if (!options.output.ends_with(".png") || options.output.size() < 5)
        throw UsageError(fmt::format("-o {}: expected a name that ends in .png", options.output));
    if (!read.line.empty() && read.row) throw UsageError("--row: expected either it or --line");
    if (!read.line.empty()) options.line = lineIn(read.line);
    if (read.row) options.line = MapLine{{0.0, *read.row}, {1.0, *read.row}};
    if (!read.pixel.empty()) options.pixel = pixelIn(read.pixel, options.width, options.height);
    checkDrawing(static_cast<CommandReading<EpipolarOptions>&>(read), {}, options.output);
}

}  // namespace

void addEpipolarCommand(CLI::App& app, Command& command) {
    CLI::App* epipolar = app.add_subcommand(
        "epipolar", "draw what lies along a line of the shadow map over the shutter, in truth and as stored");
    auto reading = std::make_shared<EpipolarReading>();
    declareScene(*epipolar, reading->options.scene)->required();
    epipolar->add_option("-o,--output", reading->options.output, "F.png")->required();
    epipolar->add_option("--line", reading->line, "x0,y0,x1,y1: the line, in [0, 1] of the shadow map, y upwards")
        ->check(notEmpty("x0,y0,x1,y1"));
    epipolar->add_option("--row", reading->row, "instead: a row of the map, in [0, 1] from its lower side")
        ->check(numberFrom(0.0, 1.0));
    epipolar
        ->add_option("--pixel", reading->pixel,
                     "px,py from the left and the top: shows the pixel's receivers and samples; without a line, the "
                     "line runs through them along the motion there")
        ->check(notEmpty("px,py"));
    declareDrawing(*epipolar, *reading);
    epipolar->final_callback([&command, reading] {
        finish(*reading);
        command = std::move(reading->options);
    });
}

}  // namespace timeshade
