// Identifies the contents of a file, so that later changes by other programs are detected.
#pragma once

#include <QByteArray>
#include <QString>

namespace dipwright {

// Compares contents only, not dates. All missing or unreadable files have one common version. Take
// the version before you read the file, so that later changes are noticed.
class FileVersion {
public:
    FileVersion() = default; // the version of a missing file
    static FileVersion of(const QString& path);
    // The version that the file would have with these bytes.
    static FileVersion ofBytes(const QByteArray& bytes);
    bool operator==(const FileVersion&) const = default;

    // Text form, for storing in a file.
    QString text() const { return QString::fromLatin1(hash_.toHex()); }
    static FileVersion fromText(const QString& text);

private:
    QByteArray hash_;
};

} // namespace dipwright
