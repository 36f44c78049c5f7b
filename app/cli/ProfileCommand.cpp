#include "cli/Arguments.h"
#include "project/Profiles.h"
#include "project/Project.h"
#include "sheet/prepress/PrinterColour.h"

#include "disk/SmallFile.h"
#include "project/ProfileFields.h"
#include "project/ProfileLibrary.h"
#include "project/ProjectFile.h"
#include "project/ProjectStore.h"
#include "settings/InkTones.h"
#include "texture/WedgeTable.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

namespace dipwright::cli {
namespace {

const QString setOption = QStringLiteral("set");
const QString iccOption = QStringLiteral("icc");
const QString linkOption = QStringLiteral("device-link");
const QString jsonOption = QStringLiteral("json");

ProfileKind takeKind(Words& words) {
    const QString word = words.take(QStringLiteral("KIND"));
    try {
        return profileKindOf(word);
    } catch (const Error& error) {
        throw UsageError(error.message(), error.where());
    }
}

const QString builtInMark = QStringLiteral(" (built in)"); // not part of the name

using Warn = std::function<void(const Error&)>;

void warnOfSeveralFiles(const ProfileEntry& entry, const Warn& warn) {
    if (const auto several = severalFiles(entry)) {
        warn(*several);
    }
}

void list(const Words& words, const QCommandLineParser& parser, QTextStream& out,
          const Warn& warn) {
    words.finish();
    QJsonArray array;
    for (const ProfileKind kind : {ProfileKind::Printer, ProfileKind::Film, ProfileKind::Tank}) {
        for (const ProfileEntry& entry : ProfileLibrary().profiles(kind)) {
            array.append(QJsonObject{{QStringLiteral("kind"), profileKindName(kind)},
                                     {QStringLiteral("name"), entry.name},
                                     {QStringLiteral("own"), entry.isUsers()}});
            if (!parser.isSet(jsonOption)) {
                out << QStringLiteral("%1 %2%3\n")
                           .arg(profileKindName(kind), -8)
                           .arg(entry.name, entry.isUsers() ? QString() : builtInMark);
            }
            warnOfSeveralFiles(entry, warn);
        }
    }
    if (parser.isSet(jsonOption)) {
        out << QJsonDocument(array).toJson();
    }
}

void show(Words words, QTextStream& out, const Warn& warn) {
    const ProfileKind kind = takeKind(words);
    const QString name = words.take(QStringLiteral("NAME"));
    words.finish();
    const ProfileLibrary library;
    out << QJsonDocument(toJson(library.profile(kind, name))).toJson();
    for (const ProfileEntry& entry : library.profiles(kind)) {
        if (entry.name == name) {
            warnOfSeveralFiles(entry, warn);
        }
    }
}

// Returns the profile that is to be changed; nothing for a new one.
std::optional<Profile> toChange(const ProfileLibrary& library, ProfileKind kind,
                                const QString& name) {
    library.requireOneFile(kind, name);
    const std::optional<Profile> known = library.found(kind, name);
    if (!known && name.endsWith(builtInMark) &&
        library.contains(kind, name.chopped(builtInMark.size()))) {
        throw UsageError(
            QStringLiteral("The words (built in) are a note of `list`, not part of the "
                           "name; the profile is called %1")
                .arg(name.chopped(builtInMark.size())),
            name);
    }
    return known;
}

// Throws Error if no sheet can be printed with the ICC profiles of a printer.
void requireUsableColours(const Profile& profile, const QString& where) {
    const auto* printer = std::get_if<PrinterProfile>(&profile);
    if (!printer) {
        return;
    }
    if (!printer->deviceLink.isEmpty() && printer->iccProfile.isEmpty()) {
        throw UsageError(QStringLiteral("A device link needs the printer's ICC profile, too; give "
                                        "it with --icc"),
                         where);
    }
    if (!printer->iccProfile.isEmpty()) {
        PrinterColour(*printer, where);
    }
}

// Reads the file that an option names into a member of a printer profile.
void setIccFile(Profile& profile, const QString& option, const QString& path,
                QByteArray PrinterProfile::*member) {
    auto* printer = std::get_if<PrinterProfile>(&profile);
    if (!printer) {
        throw UsageError(QStringLiteral("Only a printer profile has ICC profiles"),
                         QStringLiteral("--") + option);
    }
    printer->*member = readSmallFile(path, mostProfileBytes);
    requireUsableColours(profile, path);
}

// Without this check, `set printer scale=1` would make a profile of the name scale=1.
void refuseBareSetting(const QStringList& words) {
    static const QRegularExpression setting(QStringLiteral("[a-z_.]+=.*"));
    const qsizetype found = words.indexOf(setting);
    if (found >= 0) {
        throw UsageError(QStringLiteral("Write a setting as --set PATH=VALUE, after KIND and NAME"),
                         words[found]);
    }
}

void change(Words words, const QCommandLineParser& parser, QTextStream& out) {
    refuseBareSetting(parser.positionalArguments());
    const ProfileKind kind = takeKind(words);
    const QString name = words.take(QStringLiteral("NAME"));
    words.finish();
    const ProfileLibrary library;
    const std::optional<Profile> known = toChange(library, kind, name);
    Profile profile = known.value_or(newProfile(kind));
    std::visit([&](auto& value) { value.name = name; }, profile);
    for (const QString& setting : parser.values(setOption)) {
        const auto equals = setting.indexOf(QLatin1Char('='));
        if (equals <= 0) {
            throw UsageError(
                QStringLiteral("Write a setting as PATH=VALUE, for example scale=1.004;0.997"),
                QStringLiteral("--set %1").arg(setting));
        }
        try {
            setByPath(profile, setting.left(equals), setting.mid(equals + 1));
        } catch (const Error& error) {
            throw UsageError(error.message(), QStringLiteral("--set %1").arg(setting));
        }
        if (nameOf(profile) != name) {
            throw UsageError(
                QStringLiteral("A profile is not renamed by --set; export it, change the name in "
                               "the file, import the file, and remove the old profile"),
                QStringLiteral("--set %1").arg(setting));
        }
    }
    if (parser.isSet(iccOption)) {
        setIccFile(profile, iccOption, parser.value(iccOption), &PrinterProfile::iccProfile);
    }
    if (parser.isSet(linkOption)) {
        setIccFile(profile, linkOption, parser.value(linkOption), &PrinterProfile::deviceLink);
    }
    for (const QString& setting : parser.values(setOption)) {
        const QString path = setting.section(QLatin1Char('='), 0, 0);
        if (path == QLatin1String("icc_profile") || path == QLatin1String("device_link")) {
            requireUsableColours(profile, QStringLiteral("--set %1").arg(path));
        }
    }
    library.save(profile, known);
    out << QStringLiteral("Saved the %1 profile %2\n").arg(profileKindName(kind), nameOf(profile));
}

void import(Words words, QTextStream& out) {
    const QString path = words.take(QStringLiteral("FILE"));
    words.finish();
    const Profile profile = importProfile(path);
    requireUsableColours(profile, path);
    const ProfileLibrary library;
    const bool isKnown = library.contains(kindOf(profile), nameOf(profile));
    library.replace(profile);
    out << QStringLiteral("%1 the %2 profile %3\n")
               .arg(isKnown ? QStringLiteral("Replaced") : QStringLiteral("Saved"),
                    profileKindName(kindOf(profile)), nameOf(profile));
}

void exportOne(Words words, QTextStream& out) {
    const ProfileKind kind = takeKind(words);
    const QString name = words.take(QStringLiteral("NAME"));
    const QString path = words.take(QStringLiteral("FILE"));
    words.finish();
    const ProfileLibrary library;
    library.requireOneFile(kind, name);
    exportProfile(library.profile(kind, name), path);
    out << wrote(path);
}

void remove(Words words, QTextStream& out) {
    const ProfileKind kind = takeKind(words);
    const QString name = words.take(QStringLiteral("NAME"));
    words.finish();
    ProfileLibrary().remove(kind, name);
    out << QStringLiteral("Removed the %1 profile %2\n").arg(profileKindName(kind), name);
}

// From a step wedge's readings, finds the law by which ink thins on stretched film.
// Saves the law in a film profile.
void takeWedge(Words words, QTextStream& out) {
    const QString name = words.take(QStringLiteral("NAME"));
    const QString path = words.take(QStringLiteral("READINGS.csv"));
    words.finish();
    const ProfileLibrary library;
    const std::optional<Profile> known = toChange(library, ProfileKind::Film, name);
    FilmProfile film;
    if (known) {
        film = std::get<FilmProfile>(*known);
    }
    film.name = name;
    const FittedInk fitted = fitInk(readWedge(readSmallFile(path, mostWedgeBytes), path), path);
    film.ink.tones = fitted.law.tones;
    library.save(film, known);
    out << QStringLiteral("Ink      density   exponent       bend   up to stretch\n");
    for (const InkTone& tone : fitted.law.tones) {
        out << QStringLiteral("%1 %2 %3 %4 %5\n")
                   .arg(inkName(tone.ink), -8)
                   .arg(tone.density, 7, 'f', 2)
                   .arg(tone.exponent, 10, 'f', 3)
                   .arg(tone.bend, 10, 'f', 3)
                   .arg(tone.mostStretch, 15, 'f', 2);
    }
    out << QStringLiteral("The largest difference between a reading and the fit is a density of "
                          "%1. Saved in the film profile %2\n")
               .arg(fitted.worst, 0, 'f', 3)
               .arg(name);
}

void use(Words words, QTextStream& out) {
    const ProfileKind kind = takeKind(words);
    const QString name = words.take(QStringLiteral("NAME"));
    const QString path = words.take(QStringLiteral("JOB.dipw"));
    words.finish();
    const ProfileLibrary library;
    library.requireOneFile(kind, name);
    ProjectFile file(path);
    Project project = loadProject(path);
    applyProfile(project, library.profile(kind, name));
    file.save(project);
    out << QStringLiteral("%1 now uses the %2 profile %3\n").arg(path, profileKindName(kind), name);
}

class ProfileCommand : public Command {
public:
    QString name() const override { return QStringLiteral("profile"); }
    QString summary() const override {
        return QStringLiteral("Manages printer, film and tank profiles.");
    }

