#include "pipeline/WriteResults.h"

#include "base/Error.h"
#include "base/Png.h"
#include "cradle/CradleFiles.h"
#include "disk/FolderTransaction.h"
#include "parallel/Tasks.h"
#include "pipeline/JobCradles.h"
#include "pipeline/JobProof.h"
#include "pipeline/JobTicket.h"
#include "pipeline/JobTraveller.h"
#include "pipeline/Pipeline.h"
#include "pipeline/Report.h"
#include "results/Results.h"
#include "sheet/prepress/SheetFiles.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QSet>

#include <algorithm>
#include <functional>
#include <iterator>
#include <mutex>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

constexpr int filmMapEdge = 1600; // pixels

QString cradleFile(int number, const char* suffix) {
    return QStringLiteral("cradle-%1.%2").arg(number).arg(QLatin1String(suffix));
}

QString motionFile(int number, const char* suffix) {
    return QStringLiteral("motion-%1.%2").arg(number).arg(QLatin1String(suffix));
}

QStringList cradleFiles() {
    return {cradleFile(1, "stl"), cradleFile(1, "3mf"), cradleFile(2, "stl"), cradleFile(2, "3mf")};
}

// Returns the names of all files that a run may write. Includes both immersions, so that a run with
// a single immersion also removes an earlier run's files of the second.
QStringList resultFiles() {
    QStringList files = cradleFiles();
    files += {QStringLiteral("proof.png"),    QStringLiteral("proof-without-white.png"),
              QStringLiteral("coverage.png"), QStringLiteral("report.json"),
              QStringLiteral("ticket.json"),  QStringLiteral("traveller.pdf")};
    for (const int number : {1, 2}) {
        files += {motionFile(number, "csv"), motionFile(number, "gcode")};
    }
    for (const int number : {1, 2}) {
        for (const char* name : {"sheet.png", "sheet.pdf", "film.vtp", "body.vtp", "stretch.png",
                                 "wrinkling.png", "certainty.png", "tolerance.png"}) {
            files.append(immersionFolder(number) + QLatin1String(name));
        }
    }
    return files;
}

// A task that writes some of the files. Tasks run in parallel, because compressing pictures takes
// far longer than writing to the disk.
struct Piece {
    QString text;
    std::function<void()> write;
};

void writeTogether(const std::vector<Piece>& pieces, const Progress& progress) {
    std::mutex mutex;
    std::size_t written = 0;
    Tasks writing;
    for (const Piece& piece : pieces) {
        writing.run([&] {
            {
                const std::scoped_lock lock(mutex);
                progress(double(written) / double(pieces.size()), piece.text);
            }
            piece.write();
            const std::scoped_lock lock(mutex);
            ++written;
        });
    }
    writing.wait();
}

enum class SheetFormats { Png, Pdf, Both };

void addSheet(std::vector<Piece>& pieces, const ImmersionResult& result, const QString& prefix,
              SheetFormats formats, const FolderTransaction& folder) {
    const QString text = Text::tr("Writing the sheet of %1").arg(result.immersion.name);
    pieces.push_back({text, [&result, prefix, formats, &folder] {
                          const PreparedSheet sheet = preparedSheet(result.sheet, {});
                          if (formats != SheetFormats::Pdf) {
                              folder.write(prefix + QStringLiteral("sheet.png"), sheetPng(sheet));
                          }
                          if (formats != SheetFormats::Png) {
                              folder.write(prefix + QStringLiteral("sheet.pdf"),
                                           sheetPdf(sheet, {}));
                          }
                      }});
}

void addFilm(std::vector<Piece>& pieces, const ImmersionResult& result, const QString& prefix,
             const FolderTransaction& folder) {
    pieces.push_back(
        {Text::tr("Writing the film of %1").arg(result.immersion.name), [&result, prefix, &folder] {
             folder.write(prefix + QStringLiteral("film.vtp"),
                          filmVtp(*result.laid, *result.appearance));
             folder.write(prefix + QStringLiteral("body.vtp"),
                          bodyVtp(*result.body, *result.appearance, *result.coverage));
         }});
}

