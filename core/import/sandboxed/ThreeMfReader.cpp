#include "import/sandboxed/ThreeMfReader.h"

#include "base/Budgets.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include <quazip.h>
#include <quazipfile.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

// The files in the package, by their names in it.
class Package {
public:
    explicit Package(const ModelSource& source) : source_(source) {
        buffer_.setData(source.bytes);
        zip_.setIoDevice(&buffer_);
        if (!zip_.open(QuaZip::mdUnzip)) {
            source.throwDamaged(Text::tr("it is not a 3MF package"));
        }
        requireWithin(Budget::Entries, zip_.getEntriesCount(), source.path);
    }

    // Returns a file of the package; nothing if there is no such file. Throws if it is damaged.
    std::optional<QByteArray> find(const QString& name) {
        const QString path = name.startsWith(u'/') ? name.sliced(1) : name;
        QuaZipFileInfo64 info;
        if (!zip_.setCurrentFile(path, QuaZip::csInsensitive) || !zip_.getCurrentFileInfo(&info)) {
            return std::nullopt;
        }
        if (info.isEncrypted()) {
            source_.throwDamaged(Text::tr("the file %1 in the package is encrypted").arg(path));
        }
        unpacked_ += qint64(std::min(info.uncompressedSize, quint64(1) << 62));
        requireWithin(Budget::UnpackedBytes, unpacked_, source_.path, source_.bytes.size());
        QuaZipFile file(&zip_);
        QByteArray bytes;
        if (file.open(QIODevice::ReadOnly)) {
            // Reads at most one byte more than declared, whatever the archive holds.
            bytes = file.read(qint64(info.uncompressedSize) + 1);
            file.close(); // checks the checksum
        }
        if (file.getZipError() != UNZ_OK || quint64(bytes.size()) != info.uncompressedSize) {
            source_.throwDamaged(Text::tr("the file %1 in the package is damaged").arg(path));
        }
        return bytes;
    }

private:
    const ModelSource& source_;
    QBuffer buffer_;
    QuaZip zip_;
    qint64 unpacked_ = 0; // bytes unpacked so far
};

constexpr int noGroup = -1, noTexture = -1;

// A list of properties that triangles choose from: materials, colours or texture coordinates.
struct PropertyGroup {
    std::vector<Material> materials;          // base materials and colours
    std::set<std::size_t> transparent;        // indices of materials
    std::vector<Eigen::Vector2f> coordinates; // texture coordinates
    int texture = noTexture;                  // index of the texture that the coordinates are for
    QString picture;                          // file of that texture
    bool isNotRepeated = false;               // the texture is mirrored or ends at its edge
};

struct ObjectTriangle {
    std::array<std::uint32_t, 3> corners{};
    int group = noGroup;
    std::array<int, 3> properties{};
};

struct Placement {
    QString part;
    int object = -1;
    bool isHidden = false;
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
};

struct Object {
    bool isSupport = false, isOther = false, isPainted = false;
    std::vector<Eigen::Vector3f> positions;
    std::vector<ObjectTriangle> triangles;
    std::vector<Placement> components;
};

// One file of the package that holds a model.
struct Part {
    double unit = 1; // in mm
    std::map<int, QString> pictures;
    std::set<int> notRepeated; // textures
    std::map<int, PropertyGroup> groups;
    std::map<int, Object> objects;
    std::vector<Placement> build;
};

// Returns the unit in millimetres; nothing if it is unknown.
std::optional<double> unitNamed(const QString& name) {
    static const std::map<QString, double> units{
        {QStringLiteral("micron"), 0.001},  {QStringLiteral("millimeter"), 1},
        {QStringLiteral("centimeter"), 10}, {QStringLiteral("inch"), 25.4},
        {QStringLiteral("foot"), 304.8},    {QStringLiteral("meter"), 1000}};
    const auto found = units.find(name);
    return found == units.end() ? std::nullopt : std::optional(found->second);
}

// Whether an extension is supported here, or affects neither shape nor colour.
bool isKnownNamespace(QStringView name) {
    static const QStringList known{
        QStringLiteral("http://schemas.microsoft.com/3dmanufacturing/core/2015/02"),
        QStringLiteral("http://schemas.microsoft.com/3dmanufacturing/material/2015/02"),
        QStringLiteral("http://schemas.microsoft.com/3dmanufacturing/production/2015/06"),
        QStringLiteral("http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07")};
    return known.contains(name);
}

// Splits at XML white space, which has fewer characters than Unicode white space.
QList<QStringView> wordsOf(QStringView text) {
    static const QRegularExpression space(QStringLiteral("[ \\t\\r\\n]+"));
    return text.split(space, Qt::SkipEmptyParts);
}

