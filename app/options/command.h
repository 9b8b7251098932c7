#pragma once

#include <string>
#include <variant>
#include <vector>

#include "options/cases_options.h"
#include "options/epipolar_options.h"
#include "options/list_options.h"
#include "options/measure_options.h"
#include "options/pictures_options.h"
#include "options/record_options.h"
#include "options/reproduce_options.h"
#include "options/shot_options.h"
#include "options/verify_options.h"
#include "options/view_options.h"

namespace timeshade {

struct FileSetting;

/// What the command line (and a settings file) asks for, checked as far as that is possible without a scene or OpenGL.
using Command = std::variant<ViewOptions, ShotOptions, RecordOptions, PicturesOptions, VerifyOptions, MeasureOptions,
                             EpipolarOptions, ReproduceOptions, CasesOptions, ListOptions>;

/// Reads the command line. Prints help or the version and exits with 0 where asked; throws UsageError otherwise.
Command parseCommandLine(int argumentCount, char** arguments);

/// The same for arguments that begin with the command's name and hold no --settings.
Command parseArguments(const std::vector<std::string>& arguments);

/// The same with settings of files behind the command's name; a wrong one is named with its place.
Command parseWithSettings(const std::vector<std::string>& arguments, const std::vector<FileSetting>& settings);

/// Each declares one command on the program. When it is the one that is given, `command` holds its options after
/// parsing.
void addViewCommand(CLI::App& app, Command& command);
void addShotCommand(CLI::App& app, Command& command);
void addRecordCommand(CLI::App& app, Command& command);
void addPicturesCommand(CLI::App& app, Command& command);
void addVerifyCommand(CLI::App& app, Command& command);
void addMeasureCommand(CLI::App& app, Command& command);
void addEpipolarCommand(CLI::App& app, Command& command);
void addReproduceCommand(CLI::App& app, Command& command);
void addCasesCommand(CLI::App& app, Command& command);
void addListCommand(CLI::App& app, Command& command);

}  // namespace timeshade
