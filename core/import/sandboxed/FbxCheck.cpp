#include "import/sandboxed/FbxCheck.h"

#include "base/Budgets.h"

#include <QCoreApplication>
#include <QHash>
#include <QSet>
#include <QtEndian>

#include <algorithm>
#include <cctype>
#include <tuple>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

using Values = QList<QByteArray>;

// Reads the nodes of an FBX file by their names. Each node has values.
class FbxNodes {
public:
    explicit FbxNodes(QByteArrayView bytes, bool isBinary) : bytes_(bytes), isBinary_(isBinary) {}

    // Calls `use` with the first values of each node of this name, at most `count`, and with the
    // place after its name.
    template <typename Use>
    void forEach(const QByteArray& name, int count, const Use& use) const {
        const QByteArray key = isBinary_ ? char(name.size()) + name : name + ':';
        for (qsizetype at = bytes_.indexOf(key); at >= 0; at = bytes_.indexOf(key, at)) {
            const bool isName = isBinary_ || at == 0 || std::isspace(uchar(bytes_[at - 1])) != 0;
            at += key.size();
            if (isName) {
                const QByteArrayView after = bytes_.sliced(at);
                use(isBinary_ ? binaryValues(after, count) : textValues(after, count), at);
            }
        }
    }

    QByteArrayView bytes() const { return bytes_; }
    FbxNodes from(qsizetype begin) const {
        return part(std::max<qsizetype>(begin, 0), bytes_.size());
    }
    FbxNodes part(qsizetype begin, qsizetype end) const {
        return FbxNodes(bytes_.sliced(begin, end - begin), isBinary_);
    }

private:
    // Values are separated by commas. Texts are in quotes.
    static Values textValues(QByteArrayView rest, int count) {
        Values values{QByteArray()};
        bool isQuoted = false;
        for (const char byte : rest) {
            if (byte == '\n' || (!isQuoted && byte == '{')) {
                break;
            }
            isQuoted ^= byte == '"';
            if (byte == ',' && !isQuoted) {
                if (values.size() == count) {
                    break;
                }
                values.push_back(QByteArray());
            } else if (byte != '"' && (isQuoted || std::isspace(uchar(byte)) == 0)) {
                values.back() += byte;
            }
        }
        return values;
    }

    // Each value follows a letter for its type.
    static Values binaryValues(QByteArrayView rest, int count) {
        Values values;
        while (values.size() < count && rest.size() > 1) {
            const char type = rest[0];
            const char* const begin = rest.data() + 1;
            const qsizetype size = sizeOf(type, rest.sliced(1));
            if (size == 0 || size >= rest.size()) {
                break;
            }
            values.push_back(type == 'S'   ? QByteArray(begin + 4, size - 4)
                             : type == 'L' ? QByteArray::number(qFromLittleEndian<qint64>(begin))
                             : type == 'I' ? QByteArray::number(qFromLittleEndian<qint32>(begin))
                             : type == 'D'
                                 ? QByteArray::number(qFromLittleEndian<double>(begin))
                                 : QByteArray::number(double(qFromLittleEndian<float>(begin))));
            rest = rest.sliced(1 + size);
        }
        return values;
    }

    // Returns the bytes of a binary value after its type; 0 for another type.
    static qsizetype sizeOf(char type, QByteArrayView after) {
        constexpr qsizetype head = 4; // bytes of a text's length
        switch (type) {
        case 'S':
            return after.size() < head ? 0 : head + qFromLittleEndian<quint32>(after.data());
        case 'L':
        case 'D':
            return 8;
        case 'I':
        case 'F':
            return 4;
        default:
            return 0;
        }
    }

    QByteArrayView bytes_;
    bool isBinary_;
};

// An object of the scene, as its node "Model" describes it.
struct FbxModel {
    QString name;
    bool isHidden = false;
    int inheritType = 1; // as assimp takes it
    double smallestScale = 1, largestScale = 1;
};

void readProperties(const FbxNodes& node, FbxModel& model) {
    constexpr int whole = 7; // the property's name, two types, flags, and up to three numbers
    node.forEach("P", whole, [&](const Values& values, qsizetype) {
        const QByteArray name = values.value(0);
        if (name == "Visibility" && values.size() > 4) {
            model.isHidden = values[4].toDouble() == 0;
        } else if (name == "InheritType" && values.size() > 4) {
            model.inheritType = values[4].toInt();
        } else if (name == "Lcl Scaling" && values.size() == whole) {
            std::tie(model.smallestScale, model.largestScale) =
                std::minmax({values[4].toDouble(), values[5].toDouble(), values[6].toDouble()});
        }
    });
}

// Calls `use` with the number and the name of each object of a kind, and with its place.
template <typename Use>
void forEachObject(const FbxNodes& objects, const QByteArray& kind, const Use& use) {
    constexpr qsizetype longestName = 64; // in messages
    const QByteArray before = kind + "::", after = QByteArray("\0\1", 2) + kind;
    objects.forEach(kind, 2, [&](const Values& values, qsizetype at) {
        const QByteArray name = values.value(1);
        if (name.startsWith(before)) {
            use(values[0], QString::fromUtf8(name.mid(before.size())).left(longestName), at);
        } else if (name.endsWith(after)) {
            use(values[0], QString::fromUtf8(name.chopped(after.size())).left(longestName), at);
        }
    });
}

