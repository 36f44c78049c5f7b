#include "import/sandboxed/PlyReader.h"

#include "base/Budgets.h"
#include "import/sandboxed/PolygonTriangles.h"

#include <QCoreApplication>
#include <QtEndian>

#include <algorithm>
#include <cmath>
#include <optional>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

enum class Encoding { Ascii, LittleEndian, BigEndian };
enum class Type { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };

std::optional<Type> typeNamed(QByteArrayView name) {
    static const std::pair<QByteArrayView, Type> names[] = {
        {"char", Type::Int8},     {"int8", Type::Int8},     {"uchar", Type::UInt8},
        {"uint8", Type::UInt8},   {"short", Type::Int16},   {"int16", Type::Int16},
        {"ushort", Type::UInt16}, {"uint16", Type::UInt16}, {"int", Type::Int32},
        {"int32", Type::Int32},   {"uint", Type::UInt32},   {"uint32", Type::UInt32},
        {"float", Type::Float},   {"float32", Type::Float}, {"double", Type::Double},
        {"float64", Type::Double}};
    for (const auto& [known, type] : names) {
        if (known == name) {
            return type;
        }
    }
    return std::nullopt;
}

struct Property {
    QByteArray name;
    Type type = Type::Float;
    std::optional<Type> countType; // set for a list
};

struct Element {
    QByteArray name;
    quint64 count = 0;
    std::vector<Property> properties;

    // Returns the index of the first property with one of these names, or −1.
    int find(std::initializer_list<QByteArrayView> names) const {
        for (std::size_t i = 0; i < properties.size(); ++i) {
            if (std::find(names.begin(), names.end(), properties[i].name) != names.end()) {
                return int(i);
            }
        }
        return -1;
    }
};

struct Header {
    Encoding encoding = Encoding::Ascii;
    std::vector<Element> elements;
    QStringList pictures;
};

// Splits a file into lines of the header and numbers of the body.
class Scanner {
public:
    explicit Scanner(const ModelSource& source) : rest_(source.bytes), source_(source) {
        const QByteArrayView byteOrderMark = "\xef\xbb\xbf"; // added by some text editors
        if (rest_.startsWith(byteOrderMark)) {
            rest_ = rest_.sliced(byteOrderMark.size());
        }
        // Only the first line decides: after the header, a byte of a binary number may look like
        // part of a line end.
        const auto end = std::find_if(rest_.begin(), rest_.end(),
                                      [](char byte) { return byte == '\r' || byte == '\n'; });
        const QByteArrayView fromEnd(end, rest_.end());
        lineEnd_ = fromEnd.startsWith('\r') && !fromEnd.startsWith("\r\n") ? '\r' : '\n';
    }

    QByteArrayView line() {
        const qsizetype end = rest_.indexOf(lineEnd_);
        if (end < 0) {
            throwEnded();
        }
        const QByteArrayView found = rest_.first(end).trimmed();
        rest_ = rest_.sliced(end + 1);
        return found;
    }

    double number(Encoding encoding, Type type) {
        return encoding == Encoding::Ascii ? word() : binary(encoding, type);
    }

    qsizetype bytesLeft() const { return rest_.size(); }
    bool hasWordsLeft() const { return std::any_of(rest_.begin(), rest_.end(), isWord); }
    QByteArrayView left() const { return rest_; }

private:
    static bool isNoSpace(char byte) { return byte != ' ' && (byte < '\t' || byte > '\r'); }
    static bool isWord(char byte) {
        constexpr char endOfDosFile = 0x1a;
        return isNoSpace(byte) && byte != '\0' && byte != endOfDosFile;
    }

    [[noreturn]] void throwEnded() const { source_.throwDamaged(Text::tr("it ends too early")); }

    double word() {
        const auto begin = std::find_if(rest_.begin(), rest_.end(), isNoSpace);
        const auto end = std::find_if_not(begin, rest_.end(), isNoSpace);
        if (begin == end) {
            throwEnded();
        }
        bool isNumber = false;
        const double value = QByteArrayView(begin, end).toDouble(&isNumber);
        if (!isNumber) {
            source_.throwDamaged(Text::tr("there is a word where a number should be"));
        }
        rest_ = QByteArrayView(end, rest_.end());
        return value;
    }

    double binary(Encoding encoding, Type type) {
        switch (type) {
        case Type::Int8:
            return take<qint8>(encoding);
        case Type::UInt8:
            return take<quint8>(encoding);
        case Type::Int16:
            return take<qint16>(encoding);
        case Type::UInt16:
            return take<quint16>(encoding);
        case Type::Int32:
            return take<qint32>(encoding);
        case Type::UInt32:
            return take<quint32>(encoding);
        case Type::Float:
            return double(take<float>(encoding));
        case Type::Double:
            return take<double>(encoding);
        }
        return 0;
    }

