// Tests the files and pictures of a run. The film is laid round a ball by the closed form, without
// a solver.
#include "results/Results.h"
#include "DippedByHand.h"
#include "texture/LinearLight.h"

#include "base/Error.h"
#include "dip/FilmMarks.h"
#include "dip/PaintedStretch.h"
#include "geometry/CornerNormals.h"
#include "geometry/Shapes.h"
#include "results/ProofScene.h"

#include <QColorSpace>
#include <QPainter>
#include <QtTest>
#include <cmath>
#include <limits>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataReader.h>

using namespace dipwright;

namespace {

constexpr double radius = 35;

TexturedMesh ball() {
    TexturedMesh model;
    model.mesh = sphereMesh(radius, 60, 120);
    const std::size_t count = model.mesh.triangles.size();
    model.textureCoordinates.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Eigen::Vector3f& p = model.mesh.positions[model.mesh.triangles[i][corner]];
            model.textureCoordinates[i][corner] = {p.x() / 70 + 0.5f, p.z() / 70 + 0.5f};
        }
    }
    model.material.assign(count, 0);
    model.materials.push_back({});
    model.chart = findCharts(model);
    return model;
}

// Returns a film that has kept its area on the lower half of the ball: R = 2ρ sin(θ/2)
// (docs/film-model.md, "Closed forms").
DippedFilm dippedFilm(const solver::FilmGrid& grid) {
    DippedFilm film;
    film.grid = grid;
    for (std::size_t point = 0; point < grid.pointCount(); ++point) {
        const Eigen::Vector2f rest = restPosition(grid, point);
        const double flat = rest.norm();
        const double theta = 2 * std::asin(std::min(1.0, flat / (2 * radius)));
        const Eigen::Vector2f outward =
            flat > 0 ? Eigen::Vector2f(rest / flat) : Eigen::Vector2f(1, 0);
        const bool on = theta <= pi / 2;
        const double across =
            on ? radius * std::sin(theta) : flat - (2 * std::sin(pi / 4) - 1) * radius;
        const double height = on ? radius * (1 - std::cos(theta)) : radius;
        film.positions.emplace_back(float(across) * outward.x(), float(height),
                                    float(across) * outward.y());
        film.states.push_back(on ? solver::PointState::Adhered : solver::PointState::Free);
    }
    return film;
}

struct Dip {
    TexturedMesh model = ball();
    std::shared_ptr<const PosedBody> body =
        std::make_shared<const PosedBody>(posedBody(model.mesh, Immersion{}));
    std::shared_ptr<const LaidFilm> laid =
        layFilm(body, dippedFilm({81, 113, 140, 196}), ProcessSettings{});
    const DippedFilm& film = laid->film();
    Coverage covered = coverage(*laid);

    // Returns the same dip with all film marked on the right or the left of the middle.
    std::shared_ptr<const LaidFilm> marked(solver::PointMark mark, bool right) const {
        DippedFilm other = film;
        for (std::size_t point = 0; point < film.positions.size(); ++point) {
            const bool isRight = restPosition(film.grid, point).x() > 0;
            other.marks.push_back(isRight == right ? std::uint8_t(mark) : std::uint8_t(0));
        }
        return layFilm(body, other, ProcessSettings{});
    }
    // Returns `other` laid on the body with the contact of this dip.
    LaidFilm withFilm(const DippedFilm& other) const { return {body, other, laid->contact()}; }
};

// Returns a film image that is red on the left, green on the right and blue along the middle line.
QImage stripes(const solver::FilmGrid& grid) {
    QImage image(QSize(int(grid.width) * 4, int(grid.depth) * 4), QImage::Format_RGBA8888);
    image.fill(QColor(200, 30, 30));
    QPainter painter(&image);
    painter.fillRect(image.width() / 2, 0, image.width() / 2, image.height(), QColor(30, 150, 40));
    painter.fillRect(image.width() / 2 - 24, 0, 48, image.height(), QColor(20, 40, 200));
    return image;
}

vtkNew<vtkPolyData> readBack(const QByteArray& file) {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->ReadFromInputStringOn();
    reader->SetInputString(file.toStdString());
    reader->Update();
    vtkNew<vtkPolyData> data;
    data->ShallowCopy(reader->GetOutput());
    return data;
}

int countColours(const QImage& image) {
    QSet<QRgb> colours;
    for (int y = 0; y < image.height(); y += 2) {
        for (int x = 0; x < image.width(); x += 2) {
            colours.insert(image.pixel(x, y));
        }
    }
    return int(colours.size());
}

// Saves a picture if DIPWRIGHT_PICTURES names a folder.
void keep(const QImage& image, const QString& name) {
    const QString folder = qEnvironmentVariable("DIPWRIGHT_PICTURES");
    if (!folder.isEmpty()) {
        image.save(folder + '/' + name);
    }
}

} // namespace

class ResultsTest : public QObject {
    Q_OBJECT

    Dip dip_;

