// Tests how the command line compensates each ink on stretched film, from the step wedge to the
// sheet.
#include "CliProcess.h"
#include "PaperMeasure.h"
#include "TestFolders.h"
#include "TestProfiles.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace dipwright;
using namespace dipwright::test;

namespace {

bool wrote(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

QByteArray read(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// Returns the rows of a plate that have ink between the wedge's labels and the paper's right edge.
QSet<int> inkedRows(const QImage& plate) {
    QSet<int> rows;
    for (int y = plate.height() / 8; y < plate.height() * 2 / 5; ++y) {
        int inked = 0;
        for (int x = plate.width() / 5; x < plate.width(); ++x) {
            inked += qGray(plate.pixel(x, y)) < 128;
        }
        if (inked > plate.width() / 20) {
            rows.insert(y);
        }
    }
    return rows;
}

} // namespace

class InkWedgeTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QVERIFY(wrote(in("inks.icc"), simpleCmykProfile(0.002)));
        QCOMPARE(cli({"profile", "set", "printer", "Press", "--icc", in("inks.icc"), "--set",
                      "total_ink=2.4"})
                     .exitCode,
                 0);
    }

    void calibrateWedge_cmykProfile_printsEachInkAlone() {
        QCOMPARE(
            cli({"calibrate", "wedge", "--profile", "Press", "--to", in("wedge.pdf")}).exitCode, 0);
        const QByteArray table = read(in("wedge.csv"));
        QVERIFY(table.contains("\nblack,0.3,,,,"));
        QVERIFY(!table.contains("cyan,2,")); // the page ends where the ink reaches no more
        output("gs", {"-q", "-dNOPAUSE", "-dBATCH", "-dSAFER", "-sDEVICE=tiffsep", "-r60", "-o",
                      in("page.tif"), in("wedge.pdf")});
        QSet<int> all;
        for (const char* ink : {"Cyan", "Magenta", "Yellow"}) {
            const QSet<int> own = inkedRows(QImage(in(QString("page(%1).tif").arg(ink))));
            QVERIFY2(own.size() > 10, ink); // a row of patches with this ink …
            QVERIFY2(!all.intersects(own), ink);
            all.unite(own); // … where no other ink is printed
        }
        QVERIFY(
            cli({"calibrate", "wedge", "--profile", "Press", "--to", in("wedge.png")}).exitCode !=
            0);
    }

    void run_perInkReadings_reportsPerInkShortfall() {
        QByteArray readings = "ink,nominal,flat,across,down,shown\n";
        for (const auto& [ink, exponent] :
             {std::pair("cyan", 0.8), std::pair("magenta", 0.4), std::pair("black", 0.2)}) {
            for (const double tone : {0.1, 0.3}) {
                const double shown = tone * std::pow(1.5, -exponent);
                readings += QByteArray(ink) + ',' + QByteArray::number(tone) + ',' +
                            QByteArray::number(tone) + ",150,100," + QByteArray::number(shown) +
                            '\n';
            }
        }
        QVERIFY(wrote(in("readings.csv"), readings));
        QCOMPARE(cli({"profile", "wedge", "Film", in("readings.csv")}).exitCode, 0);
        const QString job = in("job.dipw");
        QVERIFY(QFile::copy(sampleFolder("/sphere.dipw"), job));
        QVERIFY(QFile::setPermissions(job, QFile::ReadOwner | QFile::WriteOwner));
        QCOMPARE(cli({"profile", "use", "film", "Film", job}).exitCode, 0);
        const QStringList coarse{"--set", "film.points=40x57", "--set", "sheet.dpi=60", "--quiet"};
        const auto shortfall = [&](const QString& folder) {
            return QJsonDocument::fromJson(
                read(folder + "/report.json"))["immersions"][0]["ink"]["per_ink_shortfall_area"];
        };
        QCOMPARE(cli(QStringList{"run", job, "--out", in("without")} + coarse).exitCode, 0);
        QVERIFY(shortfall(in("without")).isUndefined());
        QCOMPARE(cli({"profile", "use", "printer", "Press", job}).exitCode, 0);
        QCOMPARE(cli(QStringList{"run", job, "--out", in("with")} + coarse).exitCode, 0);
        QVERIFY(shortfall(in("with")).isDouble());
        QVERIFY(shortfall(in("with")).toDouble() >= 0);
    }

