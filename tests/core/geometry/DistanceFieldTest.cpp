// The signed distance field, compared with closed forms, and its cache.
#include "geometry/DistanceField.h"
#include "base/Error.h"
#include "base/Units.h"
#include "geometry/FinerFields.h"
#include "geometry/Shapes.h"
#include "parallel/ParallelFor.h"
#include "parallel/Threads.h"

#include <QtTest>

#include <cmath>
#include <functional>
#include <random>
#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

using namespace dipwright;

namespace {

using Distance = std::function<double(const Eigen::Vector3d&)>;

double sphereDistance(const Eigen::Vector3d& place) {
    return place.norm() - 35;
}

Distance boxDistance(const Eigen::Vector3d& size) {
    return [size](const Eigen::Vector3d& place) {
        const Eigen::Vector3d beyond = place.cwiseAbs() - size / 2;
        return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0);
    };
}

Eigen::Vector3d samplePlace(const DistanceField& field, int i, int j, int k) {
    return field.origin + field.spacing * Eigen::Vector3d(i, j, k);
}

struct FieldErrors {
    double nearSurface = 0; // largest error within three cells of the surface, mm
    double tooLarge = 0;    // largest excess of |φ| over the distance, mm
    int wrongSigns = 0;
};

// Compares all samples. `tolerance` is the largest distance between the mesh and the exact shape,
// mm.
FieldErrors compare(const DistanceField& field, const Distance& exact, double tolerance) {
    FieldErrors errors;
    std::size_t index = 0;
    for (int k = 0; k < field.size[2]; ++k) {
        for (int j = 0; j < field.size[1]; ++j) {
            for (int i = 0; i < field.size[0]; ++i, ++index) {
                const double expected = exact(samplePlace(field, i, j, k));
                const double found = field.distance[index];
                if (std::abs(expected) < 3 * field.spacing) {
                    errors.nearSurface = std::max(errors.nearSurface, std::abs(found - expected));
                }
                errors.tooLarge = std::max(errors.tooLarge, std::abs(found) - std::abs(expected));
                errors.wrongSigns += std::abs(expected) > tolerance && found * expected <= 0;
            }
        }
    }
    return errors;
}

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
    TriangleMesh both = a;
    const auto first = std::uint32_t(a.positions.size());
    both.positions.insert(both.positions.end(), b.positions.begin(), b.positions.end());
    for (const auto& triangle : b.triangles) {
        both.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
    }
    return both;
}

std::vector<Eigen::Vector3d> randomDirections(int count) {
    std::mt19937 random(3);
    std::normal_distribution<double> coordinate;
    std::vector<Eigen::Vector3d> directions;
    for (int i = 0; i < count; ++i) {
        const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
        directions.push_back(Eigen::Vector3d(x, y, z).normalized());
    }
    return directions;
}

} // namespace

class DistanceFieldTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();

    void buildDistanceField_grid_isACubeAroundTheBody();
    void buildDistanceField_box_isExact();
    void bodyOrigin_nearModel_isTheModelsOrigin();
    void cachedDistanceField_farModel_isThatOfTheModelAtTheOrigin();
    void buildDistanceField_facesOnSamples_isExact();
    void buildDistanceField_sphere_isAsExactAsItsMesh();
    void sampleAndGradient_sphere_matchClosedForm();
    void sample_outsideTheGrid_neverExceedsTheDistance();
    void buildDistanceField_overlappingParts_areOneBody();
    void buildDistanceField_hollow_isOutside();
    void buildDistanceField_openBody_isClosedByMajority();
    void buildDistanceField_flippedTriangles_keepTheSign();
    void buildDistanceField_anyNumberOfThreads_givesTheSameBits();
    void buildDistanceField_cancelled_throws();
    void buildDistanceField_progress_growsTo1();
    void buildDistanceField_invalidInput_isRefused();

    void thinParts_platesCount_taperedEdgesDoNot();
    void missedParts_finsCount_edgesDoNot();
    void cachedDistanceField_usualBodies_keepTheCube();
    void cachedDistanceField_thinPlate_isResolvedInAnyDirection_data();
    void cachedDistanceField_thinPlate_isResolvedInAnyDirection();
    void fieldGrid_veryThinPlate_keepsTheSampleLimit();
    void fieldLevel_smallerFilmCells_haveSmallerFieldCells();
    void fieldAtLevel_eachLevel_halvesTheErrorAtEdges();
    void fieldAtLevel_manyThreads_buildOneField();
    void fieldAtLevel_cancelled_canBeBuiltLater();

    void fieldCache_secondRequest_readsTheSameField();
    void fieldCache_finerFields_areReadToo();
    void fieldCache_damagedFile_isRebuilt();
    void fieldCache_unwritable_buildsTheField();
    void fieldCache_pipe_doesNotBlock();
    void fieldCache_full_removesLeastRecentlyUsed();