    QImage proof(const QImage& image, QSize tile = QSize(200, 200), bool compensated = false) {
        ProofOptions options;
        options.tile = tile;
        options.ink.compensate = compensated;
        return proofPicture(*proofStage(dip_.model, fineBody(dip_.model.mesh)),
                            {{dip_.laid, image}}, options, {});
    }

private slots:
    void filmVtp_holdsTheFilm();
    void bodyVtp_holdsTheBody();
    void filmAndBodyVtp_holdTheMarks();
    void filmVtp_twice_givesTheSameBytes();
    void mapColour_sequentialMaps_growEvenlyLighter_data();
    void mapColour_sequentialMaps_growEvenlyLighter();
    void mapColour_balance_isLightestInTheMiddle();
    void mapColour_unknownMap_isRefused();
    void stretchMap_showsStretchedFilm();
    void stretchMap_wideFilm_isWide();
    void numericalErrorMap_longTranslation_staysOnTheMap();
    void numericalErrorMap_inches_differsFromMillimetres();
    void wrinkling_compressionCounts_thinningDoesNot();
    void numericalErrorMap_unusedFilm_isGrey();
    void numericalErrorMap_outliers_keepTheColourScale();
    void numericalErrorMap_markedFilm_isHatched();
    void proofPicture_markedFilm_isHatched();
    void proofPicture_showsTheImageOnTheBody();
    void proofPicture_stretchedFilm_showsPalerInk();
    void proofPicture_overlappingFilms_addTheirInk();
    void proofPicture_colouredPart_showsInkOnPartColourAndOnWhite();
    void printedColours_shiftedFilm_matchClosedForm();
    void printedColours_shallowerDip_leavesTheUpperPartBare();
    void sharePicture_areasMatchClosedForm();
    void coveragePicture_showsSharesAndSeam();
    void printedColours_shiftedOverlap_matchClosedForm();
    void printedColours_bareBody_hasThePartsColour();
    void proofPicture_twice_givesTheSamePixels();
    void proofPicture_cancelled_throws();
    void cornerNormals_creases_staySharp();
};

void ResultsTest::filmVtp_holdsTheFilm() {
    const auto data = readBack(filmVtp(*dip_.laid, dip_.model));
    QCOMPARE(data->GetNumberOfPoints(), vtkIdType(81 * 113));
    QCOMPARE(data->GetNumberOfPolys(), vtkIdType(2 * 80 * 112));
    auto* rest = vtkFloatArray::SafeDownCast(data->GetPointData()->GetArray("rest"));
    auto* adhered = vtkUnsignedCharArray::SafeDownCast(data->GetPointData()->GetArray("adhered"));
    auto* uv = vtkFloatArray::SafeDownCast(data->GetPointData()->GetArray("uv"));
    auto* stretch = vtkFloatArray::SafeDownCast(data->GetPointData()->GetArray("stretch"));
    QVERIFY(rest && adhered && uv && stretch);
    QCOMPARE(rest->GetNumberOfComponents(), 3);
    QCOMPARE(uv->GetNumberOfComponents(), 2);
    QCOMPARE(rest->GetComponent(0, 0), -70.0);
    QCOMPARE(rest->GetComponent(0, 1), 0.0);
    QCOMPARE(rest->GetComponent(0, 2), -98.0);
    QVERIFY(std::isnan(uv->GetComponent(0, 0)));
    const vtkIdType middle = 56 * 81 + 40;
    QCOMPARE(int(adhered->GetValue(0)), 0);
    QCOMPARE(int(adhered->GetValue(middle)), 1);
    QVERIFY(std::abs(uv->GetComponent(middle, 0) - 0.5) < 1e-3);
    QVERIFY(std::abs(stretch->GetValue(middle) - 1) < 0.01);
    double lowest[3];
    data->GetPoint(middle, lowest);
    QVERIFY(std::abs(lowest[1]) < 1e-4); // the pose frame: the body's lowest point at y = 0
}

void ResultsTest::bodyVtp_holdsTheBody() {
    const auto data = readBack(bodyVtp(*dip_.body, dip_.model, dip_.covered));
    QCOMPARE(data->GetNumberOfPolys(), vtkIdType(dip_.model.mesh.triangles.size()));
    auto* texture = vtkFloatArray::SafeDownCast(data->GetPointData()->GetTCoords());
    auto* covered = data->GetCellData()->GetArray("covered");
    QVERIFY(texture && covered);
    QCOMPARE(QString(texture->GetName()), QString("TCoords"));
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); i += 97) {
        double point[3];
        data->GetPoint(i, point);
        QVERIFY(std::abs(texture->GetComponent(i, 0) - (point[0] / 70 + 0.5)) < 1e-4);
    }
    const double* range = covered->GetRange();
    QCOMPARE(range[0], 0.0);
    QCOMPARE(range[1], 1.0);
    double bounds[6];
    data->GetBounds(bounds);
    QVERIFY(std::abs(bounds[2]) < 1e-4 && std::abs(bounds[3] - 70) < 1e-3);
}

