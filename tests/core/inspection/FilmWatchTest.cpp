// Tests the film watch with simulated photos of a film on the water, whose true values are known.
#include "TankPhoto.h"
#include "WholeSample.h"
#include "project/Profiles.h"

#include "base/Error.h"
#include "inspection/FilmWatch.h"
#include "settings/FilmOnWater.h"
#include "sheet/page/WatchPage.h"

#include <QtTest>
#include <random>

using namespace dipwright;
using namespace dipwright::test;

namespace {

// Returns the upper left corner of a square, in mm from the page's middle.
Eigen::Vector2d printedCorner(BoardKind kind, QSizeF paper, int column, int row) {
    WatchPage page;
    page.kind = kind;
    page.paper = paper;
    const QPointF corner = watchBoard(page).box.topLeft() +
                           QPointF(column, row) * boardSquare(kind) -
                           QPointF(paper.width(), paper.height()) / 2;
    return {corner.x(), corner.y()};
}

struct Tank {
    FloatingPage film = filmPage(), card = cardPage();
    TankCamera camera;
    PhotoLight light;

    QImage photo() const { return tankPhoto({card, film}, camera, light); }
};

// Returns film and card beside each other on the water, photographed from above.
Tank tank(double swellX, double swellY) {
    Tank tank;
    tank.film.turn = turned(4, swellX, swellY);
    tank.film.middle = {-95, 5};
    tank.card.turn = turned(-8);
    tank.card.middle = {125, 20};
    tank.camera.tiltDegrees = 7;
    tank.camera.rollDegrees = 3;
    tank.camera.k1 = -0.06;
    tank.camera.k2 = 0.015;
    return tank;
}

const SeenBoard* boardOf(const std::vector<SeenBoard>& boards, BoardKind kind) {
    for (const SeenBoard& board : boards) {
        if (board.kind == kind) {
            return &board;
        }
    }
    return nullptr;
}

// Returns the seen places of a board's corners minus their true places, in pixels.
std::vector<Eigen::Vector2d> errors(const SeenBoard& board, const FloatingPage& page,
                                    const TankCamera& camera) {
    std::vector<Eigen::Vector2d> result;
    for (const SeenCorner& corner : board.corners) {
        const Eigen::Vector2d printed =
            printedCorner(board.kind, page.size, corner.column, corner.row);
        result.push_back(corner.place - camera.seen(page.onWater(printed), page.above));
    }
    return result;
}

Eigen::Vector2d mean(const std::vector<Eigen::Vector2d>& places) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& place : places) {
        sum += place / double(places.size());
    }
    return sum;
}

double rms(const std::vector<Eigen::Vector2d>& places) {
    double sum = 0;
    for (const Eigen::Vector2d& place : places) {
        sum += place.squaredNorm() / double(places.size());
    }
    return std::sqrt(sum);
}

// Returns the corners of a board as a camera sees them, with `noise` pixels of error in both
// directions. `corners` is the number of columns and rows.
SeenBoard cornersOf(const FloatingPage& page, BoardKind kind, QSize corners,
                    const TankCamera& camera, double noise, std::mt19937& random) {
    std::normal_distribution<double> off(0, noise);
    SeenBoard board{kind, false, {}};
    for (int row = 1; row <= corners.height(); ++row) {
        for (int column = 1; column <= corners.width(); ++column) {
            const Eigen::Vector2d water = page.onWater(printedCorner(kind, page.size, column, row));
            const Eigen::Vector2d place = camera.seen(water, page.above);
            board.corners.push_back(
                {column, row, place + Eigen::Vector2d(off(random), off(random))});
        }
    }
    return board;
}

FlatFilm fitted(const Tank& tank, double noise, std::mt19937& random,
                const FlatSettings& settings = {}) {
    const SeenBoard film =
        cornersOf(tank.film, BoardKind::Film, {10, 6}, tank.camera, noise, random);
    const SeenBoard card =
        cornersOf(tank.card, BoardKind::Card, {10, 13}, tank.camera, noise, random);
    return fitFlatFilm(film, card, tank.camera.size, settings, QStringLiteral("photo"));
}