    void print_plates_areThoseOfThePdf() {
        const QString job = in("plates.dipw");
        QStringList create{"new",       job, "--model", sampleFolder("/models/turtle.obj"),
                           "--size-mm", "60"};
        for (const char* value :
             {"film.points=40x57", "sheet.dpi=60", "sheet.marks=false", "sheet.ruler=false",
              "sheet.job_line=false", "sheet.white=last"}) {
            create << "--set" << value;
        }
        QCOMPARE(cli(create).exitCode, 0);
        const Outcome refused = cli({"print", job, "--plates", in("proof")});
        QCOMPARE(refused.exitCode, 1);
        QVERIFY(refused.err.contains("ICC profile in CMYK"));
        const Outcome printed = cli({"print", job, "--profile", "Press", "--plates", in("proof"),
                                     "--to", in("plates.pdf"), "--quiet"});
        QCOMPARE(printed.exitCode, 0);
        QVERIFY(printed.out.contains("above the limit of 240.0 %: 0.0 mm²"));
        output("gs", {"-q", "-dNOPAUSE", "-dBATCH", "-dSAFER", "-sDEVICE=tiffsep", "-r60", "-o",
                      in("plates.tif"), in("plates.pdf")});
        int number = 0;
        for (const char* ink : {"Cyan", "Magenta", "Yellow", "Black", "White"}) {
            const QImage own(in(QString("proof/plate-%1-%2.png").arg(++number).arg(ink)));
            const QImage page(in(QString("plates(%1).tif").arg(ink)));
            QVERIFY2(!own.isNull() && !page.isNull(), ink);
            qint64 differing = 0;
            for (int y = 0; y < std::min(own.height(), page.height()); ++y) {
                for (int x = 0; x < std::min(own.width(), page.width()); ++x) {
                    differing += std::abs(qGray(own.pixel(x, y)) - qGray(page.pixel(x, y))) > 2;
                }
            }
            QVERIFY2(differing * 200 < qint64(own.width()) * own.height(), ink);
        }
        QVERIFY(QFile::exists(in("proof/total-ink.png")));
        // The folder gets plates of another job, of one dip after the other.
        QVERIFY(wrote(in("proof/plate-artwork.png"), "not a plate"));
        for (const char* dip : {"2", "1"}) {
            QCOMPARE(plates(sampleFolder("/turtle.dipw"), in("proof"), {"--immersion", dip}), 0);
        }
        QVERIFY(QFile::exists(in("proof/immersion-1/plates.json")));
        QVERIFY(QFile::exists(in("proof/immersion-2/plates.json")));
        QCOMPARE(QDir(in("proof")).entryList(QDir::Files), QStringList{"plate-artwork.png"});
    }

    void print_plates_neverReplaceOtherFiles() {
        QVERIFY(QDir().mkpath(in("own")));
        QVERIFY(wrote(in("own/composite.png"), "not a plate"));
        QCOMPARE(plates(sampleFolder("/sphere.dipw"), in("own"), {}), 1);
        QCOMPARE(read(in("own/composite.png")), QByteArray("not a plate"));
        QCOMPARE(plates(sampleFolder("/sphere.dipw"), in("own"), {"--copies", "2"}), 2);
    }

private:
    // Prints the plates of a sample with a coarse film. Returns the exit code.
    int plates(const QString& sample, const QString& folder, const QStringList& options) const {
        const QString job = in("sample.dipw");
        QFile::remove(job);
        if (!QFile::copy(sample, job) ||
            !QFile::setPermissions(job, QFile::ReadOwner | QFile::WriteOwner)) {
            return -1;
        }
        return cli(QStringList{"print", job, "--profile", "Press", "--plates", folder, "--quiet",
                               "--set", "film.points=40x57", "--set", "sheet.dpi=60"} +
                   options)
            .exitCode;
    }

    QString in(const QString& name) const { return folder_.filePath(name); }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(InkWedgeTest)
#include "InkWedgeTest.moc"