    template <typename Number>
    Number take(Encoding encoding) {
        if (rest_.size() < qsizetype(sizeof(Number))) {
            throwEnded();
        }
        const char* bytes = rest_.data();
        rest_ = rest_.sliced(sizeof(Number));
        return encoding == Encoding::LittleEndian ? qFromLittleEndian<Number>(bytes)
                                                  : qFromBigEndian<Number>(bytes);
    }

    QByteArrayView rest_;
    char lineEnd_ = '\n';
    const ModelSource& source_;
};

class PlyReader {
public:
    PlyReader(const ModelSource& source, QStringList& warnings, const CancelToken& cancelToken)
        : source_(source), warnings_(warnings), cancelToken_(cancelToken), scanner_(source) {}

    TexturedMesh read() {
        readHeader();
        addMaterials();
        for (const Element& element : header_.elements) {
            if (element.properties.empty()) {
                continue;
            }
            if (element.name == "vertex") {
                readVertices(element);
            } else if (element.name == "face") {
                readFaces(element);
            } else if (element.name == "tristrips") {
                readStrips(element);
            } else {
                skip(element);
            }
        }
        checkNothingIsLeft();
        finish();
        return std::move(model_);
    }

private:
    // Per property: its numbers. A property that is not a list has one number.
    using Row = std::vector<std::vector<double>>;

    void readHeader() {
        if (scanner_.line() != "ply") {
            source_.throwDamaged(Text::tr("it is not a PLY file"));
        }
        for (QByteArrayView line = scanner_.line(); line != "end_header"; line = scanner_.line()) {
            const QByteArray text = line.toByteArray().simplified();
            const QList<QByteArray> words = text.split(' ');
            if (words[0] == "format" && words.size() > 1) {
                readEncoding(words[1]);
            } else if (words[0] == "element") {
                readElement(words);
            } else if (words[0] == "property") {
                readProperty(words);
            } else if (text.startsWith("comment TextureFile ")) {
                header_.pictures.push_back(QString::fromUtf8(text.sliced(20)));
            }
        }
    }

    void readElement(const QList<QByteArray>& words) {
        const QByteArray name = words.value(1);
        bool isCounted = false;
        const quint64 count = words.value(2).toULongLong(&isCounted);
        const bool hasPoints =
            std::any_of(header_.elements.begin(), header_.elements.end(),
                        [](const Element& element) { return element.name == "vertex"; });
        if (!isCounted || (hasPoints && name == "vertex")) {
            throwHeaderNotUnderstood();
        }
        header_.elements.push_back({name, count, {}});
    }

    [[noreturn]] void throwHeaderNotUnderstood() const {
        source_.throwDamaged(Text::tr("its header is not understood"));
    }

    void readEncoding(const QByteArray& name) {
        if (name == "binary_little_endian") {
            header_.encoding = Encoding::LittleEndian;
        } else if (name == "binary_big_endian") {
            header_.encoding = Encoding::BigEndian;
        } else if (name != "ascii") {
            source_.throwDamaged(
                Text::tr("its PLY format %1 is unknown").arg(QString::fromUtf8(name)));
        }
    }

    void readProperty(const QList<QByteArray>& words) {
        const bool isList = words.value(1) == "list";
        const auto type = typeNamed(words.value(isList ? 3 : 1));
        const auto countType = typeNamed(words.value(2));
        if (!type || (isList && !countType) || header_.elements.empty()) {
            throwHeaderNotUnderstood();
        }
        Property property{words.value(isList ? 4 : 2), *type, std::nullopt};
        if (isList) {
            property.countType = countType;
        }
        header_.elements.back().properties.push_back(property);
    }

    void addMaterials() {
        requireWithin(Budget::Materials, header_.pictures.size(), source_.path);
        for (const QString& picture : header_.pictures) {
            Material& material = model_.materials.emplace_back();
            if (!source_.withTextures) {
                continue;
            }
            if (QImage image = source_.readPicture(picture, warnings_); !image.isNull()) {
                material.texture = int(model_.textures.size());
                model_.textures.push_back(std::move(image));
            }
        }
        if (model_.materials.empty()) {
            model_.materials.emplace_back();
        }
    }

    // Reuses `row`, so that nothing is allocated per line.
    void readRow(const Element& element, Row& row) {
        row.resize(element.properties.size());
        for (std::size_t i = 0; i < row.size(); ++i) {
            const Property& property = element.properties[i];
            double count = 1;
            if (property.countType) {
                count = scanner_.number(header_.encoding, *property.countType);
                if (!(count >= 0) || count > double(scanner_.bytesLeft())) {
                    source_.throwDamaged(Text::tr("it ends too early"));
                }
                if (count != std::floor(count)) {
                    source_.throwDamaged(Text::tr("the length of a list is not a whole number"));
                }
            }
            row[i].resize(std::size_t(count));
            for (double& value : row[i]) {
                value = scanner_.number(header_.encoding, property.type);
            }
        }
    }

