// Tests `dipwright-cli calibrate` without a printer.
#include "CliProcess.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

using dipwright::test::cli;
using dipwright::test::Outcome;

class CalibrateCommandTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    QString in(const char* name) const { return folder_.filePath(QLatin1String(name)); }

private slots:
    void initTestCase() {
        qputenv("DIPWRIGHT_PROFILE_PATH", folder_.filePath("profiles").toUtf8());
    }

    void calibrate_otherPaper_hintRepeatsThePaper() {
        for (int time = 0; time < 2; ++time) { // the second page replaces the first
            const Outcome outcome =
                cli({"calibrate", "--profile", "Hint", "--to", in("l.pdf"), "--paper", "Letter"});
            QVERIFY2(outcome.exitCode == 0, outcome.err);
            QVERIFY2(outcome.out.contains("--paper Letter --measured 180x210"), outcome.out);
        }
    }

    void calibrate_lengthsOfAnotherPaper_areRefused() {
        const auto measured = [](const char* lengths) {
            return cli({"calibrate", "--profile", "Letters", "--measured", lengths});
        };
        // Letter, printed truly, and by a printer with an error of 3 %.
        for (const char* lengths : {"180x210", "180.6x209.5", "185.4x216.3", "174.6x203.7"}) {
            const Outcome outcome = measured(lengths);
            QVERIFY2(outcome.exitCode == 2, outcome.out);
            QVERIFY2(outcome.err.contains("--paper Letter"), outcome.err);
        }
        QCOMPARE(cli({"profile", "show", "printer", "Letters"}).exitCode, 1);
        const Outcome named = cli({"calibrate", "--profile", "Letters", "--paper", "Letter",
                                   "--measured", "180.6x209.5"});
        QVERIFY2(named.out.contains("1.00333 × 0.99762"), named.out + named.err);
    }

    void calibrate_lengthsOfA4_areTakenWithoutPaper() {
        for (const char* lengths : {"170x220", "173.4x215.6", "163.2x211.2", "178.5x228.8"}) {
            const Outcome outcome = cli({"calibrate", "--profile", "Usual", "--measured", lengths});
            QVERIFY2(outcome.exitCode == 0, outcome.err);
        }
    }

    void calibrate_rulersAsTiff_areRefused() {
        const Outcome outcome = cli({"calibrate", "--profile", "Mine", "--to", in("x.tif")});
        QCOMPARE(outcome.exitCode, 2);
        QVERIFY2(outcome.err.contains("ends in .pdf"), outcome.err);
        QVERIFY(!QFile::exists(in("x.tif")));
    }

    void calibrate_ignoredOptions_areRefused() {
        const QStringList measured{"calibrate", "--profile", "Mine", "--measured", "170x220"};
        const QStringList film{"calibrate", "film", "--to", in("film.pdf")};
        for (const QStringList& arguments :
             {measured + QStringList{"--to", in("x.pdf")},
              measured + QStringList{"--printer", "pigment"}, measured + QStringList{"--lot", "7"},
              film + QStringList{"--measured", "170x220"}, film + QStringList{"--verify"},
              film + QStringList{"--printer", "pigment"}}) {
            const Outcome outcome = cli(arguments);
            QVERIFY2(outcome.exitCode == 2, qPrintable(arguments.join(' ')));
            QVERIFY2(outcome.err.contains("has no effect"), outcome.err);
        }
        QVERIFY(!QFile::exists(in("film.pdf")) && !QFile::exists(in("x.pdf")));
    }
};

QTEST_MAIN(CalibrateCommandTest)
#include "CalibrateCommandTest.moc"
