// The project's document in JSON: its shape, what is refused, and how one value is set.
#include "SampleProject.h"

#include "base/Error.h"
#include "model/TexturedMesh.h"
#include "project/DipKeys.h"
#include "project/NewProject.h"
#include "project/ProjectValues.h"
#include "project/Schema.h"

#include <QJsonArray>
#include <QtTest>
#include <cmath>

using namespace dipwright;
using namespace dipwright::test;

namespace {

const QString file = QStringLiteral("job.dipw");

// Returns the message of the refusal; empty if `json` is read.
QString refusal(const QJsonObject& json) {
    try {
        fromJson(json, file);
    } catch (const Error& error) {
        return error.sentence();
    }
    return {};
}

QString refusal(const QString& path, const QString& value) {
    Project project = sampleProject();
    const Project before = project;
    try {
        setByPath(project, path, value);
    } catch (const Error& error) {
        return project == before ? error.sentence()
                                 : QStringLiteral("refused, but the project changed");
    }
    return {};
}

QJsonObject with(QJsonObject json, const QStringList& path, const QJsonValue& value) {
    if (path.size() == 1) {
        json.insert(path.first(), value);
    } else {
        json.insert(path.first(), with(json.value(path.first()).toObject(), path.mid(1), value));
    }
    return json;
}

double squareness(const FilmSettings& film) {
    return (film.width.value() / (film.columns - 1)) / (film.height.value() / (film.rows - 1));
}

} // namespace

class ProjectTest : public QObject {
    Q_OBJECT

private slots:
    void fromJson_readsWhatToJsonWrote() {
        const Project project = sampleProject();
        Project read = fromJson(toJson(project), file);
        QVERIFY(read.unknown.isEmpty());
        read.model = project.model;
        QVERIFY(read == project);
    }

    void toJson_infinity_isNull() {
        Project project = sampleProject();
        project.film.relaxationTime = Seconds(std::numeric_limits<double>::infinity());
        const QJsonObject json = toJson(project);
        QVERIFY(json["film"].toObject()["relaxation_time_s"].isNull());
        QVERIFY(std::isinf(fromJson(json, file).film.relaxationTime.value()));
    }

    void toJson_hasTheDocumentedShape() {
        const QJsonObject json = toJson(sampleProject());
        QCOMPARE(json["format"].toString(), QStringLiteral("dipwright-project"));
        QCOMPARE(json["version"].toInt(), 3);
        const QJsonObject film = json["film"].toObject();
        QCOMPARE(film["size_mm"].toArray(), (QJsonArray{150, 200.5}));
        QCOMPARE(film["points"].toArray(), (QJsonArray{61, 82}));
        QCOMPARE(film["lattice"].toString(), QStringLiteral("structural"));
        QCOMPARE(film["support"].toString(), QStringLiteral("none"));
        QCOMPARE(film["edges"].toObject()["left"].toString(), QStringLiteral("pinned"));
        QCOMPARE(film["edges"].toObject()["right"].toString(), QStringLiteral("free"));
        QCOMPARE(film["swell"].toArray(), (QJsonArray{1.05, 1.03}));
        QCOMPARE(film["relaxation_time_s"].toDouble(-1), 0.0);
        const QJsonObject process = json["process"].toObject();
        QCOMPARE(process["dip_speed_mm_s"].toDouble(), 7.5);
        QCOMPARE(process["iterations"].toInt(), 9);
        QCOMPARE(process["solver"].toString(), QStringLiteral("pbd-cpu"));
        QCOMPARE(json["body"].toObject()["sdf_resolution"].toInt(), 96);
        const QJsonObject top = json["immersions"].toArray().first().toObject();
        QCOMPARE(top["name"].toString(), QStringLiteral("Top"));
        QCOMPARE(top["rotation_deg"].toArray(), (QJsonArray{0, 45, 0.5}));
        QCOMPARE(top["offset_mm"].toArray(), (QJsonArray{1, -2}));
        QCOMPARE(json["model"].toObject()["unit_mm"].toDouble(), 25.4);
        QVERIFY(json["sheet"].isObject());
        QVERIFY(json["ink"].isObject());
    }

    void fromJson_dateAsAnyText_isKept() {
        QJsonObject file = toJson(Project());
        file[QLatin1String("created")] = "30.11.2026";
        QCOMPARE(fromJson(file, "file").date, "30.11.2026");
    }
    void fromJson_missingValues_areTheDefaults() {
        const QJsonObject json{{"format", "dipwright-project"},
                               {"version", 1},
                               {"immersions", QJsonArray{QJsonObject()}}};
        const Project project = fromJson(json, file);
        QVERIFY(project.film == FilmSettings());
        QVERIFY(project.process == ProcessSettings());
    }

