// Tests `dipwright-cli artwork`: adding, changing and printing a project's artwork.
#include "CliProcess.h"
#include "TestFolders.h"

#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace dipwright;
using namespace dipwright::test;

class ArtworkCommandTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        QFile::remove(job_);
        QVERIFY(QFile::copy(sampleFolder("/sphere.dipw"), job_));
        QVERIFY(QFile::setPermissions(job_, QFile::ReadOwner | QFile::WriteOwner));
        QImage logo(40, 20, QImage::Format_RGB32);
        logo.fill(Qt::red);
        QVERIFY(logo.save(logo_));
    }

    void artwork_addSetMoveRemove_changeLayers() {
        QVERIFY(artwork({"add", job_, "carbon", "--set", "repeat_mm=6"}));
        QVERIFY(artwork({"add", job_, "picture", logo_, "--set", "size_mm=20;10"}));
        QVERIFY(artwork({"add", job_, "text", "Nr. 7", "--set", "colour=#ff0000"}));
        QVERIFY(!artwork({"add", job_, "text", " "})); // a blank layer prints nothing
        QVERIFY(artwork({"base", job_, "#102030"}));
        QCOMPARE(names(), QStringList({"carbon", "logo", "Nr. 7"}));
        QCOMPARE(layer(0)["repeat_mm"].toDouble(), 6.0);
        QCOMPARE(layer(1)["size_mm"].toArray().at(0).toDouble(), 20.0);
        QCOMPARE(layer(2)["text"].toString(), QStringLiteral("Nr. 7"));
        QCOMPARE(listed()["base_colour"].toString(), QStringLiteral("#102030"));
        QVERIFY(artwork({"move", job_, "1", "3"}));
        QCOMPARE(names(), QStringList({"logo", "Nr. 7", "carbon"}));
        QVERIFY(artwork({"set", job_, "2", "--set", "turn_deg=-15", "--set", "name=Number"}));
        QCOMPARE(layer(1)["turn_deg"].toDouble(), -15.0);
        QVERIFY(artwork({"remove", job_, "3"}));
        QCOMPARE(names(), QStringList({"logo", "Number"}));
        QVERIFY(cli({"artwork", "list", job_}).out.contains("Number"));
    }

    // The axis of a cylinder begins in the middle of the part, a decal on its front.
    void artworkAdd_placement_decidesWhereTheLayerBegins() {
        QVERIFY(artwork({"add", job_, "picture", logo_}));
        QVERIFY(artwork({"add", job_, "picture", logo_, "--set", "placement=cylinder"}));
        const auto depth = [&](int index) { return layer(index)["place_mm"][2].toDouble(); };
        QVERIFY(depth(0) > depth(1) + 20);
        QVERIFY(artwork({"set", job_, "1", "--set", "placement=cylinder"}));
        QCOMPARE(depth(0), depth(1));
        QVERIFY(artwork({"set", job_, "1", "--set", "placement=box", "--set", "place_mm=0;0;5"}));
        QCOMPARE(depth(0), 5.0);
    }

    // A picture in an unread colour space is reported at once, and only for its own layer, although
    // another layer's picture has the same pixels.
    void artwork_pictureWithNote_isToldForItsLayerOnly() {
        QFile plain(logo_);
        QVERIFY(plain.open(QIODevice::ReadOnly));
        constexpr int signatureAndHeader = 33; // bytes
        QFile noted(folder_.filePath("p3.png"));
        QVERIFY(noted.open(QIODevice::WriteOnly));
        noted.write(plain.readAll().insert(signatureAndHeader, QByteArray::fromHex("00000004"
                                                                                   "63494350"
                                                                                   "0c0d0001"
                                                                                   "6e03e3ef")));
        noted.close();
        const QByteArray note = "names its colour space in a cICP chunk";
        QVERIFY(!cli({"artwork", "add", job_, "picture", logo_}).out.contains(note));
        QVERIFY(cli({"artwork", "add", job_, "picture", noted.fileName()}).out.contains(note));
        const QByteArray validated = cli({"validate", job_}).out;
        QCOMPARE(validated.count(note), 1);
        QVERIFY(validated.contains("p3"));
    }

    void artwork_invalidArguments_leaveFileUnchanged() {
        QVERIFY(artwork({"add", job_, "wood"}));
        QFile file(job_);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray before = file.readAll();
        for (const QStringList& words :
             {QStringList{"add", job_, "gold"}, QStringList{"add", job_, "picture"},
              QStringList{"add", job_, "picture", job_}, QStringList{"remove", job_, "2"},
              QStringList{"remove", job_, "0"}, QStringList{"move", job_, "1", "x"},
              QStringList{"set", job_, "1", "--set", "opacity=7"},
              QStringList{"set", job_, "1", "--set", "gloss=1"},
              QStringList{"set", job_, "1", "--set", "picture=abc"},
              QStringList{"base", job_, "reddish"}, QStringList{"paint", job_}, QStringList{}}) {
            const Outcome refused = cli(QStringList{"artwork"} + words);
            QVERIFY2(refused.exitCode == 1 || refused.exitCode == 2, qPrintable(words.join(' ')));
            QCOMPARE(refused.errorLines().size(), 1);
        }
        file.seek(0);
        QCOMPARE(file.readAll(), before);
    }

    void run_withArtwork_sheetAndReportShowIt() {
        QVERIFY(artwork({"base", job_, "#ff0000"}));
        const QString out = folder_.filePath(QStringLiteral("out"));
        const Outcome run = cli({"run", job_, "--out", out, "--quiet", "--set", "film.points=40x56",
                                 "--set", "sheet.dpi=72"});
        QVERIFY2(run.exitCode == 0, run.err);
        const QImage sheet(out + QStringLiteral("/immersion-1/sheet.png"));
        const QColor middle = sheet.pixelColor(sheet.width() / 2, sheet.height() / 2);
        QVERIFY(middle.red() > middle.green() + 60);
        QFile report(out + QStringLiteral("/report.json"));
        QVERIFY(report.open(QIODevice::ReadOnly));
        QVERIFY(QJsonDocument::fromJson(report.readAll()).object().contains("artwork"));
    }

private:
    bool artwork(const QStringList& words) const {
        const Outcome done = cli(QStringList{"artwork"} + words);
        if (done.exitCode != 0) {
            qWarning() << done.err;
        }
        return done.exitCode == 0;
    }
    QJsonObject listed() const {
        return QJsonDocument::fromJson(cli({"artwork", "list", job_, "--json"}).out).object();
    }
    QJsonObject layer(int index) const { return listed()["layers"].toArray().at(index).toObject(); }
    QStringList names() const {
        QStringList names;
        for (const QJsonValue& one : listed()["layers"].toArray()) {
            names.append(one.toObject()["name"].toString());
        }
        return names;
    }

    QTemporaryDir folder_;
    QString job_ = folder_.filePath(QStringLiteral("job.dipw"));
    QString logo_ = folder_.filePath(QStringLiteral("logo.png"));
};

QTEST_GUILESS_MAIN(ArtworkCommandTest)
#include "ArtworkCommandTest.moc"
