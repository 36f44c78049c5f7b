// Tests that prices, times at the tank and the size of an order change neither sheets nor job
// numbers, and that a project keeps them.
#include "model/TexturedMesh.h"
#include "pipeline/JobOptions.h"
#include "pipeline/JobSheet.h"
#include "pipeline/StepInputs.h"
#include "project/Profiles.h"
#include "project/Project.h"

#include <QtTest>

using namespace dipwright;

namespace {

Project plainProject() {
    static const auto model = std::make_shared<const TexturedMesh>();
    Project project;
    project.name = QStringLiteral("Box");
    project.model = model;
    project.profiles = {PrinterProfile(), FilmProfile(), TankProfile()};
    project.profiles.printer->name = QStringLiteral("Printer");
    project.profiles.film->name = QStringLiteral("Film");
    project.profiles.tank->name = QStringLiteral("Tank");
    return project;
}

Project pricedProject() {
    Project project = plainProject();
    project.profiles.printer->costs.laydown = {9, 9, 9, 8};
    project.profiles.film->costs = {12.5, FilmPriceUnit::RollMetre};
    project.profiles.tank->costs.labourRate = 40;
    project.profiles.tank->costs.currency = QStringLiteral("EUR");
    project.partsToMake = 25;
    project.asBuilt.corrects = true; // what it corrects is in the image
    project.asBuilt.strength = 0.5;
    project.asBuilt = withTankRun(
        project.asBuilt,
        {{1, 1, TankStep::Soak, QStringLiteral("2026-11-26T12:00:00"), Seconds(60), Seconds(63.5)},
         {1, 1, TankStep::Compare, QStringLiteral("2026-11-26T12:01:03"), {}, Seconds(9)}});
    return project;
}

QString jobNumber(const Project& project) {
    QImage image(20, 30, QImage::Format_RGBA8888);
    image.fill(Qt::red);
    return jobSheet(project, project.immersions.front(), {.colours = image}).job.hash;
}

} // namespace

class JobCostTest : public QObject {
    Q_OBJECT

private slots:
    void jobNumber_pricesOrderTimesAndParts_doNotMatter() {
        QCOMPARE(jobNumber(pricedProject()), jobNumber(plainProject()));
    }

    // So traveller, cradle and sheet agree on where the marks are.
    void jobSheet_printerWithMargins_keepsMarksClear() {
        Project project = plainProject();
        QImage image(20, 30, QImage::Format_RGBA8888);
        image.fill(Qt::red);
        const auto clearance = [&] {
            return jobSheet(project, project.immersions.front(), {.colours = image})
                .clearance.value();
        };
        QCOMPARE(clearance(), 3.0);
        project.profiles.printer.emplace();
        QCOMPARE(clearance(), 3.0);
        project.profiles.printer->margins = {Millimetres(5), Millimetres(4), Millimetres(0),
                                             Millimetres(2)};
        QCOMPARE(clearance(), 5.0);
        // The page is enlarged about its middle by 1/0.99.
        project.profiles.printer->scaleX = project.profiles.printer->scaleY = 0.99;
        const double half = std::max(project.film.width, project.film.height).value() / 2;
        QVERIFY(std::abs(clearance() - (half - 0.99 * (half - 5))) < 1e-9);
    }

    void jobNumber_printerProfile_doesNotMatter() {
        Project other = plainProject();
        other.profiles.printer->name = QStringLiteral("Other");
        other.profiles.printer->scaleX = 1.02;
        QCOMPARE(jobNumber(other), jobNumber(plainProject()));
    }

    void sheetInputs_pricesOrderAndTimes_doNotMatter() {
        QVERIFY(sheetInputs(pricedProject(), {}, 0, "pbd-cpu") ==
                sheetInputs(plainProject(), {}, 0, "pbd-cpu"));
    }

    void project_pricesOrderAndTimes_areKept() {
        const Project project = pricedProject();
        const Project read = fromJson(toJson(project), QStringLiteral("job.dipw"));
        QCOMPARE(read.partsToMake, 25);
        QVERIFY(read.profiles == project.profiles);
        QVERIFY(read.asBuilt == project.asBuilt);
    }

    void project_withoutPrices_isWrittenAsBefore() {
        const QJsonObject json = toJson(plainProject());
        QVERIFY(!json.contains(QStringLiteral("order")));
        QVERIFY(!json["as_built"].toObject().contains(QStringLiteral("times")));
        for (const char* kind : {"printer", "film", "tank"}) {
            QVERIFY(!json["profiles"].toObject()[QLatin1String(kind)].toObject().contains(
                QStringLiteral("cost")));
        }
    }

    void withTankRun_manyRuns_areNumberedAndLimited() {
        AsBuilt built;
        for (int run = 0; run < 700; ++run) {
            built = withTankRun(built, std::vector<TankTime>(8));
        }
        QVERIFY(built.times.size() <= mostTankTimes);
        QCOMPARE(built.times.back().run, 700);
        QCOMPARE(built.times.size() % 8, std::size_t(0));
    }
};

QTEST_GUILESS_MAIN(JobCostTest)
#include "JobCostTest.moc"