    void toJson_unknownKeys_areKeptAtEveryLevel() {
        QJsonObject json = toJson(sampleProject());
        json = with(json, {"future"}, QJsonObject{{"a", 1}});
        json = with(json, {"film", "grain"}, "fine");
        json = with(json, {"film", "edges", "depth_mm"}, 3);
        QJsonArray immersions = json["immersions"].toArray();
        immersions[1] = with(immersions[1].toObject(), {"hook"}, QJsonArray{1, 2});
        json["immersions"] = immersions;
        Project project = fromJson(json, file);
        setByPath(project, "film.swell", "1.1x1.2");
        const QJsonObject written = toJson(project);
        QCOMPARE(written["future"].toObject()["a"].toInt(), 1);
        QCOMPARE(written["film"].toObject()["grain"].toString(), QStringLiteral("fine"));
        QCOMPARE(written["film"].toObject()["edges"].toObject()["depth_mm"].toInt(), 3);
        QCOMPARE(written["immersions"].toArray()[1].toObject()["hook"].toArray(),
                 (QJsonArray{1, 2}));
        QCOMPARE(written["film"].toObject()["swell"].toArray(), (QJsonArray{1.1, 1.2}));
    }

    void toJson_unknownKeysOfEntries_goWithTheEntry() {
        Project project = sampleProject();
        project.share.marks.resize(1);
        project.tolerance.marks.resize(1);
        project.masks.resize(1);
        project.artwork.layers.resize(1);
        project.asBuilt = {false, 1, {{}}, {{}}, {{}}};
        project.inspection.photos.resize(1);
        project.inspection.pairs.assign(1, {});
        project.filmOnWater.photos.resize(1);
        project.profiles.tank.emplace().name = QStringLiteral("Tank");
        QJsonObject json = toJson(project);
        for (const QStringList& path : {QStringList{"immersions"},
                                        {"share", "marks"},
                                        {"tolerance", "marks"},
                                        {"masks"},
                                        {"artwork", "layers"},
                                        {"as_built", "parts"},
                                        {"as_built", "places"},
                                        {"as_built", "times"},
                                        {"inspection", "photos"},
                                        {"inspection", "pairs"},
                                        {"inspection", "film", "photos"}}) {
            QJsonValue list = json;
            for (const QString& key : path) {
                list = list.toObject()[key];
            }
            QJsonArray entries = list.toArray();
            entries[0] = with(entries[0].toObject(), {"future"}, path.join(u'.'));
            json = with(json, path, entries);
        }
        json = with(json, {"profiles", "tank", "future"}, 7);
        json = with(json, {"artwork", "future"}, 8);
        Project read = fromJson(json, file);
        QCOMPARE(toJson(read), json);
        read.artwork.layers.insert(read.artwork.layers.begin(), ArtworkLayer());
        read.immersions.erase(read.immersions.begin());
        json = toJson(read);
        const QJsonArray layers = json["artwork"].toObject()["layers"].toArray();
        QVERIFY(!layers[0].toObject().contains("future"));
        QVERIFY(layers[1].toObject().contains("future"));
        QVERIFY(!json["immersions"].toArray()[0].toObject().contains("future"));
    }

    void fromJson_seamMarks_areReadOrRefusedByPath() {
        Project project = sampleProject();
        project.share.marks = {{ShareMarkKind::Second,
                                {Millimetres(1), Millimetres(-2.5), Millimetres(3)},
                                Millimetres(0)},
                               {ShareMarkKind::Allow, {}, Millimetres(7.25)}};
        const QJsonObject json = toJson(project);
        QCOMPARE(fromJson(json, file).share, project.share);
        const QJsonArray marks = json["share"].toObject()["marks"].toArray();
        QCOMPARE(marks.size(), 2);
        QCOMPARE(marks[0].toObject()["kind"].toString(), QStringLiteral("second"));
        QVERIFY(refusal(with(json, {"share", "marks"}, 5)).contains("share.marks"));
        QJsonArray wrong = marks;
        wrong[1] = QJsonObject{{"kind", "other"}};
        QVERIFY(refusal(with(json, {"share", "marks"}, wrong)).contains("share.marks[1].kind"));
    }

