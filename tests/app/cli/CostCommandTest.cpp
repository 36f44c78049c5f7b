// Tests `dipwright-cli cost`: prices come from the profiles, an order may share films, and the
// table has every item.
#include "CliProcess.h"
#include "TestFolders.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

using dipwright::test::cli;
using dipwright::test::Outcome;

namespace {

const QStringList coarse{"--set", "film.points=41x58", "--set",  "body.sdf_resolution=64",
                         "--set", "sheet.dpi=60",      "--quiet"};

QJsonObject costIn(const QByteArray& json, int order) {
    return QJsonDocument::fromJson(json)
        .object()["projects"]
        .toArray()[0]
        .toObject()["costs"]
        .toArray()[order]
        .toObject();
}

} // namespace

class CostCommandTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString job_;
    QStringList environment_;

private slots:
    void initTestCase() {
        environment_ = {"DIPWRIGHT_PROFILE_PATH=" + folder_.filePath("profiles")};
        job_ = folder_.filePath("job.dipw");
        QVERIFY(QFile::copy(sampleFolder("/sphere.dipw"), job_));
        const auto set = [&](const QStringList& words) {
            const Outcome done = cli(QStringList{"profile"} + words, environment_);
            QVERIFY2(done.exitCode == 0, done.err);
        };
        set({"set", "film", "Roll", "--set", "size_mm=210x297", "--set", "cost.film_price=20"});
        set({"set", "tank", "Bench", "--set", "cost.labour_per_h=60", "--set", "cost.setup_min=30",
             "--set", "cost.handling_min=2", "--set", "cost.currency=EUR"});
        set({"set", "printer", "Jet", "--set", "cost.ink_ml_per_m2=10x10x10x10", "--set",
             "cost.ink_price_per_l=150x150x0x150"});
        for (const QStringList& use :
             {QStringList{"film", "Roll"}, {"tank", "Bench"}, {"printer", "Jet"}}) {
            set(QStringList{"use"} + use + QStringList{job_});
        }
    }

    void cost_order_isPricedByTheProfiles() {
        const QString table = folder_.filePath("cost.csv");
        QFile dips(folder_.filePath("job.dips")); // damaged
        QVERIFY(dips.open(QIODevice::WriteOnly) && dips.write("no zip") > 0);
        dips.close();
        const Outcome json =
            cli(QStringList{"cost", job_, "--parts", "10", "--json", "--csv", table} + coarse,
                environment_);
        QVERIFY2(json.exitCode == 0, json.err);
        QCOMPARE(json.err.count("warning: "), 1);
        QVERIFY2(json.err.contains("cached dips is damaged"), json.err);
        QVERIFY(dips.remove());
        const QJsonObject one = costIn(json.out, 0), ten = costIn(json.out, 1);
        QCOMPARE(one["parts"].toInt(), 1);
        QCOMPARE(ten["parts"].toInt(), 10);
        QCOMPARE(ten["currency"].toString(), QStringLiteral("EUR"));
        const QJsonArray items = ten["items"].toArray();
        QCOMPARE(items[0].toObject()["amount"].toDouble(), 0.06237 * ten["sheets"].toInt());
        QVERIFY(items[1].toObject()["cost"].toDouble() > 0); // cyan
        QVERIFY(items[3].toObject()["cost"].isNull());       // yellow has no price
        QVERIFY(!ten["complete"].toBool());
        QVERIFY(ten["missing"].toArray().contains(QStringLiteral("no price for ink: Yellow")));
        // The set-up is done once.
        QVERIFY(ten["work_s"].toDouble() < 10 * one["work_s"].toDouble() - 8 * 1800);
        QFile file(table);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray csv = file.readAll();
        QVERIFY2(csv.contains(",10,ink,Yellow,"), csv);
        QVERIFY2(csv.contains(",1,labour,,"), csv);
    }

    void cost_priceOfASheet_isNotThatOfOtherFilms() {
        const QString job = folder_.filePath("sheets.dipw");
        QVERIFY(QFile::copy(job_, job));
        QCOMPARE(cli({"profile", "set", "film", "Sheets", "--set", "size_mm=210x297", "--set",
                      "cost.film_price=2", "--set", "cost.film_price_per=sheet"},
                     environment_)
                     .exitCode,
                 0);
        QCOMPARE(cli({"profile", "use", "film", "Sheets", job}, environment_).exitCode, 0);
        const auto film = [&](const QString& size) {
            const Outcome json =
                cli(QStringList{"cost", job, "--json", "--film", size} + coarse, environment_);
            return costIn(json.out, 0)["items"].toArray()[0].toObject();
        };
        const QJsonObject own = film("A4");
        QCOMPARE(own["cost"].toDouble(), 2 * own["amount"].toDouble());
        for (const char* size : {"A3", "roll:600"}) {
            QVERIFY2(film(size)["amount"].toDouble() > 0 && film(size)["cost"].isNull(), size);
        }
    }

    void cost_packedFilm_takesLessFilm() {
        const auto film = [&](const QStringList& options) {
            const Outcome json =
                cli(QStringList{"cost", job_, "--parts", "6", "--json"} + options + coarse,
                    environment_);
            const int last = QJsonDocument::fromJson(json.out)
                                 .object()["projects"]
                                 .toArray()[0]
                                 .toObject()["costs"]
                                 .toArray()
                                 .size() -
                             1;
            return costIn(json.out, last)["items"].toArray()[0].toObject()["amount"].toDouble();
        };
        const double alone = film({}), packed = film({"--film", "roll:600"});
        QVERIFY2(packed > 0 && packed < 0.9 * alone,
                 qPrintable(QStringLiteral("%1 and %2 m²").arg(packed).arg(alone)));
    }

    void cost_wrongNumber_isRefused() {
        QCOMPARE(cli({"cost", job_, "--parts", "0"}, environment_).exitCode, 2);
    }
};

QTEST_GUILESS_MAIN(CostCommandTest)
#include "CostCommandTest.moc"
