// Tests the closed forms against known values and formulas (docs/film-model.md, "Closed forms").
#include "validation/ClosedForm.h"

#include "base/Units.h"

#include <QTest>
#include <cmath>

using namespace dipwright;

namespace {

constexpr double large = 1e6; // radius of a very large film, mm

FloatingFilm film(FilmLaw law, FilmEdge edge, double radius) {
    return {law, edge, radius};
}

FloatingFilm grown(FloatingFilm film, const std::function<double(double)>& law) {
    film.grown = law;
    return film;
}

double filmRadius(const Meridian& body, const FloatingFilm& film) {
    return ClosedForm(body, film).filmRadius(body.fullArc);
}

bool agree(double value, double expected) {
    return std::abs(value / expected - 1) < 1e-5;
}

} // namespace

class ClosedFormTest : public QObject {
    Q_OBJECT

private slots:
    void closedForm_largeFilms_matchKnownRadii();
    void closedForm_filmGrownBefore_equalsALargerFilm();
    void closedForm_heldFilm_doesNotDependOnGrowth();
    void closedForm_growingLargeFilms_matchFormulas();
    void filmOnCylinder_freeFilm_matchesKnownLengths();
};

void ClosedFormTest::closedForm_largeFilms_matchKnownRadii() {
    const Meridian cone = coneMeridian(pi / 4, 35), sphere = sphereMeridian(35, pi / 2);
    for (const FilmEdge edge : {FilmEdge::Held, FilmEdge::Free}) {
        QVERIFY(agree(filmRadius(cone, film(FilmLaw::Elastic, edge, large)), 35 * 1.2071068));
        QVERIFY(agree(filmRadius(cone, film(FilmLaw::Viscous, edge, large)), 35 * 1.1892071));
        QVERIFY(agree(filmRadius(sphere, film(FilmLaw::Viscous, edge, large)), 49.497475));
    }
}

void ClosedFormTest::closedForm_filmGrownBefore_equalsALargerFilm() {
    const Meridian sphere = sphereMeridian(35, radians(Degrees(80)));
    const auto always = [](double) { return 1.2; };
    for (const FilmLaw law : {FilmLaw::Elastic, FilmLaw::Viscous}) {
        const double small = filmRadius(sphere, grown(film(law, FilmEdge::Free, 100), always));
        QVERIFY(agree(1.2 * small, filmRadius(sphere, film(law, FilmEdge::Free, 120))));
    }
}

void ClosedFormTest::closedForm_heldFilm_doesNotDependOnGrowth() {
    const Meridian sphere = sphereMeridian(35, radians(Degrees(80)));
    for (const FilmLaw law : {FilmLaw::Elastic, FilmLaw::Viscous}) {
        const FloatingFilm held = film(law, FilmEdge::Held, 90);
        const FloatingFilm growing = grown(held, [](double depth) { return 1.1 + depth / 100; });
        QVERIFY(agree(filmRadius(sphere, growing), filmRadius(sphere, held)));
    }
}

// The film has grown by the factor e^(kh) at the depth h. Viscous film: R² = 2∫a/g² ds. Elastic
// film: dR/ds·(2g − a/R) = 1.
void ClosedFormTest::closedForm_growingLargeFilms_matchFormulas() {
    constexpr double k = 0.004;
    const auto law = [](double depth) { return std::exp(k * depth); };
    const Meridian cone = coneMeridian(pi / 4, 35);
    const double c = 2 * k * std::cos(pi / 4), s = cone.fullArc;
    const double integral = (1 - (1 + c * s) * std::exp(-c * s)) / (c * c);
    QVERIFY(agree(filmRadius(cone, grown(film(FilmLaw::Viscous, FilmEdge::Free, large), law)),
                  std::sqrt(2 * std::sin(pi / 4) * integral)));

    const ClosedForm elastic(cone, grown(film(FilmLaw::Elastic, FilmEdge::Free, large), law));
    for (const double arc : {5.0, 20.0, 45.0}) {
        const double slope = (elastic.filmRadius(arc + 0.1) - elastic.filmRadius(arc - 0.1)) / 0.2;
        const double mean = law(cone.height(arc)),
                     hoop = cone.radius(arc) / elastic.filmRadius(arc);
        QVERIFY(agree(slope * (2 * mean - hoop), 1));
    }
}

void ClosedFormTest::filmOnCylinder_freeFilm_matchesKnownLengths() {
    for (const FilmLaw law : {FilmLaw::Elastic, FilmLaw::Viscous}) {
        const FloatingFilm free = film(law, FilmEdge::Free, 0);
        QVERIFY(agree(filmOnCylinder(20, 28, free), 28));
        QVERIFY(agree(filmOnCylinder(20, 28, grown(free, [](double) { return 1.2; })), 28 / 1.2));
        // The film grows after the first contact, which stretches it across the cylinder.
        const auto late = [](double depth) { return depth > 0 ? 1.03 : 1.0; };
        QVERIFY(std::abs(filmOnCylinder(20, 28, grown(free, late)) * 1.04 / 28 - 1) < 1e-3);
    }
}

QTEST_GUILESS_MAIN(ClosedFormTest)
#include "ClosedFormTest.moc"
