// Defines the file format of profiles as tables of fields.
#include "project/ProfileFields.h"
#include "project/Profiles.h"

#include "base/Error.h"
#include "project/FieldJson.h"
#include "project/FieldMakers.h"
#include "project/FilmFields.h"
#include "project/Project.h"

#include <QCoreApplication>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Profiles)
};

constexpr const char* formatKey = "format";
constexpr const char* versionKey = "version";
constexpr const char* kindKey = "kind";
constexpr int profileVersion = 1;
constexpr int longestName = 100;
constexpr int longestIccProfile = 16 << 20; // bytes
constexpr double mostLaydown = 1000;        // ml/m²
constexpr double mostPrice = 1e6;

template <typename Owner>
Field<Owner> nameField() {
    return text<Owner>(
        "name", longestName, [](auto& p) -> auto& { return p.name; });
}

Field<PrinterProfile> iccField(const char* path, QByteArray PrinterProfile::*file) {
    return {QString::fromLatin1(path),
            {FieldKind::Text, 1, false, 0, double(longestIccProfile) * 4 / 3 + 4},
            [file](const PrinterProfile& p) { return QString::fromLatin1((p.*file).toBase64()); },
            [file, path](PrinterProfile& p, const QJsonValue& value) {
                const auto bytes = QByteArray::fromBase64Encoding(
                    value.toString().toLatin1(), QByteArray::AbortOnBase64DecodingErrors);
                if (!bytes) {
                    throw Error(
                        Text::tr("The ICC profile is not valid base64 text; import it again"),
                        QString::fromLatin1(path));
                }
                p.*file = *bytes;
            }};
}

std::vector<Field<InkCosts>> inkCostFields() {
    using C = InkCosts;
    return {numbers<C>(
                "ink_ml_per_m2", 4, 0, mostLaydown,
                [](auto& c, int ink) -> auto& { return c.laydown[std::size_t(ink)]; }),
            numbers<C>(
                "ink_price_per_l", 4, 0, mostPrice,
                [](auto& c, int ink) -> auto& { return c.price[std::size_t(ink)]; }),
            numbers<C>(
                "spot_ml_per_m2", 2, 0, mostLaydown,
                [](auto& c, int ink) -> auto& { return c.spotLaydown[std::size_t(ink)]; }),
            numbers<C>(
                "spot_price_per_l", 2, 0, mostPrice,
                [](auto& c, int ink) -> auto& { return c.spotPrice[std::size_t(ink)]; })};
}

std::vector<Field<FilmCosts>> filmCostFields() {
    using C = FilmCosts;
    return {numberOrNone<C>(
                "film_price", 0, mostPrice, [](auto& c) -> auto& { return c.price; }),
            choice<C>(
                "film_price_per",
                {QStringLiteral("m2"), QStringLiteral("roll metre"), QStringLiteral("sheet")},
                [](auto& c) -> auto& { return c.unit; })};
}

std::vector<Field<WorkCosts>> workCostFields() {
    using C = WorkCosts;
    constexpr double mostMinutes = 10'000;
    return {numberOrNone<C>(
                "labour_per_h", 0, mostPrice, [](auto& c) -> auto& { return c.labourRate; }),
            numberOrNone<C>(
                "setup_min", 0, mostMinutes, [](auto& c) -> auto& { return c.setUp; }),
            numberOrNone<C>(
                "handling_min", 0, mostMinutes, [](auto& c) -> auto& { return c.handling; }),
            number<C>(
                "parts_per_rack", 1, 1000, [](auto& c) -> auto& { return c.partsPerRack; }),
            number<C>(
                "scrap", 0, 0.9, [](auto& c) -> auto& { return c.scrap; }),
            text<C>(
                "currency", 10, [](auto& c) -> auto& { return c.currency; })};
}

// Adds the fields of a profile's costs. A file omits those that are not given.
template <typename P, typename C>
void addCosts(std::vector<Field<P>>& fields, const std::vector<Field<C>>& costs) {
    for (const Field<C>& field : costs) {
        fields.push_back(omittedIfDefault(fieldOf<P>(
            QStringLiteral("cost."), field, [](auto& p) -> auto& { return p.costs; })));
    }
}

