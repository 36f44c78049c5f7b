#include "HostileZip.h"

#include <QBuffer>
#include <quazip.h>
#include <quazipfile.h>

namespace dipwright::test {

QByteArray zip(const QList<ZipEntry>& entries) {
    QBuffer buffer;
    buffer.open(QIODevice::ReadWrite);
    QuaZip archive(&buffer);
    archive.setAutoClose(false);
    archive.open(QuaZip::mdCreate);
    for (const ZipEntry& entry : entries) {
        QuaZipFile file(&archive);
        const auto crc = entry.password
                             ? crc32(0, reinterpret_cast<const Bytef*>(entry.contents.constData()),
                                     uInt(entry.contents.size()))
                             : 0;
        file.open(QIODevice::WriteOnly, QuaZipNewInfo(entry.name), entry.password, quint32(crc));
        file.write(entry.contents);
        file.close();
    }
    archive.close();
    return buffer.data();
}

QList<ZipEntry> entriesOf(const QString& path) {
    QList<ZipEntry> entries;
    QuaZip archive(path);
    archive.open(QuaZip::mdUnzip);
    for (bool more = archive.goToFirstFile(); more; more = archive.goToNextFile()) {
        QuaZipFile file(&archive);
        file.open(QIODevice::ReadOnly);
        entries.append({archive.getCurrentFileName(), file.readAll()});
    }
    return entries;
}

} // namespace dipwright::test