bool contains(const Measured& measured, double truth) {
    return std::abs(measured.value - truth) <= measured.off;
}

QString errorOf(const QImage& photo) {
    try {
        measureFlatFilm(photo, {}, QStringLiteral("photo.jpg"));
    } catch (const Error& error) {
        return error.message();
    }
    return {};
}

} // namespace

class FilmWatchTest : public QObject {
    Q_OBJECT

private slots:
    void codedBoard_everyPart_isUnique();
    void findBoards_corners_areWithinHundredthsOfAPixel_data();
    void findBoards_corners_areWithinHundredthsOfAPixel();
    void findBoards_turnedOrSlantedBoards_areFound_data();
    void findBoards_turnedOrSlantedBoards_areFound();
    void measureFlatFilm_swell_isWithin0p1Percent_data();
    void measureFlatFilm_swell_isWithin0p1Percent();
    void fitFlatFilm_60Corners_measureSwellWithin0p1Percent();
    void fitFlatFilm_95PercentIntervals_holdTheTruthIn95Percent();
    void fitFlatFilm_cardAboveTheWater_isCorrected();
    void fitFlatFilm_unevenFilm_showsWhere();
    void fitGrowth_eightPhotos_isWithin5Percent();
    void fitGrowth_95PercentIntervals_holdTheTruthIn95Percent();
    void fitGrowth_insufficientPhotos_leavesGrowthUnknown();
    void fitGrowth_timesNotInOrder_areRefused();
    void fitGrowth_saturatedFilm_isRefused();
    void withMeasurement_profile_takesTheMeasuredValues();
    void fitFlatFilm_degenerateCorners_areRefused();
    void evaluatedFilmWatch_dipOutsideThePhotos_isRefused();
    void measureFlatFilm_unusablePhoto_isRefused();
};

void FilmWatchTest::codedBoard_everyPart_isUnique() {
    // Compares each part of 7 × 6 squares of both boards, turned and mirrored in every way, with
    // every other part.
    constexpr int width = 7, height = 6, cells = width * height;
    std::vector<std::uint64_t> parts;
    for (const BoardKind kind : {BoardKind::Film, BoardKind::Card}) {
        for (int row = 0; row + 7 <= mostBoardSquares; ++row) {
            for (int column = 0; column + 7 <= mostBoardSquares; ++column) {
                for (int way = 0; way < 8; ++way) {
                    std::uint64_t bits = isBlackSquare(column, row);
                    for (int i = 0; i < cells; ++i) {
                        int x = i % width, y = i / width;
                        x = way & 1 ? width - 1 - x : x;
                        y = way & 2 ? height - 1 - y : y;
                        if (way & 4) {
                            std::swap(x, y);
                        }
                        bits = bits << 1 | unsigned(isDottedSquare(kind, column + x, row + y));
                    }
                    parts.push_back(bits);
                }
            }
        }
    }
    std::sort(parts.begin(), parts.end());
    QVERIFY(std::adjacent_find(parts.begin(), parts.end()) == parts.end());
}

void FilmWatchTest::findBoards_corners_areWithinHundredthsOfAPixel_data() {
    QTest::addColumn<double>("blur");
    QTest::addColumn<double>("noise");
    QTest::addColumn<int>("jpeg");
    QTest::addColumn<double>("most"); // rms, in pixels
    QTest::newRow("sharp") << 0.6 << 0.0 << 0 << 0.05;
    QTest::newRow("out of focus") << 2.5 << 1.0 << 85 << 0.12;
    if (isWholeRun()) {
        QTest::newRow("noise of one level") << 0.8 << 1.0 << 85 << 0.08;
        QTest::newRow("noise of two levels") << 0.8 << 2.0 << 85 << 0.1;
    }
}

