// Writes the first inputs of the fuzz targets to FOLDER/NAME: small valid files of each kind.
#include "ModelFiles.h"
#include "SampleProject.h"

#include "disk/UnfinishedNote.h"
#include "geometry/FieldFile.h"
#include "model/StoredModel.h"
#include "pipeline/CachedDip.h"
#include "printing/PrintHistory.h"
#include "project/Profiles.h"
#include "project/ProjectStore.h"
#include "traveller/Motion.h"

#include <QBuffer>
#include <QColorSpace>
#include <QDir>
#include <QGuiApplication>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <cmath>

using namespace dipwright;
using namespace dipwright::test;

namespace {

void write(const QDir& folder, const QString& target, const QByteArray& bytes, int number = 1) {
    folder.mkpath(target);
    writeFile(folder.filePath(QStringLiteral("%1/seed-%2").arg(target).arg(number)), bytes);
}

void writeModels(const QDir& folder) {
    const QByteArray picture = png(quarters(4));
    write(folder, QStringLiteral("obj"),
          cubeObj("mtllib a.mtl\nusemtl skin\n") + "\n====\nnewmtl skin\nKd 1 0 0\n");
    write(folder, QStringLiteral("ply"), squarePly("a.png") + "\n====\n" + picture);
    write(folder, QStringLiteral("ply"), squareBinaryPly("a.png", true), 2);
    write(folder, QStringLiteral("stl"),
          "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
          "endloop\nendfacet\nendsolid a\n");
    write(folder, QStringLiteral("stl"),
          QByteArray(80, ' ') + QByteArray("\1\0\0\0", 4) + QByteArray(50, '\0'), 2);
    write(folder, QStringLiteral("gltf"), squareGltf(picture));
    write(folder, QStringLiteral("glb"), squareGlb(picture));
    write(folder, QStringLiteral("dae"), tetrahedron("collada"));
    write(folder, QStringLiteral("3ds"), tetrahedron("3ds"));
    write(folder, QStringLiteral("fbx"), tetrahedron("fbxa"));
    write(folder, QStringLiteral("fbx"), tetrahedronBinaryFbx(), 2);
    const QString package = folder.filePath(QStringLiteral("3mf/seed-1"));
    folder.mkpath(QStringLiteral("3mf"));
    writeSquare3mf(package, picture);
}

void writePictures(const QDir& folder) {
    int number = 0;
    for (const char* format : {"PNG", "JPEG", "BMP", "TIFF", "WEBP"}) {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        if (quarters(4).convertToFormat(QImage::Format_RGB888).save(&buffer, format)) {
            write(folder, QStringLiteral("picture"), bytes, ++number);
        }
    }
}

void writeProjects(const QDir& folder) {
    const Project project = sampleProject();
    write(folder, QStringLiteral("document"), QJsonDocument(toJson(project)).toJson());
    write(folder, QStringLiteral("mesh"), writeModel(*project.model));
    folder.mkpath(QStringLiteral("project"));
    saveProject(project, folder.filePath(QStringLiteral("project/seed-1")));
    int number = 0;
    const QDir shipped(QStringLiteral(":/dipwright/profiles"));
    for (const QString& kind : shipped.entryList(QDir::Dirs)) {
        for (const QString& name : QDir(shipped.filePath(kind)).entryList(QDir::Files)) {
            QFile file(shipped.filePath(kind + u'/' + name));
            if (file.open(QIODevice::ReadOnly)) {
                write(folder, QStringLiteral("profile"), file.readAll(), ++number);
            }
        }
    }
}

// Writes places on a helix as a camera sees them from two sides, 300 mm away.
void writePairs(const QDir& folder) {
    QByteArray table("photo,x_px,y_px,x_mm,y_mm,z_mm\n");
    for (int i = 0; i < 16; ++i) {
        const double x = 30 * std::cos(i), y = 4 * i - 30, z = 30 * std::sin(i);
        const int photo = i % 2;
        const double across = photo == 0 ? x : z, away = 300 + (photo == 0 ? z : -x);
        table += QStringLiteral("%1,%2,%3,%4,%5,%6\n")
                     .arg(photo + 1)
                     .arg(200 + 250 * across / away)
                     .arg(150 + 250 * y / away)
                     .arg(x)
                     .arg(y)
                     .arg(z)
                     .toLatin1();
    }
    write(folder, QStringLiteral("pairs"), table);
}

// Writes a flat film of 8 × 6 points whose middle points are adhered, once with and once without
// the optional data.
void writeDips(const QDir& folder) {
    CachedDip dip;
    dip.film.grid = {8, 6, 14, 10};
    for (std::size_t point = 0; point < dip.film.grid.pointCount(); ++point) {
        const Eigen::Vector2f rest = restPosition(dip.film.grid, point);
        dip.film.positions.emplace_back(rest.x(), 0, rest.y());
        dip.film.states.push_back(rest.norm() < 3 ? solver::PointState::Adhered
                                                  : solver::PointState::Free);
    }
    write(folder, QStringLiteral("dips"), cachedDip(dip));
    dip.film.marks.assign(dip.film.grid.pointCount(), 1);
    dip.film.grown.assign(dip.film.grid.pointCount(), 1.1F);
    NumericalErrorEstimate estimate;
    estimate.pointErrors.assign(dip.film.grid.pointCount(), 0.1F);
    dip.numericalError = std::make_shared<const NumericalErrorEstimate>(estimate);
    write(folder, QStringLiteral("dips"), cachedDip(dip), 2);
}

// Writes files that programs leave for the next start: journals, notes, records, fields.
void writeLeftoverFiles(const QDir& folder) {
    const QByteArray journal = R"({"there":["proof.png","report.json"],)"
                               R"("written":["proof.png","immersion-1/sheet.png"]})";
    write(folder, QStringLiteral("journal"), journal);
    write(folder, QStringLiteral("journal"), 'u' + journal, 2);
    write(folder, QStringLiteral("note"),
          bytesOf(UnfinishedNote{QStringLiteral("/jobs/out/.dipwright-results"),
                                 {QStringLiteral("/jobs"), QStringLiteral("/jobs/out")}}));
    write(folder, QStringLiteral("note"),
          bytesOf(UnfinishedNote{QStringLiteral("/jobs/.~new.job.dipw"), {}}), 2);
    DistanceField field;
    field.size = {2, 2, 2};
    field.spacing = 1;
    field.distance = {1, 2, 3, 4, -1, -2, -3, -4};
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (buffer.open(QIODevice::WriteOnly) && writeField(field, buffer)) {
        write(folder, QStringLiteral("field"), bytes);
    }
    const QTemporaryDir prints;
    PrintRecord record;
    record.job = QStringLiteral("3fa9c2d1");
    record.project = QStringLiteral("Turtle");
    record.printer = QStringLiteral("pigment");
    record.mediumSize = {210, 297};
    record.reason = QStringLiteral("out of paper");
    int number = 0;
    for (const PrintOutcome fate :
         {PrintOutcome::Printed, PrintOutcome::Failed, PrintOutcome::Unknown}) {
        record.fate = fate;
        const QString failure = PrintHistory(prints.path()).keep(record);
        QFile file(prints.filePath(record.id));
        if (failure.isEmpty() && file.open(QIODevice::ReadOnly)) {
            write(folder, QStringLiteral("prints"), file.readAll(), ++number);
        }
    }
}

} // namespace

int main(int argc, char* argv[]) {
    const QCoreApplication application(argc, argv);
    const QDir folder(QCoreApplication::arguments().value(1, QStringLiteral("seeds")));
    writeModels(folder);
    writePictures(folder);
    writeProjects(folder);
    writePairs(folder);
    writeDips(folder);
    writeLeftoverFiles(folder);
    write(folder, QStringLiteral("motion"), standardMotionTemplate({}).text.toUtf8());
    write(folder, QStringLiteral("plugin"),
          R"({"format":"dipwright-solver","interface":1,"id":"a","name":"A","version":"1",)"
          R"("device":"cpu","vendor":"B","priority":1,"module":"a.so"})");
    write(folder, QStringLiteral("colour"), QColorSpace(QColorSpace::SRgb).iccProfile());
}