// Adds the tasks for the film's maps. `allowedError` is the limit of the numerical error map, mm.
void addMaps(std::vector<Piece>& pieces, const ImmersionResult& result, const QString& prefix,
             double allowedError, const FolderTransaction& folder) {
    const QString text = Text::tr("Writing the stretch maps of %1").arg(result.immersion.name);
    pieces.push_back({text, [&result, prefix, &folder] {
                          const QString name = prefix + QStringLiteral("stretch.png");
                          folder.write(name, pngBytes(stretchMap(*result.laid, filmMapEdge), name));
                      }});
    pieces.push_back({text, [&result, prefix, &folder] {
                          const QString name = prefix + QStringLiteral("wrinkling.png");
                          folder.write(name,
                                       pngBytes(wrinklingMap(*result.laid, filmMapEdge), name));
                      }});
    if (result.knownError()) {
        pieces.push_back({text, [&result, prefix, allowedError, &folder] {
                              const QString name = prefix + QStringLiteral("certainty.png");
                              const QImage map =
                                  numericalErrorMap(*result.laid, result.knownError()->pointErrors,
                                                    allowedError, filmMapEdge);
                              folder.write(name, pngBytes(map, name));
                          }});
    }
}

// Returns the tasks for immersion `number`, counted from 0. They keep references to all other
// arguments.
std::vector<Piece> immersionPieces(const Project& project, const ImmersionResult& result,
                                   std::size_t number, const FolderTransaction& folder) {
    const QString prefix = immersionFolder(int(number) + 1);
    std::vector<Piece> pieces;
    addSheet(pieces, result, prefix, SheetFormats::Both, folder);
    addFilm(pieces, result, prefix, folder);
    addMaps(pieces, result, prefix, allowedError(Zone::C, project.tolerance), folder);
    return pieces;
}

// Returns the tasks for the cradles that have a mesh. They keep references to all arguments.
std::vector<Piece> cradlePieces(const JobResult& result, const std::vector<Cradle>& cradles,
                                const FolderTransaction& folder) {
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < cradles.size(); ++i) {
        if (cradles[i].mesh.triangles.empty()) {
            continue;
        }
        const QString name = result.immersions[i].immersion.name;
        pieces.push_back({Text::tr("Writing the cradle of %1").arg(name),
                          [&cradle = cradles[i], &result, &folder, name, number = int(i) + 1] {
                              folder.write(cradleFile(number, "stl"), cradleStl(cradle));
                              folder.write(cradleFile(number, "3mf"),
                                           cradle3mf(cradle, QStringLiteral("%1, %2").arg(
                                                                 result.project.name, name)));
                          }});
    }
    return pieces;
}

// Adds the task for the traveller. It keeps references to all arguments.
void addTraveller(std::vector<Piece>& pieces, const JobResult& result,
                  const FolderTransaction& folder, const CancelToken& cancelToken) {
    pieces.push_back({Text::tr("Writing the traveller"), [&result, &folder, cancelToken] {
                          folder.write(QStringLiteral("traveller.pdf"),
                                       travellerPdf(jobTraveller(result, {{}, cancelToken})));
                      }});
}

// Adds the task for the motion of each dip. It keeps references to all arguments but the template.
void addMotion(std::vector<Piece>& pieces, const JobResult& result,
               const std::optional<MotionTemplate>& motion, const FolderTransaction& folder) {
    pieces.push_back({Text::tr("Writing the motion files"), [&result, &folder, motion] {
                          for (std::size_t i = 0; i < result.immersions.size(); ++i) {
                              const DipMotion way = jobMotion(result, i);
                              folder.write(motionFile(int(i) + 1, "csv"), motionCsv(way));
                              const MotionTemplate own =
                                  motion ? *motion : standardMotionTemplate(way);
                              folder.write(motionFile(int(i) + 1, "gcode"),
                                           filledTemplate(way, own.text, own.where));
                          }
                      }});
}

// Adds the tasks for the tolerance map of each immersion if tolerances were computed. They keep
// references to all arguments.
void addToleranceMaps(std::vector<Piece>& pieces, const JobResult& result,
                      const FolderTransaction& folder) {
    for (std::size_t i = 0; result.tolerances && i < result.tolerances->dips.size(); ++i) {
        const ImmersionResult& immersion = result.immersions[i];
        pieces.push_back({Text::tr("Writing the tolerance map of %1").arg(immersion.immersion.name),
                          [&, number = int(i) + 1, &dip = result.tolerances->dips[i]] {
                              const QString name =
                                  immersionFolder(number) + QStringLiteral("tolerance.png");
                              const double limit = result.project.tolerance.limits.back().value();
                              const QImage map =
                                  toleranceMap(*immersion.laid, dip.filmPoints, limit, filmMapEdge);
                              folder.write(name, pngBytes(map, name));
                          }});
    }
}