// Parses "#RRGGBB" or "#RRGGBBAA". The alpha is left out; isTransparent() reports it.
QColor colourNamed(QStringView name) {
    const QColor colour(name.first(std::min<qsizetype>(name.size(), 7)));
    return colour.isValid() ? colour : Material().colour;
}

bool isTransparent(const QString& name) {
    return name.size() == 9 && name.last(2).compare(u"ff", Qt::CaseInsensitive) != 0;
}

class PartReader {
public:
    PartReader(const QByteArray& bytes, const QString& name, const ModelSource& source,
               const CancelToken& cancelToken)
        : name_(name), source_(source), cancelToken_(cancelToken), xml_(&buffer_) {
        buffer_.setData(bytes);
        buffer_.open(QIODevice::ReadOnly);
    }

    Part read() {
        while (!xml_.atEnd()) {
            if (xml_.readNext() == QXmlStreamReader::StartElement) {
                attributes_ = xml_.attributes();
                readElement();
            }
        }
        if (xml_.hasError()) {
            source_.throwDamaged(Text::tr("the file %1 in the package has an error: %2")
                                     .arg(name_, xml_.errorString()));
        }
        resolveReferences();
        return std::move(part_);
    }

private:
    // Elements are identified by local name alone, which is unique among those used here.
    void readElement() {
        const QStringView name = xml_.name();
        if (name == u"vertex") {
            object().positions.emplace_back(float(real("x")), float(real("y")), float(real("z")));
        } else if (name == u"triangle") {
            readTriangle();
        } else if (name == u"tex2coord") {
            group().coordinates.push_back(statedCoordinates(float(real("u")), float(real("v"))));
        } else if (name == u"base") {
            addMaterial(text("name"), text("displaycolor"));
        } else if (name == u"color") {
            addMaterial(text("color"), text("color"));
        } else if (name == u"basematerials" || name == u"colorgroup") {
            openGroup_ = &added(part_.groups);
        } else if (name == u"texture2d") {
            added(part_.pictures) = text("path");
            if (!isRepeated("tilestyleu") || !isRepeated("tilestylev")) {
                part_.notRepeated.insert(integer("id"));
            }
        } else if (name == u"texture2dgroup") {
            openGroup_ = &added(part_.groups);
            openGroup_->texture = integer("texid");
        } else if (name == u"object") {
            readObject();
        } else if (name == u"component") {
            object().components.push_back(placement());
        } else if (name == u"item") {
            part_.build.push_back(placement());
        } else if (name == u"model") {
            readModel();
        } else {
            noteOtherResource();
        }
    }

    void addMaterial(const QString& name, const QString& colour) {
        if (isTransparent(colour)) {
            group().transparent.insert(group().materials.size());
        }
        group().materials.push_back({name, colourNamed(colour), -1});
    }

    void noteOtherResource() {
        bool isNumber = false;
        const int id = text("id").toInt(&isNumber);
        if (isNumber) {
            otherResources_.insert(id);
        }
    }

    void readModel() {
        const QString unit = text("unit");
        const auto known = unit.isEmpty() ? 1 : unitNamed(unit);
        if (!known) {
            source_.throwDamaged(Text::tr("its unit %1 is unknown").arg(unit));
        }
        part_.unit = *known;
        const QString prefixes = text("requiredextensions");
        for (const QStringView prefix : wordsOf(prefixes)) {
            requireExtension(prefix);
        }
    }

    void requireExtension(QStringView prefix) const {
        QString name = prefix.toString();
        for (const auto& declaration : xml_.namespaceDeclarations()) {
            if (declaration.prefix() == prefix) {
                name = declaration.namespaceUri().toString();
            }
        }
        if (!isKnownNamespace(name)) {
            source_.throwDamaged(
                Text::tr("it needs the 3MF extension %1, which is not supported").arg(name));
        }
    }

    // Adds a new resource of this kind. Resources of different kinds may share an ID, since the
    // kind is always known.
    template <typename Resource>
    Resource& added(std::map<int, Resource>& resources) {
        const auto [place, isNew] = resources.try_emplace(integer("id"));
        if (!isNew) {
            source_.throwDamaged(Text::tr("two of its resources have the ID %1").arg(place->first));
        }
        return place->second;
    }

    // The specification wants resources before their uses. Here they may also come later, since the
    // meaning is clear, but they must exist.
    void resolveReferences() {
        for (auto& [id, group] : part_.groups) {
            const auto picture = part_.pictures.find(group.texture);
            if (picture != part_.pictures.end()) {
                group.picture = picture->second;
                group.isNotRepeated = part_.notRepeated.contains(group.texture);
            } else if (group.texture != noTexture) {
                throwNoSuchResource();
            }
        }
        for (const int group : usedGroups_) {
            if (part_.groups.count(group) == 0 && otherResources_.count(group) == 0) {
                throwNoSuchResource();
            }
        }
    }