void FilmWatchTest::findBoards_corners_areWithinHundredthsOfAPixel() {
    QFETCH(double, blur);
    QFETCH(double, noise);
    QFETCH(int, jpeg);
    QFETCH(double, most);
    Tank scene = tank(1.08, 1.03);
    scene.light = {.blur = blur, .noise = noise, .jpegQuality = jpeg};
    const std::vector<SeenBoard> boards = findBoards(scene.photo());
    const SeenBoard* film = boardOf(boards, BoardKind::Film);
    const SeenBoard* card = boardOf(boards, BoardKind::Card);
    QVERIFY(film && card);
    QCOMPARE(int(film->corners.size()), 120);
    QCOMPARE(int(card->corners.size()), 154);
    for (const auto& [board, page] : {std::pair(film, &scene.film), std::pair(card, &scene.card)}) {
        const auto off = errors(*board, *page, scene.camera);
        qInfo("errors of the corners: mean %.4f, %.4f px; rms %.4f px", mean(off).x(),
              mean(off).y(), rms(off));
        QVERIFY(mean(off).norm() < 0.05);
        QVERIFY(rms(off) < most);
    }
}

void FilmWatchTest::findBoards_turnedOrSlantedBoards_areFound_data() {
    QTest::addColumn<double>("roll");
    QTest::addColumn<double>("tilt");
    QTest::addColumn<bool>("glare");
    const std::vector<int> rolls =
        isWholeRun() ? std::vector<int>{0, 45, 90, 137, 180, 270, 311} : std::vector<int>{90, 137};
    for (const int roll : rolls) {
        QTest::addRow("turned by %d°", roll) << double(roll) << 4.0 << false;
    }
    QTest::newRow("seen at a slant") << 10.0 << 35.0 << false;
    QTest::newRow("with glare") << 0.0 << 5.0 << true;
}

void FilmWatchTest::findBoards_turnedOrSlantedBoards_areFound() {
    QFETCH(double, roll);
    QFETCH(double, tilt);
    QFETCH(bool, glare);
    Tank scene = tank(1.05, 1.02);
    scene.camera.size = {1400, 1400};
    scene.camera.height = 900;
    scene.camera.rollDegrees = roll;
    scene.camera.tiltDegrees = tilt;
    scene.light.glare = glare;
    const std::vector<SeenBoard> boards = findBoards(scene.photo());
    const SeenBoard* film = boardOf(boards, BoardKind::Film);
    const SeenBoard* card = boardOf(boards, BoardKind::Card);
    QVERIFY(film && card);
    QVERIFY(!film->mirrored && !card->mirrored);
    QVERIFY(film->corners.size() >= (glare ? 60 : 118));
    QVERIFY(card->corners.size() >= (glare ? 60 : 150));
    QVERIFY(rms(errors(*film, scene.film, scene.camera)) < 0.2);
    QVERIFY(rms(errors(*card, scene.card, scene.camera)) < 0.2);
}

void FilmWatchTest::measureFlatFilm_swell_isWithin0p1Percent_data() {
    QTest::addColumn<double>("swellX");
    QTest::addColumn<double>("swellY");
    QTest::addColumn<double>("k1");
    QTest::addColumn<double>("k2");
    QTest::addColumn<double>("blur");
    QTest::addColumn<double>("noise");
    QTest::addColumn<bool>("glare");
    QTest::newRow("barrel") << 1.13 << 1.06 << -0.1 << 0.02 << 0.8 << 1.0 << false;
    QTest::newRow("glare") << 1.05 << 1.11 << -0.06 << 0.015 << 0.8 << 1.0 << true;
    if (isWholeRun()) {
        QTest::newRow("straight lens") << 1.0 << 1.0 << 0.0 << 0.0 << 0.7 << 1.0 << false;
        QTest::newRow("cushion") << 1.21 << 1.17 << 0.05 << 0.01 << 0.8 << 2.0 << false;
        QTest::newRow("out of focus") << 1.07 << 1.02 << -0.06 << 0.0 << 2.5 << 2.0 << false;
    }
}