private:
    QTemporaryDir cache_;
};

void DistanceFieldTest::init() {
    qputenv("DIPWRIGHT_CACHE", cache_.path().toUtf8());
}

void DistanceFieldTest::buildDistanceField_grid_isACubeAroundTheBody() {
    const DistanceField field = buildDistanceField(boxMesh({10, 20, 30}), 64, Progress());
    QCOMPARE(field.size, (std::array{64, 64, 64}));
    QCOMPARE(field.distance.size(), std::size_t(64 * 64 * 64));
    const Eigen::Vector3d last = samplePlace(field, 63, 63, 63);
    const Eigen::Vector3d padding = Eigen::Vector3d::Constant(2 * field.spacing - 1e-9);
    QVERIFY((field.origin.array() <= (Eigen::Vector3d(-5, -10, -15) - padding).array()).all());
    QVERIFY((last.array() >= (Eigen::Vector3d(5, 10, 15) + padding).array()).all());
    QVERIFY((field.origin + last).norm() < 1e-9);
}

void DistanceFieldTest::bodyOrigin_nearModel_isTheModelsOrigin() {
    const auto boxAt = [](double x) {
        return transformed(boxMesh({10, 20, 30}), Eigen::Isometry3d(Eigen::Translation3d(x, 3, 4)));
    };
    const TriangleMesh near = boxAt(-farFromOrigin * 30), far = boxAt(-farFromOrigin * 30 - 1);
    QVERIFY(bodyOrigin(near).isZero(0));
    QVERIFY(inBodyCoordinates(near).positions == near.positions);
    QVERIFY((bodyOrigin(far) - Eigen::Vector3d(-farFromOrigin * 30 - 1, 3, 4)).norm() < 1e-9);
    QVERIFY(bodyOrigin(inBodyCoordinates(far)).isZero(0));
    QVERIFY(bodyOrigin(TriangleMesh()).isZero(0));
}

