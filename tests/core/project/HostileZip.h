// Writes zips that no ordinary program would write.
#pragma once

#include <QByteArray>
#include <QList>
#include <QString>

namespace dipwright::test {

struct ZipEntry {
    QString name;
    QByteArray contents;
    const char* password = nullptr; // encrypts the entry; null: not encrypted
};

QByteArray zip(const QList<ZipEntry>& entries);
// Returns the unpacked entries of an ordinary zip.
QList<ZipEntry> entriesOf(const QString& path);

} // namespace dipwright::test
