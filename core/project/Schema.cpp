#include "project/Schema.h"

#include "base/Error.h"
#include "import/trusted/CadFacts.h"
#include "project/FieldMakers.h"
#include "project/FilmFields.h"
#include "project/FilmSizes.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QRegularExpression>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Project)
};

Field<Project> filmPreset() {
    return {QStringLiteral("film.preset"),
            {FieldKind::Choice, 1, false, 0, 0, filmSizeNames() << QStringLiteral("custom")},
            [](const Project& project) { return QJsonValue(project.film.preset); },
            [](Project& project, const QJsonValue& value) {
                if (value.toString() != QLatin1String("custom")) {
                    const QSizeF size = filmSize(value.toString());
                    resizeFilm(project.film, Millimetres(size.width()), Millimetres(size.height()));
                }
                project.film.preset = value.toString();
            }};
}

Field<Project> filmSizeField() {
    return {QStringLiteral("film.size_mm"),
            {FieldKind::Number, 2, false, 10, 3000, {}, 0, QStringLiteral("mm")},
            [](const Project& project) {
                return QJsonArray{project.film.width.value(), project.film.height.value()};
            },
            [](Project& project, const QJsonValue& value) {
                const QJsonArray size = value.toArray();
                resizeFilm(project.film, Millimetres(size.at(0).toDouble()),
                           Millimetres(size.at(1).toDouble()));
            }};
}

Field<Project> filmPoints() {
    return {QStringLiteral("film.points"),
            {FieldKind::WholeNumber, 2, false, minimumFilmPoints, maximumFilmPoints},
            [](const Project& project) {
                return QJsonArray{project.film.columns, project.film.rows};
            },
            [](Project& project, const QJsonValue& value) {
                const int columns = value.toArray().at(0).toInt();
                const int rows = value.toArray().at(1).toInt();
                if (!mayHavePoints(columns, rows)) {
                    throw Error(Text::tr("%1 × %2 points are too many; a film may have up to %3 "
                                         "million points")
                                    .arg(columns)
                                    .arg(rows)
                                    .arg(maximumFilmGrid / 1'000'000),
                                QStringLiteral("film.points"));
                }
                project.film.columns = columns;
                project.film.rows = rows;
                project.film.resolution = FilmResolution::Points;
            }};
}

Field<Project> filmCell() {
    return {QStringLiteral("film.cell_mm"),
            {FieldKind::Number, 1, false, leastFilmCell, 20, {}, 0, QStringLiteral("mm")},
            [](const Project& project) { return QJsonValue(project.film.cell.value()); },
            [](Project& project, const QJsonValue& value) {
                project.film.cell = Millimetres(value.toDouble());
                project.film.resolution = FilmResolution::Cell;
            }};
}

Field<Project> modelHash() {
    return {QStringLiteral("model.sha256"),
            {FieldKind::Text, 1, false, 0, 64},
            [](const Project& project) {
                return QJsonValue(QString::fromLatin1(project.modelOrigin.sha256));
            },
            [](Project& project, const QJsonValue& value) {
                project.modelOrigin.sha256 = value.toString().toLatin1();
            }};
}

void addModelFields(std::vector<Field<Project>>& fields) {
    fields.push_back(filePath(
        "model.source", 4096, [](auto& p) -> auto& { return p.modelOrigin.source; }));
    fields.push_back(filePath(
        "model.texture_source", 4096, [](auto& p) -> auto& { return p.modelOrigin.texture; }));
    fields.push_back(number(
        "model.unit_mm", 1e-9, 1e9,
        [](auto& p) -> auto& { return p.modelOrigin.unitMillimetres; }));
    fields.push_back(omittedIfDefault(notHashedIfDefault(text(
        "model.remarks", 4000, [](auto& p) -> auto& { return p.modelOrigin.remarks; }))));
    fields.push_back(omittedIfDefault(notHashedIfDefault(text(
        "model.losses", 4000, [](auto& p) -> auto& { return p.modelOrigin.losses; }))));
    fields.push_back(modelHash());
    fields.push_back(omittedIfDefault(notHashedIfDefault(number(
        "model.tessellation_mm", 0, coarsestTessellation,
        [](auto& p) -> auto& { return p.modelOrigin.tessellation; }))));
    fields.push_back(omittedIfDefault(notHashedIfDefault(text(
        "model.file_unit", 20, [](auto& p) -> auto& { return p.modelOrigin.fileUnit; }))));
    fields.push_back(omittedIfDefault(notHashedIfDefault(text(
        "model.cad_file", longestMaterialName, [](auto& p) -> auto& { return p.cad.name; }))));
}