// Rays and closest points would be too inexact far away, so that the plate would be missed.
void DistanceFieldTest::cachedDistanceField_farModel_isThatOfTheModelAtTheOrigin() {
    const TriangleMesh plate = boxMesh({30, 20, 0.5});
    const Eigen::Isometry3d shift(Eigen::Translation3d(100'000, -2'000, 30'000));
    const auto near = cachedDistanceField(plate, 48, {});
    const auto far = cachedDistanceField(transformed(plate, shift), 48, {});
    QCOMPARE(far->size, near->size);
    QVERIFY(far->spacing < 0.3);
    QVERIFY((far->origin - near->origin).norm() < 1e-9);
    QVERIFY(far->distance == near->distance);
    QCOMPARE(far->finer->count(), near->finer->count());
}

void DistanceFieldTest::buildDistanceField_box_isExact() {
    const Eigen::Vector3d size(10, 20, 30);
    const DistanceField field = buildDistanceField(boxMesh(size), 101, Progress());
    const FieldErrors errors = compare(field, boxDistance(size), 1e-5);
    QVERIFY2(
        errors.nearSurface < 1e-5,
        qPrintable(QStringLiteral("largest error near the surface %1 mm, expected < 0.00001 mm")
                       .arg(errors.nearSurface)));
    QVERIFY2(errors.tooLarge < 1e-5,
             qPrintable(QStringLiteral("|φ| exceeds the distance by %1 mm, expected < 0.00001 mm")
                            .arg(errors.tooLarge)));
    QCOMPARE(errors.wrongSigns, 0);
}

void DistanceFieldTest::buildDistanceField_facesOnSamples_isExact() {
    // 60 cells along 60 mm: rows of samples lie in faces, along edges and at corners.
    const Eigen::Vector3d size(60, 60, 60);
    const DistanceField field = buildDistanceField(boxMesh(size), 67, Progress());
    QCOMPARE(field.spacing, 1.0);
    const FieldErrors errors = compare(field, boxDistance(size), 1e-5);
    QVERIFY(errors.nearSurface < 1e-5);
    QVERIFY(errors.tooLarge < 1e-5);
    QCOMPARE(errors.wrongSigns, 0);
}

void DistanceFieldTest::buildDistanceField_sphere_isAsExactAsItsMesh() {
    const DistanceField field = buildDistanceField(sphereMesh(35, 158, 316), 128, Progress());
    const double sagitta = 35 * (1 - std::cos(pi / 316) * std::cos(pi / 316)) + 1e-4;
    const FieldErrors errors = compare(field, sphereDistance, sagitta);
    QVERIFY2(errors.nearSurface < sagitta,
             qPrintable(QStringLiteral("largest error near the surface %1 mm, expected < %2 mm")
                            .arg(errors.nearSurface)
                            .arg(sagitta)));
    QVERIFY2(errors.tooLarge < sagitta,
             qPrintable(QStringLiteral("|φ| exceeds the distance by %1 mm, expected < %2 mm")
                            .arg(errors.tooLarge)
                            .arg(sagitta)));
    QCOMPARE(errors.wrongSigns, 0);
}

void DistanceFieldTest::sampleAndGradient_sphere_matchClosedForm() {
    const DistanceField field = buildDistanceField(sphereMesh(35, 180, 360), 96, Progress());
    // The error of interpolating a curved distance is its second difference over a cell.
    const double curvature = field.spacing * field.spacing / (4 * 35) + 0.01;
    for (const auto& direction : randomDirections(2000)) {
        for (const double away : {-1.0, -0.3, 0.0, 0.2, 0.9}) {
            const Eigen::Vector3d place = direction * (35 + away);
            QVERIFY(std::abs(field.sample(place) - away) < curvature);
            const Eigen::Vector3d gradient = field.gradient(place);
            QVERIFY(std::abs(gradient.norm() - 1) < 0.01);
            QVERIFY(gradient.normalized().dot(direction) > std::cos(radians(Degrees(1))));
        }
    }
}

void DistanceFieldTest::sample_outsideTheGrid_neverExceedsTheDistance() {
    const DistanceField field = buildDistanceField(sphereMesh(35, 60, 120), 64, Progress());
    for (const auto& direction : randomDirections(2000)) {
        for (const double away : {5.0, 20.0, 100.0, 1e4}) {
            const double found = field.sample(direction * (35 + away));
            QVERIFY(found > 0);
            QVERIFY(found < away + 0.1);
        }
        QVERIFY(field.sample(direction * 1000.0) > 900);
    }
}

void DistanceFieldTest::buildDistanceField_overlappingParts_areOneBody() {
    const TriangleMesh body = joined(boxMesh({40, 10, 10}), boxMesh({10, 10, 40}));
    const DistanceField field = buildDistanceField(body, 64, Progress());
    QVERIFY(field.sample({0, 0, 0}) < -2);
    QVERIFY(field.sample({15, 0, 0}) < -2);
    QVERIFY(field.sample({4, 0, 4}) < 0);
    QVERIFY(field.sample({0, 0, 15}) < -2);
    QVERIFY(field.sample({15, 0, 15}) > 2);
}

void DistanceFieldTest::buildDistanceField_hollow_isOutside() {
    TriangleMesh hollow = sphereMesh(20, 40, 80);
    for (auto& triangle : hollow.triangles) {
        std::swap(triangle[1], triangle[2]);
    }
    const DistanceField field =
        buildDistanceField(joined(sphereMesh(35, 60, 120), hollow), 64, Progress());
    QVERIFY(field.sample({0, 0, 0}) > 10);
    QVERIFY(field.sample({0, -27.5, 0}) < -5);
    QVERIFY(field.sample({0, -37, 0}) > 1);
}

void DistanceFieldTest::buildDistanceField_openBody_isClosedByMajority() {
    // A sphere whose cap within 36° of the pole is missing.
    TriangleMesh bowl = sphereMesh(35, 50, 100);
    std::erase_if(bowl.triangles, [&](const auto& triangle) {
        return bowl.positions[triangle[0]].y() > 35 * 0.81F;
    });
    QVERIFY(!isClosed(bowl));
    const DistanceField field = buildDistanceField(bowl, 64, Progress());
    for (const auto& direction : randomDirections(2000)) {
        if (direction.y() < 0.7) {
            QVERIFY(field.sample(direction * 33) < 0);
            QVERIFY(field.sample(direction * 15) < 0);
            QVERIFY(field.sample(direction * 37) > 0);
        }
    }
    QVERIFY(field.sample({0, 34, 0}) > 0);
}

void DistanceFieldTest::buildDistanceField_flippedTriangles_keepTheSign() {
    TriangleMesh sphere = sphereMesh(35, 60, 120);
    for (std::size_t t = 0; t < sphere.triangles.size(); t += 3) {
        std::swap(sphere.triangles[t][1], sphere.triangles[t][2]);
    }
    const DistanceField field = buildDistanceField(sphere, 64, Progress());
    QCOMPARE(compare(field, sphereDistance, 0.06).wrongSigns, 0);
}

void DistanceFieldTest::buildDistanceField_anyNumberOfThreads_givesTheSameBits() {
    const TriangleMesh body = ellipsoidMesh({35, 20, 50}, 60, 120);
    const auto build = [&](int threads) {
        const ThreadLimit limit(threads);
        return buildDistanceField(body, 96, Progress()).distance;
    };
    const auto alone = build(1);
    QVERIFY(alone == build(2));
    QVERIFY(alone == build(7));
}

void DistanceFieldTest::buildDistanceField_cancelled_throws() {
    Progress progress;
    progress.report = [&](double share, const QString&) {
        if (share > 0.2) {
            progress.cancelToken.cancel();
        }
    };
    QVERIFY_EXCEPTION_THROWN(buildDistanceField(sphereMesh(35, 60, 120), 64, progress), Cancelled);
}

void DistanceFieldTest::buildDistanceField_progress_growsTo1() {
    Progress progress;
    double last = 0;
    bool grows = true;
    progress.report = [&](double share, const QString& text) {
        grows = grows && share >= last && !text.isEmpty();
        last = share;
    };
    buildDistanceField(sphereMesh(35, 20, 40), 64, progress);
    QVERIFY(grows);
    QCOMPARE(last, 1.0);
}

void DistanceFieldTest::buildDistanceField_invalidInput_isRefused() {
    const TriangleMesh box = boxMesh({10, 10, 10});
    QVERIFY_EXCEPTION_THROWN(buildDistanceField(box, 31, Progress()), Error);
    QVERIFY_EXCEPTION_THROWN(buildDistanceField(box, 513, Progress()), Error);
    QVERIFY_EXCEPTION_THROWN(buildDistanceField(TriangleMesh(), 64, Progress()), Error);
    QVERIFY_EXCEPTION_THROWN(buildDistanceField(boxMesh({0, 0, 0}), 64, Progress()), Error);
}

// Thin plates count if they have at least 1 % of the surface.
void DistanceFieldTest::thinParts_platesCount_taperedEdgesDoNot() {
    const auto thickness = [](const TriangleMesh& mesh) {
        return thinParts(mesh, SurfaceQuery(mesh)).plate;
    };
    QVERIFY(std::abs(thickness(boxMesh({100, 0.5, 60})) - 0.5) < 1e-3);
    QVERIFY(thickness(tetrahedronMesh(60)) > 10);
    QVERIFY(thickness(sphereMesh(35, 40, 80)) > 60);
    QVERIFY(std::isinf(thickness(coneMesh(0.5, 60, 90))) || thickness(coneMesh(0.5, 60, 90)) > 10);
    // Rims of 30°, 20° and 10°.
    for (const double degrees : {60.0, 70.0, 80.0}) {
        const double found = thickness(coneMesh(degrees * pi / 180, 12, 90));
        QVERIFY2(found > 1, qPrintable(QString::number(found)));
    }
    const auto withFin = [&](double edge) {
        TriangleMesh fin = boxMesh({edge, edge, 0.5});
        for (auto& position : fin.positions) {
            position.y() += 40 + float(edge / 2);
        }
        return thickness(joined(boxMesh({60, 60, 60}), fin));
    };
    QVERIFY(std::abs(withFin(30) - 0.5) < 1e-2);
    QVERIFY(withFin(5) > 50);
}

// A fin is missed if it is thinner than a cell and sticks out by more than four cells. The edges of
// the cube, of a wedge and of a cone are thin, too, but stick out less.
void DistanceFieldTest::missedParts_finsCount_edgesDoNot() {
    const auto missed = [](const TriangleMesh& mesh, double spacing) {
        return missedParts(mesh, SurfaceQuery(mesh), spacing);
    };
    const auto withFin = [](double edge, double thickness) {
        TriangleMesh fin = boxMesh({edge, edge, thickness});
        for (auto& position : fin.positions) {
            position.y() += 30 + float(edge / 2);
        }
        return joined(boxMesh({60, 60, 60}), fin);
    };
    const MissedParts fin = missed(withFin(8, 0.3), 0.5);
    QVERIFY(std::abs(fin.thickness - 0.3) < 1e-3);
    // Both faces, and the four narrow ones; two cells or more from the cube.
    QVERIFY2(fin.area > 2 * 8 * 6 && fin.area < 2 * 8 * 8 + 4 * 8 * 0.3,
             qPrintable(QString::number(fin.area)));
    QCOMPARE(missed(withFin(8, 0.6), 0.5).area, 0.0);
    QCOMPARE(missed(withFin(1.5, 0.3), 0.5).area, 0.0);
    QVERIFY(missed(boxMesh({0.4, 30, 0.4}), 0.5).area > 0.9 * 4 * 0.4 * 30); // all of it is thin
    for (const TriangleMesh& mesh : {boxMesh({60, 60, 60}), tetrahedronMesh(60),
                                     coneMesh(0.5, 60, 90), sphereMesh(35, 40, 80)}) {
        QCOMPARE(missed(mesh, 0.5).area, 0.0);
    }
    QCOMPARE(missed(boxMesh({200, 1.2, 140}), 0.3).area, 0.0); // its places are 1.7 mm apart
}

void DistanceFieldTest::cachedDistanceField_usualBodies_keepTheCube() {
    for (const TriangleMesh& mesh : {sphereMesh(35, 40, 80), tetrahedronMesh(60),
                                     boxMesh({60, 20, 40}), boxMesh({60, 2, 40})}) {
        const DistanceField usual = buildDistanceField(mesh, 128, {});
        const auto chosen = cachedDistanceField(mesh, 128, {});
        QCOMPARE(chosen->size, usual.size);
        QCOMPARE(chosen->spacing, usual.spacing);
        QCOMPARE(chosen->origin, usual.origin);
        QCOMPARE(chosen->distance, usual.distance);
    }
}

void DistanceFieldTest::cachedDistanceField_thinPlate_isResolvedInAnyDirection_data() {
    QTest::addColumn<double>("degrees");
    QTest::newRow("along the grid") << 0.0;
    QTest::newRow("turned by 33°") << 33.0;
    QTest::newRow("turned by 45°") << 45.0;
}

// The field's surface deviates by less than 10 % of the plate's thickness.
void DistanceFieldTest::cachedDistanceField_thinPlate_isResolvedInAnyDirection() {
    QFETCH(double, degrees);
    const Eigen::Isometry3d turn(
        Eigen::AngleAxisd(degrees * pi / 180, Eigen::Vector3d(1, 0, 1).normalized()));
    const TriangleMesh plate = transformed(boxMesh({60, 0.8, 40}), turn);
    const auto field = cachedDistanceField(plate, 96, {});
    for (double x = -25; x <= 25; x += 2.3) {
        for (double z = -15; z <= 15; z += 1.7) {
            QVERIFY(field->sample(turn * Eigen::Vector3d(x, 0, z)) < -0.2);
            QVERIFY(std::abs(field->sample(turn * Eigen::Vector3d(x, 0.4, z))) < 0.08);
            QVERIFY(std::abs(field->sample(turn * Eigen::Vector3d(x, -0.4, z))) < 0.08);
        }
    }
}

void DistanceFieldTest::fieldGrid_veryThinPlate_keepsTheSampleLimit() {
    const TriangleMesh foil = transformed(
        boxMesh({100, 0.05, 100}),
        Eigen::Isometry3d(Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 0, 1).normalized())));
    const double thinnest = thinParts(foil, SurfaceQuery(foil)).thickness;
    const FieldGrid grid = fieldGrid(foil, 128, thinnest);
    QVERIFY(grid.sampleCount() <= mostFieldSamples);
    QVERIFY(grid.sampleCount() > mostFieldSamples / 2);
    QVERIFY(!isFineEnough(grid, thinnest));
}

