#include "project/Project.h"

#include "base/Error.h"
#include "base/OneLine.h"
#include "import/trusted/ImportModel.h"
#include "project/CadModel.h"
#include "project/FieldJson.h"
#include "project/ProfileFields.h"
#include "project/Profiles.h"
#include "project/Schema.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <limits>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Project)
};

constexpr int maximumImmersions = 2;
constexpr const char* shareMarksPath = "share.marks";
constexpr const char* zoneMarksPath = "tolerance.marks";
constexpr const char* masksPath = "masks";
constexpr const char* builtPartsPath = "as_built.parts";
constexpr const char* builtPlacesPath = "as_built.places";
constexpr const char* tankTimesPath = "as_built.times";
constexpr const char* photosPath = "inspection.photos";
constexpr const char* pairsPath = "inspection.pairs";
constexpr const char* floatingPath = "inspection.film.photos";
constexpr const char* artworkPath = "artwork";
constexpr const char* layersPath = "artwork.layers";

// Reads a list of objects that have fields of their own. `path` is the list's path.
template <typename Item>
std::vector<Item> readList(const QJsonArray& array, const std::vector<Field<Item>>& fields,
                           const QString& path, const QString& file) {
    std::vector<Item> items;
    for (int index = 0; index < array.size(); ++index) {
        const QString itemPath = QStringLiteral("%1[%2]").arg(path).arg(index);
        if (!array.at(index).isObject()) {
            throw Error(Text::tr("%1 must be an object").arg(itemPath), file);
        }
        Item item;
        const QJsonObject json = array.at(index).toObject();
        readFields(item, fields, json, itemPath + QLatin1Char('.'), file);
        item.unknown = withoutFields(json, fields);
        items.push_back(item);
    }
    return items;
}

template <typename Item>
QJsonArray writeList(const std::vector<Item>& items, const std::vector<Field<Item>>& fields) {
    QJsonArray array;
    for (const Item& item : items) {
        QJsonObject json = item.unknown;
        writeFields(item, fields, json);
        array.append(json);
    }
    return array;
}

std::vector<Immersion> readImmersions(const QJsonValue& value, const QString& file) {
    const QJsonArray array = value.toArray();
    if (!value.isArray() || array.isEmpty() || array.size() > maximumImmersions) {
        throw Error(Text::tr("immersions must be an array with one or two entries"), file);
    }
    return readList(array, immersionFields(), QStringLiteral("immersions"), file);
}

// Reads a list that may be missing and has at most `most` items.
template <typename Item>
std::vector<Item> readEntries(const QJsonObject& json, const std::vector<Field<Item>>& fields,
                              const char* list, std::size_t most, const QString& file) {
    const QString path = QString::fromLatin1(list);
    const QJsonValue value = valueAt(json, path, file);
    if (value.isUndefined()) {
        return {};
    }
    if (!value.isArray() || std::size_t(value.toArray().size()) > most) {
        throw Error(Text::tr("%1 must be an array of at most %2 entries").arg(path).arg(most),
                    file);
    }
    return readList(value.toArray(), fields, path, file);
}

// Reads a list of marks on the body. Bounds the points of all their brush strokes together.
template <typename Mark>
std::vector<Mark> readMarks(const QJsonObject& json, const std::vector<Field<Mark>>& fields,
                            const char* list, std::size_t most, const QString& file) {
    std::vector<Mark> marks = readEntries(json, fields, list, most, file);
    std::size_t points = 0;
    for (const Mark& mark : marks) {
        points += mark.path.size();
    }
    if (points > mostBrushPointsOfAll) {
        throw Error(Text::tr("The brush strokes in %1 have %2 points; at most %3 are possible")
                        .arg(QString::fromLatin1(list))
                        .arg(points)
                        .arg(mostBrushPointsOfAll),
                    file);
    }
    return marks;
}

template <typename P>
void readProfile(std::optional<P>& profile, const char* key, const QJsonObject& profiles,
                 const QString& file) {
    const QJsonValue value = profiles.value(QLatin1String(key));
    if (!value.isUndefined()) {
        const Profile read = profileFromJson(
            value.toObject(), QStringLiteral("%1: profiles.%2").arg(file, QLatin1String(key)));
        if (!std::holds_alternative<P>(read)) {
            throw Error(
                Text::tr("profiles.%1 holds a profile of another kind").arg(QLatin1String(key)),
                file);
        }
        profile = std::get<P>(read);
    }
}