void FilmWatchTest::measureFlatFilm_swell_isWithin0p1Percent() {
    QFETCH(double, swellX);
    QFETCH(double, swellY);
    QFETCH(double, k1);
    QFETCH(double, k2);
    QFETCH(double, blur);
    QFETCH(double, noise);
    QFETCH(bool, glare);
    Tank scene = tank(swellX, swellY);
    scene.camera.k1 = k1;
    scene.camera.k2 = k2;
    scene.light = {.blur = blur, .noise = noise, .glare = glare};
    const FlatFilm film = measureFlatFilm(scene.photo(), {}, QStringLiteral("photo"));
    qInfo("errors of the swell: %.5f ± %.5f, %.5f ± %.5f; %zu corners, %.3f px",
          film.swellX.value - swellX, film.swellX.off, film.swellY.value - swellY, film.swellY.off,
          film.corners.size(), film.residualPixels);
    QVERIFY(std::abs(film.swellX.value / swellX - 1) < 0.001);
    QVERIFY(std::abs(film.swellY.value / swellY - 1) < 0.001);
    QVERIFY(film.swellX.off < 0.001 && film.swellY.off < 0.001);
}

void FilmWatchTest::fitFlatFilm_60Corners_measureSwellWithin0p1Percent() {
    std::mt19937 random(7);
    const Tank scene = tank(1.1, 1.05);
    double worst = 0;
    for (int i = 0; i < 40; ++i) {
        const FlatFilm film = fitted(scene, 0.05, random);
        QCOMPARE(int(film.corners.size()), 60);
        worst = std::max({worst, film.swellX.off / 1.1, film.swellY.off / 1.05});
    }
    qInfo("60 corners with 0.05 px of noise: swell ± %.4f %% at 95 %%", 100 * worst);
    QVERIFY(worst < 0.001);
}

void FilmWatchTest::fitFlatFilm_95PercentIntervals_holdTheTruthIn95Percent() {
    std::mt19937 random(20261122);
    int held = 0;
    constexpr int photos = 200;
    for (int i = 0; i < photos; ++i) {
        Tank scene = tank(1 + 0.001 * i, 1.2 - 0.001 * i);
        scene.camera.tiltDegrees = i % 20;
        const FlatFilm film = fitted(scene, 0.4, random);
        held += contains(film.swellX, 1 + 0.001 * i) + contains(film.swellY, 1.2 - 0.001 * i);
    }
    qInfo("95 %% intervals hold the truth in %.1f %%", 100.0 * held / (2 * photos));
    QVERIFY(held >= 0.93 * 2 * photos && held <= 0.97 * 2 * photos);
}

void FilmWatchTest::fitFlatFilm_cardAboveTheWater_isCorrected() {
    std::mt19937 random(3);
    Tank scene = tank(1.1, 1.05);
    scene.card.above = 12;
    FlatSettings settings;
    const FlatFilm wrong = fitted(scene, 0.02, random, settings);
    QVERIFY(std::abs(wrong.swellX.value - 1.1) > 0.01);
    settings.cardAbove = 12;
    settings.focalLength = scene.camera.focalLength;
    const FlatFilm right = fitted(scene, 0.02, random, settings);
    QVERIFY(std::abs(right.swellX.value - 1.1) < 0.001);
    QVERIFY(std::abs(right.swellY.value - 1.05) < 0.001);
}

void FilmWatchTest::fitFlatFilm_unevenFilm_showsWhere() {
    std::mt19937 random(5);
    Tank scene = tank(1.1, 1.05);
    // The film is displaced by 1 mm around one place.
    const Eigen::Vector2d bump = printedCorner(BoardKind::Film, scene.film.size, 3, 3);
    scene.film.aside = [bump](const Eigen::Vector2d& place) {
        const double away = (place - bump).squaredNorm() / (2 * 25 * 25);
        return Eigen::Vector2d(std::exp(-away), 0);
    };
    FlatSettings settings;
    settings.lens = Lens{scene.camera.k1, scene.camera.k2};
    const FlatFilm film = fitted(scene, 0.05, random, settings);
    const FilmCorner* farthest = &film.corners.front();
    for (const FilmCorner& corner : film.corners) {
        farthest = corner.off.norm() > farthest->off.norm() ? &corner : farthest;
    }
    QVERIFY(std::abs(farthest->column - 3) <= 1 && std::abs(farthest->row - 3) <= 1);
    QVERIFY(farthest->off.norm() > 0.4);
    QVERIFY(film.unevennessMillimetres > 0.2);
}