void addFilmFields(std::vector<Field<Project>>& fields) {
    fields.push_back(filmPreset());
    fields.push_back(filmSizeField());
    fields.push_back(filmPoints());
    fields.push_back(notHashedIfDefault(filmCell()));
    fields.push_back(notHashedIfDefault(choice(
        "film.resolution",
        {QStringLiteral("points"), QStringLiteral("automatic"), QStringLiteral("cell")},
        [](auto& p) -> auto& { return p.film.resolution; })));
    fields.push_back(omittedIfDefault(notHashedIfDefault(number(
        "film.work_million", 0, mostFilmWork, [](auto& p) -> auto& { return p.film.work; }))));
    fields.push_back(omittedIfDefault(notHashedIfDefault(numberOrNone(
        "film.wanted_error_mm", 0.001, 100, [](auto& p) -> auto& { return p.film.wantedError; }))));
    fields.push_back(choice(
        "film.lattice", {QStringLiteral("structural"), QStringLiteral("isotropic")},
        [](auto& p) -> auto& { return p.film.lattice; }));
    fields.push_back(choice(
        "film.support", {QStringLiteral("none"), QStringLiteral("water")},
        [](auto& p) -> auto& { return p.film.support; }));
    for (const auto& material : filmBehaviourFields()) {
        fields.push_back(fieldOf(
            QStringLiteral("film."), material.field,
            [](auto& p) -> auto& { return p.film.behaviour(); }));
    }
}

void addProcessFields(std::vector<Field<Project>>& fields) {
    fields.push_back(number(
        "process.dip_speed_mm_s", 0.01, 1000, [](auto& p) -> auto& { return p.process.dipSpeed; }));
    fields.push_back(number(
        "process.time_step_s", 1e-5, 1, [](auto& p) -> auto& { return p.process.timeStep; }));
    fields.push_back(number(
        "process.iterations", 1, 1000, [](auto& p) -> auto& { return p.process.iterations; }));
    fields.push_back(choice(
        "process.relaxation", {QStringLiteral("jacobi"), QStringLiteral("gauss-seidel")},
        [](auto& p) -> auto& { return p.process.relaxation; }));
    fields.push_back(flag(
        "process.self_contact", [](auto& p) -> auto& { return p.process.selfContact; }));
    fields.push_back(number(
        "process.contact_travel_cells", 0.001, 1,
        [](auto& p) -> auto& { return p.process.contactTravel; }));
    fields.push_back(numberOrNone(
        "process.depth_mm", 0.1, 5000, [](auto& p) -> auto& { return p.process.depth; }));
    fields.push_back(number(
        "process.margin_mm", 0, 100, [](auto& p) -> auto& { return p.process.margin; }));
    const FilmLimitFields limits = filmLimitFields();
    for (const auto& field : {limits.tearStretch.field, limits.overhang.field}) {
        fields.push_back(fieldOf(
            QStringLiteral("process."), field, [](auto& p) -> auto& { return p.process; }));
    }
    fields.push_back(text(
        "process.solver", 100, [](auto& p) -> auto& { return p.process.solver; }));
    fields.push_back(number(
        "body.sdf_resolution", 64, 512, [](auto& p) -> auto& { return p.fieldResolution; }));
}

Field<Project> paper() {
    const QStringList papers{QStringLiteral("film"), QStringLiteral("A4"), QStringLiteral("A3"),
                             QStringLiteral("Letter"), QStringLiteral("custom")};
    return {
        QStringLiteral("sheet.paper"),
        {FieldKind::Choice, 1, false, 0, 0, papers},
        [](const Project& project) { return QJsonValue(project.sheet.paper); },
        [](Project& project, const QJsonValue& value) { project.sheet.paper = value.toString(); }};
}

// A field for a plate's name. It refuses the reserved names of other inks.
template <typename Owner = Project, typename Access>
Field<Owner> spotName(const char* path, Access access, bool mayBeNone = false) {
    Field<Owner> field = omittedIfDefault(text<Owner>(path, longestSpotName, access));
    field.set = [path, access, mayBeNone](Owner& owner, const QJsonValue& value) {
        const QString name = value.toString().simplified();
        const QStringList taken{QString(),
                                QStringLiteral("all"),
                                QStringLiteral("none"),
                                QStringLiteral("cyan"),
                                QStringLiteral("magenta"),
                                QStringLiteral("yellow"),
                                QStringLiteral("black")};
        if (taken.contains(name.toLower()) && !(mayBeNone && name.isEmpty())) {
            throw Error(Text::tr("A spot colour needs its own name; All, None and the names of the "
                                 "four process inks are reserved"),
                        QString::fromLatin1(path));
        }
        access(owner) = name;
    };
    return field;
}

Field<Project> baseColour() {
    Field<Project> field = omittedIfDefault(text(
        "body.base_colour", 7, [](auto& p) -> auto& { return p.baseColour; }));
    field.set = [](Project& project, const QJsonValue& value) {
        static const QRegularExpression colour(QStringLiteral("^(#[0-9a-fA-F]{6})?$"));
        if (!colour.match(value.toString()).hasMatch()) {
            throw Error(Text::tr("“%1” is not a colour; write it as #1a2b3c").arg(value.toString()),
                        QStringLiteral("body.base_colour"));
        }
        project.baseColour = value.toString();
    };
    return field;
}