// Objects with the same fault.
struct Faulty {
    int count = 0;
    QString first;

    void add(const QString& name) { first = count++ == 0 ? name : first; }
    void warn(QStringList& warnings, const QString& sentence) const {
        if (count > 0) {
            warnings.push_back(sentence.arg(count).arg(first));
        }
    }
};

class FbxCheck {
public:
    explicit FbxCheck(const QByteArray& bytes)
        : nodes_(bytes, bytes.startsWith("Kaydara FBX Binary")) {
        readObjects();
        readConnections();
    }

    void warn(QStringList& warnings, bool withTextures) const {
        if (hasLayers_ && withTextures) {
            warnings.push_back(Text::tr("The model has a texture of several layers, which is not "
                                        "shown correctly; merge the layers into one picture"));
        }
        Faulty sharing, inheriting, hidden;
        for (const QByteArray& geometry : geometries_) {
            const QList<QByteArray> users = parentsOf_.value(geometry);
            for (const QByteArray& user : users) {
                const QString name = models_.value(user).name;
                if (withTextures && materialsOf_.value(user) != materialsOf_.value(users[0])) {
                    sharing.add(name);
                }
                const Ancestry ancestry = ancestryOf(user);
                if (ancestry.losesScale) {
                    inheriting.add(name);
                }
                if (ancestry.isHidden) {
                    hidden.add(name);
                }
            }
        }
        sharing.warn(warnings,
                     Text::tr("Objects that share the mesh of another object, but not its "
                              "materials: %1, first %2. They are shown with the materials of that "
                              "object; give each object its own mesh in a modelling program"));
        inheriting.warn(warnings,
                        Text::tr("Objects that do not inherit the scale of their parents as usual "
                                 "(InheritType): %1, first %2. This is not followed, so they may "
                                 "have another size or shape; apply their transforms in a "
                                 "modelling program"));
        hidden.warn(warnings,
                    Text::tr("Hidden objects: %1, first %2. They are imported, too, and dipped "
                             "with the others; delete them in a modelling program if they do not "
                             "belong to the part"));
    }

private:
    struct Ancestry {
        bool isHidden = false, losesScale = false;
    };

    void readObjects() {
        const FbxNodes objects = nodes_.from(nodes_.bytes().indexOf("Objects"));
        std::vector<std::pair<qsizetype, QByteArray>> places; // of the models
        forEachObject(objects, "Model",
                      [&](const QByteArray& id, const QString& name, qsizetype at) {
                          models_[id].name = name;
                          places.emplace_back(at, id);
                      });
        for (std::size_t i = 0; i < places.size(); ++i) {
            const bool isLast = i + 1 == places.size();
            const qsizetype end = isLast ? objects.bytes().size() : places[i + 1].first;
            readProperties(objects.part(places[i].first, end), models_[places[i].second]);
        }
        forEachObject(objects, "Geometry", [&](const QByteArray& id, const QString&, qsizetype) {
            geometries_.push_back(id);
        });
        forEachObject(objects, "Material", [&](const QByteArray& id, const QString&, qsizetype) {
            materials_.insert(id);
        });
        forEachObject(objects, "LayeredTexture",
                      [&](const QByteArray& id, const QString&, qsizetype) { layers_.insert(id); });
    }

    void readConnections() {
        const FbxNodes connections = nodes_.from(nodes_.bytes().lastIndexOf("Connections"));
        connections.forEach("C", 4, [&](const Values& values, qsizetype) {
            const QByteArray from = values.value(1), to = values.value(2);
            if (models_.contains(to)) {
                materials_.contains(from) ? materialsOf_[to].push_back(from)
                                          : parentsOf_[from].push_back(to);
            }
            const QByteArray property = values.value(3).toLower();
            for (const char* colour : {"diffuse", "base", "color_map"}) {
                hasLayers_ |= layers_.contains(from) && property.contains(colour);
            }
        });
    }

    Ancestry ancestryOf(QByteArray model) const {
        Ancestry found;
        bool leavesScale = false, movesScale = false; // of a parent
        for (qint64 depth = budgetLimit(Budget::Nesting); depth > 0 && models_.contains(model);
             --depth) {
            const FbxModel& each = models_[model];
            const bool isUneven = each.largestScale != each.smallestScale;
            found.isHidden |= each.isHidden;
            found.losesScale |=
                (leavesScale && (isUneven || each.largestScale != 1)) || (movesScale && isUneven);
            leavesScale |= each.inheritType == 2;
            movesScale |= each.inheritType == 0;
            model = parentsOf_.value(model).value(0);
        }
        return found;
    }

    FbxNodes nodes_;
    std::vector<QByteArray> geometries_;
    QHash<QByteArray, FbxModel> models_;
    QSet<QByteArray> materials_, layers_;
    // Of each geometry and model: the models that it is part of. Of each model: its materials.
    QHash<QByteArray, QList<QByteArray>> parentsOf_, materialsOf_;
    bool hasLayers_ = false; // in a colour that is shown
};

} // namespace

void checkFbx(const ModelSource& source, QStringList& warnings) {
    FbxCheck(source.bytes).warn(warnings, source.withTextures);
}

} // namespace dipwright