const std::vector<Field<PrinterProfile>>& fieldsOf(const PrinterProfile*) {
    using P = PrinterProfile;
    static const std::vector<Field<P>> fields = [] {
        std::vector<Field<P>> all{
            nameField<P>(),
            text<P>(
                "queue", 255, [](auto& p) -> auto& { return p.queue; }),
            numbers<P>(
                "scale", 2, 0.9, 1.1,
                [](auto& p, int part) -> auto& { return part == 0 ? p.scaleX : p.scaleY; }),
            numbers<P>(
                "margins_mm", 4, 0, 100,
                [](auto& p, int part) -> auto& { return p.margins[std::size_t(part)]; }),
            iccField("icc_profile", &P::iccProfile),
            choice<P>(
                "intent",
                {QStringLiteral("perceptual"), QStringLiteral("relative"),
                 QStringLiteral("saturation"), QStringLiteral("absolute")},
                [](auto& p) -> auto& { return p.intent; }),
            flag<P>(
                "black_point_compensation", [](auto& p) -> auto& { return p.blackPoint; }),
            number<P>(
                "ink_limit", 0.1, 10, [](auto& p) -> auto& { return p.inkLimit; }),
            number<P>(
                "dpi", 30, 2400, [](auto& p) -> auto& { return p.resolution; }),
            omittedIfDefault(numberOrNone<P>(
                "total_ink", 1, 4, [](auto& p) -> auto& { return p.totalInk; })),
            omittedIfDefault(choice<P>(
                "kept_inks",
                {QStringLiteral("none"), QStringLiteral("black"), QStringLiteral("pure")},
                [](auto& p) -> auto& { return p.keptInks; })),
            omittedIfDefault(iccField("device_link", &P::deviceLink)),
            omittedIfDefault(choice<P>(
                "pdf_target",
                {QStringLiteral("ghostscript"), QStringLiteral("adobe"), QStringLiteral("older")},
                [](auto& p) -> auto& { return p.pdfTarget; })),
            omittedIfDefault(flag<P>(
                "square_pixels", [](auto& p) -> auto& { return p.squarePixels; })),
            omittedIfDefault(numberOrNone<P>(
                "roll_gap_mm", 0, 200, [](auto& p) -> auto& { return p.rollGap; })),
            omittedIfDefault(numberOrNone<P>(
                "roll_width_mm", 50, 5000, [](auto& p) -> auto& { return p.rollWidth; }))};
        addCosts(all, inkCostFields());
        return all;
    }();
    return fields;
}

void addMeasurement(std::vector<Field<FilmProfile>>& fields) {
    using P = FilmProfile;
    constexpr int longestHashes = 4096;
    fields.push_back(dateField<P>(
        "measured.date", [](auto& p) -> auto& { return p.measured.date; }));
    fields.push_back(inUnit("°C", numberOrNone<P>(
                                      "measured.water_temperature_c", 0, 100, [](auto& p) -> auto& {
                                          return p.measured.waterTemperature;
                                      })));
    fields.push_back(text<P>(
        "measured.photos", longestHashes, [](auto& p) -> auto& { return p.measured.photos; }));
    fields.push_back(number<P>(
        "measured.residual_mm", 0, 100, [](auto& p) -> auto& { return p.measured.residual; }));
    fields.push_back(numbers<P>(
        "measured.swell", 2, 0, 2, [](auto& p, int part) -> auto& {
            return part == 0 ? p.measured.swellX : p.measured.swellY;
        }));
    fields.push_back(numbers<P>(
        "measured.swell_off", 2, 0, 2, [](auto& p, int part) -> auto& {
            return part == 0 ? p.measured.swellErrorX : p.measured.swellErrorY;
        }));
    fields.push_back(inUnit("1/s", numberOrNone<P>(
                                       "measured.growth_per_s", 0, mostGrowthRate,
                                       [](auto& p) -> auto& { return p.measured.growthRate; })));
    fields.push_back(numberOrNone<P>(
        "measured.growth_limit", 0, mostGrowth,
        [](auto& p) -> auto& { return p.measured.growthLimit; }));
    fields.push_back(notHashedIfDefault(numberOrNone<P>(
        "measured.relaxation_time_s", 0, 1e6,
        [](auto& p) -> auto& { return p.measured.relaxationTime; })));
}