namespace {

double grown(double seconds, double rate, double limit) {
    return 1 + limit * (1 - std::exp(-rate * seconds / limit));
}

// Returns the measurements of a film photographed at `times`, in seconds. The dip begins at
// `begin`.
FilmWatch watched(const std::vector<double>& times, double begin, double rate, double limit,
                  double noise, std::mt19937& random) {
    std::vector<WatchedPhoto> photos;
    for (const double seconds : times) {
        const double growth = limit > 0 ? grown(seconds - begin, rate, limit) : 1;
        const Tank scene = tank(1.08 * growth, 1.04 * growth);
        photos.push_back({QStringLiteral("photo.jpg"), QStringLiteral("ab%1").arg(photos.size()),
                          seconds, scene.camera.size, fitted(scene, noise, random)});
    }
    return evaluatedFilmWatch(std::move(photos), begin);
}

const std::vector<double> twoMinutes{20, 35, 50, 70, 90, 110, 140, 180};

} // namespace

void FilmWatchTest::fitGrowth_eightPhotos_isWithin5Percent() {
    std::mt19937 random(11);
    for (const auto& [rate, limit] :
         {std::pair(0.002, 0.1), std::pair(0.004, 0.2), std::pair(0.003, 0.05)}) {
        const FilmWatch watch = watched(twoMinutes, 70, rate, limit, 0.05, random);
        const GrowthFit& growth = watch.growth;
        QCOMPARE(growth.known, GrowthKnowledge::Both);
        qInfo("rate %.5f of %.5f ± %.5f, limit %.4f of %.4f ± %.4f", growth.rate.value, rate,
              growth.rate.off, growth.limit.value, limit, growth.limit.off);
        QVERIFY(std::abs(growth.rate.value / rate - 1) < 0.05);
        QVERIFY(std::abs(growth.limit.value / limit - 1) < 0.05);
        QVERIFY(std::abs(growth.swellX.value / 1.08 - 1) < 0.001);
        QVERIFY(std::abs(growth.swellY.value / 1.04 - 1) < 0.001);
    }
}

void FilmWatchTest::fitGrowth_95PercentIntervals_holdTheTruthIn95Percent() {
    std::mt19937 random(20261123);
    int rates = 0, limits = 0, swells = 0;
    constexpr int films = 200;
    std::normal_distribution<double> off(0, 0.0004);
    for (int i = 0; i < films; ++i) {
        std::vector<SwellAt> moments;
        for (const double seconds : twoMinutes) {
            const double growth = grown(seconds - 70, 0.003, 0.1);
            const double uncertain = 1.959964 * 0.0004;
            moments.push_back({seconds,
                               {1.08 * growth + off(random), uncertain},
                               {1.04 * growth + off(random), uncertain}});
        }
        const GrowthFit growth = fitGrowth(moments, 70, {});
        QCOMPARE(growth.known, GrowthKnowledge::Both);
        rates += contains(growth.rate, 0.003);
        limits += contains(growth.limit, 0.1);
        swells += contains(growth.swellX, 1.08);
    }
    qInfo("95 %% intervals: rate %.1f %%, limit %.1f %%, swell %.1f %%", 100.0 * rates / films,
          100.0 * limits / films, 100.0 * swells / films);
    for (const int held : {rates, limits, swells}) {
        QVERIFY(held >= 0.92 * films && held <= 0.99 * films);
    }
}