void DistanceFieldTest::fieldLevel_smallerFilmCells_haveSmallerFieldCells() {
    const TriangleMesh body = boxMesh({90, 40, 50});
    const auto field = cachedDistanceField(body, 64, {});
    QCOMPARE(fieldLevel(*field, 100), 0);
    for (const double filmCell : {3.0, 2.0, 1.5, 1.0, 0.7}) {
        const int level = fieldLevel(*field, filmCell);
        QVERIFY(level > 0 && level <= field->finer->count());
        const double cell = field->finer->spacing(level);
        QCOMPARE(cell, field->spacing / std::exp2(level));
        QVERIFY(cell <= mostFieldCell * filmCell && cell > mostFieldCell * filmCell / 2);
    }
    QCOMPARE(fieldLevel(*field, 0.001), field->finer->count());
    QCOMPARE(fieldLevel(buildDistanceField(body, 64, {}), 0.001), 0);
}

void DistanceFieldTest::fieldAtLevel_eachLevel_halvesTheErrorAtEdges() {
    const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 3).normalized(); // so edges cross the cells
    const Eigen::Isometry3d turn(Eigen::AngleAxisd(0.7, axis));
    const auto field = cachedDistanceField(transformed(boxMesh({30, 30, 30}), turn), 48, {});
    QCOMPARE(&fieldAtLevel(*field, 0, {}), field.get());
    double before = 0;
    for (const int level : {0, 1, 2}) {
        const DistanceField& finer = fieldAtLevel(*field, level, {});
        double sum = 0;
        for (double along = -14; along < 14; along += 0.037) {
            sum += std::abs(finer.sample(turn * Eigen::Vector3d(15, along, 15)));
        }
        QVERIFY(level == 0 || (sum < 0.55 * before && sum > 0.45 * before));
        before = sum;
    }
}

