// Small files of the user's that are read whole: tables, templates, profiles.
#pragma once

#include <QByteArray>
#include <QString>

namespace dipwright {

// The bytes of a file. Throws Error, naming it, where it cannot be read, is no regular file, or has
// more than `most` bytes: more are never read.
QByteArray readSmallFile(const QString& path, qint64 most);

// Bytes, of a profile of any kind: ICC profiles are a megabyte or two.
constexpr qint64 mostProfileBytes = 32 << 20;

} // namespace dipwright
