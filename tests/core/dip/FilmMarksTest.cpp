// Tests which paint comes from marked film, with films laid by hand.
#include "dip/Coverage.h"

#include "DippedByHand.h"
#include "geometry/Shapes.h"

#include <QtTest>

using namespace dipwright;
using solver::PointMark;

namespace {

constexpr double side = 20; // mm, a quarter of the box's bottom
const Eigen::Vector3d boxSize(40, 30, 40);

// A film of 1 mm cells under the box. `markAt` gives the mark of each rest position.
template <typename MarkAt>
std::shared_ptr<const LaidFilm> markedFilm(const MarkAt& markAt) {
    DippedFilm film = test::flatUnderBox({61, 61, 60, 60}, boxSize);
    for (std::size_t point = 0; point < film.positions.size(); ++point) {
        film.marks.push_back(markAt(restPosition(film.grid, point)));
    }
    return test::laid(boxMesh(boxSize), film);
}

constexpr std::uint8_t torn = std::uint8_t(PointMark::Torn);
constexpr std::uint8_t letGo = std::uint8_t(PointMark::LetGo);

} // namespace

class FilmMarksTest : public QObject {
    Q_OBJECT

private slots:
    void coverage_markedFilm_marksItsPaint() {
        // Film under a quarter of the box's bottom is marked, and so are the cells that share
        // points with it.
        const auto laid = markedFilm([](const Eigen::Vector2f& rest) {
            return rest.x() >= 0 && rest.y() >= 0 ? letGo : std::uint8_t(0);
        });
        const Coverage cover = coverage(*laid);
        QVERIFY(cover.marked.any > side * side);
        QVERIFY(cover.marked.any < 1.02 * (side + 1) * (side + 1));
        QCOMPARE(cover.marked.of(PointMark::LetGo), cover.marked.any);
        QCOMPARE(cover.marked.of(PointMark::Torn), 0.0);
    }

    void coverage_twoMarksOnOneFilm_countOnceInTotal() {
        const auto laid = markedFilm([](const Eigen::Vector2f& rest) {
            return std::uint8_t((rest.x() >= 0 ? letGo : 0) | (rest.x() >= 0 ? torn : 0));
        });
        const Coverage cover = coverage(*laid);
        QCOMPARE(cover.marked.of(PointMark::LetGo), cover.marked.any);
        QCOMPARE(cover.marked.of(PointMark::Torn), cover.marked.any);
        QCOMPARE(mostSeriousMark(paintedMarks(*laid)), std::optional(PointMark::Torn));
    }

    void coverage_markedFilmBesideTheBody_marksNothing() {
        const auto laid = markedFilm([](const Eigen::Vector2f& rest) {
            return std::abs(rest.x()) > 20 ? torn : std::uint8_t(0);
        });
        QCOMPARE(coverage(*laid).marked.any, 0.0);
        QCOMPARE(paintedMarks(*laid), std::uint8_t(0));
        QVERIFY(!mostSeriousMark(0));
    }

    void coverage_unmarkedFilm_marksNothing() {
        const auto laid =
            test::laid(boxMesh(boxSize), test::flatUnderBox({61, 61, 60, 60}, boxSize));
        const Coverage cover = coverage(*laid);
        QCOMPARE(cover.marked.any, 0.0);
        QVERIFY(markedText(cover.marked, cover.paintedArea).isEmpty());
    }

    void coverage_faceMostlyPaintedByMarkedFilm_isMarked() {
        const auto laid = markedFilm([](const Eigen::Vector2f& rest) {
            return rest.x() + rest.y() > 0 ? letGo : std::uint8_t(0);
        });
        const TriangleMesh& mesh = laid->body().mesh;
        const Coverage cover = coverage(*laid);
        int marked = 0;
        for (std::size_t triangle = 0; triangle < cover.marks.size(); ++triangle) {
            marked += cover.marks[triangle] == letGo;
            QVERIFY(cover.marks[triangle] == 0 || triangleNormal(mesh, triangle).y() < -0.9f);
        }
        QVERIFY(marked > 0);
    }

    void markedText_hasAreaShareAndCause() {
        MarkedArea marked;
        marked.add(torn, 30);
        marked.add(letGo, 20);
        const QString text = markedText(marked, 1000);
        for (const char* part : {"50 mm²", "5.0 %", "Torn film: 30 mm²", "Released film: 20 mm²"}) {
            QVERIFY2(text.contains(QString::fromUtf8(part)), qPrintable(text));
        }
    }
};

QTEST_GUILESS_MAIN(FilmMarksTest)
#include "FilmMarksTest.moc"
