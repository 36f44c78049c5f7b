// The contents of a note about unfinished work, and their encoding.
#pragma once

#include <QByteArray>
#include <QStringList>
#include <optional>

namespace dipwright {

struct UnfinishedNote {
    QString work;     // the temporary file, or the hidden folder of results; absolute path
    QStringList made; // folders that were created to contain `work`, the innermost last
    bool operator==(const UnfinishedNote&) const = default;
};

QByteArray bytesOf(const UnfinishedNote& note);
// Returns nothing if the bytes are not a valid note, or if the note names paths that no Dipwright
// program would clean up.
std::optional<UnfinishedNote> noteOf(const QByteArray& bytes);

} // namespace dipwright