ProjectProfiles readProfiles(const QJsonObject& json, const QString& file) {
    ProjectProfiles profiles;
    const QJsonObject object = json.value(QLatin1String("profiles")).toObject();
    readProfile(profiles.printer, "printer", object, file);
    readProfile(profiles.film, "film", object, file);
    readProfile(profiles.tank, "tank", object, file);
    return profiles;
}

void writeProfiles(const ProjectProfiles& profiles, QJsonObject& json) {
    const auto write = [&](const char* path, const auto& profile) {
        if (profile) {
            insertAt(json, QLatin1String(path), toJson(Profile(*profile)));
        }
    };
    write("profiles.printer", profiles.printer);
    write("profiles.film", profiles.film);
    write("profiles.tank", profiles.tank);
}

Artwork readArtwork(const QJsonObject& json, const QString& file) {
    Artwork artwork;
    const QString path = QString::fromLatin1(artworkPath);
    if (const QJsonValue value = valueAt(json, path, file); !value.isUndefined()) {
        if (!value.isObject()) {
            throw Error(Text::tr("%1 must be an object").arg(path), file);
        }
        readFields(artwork, artworkFields(), value.toObject(), path + QLatin1Char('.'), file);
    }
    artwork.layers = readEntries(json, artworkLayerFields(), layersPath, mostArtworkLayers, file);
    return artwork;
}

// Writes nothing if there is no artwork, so that such files stay as in versions without artwork.
void writeArtwork(const Artwork& artwork, QJsonObject& json) {
    if (!artwork.isEmpty()) {
        QJsonObject own = json.value(QLatin1String(artworkPath)).toObject();
        writeFields(artwork, artworkFields(), own);
        json.insert(QLatin1String(artworkPath), own);
        insertAt(json, QString::fromLatin1(layersPath),
                 writeList(artwork.layers, artworkLayerFields()));
    }
}

// Returns the keys that this version does not know, nested as in the file. The entries of lists and
// the profiles keep theirs.
QJsonObject unknownPart(const QJsonObject& json) {
    QJsonObject unknown = withoutFields(json, projectFields());
    for (const char* key : {"format", "version", "immersions"}) {
        unknown.remove(QLatin1String(key));
    }
    for (const char* path : {"model.mesh", "model.texture", "model.textures", "model.inks"}) {
        removeAt(unknown, QLatin1String(path)); // ProjectStore writes these
    }
    for (const char* path : {"profiles.printer", "profiles.film", "profiles.tank"}) {
        removeAt(unknown, QLatin1String(path));
    }
    for (const char* path :
         {shareMarksPath, zoneMarksPath, masksPath, builtPartsPath, builtPlacesPath, tankTimesPath,
          photosPath, pairsPath, floatingPath, layersPath}) {
        removeAt(unknown, QString::fromLatin1(path));
    }
    for (const Field<Artwork>& field : artworkFields()) {
        removeAt(unknown, QString::fromLatin1(artworkPath) + QLatin1Char('.') + field.path);
    }
    return unknown;
}

void checkFormat(const QJsonObject& json, const QString& file) {
    if (json.value(QLatin1String("format")).toString() != QLatin1String("dipwright-project")) {
        throw Error(Text::tr("This is not a Dipwright project"), file);
    }
    const QJsonValue version = json.value(QLatin1String("version"));
    checkValue({FieldKind::WholeNumber, 1, false, 1, 1e6}, version, QStringLiteral("version"),
               file);
    if (version.toInt() > projectVersion) {
        throw Error(Text::tr("The project has version %1 of the file format, but this program "
                             "reads only up to version %2; open it with a newer Dipwright")
                        .arg(version.toInt())
                        .arg(projectVersion),
                    file);
    }
}

// Up to version 1 each dip painted all that it reached; such a project keeps doing so.
void shareNothing(QJsonObject& json) {
    insertAt(json, QStringLiteral("share.enabled"), false);
}

// Up to version 2 every part went straight down, as it does without a path.
void keepsAll(QJsonObject&) {}

// The migration at index n takes a document from version n + 1 to the next.
using Migration = void (*)(QJsonObject&);
const std::vector<Migration> migrations{shareNothing, keepsAll};

QJsonObject migrated(QJsonObject json) {
    const auto version = std::size_t(json.value(QLatin1String("version")).toInt());
    for (std::size_t step = version - 1; step < migrations.size(); ++step) {
        migrations[step](json);
    }
    return json;
}