void addSheetFields(std::vector<Field<Project>>& fields) {
    fields.push_back(paper());
    fields.push_back(flag(
        "sheet.landscape", [](auto& p) -> auto& { return p.sheet.landscape; }));
    fields.push_back(numbers(
        "sheet.custom_size_mm", 2, 10, 5000, [](auto& p, int part) -> auto& {
            return part == 0 ? p.sheet.customWidth : p.sheet.customHeight;
        }));
    fields.push_back(number(
        "sheet.dpi", 30, 2400, [](auto& p) -> auto& { return p.sheet.resolution; }));
    fields.push_back(number(
        "sheet.bleed_mm", 0, 50, [](auto& p) -> auto& { return p.sheet.bleed; }));
    fields.push_back(flag(
        "sheet.marks", [](auto& p) -> auto& { return p.sheet.marks; }));
    fields.push_back(flag(
        "sheet.ruler", [](auto& p) -> auto& { return p.sheet.ruler; }));
    fields.push_back(flag(
        "sheet.job_line", [](auto& p) -> auto& { return p.sheet.jobLine; }));
    fields.push_back(omittedIfDefault(choice(
        "sheet.cut_line", {QStringLiteral("none"), QStringLiteral("ink"), QStringLiteral("film")},
        [](auto& p) -> auto& { return p.sheet.cutLine; })));
    fields.push_back(omittedIfDefault(number(
        "sheet.cut_distance_mm", 0, 100, [](auto& p) -> auto& { return p.sheet.cutDistance; })));
    fields.push_back(omittedIfDefault(choice(
        "sheet.white", {QStringLiteral("none"), QStringLiteral("last"), QStringLiteral("first")},
        [](auto& p) -> auto& { return p.sheet.white; })));
    fields.push_back(omittedIfDefault(number(
        "sheet.white_density", 0.01, 1, [](auto& p) -> auto& { return p.sheet.whiteDensity; })));
    fields.push_back(omittedIfDefault(number(
        "sheet.white_choke_mm", 0, 10, [](auto& p) -> auto& { return p.sheet.whiteChoke; })));
    fields.push_back(spotName(
        "sheet.white_name", [](auto& p) -> auto& { return p.sheet.whiteName; }));
    fields.push_back(baseColour());
    fields.push_back(spotName(
        "sheet.cut_name", [](auto& p) -> auto& { return p.sheet.cutName; }));
    fields.push_back(omittedIfDefault(number(
        "sheet.cut_bleed_mm", 0, 50, [](auto& p) -> auto& { return p.sheet.cutBleed; })));
    fields.push_back(flag(
        "ink.compensate", [](auto& p) -> auto& { return p.ink.compensate; }));
    fields.push_back(number(
        "ink.limit", 0.1, 10, [](auto& p) -> auto& { return p.ink.limit; }));
    fields.push_back(omittedIfDefault(notHashedIfDefault(number(
        "ink.densest", 0.2, leastLightening, [](auto& p) -> auto& { return p.ink.densest; }))));
    fields.push_back(omittedIfDefault(notHashedIfDefault(number(
        "ink.passes", 1, mostInkPasses, [](auto& p) -> auto& { return p.ink.passes; }))));
    for (const auto& material : inkLawFields()) {
        fields.push_back(fieldOf(
            QStringLiteral("ink."), material.field, [](auto& p) -> auto& { return p.ink.law; }));
    }
}

void addShareFields(std::vector<Field<Project>>& fields) {
    fields.push_back(flag(
        "share.enabled", [](auto& p) -> auto& { return p.share.enabled; }));
    fields.push_back(number(
        "share.overlap_mm", 0, 20, [](auto& p) -> auto& { return p.share.overlap; }));
    fields.push_back(number(
        "share.registration_error_mm", 0, 10,
        [](auto& p) -> auto& { return p.share.registrationError; }));
    fields.push_back(number(
        "share.stretch_limit", 1, 100, [](auto& p) -> auto& { return p.share.stretchLimit; }));
}

void addCradleFields(std::vector<Field<Project>>& fields) {
    const auto add = [&](const char* path, double minimum, double maximum, auto member) {
        fields.push_back(number(
            path, minimum, maximum, [member](auto& p) -> auto& { return p.cradle.*member; }));
    };
    using C = CradleSettings;
    add("cradle.clearance_mm", 0.05, 5, &C::clearance);
    add("cradle.wall_mm", 0.8, 50, &C::wall);
    add("cradle.reach_mm", 1, 1000, &C::reach);
    add("cradle.paint_distance_mm", 0.5, 50, &C::paintDistance);
    fields.push_back(flag(
        "cradle.on_paint", [](auto& p) -> auto& { return p.cradle.onPaint; }));
    add("cradle.padding_mm", 0, 20, &C::padding);
    add("cradle.plate_thickness_mm", 2, 50, &C::plateThickness);
    add("cradle.pin_span_mm", 40, 3000, &C::pinSpan);
    add("cradle.standoff_mm", 0, 200, &C::standoff);
    add("cradle.pin_diameter_mm", 1, 30, &C::pinDiameter);
    add("cradle.pin_clearance_mm", 0, 2, &C::pinClearance);
    add("cradle.bore_mm", 0, 100, &C::bore);
    add("cradle.engraving_mm", 0, 5, &C::engravingDepth);
    add("cradle.cell_mm", 0.2, 2, &C::cell);
}

