#include "cli/Arguments.h"
#include "cli/InspectBuilt.h"
#include "cli/InspectFit.h"
#include "cli/InspectPart.h"

#include "import/trusted/ReadPhotos.h"
#include "inspection/FilmWatchFiles.h"
#include "project/ProfileLibrary.h"

#include <QDate>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace dipwright::cli {
namespace {

const QString outOption = QStringLiteral("out");
const QString timeOption = QStringLiteral("time");
const QString laidOption = QStringLiteral("laid");
const QString dipOption = QStringLiteral("dip-at");
const QString profileOption = QStringLiteral("profile");
const QString lotOption = QStringLiteral("lot");
const QString dateOption = QStringLiteral("date");
const QString waterOption = QStringLiteral("water-temperature");
const QString cardRulersOption = QStringLiteral("card-rulers");
const QString filmRulersOption = QStringLiteral("film-rulers");
const QString cardAboveOption = QStringLiteral("card-above");
const QString rulerErrorOption = QStringLiteral("ruler-error");
const QString focalOption = QStringLiteral("focal-35mm");
const QString lensOption = QStringLiteral("lens");

// Reads two numbers within limits, joined by x.
std::array<double, 2> pairOption(const QCommandLineParser& parser, const QString& option,
                                 double minimum, double maximum) {
    const QStringList parts =
        parser.value(option).split(QRegularExpression(QStringLiteral("[x;]")));
    std::array<double, 2> numbers{};
    bool isGood = parts.size() == 2;
    for (std::size_t i = 0; isGood && i < 2; ++i) {
        numbers[i] = parts[qsizetype(i)].trimmed().toDouble(&isGood);
        isGood = isGood && numbers[i] >= minimum && numbers[i] <= maximum;
    }
    if (!isGood) {
        throw UsageError(
            QStringLiteral("“%1” is not valid; give two numbers from %2 to %3, joined by x")
                .arg(parser.value(option))
                .arg(minimum)
                .arg(maximum),
            QStringLiteral("--") + option);
    }
    return numbers;
}

std::optional<Lens> lensOf(const QCommandLineParser& parser) {
    if (!parser.isSet(lensOption)) {
        return std::nullopt;
    }
    const auto [k1, k2] = pairOption(parser, lensOption, -1, 1);
    return Lens{k1, k2};
}

std::array<Millimetres, 2> rulersOf(const QCommandLineParser& parser, const QString& option) {
    if (!parser.isSet(option)) {
        return FilmOnWater().cardRulers;
    }
    const auto measured = pairOption(parser, option, leastRuler, mostRuler);
    return {Millimetres(measured[0]), Millimetres(measured[1])};
}

// Returns the film, the card and the camera as the options describe them.
FilmOnWater filmOnWater(const QCommandLineParser& parser) {
    FilmOnWater filmOptions;
    filmOptions.cardRulers = rulersOf(parser, cardRulersOption);
    filmOptions.filmRulers = rulersOf(parser, filmRulersOption);
    if (parser.isSet(rulerErrorOption)) {
        filmOptions.rulerError =
            Millimetres(numberOption(parser, rulerErrorOption, 0, mostRulerError));
    }
    if (const auto lens = lensOf(parser)) {
        filmOptions.lensK1 = lens->k1;
        filmOptions.lensK2 = lens->k2;
    }
    if (parser.isSet(cardAboveOption)) {
        filmOptions.cardAbove =
            Millimetres(numberOption(parser, cardAboveOption, -mostCardAbove, mostCardAbove));
    }
    if (parser.isSet(focalOption)) {
        filmOptions.focalAs35 =
            Millimetres(numberOption(parser, focalOption, leastFocal, mostFocal));
    }
    return filmOptions;
}

// Finds the time of each photo, in seconds since the film was laid on the water.
class Clock {
public:
    Clock(const QCommandLineParser& parser, qsizetype photos) {
        for (const QString& text : parser.values(timeOption)) {
            bool isNumber = false;
            times_.push_back(text.toDouble(&isNumber));
            if (!isNumber || !(times_.back() >= 0 && times_.back() <= longestWatch)) {
                throw UsageError(
                    QStringLiteral(
                        "“%1” is not a number of seconds since the film was laid on the water")
                        .arg(text),
                    QStringLiteral("--time"));
            }
        }
        if (!times_.empty() && qsizetype(times_.size()) != photos) {
            throw UsageError(QStringLiteral("Give one time for each photo, in the same order"),
                             QStringLiteral("--time"));
        }
        if (parser.isSet(laidOption)) {
            laid_ = QDateTime::fromString(parser.value(laidOption), Qt::ISODate);
            if (!times_.empty()) {
                throw UsageError(QStringLiteral("Give --time or --laid, not both"),
                                 QStringLiteral("--laid"));
            }
            if (!laid_.isValid() || laid_.timeSpec() != Qt::LocalTime) { // cameras state no zone
                throw UsageError(
                    QStringLiteral("“%1” is not a date and time; write it as 2026-11-22T14:03:07")
                        .arg(parser.value(laidOption)),
                    QStringLiteral("--laid"));
            }
        }
        if (photos > 1 && times_.empty() && !laid_.isValid()) {
            throw UsageError(
                QStringLiteral("Several photos need times: give --time SECONDS for each photo, or "
                               "--laid with the camera's time when the film was laid on the water"),
                QStringLiteral("--time"));
        }
    }