const QString tessellationPath = QStringLiteral("model.tessellation_mm");

// Whether a value of the project can be set by its path. Most of the model's come from its file.
bool isSettable(const QString& path) {
    return !path.startsWith(QLatin1String("model.")) || path == tessellationPath;
}

// Returns the paths that can be set in the same section as an unknown one, for a hint.
QStringList siblingPaths(const QString& path) {
    const QString section = path.left(path.indexOf(QLatin1Char('.')) + 1);
    QStringList paths;
    for (const auto& field : projectFields()) {
        if (!section.isEmpty() && field.path.startsWith(section) && isSettable(field.path)) {
            paths.append(field.path);
        }
    }
    return paths;
}

// Returns the words with which the paths that can be set begin.
QStringList firstWords() {
    QStringList words;
    for (const Field<Project>& field : projectFields()) {
        if (isSettable(field.path)) {
            words << field.path.section(QLatin1Char('.'), 0, 0);
        }
    }
    words << QStringLiteral("immersions[0]") << QString::fromLatin1(masksPath)
          << QString::fromLatin1(artworkPath);
    words.removeDuplicates();
    return words;
}

[[noreturn]] void throwUnknownPath(const QString& path) {
    const QStringList siblings = siblingPaths(path);
    const QString hint =
        siblings.isEmpty()
            ? Text::tr("a path begins with one of %1").arg(firstWords().join(QStringLiteral(", ")))
            : Text::tr("the settings in this section are %1")
                  .arg(siblings.join(QStringLiteral(", ")));
    throw Error(Text::tr("There is no such setting; %1").arg(hint), path);
}

template <typename Owner>
bool setFieldAt(Owner& owner, const std::vector<Field<Owner>>& fields, const QString& fieldPath,
                const QString& path, const QString& text) {
    for (const Field<Owner>& field : fields) {
        if (field.path == fieldPath) {
            setField(owner, field, parseValue(field.rule, text, path));
            return true;
        }
    }
    return false;
}

} // namespace

QString projectName(const QString& path) {
    return oneLine(QFileInfo(path).completeBaseName()).left(longestProjectName);
}

void applyPreset(Project& project, const QString& preset) {
    const ProcessSettings standard;
    if (preset == QLatin1String("production")) {
        project.film.lattice = solver::Lattice::Isotropic;
        project.film.support = solver::Support::Water;
    } else if (preset == QLatin1String("paper-2020")) {
        project.film.lattice = solver::Lattice::Structural;
        project.film.support = solver::Support::None;
        project.film.relaxationTime = Seconds(std::numeric_limits<double>::infinity());
        project.film.edges = {};
        project.film.growthRate = 0;
    } else {
        throw Error(Text::tr("There is no preset %1; use production or paper-2020").arg(preset),
                    QStringLiteral("preset"));
    }
    project.process.dipSpeed = standard.dipSpeed;
    project.process.timeStep = standard.timeStep;
    project.process.iterations = standard.iterations;
    project.process.relaxation = standard.relaxation;
    project.process.selfContact = standard.selfContact;
}

namespace {

const QString layerPictureField = QStringLiteral("picture");

// Tells which fields there are. `message` has a place for their names; `hidden` is not among them.
template <typename Owner>
[[noreturn]] void throwUnknownField(const QString& message, const std::vector<Field<Owner>>& fields,
                                    const QString& path, const QString& hidden = {}) {
    QStringList names;
    for (const Field<Owner>& field : fields) {
        names << field.path;
    }
    names.removeAll(hidden);
    throw Error(message.arg(names.join(QStringLiteral(", "))), path);
}

// Sets a value such as "artwork.base_colour" or "artwork.layers[0].turn_deg". A layer's picture
// cannot be set, because its field is only an id. Returns false if the path names no value of the
// artwork. Throws Error if it names no value of a layer.
bool setArtworkAt(Artwork& artwork, const QString& path, const QString& value) {
    static const QRegularExpression layerPath(
        QStringLiteral("^artwork\\.layers\\[(0|[1-9]\\d{0,2})\\]\\.(.+)$"));
    const QString own = QString::fromLatin1(artworkPath) + QLatin1Char('.');
    if (const auto match = layerPath.match(path); match.hasMatch()) {
        const auto index = match.captured(1).toUInt();
        if (index >= artwork.layers.size()) {
            throw Error(Text::tr("There is no such layer; the number of layers is %1, and the "
                                 "lowest is artwork.layers[0]")
                            .arg(artwork.layers.size()),
                        path);
        }
        const QString field = match.captured(2);
        if (field == layerPictureField ||
            !setFieldAt(artwork.layers[index], artworkLayerFields(), field, path, value)) {
            throwUnknownField(Text::tr("A layer has no such setting; its settings are %1"),
                              artworkLayerFields(), path, layerPictureField);
        }
        return true;
    }
    return path.startsWith(own) &&
           setFieldAt(artwork, artworkFields(), path.mid(own.size()), path, value);
}

} // namespace