    [[noreturn]] void throwNoSuchResource() const {
        source_.throwDamaged(Text::tr("it refers to a material or texture that does not exist"));
    }

    void readObject() {
        cancelToken_.throwIfCancelled();
        openObject_ = &added(part_.objects);
        openObject_->isSupport = text("type").endsWith(QStringLiteral("support"));
        openObject_->isOther = text("type") == u"other";
        objectGroup_ = usedGroup(noGroup);
        objectProperty_ = integer("pindex", 0);
    }

    void readTriangle() {
        ObjectTriangle triangle;
        const char* corners[] = {"v1", "v2", "v3"};
        const char* properties[] = {"p1", "p2", "p3"};
        const int first = integer("p1", -1);
        triangle.group = first < 0 ? objectGroup_ : usedGroup(objectGroup_);
        for (std::size_t i = 0; i < 3; ++i) {
            const int corner = integer(corners[i]);
            if (corner < 0 || std::size_t(corner) >= object().positions.size()) {
                source_.throwDamaged(Text::tr("a triangle refers to a point that does not exist"));
            }
            triangle.corners[i] = std::uint32_t(corner);
            triangle.properties[i] = first < 0 ? objectProperty_ : integer(properties[i], first);
        }
        object().isPainted |= !text("paint_color").isEmpty() || !text("mmu_segmentation").isEmpty();
        object().triangles.push_back(triangle);
    }

    int usedGroup(int otherwise) {
        const int group = integer("pid", otherwise);
        if (group != otherwise) {
            usedGroups_.insert(group);
        }
        return group;
    }

    Placement placement() {
        Placement result;
        result.object = integer("objectid");
        result.isHidden = text("printable") == u"0" || text("printable") == u"false";
        result.part = text("path").isEmpty() ? name_ : text("path");
        const QString transform = text("transform");
        if (!transform.isNull()) {
            result.transform = transformNamed(transform);
        }
        return result;
    }

    void requireTransform(bool isWhole) const {
        if (!isWhole) {
            source_.throwDamaged(Text::tr("one of its transforms does not have twelve numbers"));
        }
    }

    Eigen::Affine3d transformNamed(const QString& text) const {
        const QList<QStringView> numbers = wordsOf(text);
        // A 4 × 3 matrix, multiplied by a row vector from the left.
        bool isWhole = numbers.size() == 12;
        Eigen::Affine3d transform = Eigen::Affine3d::Identity();
        for (int i = 0; isWhole && i < 12; ++i) {
            const double number = numbers[i].toDouble(&isWhole);
            isWhole = isWhole && std::isfinite(number);
            transform.matrix()(i % 3, i / 3) = number;
        }
        requireTransform(isWhole);
        return transform;
    }

    Object& object() {
        if (!openObject_) {
            source_.throwDamaged(Text::tr("its elements are out of order"));
        }
        return *openObject_;
    }

    PropertyGroup& group() {
        if (!openGroup_) {
            source_.throwDamaged(Text::tr("its elements are out of order"));
        }
        return *openGroup_;
    }

    // Returns an attribute of any namespace, because the production extension's path has its own.
    // Null if there is none.
    bool isRepeated(const char* style) const {
        const QString name = text(style);
        return name.isEmpty() || name == u"wrap";
    }

    QString text(const char* name) const {
        for (const QXmlStreamAttribute& attribute : attributes_) {
            if (attribute.name() == QLatin1String(name)) {
                return attribute.value().toString();
            }
        }
        return QString();
    }

    double real(const char* name) const {
        bool isNumber = false;
        const double value = text(name).toDouble(&isNumber);
        if (!isNumber) {
            source_.throwDamaged(Text::tr("there is no number where one should be"));
        }
        return value;
    }

    int integer(const char* name, std::optional<int> otherwise = std::nullopt) const {
        const QString word = text(name);
        if (word.isEmpty() && otherwise) {
            return *otherwise;
        }
        bool isNumber = false;
        const int value = word.toInt(&isNumber);
        if (!isNumber) {
            source_.throwDamaged(Text::tr("there is no number where one should be"));
        }
        return value;
    }

