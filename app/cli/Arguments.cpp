#include "cli/Arguments.h"

#include "base/Error.h"
#include "base/OneLine.h"
#include "disk/SmallFile.h"
#include "import/trusted/ReadPictures.h"
#include "project/Project.h"
#include "project/ProjectStore.h"
#include "project/ProjectValues.h"
#include "solver/SolverRegistry.h"

#include <QStringList>
#include <algorithm>
#include <cmath>

namespace dipwright::cli {
namespace {

const QString setOption = QStringLiteral("set");
const QString threadsOption = QStringLiteral("threads");
const QString solverOption = QStringLiteral("solver");
const QString filmImageOption = QStringLiteral("film-image");
constexpr int mostThreads = 1024;
constexpr qint64 mostValueBytes = 32 << 20; // of a value in a file

// Tells whether a value that begins with @ is the name of a file.
bool mayBeInFile(const QString& path) {
    static const QStringList lists{QStringLiteral("masks"), QStringLiteral("tolerance.marks"),
                                   QStringLiteral("share.marks")};
    return lists.contains(path);
}

Setting parsedSetting(const QString& text) {
    const auto equals = text.indexOf(QLatin1Char('='));
    if (equals <= 0) {
        throw UsageError(
            QStringLiteral("Write a setting as PATH=VALUE, for example film.points=240x360"),
            QStringLiteral("--set %1").arg(text));
    }
    const QString path = text.left(equals).trimmed();
    const QString value = text.mid(equals + 1).trimmed();
    return {path,
            value.startsWith(QLatin1Char('@')) && mayBeInFile(path)
                ? QString::fromUtf8(readSmallFile(value.mid(1), mostValueBytes))
                : value,
            QStringLiteral("--set %1=%2").arg(path, value.left(200))};
}

[[noreturn]] void throwMissing(const QString& argument) {
    throw UsageError(QStringLiteral("%1 is missing; see --help").arg(argument),
                     QStringLiteral("command line"));
}

[[noreturn]] void throwTooMany(const QString& argument) {
    throw UsageError(QStringLiteral("There are too many arguments; see --help"), argument);
}

} // namespace

QString positionalArgument(const QCommandLineParser& parser, const QString& name) {
    const QStringList arguments = parser.positionalArguments();
    if (arguments.value(0).isEmpty()) {
        throwMissing(name);
    }
    if (arguments.size() > 1) {
        throwTooMany(arguments.at(1));
    }
    return arguments.first();
}

void requireNoPositionalArgument(const QCommandLineParser& parser) {
    if (const QStringList arguments = parser.positionalArguments(); !arguments.isEmpty()) {
        throwTooMany(arguments.first());
    }
}

QString Words::take(const QString& what) {
    if (words_.isEmpty()) {
        throw UsageError(QStringLiteral("%1 is missing; see --help").arg(what), command_);
    }
    return words_.takeFirst();
}

void Words::finish() const {
    if (!words_.isEmpty()) {
        throw UsageError(QStringLiteral("There are too many arguments; see --help"),
                         words_.first());
    }
}

void refuseOptions(const QCommandLineParser& parser, const QStringList& options,
                   const QString& when) {
    for (const QString& option : options) {
        if (parser.isSet(option)) {
            throw UsageError(
                QStringLiteral("--%1 has no effect %2; leave it out").arg(option, when),
                QStringLiteral("--") + option);
        }
    }
}

void refuseOptionsOfOthers(const QCommandLineParser& parser, const QMap<QString, QStringList>& uses,
                           const QString& action) {
    const QStringList used = uses.value(action);
    if (!uses.contains(action)) {
        return;
    }
    for (QStringList options : uses) {
        options.removeIf([&](const QString& option) { return used.contains(option); });
        refuseOptions(parser, options, QStringLiteral("with `%1`").arg(action));
    }
}

double numberOption(const QCommandLineParser& parser, const QString& option, double minimum,
                    double maximum) {
    bool isNumber = false;
    const double number = parser.value(option).toDouble(&isNumber);
    if (!isNumber || !(number >= minimum && number <= maximum)) {
        throw UsageError(QStringLiteral("“%1” is not valid; give a number from %2 to %3")
                             .arg(parser.value(option))
                             .arg(minimum)
                             .arg(maximum, 0, 'g', 10),
                         QStringLiteral("--") + option);
    }
    return number;
}

int wholeNumberOption(const QCommandLineParser& parser, const QString& option, int minimum,
                      int maximum) {
    const double number = numberOption(parser, option, minimum, maximum);
    if (number != std::floor(number)) {
        throw UsageError(QStringLiteral("“%1” is not a whole number").arg(parser.value(option)),
                         QStringLiteral("--") + option);
    }
    return int(number);
}

QString pictureOption(const QCommandLineParser& parser, const QString& option,
                      const QStringList& endings) {
    QString path = parser.value(option);
    const auto ends = [&](const QString& ending) {
        return path.endsWith(ending, Qt::CaseInsensitive);
    };
    if (parser.isSet(option) && std::none_of(endings.begin(), endings.end(), ends)) {
        throw UsageError(QStringLiteral("“%1” is not valid; name a file that ends in %2")
                             .arg(path, endings.join(QStringLiteral(" or "))),
                         QStringLiteral("--") + option);
    }
    return path;
}

void setByOption(Project& project, const QString& path, const QString& value,
                 const QString& option) {
    asUsage(option, [&] { setByPath(project, path, value); });
}

QString solverNamed(const QCommandLineParser& parser, const SolverRegistry& registry) {
    const QString id = parser.value(solverOption);
    const auto& all = registry.described();
    const bool isKnown = std::any_of(all.begin(), all.end(),
                                     [&](const SolverInfo& solver) { return solver.id == id; });
    if (!isKnown && parser.isSet(solverOption) && id != QLatin1String("auto")) {
        asUsage(QStringLiteral("--solver"), [&] { return registry.info(id); });
    }
    return id;
}

QString wrote(const QString& path) {
    return QStringLiteral("Wrote %1\n").arg(oneLine(path));
}

void requireReplaceable(const QString& path, const std::function<bool(const QByteArray&)>& isOwn,
                        const QString& kind) {
    constexpr qint64 bytes = 64 << 10;
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly)) {
        return; // who writes the file reports what is wrong, if anything
    }
    const QByteArray begin = file.read(bytes);
    if (!begin.isEmpty() && !isOwn(begin)) {
        throw Error(QStringLiteral("This file exists and is not %1; name another file").arg(kind),
                    path);
    }
}

