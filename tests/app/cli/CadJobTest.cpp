// Tests a CAD file on its way to a printed sheet, with a face of it as zone A.
#include "CadFiles.h"
#include "CliProcess.h"

#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

using namespace dipwright::test;

namespace {

const QStringList quickly{"--set", "film.size_mm=80x70", "--set", "film.points=25x22",
                          "--set", "sheet.dpi=72",       "--set", "body.sdf_resolution=64"};

} // namespace

class CadJobTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        writeBracket(path("bracket.step"), "INCH");
        made_ = cli({"new", path("job.dipw"), "--model", path("bracket.step"), "--set",
                     R"(tolerance.marks=[{"zone": "A", "material": "Logo"}])", "--set",
                     "model.tessellation_mm=0.05"});
        QVERIFY2(made_.exitCode == 0, made_.err);
    }

    void new_bracket_saysUnitFacesAndTolerance() {
        QVERIFY2(made_.out.contains("inch") && made_.out.contains("faces: 12") &&
                     made_.out.contains("0.05 mm"),
                 made_.out);
    }

    void info_bracket_listsTheFaces() {
        QVERIFY(cli({"info", path("job.dipw")}).out.contains("Logo"));
        const QJsonObject info =
            QJsonDocument::fromJson(cli({"info", path("job.dipw"), "--json"}).out).object();
        QVERIFY(info["model_info"]["material_names"].toArray().contains(QStringLiteral("Logo")));
    }

    void run_logoAsZoneA_isPrintedAndJudged() {
        const Outcome run =
            cli(QStringList{"run", path("job.dipw"), "--out", path("out"), "--quiet"} + quickly);
        QVERIFY2(run.exitCode == 0, run.err);
        QVERIFY(QFile::exists(path("out/immersion-1/sheet.pdf")));
        const QImage sheet(path("out/immersion-1/sheet.png"));
        const QColor middle = sheet.pixelColor(sheet.width() / 2, sheet.height() / 2);
        QVERIFY2(middle.red() > middle.blue() + 100, qPrintable(middle.name()));
        QFile report(path("out/report.json"));
        QVERIFY(report.open(QIODevice::ReadOnly));
        QVERIFY(report.readAll().contains("Zone A"));
    }

    void artwork_onAFace_showsOnlyThere() {
        const Outcome added =
            cli({"artwork", "add", path("job.dipw"), "carbon", "--on", "Logo", "--set",
                 "colour=#000000", "--set", "second_colour=#00ff00", "--set", "placement=box"});
        QVERIFY2(added.exitCode == 0, added.err);
        const Outcome unknown = cli({"artwork", "add", path("job.dipw"), "carbon", "--on", "Lug"});
        QCOMPARE(unknown.exitCode, 1);
        QVERIFY(unknown.err.contains("Logo"));
        const Outcome run =
            cli(QStringList{"run", path("job.dipw"), "--out", path("out"), "--quiet"} + quickly);
        QVERIFY2(run.exitCode == 0, run.err);
        const QImage proof(path("out/proof.png"));
        int green = 0, blue = 0;
        for (int y = 0; y < proof.height(); y += 3) {
            for (int x = 0; x < proof.width(); x += 3) {
                const QColor colour = proof.pixelColor(x, y);
                green += colour.green() > colour.red() + 60 && colour.green() > colour.blue() + 60;
                blue += colour.blue() > colour.red() + 30;
            }
        }
        QVERIFY(green > 100); // the logo's pattern
        QVERIFY(blue > 100);  // the sides keep the file's colour
    }

    void set_finerTolerance_makesMoreTriangles() {
        const auto triangles = [&](const char* tolerance) {
            const Outcome info =
                cli({"info", path("job.dipw"), "--json", "--set",
                     QStringLiteral("model.tessellation_mm=") + QString::fromLatin1(tolerance)});
            return QJsonDocument::fromJson(info.out)["model_info"]["triangles"].toInt();
        };
        QVERIFY(triangles("0.001") > triangles("0.5"));
    }

    void run_nameThatTheModelLacks_warns() {
        const Outcome checked =
            cli({"validate", path("job.dipw"), "--set", R"(masks=[{"material": "Lug"}])"});
        QVERIFY2((checked.out + checked.err).contains("Lug"), checked.out + checked.err);
    }

private:
    QString path(const char* name) const { return folder_.filePath(QString::fromLatin1(name)); }

    QTemporaryDir folder_;
    Outcome made_;
};

QTEST_GUILESS_MAIN(CadJobTest)
#include "CadJobTest.moc"
