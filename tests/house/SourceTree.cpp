#include "SourceTree.h"
#include "TestFolders.h"

#include <QDirIterator>
#include <QFile>
#include <QTest>

QDir sourceTree() {
    return {sourceFolder()};
}

QString textOf(const QString& file) {
    QFile input(sourceTree().filePath(file));
    return input.open(QIODevice::ReadOnly) ? QString::fromUtf8(input.readAll()) : QString();
}

QStringList filesIn(const QString& folder, const QStringList& patterns) {
    const QDir source = sourceTree();
    QStringList files;
    QDirIterator walk(source.filePath(folder), patterns, QDir::Files, QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        files << source.relativeFilePath(walk.next());
    }
    files.sort();
    return files;
}

void expectNone(const QStringList& offences) {
    QVERIFY2(offences.isEmpty(), qPrintable(offences.join(QLatin1Char('\n'))));
}