void addToleranceFields(std::vector<Field<Project>>& fields) {
    fields.push_back(numbers(
        "tolerance.position_mm", 2, 0, 10,
        [](auto& p, int part) -> auto& { return p.tolerance.position[part]; }));
    fields.push_back(numbers(
        "tolerance.turn_deg", 3, 0, 10,
        [](auto& p, int part) -> auto& { return p.tolerance.turn[part]; }));
    fields.push_back(numbers(
        "tolerance.film_position_mm", 2, 0, 50,
        [](auto& p, int part) -> auto& { return p.tolerance.filmPosition[part]; }));
    const auto add = [&](const char* path, double maximum, auto member) {
        fields.push_back(number(
            path, 0, maximum, [member](auto& p) -> auto& { return p.tolerance.*member; }));
    };
    using T = ToleranceSettings;
    add("tolerance.film_turn_deg", 10, &T::filmTurn);
    add("tolerance.swell", 0.1, &T::swell);
    add("tolerance.water_level_mm", 50, &T::waterLevel);
    add("tolerance.speed", 0.5, &T::speed);
    add("tolerance.relaxation", 0.9, &T::relaxation);
    fields.push_back(omittedIfDefault(notHashedIfDefault(number(
        "tolerance.path_angle_deg", 0, 10,
        [](auto& p) -> auto& { return p.tolerance.pathAngle; }))));
    fields.push_back(omittedIfDefault(notHashedIfDefault(number(
        "tolerance.timing_s", 0, 60, [](auto& p) -> auto& { return p.tolerance.timing; }))));
    add("tolerance.samples", 1000, &T::samples);
    add("tolerance.seed", 1'000'000, &T::seed);
    fields.push_back(numbers(
        "tolerance.limits_mm", int(zoneCount), 0.01, 100,
        [](auto& p, int part) -> auto& { return p.tolerance.limits[part]; }));
}

// A field for the verdict on a condition that is met or not, without a limit.
Field<Project> adviceField(const char* path, Advice VerdictSettings::*member) {
    const QStringList words{QStringLiteral("print"), QStringLiteral("look_first"),
                            QStringLiteral("do_not_print")};
    return {QString::fromLatin1(path),
            {FieldKind::Choice, 1, false, 0, 0, words},
            [words, member](const Project& project) {
                return QJsonValue(words.at(int(project.verdict.*member) - int(Advice::Print)));
            },
            [words, member](Project& project, const QJsonValue& value) {
                project.verdict.*member =
                    Advice(int(Advice::Print) + int(words.indexOf(value.toString())));
            }};
}

void addVerdictFields(std::vector<Field<Project>>& fields) {
    const auto add = [&](Field<Project> field) {
        fields.push_back(omittedIfDefault(notHashedIfDefault(std::move(field))));
    };
    const auto share = [&](const char* path, double VerdictSettings::*member) {
        add(number(
            path, 0, 1, [member](auto& p) -> auto& { return p.verdict.*member; }));
    };
    using V = VerdictSettings;
    share("verdict.air", &V::air);
    share("verdict.pale", &V::pale);
    share("verdict.unreached", &V::unreached);
    share("verdict.narrow", &V::narrow);
    share("verdict.zone_bare", &V::zoneBare);
    share("verdict.least_painted", &V::leastPainted);
    share("verdict.damaged", &V::damaged);
    add(number(
        "verdict.edge_mm", 0, 1000, [](auto& p) -> auto& { return p.verdict.edge; }));
    add(adviceField("verdict.no_picture", &V::noPicture));
    add(adviceField("verdict.changed_model", &V::changedModel));
    add(adviceField("verdict.incomplete_model", &V::incompleteModel));
    add(adviceField("verdict.guessed_film", &V::guessedFilm));
    add(adviceField("verdict.expired_film", &V::expiredFilm));
}

// "pose_search.weights.quality", "pose_search.weights.zone_a", "pose_search.limits.coverage".
void addPoseSearchFields(std::vector<Field<Project>>& fields) {
    const auto add = [&](const QString& key, auto make) {
        const QByteArray path = QByteArrayLiteral("pose_search.") + key.toLatin1();
        fields.push_back(omittedIfDefault(make(path.constData())));
    };
    for (const Measure measure : allMeasures()) {
        add(QStringLiteral("weights.") + measureKey(measure), [measure](const char* path) {
            return number(
                path, 0,
                mostWeight, [measure](auto& p) -> auto& { return p.poseAims.weights[measure]; });
        });
    }
    for (std::size_t zone = 0; zone < zoneCount; ++zone) {
        add(QStringLiteral("weights.") + zoneKey(zone), [zone](const char* path) {
            return number(
                path, 0,
                mostZoneWeight, [zone](auto& p) -> auto& { return p.poseAims.zoneWeights[zone]; });
        });
    }
    for (const Measure measure : allMeasures()) {
        add(QStringLiteral("limits.") + measureKey(measure), [measure](const char* path) {
            return inUnit(measure == Measure::Join ? "mm" : "",
                          numberOrNone(
                              path, 0, mostLimit(measure), [measure](auto& p) -> auto& {
                                  return p.poseAims.limits[measure];
                              }));
        });
    }
}

