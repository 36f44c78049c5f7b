// Files in memory.
#pragma once

#include <QByteArray>
#include <QIODevice>
#include <functional>

namespace dipwright {

// The bytes that `write` puts into the device it is given.
QByteArray bytesOf(const std::function<void(QIODevice&)>& write);

} // namespace dipwright