void ResultsTest::filmAndBodyVtp_holdTheMarks() {
    const auto laid = dip_.marked(solver::PointMark::LetGo, true);
    const auto film = readBack(filmVtp(*laid, dip_.model));
    auto* marks = film->GetPointData()->GetArray("marks");
    QVERIFY(marks);
    QCOMPARE(marks->GetComponent(0, 0), 0.0);
    QCOMPARE(marks->GetComponent(80, 0), 2.0);
    const auto body = readBack(bodyVtp(*dip_.body, dip_.model, coverage(*laid)));
    auto* onBody = body->GetCellData()->GetArray("marks");
    QVERIFY(onBody);
    QCOMPARE(onBody->GetRange()[0], 0.0);
    QCOMPARE(onBody->GetRange()[1], 2.0);
}

void ResultsTest::filmVtp_twice_givesTheSameBytes() {
    const QByteArray once = filmVtp(*dip_.laid, dip_.model);
    QVERIFY(!once.isEmpty());
    QCOMPARE(once, filmVtp(*dip_.laid, dip_.model));
}

namespace {
// Returns CIE L* by the standard's formulas, independent of the OKLab that the maps use.
double lightness(const QColor& colour) {
    const LinearColour light = linearColour(colour);
    const double y = 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];
    return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
}
} // namespace

void ResultsTest::mapColour_sequentialMaps_growEvenlyLighter_data() {
    QTest::addColumn<QString>("map");
    for (const char* map : {"lagoon", "dusk", "grey"}) {
        QTest::newRow(map) << QString(map);
    }
}

void ResultsTest::mapColour_sequentialMaps_growEvenlyLighter() {
    QFETCH(QString, map);
    const double whole = lightness(mapColour(map, 1)) - lightness(mapColour(map, 0));
    QVERIFY2(
        whole > 60,
        qPrintable(QStringLiteral("the map spans %1 of L*, expected more than 60").arg(whole)));
    for (int i = 0; i < 16; ++i) {
        const double step =
            lightness(mapColour(map, (i + 1) / 16.0)) - lightness(mapColour(map, i / 16.0));
        QVERIFY2(
            step > 0.5 * whole / 16 && step < 1.6 * whole / 16,
            qPrintable(
                QString("step %1 is %2 of L*, of %3 in 16 steps").arg(i).arg(step).arg(whole)));
    }
}

void ResultsTest::mapColour_balance_isLightestInTheMiddle() {
    for (int i = 0; i < 10; ++i) {
        const QColor low = mapColour("balance", i / 20.0);
        const QColor high = mapColour("balance", 1 - i / 20.0);
        QVERIFY(lightness(mapColour("balance", (i + 1) / 20.0)) > lightness(low));
        QVERIFY(low.blue() > low.red() && high.red() > high.blue());
        QVERIFY2(
            std::abs(lightness(low) - lightness(high)) < 8,
            qPrintable(QStringLiteral("opposite colours differ by %1 of L*, expected less than 8")
                           .arg(lightness(low) - lightness(high))));
    }
}

void ResultsTest::mapColour_unknownMap_isRefused() {
    QVERIFY_EXCEPTION_THROWN(mapColour("rainbow", 0.5), Error);
}

void ResultsTest::stretchMap_showsStretchedFilm() {
    const QImage map = stretchMap(*dip_.laid, 1000);
    keep(map, "stretch.png");
    QVERIFY(std::abs(map.height() - 1000) <= 1);
    QVERIFY(map.width() > 600 && map.width() < 1100);
    QVERIFY(countColours(map) > 100);
    QCOMPARE(map, stretchMap(*dip_.laid, 1000));
    // Stretched film has more colours than the same film without stretch.
    DippedFilm flat = dip_.film;
    for (std::size_t i = 0; i < flat.positions.size(); ++i) {
        const Eigen::Vector2f rest = restPosition(flat.grid, i);
        flat.positions[i] = {rest.x(), 0, rest.y()};
    }
    QVERIFY(countColours(stretchMap(dip_.withFilm(flat), 1000)) < countColours(map));
}

namespace {
// A translation that makes the legend's text twice as long.
class LongWords : public QTranslator {
public:
    LongWords() { QCoreApplication::installTranslator(this); }
    bool isEmpty() const override { return false; }
    QString translate(const char*, const char* text, const char*, int) const override {
        return QString::fromUtf8(text).contains(QLatin1String("Limit: "))
                   ? QString::fromUtf8(text) + QLatin1Char(' ') + QString::fromUtf8(text)
                   : QString();
    }
};
} // namespace

void ResultsTest::numericalErrorMap_longTranslation_staysOnTheMap() {
    const std::vector<float> changes(dip_.film.positions.size(), 0.1f);
    const QImage known = numericalErrorMap(*dip_.laid, changes, 0.3, 1000);
    const LongWords german;
    const QImage map = numericalErrorMap(*dip_.laid, changes, 0.3, 1000);
    QVERIFY(map != known);
    for (int y = 0; y < map.height(); ++y) {
        QCOMPARE(map.pixel(map.width() - 1, y), map.pixel(0, 0));
    }
}