void FilmWatchTest::fitGrowth_insufficientPhotos_leavesGrowthUnknown() {
    std::mt19937 random(13);
    QCOMPARE(watched({70}, 70, 0.003, 0.1, 0.1, random).growth.known, GrowthKnowledge::No);
    QCOMPARE(watched({70, 100}, 70, 0.003, 0.1, 0.1, random).growth.known, GrowthKnowledge::No);
    QCOMPARE(watched(twoMinutes, 70, 0, 0, 0.1, random).growth.known, GrowthKnowledge::None);
    // The growth is still linear when the last photo is taken.
    const FilmWatch straight = watched({60, 65, 70, 75, 80}, 70, 0.003, 0.5, 0.1, random);
    QCOMPARE(straight.growth.known, GrowthKnowledge::RateOnly);
    QVERIFY(std::abs(straight.growth.rate.value / 0.003 - 1) < 0.1);
    QVERIFY(watchSentences(straight).join(u' ').contains(QStringLiteral("stops growing")));
}

namespace {

// Returns why the film that grew as `grewAt` says cannot be measured if the photos are said to be
// from `times`; empty if it can be measured.
QString refusalOfTimes(const std::vector<double>& grewAt, const std::vector<double>& times,
                       double begin) {
    std::vector<SwellAt> moments;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double growth = grown(grewAt[i] - 70, 0.003, 0.08);
        moments.push_back({times[i], {1.08 * growth, 0.0001}, {1.04 * growth, 0.0001}});
    }
    try {
        fitGrowth(moments, begin, QStringLiteral("photo.jpg"));
    } catch (const Error& error) {
        return error.message();
    }
    return {};
}

} // namespace

void FilmWatchTest::fitGrowth_timesNotInOrder_areRefused() {
    const std::vector<double> times{60, 90, 150, 300};
    QCOMPARE(refusalOfTimes(times, times, 70), QString());
    for (const auto& wrong :
         {std::vector<double>{300, 150, 90, 60}, std::vector<double>{150, 300, 60, 90}}) {
        QVERIFY(refusalOfTimes(times, wrong, 70).contains(QStringLiteral("order of the photos")));
    }
    // A film that shrinks steadily.
    QVERIFY(refusalOfTimes({80, 75, 70}, {70, 75, 80}, 70).contains(QStringLiteral("shrinks by")));
}

// The photos of a film that has nearly stopped growing say nothing about the growth before them.
void FilmWatchTest::fitGrowth_saturatedFilm_isRefused() {
    const std::vector<double> times{150, 300, 600};
    QVERIFY(refusalOfTimes(times, times, 70).contains(QStringLiteral("do not determine")));
    QCOMPARE(refusalOfTimes(times, times, 150), QString());
    std::mt19937 random(31);
    // Growth was measured as none, or at a constant rate, only for the time of the photos.
    for (const double rate : {0.0, 0.003}) {
        QVERIFY_EXCEPTION_THROWN(watched({80, 85, 90, 95, 100}, 76, rate, 0.5, 0.1, random), Error);
    }
}

void FilmWatchTest::withMeasurement_profile_takesTheMeasuredValues() {
    std::mt19937 random(17);
    const FilmWatch watch = watched(twoMinutes, 70, 0.003, 0.1, 0.05, random);
    FilmProfile profile;
    profile.name = QStringLiteral("A film");
    profile =
        withMeasurement(profile, watch, {QStringLiteral("2026-11-22"), QStringLiteral("L7"), 28});
    QVERIFY(std::abs(profile.swellX - 1.08) < 0.001);
    QCOMPARE(profile.lot, QStringLiteral("L7"));
    QCOMPARE(profile.measured.swellX, profile.swellX);
    QVERIFY(profile.measured.growthRate == profile.growthRate);
    QCOMPARE(profileFromJson(toJson(profile), QStringLiteral("profile")), Profile(profile));
}

