// Tests withFit(): it changes the fitted values of a project and no other values.
#include "inspection/FilmFitFiles.h"
#include "project/Project.h"

#include <QJsonObject>
#include <QTest>

using namespace dipwright;

namespace {

const WatchNotes notes{QStringLiteral("2027-03-31"), {}, {}};

Project editedProject() {
    Project project;
    project.film.relaxationTime = Seconds(4);
    project.film.edges.leftPinned = true;
    project.film.contactDistance = Millimetres(0.25);
    project.film.growthRate = 0.004;
    project.film.growthLimit = 0.2;
    project.film.gripFade = Degrees(8);
    project.film.gatheringStretch = 0.75;
    project.film.resolution = FilmResolution::Automatic;
    project.process.overhang = Degrees(30);
    project.process.tearStretch = 5;
    project.ink.law.exponents = {0.4, 0.5, 0.6, 0.7, 0.8};
    project.ink.law.tones = {{FilmInk::Cyan, 0.3, 0.5, 0.1, 3}};
    return project;
}

FilmFit fitOfSwell(const Project& project) {
    FilmFit fit;
    fit.quantities = {{{FitQuantity::SwellX, 0}, 1, 1.06, 1.05, 1.07},
                      {{FitQuantity::SwellY, 0}, 1, 1.04, 1.03, 1.05}};
    fit.immersions = project.immersions;
    return fit;
}

} // namespace

class UseFitTest : public QObject {
    Q_OBJECT

private slots:
    void withFit_editedProject_keepsAllThatWasNotFitted_data() {
        QTest::addColumn<bool>("hasProfile");
        QTest::newRow("without a film profile") << false;
        QTest::newRow("with a film profile that has other values") << true;
    }

    void withFit_editedProject_keepsAllThatWasNotFitted() {
        QFETCH(bool, hasProfile);
        Project project = editedProject();
        if (hasProfile) {
            FilmProfile other;
            other.name = QStringLiteral("Lot 9");
            other.overhang = Degrees(10);
            other.tearStretch = 2;
            project.profiles.film = other;
        }
        Project used = withFit(project, fitOfSwell(project), {}, notes, QStringLiteral("Measured"));
        QCOMPARE(used.film.swellX, 1.06);
        QCOMPARE(used.film.swellY, 1.04);
        QVERIFY(used.profiles.film);
        QCOMPARE(used.profiles.film->name,
                 hasProfile ? QStringLiteral("Lot 9") : QStringLiteral("Measured"));
        QVERIFY(used.ink.law == project.ink.law);
        QVERIFY(used.profiles.film->ink == project.ink.law);

        used.film.swellX = project.film.swellX;
        used.film.swellY = project.film.swellY;
        used.profiles = project.profiles;
        QCOMPARE(toJson(used), toJson(project));
    }

    void newProfileFor_project_keepsItsFilm() {
        const Project project = editedProject();
        const FilmProfile saved =
            withFit(newProfileFor(project, QStringLiteral("New")), fitOfSwell(project), {}, notes);
        QCOMPARE(saved.name, QStringLiteral("New"));
        QCOMPARE(saved.swellX, 1.06);
        QCOMPARE(saved.relaxationTime.value(), 4.0);
        QCOMPARE(saved.growthRate, 0.004);
        QCOMPARE(saved.contactDistance.value(), 0.25);
        QVERIFY(saved.edges.leftPinned);
    }

    void otherFilmNote_valuesThatWereNotFitted_areCompared() {
        const Project project = editedProject();
        FilmProfile profile = newProfileFor(project, QStringLiteral("New"));
        profile.swellX = 1.5; // was fitted
        QVERIFY(otherFilmNote(profile, project, fitOfSwell(project)).isEmpty());
        profile.relaxationTime = Seconds(9);
        QVERIFY(otherFilmNote(profile, project, fitOfSwell(project)).contains("New"));
    }
};

QTEST_GUILESS_MAIN(UseFitTest)
#include "UseFitTest.moc"