void addAsBuiltFields(std::vector<Field<Project>>& fields) {
    fields.push_back(flag(
        "as_built.correct", [](auto& p) -> auto& { return p.asBuilt.corrects; }));
    fields.push_back(number(
        "as_built.strength", 0, 1, [](auto& p) -> auto& { return p.asBuilt.strength; }));
}

void addOrderFields(std::vector<Field<Project>>& fields) {
    fields.push_back(omittedIfDefault(notHashedIfDefault(number(
        "order.parts", 1, mostPartsToMake, [](auto& p) -> auto& { return p.partsToMake; }))));
}

void addInspectionFields(std::vector<Field<Project>>& fields) {
    fields.push_back(flag(
        "inspection.chessboard", [](auto& p) -> auto& { return p.inspection.chessboard; }));
    fields.push_back(flag(
        "inspection.keep_camera", [](auto& p) -> auto& { return p.inspection.keepsCamera; }));
}

void addFilmOnWaterFields(std::vector<Field<Project>>& fields) {
    fields.push_back(numberOrNone(
        "inspection.film.dip_begins_s", 0, longestWatch,
        [](auto& p) -> auto& { return p.filmOnWater.dipBegins; }));
    fields.push_back(text(
        "inspection.film.lot", 100, [](auto& p) -> auto& { return p.filmOnWater.lot; }));
    fields.push_back(
        inUnit("°C", numberOrNone(
                         "inspection.film.water_temperature_c", 0, 100,
                         [](auto& p) -> auto& { return p.filmOnWater.waterTemperature; })));
    fields.push_back(numbers(
        "inspection.film.card_rulers_mm", 2, leastRuler, mostRuler,
        [](auto& p, int part) -> auto& { return p.filmOnWater.cardRulers[part]; }));
    fields.push_back(numbers(
        "inspection.film.film_rulers_mm", 2, leastRuler, mostRuler,
        [](auto& p, int part) -> auto& { return p.filmOnWater.filmRulers[part]; }));
    fields.push_back(number(
        "inspection.film.ruler_error_mm", 0, mostRulerError,
        [](auto& p) -> auto& { return p.filmOnWater.rulerError; }));
    fields.push_back(number(
        "inspection.film.card_above_mm", -mostCardAbove, mostCardAbove,
        [](auto& p) -> auto& { return p.filmOnWater.cardAbove; }));
    fields.push_back(numberOrNone(
        "inspection.film.focal_35mm", leastFocal, mostFocal,
        [](auto& p) -> auto& { return p.filmOnWater.focalAs35; }));
    fields.push_back(numberOrNone(
        "inspection.film.lens_k1", -1, 1, [](auto& p) -> auto& { return p.filmOnWater.lensK1; }));
    fields.push_back(numberOrNone(
        "inspection.film.lens_k2", -1, 1, [](auto& p) -> auto& { return p.filmOnWater.lensK2; }));
}

} // namespace

const std::vector<Field<Project>>& projectFields() {
    static const std::vector<Field<Project>> fields = [] {
        std::vector<Field<Project>> all;
        all.push_back(text(
            "name", longestProjectName, [](auto& p) -> auto& { return p.name; }));
        all.push_back(text(
            "created", 40, [](auto& p) -> auto& { return p.date; }));
        addModelFields(all);
        addFilmFields(all);
        addProcessFields(all);
        addSheetFields(all);
        addShareFields(all);
        addCradleFields(all);
        addToleranceFields(all);
        addVerdictFields(all);
        addPoseSearchFields(all);
        addAsBuiltFields(all);
        addInspectionFields(all);
        addFilmOnWaterFields(all);
        addOrderFields(all);
        return all;
    }();
    return fields;
}

namespace {

Field<Immersion> pathField(Field<Immersion> field) {
    return omittedIfDefault(notHashedIfDefault(std::move(field)));
}

QJsonValue rowOf(const PathKey& key) {
    QJsonArray row{key.time.value(), key.depth ? QJsonValue(key.depth->value()) : QJsonValue()};
    for (const Millimetres beside : key.beside) {
        row.append(beside.value());
    }
    for (const Degrees turn : key.turn) {
        row.append(turn.value());
    }
    return row;
}

PathKey keyOf(const QJsonArray& row, const QString& path) {
    const auto at = [&](int part) {
        if (row.at(part).isNull()) {
            throw Error(Text::tr("In the poses of a path only the depth may be null; it then is "
                                 "the depth of the dip"),
                        path);
        }
        return row.at(part).toDouble();
    };
    constexpr double latest = latestPathKey.value(), farthest = farthestPathKey.value(),
                     mostTurn = mostPathTurn.value();
    const std::array<double, 7> limits{latest,   farthest, farthest, farthest,
                                       mostTurn, mostTurn, mostTurn};
    for (int part = 0; part < row.size(); ++part) {
        if (std::abs(row.at(part).toDouble()) > limits[std::size_t(part)]) {
            throw Error(
                Text::tr("In the poses of a path, times are at most %1 s, lengths %2 mm and "
                         "turns %3°")
                    .arg(latest)
                    .arg(farthest)
                    .arg(mostTurn),
                path);
        }
    }
    PathKey key;
    key.time = Seconds(at(0));
    key.depth.reset();
    if (!row.at(1).isNull()) {
        key.depth = Millimetres(at(1));
    }
    key.beside = {Millimetres(at(2)), Millimetres(at(3))};
    key.turn = {Degrees(at(4)), Degrees(at(5)), Degrees(at(6))};
    return key;
}

// A list of poses, each as [s, depth mm, X mm, Z mm, about X °, about Y °, about Z °].
Field<Immersion> pathKeysField() {
    const QString path = QStringLiteral("path.keys");
    constexpr int parts = 7;
    return {path,
            {FieldKind::Number, parts, true, -10'000, 10'000, {}, int(mostPathKeys)},
            [](const Immersion& immersion) {
                QJsonArray rows;
                for (const PathKey& key : immersion.path.keys) {
                    rows.append(rowOf(key));
                }
                return QJsonValue(rows);
            },
            [path](Immersion& immersion, const QJsonValue& value) {
                std::vector<PathKey> keys;
                for (const QJsonValue& row : value.toArray()) {
                    keys.push_back(keyOf(row.toArray(), path));
                }
                immersion.path.keys = std::move(keys);
            }};
}

} // namespace

