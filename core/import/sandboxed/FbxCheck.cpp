#include "import/sandboxed/FbxCheck.h"

#include "base/Budgets.h"
#include "import/sandboxed/FbxNodes.h"

#include <QCoreApplication>
#include <QHash>
#include <QSet>

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>
#include <vector>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
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
    node.forEach("P", whole, [&](const FbxValues& values, qsizetype) {
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
    objects.forEach(kind, 2, [&](const FbxValues& values, qsizetype at) {
        const QByteArray name = values.value(1);
        if (name.startsWith(before)) {
            use(values[0], QString::fromUtf8(name.mid(before.size())).left(longestName), at);
        } else if (name.endsWith(after)) {
            use(values[0], QString::fromUtf8(name.chopped(after.size())).left(longestName), at);
        }
    });
}

class FbxCheck {
public:
    explicit FbxCheck(const QByteArray& bytes) : nodes_(bytes) {
        readObjects();
        readConnections();
    }

    void warn(QStringList& warnings, bool withTextures) const {
        if (hasLayers_ && withTextures) {
            warnings.push_back(Text::tr("The model has a texture of several layers, which is not "
                                        "shown correctly; merge the layers into one picture"));
        }
        FaultyObjects sharing, inheriting, hidden;
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
        hidden.warn(warnings, hiddenObjectsWarning());
    }

private:
    struct Ancestry {
        bool isHidden = false, losesScale = false;
    };

    void readObjects() {
        const FbxNodes objects = nodes_.from(nodes_.bytes().indexOf("Objects"));
        std::map<qsizetype, QByteArray> places; // where each object begins, and its number
        for (const char* kind : {"Model", "Geometry", "Material", "LayeredTexture", "Texture",
                                 "Video", "NodeAttribute", "CollectionExclusive", "DisplayLayer",
                                 "Deformer", "Pose", "AnimCurveNode", "Implementation"}) {
            forEachObject(objects, kind,
                          [&](const QByteArray& id, const QString& name, qsizetype at) {
                              places.emplace(at, id);
                              addObject(kind, id, name);
                          });
        }
        for (auto place = places.begin(); place != places.end(); ++place) {
            const auto next = std::next(place);
            const qsizetype end = next == places.end() ? objects.bytes().size() : next->first;
            if (const auto model = models_.find(place->second); model != models_.end()) {
                readProperties(objects.part(place->first, end), *model);
            }
        }
    }

    void addObject(const QByteArray& kind, const QByteArray& id, const QString& name) {
        if (kind == "Model") {
            models_[id].name = name;
        } else if (kind == "Geometry") {
            geometries_.push_back(id);
        } else if (kind == "Material") {
            materials_.insert(id);
        } else if (kind == "LayeredTexture") {
            layers_.insert(id);
        }
    }

    void readConnections() {
        const FbxNodes connections = nodes_.from(nodes_.bytes().lastIndexOf("Connections"));
        connections.forEach("C", 4, [&](const FbxValues& values, qsizetype) {
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
    QHash<QByteArray, QList<QByteArray>> parentsOf_;   // the models above a geometry or a model
    QHash<QByteArray, QList<QByteArray>> materialsOf_; // the materials of a model
    bool hasLayers_ = false;                           // in a colour that is shown
};

} // namespace

void checkFbx(const ModelSource& source, QStringList& warnings) {
    FbxCheck(source.bytes).warn(warnings, source.withTextures);
}

} // namespace dipwright