    void declare(CommandSyntax& syntax) const override {
        syntax.addPositionalArgument(
            QStringLiteral(
                "list | show KIND NAME | set KIND NAME | import FILE | export KIND NAME FILE | "
                "remove KIND NAME | use KIND NAME JOB.dipw | wedge NAME READINGS.csv"),
            QStringLiteral(
                "The action. KIND is printer, film or tank. `set` changes a profile or "
                "makes a new one. `use` copies a profile into a project. `wedge` computes "
                "how ink thins from the readings of a step wedge (`calibrate wedge`) "
                "and saves the result in a film profile."),
            QStringLiteral("ACTION"));
        syntax.addOption({setOption,
                          QStringLiteral("For `set`: sets a value by its path in the profile, for "
                                         "example scale=1.004;0.997. May be repeated."),
                          QStringLiteral("PATH=VALUE")});
        syntax.addOption({iccOption, QStringLiteral("For `set`: the printer's ICC profile."),
                          QStringLiteral("FILE")});
        syntax.addOption({linkOption,
                          QStringLiteral("For `set`: an ICC device link from RGB or CMYK to the "
                                         "printer's CMYK, which converts pictures of its kind."),
                          QStringLiteral("FILE")});
        syntax.addOption({jsonOption, QStringLiteral("For `list`: prints JSON.")});
    }