void DistanceFieldTest::fieldAtLevel_manyThreads_buildOneField() {
    const TriangleMesh body = boxMesh({30, 20, 40});
    const auto field = cachedDistanceField(body, 48, {});
    std::vector<const DistanceField*> built(16);
    parallelFor(std::size_t(0), built.size(),
                [&](std::size_t i) { built[i] = &fieldAtLevel(*field, 1, {}); });
    for (const DistanceField* each : built) {
        QCOMPARE(each, built.front());
    }
    QVERIFY(built.front()->distance ==
            buildDistanceField(body, SurfaceQuery(body), *built.front(), {}).distance);
}

void DistanceFieldTest::fieldAtLevel_cancelled_canBeBuiltLater() {
    // Not a body of another test, because its fields would be cached.
    const auto field = cachedDistanceField(boxMesh({30, 20, 41}), 48, {});
    Progress stopped;
    stopped.cancelToken.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, fieldAtLevel(*field, 1, stopped));
    QCOMPARE(fieldAtLevel(*field, 1, {}).spacing, field->spacing / 2);
}

void DistanceFieldTest::fieldCache_secondRequest_readsTheSameField() {
    const TriangleMesh body = sphereMesh(35, 20, 40);
    const DistanceField built = buildDistanceField(body, 64, Progress());
    int builds = 0;
    Progress progress;
    progress.report = [&](double share, const QString&) { builds += share == 0; };
    for (int round = 0; round < 3; ++round) {
        const auto field = cachedDistanceField(body, 64, progress);
        QCOMPARE(field->size, built.size);
        QCOMPARE(field->spacing, built.spacing);
        QVERIFY(field->origin == built.origin);
        QVERIFY(field->distance == built.distance);
    }
    QCOMPARE(builds, 1);
    // Another body or resolution has another field.
    QVERIFY(cachedDistanceField(sphereMesh(34, 20, 40), 64, progress)->distance != built.distance);
    QCOMPARE(cachedDistanceField(body, 65, progress)->size[0], 65);
    QCOMPARE(builds, 3);
}

