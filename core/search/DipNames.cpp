#include "search/DipNames.h"

#include "dip/Pose.h"

#include <QCoreApplication>
#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(PoseSearch)
};

QString numbered(std::size_t index) {
    return Text::tr("Dip %1").arg(index + 1);
}

// Whether a name says no more than the number of a dip, in the user's language or in English.
bool isNumber(const QString& name, std::size_t dips) {
    for (std::size_t index = 0; index < dips; ++index) {
        if (name == numbered(index) || name == QStringLiteral("Dip %1").arg(index + 1)) {
            return true;
        }
    }
    return false;
}

// Returns the cosine of the angle between the directions of the model that two dips turn down.
double agreement(const Immersion& one, const Immersion& other) {
    return rotationMatrix(one.rotation).row(1).dot(rotationMatrix(other.rotation).row(1));
}

} // namespace

void nameDips(std::vector<Immersion>& found, const std::vector<Immersion>& own) {
    const bool areAsMany = found.size() == own.size();
    const bool areSwapped = areAsMany && found.size() == 2 &&
                            agreement(found[0], own[1]) + agreement(found[1], own[0]) >
                                agreement(found[0], own[0]) + agreement(found[1], own[1]);
    for (std::size_t index = 0; index < found.size(); ++index) {
        found[index].name = numbered(index);
        if (areAsMany) {
            const Immersion& like = own[areSwapped ? 1 - index : index];
            if (!isNumber(like.name, own.size()) && agreement(found[index], like) > 0) {
                found[index].name = like.name;
            }
        }
    }
}

} // namespace dipwright