// Adds the fields that a project has too.
void addMaterial(std::vector<Field<FilmProfile>>& fields) {
    using P = FilmProfile;
    for (const auto& material : filmBehaviourFields()) {
        fields.push_back(fieldOf<P>(
            {}, material.field, [](auto& p) -> auto& { return p.behaviour(); }));
    }
    for (const auto& material : inkLawFields()) {
        fields.push_back(fieldOf<P>(
            QStringLiteral("ink_"), material.field, [](auto& p) -> auto& { return p.ink; }));
    }
    const FilmLimitFields limits = filmLimitFields();
    fields.push_back(notHashedIfDefault(optionalFieldOf<P>(
        limits.overhang.field, &ProcessSettings::overhang,
        [](auto& p) -> auto& { return p.overhang; })));
    fields.push_back(notHashedIfDefault(optionalFieldOf<P>(
        limits.tearStretch.field, &ProcessSettings::tearStretch,
        [](auto& p) -> auto& { return p.tearStretch; })));
}

const std::vector<Field<FilmProfile>>& fieldsOf(const FilmProfile*) {
    using P = FilmProfile;
    static const std::vector<Field<P>> fields = [] {
        std::vector<Field<P>> all{
            nameField<P>(),
            numbers<P>(
                "size_mm", 2, 10, 3000,
                [](auto& p, int part) -> auto& { return part == 0 ? p.width : p.height; }),
            choice<P>(
                "feed", {QStringLiteral("short edge first"), QStringLiteral("long edge first")},
                [](auto& p) -> auto& { return p.feed; }),
            number<P>(
                "soak_time_s", 0, 3600, [](auto& p) -> auto& { return p.soakTime; }),
            number<P>(
                "activator_time_s", 0, 3600, [](auto& p) -> auto& { return p.activatorTime; }),
            notHashedIfDefault(numberOrNone<P>(
                "flash_time_s", 0, 86'400, [](auto& p) -> auto& { return p.flashTime; })),
            notHashedIfDefault(numberOrNone<P>(
                "drying_time_s", 0, 604'800, [](auto& p) -> auto& { return p.dryingTime; })),
            text<P>(
                "lot", 100, [](auto& p) -> auto& { return p.lot; }),
            dateField<P>(
                "expiry", [](auto& p) -> auto& { return p.expiry; })};
        addMaterial(all);
        addMeasurement(all);
        addCosts(all, filmCostFields());
        return all;
    }();
    return fields;
}

const std::vector<Field<TankProfile>>& fieldsOf(const TankProfile*) {
    using P = TankProfile;
    static const std::vector<Field<P>> fields = [] {
        std::vector<Field<P>> all{
            nameField<P>(),
            numbers<P>(
                "size_mm", 2, 10, 10000,
                [](auto& p, int part) -> auto& { return part == 0 ? p.width : p.length; }),
            number<P>(
                "water_level_mm", 0, 2000, [](auto& p) -> auto& { return p.waterLevel; }),
            numbers<P>(
                "mark_distance_mm", 2, 0, 10000,
                [](auto& p, int part) -> auto& { return p.markDistance[std::size_t(part)]; }),
            notHashedIfDefault(numberOrNone<P>(
                "water_depth_mm", 1, 10000, [](auto& p) -> auto& { return p.waterDepth; })),
            notHashedIfDefault(numberOrNone<P>(
                "reach_mm", 0, 10000, [](auto& p) -> auto& { return p.reach; })),
            notHashedIfDefault(numberOrNone<P>(
                "speed_mm_s", 0.1, 10000, [](auto& p) -> auto& { return p.speed; })),
            notHashedIfDefault(numberOrNone<P>(
                "turn_speed_deg_s", 0.1, 10000, [](auto& p) -> auto& { return p.turnSpeed; }))};
        const auto add = [&all](const char* path, bool FilmEdges::*side) {
            all.push_back(choice<P>(
                path, edgeWords(), [side](auto& p) -> auto& { return p.barriers.*side; }));
        };
        add("barriers.left", &FilmEdges::leftPinned);
        add("barriers.right", &FilmEdges::rightPinned);
        add("barriers.top", &FilmEdges::topPinned);
        add("barriers.bottom", &FilmEdges::bottomPinned);
        addCosts(all, workCostFields());
        return all;
    }();
    return fields;
}

void checkFormat(const QJsonObject& json, const QString& where) {
    if (json.value(QLatin1String(formatKey)).toString() != QLatin1String("dipwright-profile")) {
        throw Error(Text::tr("This is not a Dipwright profile"), where);
    }
    const QJsonValue version = json.value(QLatin1String(versionKey));
    checkValue({FieldKind::WholeNumber, 1, false, 1, 1e6}, version, QStringLiteral("version"),
               where);
    if (version.toInt() > profileVersion) {
        throw Error(
            Text::tr("The profile has version %1 of the file format, but this program reads only "
                     "up to version %2; open it with a newer Dipwright")
                .arg(version.toInt())
                .arg(profileVersion),
            where);
    }
}

template <typename P>
Profile read(const QJsonObject& json, const QString& where) {
    P profile;
    readFields(profile, fieldsOf(&profile), json, {}, where);
    profile.unknown = withoutFields(json, fieldsOf(&profile));
    for (const char* key : {formatKey, versionKey, kindKey}) {
        profile.unknown.remove(QLatin1String(key));
    }
    if (profile.name.simplified().isEmpty()) {
        throw Error(Text::tr("A profile needs a name"), where);
    }
    return profile;
}

template <typename P>
const Field<P>& fieldAt(const P& profile, const QString& path) {
    QStringList paths;
    for (const Field<P>& field : fieldsOf(&profile)) {
        if (field.path == path) {
            return field;
        }
        paths << field.path;
    }
    throw Error(Text::tr("This profile has no value of this name; choose one of: %1")
                    .arg(paths.join(QStringLiteral(", "))),
                path);
}

} // namespace

Profile newProfile(ProfileKind kind) {
    switch (kind) {
    case ProfileKind::Printer:
        return PrinterProfile{};
    case ProfileKind::Film:
        return FilmProfile{};
    case ProfileKind::Tank:
        break;
    }
    return TankProfile{};
}

QStringList profilePaths(ProfileKind kind) {
    return std::visit(
        [](const auto& profile) {
            QStringList paths;
            for (const auto& field : fieldsOf(&profile)) {
                paths << field.path;
            }
            return paths;
        },
        newProfile(kind));
}

FieldRule profileRule(ProfileKind kind, const QString& path) {
    return std::visit([&](const auto& profile) { return fieldAt(profile, path).rule; },
                      newProfile(kind));
}

QJsonValue profileValue(const Profile& profile, const QString& path) {
    return std::visit([&](const auto& one) { return fieldAt(one, path).get(one); }, profile);
}

void setProfileValue(Profile& profile, const QString& path, const QJsonValue& value) {
    std::visit(
        [&](auto& one) {
            const auto& field = fieldAt(one, path);
            checkValue(field.rule, value, path, {});
            setField(one, field, value);
        },
        profile);
}

void setByPath(Profile& profile, const QString& path, const QString& value) {
    std::visit(
        [&](auto& one) {
            const auto& field = fieldAt(one, path);
            setField(one, field, parseValue(field.rule, value, path));
        },
        profile);
}

QJsonObject toJson(const Profile& profile) {
    QJsonObject json = std::visit([](const auto& value) { return value.unknown; }, profile);
    json.insert(QLatin1String(formatKey), QStringLiteral("dipwright-profile"));
    json.insert(QLatin1String(versionKey), profileVersion);
    json.insert(QLatin1String(kindKey), profileKindName(kindOf(profile)));
    std::visit([&](const auto& value) { writeFields(value, fieldsOf(&value), json); }, profile);
    return json;
}

QJsonObject countedValues(const FilmProfile& film) {
    QJsonObject json = toJson(Profile(film));
    removeUncounted(json, fieldsOf(&film));
    if (film.measured == FilmMeasurement()) {
        json.remove(QLatin1String("measured"));
    }
    return json;
}

Profile profileFromJson(const QJsonObject& json, const QString& where) {
    checkFormat(json, where);
    switch (profileKindOf(json.value(QLatin1String(kindKey)).toString())) {
    case ProfileKind::Printer:
        return read<PrinterProfile>(json, where);
    case ProfileKind::Film:
        return read<FilmProfile>(json, where);
    case ProfileKind::Tank:
        break;
    }
    return read<TankProfile>(json, where);
}

} // namespace dipwright
