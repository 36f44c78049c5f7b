// Tests CAD files as users bring them: names, colours and units, finer triangles, and refusals.
#include "CadFiles.h"

#include "accuracy/tolerance/Zones.h"
#include "base/Error.h"
#include "geometry/TriangleMesh.h"
#include "import/trusted/ImportModel.h"
#include "marks/SurfaceMask.h"
#include "model/NamedMaterials.h"
#include "project/CadModel.h"
#include "project/Project.h"
#include "project/ProjectStore.h"

#include <QImage>
#include <QtTest>

using namespace dipwright;
using namespace dipwright::test;

namespace {

const QString logo = QStringLiteral("Logo");

ImportedModel import(const QString& path, const ImportOptions& options = {}) {
    return importModel(path, options, Progress());
}

QString refusal(const QString& path) {
    try {
        import(path);
        return {};
    } catch (const Error& error) {
        return error.sentence();
    }
}

Project projectOf(const QString& path, const ImportOptions& options = {}) {
    Project project;
    takeModel(project, import(path, options), path);
    return project;
}

double areaOfMask(const Project& project) {
    return maskedAreas(*surfaceMask(project.model, project.masks)).area;
}

double areaOfZoneA(const Project& project) {
    ZonedBody body(project.model);
    body.setMarks(project.tolerance.marks);
    double area = 0;
    for (std::size_t piece = 0; piece < body.zones().size(); ++piece) {
        if (body.zones()[piece] == Zone::A) {
            const auto [a, b, c] = cornersOf(body.mesh().mesh(), piece);
            area += double((b - a).cross(c - a).norm()) / 2;
        }
    }
    return area;
}

} // namespace

class CadImportTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QVERIFY(folder_.isValid());
        writeBracket(step_);
    }

    void import_bracket_isClosedInMillimetres_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("unit");
        for (const char* suffix : {".step", ".igs"}) {
            for (const auto& [unit, shown] :
                 {std::pair("MM", "mm"), {"INCH", "inch"}, {"M", "m"}}) {
                QTest::addRow("%s %s", suffix, unit)
                    << path(QLatin1String(unit) + QLatin1String(suffix))
                    << QString::fromLatin1(shown);
                writeBracket(path(QLatin1String(unit) + QLatin1String(suffix)), unit);
            }
        }
    }
    void import_bracket_isClosedInMillimetres() {
        QFETCH(const QString, file);
        const ImportedModel bracket = import(file);
        const Eigen::Vector3f size = bracket.report.box.sizes();
        QVERIFY((size - Eigen::Vector3f(40, 25, 30)).cwiseAbs().maxCoeff() < 0.01f);
        QVERIFY(bracket.report.closed);
        QVERIFY(bracket.report.volume > 0);
        QTEST(bracket.report.cad->unit, "unit");
        QVERIFY2(bracket.report.remarks().isEmpty(), qPrintable(bracket.report.remarks()));
        QCOMPARE(bracket.report.losses, QStringList());
    }

    void import_bracket_keepsNamesAndColours_data() {
        QTest::addColumn<QString>("file");
        QTest::newRow("STEP") << step_;
        writeBracket(path("named.igs"));
        QTest::newRow("IGES") << path("named.igs");
    }
    void import_bracket_keepsNamesAndColours() {
        QFETCH(const QString, file);
        const TexturedMesh model = import(file).model;
        const std::vector<std::size_t> found = materialsNamed(model, logo);
        QCOMPARE(found.size(), std::size_t(1));
        const QColor red = model.materials[found.front()].colour;
        QCOMPARE(red.name(), QStringLiteral("#cc1a1a"));
        const QStringList names = materialNames(model);
        QCOMPARE(names.size(), qsizetype(model.materials.size())); // all different
        QVERIFY(names.contains(QStringLiteral("Face 1")));
        for (const Material& material : model.materials) {
            QCOMPARE(material.colour.name(),
                     material.name == logo ? QStringLiteral("#cc1a1a") : QStringLiteral("#336699"));
        }
        const Eigen::Vector3f middle = *middleOfMaterial(model, logo);
        QVERIFY((middle - Eigen::Vector3f(0, 0, 0)).norm() < 0.01f);
    }

    void import_finerTolerance_followsTheHoleMoreClosely() {
        const auto deviation = [&](double tolerance) {
            ImportOptions options;
            options.tessellation = Millimetres(tolerance);
            const ImportedModel bracket = import(step_, options);
            const double exact = 40 * 5 * 30 + 40 * 20 * 5 - pi * 36 * 5;
            return std::abs(bracket.report.volume - exact);
        };
        QVERIFY(deviation(0.005) < deviation(0.5));
        QVERIFY(deviation(0.005) < 1);
    }

    void import_scaled_keepsTheToleranceOfThePart() {
        ImportOptions options;
        options.longestEdge = Millimetres(400);
        options.tessellation = Millimetres(0.05);
        const ImportedModel large = import(step_, options);
        options.longestEdge = Millimetres(40);
        const ImportedModel small = import(step_, options);
        QCOMPARE(qRound(large.report.unitMillimetres * 1000), 10'000);
        QVERIFY(large.report.triangles > small.report.triangles);
        QCOMPARE(large.report.cad->tessellation, 0.05);
    }

    void retessellation_zonesMasksAndSize_stay() {
        Project project = projectOf(step_);
        setByPath(project, QStringLiteral("tolerance.marks"),
                  QStringLiteral(R"([{"zone": "A", "material": "Logo"}])"));
        setByPath(project, QStringLiteral("masks"), QStringLiteral(R"([{"material": "Face 1"}])"));
        const double zone = areaOfZoneA(project), mask = areaOfMask(project);
        QVERIFY(std::abs(zone - 40 * 30) < 0.1);
        QVERIFY(mask > 1 && mask < 40 * 30);
        const std::size_t before = project.model->mesh.triangles.size();
        setByPath(project, QStringLiteral("model.tessellation_mm"), QStringLiteral("0.001"));
        QVERIFY(project.model->mesh.triangles.size() > before);
        QCOMPARE(project.modelOrigin.tessellation, Millimetres(0.001));
        QVERIFY(std::abs(areaOfZoneA(project) - zone) < 0.1);
        QVERIFY(std::abs(areaOfMask(project) - mask) < 0.5);
    }

    void project_savedAndOpened_needsNoFile() {
        const QString copy = path("copy.step");
        QVERIFY(QFile::copy(step_, copy));
        Project project = projectOf(copy);
        QVERIFY(QFile::remove(copy));
        saveProject(project, path("job.dipw"));
        Project opened = loadProject(path("job.dipw"));
        QCOMPARE(opened.cad, project.cad);
        QCOMPARE(opened.modelOrigin.tessellation, project.modelOrigin.tessellation);
        QVERIFY(opened.unknownEntries.empty());
        QVERIFY(cadText(opened).contains(QStringLiteral("mm")));
        setByPath(opened, QStringLiteral("model.tessellation_mm"), QStringLiteral("0.5"));
        QVERIFY(opened.model->mesh.triangles.size() < project.model->mesh.triangles.size());
    }

    void tessellation_modelWithoutCad_isRefused() {
        Project project = projectOf(step_);
        project.cad = {};
        QVERIFY_EXCEPTION_THROWN(
            setByPath(project, QStringLiteral("model.tessellation_mm"), QStringLiteral("0.5")),
            Error);
    }

    void import_damagedFile_saysSo_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("suffix");
        QFile file(step_);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray whole = file.readAll();
        writeBracket(path("whole.igs"));
        QFile iges(path("whole.igs"));
        QVERIFY(iges.open(QIODevice::ReadOnly));
        const QByteArray wholeIges = iges.readAll();
        QTest::newRow("text") << QByteArray("This is not CAD.\n") << ".step";
        QTest::newRow("header only") << whole.left(600) << ".step";
        QTest::newRow("half") << whole.left(whole.size() / 2) << ".step";
        QTest::newRow("IGES text") << QByteArray(500, 'x') << ".igs";
        QTest::newRow("IGES header") << wholeIges.left(500) << ".igs";
        const qsizetype lastLine = wholeIges.trimmed().lastIndexOf('\n') + 1;
        QTest::newRow("IGES without its end") << wholeIges.left(lastLine) << ".igs";
        const qsizetype lineBefore = wholeIges.lastIndexOf('\n', lastLine - 2) + 1;
        QTest::newRow("IGES without a line")
            << wholeIges.left(lineBefore) + wholeIges.mid(lastLine) << ".igs";
        QTest::newRow("zeroes") << QByteArray(5000, '\0') << ".igs";
        QByteArray noSurfaces = whole;
        QTest::newRow("no faces") << noSurfaces.replace("ADVANCED_FACE", "ADVANCED_FAKE")
                                  << ".step";
    }
    void import_damagedFile_saysSo() {
        QFETCH(const QByteArray, bytes);
        QFETCH(const QString, suffix);
        QFile file(path("damaged") + suffix);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.close();
        const QString sentence = refusal(file.fileName());
        QVERIFY(!sentence.isEmpty());
        QVERIFY2(!sentence.contains(QLatin1String("crash")), qPrintable(sentence));
    }

    void import_brokenEntity_isALoss_data() {
        QTest::addColumn<QByteArray>("entity");
        QTest::addColumn<QByteArray>("changed");
        QTest::newRow("surface") << QByteArray("PLANE(") << QByteArray("PLAIN(");
        QTest::newRow("face") << QByteArray("ADVANCED_FACE(") << QByteArray("ADVANCED_FAKE(");
    }
    void import_brokenEntity_isALoss() {
        QFETCH(const QByteArray, entity);
        QFETCH(const QByteArray, changed);
        QFile whole(step_);
        QVERIFY(whole.open(QIODevice::ReadOnly));
        QByteArray bytes = whole.readAll();
        bytes.replace(bytes.indexOf(entity), entity.size(), changed);
        QFile file(path("broken.step"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.close();
        QVERIFY(import(step_).report.losses.isEmpty());
        const QString losses = import(file.fileName()).report.losses.join(u' ');
        QVERIFY2(losses.startsWith(QLatin1String("Entities of the CAD file")), qPrintable(losses));
    }

    void import_igesWithOtherLineEnds_isWhole_data() {
        QTest::addColumn<QByteArray>("end");
        QTest::newRow("CR LF") << QByteArray("\r\n");
        QTest::newRow("CR") << QByteArray("\r");
        QTest::newRow("none") << QByteArray();
        QTest::newRow("blanks") << QByteArray("     \n");
    }
    void import_igesWithOtherLineEnds_isWhole() {
        QFETCH(const QByteArray, end);
        writeBracket(path("ends.igs"));
        QFile file(path("ends.igs"));
        QVERIFY(file.open(QIODevice::ReadWrite));
        QByteArray bytes = file.readAll();
        bytes.replace('\n', end);
        file.resize(0);
        file.write(bytes);
        file.close();
        QVERIFY(import(path("ends.igs")).report.closed);
    }

    void import_assemblyThatDoubles_isRefused() {
        writeDoubled(path("doubled.step"), 14);
        const QString sentence = refusal(path("doubled.step"));
        QVERIFY2(sentence.contains(QLatin1String("65000")), qPrintable(sentence));
    }

    void import_fewCopies_haveNamesOfTheirOwn() {
        writeDoubled(path("four.step"), 2);
        const TexturedMesh model = import(path("four.step")).model;
        QCOMPARE(materialNames(model).size(), 4 * 6);
    }

    void import_manyUnnamedFaces_areNumbered() {
        writeBoxes(path("boxes.step"), 300);
        const QStringList names = materialNames(import(path("boxes.step")).model);
        QCOMPARE(names.size(), 300 * 6);
        QCOMPARE(names.last(), QStringLiteral("Face 1800"));
    }

    void import_withPicture_saysThatItHasNoPlace() {
        QImage picture(8, 8, QImage::Format_RGB32);
        picture.fill(Qt::red);
        QVERIFY(picture.save(path("red.png")));
        ImportOptions options;
        options.texture = path("red.png");
        const ImportedModel bracket = import(step_, options);
        QVERIFY(bracket.model.textures.empty());
        const QString warnings = bracket.report.warnings.join(u' ');
        QVERIFY2(warnings.contains(QLatin1String("texture coordinates")), qPrintable(warnings));
    }

    void project_longFileName_canBeOpened() {
        const QString file = path(QString(240, u'n') + QStringLiteral(".step"));
        QVERIFY(QFile::copy(step_, file));
        saveProject(projectOf(file), path("long.dipw"));
        QVERIFY(loadProject(path("long.dipw")).cad.name.endsWith(QLatin1String("n.step")));
    }

private:
    QString path(const QString& name) const { return folder_.filePath(name); }
    QString path(const char* name) const { return path(QString::fromLatin1(name)); }

    QTemporaryDir folder_;
    QString step_ = folder_.filePath(QStringLiteral("bracket.step"));
};

QTEST_GUILESS_MAIN(CadImportTest)
#include "CadImportTest.moc"