    QString name_;
    const ModelSource& source_;
    const CancelToken& cancelToken_;
    QBuffer buffer_; // Qt reads it in pieces; from a byte array it would decode everything at once
    QXmlStreamReader xml_;
    // Attributes of the current element; cached, as Qt makes a new list per call.
    QXmlStreamAttributes attributes_;
    Part part_;
    Object* openObject_ = nullptr;
    PropertyGroup* openGroup_ = nullptr;
    int objectGroup_ = noGroup, objectProperty_ = 0;
    std::set<int> usedGroups_;     // IDs of the groups that pid attributes name
    std::set<int> otherResources_; // IDs from extensions that are not, or not fully, supported
};

class ThreeMfReader {
public:
    ThreeMfReader(const ModelSource& source, QStringList& warnings, const CancelToken& cancelToken)
        : source_(source), warnings_(warnings), cancelToken_(cancelToken), package_(source) {}

    TexturedMesh read() {
        const Part& root = part(rootPart());
        Eigen::Affine3d toMillimetres = Eigen::Affine3d::Identity();
        toMillimetres.scale(root.unit);
        std::size_t total = 0;
        for (const Placement& item : root.build) {
            total += triangleCount(item, 0);
            source_.checkTriangleCount(total);
        }
        FaultyObjects hidden;
        for (const Placement& item : root.build) {
            place(item, toMillimetres);
            if (item.isHidden || object(item).isOther) { // both are not to be printed
                hidden.add(QString::number(item.object));
            }
        }
        hidden.warn(warnings_, hiddenObjectsWarning());
        if (isPastPicture_) {
            warnings_.push_back(notRepeatedWarning());
        }
        if (mixesColours_) {
            warnings_.push_back(Text::tr(
                "The model mixes colours within its triangles, or mixes materials (3MF "
                "compositematerials or multiproperties), which is not shown; bake its colours "
                "into a texture to print them"));
        }
        if (isTransparent_) {
            warnings_.push_back(transparentMaterialWarning());
        }
        if (isPainted_) {
            warnings_.push_back(Text::tr("The model has triangles that were painted in a slicer, "
                                         "whose paint is not shown; paint the model in a modelling "
                                         "program, with a texture"));
        }
        return std::move(model_);
    }

private:
    QString rootPart() {
        const auto relations = package_.find(QStringLiteral("_rels/.rels"));
        QXmlStreamReader xml(relations.value_or(QByteArray()));
        while (!xml.atEnd()) {
            if (xml.readNext() == QXmlStreamReader::StartElement &&
                xml.attributes().value(QLatin1String("Type")).endsWith(u"/3dmodel")) {
                return xml.attributes().value(QLatin1String("Target")).toString();
            }
        }
        return QStringLiteral("3D/3dmodel.model");
    }

    const Part& part(const QString& name) {
        const auto known = parts_.find(name);
        if (known != parts_.end()) {
            return known->second;
        }
        const auto bytes = package_.find(name);
        if (!bytes) {
            source_.throwDamaged(Text::tr("the file %1 is missing from the package").arg(name));
        }
        return parts_.emplace(name, PartReader(*bytes, name, source_, cancelToken_).read())
            .first->second;
    }

    const Object& object(const Placement& placement) {
        const auto& objects = part(placement.part).objects;
        const auto found = objects.find(placement.object);
        if (found == objects.end()) {
            source_.throwDamaged(Text::tr("it places an object that does not exist"));
        }
        return found->second;
    }

    // Counts the triangles of an object with its components before anything is placed. Nested
    // components multiply, so a small file can ask for more than any memory holds.
    std::size_t triangleCount(const Placement& placement, int depth) {
        const auto key = std::pair(placement.part, placement.object);
        const auto known = triangleCounts_.find(key);
        if (known != triangleCounts_.end()) {
            return known->second;
        }
        requireWithin(Budget::Nesting, depth, source_.path);
        const Object& placed = object(placement);
        // Points count, too: an object may have many that no triangle uses.
        std::size_t count =
            placed.isSupport ? 0 : std::max(placed.triangles.size(), placed.positions.size() / 3);
        for (const Placement& component : placed.components) {
            count += placed.isSupport ? 0 : triangleCount(component, depth + 1);
            source_.checkTriangleCount(count);
        }
        return triangleCounts_.emplace(key, count).first->second;
    }

    void place(const Placement& placement, const Eigen::Affine3d& outer) {
        if (triangleCount(placement, 0) == 0) {
            return;
        }
        cancelToken_.throwIfCancelled();
        const Object& placed = object(placement);
        const Eigen::Affine3d transform = outer * placement.transform;
        addMesh(placed, part(placement.part), placement.part, transform);
        for (const Placement& component : placed.components) {
            place(component, transform);
        }
    }