    std::optional<double> secondsOf(const Photo& photo, std::size_t index) const {
        if (!times_.empty()) {
            return times_[index];
        }
        if (!laid_.isValid()) {
            return std::nullopt;
        }
        const double seconds = photo.taken ? double(laid_.msecsTo(*photo.taken)) / 1000 : -1;
        if (!(seconds >= 0 && seconds <= longestWatch)) {
            throw Error(
                photo.taken
                    ? QStringLiteral("The photo was taken before the film was laid, or days after; "
                                     "compare --laid with the camera's clock")
                    : QStringLiteral(
                          "The photo does not say when it was taken; give the times with --time"),
                photo.where);
        }
        return seconds;
    }

private:
    std::vector<double> times_;
    QDateTime laid_;
};

WatchNotes notesOf(const QCommandLineParser& parser, const std::optional<QDateTime>& taken) {
    WatchNotes notes;
    notes.date = parser.value(dateOption);
    if (notes.date.isEmpty()) {
        const QDate day = taken ? taken->date() : QDate::currentDate();
        notes.date = day.toString(Qt::ISODate);
    } else if (!QDate::fromString(notes.date, Qt::ISODate).isValid()) {
        throw UsageError(
            QStringLiteral("“%1” is not a date; write it as 2026-11-22").arg(notes.date),
            QStringLiteral("--date"));
    }
    notes.lot = parser.value(lotOption);
    if (parser.isSet(waterOption)) {
        notes.waterTemperature = numberOption(parser, waterOption, 0, 100);
    }
    return notes;
}

// The film profile that --profile names, to which the measurements are written: an existing or a
// new profile.
struct Target {
    std::optional<Profile> known;
    FilmProfile profile;
};

Target targetOf(const QCommandLineParser& parser) {
    const QString name = parser.value(profileOption);
    Target target;
    target.profile.name = name;
    if (!name.isEmpty()) {
        target.known = ProfileLibrary().found(ProfileKind::Film, name);
        if (target.known) {
            target.profile = std::get<FilmProfile>(*target.known);
        }
    }
    return target;
}

class InspectCommand : public Command {
public:
    QString name() const override { return QStringLiteral("inspect"); }
    QString summary() const override {
        return QStringLiteral("Measures a film on the water, or a dipped part, from photos.");
    }