const std::vector<Field<Immersion>>& immersionFields() {
    static const std::vector<Field<Immersion>> fields{
        text<Immersion>(
            "name", 100, [](auto& i) -> auto& { return i.name; }),
        numbers<Immersion>(
            "rotation_deg", 3, -360, 360,
            [](auto& i, int part) -> auto& { return i.rotation[part]; }),
        numbers<Immersion>(
            "offset_mm", 2, -5000, 5000, [](auto& i, int part) -> auto& { return i.offset[part]; }),
        pathField(choice<Immersion>(
            "path.kind",
            {QStringLiteral("straight"), QStringLiteral("slanted"), QStringLiteral("tilt"),
             QStringLiteral("roll"), QStringLiteral("poses")},
            [](auto& i) -> auto& { return i.path.kind; })),
        pathField(number<Immersion>(
            "path.heading_deg", -360, 360, [](auto& i) -> auto& { return i.path.heading; })),
        pathField(number<Immersion>(
            "path.angle_deg", -720, 720, [](auto& i) -> auto& { return i.path.angle; })),
        pathField(numberOrNone<Immersion>(
            "path.level_depth_mm", 0.1, 5000, [](auto& i) -> auto& { return i.path.levelDepth; })),
        pathField(numberOrNone<Immersion>(
            "path.roll_radius_mm", -5000, 5000,
            [](auto& i) -> auto& { return i.path.rollRadius; })),
        pathField(number<Immersion>(
            "path.turn_deg", -720, 720, [](auto& i) -> auto& { return i.path.turn; })),
        pathField(number<Immersion>(
            "path.water_speed_mm_s", -200, 200,
            [](auto& i) -> auto& { return i.path.waterSpeed; })),
        pathField(numberOrNone<Immersion>(
            "path.slow_speed_mm_s", 0.1, 200, [](auto& i) -> auto& { return i.path.slowSpeed; })),
        pathField(number<Immersion>(
            "path.slow_mm", 0, 1000, [](auto& i) -> auto& { return i.path.slowWay; })),
        pathField(numberOrNone<Immersion>(
            "path.acceleration_mm_s2", 0.1, 100'000,
            [](auto& i) -> auto& { return i.path.acceleration; })),
        pathField(pathKeysField())};
    return fields;
}

namespace {

// The points of a brush stroke, each as [x mm, y mm, z mm] and the surface normal.
template <typename Mark>
Field<Mark> brushPathField() {
    constexpr int parts = 6;
    constexpr double longestNormal = 1;
    const QString path = QStringLiteral("path");
    Field<Mark> field{
        path,
        {FieldKind::Number, parts, false, -farthestPlace, farthestPlace, {}, int(mostBrushPoints)},
        [](const Mark& mark) {
            QJsonArray rows;
            for (const BrushPoint& point : mark.path) {
                QJsonArray row;
                for (const Millimetres place : point.place) {
                    row.append(place.value());
                }
                for (const double outward : point.outward) {
                    row.append(outward);
                }
                rows.append(row);
            }
            return QJsonValue(rows);
        },
        [path](Mark& mark, const QJsonValue& value) {
            mark.path.clear();
            for (const QJsonValue& row : value.toArray()) {
                BrushPoint point;
                for (int axis = 0; axis < 3; ++axis) {
                    const double outward = row.toArray().at(3 + axis).toDouble();
                    if (std::abs(outward) > longestNormal) {
                        throw Error(Text::tr("The normals of a brush stroke have parts from −1 "
                                             "to 1"),
                                    path);
                    }
                    point.place[std::size_t(axis)] = Millimetres(row.toArray().at(axis).toDouble());
                    point.outward[std::size_t(axis)] = outward;
                }
                mark.path.push_back(point);
            }
        }};
    return omittedIfDefault(std::move(field));
}

template <typename Mark>
Field<Mark> placeField() {
    return numbers<Mark>(
        "place_mm", 3, -farthestPlace, farthestPlace,
        [](auto& m, int part) -> auto& { return m.place[part]; });
}

template <typename Mark>
Field<Mark> radiusField() {
    return number<Mark>(
        "radius_mm", 0, 1000, [](auto& m) -> auto& { return m.radius; });
}

// In the order of MarkExtent.
QStringList extentWords() {
    return {QStringLiteral("spot"), QStringLiteral("face"), QStringLiteral("material"),
            QStringLiteral("stroke")};
}

// The material that a mark covers. A mark with this name needs no extent in the file.
template <typename Mark>
Field<Mark> markedMaterialField() {
    Field<Mark> field = omittedIfDefault(text<Mark>(
        "material", longestMaterialName, [](auto& m) -> auto& { return m.material; }));
    field.set = [](Mark& mark, const QJsonValue& value) {
        mark.material = value.toString();
        if (!mark.material.isEmpty()) {
            mark.extent = MarkExtent::Material;
        }
    };
    return field;
}

// A mask's extent; it has no spots.
Field<MaskMark> maskExtentField() {
    Field<MaskMark> field = choice<MaskMark>(
        "extent", extentWords(), [](auto& m) -> auto& { return m.extent; });
    field.rule.choices.removeFirst();
    return field;
}

} // namespace