void ResultsTest::numericalErrorMap_inches_differsFromMillimetres() {
    std::vector<float> changes(dip_.film.positions.size());
    for (std::size_t point = 0; point < changes.size(); ++point) {
        changes[point] = 0.5f * float(point) / float(changes.size());
    }
    const QImage millimetres = numericalErrorMap(*dip_.laid, changes, 0.3, 1000);
    const QImage inches = numericalErrorMap(*dip_.laid, changes, 0.3, 1000, LengthUnit::Inch);
    keep(inches, "certainty-inches.png");
    QCOMPARE(inches.size(), millimetres.size());
    QVERIFY(inches != millimetres);
}

void ResultsTest::numericalErrorMap_unusedFilm_isGrey() {
    // Where nothing is compared, the error is not a number.
    std::vector<float> changes(dip_.film.positions.size(), 0.1f);
    const QImage known = numericalErrorMap(*dip_.laid, changes, 0.3, 1000);
    std::fill_n(changes.begin(), changes.size() / 10, std::numeric_limits<float>::quiet_NaN());
    const QImage partly = numericalErrorMap(*dip_.laid, changes, 0.3, 1000);
    keep(partly, "certainty-unused.png");
    for (const QImage& map : {known, partly}) {
        const QColor corner = map.pixelColor(90 + 10, 120 + 10);
        QVERIFY(corner.red() == corner.green() && corner.green() == corner.blue());
        QCOMPARE(corner, known.pixelColor(90 + 10, 120 + 10));
        QVERIFY(corner != map.pixelColor(0, 0));
    }
}

void ResultsTest::stretchMap_wideFilm_isWide() {
    const auto wide = layFilm(dip_.body, dippedFilm({113, 57, 196, 98}), ProcessSettings{});
    const QImage map = stretchMap(*wide, 800);
    keep(map, "stretch-wide.png");
    QVERIFY(map.width() > map.height());
}

void ResultsTest::wrinkling_compressionCounts_thinningDoesNot() {
    // The film is stretched to 1.5 in one direction. In the other direction its stretch is first 1,
    // then 0.9.
    const auto drawn = [&](float across) {
        DippedFilm film = dip_.film;
        for (std::size_t i = 0; i < film.positions.size(); ++i) {
            const Eigen::Vector2f rest = restPosition(film.grid, i);
            film.positions[i] = {1.5f * rest.x(), 0, across * rest.y()};
        }
        return film;
    };
    const Wrinkling thinned = dip_.withFilm(drawn(1)).painted().wrinkling;
    QCOMPARE(thinned.share, 0.0);
    QVERIFY(std::abs(thinned.least - 1) < 1e-4);
    const LaidFilm compressed = dip_.withFilm(drawn(0.9f));
    const Wrinkling& wrinkled = compressed.painted().wrinkling;
    QCOMPARE(wrinkled.share, 1.0);
    QVERIFY(wrinkled.area > 0);
    QVERIFY(std::abs(wrinkled.least - 0.9) < 1e-4);
    const QImage map = wrinklingMap(*dip_.laid, 1000);
    keep(map, "wrinkling.png");
    QCOMPARE(map.size(), stretchMap(*dip_.laid, 1000).size());
    QVERIFY(map != wrinklingMap(compressed, 1000));
}

namespace {
// Returns the number of pixels in exactly this colour to the left and to the right of the column.
std::pair<int, int> countBeside(const QImage& image, const QColor& colour, int column,
                                const QRect& part) {
    std::pair<int, int> count{0, 0};
    for (int y = part.top(); y <= part.bottom(); ++y) {
        for (int x = part.left(); x <= part.right(); ++x) {
            if (image.pixelColor(x, y) == colour) {
                ++(x < column ? count.first : count.second);
            }
        }
    }
    return count;
}
} // namespace

void ResultsTest::numericalErrorMap_outliers_keepTheColourScale() {
    // The error is 0.1 mm left of the middle, 0.5 mm right of it, and 150 mm in some places.
    std::vector<float> changes;
    for (std::size_t point = 0; point < dip_.film.positions.size(); ++point) {
        changes.push_back(restPosition(dip_.film.grid, point).x() < 0 ? 0.1f : 0.5f);
    }
    const QImage near = numericalErrorMap(*dip_.laid, changes, 0.3, 1000);
    const std::size_t middle = 56 * 81 + 40;
    const int columns = dip_.film.grid.columns;
    for (int row = -15; row <= 15; ++row) {
        std::fill_n(changes.begin() + std::ptrdiff_t(middle) + row * columns - 5, 11, 150.f);
    }
    const QImage far = numericalErrorMap(*dip_.laid, changes, 0.3, 1000);
    keep(far, "certainty-far.png");
    QCOMPARE(far.size(), near.size());
    const int width = int(780 * 140 / 196.0);
    const auto at = [&](const QImage& map, double share) {
        return map.pixelColor(90 + int(share * width), 120 + 390);
    };
    // Both sides must still be distinguishable. Errors above the scale must have a colour outside
    // the map.
    QVERIFY(lightness(at(far, 0.6)) > lightness(at(far, 0.4)) + 15);
    QVERIFY(at(far, 0.5).red() > at(far, 0.5).blue() + 100);
    QVERIFY(lightness(at(near, 0.6)) > lightness(at(near, 0.4)) + 15);
}