    void declare(CommandSyntax& syntax) const override {
        syntax.addPositionalArgument(
            QStringLiteral("film FILE… | part FILE… | fit FILE… | built FILE…"),
            QStringLiteral("The photos. For `film`: the page of “calibrate film” floats on the "
                           "water, and the card of “calibrate card” lies beside it in each photo. "
                           "Otherwise: photos of a dipped part."),
            QStringLiteral("FILE"));
        syntax.addOption(
            {outOption, QStringLiteral("The folder for the results. It is made if it is missing."),
             QStringLiteral("DIR")});
        declarePart(syntax);
        declareFit(syntax);
        declareBuilt(syntax);
        syntax.addOption({timeOption,
                          QStringLiteral("The time of a photo, in seconds since the film was laid "
                                         "on the water. Give it once for each photo."),
                          QStringLiteral("SECONDS")});
        syntax.addOption({laidOption,
                          QStringLiteral("Instead of --time: when the film was laid, by the "
                                         "camera's clock, for example 2026-11-22T14:03:07."),
                          QStringLiteral("TIME")});
        syntax.addOption(
            {dipOption,
             QStringLiteral("The start of the dip, in seconds since the film was laid. Without it: "
                            "the profile's soak time plus its activator time."),
             QStringLiteral("SECONDS")});
        syntax.addOption({profileOption,
                          QStringLiteral("The film profile to which the measurements are saved. It "
                                         "is made if it does not exist."),
                          QStringLiteral("NAME")});
        syntax.addOption({lotOption, QStringLiteral("The film's lot."), QStringLiteral("TEXT")});
        syntax.addOption(
            {dateOption,
             QStringLiteral(
                 "The date of the photos. Without it: the date of the first photo, or today."),
             QStringLiteral("DATE")});
        syntax.addOption({waterOption, QStringLiteral("The water temperature in °C."),
                          QStringLiteral("DEGREES")});
        syntax.addOption({cardRulersOption,
                          QStringLiteral("The measured lengths of the card's two rulers, across "
                                         "and down, in mm. Without it 100x100."),
                          QStringLiteral("XxY")});
        syntax.addOption(
            {filmRulersOption,
             QStringLiteral("The measured lengths of the dry film's two rulers, in mm."),
             QStringLiteral("XxY")});
        syntax.addOption({rulerErrorOption,
                          QStringLiteral("The error of each ruler reading in mm, at 95 %. It "
                                         "widens the interval of the swell."),
                          QStringLiteral("MM")});
        syntax.addOption({cardAboveOption,
                          QStringLiteral("The height of the card's print above the film in mm."),
                          QStringLiteral("MM")});
        syntax.addOption(
            {focalOption,
             QStringLiteral("The camera's focal length as the 35 mm equivalent, if the photos do "
                            "not contain it. Needed only for --card-above."),
             QStringLiteral("MM")});
        syntax.addOption({lensOption,
                          QStringLiteral("The lens distortion k1xk2 as film-watch.json states it, "
                                         "instead of the value found from each photo."),
                          QStringLiteral("K1xK2")});
    }

    void run(const QCommandLineParser& parser, Console& console) const override {
        QStringList files = parser.positionalArguments();
        const QString subject = files.isEmpty() ? QString() : files.takeFirst();
        static const QStringList subjects{QStringLiteral("film"), QStringLiteral("part"),
                                          QStringLiteral("fit"), QStringLiteral("built")};
        if (files.isEmpty() || !subjects.contains(subject)) {
            throw UsageError(
                QStringLiteral("Name the action (film, part, fit or built) and the photos"),
                QStringLiteral("film FILE… | part FILE… | fit FILE… | built FILE…"));
        }
        refuseOptionsOfOthers(parser, optionsOfActions(), subject);
        if (parser.value(outOption).isEmpty()) {
            throw UsageError(QStringLiteral("Name the folder for the results with --out DIR"),
                             QStringLiteral("--out"));
        }
        if (subject == QLatin1String("film")) {
            inspectFilm(files, parser, console);
        } else if (subject == QLatin1String("part")) {
            inspectPart(files, parser, lensOf(parser), console);
        } else if (subject == QLatin1String("fit")) {
            inspectFit(files, parser, console);
        } else {
            inspectBuilt(
                files, parser, lensOf(parser),
                [&](const auto& taken) { return notesOf(parser, taken).date; }, console);
        }
    }

private:
    // Returns the options of each action, except --out and --lens, which all of them use.
    static QMap<QString, QStringList> optionsOfActions() {
        const auto words = [](const char* text) { return QString::fromLatin1(text).split(u' '); };
        return {{QStringLiteral("film"),
                 words("time laid dip-at profile lot date water-temperature card-rulers "
                       "film-rulers ruler-error card-above focal-35mm")},
                {QStringLiteral("part"), words("pairs project film-image keep-camera")},
                {QStringLiteral("fit"),
                 words("pairs project film-image keep-camera places fit update-job profile lot "
                       "date water-temperature")},
                {QStringLiteral("built"),
                 words("pairs project film-image keep-camera places update-job accepted-by "
                       "correct date")}};
    }

