#include "pipeline/Pipeline.h"

#include "base/Error.h"
#include "pipeline/ResultFolder.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QJsonDocument>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

constexpr int filmMapEdge = 1600; // pixels

// The bytes that `write` puts into the device it is given.
template <typename Write>
QByteArray bytesOf(Write write) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    write(buffer);
    return bytes;
}

QByteArray png(const QImage& image) {
    return bytesOf([&](QBuffer& buffer) { image.save(&buffer, "PNG"); });
}

QString immersionFolder(int number) {
    return QStringLiteral("immersion-%1").arg(number);
}

void writeImmersion(const ImmersionResult& result, const QString& name, const ResultFolder& folder,
                    const Progress& progress) {
    const QString prefix = name + QLatin1Char('/');
    progress(0, Text::tr("Writing the sheet of %1").arg(result.immersion.name));
    folder.write(prefix + QStringLiteral("sheet.png"),
                 bytesOf([&](QBuffer& buffer) { writeSheetPng(result.sheet, buffer); }));
    progress(0.4, Text::tr("Writing the sheet of %1").arg(result.immersion.name));
    folder.write(prefix + QStringLiteral("sheet.pdf"),
                 bytesOf([&](QBuffer& buffer) { writeSheetPdf(result.sheet, buffer); }));
    progress(0.7, Text::tr("Writing the film of %1").arg(result.immersion.name));
    const QString path = folder.path() + QLatin1Char('/') + prefix;
    writeFilmVtp(*result.film, *result.contact, *result.body, path + QStringLiteral("film.vtp"));
    writeBodyVtp(*result.body, *result.coverage, path + QStringLiteral("body.vtp"));
    progress(0.9, Text::tr("Writing the stretch of %1").arg(result.immersion.name));
    folder.write(prefix + QStringLiteral("stretch.png"),
                 png(stretchMap(*result.film, *result.contact, filmMapEdge)));
    folder.write(prefix + QStringLiteral("wrinkling.png"),
                 png(wrinklingMap(*result.film, *result.contact, filmMapEdge)));
}

} // namespace

void checkResultFolder(const QString& folder) {
    const ResultFolder trial(folder);
    trial.write(QStringLiteral("trial"), QByteArrayLiteral("trial"));
}

void writeResults(const Project& project, const JobResult& result, const QString& folder,
                  const Progress& progress) {
    ResultFolder results(folder);
    const int count = int(result.immersions.size());
    for (int index = 0; index < count; ++index) {
        writeImmersion(result.immersions[std::size_t(index)], immersionFolder(index + 1), results,
                       progress.part(double(index) / count, double(index + 1) / count));
    }
    results.write(QStringLiteral("proof.png"), png(result.proof));
    results.write(QStringLiteral("report.json"), QJsonDocument(report(project, result)).toJson());
    progress(1, Text::tr("Moving the results in place"));
    // Both folders, so that no second immersion of an earlier run stays beside these results.
    results.commit({immersionFolder(1), immersionFolder(2), QStringLiteral("proof.png"),
                    QStringLiteral("report.json")});
}

} // namespace dipwright