void ResultsTest::numericalErrorMap_markedFilm_isHatched() {
    const std::vector<float> changes(dip_.film.positions.size(), 0.01f);
    const QImage plain = numericalErrorMap(*dip_.laid, changes, 0.3, 1000);
    for (const solver::PointMark mark : filmMarks) {
        const auto marked = dip_.marked(mark, true);
        const QImage map = numericalErrorMap(*marked, changes, 0.3, 1000);
        keep(map, QStringLiteral("marked-%1.png").arg(int(mark)));
        QVERIFY(map.height() > plain.height()); // because the hatch has a line in the legend
        // Where the film lies in the picture. FilmMap gives its lengths in per cent of the height.
        const QRect film(90, 120, int(780 * 140 / 196.0), 780);
        const auto [left, right] = countBeside(map, markColour(mark), film.center().x(), film);
        QVERIFY2(left < 100 && right > 5000,
                 qPrintable(QStringLiteral(
                                "%1 hatched pixels left and %2 right, expected < 100 and > 5000")
                                .arg(left)
                                .arg(right)));
        QCOMPARE(countBeside(plain, markColour(mark), 0, plain.rect()).second, 0);
    }
}

void ResultsTest::proofPicture_markedFilm_isHatched() {
    QImage image(400, 560, QImage::Format_RGBA8888);
    image.fill(QColor(90, 90, 90));
    ProofOptions options;
    options.tile = QSize(200, 200);
    const auto of = [&](const std::shared_ptr<const LaidFilm>& laid) {
        return proofPicture(*proofStage(dip_.model, fineBody(dip_.model.mesh)), {{laid, image}},
                            options, {});
    };
    const QImage plain = of(dip_.laid);
    const solver::PointMark mark = solver::PointMark::Torn;
    const QImage proof = of(dip_.marked(mark, true));
    keep(proof, "marked-proof.png");
    // The marked film is on the right of the front view and on the left of the back view.
    const auto front = countBeside(proof, markColour(mark), 100, QRect(0, 0, 200, 200));
    const auto back = countBeside(proof, markColour(mark), 100, QRect(0, 200, 200, 180));
    QVERIFY(front.first < 20 && front.second > 300);
    QVERIFY(back.second < 20 && back.first > 300);
    QCOMPARE(countBeside(plain, markColour(mark), 0, plain.rect()).second, 0);
    // Marked film that does not paint does not change the picture.
    DippedFilm beside = dip_.film;
    for (std::size_t point = 0; point < beside.positions.size(); ++point) {
        beside.marks.push_back(beside.adhered(point) ? 0 : std::uint8_t(mark));
    }
    QCOMPARE(of(layFilm(dip_.body, beside, ProcessSettings{})), plain);
}

void ResultsTest::proofPicture_showsTheImageOnTheBody() {
    const bool large = qEnvironmentVariableIsSet("DIPWRIGHT_PICTURES");
    const QSize tile = large ? QSize(800, 800) : QSize(200, 200);
    const QImage image = proof(stripes(dip_.film.grid), tile);
    keep(image, "proof.png");
    QCOMPARE(image.size(), QSize(3 * tile.width(), 2 * tile.height()));
    // The ball is painted below its middle and bare above. The film's left is on the left from the
    // front and on the right from the back.
    const auto pixel = [&](int view, double right, double down) {
        return image.pixelColor(int(tile.width() * (view % 3 + right)),
                                int(tile.height() * (view / 3 + down)));
    };
    const auto isRed = [](const QColor& c) {
        return c.red() > c.green() + 40 && c.red() > c.blue() + 40;
    };
    const auto isGreen = [](const QColor& c) {
        return c.green() > c.red() + 30 && c.green() > c.blue() + 30;
    };
    const auto isBlue = [](const QColor& c) {
        return c.blue() > c.red() + 40 && c.blue() > c.green() + 40;
    };
    QVERIFY(isRed(pixel(0, 0.3, 0.72)));
    QVERIFY(isGreen(pixel(0, 0.7, 0.72)));
    QVERIFY(isBlue(pixel(0, 0.5, 0.8)));
    QVERIFY(isGreen(pixel(1, 0.5, 0.8)));
    QVERIFY(isGreen(pixel(3, 0.3, 0.72)));
    QVERIFY(isRed(pixel(3, 0.7, 0.72)));
    QVERIFY(isRed(pixel(4, 0.5, 0.8)));
    // From below, the film's left is also on the left.
    QVERIFY(isRed(pixel(5, 0.3, 0.5)));
    QVERIFY(isGreen(pixel(5, 0.7, 0.5)));
    QVERIFY(isBlue(pixel(5, 0.5, 0.5)));
    for (const QColor& bare : {pixel(0, 0.5, 0.3), pixel(2, 0.5, 0.5)}) {
        QVERIFY(std::abs(bare.red() - bare.blue()) < 12 && bare.red() > 120);
    }
}

