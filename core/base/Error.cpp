#include "base/Error.h"

#include "base/OneLine.h"

namespace dipwright {

Error::Error(const QString& what, const QString& where)
    : std::runtime_error(what.toStdString()), message_(what), where_(where) {}

QString Error::sentence() const {
    return withVisibleFormats(where_.isEmpty() ? message_
                                               : QStringLiteral("%1 (%2)").arg(message_, where_));
}

} // namespace dipwright
