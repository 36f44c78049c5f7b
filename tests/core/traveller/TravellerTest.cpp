// Tests the traveller's pages with general PDF tools and a QR code reader.
#include "traveller/Traveller.h"
#include "DippedByHand.h"
#include "geometry/Shapes.h"
#include "sheet/page/Sheet.h"
#include "traveller/PosePicture.h"
#include "traveller/TankTasks.h"

#include <QProcess>
#include <QStandardPaths>
#include <QStringList>
#include <QTemporaryDir>
#include <QtTest>

using namespace dipwright;

namespace {

QByteArray outputOf(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    process.waitForFinished();
    return process.readAllStandardOutput();
}

const std::shared_ptr<const LaidFilm>& film() {
    static const auto laid =
        test::laid(sphereMesh(35, 60, 120), test::viscousOnSphere(test::a4Grid(), 35, pi / 2));
    return laid;
}

Traveller traveller() {
    Traveller result;
    result.project = QStringLiteral("Ball");
    result.date = QStringLiteral("2026-11-22");
    FilmProfile profile;
    profile.name = QStringLiteral("Thin film");
    profile.lot = QStringLiteral("L-77");
    profile.dryingTime = Seconds(5400);
    result.profiles.film = profile;
    TankProfile tank;
    tank.markDistance = {Millimetres(250), Millimetres(330)};
    result.profiles.tank = tank;
    result.pins = datumPins(Sheet(), FilmSettings(), Millimetres(180));
    for (const char* name : {"Below", "Above"}) {
        TravellerDip dip;
        dip.immersion.name = QLatin1String(name);
        dip.immersion.rotation[0] = Degrees(12.5);
        dip.job = QStringLiteral("%1").arg(result.dips.size() + 1, 12, 16, QLatin1Char('a'));
        dip.sheet = QImage(210, 297, QImage::Format_RGB32);
        dip.sheet.fill(Qt::yellow);
        dip.body = boundingBox(film()->body().mesh);
        dip.motion.depth = Millimetres(72);
        dip.waterAtEnd = 72;
        result.dips.push_back(dip);
    }
    return result;
}

// Writes the PDF into the file and returns the text of each page.
QStringList pagesOf(const QByteArray& pdf, const QString& path) {
    QFile file(path);
    file.open(QIODevice::WriteOnly);
    file.write(pdf);
    file.close();
    return QString::fromUtf8(outputOf(QStringLiteral("pdftotext"), {path, QStringLiteral("-")}))
        .split(u'\f', Qt::SkipEmptyParts);
}

} // namespace

class TravellerTest : public QObject {
    Q_OBJECT

private slots:
    void travellerPdf_everyPage_listsTheSteps() {
        QTemporaryDir folder;
        const QStringList pages =
            pagesOf(travellerPdf(traveller()), folder.filePath("traveller.pdf"));
        QCOMPARE(pages.size(), 2);
        const QString first = pages.front().simplified();
        for (const char* words :
             {"Dip 1 of 2: Below", "aaaaaaaaaaa1", "12.5°", "Soak the film: 60 s",
              "then wait: 10 s", "before rinsing: see the film maker's instructions", "dry: 5400 s",
              "lot: L-77", "250 × 330 mm apart", "72 mm below it, at 5 mm/s, in 14.5 s",
              "Before dip 2, compare", "Done by"}) {
            QVERIFY2(first.contains(QString::fromUtf8(words)), words);
        }
        QVERIFY(pages.back().contains(QStringLiteral("Dip 2 of 2: Above")));
    }

    void travellerPdf_fullPage_hasThePicturesOnTheNext() {
        Traveller full = traveller();
        full.dips.front().verdict =
            QStringList(30, QStringLiteral("Trapped air keeps 3 % of the surface dry."));
        QTemporaryDir folder;
        const QStringList pages = pagesOf(travellerPdf(full), folder.filePath("traveller.pdf"));
        QCOMPARE(pages.size(), 3);
        QVERIFY(pages[0].contains("Trapped air") && !pages[0].contains("After dip 1"));
        QVERIFY(pages[1].contains("Dip 1 of 2") && pages[1].contains("After dip 1"));
        QVERIFY(pages[1].contains("Done by"));
        QVERIFY(pages[2].contains("After dip 2") && pages[2].contains("Done by"));
    }

    void tankTasks_path_saysPlacesAndTurnsInWords() {
        Traveller onPath = traveller();
        const Eigen::Quaterniond tilted(Eigen::AngleAxisd(30 * pi / 180, Eigen::Vector3d::UnitX()));
        onPath.dips.front().motion.path = {{Seconds(0), {12, 0, 20}, tilted},
                                           {Seconds(6), {0, 0, -40}}};
        const std::vector<TankTask> tasks = tankTasks(onPath);
        const auto dip = std::ranges::find(tasks, TankStep::Dip, &TankTask::step);
        QVERIFY(dip != tasks.end());
        QVERIFY2(dip->text.contains(
                     QStringLiteral("2 s: 8 mm to the right, 0 mm towards the upper edge, 0 mm up, "
                                    "turned by 20°, 0° and 0°")),
                 qPrintable(dip->text));
    }