void DistanceFieldTest::fieldCache_finerFields_areReadToo() {
    const TriangleMesh body = boxMesh({31, 22, 43});
    int builds = 0;
    Progress progress;
    progress.report = [&](double share, const QString&) { builds += share == 0; };
    std::vector<float> distance;
    for (int round = 0; round < 2; ++round) {
        const auto field = cachedDistanceField(body, 48, {});
        const DistanceField& finer = fieldAtLevel(*field, 1, progress);
        QVERIFY(round == 0 || finer.distance == distance);
        distance = finer.distance;
    }
    QCOMPARE(builds, 1);
}

void DistanceFieldTest::fieldCache_damagedFile_isRebuilt() {
    const TriangleMesh body = boxMesh({11, 12, 13});
    const DistanceField built = buildDistanceField(body, 64, Progress());
    cachedDistanceField(body, 64, Progress());
    const QDir folder(cache_.path());
    const QString path = folder.filePath(folder.entryList(QDir::Files, QDir::Time).first());
    const auto damage = [&](const std::function<void(QByteArray&)>& change) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadWrite));
        QByteArray bytes = file.readAll();
        change(bytes);
        file.resize(0);
        file.seek(0);
        file.write(bytes);
        file.close();
        const auto field = cachedDistanceField(body, 64, Progress());
        QVERIFY(field->distance == built.distance && field->origin == built.origin);
    };
    damage([](QByteArray& bytes) { bytes.clear(); });
    damage([](QByteArray& bytes) { bytes.truncate(bytes.size() / 2); });
    damage([](QByteArray& bytes) { bytes.append("more"); });
    for (const int place : {0, 3, 10, 20, 60, 90, 5000}) {
        damage([place](QByteArray& bytes) { bytes[place] = char(bytes[place] ^ 0x41); });
    }
}