void FilmWatchTest::fitFlatFilm_degenerateCorners_areRefused() {
    std::mt19937 random(23);
    const Tank scene = tank(1.1, 1.05);
    const auto refusal = [&](QSize film, QSize card, const FlatSettings& settings) {
        try {
            fitFlatFilm(cornersOf(scene.film, BoardKind::Film, film, scene.camera, 0.05, random),
                        cornersOf(scene.card, BoardKind::Card, card, scene.camera, 0.05, random),
                        scene.camera.size, settings, QStringLiteral("photo"));
        } catch (const Error& error) {
            return error.message();
        }
        return QString();
    };
    const QSize film(10, 6), card(10, 13);
    QCOMPARE(refusal(film, card, {}), QString());
    // Only a single row or column of corners of one board is visible.
    QVERIFY(refusal({60, 1}, card, {}).contains(QStringLiteral("the whole card")));
    QVERIFY(refusal({1, 60}, card, {}).contains(QStringLiteral("the whole card")));
    QVERIFY(refusal(film, {130, 1}, {}).contains(QStringLiteral("the whole card")));
    // The given lens or card height does not fit this photo.
    for (const Lens lens : {Lens{-0.3, 0}, Lens{0.5, 0}, Lens{-1, -1}, Lens{1, 1}, Lens{-1, 1}}) {
        FlatSettings settings;
        settings.lens = lens;
        QVERIFY(refusal(film, card, settings).contains(QStringLiteral("distortion")));
    }
    FlatSettings settings;
    settings.cardAbove = -mostCardAbove;
    settings.focalLength = 0.23; // half diagonals; the shortest allowed
    QVERIFY(refusal(film, card, settings).contains(QStringLiteral("height")));
    settings.cardAbove = mostCardAbove;
    QVERIFY(!refusal(film, card, settings).isEmpty());
}

void FilmWatchTest::evaluatedFilmWatch_dipOutsideThePhotos_isRefused() {
    std::mt19937 random(29);
    const std::vector<double> late{300, 310, 320, 330};
    for (const auto& [times, begin] :
         {std::pair(twoMinutes, 3600.0), std::pair(late, 70.0), std::pair(late, 400.0)}) {
        try {
            watched(times, begin, 0, 0, 0.05, random);
            QFAIL("the film was measured, expected a refusal");
        } catch (const Error& error) {
            QVERIFY(error.message().contains(QStringLiteral("but the dip begins after")));
        }
    }
    // Photos of one moment give the film's size at that moment.
    const auto words = [&](double seconds) {
        return watchSentences(watched({seconds, seconds, seconds}, 70, 0.003, 0.1, 0.05, random))
            .join(u' ');
    };
    QVERIFY(words(190).contains(QStringLiteral("after 190 s")));
    QVERIFY(!words(70).contains(QStringLiteral("growth in between")));
}

void FilmWatchTest::measureFlatFilm_unusablePhoto_isRefused() {
    QImage empty(800, 600, QImage::Format_RGB32);
    empty.fill(Qt::gray);
    QVERIFY(errorOf(empty).startsWith(QStringLiteral("No chessboard")));
    Tank scene = tank(1.05, 1.05);
    scene.camera.size = {1600, 1200};
    const QImage photo = scene.photo();
    QCOMPARE(errorOf(photo), QString());
    QVERIFY(errorOf(photo.mirrored(true, false)).contains(QStringLiteral("mirrored")));
    const QImage filmOnly = tankPhoto({scene.film}, scene.camera, scene.light);
    QVERIFY(errorOf(filmOnly).startsWith(QStringLiteral("The card")));
    const QImage cardOnly = tankPhoto({scene.card}, scene.camera, scene.light);
    QVERIFY(errorOf(cardOnly).startsWith(QStringLiteral("Too little of the film's")));
    // The camera is turned away, so that only a third of the film is in the picture.
    Tank half = scene;
    half.camera.over = {330, 5};
    const QString sentence = errorOf(half.photo());
    qInfo("%s", qPrintable(sentence));
    QVERIFY(!sentence.isEmpty());
}

QTEST_MAIN(FilmWatchTest)
#include "FilmWatchTest.moc"