void addProof(std::vector<Piece>& pieces, const JobResult& result,
              const FolderTransaction& folder) {
    pieces.push_back({Text::tr("Writing the proof"), [&] {
                          const QString proof = QStringLiteral("proof.png");
                          folder.write(proof, pngBytes(result.proof, proof));
                      }});
    if (!result.proofWithoutWhite.isNull()) {
        pieces.push_back({Text::tr("Writing the proof"), [&] {
                              const QString name = QStringLiteral("proof-without-white.png");
                              folder.write(name, pngBytes(result.proofWithoutWhite, name));
                          }});
    }
    if (!result.coverage.isNull()) {
        pieces.push_back({Text::tr("Writing the coverage picture"), [&] {
                              const QString name = QStringLiteral("coverage.png");
                              folder.write(name, pngBytes(result.coverage, name));
                          }});
    }
}

// Adds the task for the proof to share. It keeps references to all arguments.
void addSharedProof(std::vector<Piece>& pieces, const JobResult& result,
                    const FolderTransaction& folder, const CancelToken& cancelToken) {
    pieces.push_back({Text::tr("Writing the proof to share"), [&result, &folder, cancelToken] {
                          const SharedProof proof = sharedProof(result, {{}, cancelToken});
                          folder.write(QStringLiteral("proof.glb"), proof.glb);
                          folder.write(QStringLiteral("proof.html"), proof.html);
                      }});
}

void addReport(std::vector<Piece>& pieces, const Project& project, const JobResult& result,
               const FolderTransaction& folder) {
    pieces.push_back({Text::tr("Writing the report"), [&] {
                          folder.write(QStringLiteral("report.json"),
                                       QJsonDocument(report(project, result)).toJson());
                      }});
}

// Returns the tasks for the files of the whole job.
std::vector<Piece> jobPieces(const Project& project, const JobResult& result,
                             const FolderTransaction& folder) {
    std::vector<Piece> pieces = cradlePieces(result, result.cradles, folder);
    addToleranceMaps(pieces, result, folder);
    addProof(pieces, result, folder);
    addReport(pieces, project, result, folder);
    return pieces;
}

// Writes the ticket. Call this after all files that the ticket names are written, because it
// contains their hashes.
void writeTicket(const JobResult& result, const FolderTransaction& folder) {
    std::vector<QStringList> files;
    for (int number = 1; number <= int(result.immersions.size()); ++number) {
        const QString prefix = immersionFolder(number);
        files.push_back({prefix + QStringLiteral("sheet.png"), prefix + QStringLiteral("sheet.pdf"),
                         motionFile(number, "csv"), motionFile(number, "gcode")});
    }
    const auto contents = [&](const QString& name) { return folder.written(name); };
    folder.write(QStringLiteral("ticket.json"),
                 QJsonDocument(jobTicket(result, files, contents)).toJson());
}

void commit(FolderTransaction& folder, const Progress& progress) {
    progress(1, Text::tr("Moving the results to their folder"));
    progress.cancelToken.throwIfCancelled();
    folder.commit();
}

} // namespace

void writeResults(const Project& project, const JobResult& result, const QString& folder,
                  const Progress& progress) {
    FolderTransaction results(folder, resultFiles());
    std::vector<Piece> pieces = jobPieces(project, result, results);
    addTraveller(pieces, result, results, progress.cancelToken);
    addMotion(pieces, result, std::nullopt, results);
    for (std::size_t number = 0; number < result.immersions.size(); ++number) {
        for (Piece& piece :
             immersionPieces(result.project, result.immersions[number], number, results)) {
            pieces.push_back(std::move(piece));
        }
    }
    writeTogether(pieces, progress);
    writeTicket(result, results);
    commit(results, progress);
}

std::vector<Cradle> writeCradles(const JobResult& result, const QString& folder,
                                 const Progress& progress) {
    FolderTransaction files(folder, cradleFiles());
    std::vector<Cradle> cradles =
        result.cradles.empty() ? jobCradles(result, progress.part(0, 0.95)) : result.cradles;
    writeTogether(cradlePieces(result, cradles, files), progress.part(0.95, 1));
    commit(files, progress);
    return cradles;
}

