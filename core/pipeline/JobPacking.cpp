#include "pipeline/JobPacking.h"

#include "base/Bytes.h"
#include "base/Error.h"
#include "disk/FolderTransaction.h"
#include "sheet/prepress/Separation.h"
#include "sheet/prepress/SheetFiles.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>

#include <array>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

const QString reportFile = QStringLiteral("films.json");

QString filmFile(std::size_t number, const char* suffix) {
    return QStringLiteral("film-%1.%2").arg(number + 1).arg(QLatin1String(suffix));
}

bool runsAlongHeight(QSizeF size, FeedDirection feed) {
    return (size.height() >= size.width()) == (feed == FeedDirection::ShortEdgeFirst);
}

// Whether the film's own web runs along its height.
bool isWebAlongHeight(const Project& project) {
    const FilmSettings& film = project.film;
    const std::optional<FilmProfile>& profile = project.profiles.film;
    return runsAlongHeight({film.width.value(), film.height.value()},
                           profile ? profile->feed : FeedDirection::ShortEdgeFirst);
}

// Returns how the film behaves on the water: swell across and along its web, relaxation and growth.
// A film has the same values whichever way round a sheet of it lies.
std::array<double, 5> behaviourOf(const Project& project) {
    const FilmSettings& film = project.film;
    std::array<double, 5> behaviour{film.swellX, film.swellY, film.relaxationTime.value(),
                                    grows(film) ? film.growthRate : 0,
                                    grows(film) ? film.growthLimit : 0};
    if (!isWebAlongHeight(project)) {
        std::swap(behaviour[0], behaviour[1]);
    }
    return behaviour;
}

// Returns the project's printer profile without the fields that do not change the print.
std::optional<PrinterProfile> printOf(const Project& project) {
    std::optional<PrinterProfile> printer = withoutCosts(project.profiles).printer;
    if (printer) {
        printer->name.clear();
        printer->queue.clear();
    }
    return printer;
}

// Throws Error if the sheets of two projects cannot be right on one film, or by one printer.
void refuseOtherMaterial(const Project& project, const Project& first) {
    if (behaviourOf(project) != behaviourOf(first)) {
        throw Error(Text::tr("The film of this job swells, relaxes or grows differently from that "
                             "of %1; pack only jobs for the same film together")
                        .arg(first.name),
                    project.name);
    }
    if (printOf(project) != printOf(first)) {
        throw Error(Text::tr("This job has another printer profile than %1; give both the same "
                             "profile (on the command line, --profile gives it to all jobs)")
                        .arg(first.name),
                    project.name);
    }
}

QJsonArray boxJson(const QRectF& box) {
    return {box.x(), box.y(), box.width(), box.height()};
}

QJsonObject pieceJson(const SheetPiece& piece) {
    const QPointF off = piece.picture.center() - piece.middle;
    return {{"project", piece.job.project},
            {"immersion", piece.job.immersion},
            {"job", piece.job.hash},
            {"dip", piece.dip},
            {"copy", piece.copy},
            {"copies", piece.copies},
            {"box_mm", boxJson(piece.box())},
            {"turned", piece.turned},
            {"picture_mm", QJsonArray{piece.picture.width(), piece.picture.height()}},
            {"picture_off_mm", QJsonArray{off.x(), off.y()}}};
}

QJsonObject filmJson(const Sheet& sheet, const PlannedFilm& film, std::size_t number) {
    QJsonArray pieces;
    for (const SheetPiece& piece : sheet.pieces) {
        pieces.append(pieceJson(piece));
    }
    return {{"file", filmFile(number, "pdf")},
            {"job", sheet.job.hash},
            {"size_mm", QJsonArray{film.size.width(), film.size.height()}},
            {"used", film.used},
            {"passes", sheet.passes},
            {"pieces", pieces}};
}

} // namespace

Turning turningOf(const Project& project, const PackSettings& settings) {
    const FilmSettings& film = project.film;
    if (film.swellX == film.swellY) {
        return settings.mayTurn ? Turning::Allowed : Turning::Never;
    }
    const bool own = isWebAlongHeight(project);
    const bool here = settings.film.isRoll || runsAlongHeight(settings.film.size, settings.feed);
    return own == here ? Turning::Never : Turning::Always;
}

Turning turningOnRoll(const Project& project) {
    PackSettings roll;
    roll.film.isRoll = true;
    roll.mayTurn = true;
    return turningOf(project, roll);
}

