// Tests `inspect fit` and `inspect built` through the command line. The input is a job, photos of a
// dipped part, and tables of places in the photos.
#include "../../core/inspection/PhotographedPart.h"
#include "CliProcess.h"
#include "TestFiles.h"
#include "TestFolders.h"
#include "project/ProjectFile.h"
#include "project/ProjectStore.h"
#include "solver/SolverRegistry.h"

#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

using namespace dipwright;
using namespace dipwright::test;

namespace {

const Hidden hidden{1.03, 1.03, std::numeric_limits<double>::infinity(), 1.2, -0.8, 0};

QByteArray joined(const std::vector<double>& numbers) {
    QByteArray line;
    for (const double number : numbers) {
        line += (line.isEmpty() ? "" : ",") + QByteArray::number(number, 'f', 5);
    }
    return line + "\n";
}

} // namespace

class InspectDippedTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        QVERIFY(folder_.isValid());
        qputenv("DIPWRIGHT_PROFILE_PATH", path("profiles").toLocal8Bit());
        const SolverRegistry registry{QStringList{pluginFolder()}};
        const PhotographedPart part(eggToFit(1, 2.6), hidden, 2.6,
                                    registry.module(QStringLiteral("pbd-cpu")));
        const auto cameras = camerasAround({{20, -35}, {140, -30}}, 280, 3.4, 2000);
        const FitPairs pairs = part.pairs(cameras, 16, 12, 0.3, 1);
        saveProject(part.project(), path("job.dipw"));
        QByteArray body("photo,x_px,y_px,x_mm,y_mm,z_mm\n");
        for (const PlacePair& pair : pairs.body) {
            body += joined({pair.photo + 1.0, pair.pixel.x(), pair.pixel.y(), pair.model.x(),
                            pair.model.y(), pair.model.z()});
        }
        QByteArray places("photo,x_px,y_px,dip,sheet_x_mm,sheet_y_mm,x_mm,y_mm,z_mm\n");
        for (const PrintedPlace& place : pairs.printed) {
            places +=
                joined({place.photo + 1.0, place.pixel.x(), place.pixel.y(), 1, place.sheet.x(),
                        place.sheet.y(), place.model.x(), place.model.y(), place.model.z()});
        }
        writeFile(path("pairs.csv"), body);
        writeFile(path("places.csv"), places);
        QImage photo(pairs.picture, QImage::Format_Grayscale8);
        photo.fill(128);
        QVERIFY(photo.save(path("1.png")));
        photo.fill(129); // the same photo twice is refused
        QVERIFY(photo.save(path("2.png")));
    }

    // Each place of a copied photo would count twice.
    void inspect_samePhotoTwice_isRefused() {
        QVERIFY(QFile::copy(path("1.png"), path("copy.png")));
        for (const QStringList& with :
             {words("part", {"--keep-camera"}), words("fit", {"--fit", "shift_x"}),
              words("built", {"--accepted-by", "Ada"})}) {
            QStringList copied = with;
            copied.replaceInStrings(path("2.png"), path("copy.png"));
            const Outcome outcome = cli(copied);
            QCOMPARE(outcome.exitCode, 1);
            QCOMPARE(outcome.errorLines().size(), 1);
            QVERIFY2(outcome.err.contains("The photo is the same as"), outcome.err.constData());
            QVERIFY2(outcome.err.contains("1.png") && outcome.err.contains("copy.png"),
                     outcome.err.constData());
        }
    }

    void inspect_invalidInput_isRefusedInOneSentence() {
        QCOMPARE(cli({"inspect", "fit", path("1.png"), "--out", path("no")}).exitCode, 2);
        QCOMPARE(cli(words("fit", {"--fit", "weather"})).exitCode, 2);
        const Outcome depth = cli(words("fit", {"--fit", "depth"}));
        QCOMPARE(depth.exitCode, 1);
        QCOMPARE(depth.errorLines().size(), 1);
        QVERIFY(depth.err.contains("moves none of the places"));
        QCOMPARE(cli(words("built", {})).exitCode, 2); // --accepted-by is missing
        {
            const ProjectFile other(path("job.dipw"));
            const Outcome refused = cli(
                words("built", {"--accepted-by", "Ada", "--date", "2026-11-22", "--update-job"}));
            QCOMPARE(refused.exitCode, 1);
            QVERIFY2(refused.err.contains("open elsewhere"), refused.err.constData());
        }
        QVERIFY(!QFileInfo::exists(path("out")));
    }

    void inspectFit_placesMistakenForOthers_isRefusedAndNotSaved() {
        const QByteArray job = bytesOf(path("job.dipw"));
        QStringList with = words("fit", {"--fit", "shift_x,shift_z", "--update-job"});
        usePlaces(with, [](QList<QByteArray>& cells, int row) {
            cells[4] = QByteArray::number(cells[4].toDouble() + 4 * (row % 3 - 1));
            cells[5] = QByteArray::number(cells[5].toDouble() + 4 * (row % 2));
        });
        const Outcome outcome = cli(with);
        QCOMPARE(outcome.exitCode, 1);
        QCOMPARE(outcome.errorLines().size(), 1);
        QVERIFY2(outcome.err.contains("does not explain"), outcome.err.constData());
        QCOMPARE(bytesOf(path("job.dipw")), job);
    }

    void inspectBuilt_sheetReadUpwards_isRefusedAndNotSaved() {
        const QByteArray job = bytesOf(path("job.dipw"));
        QStringList with =
            words("built", {"--accepted-by", "Ada", "--correct", "1", "--update-job"});
        usePlaces(with, [](QList<QByteArray>& cells, int) {
            cells[5] = QByteArray::number(-cells[5].toDouble());
        });
        const Outcome outcome = cli(with);
        QCOMPARE(outcome.exitCode, 1);
        QCOMPARE(outcome.errorLines().size(), 1);
        QVERIFY2(outcome.err.contains("sheet_y_mm has the other sign"), outcome.err.constData());
        QCOMPARE(bytesOf(path("job.dipw")), job);
    }

    // Tables of a part that is a tenth larger.
    void inspectBuilt_tableOfAnotherPart_isRefusedAndNotSaved() {
        const QByteArray job = bytesOf(path("job.dipw"));
        for (const QString& table : {path("places.csv"), path("pairs.csv")}) {
            QStringList with = words("built", {"--accepted-by", "Ada", "--update-job"});
            useTable(with, table, [](QList<QByteArray>& cells, int) {
                for (qsizetype cell = cells.size() - 3; cell < cells.size(); ++cell) {
                    cells[cell] = QByteArray::number(1.1 * cells[cell].toDouble());
                }
            });
            const Outcome outcome = cli(with);
            QCOMPARE(outcome.exitCode, 1);
            QCOMPARE(outcome.errorLines().size(), 1);
            QVERIFY2(outcome.err.contains("from the surface of the job's model"),
                     outcome.err.constData());
            QCOMPARE(bytesOf(path("job.dipw")), job);
        }
    }

    void inspectBuilt_acceptedPart_correctsNextSheet() {
        const Outcome outcome = cli(words("built", {"--accepted-by", "Ada", "--correct", "1",
                                                    "--date", "2026-11-22", "--update-job"}));
        QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
        qInfo("%s", outcome.out.constData());
        QVERIFY(!QImage(path("out/correction-1.png")).isNull());
        const AsBuilt built = loadProject(path("job.dipw")).asBuilt;
        QCOMPARE(built.parts.size(), std::size_t(1));
        QCOMPARE(built.parts.front().acceptedBy, QStringLiteral("Ada"));
        QCOMPARE(built.parts.front().photos.size(), 2 * 64 + 1);
        QVERIFY(std::abs(built.parts.front().residual - std::hypot(1.2, 0.8) / 1.03) < 0.1);
        QVERIFY(built.corrects);

        const QByteArray off = sheetOf("off", {"--set", "as_built.correct=false"});
        const QByteArray never =
            sheetOf("never", {"--set", "as_built.correct=false", "--set", "as_built.strength=0.5"});
        const QByteArray on = sheetOf("on", {});
        QVERIFY(!off.isEmpty() && off == never);
        QVERIFY(on != off);
        const QJsonObject dip = dipOf(path("on"));
        QCOMPARE(dip.value("corrected").toBool(), true);
        QCOMPARE(dip.value("parts").toInt(), 1);
        const QJsonArray shift = dip.value("shift_mm").toArray(); // of the body, seen on the sheet
        QVERIFY(std::abs(shift.at(0).toDouble() + hidden.shiftX / 1.03) < 0.15);
        QVERIFY(std::abs(shift.at(1).toDouble() + hidden.shiftZ / 1.03) < 0.15);

        const Outcome turned = cli({"run", path("job.dipw"), "--out", path("turned"), "--set",
                                    "immersions[0].rotation_deg=0;5;0"});
        QVERIFY2(turned.out.contains("The sheet is not corrected"), turned.out.constData());
        const QJsonObject other = dipOf(path("turned"));
        QCOMPARE(other.value("corrected").toBool(), false);
        QCOMPARE(other.value("parts_of_other_dips").toInt(), 1);
    }

    // One of the photos shows the part of the test before.
    void inspectBuilt_photoOfAKeptPart_isRefused() {
        QImage photo(path("2.png"));
        photo.fill(100);
        QVERIFY(photo.save(path("3.png")));
        QStringList with = words("built", {"--accepted-by", "Ada", "--update-job"});
        with.replaceInStrings(path("2.png"), path("3.png"));
        const Outcome outcome = cli(with);
        QCOMPARE(outcome.exitCode, 1);
        QVERIFY2(outcome.err.contains("already contains the part"), outcome.err.constData());
        QCOMPARE(loadProject(path("job.dipw")).asBuilt.parts.size(), std::size_t(1));
    }

    // The job corrects its sheets by the part of the first of these tests.
    void inspectFit_updateJobOfCorrectedSheets_isRefused() {
        const QByteArray job = bytesOf(path("job.dipw"));
        const Outcome refused = cli(words(
            "fit", {"--fit", "shift_x,shift_z", "--film-image", "chessboard", "--update-job"}));
        QCOMPARE(refused.exitCode, 1);
        QCOMPARE(refused.errorLines().size(), 1);
        QVERIFY2(refused.err.contains("correct the same error twice"), refused.err.constData());
        QCOMPARE(bytesOf(path("job.dipw")), job);
        Project uncorrected = loadProject(path("job.dipw"));
        uncorrected.asBuilt.corrects = false;
        saveProject(uncorrected, path("job.dipw"));
    }

    void inspectFit_updateJob_writesFittedOffset() {
        const Outcome outcome = cli(words(
            "fit", {"--fit", "shift_x,shift_z", "--update-job", "--profile", "Fitted", "--set"}));
        QCOMPARE(outcome.exitCode, 2); // `inspect fit` has no option --set
        const Outcome fitted =
            cli(words("fit", {"--fit", "shift_x,shift_z,swell_x,swell_y", "--film-image",
                              "chessboard", "--update-job", "--profile", "Fitted"}));
        QVERIFY2(fitted.exitCode == 0, fitted.err.constData());
        qInfo("%s", fitted.out.constData());
        const Immersion immersion = loadProject(path("job.dipw")).immersions.front();
        QVERIFY(std::abs(immersion.offset[0].value() - hidden.shiftX) < 0.1);
        QVERIFY(std::abs(immersion.offset[1].value() - hidden.shiftZ) < 0.1);
        QVERIFY(bytesOf(path("out/fit.json")).contains("\"correlation\""));
        QVERIFY(bytesOf(path("out/fit-places.csv")).count('\n') > 20);
        QVERIFY(cli({"profile", "show", "film", "Fitted"}).out.contains("\"swell_off\""));
    }

