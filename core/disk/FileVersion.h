// Which contents a file has, to tell later whether somebody else has written it since.
#pragma once

#include <QByteArray>
#include <QString>

namespace dipwright {

// By content alone: no clock and no date has a say. A file that is missing, or cannot be read, has
// a version of its own. Take it before the file is read: what comes in between is then noticed.
class FileVersion {
public:
    FileVersion() = default; // of a missing file
    static FileVersion of(const QString& path);
    // As the file would be with these bytes.
    static FileVersion ofBytes(const QByteArray& bytes);
    bool operator==(const FileVersion&) const = default;

    // To be kept in a file, and from it.
    QString text() const { return QString::fromLatin1(hash_.toHex()); }
    static FileVersion fromText(const QString& text);

private:
    QByteArray hash_;
};

} // namespace dipwright