namespace {

// A project file keeps unknown keys, as of a newer version. A typed one is a mistake.
template <typename Mark>
void requireKnownKeys(const std::vector<Mark>& marks, const std::vector<Field<Mark>>& fields,
                      const QString& list) {
    for (std::size_t index = 0; index < marks.size(); ++index) {
        if (const QStringList keys = marks[index].unknown.keys(); !keys.isEmpty()) {
            throwUnknownField(Text::tr("An entry has no such key; its keys are %1"), fields,
                              QStringLiteral("%1[%2].%3").arg(list).arg(index).arg(keys.first()));
        }
    }
}

// Sets a list of marks from its JSON text. Returns false if the path names no such list.
bool setMarksAt(Project& project, const QString& path, const QString& value) {
    const auto set = [&](const char* list, const auto& fields, std::size_t most, auto& marks) {
        if (path != QLatin1String(list)) {
            return false;
        }
        const QJsonDocument document = QJsonDocument::fromJson(value.toUtf8());
        if (!document.isArray()) {
            throw Error(Text::tr("The value must be a list in JSON, as in the project file"), path);
        }
        QJsonObject json;
        insertAt(json, path, document.array());
        auto read = readMarks(json, fields, list, most, {});
        requireKnownKeys(read, fields, path);
        marks = std::move(read);
        return true;
    };
    return set(masksPath, maskMarkFields(), mostMaskMarks, project.masks) ||
           set(zoneMarksPath, zoneMarkFields(), mostZoneMarks, project.tolerance.marks) ||
           set(shareMarksPath, shareMarkFields(), mostShareMarks, project.share.marks);
}

// Makes the triangles of a CAD model again if the path and value ask for it. Returns false for
// another path. Without a model, as in a new project, only notes the value.
bool setTessellationAt(Project& project, const QString& path, const QString& value) {
    if (path != tessellationPath) {
        return false;
    }
    Project changed = project;
    setFieldAt(changed, projectFields(), path, path, value);
    const Millimetres tolerance = changed.modelOrigin.tessellation;
    if (project.model && tolerance != project.modelOrigin.tessellation) {
        takeModel(changed, retessellated(project, tolerance, {}), project.modelOrigin.source);
        changed.cad.name = project.cad.name;
    }
    project = std::move(changed);
    return true;
}

} // namespace

void setByPath(Project& project, const QString& path, const QString& value) {
    if (path == QLatin1String("created")) { // older files may hold any text
        requireDate(value, path);
    }
    static const QRegularExpression immersionPath(
        QStringLiteral("^immersions\\[(0|[1-9]\\d{0,2})\\]\\.(.+)$"));
    if (const auto match = immersionPath.match(path); match.hasMatch()) {
        const auto index = match.captured(1).toUInt();
        if (index >= project.immersions.size()) {
            throw Error(Text::tr("There is no such dip; the number of dips is %1, and the first is "
                                 "immersions[0]")
                            .arg(project.immersions.size()),
                        path);
        }
        if (setFieldAt(project.immersions[index], immersionFields(), match.captured(2), path,
                       value)) {
            return;
        }
    } else if (setTessellationAt(project, path, value) || setMarksAt(project, path, value) ||
               setArtworkAt(project.artwork, path, value) ||
               (isSettable(path) && setFieldAt(project, projectFields(), path, path, value))) {
        return;
    }
    throwUnknownPath(path);
}

QJsonObject pathToJson(const Immersion& immersion) {
    const QString prefix = QStringLiteral("path.");
    QJsonObject path;
    for (const Field<Immersion>& field : immersionFields()) {
        // Values that came later are left out while unused, so that sheets of before keep their
        // job number.
        const bool isNewer = field.path == QLatin1String("path.keys") ||
                             field.path == QLatin1String("path.acceleration_mm_s2");
        const QJsonValue value = field.get(immersion);
        if (field.path.startsWith(prefix) && (!isNewer || value != field.get(Immersion()))) {
            path.insert(field.path.mid(prefix.size()), value);
        }
    }
    return path;
}

