// Reads small user files completely: tables, templates, profiles.
#pragma once

#include <QByteArray>
#include <QString>

namespace dipwright {

// Returns the bytes of a file. Throws Error that names the file if it cannot be read, is no regular
// file, or has more than `most` bytes. Never reads more than `most` bytes.
QByteArray readSmallFile(const QString& path, qint64 most);

// Size limit for a profile of any kind, in bytes. ICC profiles usually have one or two megabytes.
constexpr qint64 mostProfileBytes = 32 << 20;

} // namespace dipwright