    void run(const QCommandLineParser& parser, Console& console) const override {
        Words words(name(), parser.positionalArguments());
        const QString action = words.take(QStringLiteral("The action"));
        refuseOptionsOfOthers(parser,
                              {{QStringLiteral("list"), {jsonOption}},
                               {QStringLiteral("set"), {setOption, iccOption, linkOption}},
                               {QStringLiteral("show"), {}},
                               {QStringLiteral("import"), {}},
                               {QStringLiteral("export"), {}},
                               {QStringLiteral("remove"), {}},
                               {QStringLiteral("wedge"), {}},
                               {QStringLiteral("use"), {}}},
                              action);
        QTextStream& out = console.out();
        if (action == QLatin1String("list")) {
            list(words, parser, out, console.warnings());
        } else if (action == QLatin1String("show")) {
            show(words, out, console.warnings());
        } else if (action == QLatin1String("set")) {
            change(words, parser, out);
        } else if (action == QLatin1String("import")) {
            import(words, out);
        } else if (action == QLatin1String("export")) {
            exportOne(words, out);
        } else if (action == QLatin1String("remove")) {
            remove(words, out);
        } else if (action == QLatin1String("wedge")) {
            takeWedge(words, out);
        } else if (action == QLatin1String("use")) {
            use(words, out);
        } else {
            throw UsageError(QStringLiteral("There is no such action; see --help"), action);
        }
    }
};

} // namespace

std::unique_ptr<Command> profileCommand() {
    return std::make_unique<ProfileCommand>();
}

} // namespace dipwright::cli