    void tankTasks_flowingWater_saysWhereTheFilmMustBe() {
        Traveller inFlow = traveller();
        TravellerDip& dip = inFlow.dips.front();
        dip.motion.path = {{Seconds(0), {0, 0, 20}}, {Seconds(6), {0, 0, -40}}};
        dip.immersion.path.waterSpeed = MillimetresPerSecond(-3);
        dip.immersion.path.heading = Degrees(90);
        const std::vector<TankTask> tasks = tankTasks(inFlow);
        const auto step = std::ranges::find(tasks, TankStep::Lay, &TankTask::step);
        QVERIFY(step != tasks.end());
        const double seconds = dip.motion.dipTime().value();
        QVERIFY2(
            step->text.contains(QStringLiteral("flows at 3 mm/s with the heading 270°")) &&
                step->text.contains(QStringLiteral("0 mm to the right of it and −%1 mm towards "
                                                   "the lower edge")
                                        .arg(3 * seconds)),
            qPrintable(step->text));
    }

    void tankTasks_pathThroughPoses_listsThesePoses() {
        Traveller onPath = traveller();
        TravellerDip& dip = onPath.dips.front();
        dip.motion.path = {{Seconds(0), {0, 0, 20}}, {Seconds(6), {0, 0, -40}}};
        dip.immersion.path.kind = PathKind::Poses;
        dip.immersion.path.keys = {{Seconds(0)}, {Seconds(1.5)}, {Seconds(6)}};
        const std::vector<TankTask> tasks = tankTasks(onPath);
        const auto step = std::ranges::find(tasks, TankStep::Dip, &TankTask::step);
        QVERIFY(step != tasks.end());
        QVERIFY2(
            step->text.contains(QStringLiteral("\n• 1.5 s: 0 mm to the right, 0 mm towards the "
                                               "upper edge, 5 mm up")),
            qPrintable(step->text));
    }

    void travellerPdf_code_isTheJobNumber() {
        Traveller one = traveller();
        one.dips.pop_back();
        QCOMPARE(travellerJob(one), one.dips.front().job);
        const Traveller both = traveller();
        QCOMPARE(travellerJob(both).size(), 12);
        QVERIFY(travellerJob(both) != travellerJob(one));

        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("traveller.pdf"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(travellerPdf(both));
        file.close();
        outputOf(QStringLiteral("pdftoppm"),
                 {QStringLiteral("-r"), QStringLiteral("150"), QStringLiteral("-png"), path,
                  folder.filePath(QStringLiteral("page"))});
        for (const char* page : {"page-1.png", "page-2.png"}) {
            const QByteArray code =
                outputOf(QStringLiteral("zbarimg"), {QStringLiteral("-q"), QStringLiteral("--raw"),
                                                     folder.filePath(QLatin1String(page))});
            QCOMPARE(QString::fromLatin1(code.trimmed()), travellerJob(both));
        }
    }

    void travellerPdf_twice_givesTheSameBytes() {
        QCOMPARE(travellerPdf(traveller()), travellerPdf(traveller()));
    }

    // The ball's lower half is red. From the front, the lower half of the picture is red; from
    // below, the whole ball.
    void posePicture_showsTheBodyFromFrontAndBelow() {
        QImage red(210, 297, QImage::Format_RGBA8888);
        red.fill(Qt::red);
        const RefinedMesh fine(sphereMesh(35, 60, 120), 2);
        const PaintedBody paint({{film(), red}}, {}, {}, &fine);
        const PoseView view{film()->body(), fine, paint};
        const auto isRed = [](const QColor& colour) {
            return colour.red() > 2 * colour.green() + 40;
        };
        const QSize size(200, 200);
        const PosePicture front = posePicture(view, PoseSide::Front, size, {});
        QVERIFY(isRed(front.image.pixelColor(100, 130)));
        QVERIFY(!isRed(front.image.pixelColor(100, 70)));
        QCOMPARE(front.image.pixelColor(3, 3), QColor(Qt::white));
        // The ball is 70 mm high; the picture has a rim of 6 %.
        QVERIFY(std::abs(front.scale - 200 / (1.06 * 70)) < 0.01);
        QVERIFY(std::abs(front.bottom + 0.03 * 70) < 0.1);
        const PosePicture below = posePicture(view, PoseSide::Below, size, {});
        QVERIFY(isRed(below.image.pixelColor(100, 40)) && isRed(below.image.pixelColor(100, 160)));
    }

    // Where two dips fade into each other, each lets some light through, and the part shows the
    // product.
    void posePicture_twoDips_addsTheirInk() {
        const auto shownBelow = [](const std::vector<int>& greys) {
            std::vector<FilmAppearance> films;
            for (const int grey : greys) {
                films.push_back({film(), QImage(210, 297, QImage::Format_RGBA8888)});
                films.back().image.fill(QColor(grey, grey, grey));
            }
            const RefinedMesh fine(sphereMesh(35, 60, 120), 2);
            InkSettings ink;
            ink.compensate = false;
            const PaintedBody paint(films, ink, {}, &fine);
            const PoseView view{film()->body(), fine, paint};
            return posePicture(view, PoseSide::Below, {100, 100}, {})
                .image.pixelColor(50, 50)
                .red();
        };
        const int both =
            qRound(255 * srgbFromLinear(linearFromSrgb(200 / 255.0) * linearFromSrgb(150 / 255.0)));
        QVERIFY(std::abs(shownBelow({200, 150}) - shownBelow({both})) <= 1);
        QVERIFY(shownBelow({200, 150}) < shownBelow({150}) - 20);
    }
};

QTEST_MAIN(TravellerTest)
#include "TravellerTest.moc"
