// Tests cost and time of an order against calculations by hand, and the ink of a sheet with a known
// grey.
#include "TestProfiles.h"
#include "cost/CostText.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/Separation.h"

#include <QJsonArray>
#include <QtTest>

using namespace dipwright;

namespace {

// One A4 film for each of two dips; the second dip prints twice as much cyan.
OrderToCost order(int parts) {
    OrderToCost order;
    order.parts = parts;
    order.sheet = {0.21 * 0.297, 0.297, 1};
    order.film = {20.0, FilmPriceUnit::SquareMetre};
    order.work = {.labourRate = 60.0,
                  .setUp = 30.0,
                  .handling = 2.0,
                  .partsPerRack = 1,
                  .scrap = 0,
                  .currency = QStringLiteral("EUR")};
    for (const double area : {10'000.0, 20'000.0}) {
        DipCosts dip;
        dip.inks = {{QStringLiteral("Cyan"), area, 10, 150}};
        dip.soak = Seconds(60);
        dip.activator = Seconds(10);
        dip.motion = Seconds(50);
        dip.flash = Seconds(300);
        dip.drying = Seconds(3600);
        order.dips.push_back(dip);
    }
    return order;
}

const CostItem& item(const OrderCost& cost, CostKind kind) {
    return *std::find_if(cost.items.begin(), cost.items.end(),
                         [&](const CostItem& one) { return one.kind == kind; });
}

bool isNear(double value, double wanted, double share = 1e-9) {
    return std::abs(value - wanted) <= share * std::abs(wanted);
}

// Returns a sheet of 100 × 60 mm whose left half is grey.
Sheet greySheet(int grey) {
    Sheet sheet;
    sheet.filmWidth = Millimetres(100);
    sheet.filmHeight = Millimetres(60);
    QImage image(500, 300, QImage::Format_RGBA8888);
    image.fill(Qt::transparent);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width() / 2; ++x) {
            image.setPixelColor(x, y, QColor(grey, grey, grey));
        }
    }
    sheet.image = image;
    return sheet;
}

} // namespace

class OrderCostTest : public QObject {
    Q_OBJECT

private slots:
    void costOf_tenParts_agreesWithHandCalculation() {
        const OrderCost cost = costOf(order(10));
        QVERIFY(cost.isComplete());
        QCOMPARE(cost.sheets, 20);
        // 20 films of 0.06237 m² at 20 a square metre
        QVERIFY(isNear(*item(cost, CostKind::Film).cost(), 24.948));
        // 10 × 0.03 m² at 10 ml/m², at 150 a litre
        QVERIFY(isNear(*item(cost, CostKind::Ink).amount, 3.0));
        QVERIFY(isNear(*item(cost, CostKind::Ink).cost(), 0.45));
        // 30 min, and 10 × 2 dips of 2 min + 60 s + 10 s + 50 s
        QVERIFY(isNear(cost.work.value(), 1800 + 20 * 240));
        QVERIFY(isNear(*item(cost, CostKind::Labour).cost(), 110));
        QVERIFY(isNear(cost.known, 24.948 + 0.45 + 110));
    }

    void costOf_twoDips_dryWhileOthersAreDipped() {
        // One rack: each dip dries before the next.
        QVERIFY(isNear(costOf(order(1)).elapsed.value(), 1800 + 2 * (240 + 3900)));
        // Twenty racks: the first is dry before the last has its first dip.
        QVERIFY(isNear(costOf(order(20)).elapsed.value(), 1800 + 40 * 240 + 3900));
        // Ten racks wait for the first to dry.
        QVERIFY(isNear(costOf(order(10)).elapsed.value(), 1800 + 240 + 3900 + 10 * 240 + 3900));
    }

    void costOf_scrapAndRacks_multiplyEverything() {
        OrderToCost more = order(10);
        more.work.partsPerRack = 4;
        more.work.scrap = 0.25;
        const OrderCost cost = costOf(more);
        QCOMPARE(cost.racks, 4.0); // 3 good racks of 4
        QCOMPARE(racksOf(10, more.work), 4);
        QCOMPARE(cost.sheets, 8);
        QVERIFY(isNear(*item(cost, CostKind::Film).cost(), 8 * 0.06237 * 20));
        QVERIFY(isNear(cost.work.value(), 1800 + 8 * 240));
    }

