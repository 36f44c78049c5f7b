// Tests `dipwright-cli pack`. Each piece on a packed film must equal the sheet that its job gives
// alone.
#include "BallModel.h"
#include "CliProcess.h"
#include "TestFolders.h"

#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

using dipwright::test::cli;
using dipwright::test::Outcome;

namespace {

const QString turtle = sampleFolder("/turtle.dipw");
const QStringList coarse{
    "--set", "film.points=41x58", "--set", "body.sdf_resolution=64", "--dpi", "100", "--quiet"};

QJsonArray filmsIn(const QString& folder) {
    QFile file(folder + QStringLiteral("/films.json"));
    file.open(QIODevice::ReadOnly);
    return QJsonDocument::fromJson(file.readAll()).object()["films"].toArray();
}

bool isWhite(QRgb pixel) {
    return (pixel & 0xffffff) == 0xffffff;
}

} // namespace

class PackCommandTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    void pack_filmsInFolder_refusesOptionsOfPrinting() {
        const QString out = folder_.filePath("unused");
        for (const char* option : {"--to", "--printer"}) {
            const Outcome packed = cli({"pack", turtle, "--out", out, option, "films.pdf"});
            QCOMPARE(packed.exitCode, 2);
            QVERIFY2(packed.err.contains("has no effect"), packed.err);
        }
        QVERIFY(!QFile::exists(out));
    }

    void pack_pieces_equalTheirSheets() {
        const QString out = folder_.filePath("films");
        const Outcome packed =
            cli(QStringList{"pack", turtle + ":2", "--out", out, "--film", "roll:400"} + coarse);
        QVERIFY2(packed.exitCode == 0, packed.err);
        QVERIFY2(packed.out.contains("Film 1: 400 × "), packed.out);
        QVERIFY2(packed.out.contains("Numerical error:"), packed.out);
        QVERIFY2(!packed.out.contains("NOT JUDGED"), packed.out);
        const Outcome run =
            cli(QStringList{"run", turtle, "--out", folder_.filePath("alone"), "--no-certainty"} +
                coarse);
        QVERIFY2(run.exitCode == 0, run.err);
        const QJsonArray films = filmsIn(out);
        QCOMPARE(films.size(), 1);
        const QJsonArray pieces = films[0].toObject()["pieces"].toArray();
        QCOMPARE(pieces.size(), 4);
        const QImage film = QImage(out + "/film-1.png").convertToFormat(QImage::Format_RGB32);
        const double unit = film.width() / 400.0;
        for (const QJsonValue& piece : pieces) {
            const QImage sheet =
                QImage(
                    folder_.filePath(
                        QStringLiteral("alone/immersion-%1/sheet.png").arg(piece["dip"].toInt())))
                    .convertToFormat(QImage::Format_RGB32);
            const auto at = [&](const char* key, int number) {
                return piece[QLatin1String(key)].toArray()[number].toDouble() * unit;
            };
            // The picture is horizontally centred in its box.
            const QSize size(int(std::lround(at("picture_mm", 0))),
                             int(std::lround(at("picture_mm", 1))));
            const QImage box =
                film.copy(int(std::lround(at("box_mm", 0))), int(std::lround(at("box_mm", 1))),
                          int(std::lround(at("box_mm", 2))), size.height() + 56);
            const QPoint own(int(std::lround(sheet.width() / 2.0 + at("picture_off_mm", 0) -
                                             size.width() / 2.0)),
                             int(std::lround(sheet.height() / 2.0 + at("picture_off_mm", 1) -
                                             size.height() / 2.0)));
            const QPoint there((box.width() - size.width()) / 2, 28); // 7 mm
            qsizetype inked = 0;
            for (int y = 0; y < size.height(); ++y) {
                for (int x = 0; x < size.width(); ++x) {
                    const QRgb pixel = sheet.pixel(own + QPoint(x, y));
                    inked += !isWhite(pixel);
                    QCOMPARE(box.pixel(there + QPoint(x, y)), pixel);
                }
            }
            QVERIFY(inked > 10000);
        }
        for (const char* name : {"/film-1.pdf", "/film-1.tif"}) {
            QVERIFY(QFileInfo(out + QLatin1String(name)).size() > 10000);
        }
    }

    void pack_fewerFilms_removesEarlierFilms() {
        const QString out = folder_.filePath("fewer");
        const auto pack = [&](const QString& copies) {
            return cli(QStringList{"pack", turtle + copies, "--out", out, "--film", "A3"} + coarse);
        };
        QCOMPARE(pack(":3").exitCode, 0);
        QVERIFY(QFile::exists(out + "/film-2.pdf"));
        QCOMPARE(pack({}).exitCode, 0);
        QVERIFY(QFile::exists(out + "/film-1.pdf") && !QFile::exists(out + "/film-2.pdf"));
    }

    void pack_severalFilmsToFile_areNumbered() {
        const Outcome packed = cli(QStringList{"pack", turtle + ":3", "--to",
                                               folder_.filePath("films.pdf"), "--film", "A3"} +
                                   coarse);
        QVERIFY2(packed.exitCode == 0, packed.err);
        QVERIFY(QFile::exists(folder_.filePath("films-1.pdf")));
        QVERIFY(QFile::exists(folder_.filePath("films-2.pdf")));
        QVERIFY(!QFile::exists(folder_.filePath("films.pdf")));
        const Outcome fewer =
            cli(QStringList{"pack", turtle, "--to", folder_.filePath("films.pdf"), "--film", "A3"} +
                coarse);
        QVERIFY2(fewer.out.contains("films-2.pdf is from an earlier call"), fewer.out);
    }

    // The printer prints 2 % too small and does not reach the outer 12 mm.
    void pack_printerMargins_keepsPiecesInReach() {
        const QString profiles = "DIPWRIGHT_PROFILE_PATH=" + folder_.filePath("profiles");
        const Outcome set = cli({"profile", "set", "printer", "Narrow", "--set",
                                 "margins_mm=12x12x12x12", "--set", "scale=0.98;0.98"},
                                {profiles});
        QVERIFY2(set.exitCode == 0, set.err);
        const QString out = folder_.filePath("reach");
        const Outcome packed =
            cli(QStringList{"pack", turtle, "--profile", "Narrow", "--out", out, "--film", "A3"} +
                    coarse,
                {profiles});
        QVERIFY2(packed.exitCode == 0, packed.err);
        // At this scale, the drawing is cut off at 420 / 2 - (420 / 2 - 12) * 0.98 mm.
        const QSizeF film(297, 420);
        const double x = film.width() / 2 - (film.width() / 2 - 12) * 0.98;
        const double y = film.height() / 2 - (film.height() / 2 - 12) * 0.98;
        const QRectF reach = QRectF({0, 0}, film).adjusted(x, y, -x, -y);
        const QJsonArray pieces = filmsIn(out)[0].toObject()["pieces"].toArray();
        QVERIFY(!pieces.isEmpty());
        for (const QJsonValue& piece : pieces) {
            const QJsonArray box = piece["box_mm"].toArray();
            QVERIFY(reach.contains(QRectF(box[0].toDouble(), box[1].toDouble(), box[2].toDouble(),
                                          box[3].toDouble())));
        }
    }

    void pack_whiteLayerToFolder_isToldToBeLeftOut() {
        const QStringList pack =
            QStringList{"pack", turtle, "--out", folder_.filePath("white"), "--film", "A3"} +
            coarse;
        QVERIFY(!cli(pack).out.contains("white layer is left out"));
        const Outcome told = cli(pack + QStringList{"--set", "sheet.white=last"});
        QVERIFY2(told.out.contains("white layer is left out"), told.out + told.err);
    }

    void pack_jobsForOtherSheets_areRefusedBeforeTheDips_data() {
        QTest::addColumn<QString>("setting");
        QTest::addColumn<QString>("says");
        QTest::newRow("cut contour") << "sheet.cut_line=ink"
                                     << "“Cut contour” differs between this job and plain";
        QTest::newRow("swell") << "film.swell=1.05x1.05"
                               << "differently from that of plain";
        QTest::newRow("relaxation") << "film.relaxation_time_s=3"
                                    << "differently from that of plain";
        QTest::newRow("printer") << ""
                                 << "another printer profile than plain";
    }
    // A solver that does not exist shows that the refusal comes before the dips.
    void pack_jobsForOtherSheets_areRefusedBeforeTheDips() {
        QFETCH(QString, setting);
        QFETCH(QString, says);
        const QStringList profiles{"DIPWRIGHT_PROFILE_PATH=" + folder_.filePath("profiles")};
        const QString model = dipwright::test::writeBall(folder_.path());
        const QString plain = folder_.filePath("plain.dipw"), other = folder_.filePath("o.dipw");
        const QStringList make{"--model", model};
        QCOMPARE(cli(QStringList{"new", plain} + make).exitCode, 0);
        if (setting.isEmpty()) {
            QCOMPARE(cli(QStringList{"new", other} + make).exitCode, 0);
            QCOMPARE(cli({"profile", "set", "printer", "Small"}, profiles).exitCode, 0);
            QCOMPARE(cli({"profile", "use", "printer", "Small", other}, profiles).exitCode, 0);
        } else {
            QCOMPARE(cli(QStringList{"new", other, "--set", setting} + make).exitCode, 0);
        }
        const Outcome packed = cli({"pack", plain, other, "--to", folder_.filePath("other.pdf"),
                                    "--solver", "missing", "--quiet"});
        QCOMPARE(packed.exitCode, 1);
        QVERIFY2(packed.err.contains(says.toUtf8()), packed.err);
    }

    void pack_wrongNumberOfCopies_isRefused() {
        const QString out = folder_.filePath("copies");
        for (const char* copies : {":0", ":-1", ":1e3", ":2001", ":99999999999", ":"}) {
            const Outcome packed =
                cli({"pack", turtle + QLatin1String(copies), "--out", out, "--quiet"});
            QCOMPARE(packed.exitCode, 2);
            QVERIFY2(packed.err.contains("Give 1 to 2000 copies"), packed.err);
        }
        const Outcome missing = cli({"pack", "missing.dipw:3", "--out", out, "--quiet"});
        QVERIFY2(missing.err.contains("(missing.dipw)"), missing.err);
    }

    void pack_pieceTooLarge_isRefused() {
        const Outcome packed = cli(
            QStringList{"pack", turtle, "--out", folder_.filePath("small"), "--film", "100x100"} +
            coarse);
        QCOMPARE(packed.exitCode, 1);
        QVERIFY2(packed.err.contains("use a larger film"), packed.err);
        QVERIFY(!QFile::exists(folder_.filePath("small")));
    }
};

QTEST_MAIN(PackCommandTest)
#include "PackCommandTest.moc"