QJsonObject toJson(const Project& project) {
    QJsonObject json = project.unknown;
    json.insert(QStringLiteral("format"), QStringLiteral("dipwright-project"));
    json.insert(QStringLiteral("version"), projectVersion);
    writeFields(project, projectFields(), json);
    json.insert(QStringLiteral("immersions"), writeList(project.immersions, immersionFields()));
    insertAt(json, QString::fromLatin1(shareMarksPath),
             writeList(project.share.marks, shareMarkFields()));
    insertAt(json, QString::fromLatin1(zoneMarksPath),
             writeList(project.tolerance.marks, zoneMarkFields()));
    if (!project.masks.empty()) {
        insertAt(json, QString::fromLatin1(masksPath), writeList(project.masks, maskMarkFields()));
    }
    insertAt(json, QString::fromLatin1(builtPartsPath),
             writeList(project.asBuilt.parts, builtPartFields()));
    insertAt(json, QString::fromLatin1(builtPlacesPath),
             writeList(project.asBuilt.places, builtPlaceFields()));
    if (!project.asBuilt.times.empty()) { // so that other files stay as in earlier versions
        insertAt(json, QString::fromLatin1(tankTimesPath),
                 writeList(project.asBuilt.times, tankTimeFields()));
    }
    insertAt(json, QString::fromLatin1(photosPath),
             writeList(project.inspection.photos, inspectedPhotoFields()));
    insertAt(json, QString::fromLatin1(pairsPath),
             writeList(project.inspection.pairs, clickedPairFields()));
    insertAt(json, QString::fromLatin1(floatingPath),
             writeList(project.filmOnWater.photos, floatingPhotoFields()));
    writeArtwork(project.artwork, json);
    writeProfiles(project.profiles, json);
    return json;
}

QJsonObject countedSettings(const Project& project) {
    QJsonObject json = toJson(project);
    removeUncounted(json, projectFields());
    if (project.profiles.film) {
        insertAt(json, QStringLiteral("profiles.film"), countedValues(*project.profiles.film));
    }
    json.insert(QStringLiteral("version"), 1);
    return json;
}

Project fromJson(const QJsonObject& json, const QString& where) {
    checkFormat(json, where);
    const QJsonObject current = migrated(json);
    Project project;
    readFields(project, projectFields(), current, {}, where);
    project.immersions = readImmersions(current.value(QLatin1String("immersions")), where);
    project.share.marks =
        readMarks(current, shareMarkFields(), shareMarksPath, mostShareMarks, where);
    project.tolerance.marks =
        readMarks(current, zoneMarkFields(), zoneMarksPath, mostZoneMarks, where);
    project.masks = readMarks(current, maskMarkFields(), masksPath, mostMaskMarks, where);
    project.asBuilt.parts =
        readEntries(current, builtPartFields(), builtPartsPath, mostBuiltParts, where);
    project.asBuilt.places =
        readEntries(current, builtPlaceFields(), builtPlacesPath, mostBuiltPlaces, where);
    project.asBuilt.times =
        readEntries(current, tankTimeFields(), tankTimesPath, mostTankTimes, where);
    project.inspection.photos =
        readEntries(current, inspectedPhotoFields(), photosPath, mostInspectedPhotos, where);
    project.inspection.pairs =
        readEntries(current, clickedPairFields(), pairsPath, mostClickedPairs, where);
    project.filmOnWater.photos =
        readEntries(current, floatingPhotoFields(), floatingPath, mostFloatingPhotos, where);
    for (const ClickedPair& pair : project.inspection.pairs) {
        if (std::size_t(pair.photo) >= project.inspection.photos.size()) {
            throw Error(Text::tr("inspection.pairs names a photo that is not in inspection.photos"),
                        where);
        }
    }
    for (const BuiltPlace& place : project.asBuilt.places) {
        if (std::size_t(place.part) > project.asBuilt.parts.size()) {
            throw Error(Text::tr("as_built.places names a part that is not in as_built.parts"),
                        where);
        }
    }
    project.artwork = readArtwork(current, where);
    project.profiles = readProfiles(current, where);
    project.unknown = unknownPart(current);
    return project;
}

} // namespace dipwright