    template <typename Use>
    void forEachRow(const Element& element, const Use& use) {
        Row row;
        for (quint64 i = 0; i < element.count; ++i) {
            if (i % 4096 == 0) {
                cancelToken_.throwIfCancelled();
            }
            const qsizetype before = scanner_.bytesLeft();
            readRow(element, row);
            lastRowBytes_ = before - scanner_.bytesLeft();
            use(row);
        }
    }

    void checkNothingIsLeft() const {
        const bool endsWithFaces = !header_.elements.empty() && lastRowBytes_ > 0 &&
                                   header_.elements.back().name == "face";
        if (header_.encoding == Encoding::Ascii
                ? scanner_.hasWordsLeft()
                : endsWithFaces && mayBeFurtherRows(scanner_.left(), lastRowBytes_)) {
            source_.throwDamaged(Text::tr("it holds more data than its header declares"));
        }
    }

    void skip(const Element& element) {
        forEachRow(element, [](const Row&) {});
    }

    void readVertices(const Element& element) {
        const int x = element.find({"x"}), y = element.find({"y"}), z = element.find({"z"});
        const int u = element.find({"s", "u", "texture_u"});
        const int v = element.find({"t", "v", "texture_v"});
        hasColours_ = element.find({"red", "diffuse_red"}) >= 0;
        const auto value = [](const Row& row, int property) {
            const auto& values = row[std::size_t(property)];
            return values.empty() ? std::nanf("") : float(values[0]);
        };
        if (x < 0 || y < 0 || z < 0) {
            source_.throwDamaged(Text::tr("its points have no x, y and z"));
        }
        forEachRow(element, [&](const Row& row) {
            model_.mesh.positions.emplace_back(value(row, x), value(row, y), value(row, z));
            if (u >= 0 && v >= 0) {
                pointCoordinates_.push_back(statedCoordinates(value(row, u), value(row, v)));
            }
        });
    }

    void readFaces(const Element& element) {
        const int corners = element.find({"vertex_indices", "vertex_index"});
        const int coordinates = element.find({"texcoord"});
        const int picture = element.find({"texnumber"});
        if (corners < 0) {
            source_.throwDamaged(Text::tr("its faces have no corners"));
        }
        forEachRow(element, [&](const Row& row) {
            const auto& numbers = row[std::size_t(picture < 0 ? corners : picture)];
            const double material = picture < 0 || numbers.empty() ? 0 : numbers[0];
            addFace(row[std::size_t(corners)],
                    coordinates < 0 ? std::vector<double>() : row[std::size_t(coordinates)],
                    material);
        });
    }

    // Each corner forms a triangle with the two before it; every second triangle is reversed. −1
    // begins a new strip. A repeated corner only continues the strip.
    void readStrips(const Element& element) {
        constexpr double newStrip = -1;
        const int corners = element.find({"vertex_indices", "vertex_index"});
        if (corners < 0) {
            source_.throwDamaged(Text::tr("its faces have no corners"));
        }
        forEachRow(element, [&](const Row& row) {
            std::vector<double> strip;
            for (const double corner : row[std::size_t(corners)]) {
                if (corner == newStrip) {
                    strip.clear();
                    continue;
                }
                strip.push_back(corner);
                addStripTriangle(strip);
            }
        });
    }

    void addStripTriangle(const std::vector<double>& strip) {
        if (strip.size() < 3) {
            return;
        }
        std::array<double, 3> corners{};
        std::copy(strip.end() - 3, strip.end(), corners.begin());
        if (strip.size() % 2 == 0) {
            std::swap(corners[0], corners[1]);
        }
        const auto& [a, b, c] = corners;
        if (a != b && b != c && c != a) {
            addFace({a, b, c}, {}, 0);
        }
    }