    static void inspectFilm(const QStringList& files, const QCommandLineParser& parser,
                            Console& console) {
        const FilmOnWater filmOptions = filmOnWater(parser);
        const Clock clock(parser, files.size());
        Target target = targetOf(parser);
        const double begin =
            parser.isSet(dipOption)
                ? numberOption(parser, dipOption, 0, longestWatch)
                : target.profile.soakTime.value() + target.profile.activatorTime.value();
        notesOf(parser, {});
        const Progress progress = console.progress();
        std::vector<WatchedPhoto> photos;
        std::optional<QDateTime> taken;
        for (qsizetype i = 0; i < files.size(); ++i) {
            progress(double(i) / double(files.size()), files[i]);
            const Photo photo = readPhotoFile(files[i], progress);
            const auto seconds = clock.secondsOf(photo, std::size_t(i));
            taken = i == 0 ? photo.taken : taken;
            photos.push_back(
                {files[i], photo.sha256, seconds, photo.picture.size(),
                 measureFlatFilm(photo.picture,
                                 flatSettings(filmOptions, photo.focalLength, files[i]),
                                 files[i])});
        }
        progress(1, QStringLiteral("Done"));
        finish(evaluatedFilmWatch(std::move(photos), begin, filmOptions.rulerError.value()),
               notesOf(parser, taken), std::move(target), parser.value(outOption), console);
    }

    static void inspectFit(const QStringList& files, const QCommandLineParser& parser,
                           Console& console) {
        Target target = targetOf(parser);
        notesOf(parser, {});
        const FittedPart part = fitPart(files, parser, lensOf(parser), console);
        const WatchNotes notes = notesOf(parser, part.taken);
        const bool hasProfile = !target.profile.name.isEmpty();
        QString otherFilm;
        if (hasProfile) { // fails before anything is written
            if (!target.known) {
                target.profile = newProfileFor(part.project, target.profile.name);
            }
            otherFilm = otherFilmNote(target.profile, part.project, part.fit);
            target.profile = withFit(target.profile, part.fit, part.photos, notes);
        }
        writeFilmFit(part.fit, part.pairs, part.photos, notes, parser.value(outOption));
        for (const QString& sentence : fitSentences(part.fit)) {
            console.out() << sentence << '\n';
        }
        updateJob(part, parser, console);
        save(target, console);
        if (!otherFilm.isEmpty()) {
            console.out() << otherFilm << '\n';
        }
    }

    static void save(const Target& target, Console& console) {
        if (!target.profile.name.isEmpty()) {
            ProfileLibrary().save(target.profile, target.known);
            console.out() << QStringLiteral("Saved the measurements in the film profile %1\n")
                                 .arg(target.profile.name);
        }
    }

    static void finish(const FilmWatch& watch, const WatchNotes& notes, Target target,
                       const QString& folder, Console& console) {
        const bool hasProfile = !target.profile.name.isEmpty();
        if (hasProfile) { // fails before anything is written
            target.profile = withMeasurement(target.profile, watch, notes);
        }
        writeFilmWatch(watch, notes, folder);
        for (const WatchedPhoto& photo : watch.photos) {
            const FlatFilm& film = photo.film;
            console.out()
                << QStringLiteral(
                       "%1: %2 corners of the film and %3 of the card, rms residual %4 px\n")
                       .arg(photo.where)
                       .arg(film.corners.size())
                       .arg(film.cardCorners.size())
                       .arg(film.residualPixels, 0, 'f', 3);
        }
        for (const QString& sentence : watchSentences(watch)) {
            console.out() << sentence << '\n';
        }
        save(target, console);
    }
};

} // namespace

std::unique_ptr<Command> inspectCommand() {
    return std::make_unique<InspectCommand>();
}

} // namespace dipwright::cli
