// Artwork in the project's file: it is kept, invalid artwork is refused, and a project without
// artwork has no entry.
#include "SampleProject.h"
#include "artwork/EditArtwork.h"
#include "base/Error.h"
#include "project/ProjectStore.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QtTest>

using namespace dipwright;
using namespace dipwright::test;

namespace {

QImage dots(const QColor& colour) {
    QImage image(7, 5, QImage::Format_RGBA8888);
    image.fill(Qt::transparent);
    image.setPixelColor(3, 2, colour);
    return image;
}

Project decorated() {
    Project project = sampleProject();
    project.artwork.base = QColor(1, 2, 3);
    ArtworkLayer picture = newLayer(LayerKind::Picture, QStringLiteral("Logo"));
    picture.picture = artworkPicture(dots(Qt::red));
    picture.place = {Millimetres(1.5), Millimetres(-2), Millimetres(3)};
    picture.turn = Degrees(-30);
    picture.size = {Millimetres(12), Millimetres(8)};
    picture.opacity = 0.25;
    ArtworkLayer text = newLayer(LayerKind::Text, QStringLiteral("Words"));
    text.text = QStringLiteral("Grüße\n2");
    text.colour = QColor(9, 8, 7);
    text.placement = LayerPlacement::Plane;
    text.axis = LayerAxis::MinusY;
    text.visible = false;
    ArtworkLayer camouflage = newLayer(LayerKind::Camouflage, QStringLiteral("Pattern"));
    camouflage.seed = 17;
    ArtworkLayer again = picture;
    again.repeat = Millimetres(4);
    project.artwork.layers = {camouflage, picture, text, again};
    return project;
}

// Returns the place and message of the refusal; empty if the value is accepted.
QString refusalOf(const QString& key, const QJsonValue& value) {
    QJsonObject json = toJson(decorated());
    QJsonObject artwork = json.value(QLatin1String("artwork")).toObject();
    QJsonArray layers = artwork.value(QLatin1String("layers")).toArray();
    QJsonObject layer = layers.at(1).toObject();
    layer.insert(key, value);
    layers.replace(1, layer);
    artwork.insert(QStringLiteral("layers"), layers);
    json.insert(QStringLiteral("artwork"), artwork);
    try {
        fromJson(json, QStringLiteral("job.dipw"));
    } catch (const Error& error) {
        return error.where() + QStringLiteral(" ") + error.message();
    }
    return {};
}

} // namespace

class ArtworkFileTest : public QObject {
    Q_OBJECT

private slots:
    void toJson_withoutArtwork_omitsIt() {
        QVERIFY(!toJson(sampleProject()).contains(QLatin1String("artwork")));
    }