    void addMesh(const Object& mesh, const Part& inPart, const QString& partName,
                 const Eigen::Affine3d& transform) {
        isPainted_ |= source_.withTextures && mesh.isPainted;
        const auto first = std::uint32_t(model_.mesh.positions.size());
        for (const auto& position : mesh.positions) {
            model_.mesh.positions.push_back((transform * position.cast<double>()).cast<float>());
        }
        const bool isMirrored = transform.linear().determinant() < 0;
        for (const ObjectTriangle& triangle : mesh.triangles) {
            auto corners = triangle.corners;
            auto uv = noCoordinates();
            const auto group = inPart.groups.find(triangle.group);
            if (group != inPart.groups.end()) {
                fillCoordinates(group->second, triangle, uv);
                isPastPicture_ |=
                    source_.withTextures && group->second.isNotRepeated && isPastPicture(uv);
                mixesColours_ |= source_.withTextures && mixesColours(group->second, triangle);
            } else { // compositematerials and multiproperties are not read as groups
                mixesColours_ |= source_.withTextures && triangle.group != noGroup;
            }
            for (auto& corner : corners) {
                corner += first;
            }
            if (isMirrored) {
                std::swap(corners[1], corners[2]);
                std::swap(uv[1], uv[2]);
            }
            model_.mesh.triangles.push_back(corners);
            model_.textureCoordinates.push_back(uv);
            model_.material.push_back(material(inPart, partName, triangle));
        }
    }

    static void fillCoordinates(const PropertyGroup& group, const ObjectTriangle& triangle,
                                std::array<Eigen::Vector2f, 3>& uv) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto index = std::size_t(triangle.properties[i]);
            if (index < group.coordinates.size()) {
                uv[i] = group.coordinates[index];
            }
        }
    }

    // Whether the corners of a triangle have different colours.
    static bool mixesColours(const PropertyGroup& group, const ObjectTriangle& triangle) {
        const auto colour = [&](int property) {
            return std::size_t(property) < group.materials.size()
                       ? group.materials[std::size_t(property)].colour
                       : QColor();
        };
        const auto [first, second, third] = triangle.properties;
        return colour(first) != colour(second) || colour(first) != colour(third);
    }

    // Returns the model's material for a triangle. All triangles of one picture share a material.
    std::uint16_t material(const Part& inPart, const QString& partName,
                           const ObjectTriangle& triangle) {
        const auto found = inPart.groups.find(triangle.group);
        const PropertyGroup* group = found == inPart.groups.end() ? nullptr : &found->second;
        const bool isPlain = group && std::size_t(triangle.properties[0]) < group->materials.size();
        const auto key = std::tuple(partName, group ? triangle.group : -1,
                                    isPlain ? triangle.properties[0] : -1);
        const auto known = materials_.find(key);
        if (known != materials_.end()) {
            return known->second;
        }
        requireWithin(Budget::Materials, qint64(model_.materials.size()) + 1, source_.path);
        isTransparent_ |=
            isPlain && group->transparent.count(std::size_t(triangle.properties[0])) > 0;
        Material material =
            isPlain ? group->materials[std::size_t(triangle.properties[0])] : Material();
        if (group && !group->picture.isEmpty() && source_.withTextures) {
            material.texture = texture(group->picture);
        }
        model_.materials.push_back(material);
        return materials_.emplace(key, std::uint16_t(model_.materials.size() - 1)).first->second;
    }

    int texture(const QString& name) {
        const auto known = textures_.find(name);
        if (known != textures_.end()) {
            return known->second;
        }
        int index = -1;
        if (const auto bytes = package_.find(name)) {
            index = int(model_.textures.size());
            model_.textures.push_back(source_.pictures.read(
                *bytes, Text::tr("texture %1 in %2").arg(name, source_.path)));
        } else {
            warnings_.push_back(
                Text::tr("The texture %1 is not in the model's package; its material's "
                         "colour is used instead")
                    .arg(name));
        }
        return textures_.emplace(name, index).first->second;
    }

    const ModelSource& source_;
    QStringList& warnings_;
    const CancelToken& cancelToken_;
    Package package_;
    std::map<QString, Part> parts_;
    TexturedMesh model_;
    bool isPastPicture_ = false, mixesColours_ = false, isTransparent_ = false, isPainted_ = false;
    std::map<std::tuple<QString, int, int>, std::uint16_t> materials_;
    std::map<QString, int> textures_;
    std::map<std::pair<QString, int>, std::size_t> triangleCounts_;
};

} // namespace

TexturedMesh readThreeMf(const ModelSource& source, QStringList& warnings,
                         const CancelToken& cancelToken) {
    return ThreeMfReader(source, warnings, cancelToken).read();
}

} // namespace dipwright