void DistanceFieldTest::fieldCache_unwritable_buildsTheField() {
    QFile file(cache_.filePath(QStringLiteral("file")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    qputenv("DIPWRIGHT_CACHE", (file.fileName() + QStringLiteral("/folder")).toUtf8());
    const auto field = cachedDistanceField(boxMesh({10, 10, 10}), 64, Progress());
    QCOMPARE(field->size[0], 64);
}

void DistanceFieldTest::fieldCache_pipe_doesNotBlock() {
#ifdef Q_OS_UNIX
    const auto field = cachedDistanceField(boxMesh({11, 12, 13}), 64, Progress());
    const QStringList files = QDir(cache_.path()).entryList({QStringLiteral("*.field")});
    for (const QString& name : files) {
        const QString path = cache_.filePath(name);
        QVERIFY(QFile::remove(path));
        QCOMPARE(mkfifo(QFile::encodeName(path).constData(), 0600), 0);
    }
    const auto again = cachedDistanceField(boxMesh({11, 12, 13}), 64, Progress());
    QVERIFY(again->distance == field->distance);
    for (const QString& name : files) {
        QVERIFY(QFile::remove(cache_.filePath(name)));
    }
#endif
}

void DistanceFieldTest::fieldCache_full_removesLeastRecentlyUsed() {
    const auto addFile = [&](const QString& name, qint64 megabytes, int daysAgo) {
        QFile file(cache_.filePath(name));
        return file.open(QIODevice::WriteOnly) && file.resize(megabytes << 20) &&
               file.setFileTime(QDateTime::currentDateTime().addDays(-daysAgo),
                                QFileDevice::FileModificationTime);
    };
    QVERIFY(addFile(QStringLiteral("old.field"), 700, 20));
    QVERIFY(addFile(QStringLiteral("recent.field"), 700, 10));
    QVERIFY(addFile(QStringLiteral("other.txt"), 1, 30));
    cachedDistanceField(boxMesh({17, 18, 19}), 64, Progress());
    QVERIFY(!QFile::exists(cache_.filePath(QStringLiteral("old.field"))));
    QVERIFY(QFile::exists(cache_.filePath(QStringLiteral("recent.field"))));
    QVERIFY(QFile::exists(cache_.filePath(QStringLiteral("other.txt"))));
}

QTEST_GUILESS_MAIN(DistanceFieldTest)
#include "DistanceFieldTest.moc"