    void fromJson_masks_areReadOrRefusedByPath() {
        Project project = sampleProject();
        QVERIFY(!toJson(project).contains("masks")); // as in older files
        QVERIFY(!countedSettings(project).contains("masks"));
        MaskMark stroke, face;
        stroke.path = {{{Millimetres(1), Millimetres(-2.5), Millimetres(3)}, {0, -0.6, 0.8}},
                       {{Millimetres(4), Millimetres(-2.5), Millimetres(3)}, {0, 0, 1}}};
        stroke.radius = Millimetres(2.5);
        face.extent = MarkExtent::Face;
        face.place = {Millimetres(1), Millimetres(2), Millimetres(3)};
        face.erases = true;
        project.masks = {stroke, face};
        const QJsonObject json = toJson(project);
        QVERIFY(fromJson(json, file).masks == project.masks);
        const QJsonArray marks = json["masks"].toArray();
        QCOMPARE(marks[0].toObject()["path"].toArray()[0].toArray(),
                 (QJsonArray{1, -2.5, 3, 0, -0.6, 0.8}));
        QCOMPARE(marks[1].toObject()["extent"].toString(), QStringLiteral("face"));
        const auto refusalOf = [&](const QJsonValue& mark) {
            return refusal(with(json, {"masks"}, QJsonArray{mark}));
        };
        QVERIFY(refusal(with(json, {"masks"}, 5)).contains("masks"));
        QVERIFY(refusalOf(QJsonObject{{"extent", "spot"}}).contains("masks[0].extent"));
        QVERIFY(refusalOf(QJsonObject{{"radius_mm", 0}}).contains("masks[0].radius_mm"));
        QVERIFY(refusalOf(QJsonObject{{"radius_mm", 1e9}}).contains("masks[0].radius_mm"));
        QVERIFY(refusalOf(QJsonObject{{"path", QJsonArray{QJsonArray{1, 2, 3}}}})
                    .contains("masks[0].path"));
        QVERIFY(refusalOf(QJsonObject{{"path", QJsonArray{QJsonArray{0, 0, 0, 0, 0, 7}}}})
                    .contains("normal"));
        QVERIFY(refusalOf(QJsonObject{{"path", QJsonArray{QJsonArray{0, 0, 1e10, 0, 0, 1}}}})
                    .contains("masks[0].path[0][2]"));
    }

    void fromJson_tooManyBrushPoints_isRefused() {
        const QJsonObject json = toJson(sampleProject());
        QJsonArray path;
        for (std::size_t point = 0; point < mostBrushPoints; ++point) {
            path.append(QJsonArray{0, 0, 0, 0, 0, 1});
        }
        QJsonArray marks;
        for (std::size_t stroke = 0; stroke <= mostBrushPointsOfAll / mostBrushPoints; ++stroke) {
            marks.append(QJsonObject{{"path", path}});
        }
        QVERIFY(refusal(with(json, {"masks"}, marks)).contains("50000"));
        path.append(QJsonArray{0, 0, 0, 0, 0, 1});
        QVERIFY(refusal(with(json, {"masks"}, QJsonArray{QJsonObject{{"path", path}}}))
                    .contains("masks[0].path"));
    }

    void setByPath_listOfMarks_isReadAsJson() {
        Project project = sampleProject();
        setByPath(project, "masks", R"([{"extent":"material","place_mm":[0,0,5]}])");
        QCOMPARE(project.masks.size(), std::size_t(1));
        QCOMPARE(project.masks[0].extent, MarkExtent::Material);
        setByPath(project, "tolerance.marks",
                  R"([{"zone":"B","extent":"stroke","radius_mm":3,"path":[[0,0,5,0,0,1]]}])");
        QCOMPARE(project.tolerance.marks[0].path.size(), std::size_t(1));
        QVERIFY_EXCEPTION_THROWN(setByPath(project, "masks", "face"), Error);
        QVERIFY_EXCEPTION_THROWN(setByPath(project, "masks", R"([{"extent":"spot"}])"), Error);
        QCOMPARE(project.masks.size(), std::size_t(1));
        QCOMPARE(refusal("masks", R"([{"radius_mm":3},{"extent":"stroke","radius":12}])"),
                 "An entry has no such key; its keys are extent, place_mm, radius_mm, erase, path, "
                 "material (masks[1].radius)");
        QVERIFY(refusal("tolerance.marks", R"([{"materiel":"Red"}])")
                    .contains("tolerance.marks[0].materiel"));
        QVERIFY(refusal("share.marks", R"([{"radius":3}])").contains("radius_mm"));
        QCOMPARE(project.masks.size(), std::size_t(1));
        setByPath(project, "masks", "[]");
        QVERIFY(project.masks.empty());
    }

