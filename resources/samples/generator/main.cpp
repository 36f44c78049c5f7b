// Writes the sample models and projects. Usage: dipwright-samples FOLDER.
// Models are written to FOLDER/models and projects, which embed them, to FOLDER.
#include "ObjFile.h"
#include "Samples.h"
#include "base/Error.h"
#include "import/trusted/ImportModel.h"
#include "project/FilmSizes.h"
#include "project/NewProject.h"
#include "project/Project.h"
#include "project/ProjectStore.h"
#include "settings/Immersion.h"

#include <QDir>
#include <QGuiApplication>
#include <cstdio>

namespace {

using namespace dipwright;

// A sample project. Its film is as large as the dips need, plus a margin of at least 20 mm
// (pipeline/SmallerFilm.h).
struct Sample {
    QString name;
    TexturedMesh (*model)();
    std::vector<Immersion> immersions;
    QSizeF film; // mm
    VerdictSettings verdict;
    std::optional<Millimetres> depth;
    Degrees overhang = ProcessSettings().overhang;
};

Immersion immersion(const QString& name, double x, double y, double z) {
    return {name, {Degrees(x), Degrees(y), Degrees(z)}, {}};
}

std::vector<Sample> allSamples() {
    VerdictSettings twoFaces; // each dip paints one of four faces; the dips need no overlap
    twoFaces.unreached = 0.5;
    twoFaces.narrow = 1;
    twoFaces.pale = 0.03; // the sharp edges stretch film more than ink can cover
    return {
        {QStringLiteral("sphere"),
         samples::sphere,
         {immersion(QStringLiteral("Front"), 90, 180, 0)},
         {180, 180},
         {},
         {}},
        {QStringLiteral("tetrahedron"),
         samples::tetrahedron,
         {immersion(QStringLiteral("Face F"), 0, 180, 0),
          immersion(QStringLiteral("Face P"), -109.5, 0, 0)},
         {110, 110},
         twoFaces,
         Millimetres(1.5)},
        {QStringLiteral("turtle"),
         samples::turtle,
         {immersion(QStringLiteral("Belly"), 0, 0, 0),
          immersion(QStringLiteral("Shell"), 0, 0, 180)},
         filmSize(QStringLiteral("A5")),
         {},
         {},
         Degrees(25)}, // with this, the two dips meet around the flippers
    };
}

void write(const Sample& sample, const QDir& folder) {
    const QString models = folder.filePath(QStringLiteral("models"));
    if (!QDir().mkpath(models)) {
        throw Error(QStringLiteral("The folder cannot be made"), models);
    }
    samples::writeObj(sample.model(), models, sample.name);

    // The project imports the model like any other: from its file.
    const QString source = QStringLiteral("models/%1.obj").arg(sample.name);
    Project project = newProject(source);
    project.name = sample.name.left(1).toUpper() + sample.name.mid(1);
    // A fixed date, so that the file is always the same.
    project.date = QStringLiteral("2026-01-01");
    resizeFilm(project.film, Millimetres(sample.film.width()), Millimetres(sample.film.height()));
    project.immersions = sample.immersions;
    project.process.depth = sample.depth;
    project.process.overhang = sample.overhang;
    project.verdict = sample.verdict;
    project.model =
        std::make_shared<const TexturedMesh>(importModel(folder.filePath(source), {}, {}).model);
    project.modelOrigin.source = source;
    saveProject(project, folder.filePath(sample.name + QStringLiteral(".dipw")));
}

} // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen"); // allows fonts without a window
    const QGuiApplication application(argc, argv);
    if (argc != 2) {
        std::fputs("usage: dipwright-samples FOLDER\n", stderr);
        return 2;
    }
    try {
        for (const Sample& sample : allSamples()) {
            write(sample, QDir(QString::fromLocal8Bit(argv[1])));
        }
    } catch (const Error& error) {
        std::fprintf(stderr, "error: %s\n", qPrintable(error.sentence()));
        return 1;
    }
    return 0;
}