void ResultsTest::proofPicture_stretchedFilm_showsPalerInk() {
    // Film stretched to J = 4 shows a quarter of the printed density.
    DippedFilm stretched = dip_.film;
    stretched.grid.width /= 2;
    stretched.grid.depth /= 2;
    QImage image(400, 560, QImage::Format_RGBA8888);
    image.fill(QColor(90, 90, 90));
    ProcessSettings process;
    process.tearStretch = 10;
    const FilmAppearance appearance{layFilm(dip_.body, stretched, process), image};
    ProofOptions options;
    options.tile = QSize(60, 60);
    options.ink.compensate = false;
    const QImage printed =
        proofPicture(*proofStage(dip_.model, fineBody(dip_.model.mesh)), {appearance}, options, {});
    options.ink.compensate = true;
    const QImage shown =
        proofPicture(*proofStage(dip_.model, fineBody(dip_.model.mesh)), {appearance}, options, {});
    QVERIFY(shown.pixelColor(30, 45).red() > printed.pixelColor(30, 45).red() + 30);
}

void ResultsTest::proofPicture_overlappingFilms_addTheirInk() {
    QImage red(400, 560, QImage::Format_RGBA8888);
    red.fill(Qt::red);
    QImage holed = red; // green with a hole on the left
    holed.fill(Qt::green);
    QPainter painter(&holed);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    painter.fillRect(0, 0, 200, 560, Qt::transparent);
    painter.end();
    ProofOptions options;
    options.tile = QSize(100, 100);
    options.ink.compensate = false;
    const QImage image = proofPicture(*proofStage(dip_.model, fineBody(dip_.model.mesh)),
                                      {{dip_.laid, red}, {dip_.laid, holed}}, options, {});
    const QColor left = image.pixelColor(30, 75);
    const QColor right = image.pixelColor(70, 75);
    QVERIFY(left.red() > left.green() + 40);
    QVERIFY(right.red() < left.red() - 40); // the green ink absorbs red
    QVERIFY(right.green() < 60);            // the red ink absorbs green
}

// Red ink on a blue part is nearly black, except on the right, where white lies under it.
void ResultsTest::proofPicture_colouredPart_showsInkOnPartColourAndOnWhite() {
    QImage red(400, 560, QImage::Format_RGBA8888);
    red.fill(Qt::red);
    QImage white(red.size(), QImage::Format_Grayscale8);
    white.fill(0);
    for (int y = 0; y < white.height(); ++y) {
        std::fill_n(white.scanLine(y) + 200, 200, uchar(255));
    }
    ProofOptions options;
    options.tile = QSize(100, 100);
    options.ink.compensate = false;
    const auto of = [&](const QImage& plate) {
        FilmAppearance appearance{dip_.laid, red};
        appearance.white = plate;
        return proofPicture(*proofStage(dip_.model, fineBody(dip_.model.mesh)), {appearance},
                            options, {});
    };
    const QImage usual = of({});
    QCOMPARE(of(white), usual); // without a part colour, ink is shown on white anyway
    options.ground.base = QColor(20, 30, 200);
    const QImage bare = of({});
    const QImage backed = of(white);
    keep(backed, "white-proof.png");
    QVERIFY(bare.pixelColor(70, 75).red() < 60);
    QCOMPARE(backed.pixelColor(30, 75), bare.pixelColor(30, 75));
    QCOMPARE(backed.pixelColor(70, 75), usual.pixelColor(70, 75));
    options.ground.whiteOutside = true; // white outside the ink hides it
    const QColor veil = of(white).pixelColor(70, 75);
    QVERIFY(veil.red() > 150 && std::abs(veil.red() - veil.green()) < 8);
}