    void fromJson_poseAims_areRead() {
        Project project = sampleProject();
        project.poseAims = {};
        QVERIFY(!toJson(project).contains("pose_search")); // as in older files
        project.poseAims.weights[Measure::TrappedAir] = 0;
        project.poseAims.zoneWeights[0] = 7.5;
        project.poseAims.limits[Measure::Coverage] = 0.9;
        const QJsonObject kept = toJson(project)["pose_search"].toObject();
        QCOMPARE(kept, (QJsonObject{{"weights", QJsonObject{{"trapped_air", 0}, {"zone_a", 7.5}}},
                                    {"limits", QJsonObject{{"coverage", 0.9}}}}));
        QVERIFY(fromJson(toJson(project), "x").poseAims == project.poseAims);
    }

    // Errors measured on a part hold for the same dip only.
    void dipKeys_whatADipDependsOn_changesThem() {
        Project project = sampleProject();
        project.process.depth.reset();
        project.immersions[1].rotation = {Degrees(0), Degrees(90), Degrees(0)};
        const QStringList keys = dipKeys(project);
        QCOMPARE(keys.size(), qsizetype(project.immersions.size()));
        Project read = fromJson(toJson(project), file);
        read.model = project.model;
        QCOMPARE(dipKeys(read), keys);
        const auto after = [&](const QString& path, const QString& value) {
            Project changed = project;
            setByPath(changed, path, value);
            return dipKeys(changed);
        };
        for (const auto& [path, value] :
             {std::pair("film.swell", "1.07x1.02"), std::pair("film.preset", "A3"),
              std::pair("film.growth_per_s", "0.0123"), std::pair("process.dip_speed_mm_s", "7.7"),
              std::pair("process.depth_mm", "12.5")}) {
            const QStringList others = after(QString::fromLatin1(path), QString::fromLatin1(value));
            QVERIFY2(others[0] != keys[0] && others[1] != keys[1], path);
        }
        for (const auto& [path, value] : {std::pair("immersions[1].rotation_deg", "0;180;0"),
                                          std::pair("immersions[1].offset_mm", "3x-4"),
                                          std::pair("immersions[1].path.kind", "slanted"),
                                          std::pair("immersions[1].path.turn_deg", "7")}) {
            const QStringList others = after(QString::fromLatin1(path), QString::fromLatin1(value));
            QVERIFY2(others[0] == keys[0] && others[1] != keys[1], path);
        }
        for (const auto& [path, value] :
             {std::pair("film.points", "40x50"), std::pair("process.solver", "pbd-cpu"),
              std::pair("process.contact_travel_cells", "0.1"), std::pair("sheet.dpi", "72"),
              std::pair("immersions[1].rotation_deg", "360;-270;0")}) {
            QCOMPARE(after(QString::fromLatin1(path), QString::fromLatin1(value)), keys);
        }
        auto otherModel = std::make_shared<TexturedMesh>(*project.model);
        otherModel->mesh.positions.front().x() += 1;
        project.model = otherModel;
        QVERIFY(dipKeys(project)[0] != keys[0]);
    }

    void dipKeys_valuesThatThePathDoesNotUse_doNotChangeThem() {
        Project project = sampleProject();
        const auto after = [&](const QString& name, const QString& value) {
            Project changed = project;
            setByPath(changed, QStringLiteral("immersions[0].path.") + name, value);
            return dipKeys(changed)[0];
        };
        const QString poses = QStringLiteral("0x0x0x0x0x0x0/8xnullx0x0x0x0x0");
        project.immersions[0].path.kind = PathKind::Tilt;
        project.immersions[0].path.heading = Degrees(30);
        QString key = dipKeys(project)[0];
        for (const auto& [name, value] :
             {std::pair("roll_radius_mm", QStringLiteral("7")),
              std::pair("slow_mm", QStringLiteral("9")), std::pair("keys", poses),
              std::pair("heading_deg", QStringLiteral("-330"))}) {
            QCOMPARE(after(QString::fromLatin1(name), value), key);
        }
        for (const char* name : {"heading_deg", "level_depth_mm", "turn_deg", "angle_deg",
                                 "slow_speed_mm_s", "water_speed_mm_s", "acceleration_mm_s2"}) {
            QVERIFY2(after(QString::fromLatin1(name), QStringLiteral("8")) != key, name);
        }
        project.immersions[0].path.kind = PathKind::Poses;
        setByPath(project, QStringLiteral("immersions[0].path.keys"), poses);
        key = dipKeys(project)[0];
        for (const char* name : {"heading_deg", "level_depth_mm", "turn_deg", "angle_deg",
                                 "slow_speed_mm_s", "roll_radius_mm"}) {
            QCOMPARE(after(QString::fromLatin1(name), QStringLiteral("8")), key);
        }
        QVERIFY(after(QStringLiteral("water_speed_mm_s"), QStringLiteral("8")) != key);
    }

