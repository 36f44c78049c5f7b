#include "pipeline/WriteResults.h"

#include "base/Bytes.h"
#include "base/Error.h"
#include "base/Png.h"
#include "parallel/ParallelFor.h"
#include "pipeline/Report.h"
#include "pipeline/ResultFolder.h"
#include "results/Results.h"
#include "sheet/SheetFiles.h"

#include <QCoreApplication>
#include <QDir>
#include <QJsonDocument>

#include <functional>
#include <mutex>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

constexpr int filmMapEdge = 1600; // pixels

QString immersionFolder(int number) {
    return QStringLiteral("immersion-%1").arg(number);
}

// All that a run may write: those of both immersions, so that no second immersion of an earlier run
// stays beside the results of a single one.
QStringList resultFiles() {
    QStringList files{QStringLiteral("proof.png"), QStringLiteral("report.json")};
    for (const int number : {1, 2}) {
        for (const char* name :
             {"sheet.png", "sheet.pdf", "film.vtp", "body.vtp", "stretch.png", "wrinkling.png"}) {
            files.append(immersionFolder(number) + QLatin1Char('/') + QLatin1String(name));
        }
    }
    return files;
}

// One of the pieces of writing that go on at the same time: packing pictures takes far longer than
// the disk.
struct Piece {
    QString text;
    std::function<void()> write;
};

void writeTogether(const std::vector<Piece>& pieces, const Progress& progress) {
    std::mutex mutex;
    std::size_t written = 0;
    parallelFor(std::size_t(0), pieces.size(), [&](std::size_t index) {
        const Piece& piece = pieces[index];
        {
            const std::scoped_lock lock(mutex);
            progress(double(written) / double(pieces.size()), piece.text);
        }
        piece.write();
        const std::scoped_lock lock(mutex);
        ++written;
    });
}

void addSheet(std::vector<Piece>& pieces, const ImmersionResult& result, const QString& prefix,
              const ResultFolder& folder) {
    const QString text = Text::tr("Writing the sheet of %1").arg(result.immersion.name);
    pieces.push_back(
        {text, [&result, prefix, &folder] {
             folder.write(prefix + QStringLiteral("sheet.png"),
                          bytesOf([&](QIODevice& device) { writeSheetPng(result.sheet, device); }));
         }});
    pieces.push_back(
        {text, [&result, prefix, &folder] {
             folder.write(prefix + QStringLiteral("sheet.pdf"),
                          bytesOf([&](QIODevice& device) { writeSheetPdf(result.sheet, device); }));
         }});
}

void addFilm(std::vector<Piece>& pieces, const ImmersionResult& result, const QString& prefix,
             const ResultFolder& folder) {
    pieces.push_back(
        {Text::tr("Writing the film of %1").arg(result.immersion.name), [&result, prefix, &folder] {
             folder.write(prefix + QStringLiteral("film.vtp"), filmVtp(*result.laid));
             folder.write(prefix + QStringLiteral("body.vtp"),
                          bodyVtp(*result.body, *result.coverage));
         }});
    const QString text = Text::tr("Writing the stretch of %1").arg(result.immersion.name);
    pieces.push_back({text, [&result, prefix, &folder] {
                          const QString name = prefix + QStringLiteral("stretch.png");
                          folder.write(name, pngBytes(stretchMap(*result.laid, filmMapEdge), name));
                      }});
    pieces.push_back({text, [&result, prefix, &folder] {
                          const QString name = prefix + QStringLiteral("wrinkling.png");
                          folder.write(name,
                                       pngBytes(wrinklingMap(*result.laid, filmMapEdge), name));
                      }});
}

} // namespace

void checkResultFolder(const QString& folder) {
    const ResultFolder trial(folder);
    trial.write(QStringLiteral("trial"), QByteArrayLiteral("trial"));
}

void writeResults(const Project& project, const JobResult& result, const QString& folder,
                  const Progress& progress) {
    ResultFolder results(folder);
    std::vector<Piece> pieces;
    int number = 0;
    for (const ImmersionResult& immersion : result.immersions) {
        const QString prefix = immersionFolder(++number) + QLatin1Char('/');
        addSheet(pieces, immersion, prefix, results);
        addFilm(pieces, immersion, prefix, results);
    }
    writeTogether(pieces, progress);
    const QString proof = QStringLiteral("proof.png");
    results.write(proof, pngBytes(result.proof, proof));
    results.write(QStringLiteral("report.json"), QJsonDocument(report(project, result)).toJson());
    progress(1, Text::tr("Moving the results in place"));
    results.commit(resultFiles());
}

} // namespace dipwright