    void addFace(const std::vector<double>& corners, const std::vector<double>& coordinates,
                 double material) {
        requireWithin(Budget::PolygonCorners, qint64(corners.size()), source_.path);
        for (const double corner : corners) {
            if (!(corner >= 0 && corner < double(SurfacePoint::noTriangle)) ||
                corner != std::floor(corner)) {
                throwUnknownPoint();
            }
        }
        const bool hasMaterial = material >= 0 && material < double(model_.materials.size());
        if (corners.size() > 3) {
            fans_.emplace_back(model_.mesh.triangles.size(), corners.size());
        }
        for (std::size_t last = 2; last < corners.size(); ++last) {
            const std::array<std::size_t, 3> chosen{0, last - 1, last};
            auto& triangle = model_.mesh.triangles.emplace_back();
            auto& uv = model_.textureCoordinates.emplace_back(noCoordinates());
            model_.material.push_back(hasMaterial ? std::uint16_t(material) : std::uint16_t(0));
            for (int i = 0; i < 3; ++i) {
                triangle[i] = std::uint32_t(corners[chosen[i]]);
                if (coordinates.size() == 2 * corners.size()) {
                    uv[i] = statedCoordinates(float(coordinates[2 * chosen[i]]),
                                              float(coordinates[2 * chosen[i] + 1]));
                }
            }
            source_.checkTriangleCount(model_.mesh.triangles.size());
        }
    }

    [[noreturn]] void throwUnknownPoint() const {
        source_.throwDamaged(Text::tr("a face refers to a point that does not exist"));
    }

    // Cuts polygons again whose fan folds over itself. Only here all points are known.
    void unfold() {
        std::size_t crossed = 0;
        std::vector<Eigen::Vector3f> polygon;
        for (const auto& [first, corners] : fans_) {
            cancelToken_.throwIfCancelled();
            polygon.clear();
            for (std::size_t corner = 0; corner < corners; ++corner) {
                const auto [triangle, place] = placeInFan(corner);
                polygon.push_back(
                    model_.mesh.positions[model_.mesh.triangles[first + triangle][place]]);
            }
            if (isFoldedFan(polygon)) {
                const auto cut = cutPolygon(polygon);
                crossed += cut ? 0 : 1;
                replaceFan(first, cut.value_or(std::vector<PolygonTriangle>()));
            }
        }
        if (crossed > 0) {
            warnings_.push_back(
                Text::tr("Faces whose edges cross each other: %1. Their inside is not clear, so "
                         "they may be filled wrongly; cut them into triangles in a modelling "
                         "program")
                    .arg(crossed));
        }
    }

    // Returns where a corner of a polygon is in its fan: in which triangle, and in which place.
    static std::pair<std::size_t, std::size_t> placeInFan(std::size_t corner) {
        return corner < 2 ? std::pair(std::size_t(0), corner)
                          : std::pair(corner - 2, std::size_t(2));
    }

    void replaceFan(std::size_t first, const std::vector<PolygonTriangle>& cut) {
        const auto triangles = model_.mesh.triangles.begin() + std::ptrdiff_t(first);
        const auto coordinates = model_.textureCoordinates.begin() + std::ptrdiff_t(first);
        const std::vector oldTriangles(triangles, triangles + std::ptrdiff_t(cut.size()));
        const std::vector oldCoordinates(coordinates, coordinates + std::ptrdiff_t(cut.size()));
        for (std::size_t t = 0; t < cut.size(); ++t) {
            for (std::size_t i = 0; i < 3; ++i) {
                const auto [triangle, place] = placeInFan(cut[t][i]);
                model_.mesh.triangles[first + t][i] = oldTriangles[triangle][place];
                model_.textureCoordinates[first + t][i] = oldCoordinates[triangle][place];
            }
        }
    }

    void finish() {
        for (std::size_t t = 0; t < model_.mesh.triangles.size(); ++t) {
            for (int i = 0; i < 3; ++i) {
                const std::uint32_t corner = model_.mesh.triangles[t][i];
                if (corner >= model_.mesh.positions.size()) {
                    throwUnknownPoint();
                }
                Eigen::Vector2f& uv = model_.textureCoordinates[t][i];
                if (corner < pointCoordinates_.size() && uv.array().isNaN().any()) {
                    uv = pointCoordinates_[corner];
                }
            }
        }
        unfold();
        if (hasColours_ && header_.pictures.empty()) {
            warnings_.push_back(Text::tr(
                "The model's vertex colours are not used; bake them into a texture to print them"));
        }
    }

    const ModelSource& source_;
    QStringList& warnings_;
    const CancelToken& cancelToken_;
    Scanner scanner_;
    Header header_;
    TexturedMesh model_;
    // First triangle and number of corners of each polygon with more than three corners.
    std::vector<std::pair<std::size_t, std::size_t>> fans_;
    // Texture coordinates per point; empty if there are none.
    std::vector<Eigen::Vector2f> pointCoordinates_;
    qsizetype lastRowBytes_ = 0;
    bool hasColours_ = false;
};

} // namespace

TexturedMesh readPly(const ModelSource& source, QStringList& warnings,
                     const CancelToken& cancelToken) {
    return PlyReader(source, warnings, cancelToken).read();
}

} // namespace dipwright