private:
    QString path(const QString& name) const { return folder_.filePath(name); }
    QStringList words(const QString& subject, const QStringList& more) const {
        const QStringList places = subject == QLatin1String("part")
                                       ? QStringList()
                                       : QStringList{"--places", path("places.csv")};
        return QStringList{"inspect",   subject,          path("1.png"), path("2.png"),
                           "--project", path("job.dipw"), "--pairs",     path("pairs.csv"),
                           "--out",     path("out")} +
               places + more;
    }
    template <typename Change>
    void usePlaces(QStringList& words, const Change& change) const {
        useTable(words, path("places.csv"), change);
    }
    // Changes each row of a table, counted from 2 below the header, and uses the changed table in
    // these words.
    template <typename Change>
    void useTable(QStringList& words, const QString& table, const Change& change) const {
        QByteArray changed;
        int row = 1;
        for (const QByteArray& line : bytesOf(table).trimmed().split('\n')) {
            QList<QByteArray> cells = line.split(',');
            if (row++ > 1) {
                change(cells, row - 1);
            }
            changed += cells.join(',') + '\n';
        }
        writeFile(path("changed.csv"), changed);
        words.replaceInStrings(table, path("changed.csv"));
    }
    // Returns what the report in this folder says of the parts of the first dip.
    static QJsonObject dipOf(const QString& folder) {
        const QJsonObject report =
            QJsonDocument::fromJson(bytesOf(folder + "/report.json")).object();
        return report.value("as_built").toObject().value("dips").toArray().at(0).toObject();
    }
    QByteArray sheetOf(const QString& name, const QStringList& more) const {
        const Outcome outcome =
            cli(QStringList{"run", path("job.dipw"), "--out", path(name), "--no-certainty"} + more);
        return outcome.exitCode == 0 ? bytesOf(path(name + "/immersion-1/sheet.png"))
                                     : QByteArray();
    }

    QTemporaryDir folder_;
};

QTEST_MAIN(InspectDippedTest)
#include "InspectDippedTest.moc"
