// Tests `dipwright-cli bench` through the program itself.

#include "CliProcess.h"
#include "TestFiles.h"

#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>

using namespace dipwright::test;

class BenchTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QVERIFY(folder_.isValid()); }

    void bench_json_listsTableOne() {
        const Outcome bench = cli({"bench", "--json", "--rows", "1", "--runs", "1"});
        QVERIFY2(bench.exitCode == 0, bench.err);
        const QJsonObject json = QJsonDocument::fromJson(bench.out).object();
        QCOMPARE(json["version"].toInt(), 1);
        QVERIFY(!json["solver"].toString().isEmpty() && !json["device"].toString().isEmpty());
        const QJsonObject row = json["table1"].toArray().first().toObject();
        QCOMPARE(row["points"].toInt(), 96);
        QCOMPARE(row["constraints"].toInt(), 172);
        QCOMPARE(row["paper"].toInt(), 326);
        QVERIFY(hasNumbers(row, {"steps_per_second", "min", "max"}));
        QVERIFY(row["steps_per_second"].toDouble() > 0);
    }

    void bench_partsOption_measuresOnlyTheseParts() {
        const Outcome bench = cli({"bench", "--json", "--quick", "--runs", "1", "--parts",
                                   "sweep,field,texture", "--solver", "pbd-cpu"});
        QVERIFY2(bench.exitCode == 0, bench.err);
        const QJsonObject json = QJsonDocument::fromJson(bench.out).object();
        QVERIFY(json["table1"].toArray().isEmpty() && json["dips"].toArray().isEmpty());
        QVERIFY(hasNumbers(json["ceiling"].toObject(), {"flops_per_second", "bytes_per_second"}));
        QCOMPARE(json["figure7"].toArray().size(), 6); // three bodies, fields of 32³ and 64³
        for (const QJsonValue& value : json["figure7"].toArray()) {
            const QJsonObject row = value.toObject();
            QCOMPARE(row["points"].toInt(), 21600);
            QCOMPARE(row["constraint_solves_per_second"].toDouble(),
                     row["steps_per_second"].toDouble() * 5 * 42900);
            QVERIFY(row["share_of_ceiling"].toDouble() > 0);
            QVERIFY(row["paper"].isNull());
        }
        for (const char* part : {"fields", "sheets"}) {
            QVERIFY(!json[part].toArray().isEmpty());
            for (const QJsonValue& row : json[part].toArray()) {
                QVERIFY(row["seconds"].toDouble() > 0);
                QVERIFY(row["min"].toDouble() <= row["max"].toDouble());
            }
        }
    }

    void bench_plot_drawsFigures() {
        const auto draw = [&](const QString& parts, const QString& file) {
            return cli({"bench", "--quick", "--runs", "1", "--rows", "2", "--parts", parts,
                        "--plot", path(file)});
        };
        const Outcome both = draw("steps,sweep", "rates.png");
        QVERIFY2(both.exitCode == 0, both.err);
        QVERIFY2(both.out.contains("Table I") && both.out.contains("Figure 7"), both.out);
        const Outcome one = draw("steps", "rates.svg");
        QVERIFY2(one.exitCode == 0, one.err);
        QCOMPARE(QImage(path("rates.png")).size(), QSize(1400, 640));
        QFile svg(path("rates.svg"));
        QVERIFY(svg.open(QIODevice::ReadOnly));
        QVERIFY(svg.readAll().contains("GeForce 940MX"));
    }

    void bench_invalidArguments_areRefused() {
        const Outcome unknown = cli({"bench", "--parts", "steps,luck"});
        QCOMPARE(unknown.exitCode, 2);
        QVERIFY2(unknown.err.contains("luck") && unknown.err.contains("--parts"), unknown.err);
        const Outcome nothingToDraw = cli({"bench", "--parts", "field", "--plot", path("a.png")});
        QCOMPARE(nothingToDraw.exitCode, 2);
        const Outcome nowhere = cli({"bench", "--quick", "--runs", "1", "--rows", "1", "--parts",
                                     "steps", "--plot", path("no/such/folder.svg")});
        QCOMPARE(nowhere.exitCode, 1);
        QCOMPARE(nowhere.errorLines().size(), 1);
    }

private:
    QString path(const QString& name) const { return folder_.filePath(name); }
    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(BenchTest)
#include "BenchTest.moc"
