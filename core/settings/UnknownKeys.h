// Keys of a file that this version of the program does not know.
#pragma once

#include <QJsonObject>

namespace dipwright {

// An entry of a list, or a profile, carries these keys with it. So they are saved again with the
// entry, wherever it has moved, and go when it is deleted.
struct UnknownKeys : QJsonObject {
    UnknownKeys() noexcept {} // GCC 12 warns about entries whose construction might throw
    UnknownKeys(const QJsonObject& keys) : QJsonObject(keys) {}
};

} // namespace dipwright