    void saveProject_artwork_isReadAgain() {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("job.dipw"));
        const Project project = decorated();
        saveProject(project, path);
        const Project read = loadProject(path);
        QCOMPARE(read.artwork, project.artwork);
        QCOMPARE(read.artwork.layers[1].picture.image, dots(Qt::red));
        QVERIFY(read.unknownEntries ==
                project.unknownEntries); // the layer's picture is not an unknown entry
        saveProject(read, path);
        QCOMPARE(loadProject(path).artwork, project.artwork);
    }

    void saveProject_samePictureTwice_isStoredOnce() {
        QTemporaryDir folder;
        const QString one = folder.filePath(QStringLiteral("one.dipw"));
        const QString two = folder.filePath(QStringLiteral("two.dipw"));
        Project project = decorated();
        QImage noise(200, 200, QImage::Format_RGBA8888);
        for (int k = 0; k < 40000; ++k) {
            noise.setPixelColor(k % 200, k / 200, QColor::fromRgb(QRgb(k) * 2654435761u));
        }
        project.artwork.layers.resize(2);
        project.artwork.layers[1].picture = artworkPicture(noise);
        saveProject(project, one);
        project.artwork.layers.push_back(project.artwork.layers[1]);
        saveProject(project, two);
        QVERIFY(QFileInfo(two).size() < QFileInfo(one).size() + 2000);
    }

    void fromJson_layerValueOutOfRange_isRefusedByPath_data() {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QJsonValue>("value");
        const auto row = [](const char* key, const QJsonValue& value) {
            QTest::addRow("%s %s", key, qPrintable(value.toVariant().toString()))
                << QString::fromLatin1(key) << value;
        };
        row("opacity", 1.5);
        row("opacity", -1);
        row("opacity", QStringLiteral("half"));
        row("kind", QStringLiteral("gold"));
        row("placement", 3);
        row("axis", QStringLiteral("w"));
        row("turn_deg", 1e9);
        row("repeat_mm", -1);
        row("repeat_mm", 1e300);
        row("seed", 0.5);
        row("colour", QStringLiteral("red"));
        row("colour", QStringLiteral("#12345"));
        row("second_colour", QStringLiteral("#1234567"));
        row("name", QString(5000, QLatin1Char('a')));
        row("text", QString(5000, QLatin1Char('a')));
        row("visible", 1);
        row("size_mm", QJsonArray{0, 10});
        row("size_mm", QJsonArray{10});
        row("place_mm", QJsonArray{1e10, 0, 0});
    }

    void fromJson_layerValueOutOfRange_isRefusedByPath() {
        QFETCH(QString, key);
        QFETCH(QJsonValue, value);
        const QString refusal = refusalOf(key, value);
        QVERIFY2(refusal.contains(QStringLiteral("artwork.layers[1].%1").arg(key)),
                 qPrintable(refusal));
    }

    void fromJson_layersThatAreNoList_areRefused() {
        for (const QJsonValue& layers :
             {QJsonValue(3), QJsonValue(QJsonArray{QJsonValue(1)}), QJsonValue(QJsonObject())}) {
            QJsonObject json = toJson(sampleProject());
            json.insert(QStringLiteral("artwork"), QJsonObject{{QStringLiteral("layers"), layers}});
            QVERIFY_EXCEPTION_THROWN(fromJson(json, QStringLiteral("job")), Error);
        }
        QJsonObject json = toJson(sampleProject());
        json.insert(QStringLiteral("artwork"), 7);
        QVERIFY_EXCEPTION_THROWN(fromJson(json, QStringLiteral("job")), Error);
        QJsonArray many;
        for (std::size_t k = 0; k <= mostArtworkLayers; ++k) {
            many.append(QJsonObject());
        }
        json.insert(QStringLiteral("artwork"), QJsonObject{{QStringLiteral("layers"), many}});
        QVERIFY_EXCEPTION_THROWN(fromJson(json, QStringLiteral("job")), Error);
    }

    void loadProject_missingLayerPicture_isRefused() {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("job.dipw"));
        Project project = decorated();
        project.artwork.layers[1].picture.image = {};
        project.artwork.layers[3].picture.image = {};
        saveProject(project, path);
        QVERIFY_EXCEPTION_THROWN(loadProject(path), Error);
    }

    // The import accepts models that lie farther away than 100 m.
    void saveProject_placesFarFromTheOrigin_canBeOpened() {
        Project project = decorated();
        const std::array<Millimetres, 3> far{Millimetres(150'000), Millimetres(-9e8),
                                             Millimetres(0)};
        project.artwork.layers[0].place = far;
        project.masks = {MaskMark()};
        project.masks[0].path = {BrushPoint{far, {0, 0, 1}}};
        project.tolerance.marks = {ZoneMark()};
        project.tolerance.marks[0].place = far;
        project.share.marks = {ShareMark()};
        project.share.marks[0].place = far;
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("far.dipw"));
        saveProject(project, path);
        const Project opened = loadProject(path);
        QVERIFY(opened.artwork.layers[0].place == far);
        QVERIFY(opened.masks[0].path[0].place == far);
        QVERIFY(opened.tolerance.marks[0].place == far);
        QVERIFY(opened.share.marks[0].place == far);
    }

    void setByPath_layerValues_areSet() {
        Project project = decorated();
        setByPath(project, QStringLiteral("artwork.layers[1].opacity"), QStringLiteral("0.75"));
        setByPath(project, QStringLiteral("artwork.layers[1].place_mm"), QStringLiteral("1;2;-3"));
        setByPath(project, QStringLiteral("artwork.base_colour"), QStringLiteral("null"));
        QCOMPARE(project.artwork.layers[1].opacity, 0.75);
        QCOMPARE(project.artwork.layers[1].place[2].value(), -3.0);
        QVERIFY(!project.artwork.base);
        for (const char* path : {"artwork.layers[9].opacity", "artwork.layers[0].picture",
                                 "artwork.layers", "artwork.layers[0].gloss", "artwork.colour"}) {
            QVERIFY_EXCEPTION_THROWN(
                setByPath(project, QString::fromLatin1(path), QStringLiteral("1")), Error);
        }
    }

    void toJson_spotInk_isKeptAndOmittedIfUnset() {
        Project project = decorated();
        const QJsonObject plain = toJson(project);
        QVERIFY(!QJsonDocument(plain).toJson().contains("spot"));
        setByPath(project, QStringLiteral("artwork.layers[0].spot"),
                  QStringLiteral("Gloss varnish"));
        setByPath(project, QStringLiteral("artwork.layers[0].spot_colour"),
                  QStringLiteral("#da291c"));
        setByPath(project, QStringLiteral("artwork.layers[0].spot_first"), QStringLiteral("true"));
        const ArtworkLayer& layer = project.artwork.layers[0];
        QCOMPARE(layer.spot, QStringLiteral("Gloss varnish"));
        QVERIFY(layer.spotFirst);
        const ArtworkLayer back =
            fromJson(toJson(project), QStringLiteral("job")).artwork.layers[0];
        QCOMPARE(back.spot, layer.spot);
        QCOMPARE(back.spotColour, layer.spotColour);
        QCOMPARE(back.spotFirst, true);
        QVERIFY_EXCEPTION_THROWN(
            setByPath(project, QStringLiteral("artwork.layers[0].spot"), QStringLiteral("Cyan")),
            Error);
        setByPath(project, QStringLiteral("artwork.layers[0].spot"), QString());
        QVERIFY(project.artwork.layers[0].spot.isEmpty());
    }
};

QTEST_MAIN(ArtworkFileTest)
#include "ArtworkFileTest.moc"