void checkProjects(const std::vector<ProjectToPack>& projects) {
    std::vector<PieceToPack> pieces;
    for (const ProjectToPack& packed : projects) {
        refuseOtherMaterial(packed.project, projects.front().project);
        for (const Immersion& immersion : packed.project.immersions) {
            PieceToPack piece;
            piece.sheet.settings = packed.project.sheet;
            piece.sheet.job.project = packed.project.name;
            piece.sheet.job.immersion = immersion.name;
            piece.copies = packed.copies;
            pieces.push_back(std::move(piece));
        }
    }
    checkSettings(pieces);
}

std::vector<PieceToPack> piecesOf(const JobResult& result, int copies,
                                  const PackSettings& settings) {
    std::vector<PieceToPack> pieces;
    for (std::size_t dip = 0; dip < result.immersions.size(); ++dip) {
        pieces.push_back({result.immersions[dip].sheet, int(dip) + 1, copies,
                          turningOf(result.project, settings)});
    }
    return pieces;
}

PackedFilms packedFilms(std::vector<PieceToPack> pieces, const PackSettings& settings) {
    PackedFilms films{std::move(pieces), settings, {}};
    films.plan = planFilms(films.pieces, settings.film);
    return films;
}

Sheet sheetOf(const PackedFilms& films, std::size_t number) {
    return filmSheet(films.pieces, films.settings.film, films.plan, number);
}

QStringList filmsText(const PackedFilms& films) {
    QStringList lines;
    for (std::size_t number = 0; number < films.plan.films.size(); ++number) {
        const PlannedFilm& film = films.plan.films[number];
        lines << Text::tr("Film %1: %2 × %3 mm, pieces: %4, used area: %5 %")
                     .arg(number + 1)
                     .arg(QString::number(film.size.width(), 'f', 0),
                          QString::number(film.size.height(), 'f', 0))
                     .arg(film.pieces.size())
                     .arg(QString::number(100 * film.used, 'f', 0));
    }
    return lines;
}

QStringList filmsWarnings(const PackedFilms& films) {
    if (!losesInks(films.pieces)) {
        return {};
    }
    return {Text::tr("The jobs differ in their ink settings or CMYK profiles, so that the films do "
                     "not keep all amounts of ink of CMYK pictures or compensate each ink by "
                     "itself; give all jobs the same ink settings and profiles")};
}

QStringList lostInFiles(const PackedFilms& films) {
    QStringList lost;
    for (const PieceToPack& piece : films.pieces) {
        for (const QString& sentence : lostPlates(piece.sheet, false)) {
            if (!lost.contains(sentence)) {
                lost << sentence;
            }
        }
    }
    return lost;
}

QStringList filmFiles() {
    QStringList files{reportFile};
    for (int number = 0; number < mostFilms; ++number) {
        for (const char* suffix : {"pdf", "png", "tif"}) {
            files << filmFile(std::size_t(number), suffix);
        }
    }
    return files;
}

void checkFilmsFolder(const QString& folder) {
    FolderTransaction(folder, filmFiles());
}

void writeFilms(const PackedFilms& films, const QString& folder, const Progress& progress) {
    FolderTransaction results(folder, filmFiles());
    const std::size_t count = films.plan.films.size();
    QJsonArray list;
    for (std::size_t number = 0; number < count; ++number) {
        progress(double(number) / double(count), Text::tr("Writing film %1").arg(number + 1));
        progress.cancelToken.throwIfCancelled();
        const Sheet sheet = sheetOf(films, number);
        const PreparedSheet prepared = preparedSheet(sheet, {});
        results.write(filmFile(number, "png"), sheetPng(prepared));
        results.write(filmFile(number, "pdf"), sheetPdf(prepared, {}));
        results.write(filmFile(number, "tif"),
                      bytesOf([&](QIODevice& device) { writeSheetTiff(sheet, device); }));
        list.append(filmJson(sheet, films.plan.films[number], number));
    }
    const QJsonObject report{{"format", "dipwright-films"},
                             {"version", 1},
                             {"dpi", films.pieces.front().sheet.settings.resolution.value()},
                             {"films", list}};
    results.write(reportFile, QJsonDocument(report).toJson());
    progress(1, Text::tr("Moving the results to their folder"));
    progress.cancelToken.throwIfCancelled();
    results.commit();
}

} // namespace dipwright
