// A zip as the store needs it: read with distrust, written the same way every time.
#pragma once

#include <QBuffer>
#include <QByteArray>
#include <QFile>
#include <QSet>
#include <QString>
#include <memory>

class QuaZip;

namespace dipwright {

// A zip to read from. All of the directory is judged before anything is unpacked: the constructor
// throws Error for a file that is missing, empty, truncated, not a zip, encrypted, has unsafe or
// repeated names, or is or would be larger than Budgets.h allows.
class ArchiveReader {
public:
    explicit ArchiveReader(const QString& path);
    ~ArchiveReader();

    const QSet<QString>& names() const { return names_; }
    bool contains(const QString& name) const { return names_.contains(name); }
    // The whole entry, its checksum verified. Throws Error.
    QByteArray read(const QString& name);

private:
    void judgeDirectory();

    QString path_;
    QFile file_;
    std::unique_ptr<QuaZip> zip_;
    QSet<QString> names_;
};

// A zip written into memory: no time stamps, so that equal contents give equal bytes.
class ArchiveWriter {
public:
    enum class Packing { Stored, Deflated };

    ArchiveWriter();
    ~ArchiveWriter();
    void add(const QString& name, const QByteArray& contents, Packing packing);
    // Throws Error unless all of it is in the bytes.
    QByteArray finish();

private:
    QBuffer buffer_;
    std::unique_ptr<QuaZip> zip_;
    int entries_ = 0;
};

} // namespace dipwright
