#include "inspection/SamePhoto.h"

#include "base/Error.h"

#include <QCoreApplication>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::FilmWatch)
};

} // namespace

void refuseSamePhoto(const QString& photo, const QString& other) {
    throw Error(Text::tr("The photo is the same as %1; give each photo only once").arg(other),
                photo);
}

} // namespace dipwright
