// The contents of a note about unfinished work, and their encoding.
#pragma once

#include <QByteArray>
#include <QStringList>
#include <optional>

namespace dipwright {

struct UnfinishedNote {
    QString work;     // the temporary file, or the hidden folder of results; absolute path
    QStringList made; // folders that were created for it and contain it, the innermost last
    bool operator==(const UnfinishedNote&) const = default;
};

QByteArray bytesOf(const UnfinishedNote& note);
// Returns nothing if the bytes are no note, or name something that no Dipwright program would clean
// up.
std::optional<UnfinishedNote> noteOf(const QByteArray& bytes);

} // namespace dipwright
