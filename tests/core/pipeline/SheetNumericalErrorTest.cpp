// Tests how far sheets move when they are computed with finer cells and steps, and the report of
// these moves.
#include "pipeline/SheetNumericalError.h"
#include "TestFolders.h"
#include "project/Project.h"

#include "PluginFolder.h"
#include "WholeSample.h"
#include "base/Error.h"
#include "project/ProjectStore.h"

#include <QDir>
#include <QJsonArray>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

using namespace dipwright;

namespace {

Project sample(const char* name) {
    return loadProject(sampleFolder("/%1.dipw").arg(name));
}

// Returns a project with the sample sphere on a small film.
Project sphereOn(int points) {
    Project project = sample("sphere");
    project.film = {}; // evenly spaced points
    project.film.width = project.film.height = Millimetres(160);
    project.film.columns = project.film.rows = points;
    project.fieldResolution = 64;
    return project;
}

} // namespace

class SheetNumericalErrorTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        coarse_ = sheetNumericalError(sphereOn(25), registry_, {});
    }

    void sheetNumericalError_samples_areWithinTheLimit_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::newRow("sphere") << QByteArray("sphere");
        if (test::isWholeRun()) {
            QTest::newRow("turtle") << QByteArray("turtle");
        }
    }
    void sheetNumericalError_samples_areWithinTheLimit() {
        QFETCH(QByteArray, name);
        const Project project = sample(name);
        const auto numericalError = sheetNumericalError(project, registry_, {});
        QCOMPARE(numericalError.size(), project.immersions.size());
        for (const DipNumericalError& one : numericalError) {
            const double step = one.halfStep.distance.percentile95;
            const double spacing = one.halfSpacing.distance.percentile95;
            QVERIFY2(
                step < mostHalfStepChange,
                qPrintable(
                    QStringLiteral(
                        "half the step moves 95 % of the sheet by up to %1 mm, expected < %2 mm")
                        .arg(step)
                        .arg(mostHalfStepChange)));
            QVERIFY2(
                spacing < mostHalfSpacingChange,
                qPrintable(
                    QStringLiteral(
                        "half the cell moves 95 % of the sheet by up to %1 mm, expected < %2 mm")
                        .arg(spacing)
                        .arg(mostHalfSpacingChange)));
            QVERIFY(one.halfSpacing.painted > 0.5 && one.halfSpacing.painted < 0.8);
            QVERIFY(one.halfSpacing.paintedOnce < 0.02);
            QVERIFY(isAccurateEnough(one));
        }
    }

    void sheetNumericalError_moreFilmPoints_moveLess() {
        const auto finer = sheetNumericalError(sphereOn(49), registry_, {});
        const Distribution& change = finer[0].halfSpacing.distance;
        QVERIFY(change.percentile95 < coarse_[0].halfSpacing.distance.percentile95 / 2);
        QVERIFY(change.percentile95 > 0);
    }

    void numericalErrorMap_withoutBody_isPale() {
        const QImage map = mapOf(coarse_[0]);
        QVERIFY(map.height() >= 1000);
        // The film's corner is pale; its middle is not.
        const QColor corner = map.pixelColor(map.width() / 6, map.height() / 6);
        const QColor middle = map.pixelColor(4 * map.width() / 10, map.height() / 2);
        QVERIFY(corner.lightnessF() > 0.7 && middle.lightnessF() < 0.5);
    }

    void sheetNumericalError_tooCoarseFilm_exceedsTheLimit() {
        const auto numericalError = sheetNumericalError(sphereOn(9), registry_, {});
        QVERIFY(numericalError[0].halfSpacing.distance.percentile95 > mostHalfSpacingChange);
        QVERIFY(!isAccurateEnough(numericalError[0]));
        const QJsonObject json =
            numericalErrorJson(numericalError)["immersions"].toArray()[0].toObject();
        QCOMPARE(json["name"].toString(), QStringLiteral("Front"));
        QCOMPARE(json["certain"].toBool(true), false);
    }

    void sheetNumericalError_sheetPaintsNothing_isNotWithinTheLimit() {
        Project project = sphereOn(9);
        project.film.width = project.film.height = Millimetres(900);
        const auto numericalError = sheetNumericalError(project, registry_, {});
        QCOMPARE(numericalError[0].halfStep.painted, 0.0);
        QVERIFY(!isAccurateEnough(numericalError[0]));
    }

    void sheetNumericalError_papersFilm_isComputed() {
        Project project = sphereOn(17);
        applyPreset(project, QStringLiteral("paper-2020"));
        project.film.columns = project.film.rows = 17;
        const auto numericalError = sheetNumericalError(project, registry_, {});
        QVERIFY(numericalError[0].halfStep.distance.percentile95 > 0);
        QVERIFY(numericalError[0].halfSpacing.distance.percentile95 > 0);
    }

    void sheetNumericalError_gpuMissing_cpuTakesOver() {
        const test::PluginFolder folder;
        QJsonObject description = test::PluginFolder::description(QStringLiteral("device"));
        folder.add(QStringLiteral("device"),
                   badModuleFolder("/") + test::PluginFolder::moduleName(QStringLiteral("device")));
        description[QLatin1String("device")] = QStringLiteral("gpu");
        folder.describe(description);
        const SolverRegistry registry({folder.path(), pluginFolder()});
        Project project = sphereOn(25);
        project.process.solver = QStringLiteral("device");
        const auto numericalError = sheetNumericalError(project, registry, {});
        QCOMPARE(numericalError[0].halfSpacing.distance.mean, coarse_[0].halfSpacing.distance.mean);
        QVERIFY(numericalError[0].notes.join('\n').contains("The CPU is used instead"));
        QVERIFY(coarse_[0].notes.isEmpty());
    }

    void writeNumericalErrorMaps_replacesEarlierMaps() {
        const QTemporaryDir folder;
        writeNumericalErrorMaps({coarse_[0], coarse_[0]}, folder.filePath("maps"));
        QVERIFY(QFileInfo::exists(folder.filePath("maps/certainty-2.png")));
        writeNumericalErrorMaps(coarse_, folder.filePath("maps"));
        const QImage map(folder.filePath("maps/certainty-1.png"));
        QVERIFY(map.height() >= 1000);
        QCOMPARE(QDir(folder.filePath("maps"))
                     .entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden),
                 QStringList("certainty-1.png"));
    }

    void sheetNumericalError_tooManyPoints_isRefused() {
        Project project = sphereOn(25);
        project.film.rows = 1500;
        try {
            sheetNumericalError(project, registry_, {});
            QFAIL("too many points were computed, expected a refusal");
        } catch (const Error& error) {
            QVERIFY2(error.sentence().contains("49 × 2999"), qPrintable(error.sentence()));
        }
    }

    void sheetNumericalError_progress_grows() {
        Progress progress;
        double last = 0;
        progress.report = [&](double share, const QString& text) {
            QVERIFY2(share >= last - 1e-9 && share <= 1 + 1e-9, qPrintable(text));
            last = share;
        };
        sheetNumericalError(sphereOn(9), registry_, progress);
        QVERIFY(last > 0.9);
    }

    void sheetNumericalError_cancelled_throws() {
        Progress progress;
        CancelToken cancelToken = progress.cancelToken;
        progress.report = [&cancelToken](double share, const QString&) {
            if (share > 0.4) {
                cancelToken.cancel();
            }
        };
        QVERIFY_EXCEPTION_THROWN(sheetNumericalError(sphereOn(49), registry_, progress), Cancelled);
    }

private:
    const SolverRegistry registry_{QStringList{pluginFolder()}};
    std::vector<DipNumericalError> coarse_;
};

QTEST_MAIN(SheetNumericalErrorTest)
#include "SheetNumericalErrorTest.moc"