    void costOf_packedSheets_countTheirFilms() {
        OrderToCost packed = order(10);
        packed.packed = FilmAmount{0.5, 0.8, 2};
        QVERIFY(isNear(*item(costOf(packed), CostKind::Film).cost(), 10));
        packed.film = {5.0, FilmPriceUnit::RollMetre};
        QVERIFY(isNear(*item(costOf(packed), CostKind::Film).cost(), 4));
        packed.film = {1.5, FilmPriceUnit::Sheet};
        QVERIFY(isNear(*item(costOf(packed), CostKind::Film).cost(), 3));
        packed.packed->haveSheetPrice = false;
        QVERIFY(!item(costOf(packed), CostKind::Film).cost());
        QVERIFY(!costOf(packed).isComplete());
    }

    void costOf_missingPrice_isNamedAndNotCounted() {
        OrderToCost unknown = order(10);
        unknown.film.price.reset();
        for (DipCosts& dip : unknown.dips) {
            dip.inks.push_back({QStringLiteral("Varnish"), 5000, 0, 90});
            dip.drying.reset();
        }
        const OrderCost cost = costOf(unknown);
        QVERIFY(!cost.isComplete());
        QVERIFY(isNear(cost.known, 110.45));
        QCOMPARE(missingPrices(cost),
                 (QStringList{"no price for the film", "no amount in ml/m² for ink: Varnish"}));
        QCOMPARE(missingTimes(cost), QStringList{"no drying time"});
        QVERIFY(costSentence(cost).contains(QStringLiteral("no price for the film")));
        const QJsonObject json = costJson(cost);
        QVERIFY(json["items"].toArray().first().toObject()["cost"].isNull());
        QVERIFY(!json["complete"].toBool());
    }

    void inkAreas_grey_isTheTintTimesTheArea() {
        // 30 cm² of 55 % cyan, magenta and yellow each
        const std::vector<InkArea> inks = inkAreas(greySheet(115), {});
        QCOMPARE(inks.size(), std::size_t(3));
        QVERIFY(areEstimated(inks));
        for (const InkArea& ink : inks) {
            QVERIFY2(isNear(ink.area, 3000 * (1 - 115 / 255.0), 0.01), qPrintable(ink.ink));
        }
        // At 12 ml/m² this is 0.0198 ml.
        OrderToCost one;
        one.dips.push_back({{{inks[0].ink, inks[0].area, 12, 100}}, {}, {}, Seconds(1), {}, {}});
        QVERIFY(isNear(*item(costOf(one), CostKind::Ink).amount, 0.01976, 0.01));
    }

    void inkAreas_cmykPrinter_areThePlates() {
        const PrinterColour colour(simpleCmykProfile(0.002), RenderingIntent::RelativeColorimetric,
                                   false, QStringLiteral("inks.icc"));
        QImage pixel(1, 1, QImage::Format_RGB888);
        pixel.fill(QColor(115, 115, 115));
        const QByteArray tints = colour.cmyk(pixel);
        Sheet sheet = greySheet(115);
        QImage white(sheet.image.size(), QImage::Format_Grayscale8);
        white.fill(51); // 20 %
        sheet.plates.push_back({QStringLiteral("White"), white, true});
        const std::vector<InkArea> inks = inkAreas(sheet, {.colour = &colour});
        QCOMPARE(inks.size(), std::size_t(5));
        QVERIFY(!areEstimated(inks));
        QVERIFY(inks[0].isWhite);
        QVERIFY(isNear(inks[0].area, 6000 * 0.2, 0.01));
        for (int ink = 0; ink < 4; ++ink) {
            const double wanted = 3000 * uchar(tints[ink]) / 255.0;
            QVERIFY2(std::abs(inks[std::size_t(ink) + 1].area - wanted) <= 0.01 * wanted,
                     qPrintable(inks[std::size_t(ink) + 1].ink));
        }
    }

    void costCsv_names_areQuoted() {
        const QString csv =
            QString::fromUtf8(costCsv({{QStringLiteral("Knob, \"left\""), {costOf(order(2))}}}));
        const QStringList lines = csv.split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines[0],
                 QStringLiteral("project,parts,kind,name,amount,unit,price,cost,currency"));
        QCOMPARE(lines[1],
                 QStringLiteral("\"Knob, \"\"left\"\"\",2,film,,0.24948,m2,20,4.9896,EUR"));
        QVERIFY(lines.last().contains(QStringLiteral(",sum,")));
    }

    void durationText_usesTwoUnitsAtMost() {
        QCOMPARE(durationText(Seconds(44.6)), QStringLiteral("45 s"));
        QCOMPARE(durationText(Seconds(600)), QStringLiteral("10 min"));
        QCOMPARE(durationText(Seconds(4800)), QStringLiteral("1 h 20 min"));
        QCOMPARE(durationText(Seconds(200'000)), QStringLiteral("2 days 8 h"));
    }
};

QTEST_GUILESS_MAIN(OrderCostTest)
#include "OrderCostTest.moc"