void declareSettings(CommandSyntax& syntax, bool areStored) {
    syntax.addOption({setOption,
                      QStringLiteral("Sets a value by its path in the project file, for example "
                                     "film.points=240x360 or immersions[0].rotation_deg=0;45;0. "
                                     "May be repeated. %1")
                          .arg(areStored ? QStringLiteral("The project file stores the value.")
                                         : QStringLiteral("The value holds for this command only; "
                                                          "the project file does not change.")),
                      QStringLiteral("PATH=VALUE")});
}

void applySettings(Project& project, const QCommandLineParser& parser) {
    std::vector<Setting> settings;
    for (const QString& text : parser.values(setOption)) {
        settings.push_back(parsedSetting(text));
    }
    applySettings(project, std::move(settings));
}

void applySettings(Project& project, std::vector<Setting> settings) {
    std::ranges::stable_sort(settings, {},
                             [](const Setting& setting) { return settingOrder(setting.path); });
    for (const Setting& setting : settings) {
        setByOption(project, setting.path, setting.value, setting.where);
    }
}

void declareProject(CommandSyntax& syntax) {
    syntax.addPositionalArgument(QStringLiteral("JOB.dipw"), QStringLiteral("The project."));
    declareSettings(syntax);
}

QString projectPath(const QCommandLineParser& parser) {
    return positionalArgument(parser, QStringLiteral("JOB.dipw"));
}

Project projectArgument(const QCommandLineParser& parser) {
    return readProject(projectPath(parser), parser);
}

void declareProjects(CommandSyntax& syntax, const QString& whatHappens) {
    syntax.addPositionalArgument(QStringLiteral("JOB.dipw"),
                                 QStringLiteral("The project. ") + whatHappens);
    declareSettings(syntax);
}

QStringList projectPaths(const QCommandLineParser& parser) {
    const QStringList paths = parser.positionalArguments();
    if (paths.isEmpty() || paths.contains(QString())) {
        throwMissing(QStringLiteral("JOB.dipw"));
    }
    return paths;
}

Project readProject(const QString& path, const QCommandLineParser& parser) {
    Project project = loadProject(path);
    applySettings(project, parser);
    return project;
}

void printWarnings(const QStringList& warnings, QTextStream& out) {
    for (const QString& warning : warnings) {
        out << "warning: " << warning << '\n';
    }
}

void declareFilmImage(CommandSyntax& syntax) {
    syntax.addOption(
        {filmImageOption,
         QStringLiteral("The picture to print, stretched to the whole film, or the "
                        "built-in chessboard. The proof shows where it lands on the part."),
         QStringLiteral("chessboard|FILE")});
}

void declareChessboard(CommandSyntax& syntax, const QString& description) {
    syntax.addOption({filmImageOption, description, QStringLiteral("chessboard")});
}

void applyFilmImage(JobOptions& options, const QCommandLineParser& parser) {
    const QString picture = parser.value(filmImageOption);
    options.chessboard = picture == QLatin1String("chessboard");
    if (!picture.isEmpty() && !options.chessboard) {
        const ReadPicture read = readPictureAndInks(picture);
        options.filmImage = read.colours;
        options.filmInks = read.inks;
    }
}

void declareThreads(CommandSyntax& syntax) {
    syntax.addOption({threadsOption,
                      QStringLiteral("Uses at most N threads. The results do not depend on N."),
                      QStringLiteral("N")});
}

ThreadLimit threadLimit(const QCommandLineParser& parser) {
    return ThreadLimit(
        parser.isSet(threadsOption) ? wholeNumberOption(parser, threadsOption, 1, mostThreads) : 0);
}

} // namespace dipwright::cli
