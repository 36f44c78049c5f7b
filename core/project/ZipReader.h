// A zip as the store needs it: read with distrust. disk/ZipWriter.h writes one.
#pragma once

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
class ZipReader {
public:
    explicit ZipReader(const QString& path);
    ~ZipReader();

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

} // namespace dipwright