const std::vector<Field<ShareMark>>& shareMarkFields() {
    static const std::vector<Field<ShareMark>> fields{
        choice<ShareMark>(
            "kind",
            {QStringLiteral("first"), QStringLiteral("second"), QStringLiteral("avoid"),
             QStringLiteral("allow"), QStringLiteral("none")},
            [](auto& m) -> auto& { return m.kind; }),
        placeField<ShareMark>(), radiusField<ShareMark>(), brushPathField<ShareMark>()};
    return fields;
}

const std::vector<Field<ZoneMark>>& zoneMarkFields() {
    static const std::vector<Field<ZoneMark>> fields{
        choice<ZoneMark>(
            "zone", {QStringLiteral("A"), QStringLiteral("B"), QStringLiteral("C")},
            [](auto& m) -> auto& { return m.zone; }),
        placeField<ZoneMark>(),
        choice<ZoneMark>(
            "extent", extentWords(), [](auto& m) -> auto& { return m.extent; }),
        radiusField<ZoneMark>(),
        brushPathField<ZoneMark>(),
        markedMaterialField<ZoneMark>()};
    return fields;
}

const std::vector<Field<MaskMark>>& maskMarkFields() {
    static const std::vector<Field<MaskMark>> fields{
        maskExtentField(),
        omittedIfDefault(placeField<MaskMark>()),
        omittedIfDefault(number<MaskMark>(
            "radius_mm", leastMaskRadius, 1000, [](auto& m) -> auto& { return m.radius; })),
        omittedIfDefault(flag<MaskMark>(
            "erase", [](auto& m) -> auto& { return m.erases; })),
        brushPathField<MaskMark>(),
        markedMaterialField<MaskMark>()};
    return fields;
}

const std::vector<Field<BuiltPart>>& builtPartFields() {
    constexpr int longestHashes = 4096, longestDips = 100;
    static const std::vector<Field<BuiltPart>> fields{
        text<BuiltPart>(
            "date", 10, [](auto& p) -> auto& { return p.date; }),
        text<BuiltPart>(
            "accepted_by", 100, [](auto& p) -> auto& { return p.acceptedBy; }),
        text<BuiltPart>(
            "photos", longestHashes, [](auto& p) -> auto& { return p.photos; }),
        number<BuiltPart>(
            "residual_mm", 0, 100, [](auto& p) -> auto& { return p.residual; }),
        omittedIfDefault(text<BuiltPart>(
            "dips", longestDips, [](auto& p) -> auto& { return p.dips; }))};
    return fields;
}

const std::vector<Field<BuiltPlace>>& builtPlaceFields() {
    static const std::vector<Field<BuiltPlace>> fields{
        number<BuiltPlace>(
            "part", 1, int(mostBuiltParts), [](auto& p) -> auto& { return p.part; }),
        number<BuiltPlace>(
            "dip", 1, 2, [](auto& p) -> auto& { return p.dip; }),
        numbers<BuiltPlace>(
            "sheet_mm", 2, -5000, 5000, [](auto& p, int part) -> auto& { return p.sheet[part]; }),
        numbers<BuiltPlace>(
            "model_mm", 3, -farthestPlace, farthestPlace,
            [](auto& p, int part) -> auto& { return p.model[part]; }),
        numbers<BuiltPlace>(
            "off_mm", 2, -100, 100, [](auto& p, int part) -> auto& { return p.off[part]; })};
    return fields;
}

const std::vector<Field<TankTime>>& tankTimeFields() {
    using T = TankTime;
    constexpr double longest = 604'800; // s, a week
    static const std::vector<Field<T>> fields{
        number<T>(
            "run", 1, 1e6, [](auto& t) -> auto& { return t.run; }),
        number<T>(
            "dip", 1, 2, [](auto& t) -> auto& { return t.dip; }),
        choice<T>(
            "step", tankStepKeys(), [](auto& t) -> auto& { return t.step; }),
        text<T>(
            "began", 40, [](auto& t) -> auto& { return t.began; }),
        numberOrNone<T>(
            "planned_s", 0, longest, [](auto& t) -> auto& { return t.planned; }),
        number<T>(
            "took_s", 0, longest, [](auto& t) -> auto& { return t.took; })};
    return fields;
}