    void partsDippedAlike_partsOfOtherDips_areLeftOut() {
        Project project = sampleProject();
        project.asBuilt.parts.assign(3, {});
        project.asBuilt.places.clear();
        for (int part = 1; part <= 3; ++part) {
            for (const int dip : {1, 2}) {
                project.asBuilt.places.push_back({part, dip, {}, {}, {}});
            }
        }
        const QStringList keys = dipKeys(project);
        project.asBuilt.parts[0].dips = keys.join(u' ');
        project.asBuilt.parts[1].dips = keys[0] + QStringLiteral(" 0123456789abcdef");
        const AsBuilt alike = partsDippedAlike(project); // nothing is known about the third part
        QCOMPARE(alike.places.size(), std::size_t(5));
        QVERIFY(countParts(project.asBuilt, 1, keys) == BuiltPartCounts({2, 1, 0}));
        QVERIFY(countParts(project.asBuilt, 2, keys) == BuiltPartCounts({1, 1, 1}));
        project.immersions.resize(1); // as if the user had removed a dip
        for (const BuiltPlace& place : partsDippedAlike(project).places) {
            QCOMPARE(place.dip, 1);
        }
        QVERIFY(countParts(project.asBuilt, 2, dipKeys(project)) == BuiltPartCounts());
        QVERIFY(refusal(toJson(project)).isEmpty());
        project.asBuilt.parts.pop_back();
        QVERIFY(refusal(toJson(project)).contains("as_built.places"));
    }

    void fromJson_version1_hasNoShare() {
        QJsonObject json = toJson(sampleProject());
        QVERIFY(fromJson(json, file).share.enabled);
        json.remove("share");
        json["version"] = 1;
        QVERIFY(!fromJson(json, file).share.enabled);
    }

    void fromJson_newerVersion_isRefusedNamingBoth() {
        const QString sentence = refusal(with(toJson(sampleProject()), {"version"}, 7));
        QVERIFY2(sentence.contains("version 7") && sentence.contains("version 3"),
                 qPrintable(sentence));
    }