void ResultsTest::printedColours_shiftedFilm_matchClosedForm() {
    QImage halves(1400, 1960, QImage::Format_RGBA8888);
    halves.fill(Qt::red);
    QPainter painter(&halves);
    painter.fillRect(700, 0, 700, 1960, Qt::green);
    painter.end();
    const RefinedMesh fine(dip_.model.mesh, 0.5f);
    FilmPlacementError slip;
    slip.shift = {Millimetres(3), Millimetres(-2)};
    slip.turn = Degrees(10);
    slip.swell = 1.05;
    const std::vector<QRgb> colours =
        printedColours(fine, {{dip_.laid, halves, slip}}, {.compensate = false});
    // The closed form gives where the film of a place lay before the dip, and so which half of the
    // picture it showed.
    const double turn = radians(slip.turn);
    std::size_t tried = 0;
    for (std::size_t triangle = 0; triangle < colours.size(); ++triangle) {
        const Eigen::Vector3d place =
            position(dip_.model.mesh, fine.middle(triangle)).cast<double>();
        const double across = std::hypot(place.x(), place.z());
        const double theta = std::atan2(across, -place.y());
        if (theta > 1.4 || across < 1) {
            continue;
        }
        const double flat = 2 * radius * std::sin(theta / 2);
        const double x = flat * place.x() / across - 3;
        const double z = flat * place.z() / across + 2;
        const double printed = (std::cos(turn) * x + std::sin(turn) * z) / 1.05;
        if (std::abs(printed) > 0.3) {
            QCOMPARE(qRed(colours[triangle]) > 128, printed < 0);
            ++tried;
        }
    }
    QVERIFY(tried > 5000);
}

void ResultsTest::printedColours_shallowerDip_leavesTheUpperPartBare() {
    QImage red(140, 196, QImage::Format_RGBA8888);
    red.fill(Qt::red);
    const RefinedMesh fine(dip_.model.mesh, 1);
    FilmPlacementError slip;
    slip.deeper = Millimetres(-12);
    const double depth = 32;
    const std::vector<QRgb> colours =
        printedColours(fine, {{dip_.laid, red, slip, depth}}, {.compensate = false});
    const double lowest = double(boundingBox(dip_.model.mesh).min().y());
    std::size_t wet = 0, dry = 0;
    for (std::size_t triangle = 0; triangle < colours.size(); ++triangle) {
        const Eigen::Vector3f place = position(dip_.model.mesh, fine.middle(triangle));
        const double height = double(place.y()) - lowest;
        if (std::abs(height - 20) > 0.01) {
            QCOMPARE(qRed(colours[triangle]) > qGreen(colours[triangle]) + 100, height < 20);
            ++(height < 20 ? wet : dry);
        }
    }
    QVERIFY(wet > 1000 && dry > 1000);
}

namespace {

// A ball that is dipped from opposite sides through two films.
struct OppositeDips {
    TexturedMesh model = test::plainModel(sphereMesh(radius, 60, 120), QColor(120, 120, 120));
    std::array<std::shared_ptr<const LaidFilm>, 2> films{
        test::laidOnTurnedSphere(model.mesh, radius, 2, 0),
        test::laidOnTurnedSphere(model.mesh, radius, 2, 180)};
    BodyShare share = shareBody(*shareStage(model, fineBody(model.mesh)), films, {}, {}, {});
};

std::size_t countOf(const QImage& picture, const QColor& colour, const QRect& part) {
    std::size_t count = 0;
    for (int y = part.top(); y <= part.bottom(); ++y) {
        for (int x = part.left(); x <= part.right(); ++x) {
            count += picture.pixel(x, y) == colour.rgb() ? 1 : 0;
        }
    }
    return count;
}

} // namespace

void ResultsTest::sharePicture_areasMatchClosedForm() {
    const OppositeDips dips;
    const QSize pixels(840, 1188); // 4 per mm
    const QImage picture = sharePicture(*dips.films[0], dips.share, 0, pixels);
    // Film that lay within 2ρ·sin(θ/2) of the film's centre now lies within the angle θ of the
    // ball's lowest point. Dip 1 alone paints up to the overlap, which begins half its width before
    // the equator.
    const double alone = pi / 2 - dips.share.overlap.middle / 2 / radius;
    const double disc = pi * std::pow(2 * radius * std::sin(alone / 2), 2) * 16;
    const auto painted = double(countOf(picture, painterColour(Painter::First), picture.rect()));
    QVERIFY2(std::abs(painted - disc) < 0.03 * disc,
             qPrintable(QStringLiteral("%1 pixels, expected %2").arg(painted).arg(disc)));
    QCOMPARE(picture.pixelColor(420, 594), painterColour(Painter::First));
    QVERIFY(countOf(picture, painterColour(Painter::Both), picture.rect()) > 500);
    QVERIFY(countOf(picture, painterColour(Painter::Second), picture.rect()) > 500);
    QVERIFY(picture.pixelColor(5, 5) != painterColour(Painter::First));
}

