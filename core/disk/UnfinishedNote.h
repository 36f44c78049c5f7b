// What a note of unfinished work says, and its bytes.
#pragma once

#include <QByteArray>
#include <QStringList>
#include <optional>

namespace dipwright {

struct UnfinishedNote {
    QString work;     // the temporary file, or the hidden folder of results; absolute
    QStringList made; // folders that were made for it and that it lies in, the innermost last
    bool operator==(const UnfinishedNote&) const = default;
};

QByteArray bytesOf(const UnfinishedNote& note);
// Nothing where the bytes are no note, or name what no program of ours would put right.
std::optional<UnfinishedNote> noteOf(const QByteArray& bytes);

} // namespace dipwright