    void fromJson_invalidValue_isRefusedByPath_data() {
        QTest::addColumn<QStringList>("path");
        QTest::addColumn<QJsonValue>("value");
        QTest::addColumn<QString>("named");
        const auto row = [](const char* path, const QJsonValue& value, const char* named) {
            const QByteArray name = QByteArray(path) + ' ' +
                                    QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact);
            QTest::newRow(name.constData()) << QString(path).split('.') << value << QString(named);
        };
        row("format", "something", "not a Dipwright project");
        row("version", 0, "version");
        row("version", "1", "version");
        row("name", 5, "name");
        row("film", 5, "film");
        row("film.edges", QJsonArray(), "edges");
        row("film.edges.left", "nailed", "film.edges.left");
        row("film.preset", "B9", "film.preset");
        row("film.size_mm", QJsonArray{210}, "film.size_mm");
        row("film.size_mm", QJsonArray{210, 1e9}, "film.size_mm[1]");
        row("film.size_mm", QJsonArray{210, -1}, "film.size_mm[1]");
        row("film.points", QJsonArray{1, 1}, "film.points[0]");
        row("film.points", QJsonArray{100000, 100000}, "film.points[0]");
        row("film.points", QJsonArray{2048, 2048}, "film.points");
        row("film.points", QJsonArray{20.5, 30}, "film.points[0]");
        row("film.lattice", "hexagonal", "film.lattice");
        row("film.swell", QJsonArray{0, 1}, "film.swell[0]");
        row("film.relaxation_time_s", -1, "film.relaxation_time_s");
        row("film.relaxation_time_s", "soon", "film.relaxation_time_s");
        row("process.iterations", 0, "process.iterations");
        row("process.self_contact", 1, "process.self_contact");
        row("process.dip_speed_mm_s", QJsonValue(), "process.dip_speed_mm_s");
        row("body.sdf_resolution", 4096, "body.sdf_resolution");
        row("immersions", QJsonArray(), "immersions");
        row("immersions", QJsonArray{QJsonObject(), QJsonObject(), QJsonObject()}, "immersions");
        row("immersions", QJsonArray{3}, "immersions[0]");
        row("immersions", QJsonArray{QJsonObject{{"rotation_deg", QJsonArray{0, 1e5, 0}}}},
            "immersions[0].rotation_deg[1]");
        row("sheet.dpi", 1e6, "sheet.dpi");
        row("sheet.paper", "wallpaper", "sheet.paper");
    }
    void fromJson_invalidValue_isRefusedByPath() {
        QFETCH(QStringList, path);
        QFETCH(QJsonValue, value);
        QFETCH(QString, named);
        const QString sentence = refusal(with(toJson(sampleProject()), path, value));
        QVERIFY2(sentence.contains(named), qPrintable(sentence));
    }

    void setByPath_calculationWithUnit_isConverted() {
        Project project;
        setByPath(project, "film.size_mm", "8 in x 1/2ft");
        QCOMPARE(project.film.width, Millimetres(203.2));
        QVERIFY(std::abs(project.film.height.value() - 152.4) < 1); // whole cells
        setByPath(project, "film.relaxation_time_s", "1/2 min");
        QCOMPARE(project.film.relaxationTime, Seconds(30));
        setByPath(project, "immersions[0].rotation_deg", "0;1/8 turn;0");
        QCOMPARE(project.immersions[0].rotation[1], Degrees(45));
        setByPath(project, "inspection.film.ruler_error_mm", "0.1mm");
        QCOMPARE(project.filmOnWater.rulerError, Millimetres(0.1));
        setByPath(project, "inspection.film.card_rulers_mm", "10 cm x 4 in");
        QCOMPARE(project.filmOnWater.cardRulers[1], Millimetres(101.6));
        setByPath(project, "inspection.film.dip_begins_s", "1 min");
        QCOMPARE(project.filmOnWater.dipBegins.value(), Seconds(60));
        for (const char* refused : {"2 s x 100", "1,5 x 100", "2 furlongs x 100"}) {
            QVERIFY_EXCEPTION_THROWN(setByPath(project, "film.size_mm", refused), Error);
        }
    }

    void setByPath_setsOneValue() {
        Project project = sampleProject();
        setByPath(project, "film.points", "240x360");
        QCOMPARE(project.film.columns, 240);
        QCOMPARE(project.film.rows, 360);
        setByPath(project, "immersions[0].rotation_deg", "0;45;-10.5");
        QCOMPARE(project.immersions[0].rotation[2].value(), -10.5);
        setByPath(project, "film.relaxation_time_s", "null");
        QVERIFY(std::isinf(project.film.relaxationTime.value()));
        setByPath(project, "film.relaxation_time_s", "0");
        QCOMPARE(project.film.relaxationTime.value(), 0.0);
        setByPath(project, "ink.compensate", "true");
        QVERIFY(project.ink.compensate);
        setByPath(project, "film.edges.top", "pinned");
        QVERIFY(project.film.edges.topPinned);
        setByPath(project, "immersions[1].name", "Belly; second");
        QCOMPARE(project.immersions[1].name, QStringLiteral("Belly; second"));
    }

    void setByPath_everyField_canBeReadAndSet() {
        for (const auto& field : projectFields()) {
            if (field.path.startsWith("model.")) {
                continue;
            }
            QJsonValue value = field.get(sampleProject());
            QStringList parts;
            for (const QJsonValue& part : value.isArray() ? value.toArray() : QJsonArray{value}) {
                parts.append(part.toVariant().toString());
            }
            Project project = sampleProject();
            setByPath(project, field.path, parts.join(QLatin1Char('x')));
            Project expected = sampleProject();
            if (field.path == QLatin1String("film.cell_mm")) { // setting the cell also selects it
                expected.film.resolution = FilmResolution::Cell;
            }
            QVERIFY2(project == expected || toJson(project) == toJson(expected),
                     qPrintable(field.path));
        }
    }

    void projectValues_ofAProject_areThoseThatCanBeSet() {
        Project project = sampleProject();
        const std::vector<ProjectValue> values = projectValues(project);
        QVERIFY(values.size() > projectFields().size());
        for (const ProjectValue& value : values) {
            QVERIFY2(value.path != QLatin1String("model.unit_mm"), qPrintable(value.path));
            QCOMPARE(valueByPath(project, value.path).value, value.value);
        }
        setByPath(project, "immersions[1].name", "Second");
        QCOMPARE(valueByPath(project, "immersions[1].name").value, QJsonValue("Second"));
        QCOMPARE(valueByPath(project, "film.size_mm").rule.unit, QStringLiteral("mm"));
        QVERIFY(valueByPath(project, "masks").value.isArray());
    }

    void valueByPath_unknownPath_isRefusedAsBySetting() {
        for (const QString path : {"film.nothing", "immersions[9].name", "immersions[00].name",
                                   "artwork.layers[00].turn_deg", "model.unit_mm", ""}) {
            try {
                valueByPath(sampleProject(), path);
                QFAIL(qPrintable(path));
            } catch (const Error& error) {
                QCOMPARE(error.sentence(), refusal(path, QStringLiteral("1")));
            }
        }
    }

    void setByPath_posesOfAPath_areReadAndKept() {
        Project project = sampleProject();
        setByPath(project, "immersions[0].path.kind", "poses");
        setByPath(project, "immersions[0].path.keys",
                  "0;0;0;0;0;0;-20 / 2.5;10;4;-3;0;5;-20 / 6;null;8;0;0;0;0");
        const std::vector<PathKey>& keys = project.immersions[0].path.keys;
        QCOMPARE(keys.size(), std::size_t(3));
        QCOMPARE(keys[1].time.value(), 2.5);
        QCOMPARE(keys[1].depth.value().value(), 10.0);
        QCOMPARE(keys[1].beside[1].value(), -3.0);
        QCOMPARE(keys[1].turn[2].value(), -20.0);
        QVERIFY(!keys[2].depth);
        QVERIFY(fromJson(toJson(project), "x").immersions == project.immersions);
        for (const char* wrong : {"0;0;0;0;0;0", "0;0;0;0;0;0;x", "null;0;0;0;0;0;0"}) {
            QVERIFY_EXCEPTION_THROWN(
                setByPath(project, "immersions[0].path.keys", QString::fromLatin1(wrong)), Error);
        }
    }

    void newProject_accuracy_isInTheFileAndOlderFilesKeepTheirs() {
        QJsonObject file = toJson(newProject(QStringLiteral("part.obj")));
        QJsonObject film = file["film"].toObject();
        QCOMPARE(film["work_million"].toDouble(), newProjectFilmWork);
        QCOMPARE(film["wanted_error_mm"].toDouble(), newProjectWantedError.value());
        QCOMPARE(file["process"].toObject()["contact_travel_cells"].toDouble(),
                 newProjectContactTravel);
        film.remove("work_million");
        film.remove("wanted_error_mm");
        file["film"] = film;
        const Project older = fromJson(file, "x");
        QCOMPARE(older.film.work, 60.0);
        QVERIFY(!older.film.wantedError);
    }

    void setByPath_pointsOrCell_lastOneCounts() {
        Project project = sampleProject();
        setByPath(project, "film.resolution", "automatic");
        QVERIFY(project.film.resolution == FilmResolution::Automatic);
        setByPath(project, "film.points", "240x360");
        QVERIFY(project.film.resolution == FilmResolution::Points);
        setByPath(project, "film.cell_mm", "0.75");
        QVERIFY(project.film.resolution == FilmResolution::Cell);
        for (const FilmResolution resolution :
             {FilmResolution::Points, FilmResolution::Automatic, FilmResolution::Cell}) {
            project.film.resolution = resolution;
            const Project read = fromJson(toJson(project), "x");
            QVERIFY(read.film.resolution == resolution);
            QCOMPARE(read.film.columns, 240);
            QCOMPARE(read.film.cell.value(), 0.75);
        }
        QJsonObject old = toJson(project);
        QJsonObject film = old["film"].toObject();
        film.remove("resolution");
        film.remove("cell_mm");
        old["film"] = film;
        QVERIFY(fromJson(old, "x").film.resolution == FilmResolution::Points);
    }

    void setByPath_invalidValue_isRefusedByPath_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("value");
        QTest::newRow("unknown section") << "foam.points"
                                         << "1";
        QTest::newRow("unknown key") << "film.pionts"
                                     << "240x360";
        QTest::newRow("a section") << "film"
                                   << "1";
        QTest::newRow("empty path") << ""
                                    << "1";
        QTest::newRow("no date") << "created"
                                 << "banana";
        QTest::newRow("a day that does not exist") << "created"
                                                   << "2027-02-30";
        QTest::newRow("1 × 1 points") << "film.points"
                                      << "1x1";
        QTest::newRow("100,000 × 100,000 points") << "film.points"
                                                  << "100000x100000";
        QTest::newRow("too many points in total") << "film.points"
                                                  << "2048x2048";
        QTest::newRow("one part") << "film.points"
                                  << "240";
        QTest::newRow("three parts") << "film.points"
                                     << "240x360x2";
        QTest::newRow("not a number") << "film.size_mm"
                                      << "ax300";
        QTest::newRow("nan") << "film.size_mm"
                             << "nanx300";
        QTest::newRow("infinity") << "film.contact_distance_mm"
                                  << "inf";
        QTest::newRow("decimal comma") << "film.contact_distance_mm"
                                       << "0,5";
        QTest::newRow("decimal comma, three digits") << "film.contact_distance_mm"
                                                     << "0,500";
        QTest::newRow("not nullable") << "film.contact_distance_mm"
                                      << "null";
        QTest::newRow("unknown dip") << "immersions[2].name"
                                     << "Third";
        QTest::newRow("unknown value of a dip") << "immersions[0].speed"
                                                << "3";
        QTest::newRow("the model") << "model.unit_mm"
                                   << "10";
        QTest::newRow("the version") << "version"
                                     << "2";
        QTest::newRow("not a flag") << "sheet.marks"
                                    << "yes";
        QTest::newRow("unknown choice") << "film.support"
                                        << "oil";
        QTest::newRow("unknown measure") << "pose_search.weights.colour"
                                         << "1";
        QTest::newRow("negative weight") << "pose_search.weights.quality"
                                         << "-1";
        QTest::newRow("infinite weight") << "pose_search.weights.zone_a"
                                         << "inf";
        QTest::newRow("limit above 1") << "pose_search.limits.coverage"
                                       << "1.5";
    }
    void setByPath_invalidValue_isRefusedByPath() {
        QFETCH(QString, path);
        QFETCH(QString, value);
        const QString sentence = refusal(path, value);
        QVERIFY2(!sentence.isEmpty() && sentence.contains(path), qPrintable(sentence));
    }

    void setByPath_filmSize_keepsTheCellsSquare_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("value");
        QTest::newRow("square") << "film.size_mm"
                                << "300x300";
        QTest::newRow("landscape") << "film.size_mm"
                                   << "297x210";
        QTest::newRow("small") << "film.size_mm"
                               << "20x31";
        QTest::newRow("large") << "film.size_mm"
                               << "2999x3000";
        for (const char* preset : {"A5", "A3", "A2", "Letter", "Legal", "Tabloid"}) {
            QTest::newRow(preset) << "film.preset" << preset;
        }
    }
    void setByPath_filmSize_keepsTheCellsSquare() {
        QFETCH(QString, path);
        QFETCH(QString, value);
        Project project;
        setByPath(project, path, value);
        const double shorter = std::min(project.film.columns, project.film.rows);
        QVERIFY2(std::abs(squareness(project.film) - 1) < 0.5 / (shorter - 1),
                 qPrintable(QStringLiteral("a cell's width divided by its height is %1, expected 1")
                                .arg(squareness(project.film))));
        QVERIFY(project.film.columns * project.film.rows <= 4'000'000);
        // After writing and reading, the film is the same.
        QVERIFY(fromJson(toJson(project), file).film == project.film);
    }

    void setByPath_sameFilmSize_changesNothing() {
        Project project;
        setByPath(project, "film.preset", "A4");
        QVERIFY(project.film == FilmSettings());
        setByPath(project, "film.size_mm", "210x297");
        QVERIFY(project.film == FilmSettings());
    }

    void setByPath_unknownPath_namesAllFirstWords() {
        for (const char* word : {"name", "created", "model", "film", "verdict", "masks", "artwork",
                                 "immersions[0]", "order"}) {
            QVERIFY2(refusal("flim.swell", "1").contains(word), word);
        }
        QVERIFY(refusal("film.swell", "x").startsWith(QStringLiteral("“x” is not allowed")));
    }

    void settingOrder_presetThenSize_sizeWins() {
        QVERIFY(settingOrder("film.preset") < settingOrder("film.size_mm"));
        QVERIFY(settingOrder("film.size_mm") < settingOrder("film.points"));
        QCOMPARE(settingOrder("film.points"), settingOrder("sheet.dpi"));
    }

    void setByPath_filmSize_namesThePreset() {
        Project project;
        setByPath(project, "film.size_mm", "420x297");
        QCOMPARE(project.film.preset, QStringLiteral("A3"));
        setByPath(project, "film.size_mm", "300x300");
        QCOMPARE(project.film.preset, QStringLiteral("custom"));
    }

    void applyPreset_setsTheFilmModel() {
        Project project;
        applyPreset(project, "paper-2020");
        QVERIFY(project.film.lattice == solver::Lattice::Structural);
        QVERIFY(project.film.support == solver::Support::None);
        QCOMPARE(project.process.iterations, 5);
        QCOMPARE(project.process.timeStep.value(), 1.0 / 60);
        QCOMPARE(project.process.dipSpeed.value(), 5.0);
        applyPreset(project, "production");
        QVERIFY(project == Project());
        QVERIFY_EXCEPTION_THROWN(applyPreset(project, "paper-2021"), Error);
    }
};

QTEST_GUILESS_MAIN(ProjectTest)
#include "ProjectTest.moc"
