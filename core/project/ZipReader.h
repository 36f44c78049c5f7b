// Reads zips from untrusted sources. disk/ZipWriter.h writes them.
#pragma once

#include <QByteArray>
#include <QFile>
#include <QSet>
#include <QString>
#include <memory>

class QuaZip;

namespace dipwright {

// An open zip. The constructor checks the whole directory before anything is unpacked. It throws
// Error if the file is missing, empty, truncated, not a zip or encrypted. It also throws Error for
// unsafe or repeated names, and if the packed or unpacked size exceeds the limits of Budgets.h.
class ZipReader {
public:
    explicit ZipReader(const QString& path);
    ~ZipReader();

    const QSet<QString>& names() const { return names_; }
    bool contains(const QString& name) const { return names_.contains(name); }
    // Returns the whole entry after verifying its checksum. Throws Error.
    QByteArray read(const QString& name);

private:
    void checkDirectory();

    QString path_;
    QFile file_;
    std::unique_ptr<QuaZip> zip_;
    QSet<QString> names_;
};

} // namespace dipwright