namespace {

// Returns the tasks for the files that an output has for one dip; none if it has only files for
// the job. They keep references to all other arguments.
std::vector<Piece> dipPieces(Output output, const JobResult& result, std::size_t number,
                             const FolderTransaction& folder) {
    const QString prefix = immersionFolder(int(number) + 1);
    const ImmersionResult& dip = result.immersions[number];
    std::vector<Piece> pieces;
    if (output == Output::SheetPdf || output == Output::SheetPng) {
        addSheet(pieces, dip, prefix,
                 output == Output::SheetPdf ? SheetFormats::Pdf : SheetFormats::Png, folder);
    } else if (output == Output::Film) {
        addFilm(pieces, dip, prefix, folder);
    } else if (output == Output::Maps) {
        addMaps(pieces, dip, prefix, allowedError(Zone::C, result.project.tolerance), folder);
    }
    return pieces;
}

// Returns the tasks for the files that an output has for the job. They keep references to all
// arguments but the output.
std::vector<Piece> jobPieces(Output output, const JobResult& result,
                             const std::vector<Cradle>& cradles, const FolderTransaction& folder,
                             const CancelToken& cancelToken) {
    std::vector<Piece> pieces;
    if (output == Output::Proof) {
        addProof(pieces, result, folder);
    } else if (output == Output::SharedProof) {
        addSharedProof(pieces, result, folder, cancelToken);
    } else if (output == Output::Traveller) {
        addTraveller(pieces, result, folder, cancelToken);
    } else if (output == Output::Motion) {
        addMotion(pieces, result, std::nullopt, folder);
    } else if (output == Output::Cradles) {
        pieces = cradlePieces(result, cradles, folder);
    } else if (output == Output::Report) {
        addReport(pieces, result.project, result, folder);
    } else if (output == Output::Maps) {
        addToleranceMaps(pieces, result, folder);
    }
    return pieces;
}

} // namespace

QStringList writeOutput(const JobResult& result, Output output, const QString& folder,
                        const Progress& progress) {
    FolderTransaction files(folder, outputFiles(output));
    const bool makesCradles = output == Output::Cradles && result.cradles.empty();
    const double making = makesCradles ? 0.9 : 0; // share of the time
    const std::vector<Cradle> cradles =
        makesCradles ? jobCradles(result, progress.part(0, making)) : result.cradles;
    QStringList notes;
    for (const Cradle& cradle : cradles) {
        notes += output == Output::Cradles ? cradle.notes : QStringList();
    }
    std::vector<Piece> pieces = jobPieces(output, result, cradles, files, progress.cancelToken);
    for (std::size_t number = 0; number < result.immersions.size(); ++number) {
        std::ranges::move(dipPieces(output, result, number, files), std::back_inserter(pieces));
    }
    if (pieces.empty()) {
        throw Error(notes.isEmpty() ? Text::tr("There is nothing to write")
                                    : notes.join(QStringLiteral("; ")),
                    {});
    }
    writeTogether(pieces, progress.part(making, 1));
    commit(files, progress);
    return notes;
}

namespace {

// Throws Error if the template of the motion cannot be filled in for one of the dips.
void requireMotionTemplate(const Project& project, const JobOptions& options) {
    for (const Immersion& immersion : project.immersions) {
        DipMotion motion;
        if (!immersion.path.isStraightDown()) {
            motion.path = {{}, {Seconds(1)}};
        }
        const MotionTemplate own =
            options.motion ? *options.motion : standardMotionTemplate(motion);
        filledTemplate(motion, own.text, own.where);
    }
}

} // namespace

JobResult runAndWrite(const Project& project, const SolverRegistry& registry,
                      const JobOptions& options, const JobResult* previous, const QString& folder,
                      const Progress& progress) {
    FolderTransaction results(folder, resultFiles());
    requireMotionTemplate(project, options); // throws Error before the job
    pageSize(Sheet{{},
                   project.film.width,
                   project.film.height,
                   project.sheet,
                   {}}); // throws Error before the job
    Tasks writing;
    const Progress running = progress.part(0, 0.95);
    JobOptions watched = options;
    watched.finished = [&](std::size_t number, const ImmersionResult& immersion) {
        writing.run([&, number, immersion] {
            writeTogether(immersionPieces(project, immersion, number, results), progress.silent());
        });
    };
    const JobResult result = runJob(project, registry, watched, previous, running);
    std::vector<Piece> pieces = jobPieces(project, result, results);
    addTraveller(pieces, result, results, progress.cancelToken);
    addMotion(pieces, result, options.motion, results);
    writeTogether(pieces, progress.part(0.95, 1));
    writing.wait();
    writeTicket(result, results);
    commit(results, progress);
    return result;
}

QStringList resultFolders(const QStringList& projects, const QString& folder) {
    QStringList folders;
    QSet<QString> taken; // names in lower case, for file systems that ignore case
    for (const QString& project : projects) {
        const QString base = QFileInfo(project).completeBaseName();
        // The names "." and ".." would not be folders within this folder.
        const bool isNone = base.count(u'.') == base.size();
        const QString name = isNone ? QStringLiteral("project") : base;
        QString own = name;
        for (int number = 2; taken.contains(own.toLower()); ++number) {
            own = QStringLiteral("%1-%2").arg(name).arg(number);
        }
        taken.insert(own.toLower());
        folders.append(folder + QLatin1Char('/') + own);
    }
    return folders;
}

} // namespace dipwright
