// Zips as no honest program writes them.
#pragma once

#include <QByteArray>
#include <QList>
#include <QString>

namespace dipwright::test {

struct ZipEntry {
    QString name;
    QByteArray contents;
    const char* password = nullptr; // encrypted with it
};

QByteArray zip(const QList<ZipEntry>& entries);
// The entries of an honest zip, unpacked.
QList<ZipEntry> entriesOf(const QString& path);

} // namespace dipwright::test