const std::vector<Field<InspectedPhoto>>& inspectedPhotoFields() {
    static const std::vector<Field<InspectedPhoto>> fields{
        filePath<InspectedPhoto>(
            "file", 4096, [](auto& p) -> auto& { return p.file; }),
        text<InspectedPhoto>(
            "sha256", 64, [](auto& p) -> auto& { return p.sha256; })};
    return fields;
}

const std::vector<Field<FloatingPhoto>>& floatingPhotoFields() {
    static const std::vector<Field<FloatingPhoto>> fields{
        filePath<FloatingPhoto>(
            "file", 4096, [](auto& p) -> auto& { return p.file; }),
        text<FloatingPhoto>(
            "sha256", 64, [](auto& p) -> auto& { return p.sha256; }),
        numberOrNone<FloatingPhoto>(
            "seconds", 0, longestWatch, [](auto& p) -> auto& { return p.seconds; })};
    return fields;
}

const std::vector<Field<ClickedPair>>& clickedPairFields() {
    static const std::vector<Field<ClickedPair>> fields{
        number<ClickedPair>(
            "photo", 0, double(mostInspectedPhotos - 1), [](auto& p) -> auto& { return p.photo; }),
        numbers<ClickedPair>(
            "pixel", 2, 0, 1e5, [](auto& p, int part) -> auto& { return p.pixel[part]; }),
        numbers<ClickedPair>(
            "place_mm", 3, -farthestPlace, farthestPlace,
            [](auto& p, int part) -> auto& { return p.place[part]; })};
    return fields;
}

const std::vector<Field<Artwork>>& artworkFields() {
    static const std::vector<Field<Artwork>> fields{colourOrNone<Artwork>(
        "base_colour", [](auto& a) -> auto& { return a.base; })};
    return fields;
}

const std::vector<Field<ArtworkLayer>>& artworkLayerFields() {
    constexpr int lettersOfId = 64;
    static const std::vector<Field<ArtworkLayer>> fields{
        text<ArtworkLayer>(
            "name", longestLayerName, [](auto& l) -> auto& { return l.name; }),
        choice<ArtworkLayer>(
            "kind",
            {QStringLiteral("picture"), QStringLiteral("text"), QStringLiteral("carbon"),
             QStringLiteral("camouflage"), QStringLiteral("wood")},
            [](auto& l) -> auto& { return l.kind; }),
        flag<ArtworkLayer>(
            "visible", [](auto& l) -> auto& { return l.visible; }),
        number<ArtworkLayer>(
            "opacity", 0, 1, [](auto& l) -> auto& { return l.opacity; }),
        text<ArtworkLayer>(
            "picture", lettersOfId, [](auto& l) -> auto& { return l.picture.id; }),
        textOfLines<ArtworkLayer>(
            "text", longestLayerText, [](auto& l) -> auto& { return l.text; }),
        text<ArtworkLayer>(
            "font", longestLayerName, [](auto& l) -> auto& { return l.font; }),
        colour<ArtworkLayer>(
            "colour", [](auto& l) -> auto& { return l.colour; }),
        colour<ArtworkLayer>(
            "second_colour", [](auto& l) -> auto& { return l.secondColour; }),
        number<ArtworkLayer>(
            "seed", 0, mostSeed, [](auto& l) -> auto& { return l.seed; }),
        choice<ArtworkLayer>(
            "placement",
            {QStringLiteral("decal"), QStringLiteral("plane"), QStringLiteral("cylinder"),
             QStringLiteral("box")},
            [](auto& l) -> auto& { return l.placement; }),
        choice<ArtworkLayer>(
            "axis",
            {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z"), QStringLiteral("-x"),
             QStringLiteral("-y"), QStringLiteral("-z")},
            [](auto& l) -> auto& { return l.axis; }),
        numbers<ArtworkLayer>(
            "place_mm", 3, -farthestPlace, farthestPlace,
            [](auto& l, int part) -> auto& { return l.place[part]; }),
        number<ArtworkLayer>(
            "turn_deg", -360, 360, [](auto& l) -> auto& { return l.turn; }),
        numbers<ArtworkLayer>(
            "size_mm", 2, smallestLayer, largestLayer,
            [](auto& l, int part) -> auto& { return l.size[part]; }),
        number<ArtworkLayer>(
            "repeat_mm", 0, largestLayer, [](auto& l) -> auto& { return l.repeat; }),
        spotName<ArtworkLayer>(
            "spot", [](auto& l) -> auto& { return l.spot; }, true),
        omittedIfDefault(colour<ArtworkLayer>(
            "spot_colour", [](auto& l) -> auto& { return l.spotColour; })),
        omittedIfDefault(flag<ArtworkLayer>(
            "spot_first", [](auto& l) -> auto& { return l.spotFirst; })),
        omittedIfDefault(text<ArtworkLayer>(
            "material", longestMaterialName, [](auto& l) -> auto& { return l.material; }))};
    return fields;
}

} // namespace dipwright
