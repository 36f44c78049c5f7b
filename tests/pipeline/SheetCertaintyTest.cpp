// How far sheets move when they are computed more finely, and that the user is told.
#include "pipeline/SheetCertainty.h"

#include "base/Error.h"
#include "project/ProjectStore.h"

#include <QGuiApplication>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

using namespace dipwright;

namespace {

Project sample(const char* name) {
    return loadProject(QStringLiteral(DIPWRIGHT_SAMPLE_FOLDER "/%1.dipw").arg(name));
}

// The sample sphere on a small film.
Project sphereOn(int points) {
    Project project = sample("sphere");
    project.film.width = project.film.height = Millimetres(160);
    project.film.columns = project.film.rows = points;
    project.fieldResolution = 64;
    return project;
}

} // namespace

class SheetCertaintyTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        coarse_ = sheetCertainty(sphereOn(25), registry_, {});
    }

    void samplesAreCertain_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::newRow("sphere") << QByteArray("sphere");
        QTest::newRow("turtle") << QByteArray("turtle");
    }
    void samplesAreCertain() {
        QFETCH(QByteArray, name);
        const Project project = sample(name);
        const auto certainty = sheetCertainty(project, registry_, {});
        QCOMPARE(certainty.size(), project.immersions.size());
        for (const ImmersionCertainty& one : certainty) {
            QVERIFY2(one.halfStep.percentile95 < 0.05,
                     qPrintable(QString::number(one.halfStep.percentile95)));
            QVERIFY2(one.halfSpacing.percentile95 < 0.15,
                     qPrintable(QString::number(one.halfSpacing.percentile95)));
            QVERIFY(one.halfSpacing.painted > 0.5 && one.halfSpacing.painted < 0.8);
        }
        QVERIFY(certaintyWarnings(certainty).isEmpty());
    }

    void moreFilmPointsAreMoreCertain() {
        const auto finer = sheetCertainty(sphereOn(49), registry_, {});
        QVERIFY(finer[0].halfSpacing.percentile95 < coarse_[0].halfSpacing.percentile95 / 2);
        QVERIFY(finer[0].halfSpacing.percentile95 > 0);
    }

    void changesAreOrdered() {
        for (const SheetChange& change : {coarse_[0].halfStep, coarse_[0].halfSpacing}) {
            QVERIFY(change.median > 0 && change.median < change.percentile95);
            QVERIFY(change.percentile95 <= change.percentile99);
            QVERIFY(change.percentile99 <= change.maximum);
        }
    }

    void filmThatIsNotOnTheBodyDoesNotMove() {
        const std::vector<float>& points = coarse_[0].halfSpacing.points;
        QCOMPARE(points.size(), std::size_t(25 * 25));
        QCOMPARE(points.front(), 0.f);
        int moved = 0;
        for (std::size_t point = 0; point < points.size(); ++point) {
            QVERIFY(points[point] == 0 || coarse_[0].contact->surface[point].isValid());
            moved += points[point] > 0 ? 1 : 0;
        }
        QVERIFY2(moved > 50, qPrintable(QString::number(moved)));
    }

    void tooCoarseFilmIsToldOf() {
        const auto certainty = sheetCertainty(sphereOn(9), registry_, {});
        QVERIFY(certainty[0].halfSpacing.percentile95 > certainHalfSpacing);
        const QStringList warnings = certaintyWarnings(certainty);
        QCOMPARE(warnings.size(), 1);
        QVERIFY2(warnings[0].startsWith("Front: "), qPrintable(warnings[0]));
    }

    void mapsAreWritten() {
        const QTemporaryDir folder;
        writeCertaintyMaps(coarse_, folder.filePath("maps"));
        const QImage map(folder.filePath("maps/certainty-1.png"));
        QVERIFY(map.height() >= 1000);
        QCOMPARE(QDir(folder.filePath("maps"))
                     .entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden),
                 QStringList("certainty-1.png"));
    }

    void moreThanTheMostPointsAreRefused() {
        Project project = sphereOn(25);
        project.film.rows = 1500;
        try {
            sheetCertainty(project, registry_, {});
            QFAIL("computed");
        } catch (const Error& error) {
            QVERIFY2(error.sentence().contains("49 × 2999"), qPrintable(error.sentence()));
        }
    }

    void cancelledItThrows() {
        Progress progress;
        CancelSwitch cancelSwitch = progress.cancelSwitch;
        progress.report = [&cancelSwitch](double share, const QString&) {
            if (share > 0.4) {
                cancelSwitch.cancel();
            }
        };
        QVERIFY_EXCEPTION_THROWN(sheetCertainty(sphereOn(49), registry_, progress), Cancelled);
    }

private:
    const SolverRegistry registry_{QStringList{DIPWRIGHT_PLUGINS}};
    std::vector<ImmersionCertainty> coarse_;
};

QTEST_MAIN(SheetCertaintyTest)
#include "SheetCertaintyTest.moc"