void ResultsTest::coveragePicture_showsSharesAndSeam() {
    const OppositeDips dips;
    const int tile = 320;
    const QImage picture = coveragePicture(
        *proofStage(dips.model, fineBody(dips.model.mesh)), dips.share,
        {{dips.films[0], QStringLiteral("Below")}, {dips.films[1], QStringLiteral("Above")}}, tile,
        {});
    const auto hue = [&](int column, int row) {
        return picture.pixelColor(column * tile + tile / 2, row * tile + tile / 2).hslHue();
    };
    // The third views are from above and from below.
    QVERIFY(std::abs(hue(2, 0) - painterColour(Painter::Second).hslHue()) < 8);
    QVERIFY(std::abs(hue(2, 1) - painterColour(Painter::First).hslHue()) < 8);
    // From the front the seam runs across the middle.
    const QColor join = shareLines(dips.share, {QString(), QString()}).back().colour;
    int found = 0;
    for (int y = tile / 2 - 4; y <= tile / 2 + 4; ++y) {
        found += std::abs(picture.pixelColor(tile / 2, y).hslHue() - join.hslHue()) < 8 ? 1 : 0;
    }
    QVERIFY2(found > 0,
             qPrintable(QStringLiteral("%1 pixels of the seam, expected 1 or more").arg(found)));
    Progress cancelled;
    cancelled.cancelToken.cancel();
    QVERIFY_EXCEPTION_THROWN(coveragePicture(*proofStage(dips.model, fineBody(dips.model.mesh)),
                                             dips.share, {{dips.films[0], {}}, {dips.films[1], {}}},
                                             tile, cancelled),
                             Cancelled);
}

void ResultsTest::printedColours_shiftedOverlap_matchClosedForm() {
    // Two films fade into each other over b = 10 mm. The second film is shifted by e, so ink is
    // missing in the overlap: a grey of reflectance R shows R^(1 − e/b).
    const double shift = 2, band = 10, grey = 0.3;
    const auto fading = [&](bool toTheRight) {
        QImage image(1400, 1960, QImage::Format_RGBA8888);
        for (int column = 0; column < image.width(); ++column) {
            const double x = (column + 0.5) / 10 - 70;
            const double share = std::clamp(0.5 + (toTheRight ? x : -x) / band, 0.0, 1.0);
            const int value = encodedByte(float(std::pow(grey, share)));
            QPainter(&image).fillRect(column, 0, 1, image.height(), QColor(value, value, value));
        }
        return image;
    };
    const RefinedMesh fine(dip_.model.mesh, 1);
    FilmPlacementError slip;
    slip.shift[0] = Millimetres(shift);
    const std::vector<QRgb> colours = printedColours(
        fine, {{dip_.laid, fading(false)}, {dip_.laid, fading(true), slip}}, {.compensate = false});
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t triangle = 0; triangle < colours.size(); ++triangle) {
        const Eigen::Vector3f place = position(dip_.model.mesh, fine.middle(triangle));
        if (place.y() < -34 && std::abs(place.x()) < 2) {
            sum += linearFromSrgb(qRed(colours[triangle]) / 255.0);
            ++count;
        }
    }
    QVERIFY(count > 20);
    const double wanted = std::pow(grey, 1 - shift / band);
    QVERIFY2(
        std::abs(sum / double(count) - wanted) < 0.01 * wanted,
        qPrintable(
            QStringLiteral("reflectance %1, expected %2").arg(sum / double(count)).arg(wanted)));
}

// Where no film paints, the part shows its own colour, as in the proof.
void ResultsTest::printedColours_bareBody_hasThePartsColour() {
    const RefinedMesh fine(dip_.model.mesh, 2);
    QImage picture(140, 196, QImage::Format_RGBA8888);
    picture.fill(Qt::transparent);
    const QColor own(40, 90, 160);
    const auto colours =
        printedColours(fine, {{dip_.laid, picture}}, {.compensate = false}, Ground{.base = own});
    for (const QRgb colour : colours) {
        QVERIFY(std::abs(qRed(colour) - own.red()) <= 1 &&
                std::abs(qGreen(colour) - own.green()) <= 1 &&
                std::abs(qBlue(colour) - own.blue()) <= 1);
    }
}

void ResultsTest::proofPicture_twice_givesTheSamePixels() {
    const QImage image = stripes(dip_.film.grid);
    QCOMPARE(proof(image), proof(image));
}

void ResultsTest::proofPicture_cancelled_throws() {
    Progress progress;
    progress.report = [&](double share, const QString&) {
        if (share > 0.3) {
            progress.cancelToken.cancel();
        }
    };
    ProofOptions options;
    options.tile = QSize(60, 60);
    const FilmAppearance appearance{dip_.laid, stripes(dip_.film.grid)};
    QVERIFY_EXCEPTION_THROWN(proofPicture(*proofStage(dip_.model, fineBody(dip_.model.mesh)),
                                          {appearance}, options, progress),
                             Cancelled);
}

void ResultsTest::cornerNormals_creases_staySharp() {
    const TriangleMesh box = boxMesh({10, 20, 30});
    const auto normals = cornerNormals(box);
    for (std::size_t i = 0; i < box.triangles.size(); ++i) {
        for (const Eigen::Vector3f& normal : normals[i]) {
            QVERIFY((normal - triangleNormal(box, i)).norm() < 1e-5f);
        }
    }
    const auto smooth = cornerNormals(dip_.model.mesh);
    const Eigen::Vector3f& corner = dip_.model.mesh.positions[dip_.model.mesh.triangles[500][1]];
    QVERIFY((smooth[500][1] - corner.normalized()).norm() < 0.02f);
}

QTEST_MAIN(ResultsTest)
#include "ResultsTest.moc"
